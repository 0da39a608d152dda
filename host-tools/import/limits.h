/* SPDX-License-Identifier: MIT */
/* What the importing process may use. A file that needs more is malformed, as far as anyone can tell. */
#ifndef LIMITS_H
#define LIMITS_H

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define LIMITS_SANITIZED 1
#endif
#endif
#if !defined(LIMITS_SANITIZED) && defined(__SANITIZE_ADDRESS__)
#define LIMITS_SANITIZED 1
#elif !defined(LIMITS_SANITIZED)
#define LIMITS_SANITIZED 0
#endif

/* Seconds of processor time: they grow with the file and, of a .gltf, with the files that hold its buffers. */
unsigned long limits_seconds(const char *path);

/* Limits this process to them, and to 4 GiB but under sanitizers, which map far more memory than they use. */
void limits_set(const char *path);

#endif

/* SPDX-License-Identifier: MIT */
/* The system calls that USB takes, apart so that a test can be the kernel. Each returns a negative errno. */
#ifndef HAL_LINUX_FILES_H
#define HAL_LINUX_FILES_H

#include <stddef.h>

/* For reading and writing; `waits` 0: what cannot be done yet is refused (EAGAIN). A descriptor. */
int files_open(const char *path, int waits);
void files_close(int descriptor);
long files_read(int descriptor, void *bytes, size_t size);
long files_write(int descriptor, const void *bytes, size_t size);

/* A whole file of an attribute, without the line's end. */
int files_put(const char *path, const char *text);
int files_get(const char *path, char *text, size_t size);

int files_make_folder(const char *path);
int files_remove_folder(const char *path);
int files_link(const char *target, const char *path);
int files_unlink(const char *path);
int files_mount(const char *source, const char *path, const char *type);
int files_unmount(const char *path);

/* The first name in a folder, by the alphabet; ENOENT if it has none. */
int files_first(const char *folder, char *name, size_t size);

/* An event that is awaited beside a descriptor: files_wait() returns 1 when that can be read, 0 when the event was
 * raised. */
int files_event(void);
int files_raise(int event);
int files_wait(int descriptor, int event);

#endif

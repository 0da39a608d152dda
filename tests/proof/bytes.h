/* SPDX-License-Identifier: MIT */
/* Contracts that proofs of outside bytes assume of each other's functions. */
#ifndef PROOF_BYTES_H
#define PROOF_BYTES_H

#include "scene/scene.h"

/*@ requires \valid_read((const uint8_t *)bytes + (0 .. size - 1));
    assigns \result \from crc, size, ((const uint8_t *)bytes)[0 .. size - 1]; */
uint32_t scene_crc32(uint32_t crc, const void *bytes, size_t size);

/* Named by a header, called by nothing here. */
/*@ assigns \result \from turn; */
q30_t fx_sin(uint32_t turn);

#endif

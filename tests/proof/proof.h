/* SPDX-License-Identifier: MIT */
/*
 * What the proofs are written with. Each tests/proof/<thing>.c is one: prove() calls production functions, which it
 * includes unchanged, with every value of their documented ranges, and Frama-C shows that nothing overflows, leaves its
 * array or is undefined. The comment at its head says what is proven (tests/tools/prove.py reads it):
 *
 *   proves:   functions of which every statement must be reached
 *   assumes:  functions whose contract (contracts.h) stands for them here; another proof must prove each
 *   options:  of Frama-C besides the common ones
 *   then:     what runs after Eva in the same session, as -wp ..., on what Eva could not decide
 */
#ifndef PROOF_H
#define PROOF_H

#include <stdint.h>

#include "__fc_builtin.h"

/* Any value of [least, most]. */
static inline int32_t any_s32(int32_t least, int32_t most)
{
    return Frama_C_int_interval(least, most);
}
static inline uint32_t any_u32(uint32_t least, uint32_t most)
{
    return Frama_C_unsigned_int_interval(least, most);
}
static inline int64_t any_s64(int64_t least, int64_t most)
{
    return Frama_C_long_long_interval(least, most);
}
static inline uint64_t any_u64(uint64_t least, uint64_t most)
{
    return Frama_C_unsigned_long_long_interval(least, most);
}
static inline int any_flag(void)
{
    return Frama_C_int_interval(0, 1);
}

/* Any bytes, in place of what is in [p, p + size). */
static inline void any_bytes(void *p, unsigned size)
{
    Frama_C_make_unknown(p, size);
}

#define ANY_S32 any_s32(INT32_MIN, INT32_MAX)
#define ANY_U32 any_u32(0, UINT32_MAX)

#endif

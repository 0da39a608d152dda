/* SPDX-License-Identifier: MIT */
/*
 * What the proofs are written with. Each tests/proof/<thing>.c is one: prove() calls production functions, which it
 * includes unchanged, with every value of their documented ranges, and Frama-C shows that nothing overflows, leaves its
 * array or is undefined. The comment at its head says what is proven (tests/tools/prove.py reads it):
 *
 *   proves:   functions of which every statement must be reached
 *   assumes:  functions whose contract (contracts.h) stands for them here; another proof must prove each
 *   lemmas:   files .smt2: z3 shows there what Eva could not. Each names the code that it rests upon, and what it shows
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

/* Leading zero bits, for Eva: each count is a case of its own from where it is known (-eva-split-return full), so that
 * what is shifted by it has its bounds. */
static inline int proof_clz(uint32_t x)
{
    //@ assert x != 0;
    //@ loop unroll 32;
    for (int n = 0; n < 31; n++)
        if (x >= 1u << (31 - n))
            return n;
    return 31;
}
#ifdef PROOF_CLZ_BY_CASES
#define __builtin_clz proof_clz
#endif

/* Whatever the program is made for. */
#ifdef PROOF_ANY_USES
#include "uses.h"
#undef USES
#define USES(effects) any_flag()
#endif

#define ANY_S32 any_s32(INT32_MIN, INT32_MAX)
#define ANY_U32 any_u32(0, UINT32_MAX)

#endif

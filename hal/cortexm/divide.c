/* SPDX-License-Identifier: MIT */
/*
 * Signed division for CPUs without one (ARMv6-M), under the names that a compiler calls (Run-time ABI for the Arm
 * Architecture, 4.3.1): by libgcc's unsigned one, which is linked anyway, in 60 bytes; libgcc's signed one takes 460.
 */
#include <stdint.h>

/* The quotient in r0, the remainder in r1: who calls the plain division looks at the first alone. */
uint64_t __aeabi_uidivmod(uint32_t n, uint32_t d);
uint64_t __aeabi_idivmod(int32_t n, int32_t d);
uint64_t __aeabi_idiv(int32_t n, int32_t d) __attribute__((alias("__aeabi_idivmod")));

/* -n, modulo 2^32. */
static uint32_t negative(uint32_t n)
{
    return n ? ~n + 1u : 0;
}

/* Rounded to 0; the remainder has the dividend's sign. */
uint64_t __aeabi_idivmod(int32_t n, int32_t d)
{
    const uint64_t both =
        __aeabi_uidivmod(n < 0 ? negative((uint32_t)n) : (uint32_t)n, d < 0 ? negative((uint32_t)d) : (uint32_t)d);
    const uint32_t quotient = (uint32_t)both, rest = (uint32_t)(both >> 32);
    return (uint64_t)(n < 0 ? negative(rest) : rest) << 32 | ((n < 0) != (d < 0) ? negative(quotient) : quotient);
}

/* SPDX-License-Identifier: MIT */
/*
 * The C library's own start, as ARMv6 can run it: Debian's cross compiler brings one for ARMv7 only, on which a first
 * Raspberry Pi Zero stops. The library itself is the Pi's.
 */
        .arm
        .globl _start
_start:
        mov     fp, #0
        mov     lr, #0
        pop     {r1}            /* argc; argv is above it */
        mov     r2, sp
        push    {r2}            /* stack_end */
        push    {r0}            /* rtld_fini */
        mov     ip, #0
        push    {ip}            /* fini */
        ldr     r0, =main
        mov     r3, #0          /* init */
        bl      __libc_start_main
        udf     #0
        .section .note.GNU-stack, "", %progbits

/* SPDX-License-Identifier: MIT */
/* A machine for the handheld's program, whose main.c is included, of which nothing fails and nobody presses a button:
 * its clock goes on by itself. The includer has machine_write() and the serial line. After cmocka.h. */
#ifndef APP_MACHINE_H
#define APP_MACHINE_H

#include "app/app.h"
#include "clock.h"
#include "cortexm/fault.h"
#include "cortexm/machine.h"
#include "cortexm/stack.h"
#include "firmware/app/main.c"
#include "input.h"
#include "pack/pack.h"
#include "serial.h"

#include <string.h>

static uint32_t now_us, blob[24 * 1024 / 4], blob_length;

uint32_t input_buttons(void)
{
    return 0;
}
uint32_t clock_us(void)
{
    return now_us += 100;
}
void clock_wait_us(uint32_t us)
{
    now_us += us;
}
void clock_idle(void)
{
    now_us += 1000;
}
int fault_last(struct fault *fault)
{
    (void)fault;
    return 0;
}
void fault_text(const struct fault *fault, char text[FAULT_TEXT])
{
    (void)fault;
    text[0] = 0;
}
uint32_t stack_used(void)
{
    return 0;
}
void stack_check(void) {}

/* The scene becomes the blob: 0, or the group of tests cannot begin. */
static int app_machine_load(const char *path)
{
    struct pack_result packed;
    if (pack_load(path, NULL, &packed) != 0 || packed.size > sizeof blob)
        return 1;
    memcpy(blob, packed.scene, packed.size);
    blob_length = (uint32_t)packed.size;
    pack_free(&packed);
    return 0;
}

#endif

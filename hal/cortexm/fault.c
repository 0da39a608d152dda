/* SPDX-License-Identifier: MIT */
#include "cortexm/fault.h"
#include "cortexm/machine.h"
#include "cortexm/stack.h"

#define FAULT_MAGIC 0xFA017000u

/* Where no section lies (boards/cortexm.ld): neither start-up nor a loader writes there. What power-up leaves there is
 * anything. */
struct fault_kept {
    uint32_t magic;
    struct fault fault;
    uint32_t sum;
};
extern struct fault_kept link_kept;

_Noreturn void fault_exception(uint32_t at, uint32_t from);

static uint32_t fault_sum(const struct fault *fault)
{
    return ~(FAULT_MAGIC ^ fault->number ^ fault->at ^ fault->from ^ fault->overflow << 31);
}

int fault_last(struct fault *fault)
{
    *fault = link_kept.fault;
    int kept = link_kept.magic == FAULT_MAGIC && link_kept.sum == fault_sum(fault);
    link_kept.magic = 0;
    return kept;
}

static char *fault_add(char *at, const char *text)
{
    while (*text)
        *at++ = *text++;
    *at = 0;
    return at;
}

static char *fault_hex(char *at, uint32_t value)
{
    for (int shift = 28; shift >= 0; shift -= 4)
        *at++ = "0123456789abcdef"[value >> shift & 15];
    *at = 0;
    return at;
}

void fault_text(const struct fault *fault, char text[FAULT_TEXT])
{
    char *at = fault_add(text, fault->number ? "fault " : "fault");
    for (uint32_t number = fault->number & 0x1ff, unit = 100; unit; unit /= 10)
        if (number >= unit)
            *at++ = (char)('0' + number / unit % 10);
    if (fault->overflow)
        at = fault_add(at, ", stack overflow");
    at = fault_hex(fault_add(at, ", at "), fault->at);
    if (fault->from)
        fault_hex(fault_add(at, ", from "), fault->from);
}

_Noreturn void fault_end(const struct fault *fault)
{
    char text[FAULT_TEXT];
    struct fault before;
    int again = fault_last(&before);
    __asm volatile("cpsid i" ::: "memory");
    link_kept = (struct fault_kept){FAULT_MAGIC, *fault, fault_sum(fault)};
    fault_text(fault, text);
    machine_write(text);
    machine_write("\n");
    if (again)
        machine_exit(3);
    machine_reset();
}

/* Of start_fault(). */
_Noreturn void fault_exception(uint32_t at, uint32_t from)
{
    struct fault fault = {.at = at, .from = from, .overflow = (uint32_t)stack_broken()};
    __asm volatile("mrs %0, ipsr" : "=r"(fault.number));
    fault_end(&fault);
}

/* SPDX-License-Identifier: MIT */
/*
 * Fails on demand: the board's fault handling, stack, serial line and clock, told what to do by lines on the serial
 * line. Says "ready" first, on the display too where the last start ended in a fault.
 *
 *   undefined   an undefined instruction
 *   unaligned   two words read at an odd address
 *   unserved    an exception that nobody serves
 *   deep N      writes N bytes of stack; then "used M of S", or stack_check()'s fault
 *   second N    on the second CPU: an undefined instruction if N is 0, or it writes N bytes of stack; then as deep
 *   busy        says "busy", looks at the serial line after a button only, and says what has come: "got TEXT, lost N"
 *   clock N     reads the time N times, every other with interrupts masked: "N steps back"
 */
#include "app/crash.h"
#include "clock.h"
#include "cortexm/machine.h"
#include "cortexm/stack.h"
#include "input.h"
#include "serial.h"
#include "tests/device/program.h"

int main(void);

void program_write(const char *text)
{
    machine_write(text);
}

/* As a deep call would, but that it returns. */
static void faults_deep(uint32_t bytes)
{
    uintptr_t here = (uintptr_t)__builtin_frame_address(0) & ~(uintptr_t)3;
    for (uint32_t i = 4; i <= bytes; i += 4)
        *(volatile uint32_t *)(here - i) = 0;
}

static void faults_job(void *argument)
{
    uint32_t depth = *(const uint32_t *)argument;
    if (depth == 0)
        __asm volatile("udf #0");
    faults_deep(depth);
    for (;;)
        ;
}

/* The first CPU goes on, and uses what its stack begins with. */
static void faults_second(const struct hal_core *core, uint32_t depth)
{
    enum { WORDS = 40 };
    extern volatile uint32_t link_stack[];
    volatile uint32_t *first = link_stack + stack_size() / 4 - WORDS;
    uint32_t begin = clock_us(), kept[WORDS];
    core->start(faults_job, &depth);
    for (int i = 0; i < WORDS; i++)
        kept[i] = first[i];
    while (clock_us() - begin < 20000)
        for (int i = 0; i < WORDS; i++)
            first[i] = 0;
    for (int i = 0; i < WORDS; i++)
        first[i] = kept[i];
}

static void faults_unaligned(void)
{
    /* two words at once: the Cortex-M3 allows one word anywhere */
    __asm volatile("ldr r0, =link_stack + 1\n ldmia r0!, {r1, r2}" ::: "r0", "r1", "r2", "memory");
}

static void faults_clock(uint32_t count)
{
    struct line line = {.length = 0};
    uint32_t last = clock_us(), back = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (i & 1)
            __asm volatile("cpsid i" ::: "memory");
        uint32_t now = clock_us();
        if (i & 1)
            __asm volatile("cpsie i" ::: "memory");
        if ((now - last) >> 31)
            back++;
        last = now;
    }
    line_decimal(&line, back);
    line_text(&line, " steps back");
    line_end(&line);
}

static void faults_busy(void)
{
    struct line line = {.length = 0};
    char text[32];
    machine_write("busy\n");
    while (input_buttons() == 0)
        ;
    machine_write("got ");
    for (uint32_t count; (count = serial_read(text, sizeof text - 1)) != 0;) {
        text[count] = 0;
        machine_write(text);
    }
    line_text(&line, ", lost ");
    line_decimal(&line, serial_lost());
    line_end(&line);
}

static void faults_used(void)
{
    struct line line = {.length = 0};
    stack_check();
    line_text(&line, "used ");
    line_decimal(&line, stack_used());
    line_text(&line, " of ");
    line_decimal(&line, stack_size());
    line_end(&line);
}

static void faults_obey(char *line, const struct board *board)
{
    char *number = line;
    while (*number && *number != ' ')
        number++;
    if (*number)
        *number++ = 0;
    uint32_t value = text_number(number);
    if (text_equal(line, "undefined"))
        __asm volatile("udf #0");
    else if (text_equal(line, "unaligned"))
        faults_unaligned();
    else if (text_equal(line, "unserved"))
        __asm volatile("svc #0");
    else if (text_equal(line, "busy"))
        faults_busy();
    else if (text_equal(line, "clock"))
        faults_clock(value);
    else {
        if (text_equal(line, "deep"))
            faults_deep(value);
        if (text_equal(line, "second"))
            faults_second(board->core, value);
        faults_used();
    }
}

int main(void)
{
    char line[80];
    uint32_t length = 0;
    const struct board *board = board_start();
    struct hal_display *display = board->display;
    if (display->ops->open(display, board->width, board->height, (enum hal_pixel_format)board->format) != 0)
        return 3;
    crash_show(board);
    machine_write("ready\n");
    for (;;) {
        if (!serial_read(line + length, 1))
            clock_idle();
        else if (line[length] != '\n')
            length += length + 1 < sizeof line;
        else {
            line[length] = 0;
            length = 0;
            faults_obey(line, board);
        }
    }
}

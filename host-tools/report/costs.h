/* SPDX-License-Identifier: MIT */
/*
 * What methods cost on a device, counted elsewhere (`make report`) and read from CSV files:
 *
 *     cpu,scene,method,width,height,format,instructions,picture
 *                                                          one frame, clear included; its picture's hash, of each cpu
 *     cpu,method,bytes                                     flash of a program that draws by that method alone
 *     cpu,scene,budget_q8,instructions                     one frame by auto within that budget, Q8 of 1/255
 *     cpu,scene,power,exponent,instructions                one frame by x with that form of the highlight's power
 *     cpu,scene,format,codec,pixels,bytes,instructions     to pack and check one frame for a stream (`make
 * bench-stream`)
 */
#ifndef COSTS_H
#define COSTS_H

#include <stddef.h>
#include <stdint.h>

enum costs_cpu { COSTS_M3, COSTS_M0PLUS, COSTS_CPUS };
extern const char *const costs_cpu_names[COSTS_CPUS];  /* in the files */
extern const char *const costs_cpu_titles[COSTS_CPUS]; /* to be read */

struct costs_frame {
    char scene[64], method[64];
    enum costs_cpu cpu;
    unsigned width, height;
    uint32_t instructions;
    char picture[16]; /* a hash, the same on every cpu */
    unsigned line;
};

struct costs_flash {
    char method[64];
    enum costs_cpu cpu;
    uint32_t bytes;
};

struct costs_budget {
    char scene[64];
    unsigned budget_q8;
    enum costs_cpu cpu;
    uint32_t instructions;
};

struct costs_power {
    char scene[64];
    unsigned form, exponent; /* in renderer_powers[] */
    enum costs_cpu cpu;
    uint32_t instructions;
};

enum { COSTS_STREAM_CPUS = 3 };
extern const char *const costs_stream_cpus[COSTS_STREAM_CPUS];       /* in the file */
extern const char *const costs_stream_cpu_titles[COSTS_STREAM_CPUS]; /* to be read */

struct costs_stream {
    char scene[64], format[64]; /* a format's name, ` dithered` after it if it is */
    unsigned cpu;               /* in costs_stream_cpus[] */
    unsigned codec;             /* 1 or 2 */
    uint32_t pixels, bytes, instructions;
};

struct costs {
    const char *frames_path, *flash_path, *powers_path, *streams_path, *budgets_path; /* the caller's */
    struct costs_frame *frames;
    struct costs_flash *flash;
    struct costs_power *powers;
    struct costs_stream *streams;
    struct costs_budget *budgets;
    size_t frame_count, flash_count, power_count, stream_count, frame_room, flash_room, power_room, stream_room,
        budget_count, budget_room;
};

/* Reads the files whose paths are set, the rest of `costs` being 0; of frames the format must be grey8, every number is
 * above 0 and no line there twice. Returns the exit code of the command line, 0, 1 or 3; after a failure, one line has
 * been printed on stderr. To be given to costs_free() in any case. */
int costs_read(struct costs *costs);
void costs_free(struct costs *costs);

/* Null: not in the file. */
const struct costs_frame *costs_find_frame(const struct costs *costs, enum costs_cpu cpu, const char *scene,
                                           const char *method);
const struct costs_flash *costs_find_flash(const struct costs *costs, enum costs_cpu cpu, const char *method);
const struct costs_budget *costs_find_budget(const struct costs *costs, enum costs_cpu cpu, const char *scene,
                                             unsigned budget_q8);
const struct costs_power *costs_find_power(const struct costs *costs, enum costs_cpu cpu, const char *scene,
                                           unsigned form, unsigned exponent);
const struct costs_stream *costs_find_stream(const struct costs *costs, unsigned cpu, const char *scene,
                                             const char *format, unsigned codec);

#endif

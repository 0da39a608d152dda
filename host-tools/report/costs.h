/* SPDX-License-Identifier: MIT */
/*
 * What methods cost on a device, counted elsewhere (`make report`) and read from CSV files:
 *
 *     cpu,scene,method,width,height,format,instructions    one frame, clear included
 *     cpu,method,bytes                                     flash of a program that draws by that method alone
 *     cpu,scene,power,exponent,instructions                one frame by x with that form of the highlight's power
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
    unsigned line;
};

struct costs_flash {
    char method[64];
    enum costs_cpu cpu;
    uint32_t bytes;
};

struct costs_power {
    char scene[64];
    unsigned form, exponent; /* in renderer_powers[] */
    enum costs_cpu cpu;
    uint32_t instructions;
};

struct costs {
    const char *frames_path, *flash_path, *powers_path; /* the caller's */
    struct costs_frame *frames;
    struct costs_flash *flash;
    struct costs_power *powers;
    size_t frame_count, flash_count, power_count, frame_room, flash_room, power_room;
};

/* Reads the files, powers_path unless it is null; the format must be grey8, every number above 0 and no line there
 * twice. Returns the exit code of the command line, 0, 1 or 3; after a failure, one line has been printed on stderr. To
 * be given to costs_free() in any case. */
int costs_read(struct costs *costs, const char *frames_path, const char *flash_path, const char *powers_path);
void costs_free(struct costs *costs);

/* Null: not in the file. */
const struct costs_frame *costs_find_frame(const struct costs *costs, enum costs_cpu cpu, const char *scene,
                                           const char *method);
const struct costs_flash *costs_find_flash(const struct costs *costs, enum costs_cpu cpu, const char *method);
const struct costs_power *costs_find_power(const struct costs *costs, enum costs_cpu cpu, const char *scene,
                                           unsigned form, unsigned exponent);

#endif

/* SPDX-License-Identifier: MIT */
/* Films of pictures in a folder of their own. Include after cmocka.h. */
#ifndef RECORD_CASE_H
#define RECORD_CASE_H

#include "glint/cli.h"
#include "view/record.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static inline int record_case_enter(void **state)
{
    char *name = strdup("/tmp/glint-record-XXXXXX");
    *state = name;
    return mkdtemp(name) && chdir(name) == 0 ? 0 : -1;
}

static inline int record_case_leave(void **state)
{
    char command[128];
    snprintf(command, sizeof command, "rm -rf '%s'", (const char *)*state);
    free(*state);
    return chdir("/") || system(command);
}

/* The number of files here, hidden ones too. */
static inline int record_case_files(void)
{
    DIR *folder = opendir(".");
    int count = -2; /* . and .. */
    while (readdir(folder))
        count++;
    closedir(folder);
    return count;
}

static inline struct frames_picture record_case_picture(const uint8_t *pixels, unsigned width, unsigned height,
                                                        enum stream_format format, uint32_t time_us)
{
    return (struct frames_picture){
        .pixels = pixels, .width = (uint16_t)width, .height = (uint16_t)height, .format = format, .time_us = time_us};
}

#define RECORD_CASE(name) cmocka_unit_test_setup_teardown(name, record_case_enter, record_case_leave)

#endif

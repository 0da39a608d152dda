/* SPDX-License-Identifier: MIT */
/* What the checked build's operations call when a value leaves their range (firmware/fixed/checked.h). */
#include "fixed/checked.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#include <sanitizer/common_interface_defs.h>
#define TRACE() __sanitizer_print_stack_trace()
#endif
#endif
#ifndef TRACE
#define TRACE() ((void)0)
#endif

void fx_trap(const char *file, int line, const char *broken, int64_t a, int64_t b)
{
    fprintf(stderr, "%s:%d: broken: %s (%" PRId64 ", %" PRId64 ")\n", file, line, broken, a, b);
    TRACE();
    exit(126);
}

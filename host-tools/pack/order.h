/* SPDX-License-Identifier: MIT */
/* Scenes in the other byte order, for machines that are not little-endian. */
#ifndef ORDER_H
#define ORDER_H

#include "pack/pack.h"

/* Copies the checked blob with every integer turned round and sealed anew: scene_check() on a machine of the other
 * byte order says of it what it says of the blob here. This machine can only write it to a file. The copy is the
 * caller's, to be given to pack_free(); it has no report. */
void order_swap(const struct pack_result *result, struct pack_result *swapped);

/* Whether that has been done to it. */
bool order_is_swapped(const struct scene_header *scene);

#endif

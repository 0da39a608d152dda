/* SPDX-License-Identifier: MIT */
#include "boards/linux/name.h"
#include "linux/files.h"
#include "scene/scene.h"

#include <stdio.h>
#include <string.h>

#define NAME_TREE    "/sys/firmware/devicetree/base/serial-number"
#define NAME_MACHINE "/etc/machine-id"

void name_serial(char *serial, size_t size)
{
    char id[64];
    if (files_get(NAME_TREE, serial, size) == 0 && serial[0])
        return;
    if (files_get(NAME_MACHINE, id, sizeof id) == 0 && id[0])
        snprintf(serial, size, "%08lx", (unsigned long)scene_crc32(scene_crc32(0, "glint", 5), id, strlen(id)));
    else
        snprintf(serial, size, "0");
}

/* SPDX-License-Identifier: MIT */
#include "boards/linux/device.h"

int main(int argc, char **argv)
{
    return device_run(argc, argv);
}

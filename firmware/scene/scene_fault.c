/* SPDX-License-Identifier: MIT */
#include "scene/scene.h"

const char *scene_fault_text(enum scene_fault fault)
{
    switch (fault) {
    case SCENE_OK:
        return "the scene is good";
    case SCENE_E_ALIGN:
        return "the scene does not start at a multiple of 4";
    case SCENE_E_SHORT:
        return "the scene is cut short";
    case SCENE_E_MAGIC:
        return "not a scene, or one of the other byte order";
    case SCENE_E_VERSION:
        return "a scene of another version";
    case SCENE_E_CRC:
        return "the scene is damaged: its CRC does not match";
    case SCENE_E_STRUCTURE:
        return "an array lies outside the scene";
    case SCENE_E_INDEX:
        return "a reference to something that is not in the scene";
    case SCENE_E_RANGE:
        return "a value is outside its range";
    case SCENE_E_USES:
        return "the scene needs an effect that this program was compiled without";
    }
    return "unknown fault";
}

# SPDX-License-Identifier: MIT
$(eval $(call rp2040_board,pico-st7789))
SCENES_pico-st7789 := demo torus288 torus800 sphere690 bulb pawn zigzag teapot896 bench-torus4000

# SPDX-License-Identifier: MIT
$(eval $(call rp2040_board,pico-display2))
SCENES_pico-display2 := demo torus288 torus800 sphere690 bulb pawn zigzag teapot896 bench-torus4000

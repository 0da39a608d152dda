# SPDX-License-Identifier: MIT
$(eval $(call rp2040_board,picosystem))
SCENES_picosystem := demo torus288 torus800 sphere690 bulb pawn zigzag teapot896 bench-torus4000

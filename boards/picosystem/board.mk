# SPDX-License-Identifier: MIT
$(eval $(call rp2040_board,picosystem))

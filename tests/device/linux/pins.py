# SPDX-License-Identifier: MIT
"""A logic analyser's listing of a GPIO chip's pins, read as the wires to a panel.

QEMU's trace event pl061_set_output is a line a change of a pin's level, with the time in front. Bits count at the
clock's rising edge while the panel is selected: SPI modes 0 and 3. What a panel would not forgive is in `faults`. Where
the stamps mean nothing (not `timed`), everything comes a second after what was before.
"""
import re

SCK, MOSI, CS, KEY_A, DC, RESET, BACKLIGHT, KEY_B = range(8)
NAMES = {RESET: "reset", BACKLIGHT: "backlight"}
# All but the clock's falling edges, which say nothing.
CHANGE = re.compile(rb"@(\d+)\.(\d{6}):pl061_set_output \S+ setting output (0 to 1|[1-7] to \d)")
MS = 1000  # times are in microseconds


class Wires:
    def __init__(self, timed=True):
        self.timed = timed
        self.untimed = 0
        self.level = [0] * 8  # the chip pulls down what nothing drives
        self.rest = b""
        self.attach(None)

    def attach(self, panel):
        """Another panel takes the place of the one before; what was found so far is forgotten."""
        self.panel = panel
        self.faults = []
        self.edges = []  # of reset and backlight: (time, name, level)
        self.bits = self.value = self.data = 0
        self.bytes = 0
        self.first = self.last = None  # when bytes came
        if panel:
            panel.power(self.level[RESET])

    def fault(self, text):
        if len(self.faults) < 10:
            self.faults.append(text)

    def feed(self, listing):
        """More of the listing; the last line may be cut."""
        listing = self.rest + listing
        end = listing.rfind(b"\n") + 1
        self.rest = listing[end:]
        for seconds, fraction, change in CHANGE.findall(listing[:end]):
            if change == b"0 to 1":
                if not self.level[CS]:
                    self.value = self.value << 1 | self.level[MOSI]
                    self.bits += 1
                    if self.bits == 1:
                        self.data = self.level[DC]
                    elif self.bits == 8:
                        self.byte(self.time(seconds + fraction))
                continue
            line, level = change[0] - 48, change[-1] - 48
            self.level[line] = level
            if line != MOSI:
                self.other(line, level, self.time(seconds + fraction))

    def time(self, stamp):
        if self.timed:
            return int(stamp)
        self.untimed += 1000 * MS
        return self.untimed

    def byte(self, now):
        if self.data != self.level[DC]:
            self.fault("D/C changes in a byte")
        value, self.bits, self.value = self.value, 0, 0
        self.bytes += 1
        self.first = self.first or now
        self.last = now
        if self.panel:
            self.panel.byte(value, self.data, now)

    def other(self, line, level, now):
        if line == CS:
            if self.bits:
                self.fault(f"selection changes after {self.bits} bits of a byte")
            self.bits = self.value = 0
        elif line in NAMES:
            self.edges.append((now, NAMES[line], level))
            if line == RESET:
                if self.bits:
                    self.bits = self.value = 0
                if self.panel:
                    self.panel.reset(level, now)
            elif self.panel:
                self.panel.backlight(level)

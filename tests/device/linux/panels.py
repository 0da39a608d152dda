# SPDX-License-Identifier: MIT
"""ST7789, ILI9341 and SSD0323 at the end of the wires, by their data sheets' command sets.

Bytes come in with the level of D/C and the time in microseconds; what the glass shows comes out. What a data sheet
forbids (a command too early, a parameter too few, a window outside) is in `faults`. `log` has each command with its
parameters, or for pixels their bytes' number, and the longest pause in and behind it, in microseconds.
"""
MS = 1000


def turned_upright(pixels, width, height, turn):
    """The picture that somebody sees who looks at a glass turned clockwise by that many degrees."""
    rows = [pixels[y * width:][:width] for y in range(height)]
    for _ in range(turn // 90):
        rows = [list(column) for column in zip(*rows[::-1])]
    return [pixel for row in rows for pixel in row]


class Panel:
    """What the controllers have in common. `glass`: width, height and offset of the glass in the memory."""

    def __init__(self, width, height, x=0, y=0):
        self.glass = (width, height, x, y)
        self.faults, self.log = [], []
        self.held, self.ready, self.reset_at, self.last = True, 0, None, None
        self.shown = None  # the glass before it went dark
        self.lit = []  # changes of the backlight: level, and whether the glass shows something
        self.defaults()

    def fault(self, text):
        if len(self.faults) < 10:
            self.faults.append(text)

    def power(self, reset):
        self.held = not reset

    def reset(self, level, now):
        if level and self.reset_at is not None and now - self.reset_at < self.RESET_LOW:
            self.fault(f"reset for {now - self.reset_at} us only")
        self.darken()
        self.defaults()
        self.held, self.reset_at, self.ready = not level, now, now + self.RESET_REST
        self.last = now

    def backlight(self, level):
        self.lit.append((level, not self.dark()))

    def byte(self, value, data, now):
        if self.held:
            self.fault(f"{value:02x} sent while in reset")
            return
        if now < self.ready:
            self.fault(f"{value:02x} sent {(self.ready - now) / MS:.3f} ms too early")
        if self.log and self.last is not None:
            self.log[-1][2] = max(self.log[-1][2], now - self.last)
        self.last = now
        self.take(value, data, now)

    def dark(self):
        """Nothing is to be seen."""
        return self.held or not self.on

    def darken(self):
        """What follows puts the glass out; what it shows now is kept."""
        if not self.dark():
            self.shown = self.glass_pixels()

    def glass_pixels(self):
        self.wiring()
        width, height, left, top = self.glass
        return [self.seen(left + x, top + y) for y in range(height) for x in range(width)]

    def picture(self, turn=0):
        """What is seen on the glass turned clockwise by that many degrees, or was before it went dark; None: nothing."""
        pixels = self.shown if self.dark() else self.glass_pixels()
        width, height = self.glass[:2]
        return pixels and turned_upright(pixels, width, height, turn)


class Dcs(Panel):
    """A 240x320 controller with MIPI's display command set; makers' registers differ."""
    COLUMNS, ROWS = 240, 320
    RESET_LOW, RESET_REST = 10, 5 * MS
    # parameters of each command; None: pixels
    STANDARD = {0x00: 0, 0x01: 0, 0x10: 0, 0x11: 0, 0x13: 0, 0x20: 0, 0x21: 0, 0x28: 0, 0x29: 0, 0x2A: 4, 0x2B: 4, 0x2C: None,
                0x34: 0, 0x35: 1, 0x36: 1, 0x38: 0, 0x3A: 1, 0x3C: None}

    def __init__(self, *glass):
        self.memory = [0xF81F] * (self.COLUMNS * self.ROWS)  # power-up leaves anything
        self.commands = {**self.STANDARD, **self.OWN}
        super().__init__(*glass)

    def defaults(self):
        self.asleep, self.on, self.inverted, self.madctl, self.colmod = True, False, False, 0, 0x66
        self.columns, self.rows = (0, self.COLUMNS - 1), (0, self.ROWS - 1)
        self.at, self.half, self.command, self.parameters = [0, 0], None, None, []
        self.slept_at = None
        self.registers = {}

    def dark(self):
        return super().dark() or self.asleep

    def take(self, value, data, now):
        if not data:
            self.finish()
            self.begin(value, now)
        elif self.commands.get(self.command, 0) is None:
            self.log[-1][1] += 1
            self.pixel_byte(value)
        else:
            self.parameters.append(value)
            self.log[-1][1] += bytes([value])
            self.parameter()

    def finish(self):
        """The command under way has all that belongs to it."""
        wanted = self.commands.get(self.command, 0)
        if wanted is not None and len(self.parameters) != wanted:
            self.fault(f"{self.command or 0:02x}: {len(self.parameters)} parameters, not {wanted}")
        if self.half is not None:
            self.fault("half a pixel")
            self.half = None

    def begin(self, command, now):
        self.command, self.parameters = command, []
        if command not in self.commands:
            self.fault(f"unknown command {command:02x}")
        self.log.append([command, 0 if self.commands.get(command, 0) is None else b"", 0])
        if command in (0x01, 0x10, 0x28):
            self.darken()
        if command == 0x01:
            self.defaults()
            self.reset_at, self.ready = now, now + 5 * MS
        elif command in (0x10, 0x11):
            since = now - ((self.reset_at or 0) if self.slept_at is None else self.slept_at)
            if since < 120 * MS:
                self.fault(f"{command:02x} {since / MS:.1f} ms after a reset or the last of 10, 11: 120 are wanted")
            self.asleep, self.slept_at, self.ready = command == 0x10, now, now + 5 * MS
        elif command in (0x20, 0x21):
            self.inverted = command == 0x21
        elif command in (0x28, 0x29):
            self.on = command == 0x29
        elif command == 0x2C:
            self.at = [self.columns[0], self.rows[0]]

    def parameter(self):
        p = self.parameters
        if self.command == 0x36:
            self.madctl = p[0]
        elif self.command == 0x3A:
            self.colmod = p[0]
        elif self.command in (0x2A, 0x2B) and len(p) == 4:
            window = (p[0] << 8 | p[1], p[2] << 8 | p[3])
            across = (self.command == 0x2A) != bool(self.madctl & 0x20)
            if window[0] > window[1] or window[1] >= (self.COLUMNS if across else self.ROWS):
                self.fault(f"window {window}")
            elif self.command == 0x2A:
                self.columns = window
            else:
                self.rows = window
        else:
            self.registers[self.command] = bytes(p)

    def pixel_byte(self, value):
        if self.half is None:
            self.half = value
            return
        if self.colmod & 7 != 5:
            self.fault("pixels that are not of 16 bits")
        x, y = self.at
        self.at[0] += 1
        if self.at[0] > self.columns[1]:
            self.at[0] = self.columns[0]
            self.at[1] = self.at[1] + 1 if self.at[1] < self.rows[1] else self.rows[0]
        if self.madctl & 0x20:
            x, y = y, x
        if self.madctl & 0x40:
            x = self.COLUMNS - 1 - x
        if self.madctl & 0x80:
            y = self.ROWS - 1 - y
        if 0 <= x < self.COLUMNS and 0 <= y < self.ROWS:
            self.memory[y * self.COLUMNS + x] = self.half << 8 | value
        else:
            self.fault(f"a pixel at {x}, {y}")
        self.half = None

    def colours(self, pixel, blue_first, complement):
        if blue_first:
            pixel = (pixel & 0x1F) << 11 | pixel & 0x7E0 | pixel >> 11
        return pixel ^ 0xFFFF if complement else pixel

    def wiring(self):
        pass


class St7789(Dcs):
    """Its glass is dark without voltage: a true picture wants inversion."""
    OWN = {0xB2: 5, 0xB7: 1, 0xBB: 1, 0xC0: 1, 0xC2: 1, 0xC3: 1, 0xC4: 1, 0xC6: 1, 0xD0: 2, 0xE0: 14, 0xE1: 14}

    def seen(self, x, y):
        return self.colours(self.memory[y * self.COLUMNS + x], self.madctl & 8, not self.inverted)


class Ili9341(Dcs):
    """Its glass has the sources blue first; the gates count from below unless B6's GS turns them."""
    OWN = {0xEF: 3, 0xCF: 3, 0xED: 4, 0xE8: 3, 0xCB: 5, 0xF7: 1, 0xEA: 2, 0xC0: 1, 0xC1: 1, 0xC5: 2, 0xC7: 1, 0xB1: 2, 0xF2: 1,
           0x26: 1, 0xE0: 15, 0xE1: 15, 0xB6: 3}

    def seen(self, x, y):
        if not self.registers.get(0xB6, b"\0\0")[1] & 0x40:
            y = self.ROWS - 1 - y
        return self.colours(self.memory[y * self.COLUMNS + x], not self.madctl & 8, self.inverted)


class Ssd0323(Panel):
    """128x80 pixels of 16 greys, two a byte; a command's arguments come with D/C low."""
    RESET_LOW, RESET_REST = 3, 3
    ARGUMENTS = {0x15: 2, 0x75: 2, 0x81: 1, 0x84: 0, 0x85: 0, 0x86: 0, 0xA0: 1, 0xA1: 1, 0xA2: 1, 0xA4: 0, 0xA5: 0, 0xA6: 0,
                 0xA7: 0, 0xA8: 1, 0xAD: 1, 0xAE: 0, 0xAF: 0, 0xB0: 1, 0xB1: 1, 0xB2: 1, 0xB3: 1, 0xB4: 1, 0xB8: 8, 0xBC: 1,
                 0xBE: 1, 0xBF: 1, 0xE3: 0}

    def __init__(self, *glass):
        self.memory = [5] * (128 * 80)
        super().__init__(*glass)

    def defaults(self):
        self.on, self.mode = False, 0xA4
        self.columns, self.rows, self.at = (0, 63), (0, 79), [0, 0]
        self.command, self.parameters, self.wanted = None, [], 0
        self.registers = {}

    def take(self, value, data, now):
        if data:
            if self.wanted:
                self.fault(f"{self.command:02x}: pixels where a parameter is wanted")
            self.pixels(value)
        elif self.wanted:
            self.wanted -= 1
            self.parameters.append(value)
            self.log[-1][1] += bytes([value])
            if not self.wanted:
                self.set(self.command, self.parameters)
        else:
            self.begin(value)

    def begin(self, command):
        if command not in self.ARGUMENTS:
            self.fault(f"unknown command {command:02x}")
        self.command, self.parameters, self.wanted = command, [], self.ARGUMENTS.get(command, 0)
        self.log.append([command, b"", 0])
        if command == 0xAE:
            self.darken()
        if command in (0xAE, 0xAF):
            self.on = command == 0xAF
        elif command in (0xA4, 0xA5, 0xA6, 0xA7):
            self.mode = command

    def set(self, command, p):
        if command in (0x15, 0x75):
            if not p[0] <= p[1] < (64 if command == 0x15 else 80):
                self.fault(f"window {p}")
            elif command == 0x15:
                self.columns, self.at[0] = tuple(p), p[0]
            else:
                self.rows, self.at[1] = tuple(p), p[0]
        self.registers[command] = bytes(p)

    def pixels(self, value):
        if self.log[-1][0] is not None:
            self.log.append([None, 0, 0])
        self.log[-1][1] += 1
        x, y = self.at
        self.memory[y * 128 + 2 * x], self.memory[y * 128 + 2 * x + 1] = value >> 4, value & 15
        down = self.registers.get(0xA0, b"\0")[0] >> 2 & 1
        windows = (self.columns, self.rows)
        for axis in (down, 1 - down):
            self.at[axis] += 1
            if self.at[axis] <= windows[axis][1]:
                break
            self.at[axis] = windows[axis][0]

    def wiring(self):
        """The 128x64 glass has its lines interleaved and from below, the high nibble left, 64 lines from row 0."""
        for command, value, mask in ((0xA0, 0x52, 0xFB), (0xA8, 0x3F, 0x7F), (0xA2, 0x40, 0x7F), (0xA1, 0x00, 0x7F)):
            have = self.registers.get(command, b"\0")[0] & mask
            if have != value:
                self.fault(f"{command:02x} is {have:02x}, not {value:02x}: the glass would not be as it is wired")

    def seen(self, x, y):
        pixel = self.memory[y * 128 + x]
        return {0xA4: pixel, 0xA5: 15, 0xA6: 0, 0xA7: 15 - pixel}[self.mode]

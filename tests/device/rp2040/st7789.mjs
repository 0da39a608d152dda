// SPDX-License-Identifier: MIT
// The ST7789's side of the wires, by its datasheet's command set: what a glass on its 240x320 memory shows.
// Times are in nanoseconds; what the datasheet forbids is noted in `faults`.

const COLUMNS = 240, ROWS = 320;
const MY = 0x80, MX = 0x40, MV = 0x20, BGR = 0x08;
const MS = 1e6;
const NAMES = {NOP: 0x00, SWRESET: 0x01, SLPIN: 0x10, SLPOUT: 0x11, INVOFF: 0x20, INVON: 0x21, DISPOFF: 0x28, DISPON: 0x29,
    CASET: 0x2a, RASET: 0x2b, RAMWR: 0x2c, TEOFF: 0x34, TEON: 0x35, MADCTL: 0x36, PORCTRL: 0xb2, FRCTRL2: 0xc6, COLMOD: 0x3a, RAMWRC: 0x3c};
// Parameters of the other commands, which set voltages and timing: only their number is checked.
const TUNING = {0xb2: 5, 0xb7: 1, 0xbb: 1, 0xc0: 1, 0xc2: 1, 0xc3: 1, 0xc4: 1, 0xc6: 1, 0xd0: 2, 0xe0: 14, 0xe1: 14};

export class St7789 {
    // The glass as built, and where its first pixel is in the memory.
    constructor({width, height, x = 0, y = 0}) {
        this.glass = {width, height, x, y};
        this.memory = new Uint16Array(COLUMNS * ROWS).fill(0xf81f); // what power-up leaves is anything
        this.faults = [];
        this.bytes = {command: 0, data: 0};
        this.ready = 0; // no command before
        this.defaults();
    }

    defaults() {
        Object.assign(this, {asleep: true, on: false, inverted: false, tearing: false, madctl: 0, colmod: 0x66,
            porches: 24, rate: 0x0f, command: -1,
            parameters: [], columns: [0, COLUMNS - 1], rows: [0, ROWS - 1], x: 0, y: 0, half: -1, held: false});
    }

    fault(text) {
        if (this.faults.length < 10) this.faults.push(text);
    }

    reset(level, now) {
        this.defaults();
        this.held = !level;
        this.resetAt = now;
        this.ready = now + 5 * MS;
    }

    byte(value, data, now) {
        if (this.held) return this.fault('sent while in reset');
        if (now < this.ready) this.fault(`${value.toString(16)} sent ${((this.ready - now) / MS).toFixed(3)} ms too early`);
        if (data) this.parameter(value);
        else this.begin(value, now);
    }

    begin(command, now) {
        this.finish();
        this.bytes.command++;
        this.command = command;
        this.parameters = [];
        switch (command) {
        case NAMES.NOP: break;
        case NAMES.SWRESET: this.defaults(); this.resetAt = now; this.ready = now + 5 * MS; break;
        case NAMES.SLPIN: this.asleep = true; this.ready = now + 5 * MS; break;
        case NAMES.SLPOUT:
            if (now < (this.resetAt ?? 0) + 120 * MS) this.fault('woken within 120 ms of a reset');
            this.asleep = false;
            this.ready = now + 5 * MS;
            break;
        case NAMES.INVOFF: case NAMES.INVON: this.inverted = command === NAMES.INVON; break;
        case NAMES.DISPOFF: case NAMES.DISPON: this.on = command === NAMES.DISPON; break;
        case NAMES.TEOFF: this.tearing = false; break;
        case NAMES.RAMWR: this.x = this.columns[0]; this.y = this.rows[0]; this.half = -1; break;
        case NAMES.RAMWRC: case NAMES.CASET: case NAMES.RASET: case NAMES.MADCTL: case NAMES.COLMOD: case NAMES.TEON: break;
        default: if (!(command in TUNING)) this.fault(`unknown command ${command.toString(16)}`);
        }
    }

    // Before the next command: the one under way has all its parameters.
    finish() {
        const wanted = TUNING[this.command];
        if (wanted !== undefined && wanted !== this.parameters.length)
            this.fault(`${this.command.toString(16)}: ${this.parameters.length} parameters, not ${wanted}`);
        if (this.half >= 0) this.fault('half a pixel');
    }

    parameter(value) {
        this.bytes.data++;
        if (this.command === NAMES.RAMWR || this.command === NAMES.RAMWRC) return this.pixelByte(value);
        this.parameters.push(value);
        const p = this.parameters;
        if (this.command === NAMES.MADCTL) this.madctl = value;
        else if (this.command === NAMES.COLMOD) this.colmod = value;
        else if (this.command === NAMES.TEON) this.tearing = true;
        else if (this.command === NAMES.PORCTRL && p.length === 2) this.porches = p[0] + p[1];
        else if (this.command === NAMES.FRCTRL2) this.rate = value & 0x1f;
        else if ((this.command === NAMES.CASET || this.command === NAMES.RASET) && p.length === 4) {
            const across = (this.command === NAMES.CASET) !== !!(this.madctl & MV);
            const window = [p[0] << 8 | p[1], p[2] << 8 | p[3]];
            if (window[0] > window[1] || window[1] >= (across ? COLUMNS : ROWS)) this.fault(`window ${window}`);
            else if (this.command === NAMES.CASET) this.columns = window;
            else this.rows = window;
        }
    }

    pixelByte(value) {
        if ((this.colmod & 7) !== 5) return this.fault('pixels that are not of 16 bits');
        if (this.half < 0) {
            this.half = value;
            return;
        }
        let x = this.x, y = this.y;
        if (this.madctl & MV) [x, y] = [y, x];
        if (this.madctl & MX) x = COLUMNS - 1 - x;
        if (this.madctl & MY) y = ROWS - 1 - y;
        let pixel = this.half << 8 | value;
        if (this.madctl & BGR) pixel = (pixel & 0x1f) << 11 | (pixel & 0x7e0) | pixel >> 11;
        this.memory[y * COLUMNS + x] = pixel;
        this.half = -1;
        if (++this.x > this.columns[1]) {
            this.x = this.columns[0];
            if (++this.y > this.rows[1]) this.y = this.rows[0];
        }
    }

    // The glass is scanned line after line from the memory, then rests for the porches: the tearing signal.
    get lineNanos() {
        return (250 + 16 * this.rate) * 100;
    }

    get tearingNanos() {
        return {high: this.porches * this.lineNanos, low: ROWS * this.lineNanos};
    }

    // What the glass shows, RGB565. Its liquid crystal is dark without voltage: a true picture needs INVON.
    // Looked at with the glass turned clockwise by that many degrees.
    picture(turn = 0) {
        const {glass} = this, [width, height] = turn % 180 ? [glass.height, glass.width] : [glass.width, glass.height];
        const pixels = new Uint16Array(width * height), right = glass.width - 1, bottom = glass.height - 1;
        for (let y = 0; !this.asleep && this.on && y < height; y++)
            for (let x = 0; x < width; x++) {
                const [gx, gy] = {0: [x, y], 90: [y, bottom - x], 180: [right - x, bottom - y], 270: [right - y, x]}[turn];
                pixels[y * width + x] = this.memory[(glass.y + gy) * COLUMNS + glass.x + gx] ^ (this.inverted ? 0 : 0xffff);
            }
        return {pixels, width, height};
    }
}

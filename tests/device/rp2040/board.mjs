// SPDX-License-Identifier: MIT
// A PicoSystem around an emulated RP2040: takes a UF2 file as the boot ROM does, starts it as the boot ROM does, and
// gives what SPI0's wires carry to a panel.
import fs from 'node:fs';

const FLASH = 0x10000000, BOOT2_AT = 0x20041f00;
const PIN = {reset: 4, cs: 5, sck: 6, mosi: 7, tearing: 8, dc: 9, backlight: 12};
export const BUTTON = {Y: 16, X: 17, A: 18, B: 19, down: 20, right: 21, left: 22, up: 23};
const FUNCTION_SPI = 1, FUNCTION_PWM = 4;

// Blocks of 512 bytes; all of one file must be there, and be for this chip.
export function flashFromUf2(path) {
    const file = fs.readFileSync(path), view = new DataView(file.buffer, file.byteOffset, file.length);
    const word = (at) => view.getUint32(at, true), blocks = file.length / 512, seen = new Set();
    if (!Number.isInteger(blocks) || !blocks) throw new Error(`${path}: not a whole number of blocks`);
    const flash = new Uint8Array(blocks * 256).fill(0xff);
    for (let at = 0; at < file.length; at += 512) {
        const good = word(at) === 0x0a324655 && word(at + 4) === 0x9e5d5157 && word(at + 508) === 0x0ab16f30 &&
            word(at + 8) === 0x2000 && word(at + 16) === 256 && word(at + 24) === blocks && word(at + 28) === 0xe48bff56;
        const address = word(at + 12) - FLASH;
        if (!good || address < 0 || address % 256 || address + 256 > flash.length)
            throw new Error(`${path}: block ${at / 512} is not one of an RP2040 image`);
        flash.set(file.subarray(at + 32, at + 288), address);
        seen.add(word(at + 20));
    }
    if (seen.size !== blocks) throw new Error(`${path}: blocks are missing`);
    return flash;
}

function bootCrc(bytes) {
    let crc = 0xffffffff;
    for (const byte of bytes)
        for (let bit = 7; bit >= 0; bit--) crc = (crc << 1 ^ ((crc >>> 31 ^ byte >> bit) & 1 ? 0x04c11db7 : 0)) >>> 0;
    return crc;
}

export class Board {
    constructor({Simulator}, panel) {
        this.mcu = new Simulator().rp2040;
        this.clock = this.mcu.clock;
        this.panel = panel;
        this.faults = [];
        this.onLine = () => {};
        this.lines = []; // of UART0: text, and the cycles at their first and last byte
        const note = (name, text) => this.fault(`${name}: ${text}`);
        this.mcu.logger = {debug() {}, info() {}, warn: note, error: note};
        for (const pin of Object.values(BUTTON)) this.mcu.gpio[pin].setInputValue(true);
        this.mcu.gpio[PIN.reset].addListener((level) => panel.reset(level === 1, this.clock.nanos));
        this.wireSpi();
        this.wireTearing();
        this.wireUart();
    }

    fault(text) {
        if (this.faults.length < 10) this.faults.push(text);
    }

    press(name, held) {
        this.mcu.gpio[BUTTON[name]].setInputValue(!held);
    }

    // A frame takes its bits' time; D/C and CS must stand still in it.
    wireSpi() {
        const {mcu, clock, panel} = this, spi = mcu.spi[0], pins = mcu.gpio;
        let value = 0, bits = 0, data = false;
        const done = clock.createAlarm(() => {
            if (pins[PIN.cs].outputValue) this.fault('SPI while the panel is not selected');
            if (pins[PIN.dc].outputValue !== data) this.fault('D/C changed while bits were on their way');
            for (let at = bits - 8; at >= 0; at -= 8) panel.byte(value >> at & 0xff, data, clock.nanos);
            spi.completeTransmit(0);
        });
        spi.onTransmit = (frame) => {
            [value, bits, data] = [frame, spi.dataBits, pins[PIN.dc].outputValue];
            if (pins[PIN.sck].functionSelect !== FUNCTION_SPI || pins[PIN.mosi].functionSelect !== FUNCTION_SPI)
                this.fault('SPI is not on its pins');
            if (!spi.enabled || spi.spiMode !== 0 || bits % 8) this.fault(`SPI mode ${spi.spiMode}, ${bits} bits`);
            this.spiHz = spi.clockFrequency;
            done.schedule(bits * 1e9 / this.spiHz);
        };
    }

    wireTearing() {
        const {mcu, clock, panel} = this, pin = mcu.gpio[PIN.tearing];
        const turn = clock.createAlarm(() => {
            const high = !pin.rawInputValue, {high: rest, low: scan} = panel.tearingNanos;
            pin.setInputValue(high && panel.tearing);
            turn.schedule(high ? rest : scan);
        });
        turn.schedule(0);
    }

    // The share of its time that the backlight is on.
    get backlight() {
        const pin = this.mcu.gpio[PIN.backlight], slice = this.mcu.pwm.channels[PIN.backlight >> 1 & 7];
        return pin.functionSelect === FUNCTION_PWM && slice.csr & 1 ? Math.min(1, (slice.cc & 0xffff) / (slice.top + 1)) : 0;
    }

    wireUart() {
        let text = '', begin = 0;
        this.mcu.uart[0].onByte = (byte) => {
            if (text === '') begin = this.cycles;
            if (byte !== 10) {
                text += String.fromCharCode(byte);
                return;
            }
            this.lines.push({text, begin, end: this.cycles});
            this.onLine(text);
            text = '';
        };
    }

    type(text) {
        for (const c of text) this.mcu.uart[0].feedByte(c.charCodeAt(0));
    }

    // RP2040 datasheet 2.8.1.3: the second stage to the end of RAM, its CRC, in.
    boot(flash) {
        const {mcu} = this, stage = flash.subarray(0, 252);
        const crc = new DataView(flash.buffer).getUint32(252, true);
        if (bootCrc(stage) !== crc) throw new Error('the boot ROM refuses the second stage: wrong CRC');
        mcu.flash.set(flash, 0);
        mcu.sram.set(flash.subarray(0, 256), BOOT2_AT - 0x20000000);
        mcu.core.SP = BOOT2_AT;
        mcu.core.LR = 0;
        mcu.core.PC = BOOT2_AT;
        this.slept = 0;
        this.counts = new Float64Array(flash.length / 2); // cycles by half-word of flash, while `counting`
    }

    // Of the system clock since boot, sleep included.
    get cycles() {
        return this.mcu.core.cycles + this.slept;
    }

    // Until the program ends (its code), or so many seconds of its time have gone (undefined).
    run(seconds, until = () => false) {
        const {mcu, clock} = this, {core} = mcu, limit = clock.nanos + seconds * 1e9;
        while (clock.nanos < limit) {
            for (let i = 0; i < 1000; i++) {
                if (core.waiting) {
                    const nanos = Math.max(clock.nanosToNextAlarm, 1e9 / mcu.clkSys);
                    clock.tick(nanos);
                    this.slept += nanos * mcu.clkSys / 1e9;
                } else {
                    const at = core.PC - FLASH >>> 1, cycles = core.executeInstruction();
                    if (this.counting) this.counts[at] += cycles;
                    clock.tick(cycles * 1e9 / mcu.clkSys);
                }
            }
            const ended = /^exit (\d)$/.exec(this.lines.at(-1)?.text ?? '');
            if (ended) return +ended[1];
            if (until(this)) return undefined;
        }
        return undefined;
    }
}

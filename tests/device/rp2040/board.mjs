// SPDX-License-Identifier: MIT
// A board around an emulated RP2040: takes a UF2 file as the boot ROM does, starts it as the boot ROM does, and gives
// what the SPI's wires carry to a panel. Which pins go where is the board's wires.json, written from its maker's
// documents: it stands for the copper, and knows nothing of the firmware's idea of it.
import fs from 'node:fs';
import {createRequire} from 'node:module';
import path from 'node:path';
import {fileURLToPath} from 'node:url';
import {SecondCore} from './second.mjs';
import {St7789} from './st7789.mjs';

const FLASH = 0x10000000, BOOT2_AT = 0x20041f00;
const FUNCTION_SPI = 1, FUNCTION_PWM = 4;
const EXC_HARDFAULT = 3, WATCHDOG = 0x40058, DMA_ABORT = 0x50000444;
const BOARDS = fileURLToPath(new URL('../../../boards', import.meta.url));

// The board that the environment's BOARD names, else a PicoSystem; MODULES: the folder rp2040js was installed into.
export function openBoard(modules) {
    const name = process.env.BOARD || 'picosystem', file = path.join(BOARDS, name, 'wires.json');
    if (!fs.existsSync(file)) throw new Error(`${name}: no board that runs here: there is no ${path.relative('.', file)}`);
    const wires = JSON.parse(fs.readFileSync(file, 'utf8'));
    return new Board(createRequire(path.resolve(modules) + '/')('rp2040js'), wires, new St7789(wires.glass));
}

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
    constructor({Simulator}, wires, panel) {
        this.wires = wires;
        this.pins = wires.pins;
        this.mcu = new Simulator().rp2040;
        this.clock = this.mcu.clock;
        this.panel = panel;
        this.faults = [];
        this.onLine = () => {};
        this.lines = []; // of UART0: text, and the cycles at their first and last byte
        const note = (name, text) => this.fault(`${name}: ${text}`);
        this.mcu.logger = {debug() {}, info: (name, text) => text === 'SEV' && this.second.event(), warn: note, error: note};
        this.second = new SecondCore(this.mcu);
        for (const pin of Object.values(wires.buttons)) this.mcu.gpio[pin].setInputValue(true);
        if ('reset' in this.pins) this.mcu.gpio[this.pins.reset].addListener((level) => panel.reset(level === 1, this.clock.nanos));
        this.wireSpi();
        if ('tearing' in this.pins) this.wireTearing();
        this.wireUart();
    }

    fault(text) {
        if (this.faults.length < 10) this.faults.push(text);
    }

    press(name, held) {
        this.mcu.gpio[this.wires.buttons[name]].setInputValue(!held);
    }

    // What is seen on it, for a program that turns its picture by `turn` more than the glass is turned.
    picture(turn = 0) {
        return this.panel.picture((this.wires.glass.turned + turn) % 360);
    }

    // A frame takes its bits' time; D/C and CS must stand still in it.
    wireSpi() {
        const {mcu, clock, panel, pins: {sck, mosi, cs, dc}} = this, spi = mcu.spi[sck >> 3 & 1], pins = mcu.gpio;
        let value = 0, bits = 0, data = false;
        const done = clock.createAlarm(() => {
            if (cs !== undefined && pins[cs].outputValue) this.fault('SPI while the panel is not selected');
            if (pins[dc].outputValue !== data) this.fault('D/C changed while bits were on their way');
            for (let at = bits - 8; at >= 0; at -= 8) panel.byte(value >> at & 0xff, data, clock.nanos);
            spi.completeTransmit(0);
        });
        spi.onTransmit = (frame) => {
            [value, bits, data] = [frame, spi.dataBits, pins[dc].outputValue];
            if (pins[sck].functionSelect !== FUNCTION_SPI || pins[mosi].functionSelect !== FUNCTION_SPI)
                this.fault('SPI is not on its pins');
            if (!spi.enabled || spi.spiMode !== (cs === undefined ? 3 : 0) || bits % 8) this.fault(`SPI mode ${spi.spiMode}, ${bits} bits`);
            this.spiHz = spi.clockFrequency;
            done.schedule(bits * 1e9 / this.spiHz);
        };
    }

    wireTearing() {
        const {mcu, clock, panel} = this, pin = mcu.gpio[this.pins.tearing];
        const turn = clock.createAlarm(() => {
            const high = !pin.rawInputValue, {high: rest, low: scan} = panel.tearingNanos;
            pin.setInputValue(high && panel.tearing);
            turn.schedule(high ? rest : scan);
        });
        turn.schedule(0);
    }

    // The share of its time that the backlight is on.
    get backlight() {
        const {backlight} = this.pins;
        if (backlight === undefined) return 1;
        const slice = this.mcu.pwm.channels[backlight >> 1 & 7], level = slice.cc >> (backlight & 1 ? 16 : 0) & 0xffff;
        const wired = this.mcu.gpio[backlight].functionSelect === FUNCTION_PWM && slice.csr & 1;
        return wired ? Math.min(1, level / (slice.top + 1)) : 0;
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

    boot(flash) {
        const {mcu} = this;
        mcu.flash.set(flash, 0);
        this.slept = 0;
        this.counts = new Float64Array(flash.length / 2); // cycles of both cores by half-word of flash, while `counting`
        // What rp2040js leaves to its user: the HardFault of an undefined instruction, and the watchdog's reset.
        for (const bus of [mcu, this.second.bus])
            bus.onBreak = () => {
                bus.core.PC -= bus.core.breakRewind;
                bus.core.exceptionEntry(EXC_HARDFAULT);
            };
        mcu.peripherals[WATCHDOG].onWatchdogTrigger = () => this.enter();
        this.enter();
    }

    // RP2040 datasheet 2.8.1.3: the second stage to the end of RAM, its CRC, in. The rest of RAM is left as it is.
    enter() {
        const {mcu} = this, {core} = mcu, flash = mcu.flash, stage = flash.subarray(0, 252);
        const crc = new DataView(flash.buffer).getUint32(252, true);
        if (bootCrc(stage) !== crc) throw new Error('the boot ROM refuses the second stage: wrong CRC');
        mcu.sram.set(flash.subarray(0, 256), BOOT2_AT - 0x20000000);
        Object.assign(core, {IPSR: 0, PM: false, currentMode: 0, pendingInterrupts: 0, enabledInterrupts: 0});
        mcu.writeUint32(DMA_ABORT, 0xfff);
        core.SP = BOOT2_AT;
        core.LR = 0;
        core.PC = BOOT2_AT;
        this.second.reset();
    }

    // Of the system clock since boot, sleep included.
    get cycles() {
        return this.mcu.core.cycles + this.slept;
    }

    // Until the program ends (its code), or so many seconds of its time have gone (undefined).
    run(seconds, until = () => false) {
        const {mcu, clock, second} = this, {core} = mcu, limit = clock.nanos + seconds * 1e9;
        while (clock.nanos < limit) {
            for (let i = 0; i < 1000; i++) {
                const count = this.counting ? this.counts : undefined;
                if (core.waiting) {
                    const ahead = Math.max(clock.nanosToNextAlarm, 1e9 / mcu.clkSys);
                    const nanos = second.asleep ? ahead : Math.min(second.step(count) * 1e9 / mcu.clkSys, ahead);
                    clock.tick(nanos);
                    this.slept += nanos * mcu.clkSys / 1e9;
                } else {
                    const at = core.PC - FLASH >>> 1, cycles = core.executeInstruction();
                    if (count) count[at] += cycles;
                    clock.tick(cycles * 1e9 / mcu.clkSys);
                    second.run(cycles, count);
                }
            }
            const ended = /^exit (\d)$/.exec(this.lines.at(-1)?.text ?? '');
            if (ended) return +ended[1];
            if (until(this)) return undefined;
        }
        return undefined;
    }
}

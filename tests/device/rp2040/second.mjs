// SPDX-License-Identifier: MIT
// The RP2040's second core, which rp2040js lacks: another of its CPU cores on the same bus, with what belongs to a core
// of its own (NVIC, SysTick, divider, CPUID), the FIFOs between the two, events, and the boot ROM's wait for a program,
// by the datasheet (2.3.1, 2.8.2, 2.13). The two advance together, an instruction at most apart. Not modelled: that
// they wait for each other at a bank of RAM or a peripheral; interrupts on the second.
const FLASH = 0x10000000, PSM_FORCE_OFF = 4, PROC1 = 1 << 16, WFE = 0xbf20;
const CPUID = 0x00, FIFO_ST = 0x50, FIFO_WR = 0x54, FIFO_RD = 0x58, FIFO_WORDS = 8;
const VALID = 1, READY = 2, WRITTEN_FULL = 4, READ_EMPTY = 8;
const OWN = (offset) => offset >= 0x60 && offset < 0x100; // divider and interpolators
const SEQUENCE = [0, 0, 1]; // then vectors, stack and entry

export class SecondCore {
    constructor(mcu) {
        this.mcu = mcu;
        const bus = Object.create(mcu); // what is not given here is the first core's too
        this.bus = bus;
        this.core = bus.core = new mcu.core.constructor(bus);
        bus.ppb = new mcu.ppb.constructor(bus, 'PPB1');
        const own = new mcu.sio.constructor(bus), shared = mcu.sio;
        const {readUint32, writeUint32} = shared;
        this.fifo = [[], []]; // for core 0, for core 1
        this.flags = [0, 0];
        const unit = (index, rest) => ({
            readUint32: (offset) => offset === CPUID ? index : this.read(index, offset) ?? readUint32.call(rest(offset), offset),
            writeUint32: (offset, value) => this.write(index, offset, value) || writeUint32.call(rest(offset), offset, value),
        });
        bus.sio = unit(1, (offset) => OWN(offset) ? own : shared);
        Object.assign(shared, unit(0, () => shared));
        this.wirePower();
        this.reset();
    }

    // Into the ROM's wait.
    reset() {
        this.words = [];
        this.running = this.core.waiting = false;
        this.ahead = 0; // cycles
    }

    wirePower() {
        const psm = this.mcu.peripherals[0x40010], {readUint32} = psm;
        let off = 0;
        psm.readUint32 = (offset) => offset === PSM_FORCE_OFF ? off : readUint32.call(psm, offset);
        psm.writeUint32Atomic = (offset, value, kind) => {
            if (offset !== PSM_FORCE_OFF) return;
            off = [value, off ^ value, off | value, off & ~value][kind];
            if (off & PROC1) this.reset();
        };
    }

    read(index, offset) {
        const fifo = this.fifo[index], other = this.fifo[1 - index];
        if (offset === FIFO_ST)
            return (fifo.length ? VALID : 0) | (other.length < FIFO_WORDS ? READY : 0) | this.flags[index];
        if (offset !== FIFO_RD) return undefined;
        if (!fifo.length) this.flags[index] |= READ_EMPTY;
        return fifo.shift() ?? 0;
    }

    write(index, offset, value) {
        const other = this.fifo[1 - index];
        if (offset === FIFO_ST) this.flags[index] &= ~(value & (WRITTEN_FULL | READ_EMPTY));
        else if (offset !== FIFO_WR) return false;
        else if (other.length === FIFO_WORDS) this.flags[index] |= WRITTEN_FULL;
        else other.push(value >>> 0);
        if (!this.running) this.rom();
        return true;
    }

    // Gives each word back; after 0, 0, 1 come vectors, stack and entry, and the ROM enters the program.
    rom() {
        while (this.fifo[1].length) {
            const word = this.fifo[1].shift(), {core, words} = this;
            this.fifo[0].push(word);
            if (words.length < SEQUENCE.length && word !== SEQUENCE[words.length]) words.length = 0;
            else words.push(word);
            if (words.length < SEQUENCE.length + 3) continue;
            [core.VTOR, core.SP, core.PC] = words.slice(SEQUENCE.length);
            core.PC &= ~1;
            core.LR = 0;
            this.running = true;
        }
        this.event();
    }

    // SEV: wakes whoever waits for an event, and is remembered by whoever does not.
    event() {
        for (const core of [this.mcu.core, this.core]) {
            if (core.waiting && this.mcu.readUint16(core.PC - 2) === WFE) core.waiting = false;
            else if (!core.waiting) core.eventRegistered = true;
        }
    }

    get asleep() {
        return !this.running || this.core.waiting;
    }

    // One instruction: its cycles.
    step(counts) {
        const at = this.core.PC - FLASH >>> 1, cycles = this.core.executeInstruction();
        if (counts && at < counts.length) counts[at] += cycles;
        return cycles;
    }

    // As long as the first core took.
    run(cycles, counts) {
        this.ahead -= cycles;
        while (this.ahead < 0 && !this.asleep) this.ahead += this.step(counts);
        if (this.asleep) this.ahead = 0;
    }
}

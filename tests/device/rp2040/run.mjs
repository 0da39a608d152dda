// SPDX-License-Identifier: MIT
// run.mjs MODULES IMAGE.uf2 "COMMAND" PICTURE [SYMBOLS]: runs panel.c on the emulated board with that line on its UART
// and some buttons held, writes what the panel shows, turned as it was mounted, as PICTURE-first and PICTURE, .raw
// (RGB565) and .png, and prints what the program cost. MODULES is the folder that rp2040js was installed into; the
// environment's BOARD names another board than the PicoSystem. With SYMBOLS, what `nm` prints of the image, it prints
// each function's cycles in the second frame that is drawn only.
import fs from 'node:fs';
import {flashFromUf2, openBoard} from './board.mjs';
import {png} from './png.mjs';

const SECONDS = 5, HELD = {up: 1, right: 8, Y: 128}; // bits of hal/input.h
const [modules, image, command, picture, symbols] = process.argv.slice(2);
if (!picture) {
    console.error('usage: run.mjs MODULES IMAGE.uf2 "COMMAND" PICTURE [SYMBOLS]');
    process.exit(2);
}

const turn = +(command.split(' ')[4] ?? 0);

// Cycles of each passage from one line to another, from the end of the first to the begin of the second.
function passages(lines, from, to) {
    return lines.flatMap((line, i) => line.text === from && lines[i + 1]?.text === to ? [lines[i + 1].begin - line.end] : []);
}

// Cycles by function, most first.
function profile(counts) {
    const functions = fs.readFileSync(symbols, 'utf8').split('\n').map((line) => line.split(' '))
        .filter(([, type]) => /^[tTwW]$/.test(type)).map(([at, , name]) => ({at: (parseInt(at, 16) - 0x10000000) >> 1, name, sum: 0}))
        .filter(({at, name}) => at >= 0 && !name.startsWith('$')).sort((a, b) => a.at - b.at);
    const all = counts.reduce((a, b) => a + b, 0);
    functions.forEach((f, i) => f.sum = counts.subarray(f.at, functions[i + 1]?.at).reduce((a, b) => a + b, 0));
    functions.sort((a, b) => b.sum - a.sum).slice(0, 16).forEach(({name, sum}) =>
        console.log(`${String(sum).padStart(9)} ${(100 * sum / all).toFixed(1).padStart(5)} % ${name}`));
}

function write(name, shown) {
    fs.writeFileSync(`${name}.raw`, Buffer.from(shown.pixels.buffer));
    fs.writeFileSync(`${name}.png`, png(shown));
}

try {
    const board = openBoard(modules), {panel} = board, held = Object.keys(HELD).filter((name) => name in board.wires.buttons);
    board.boot(flashFromUf2(image));
    held.forEach((name) => board.press(name, true));
    const heldLine = 'buttons ' + held.reduce((sum, name) => sum + HELD[name], 0).toString(16).padStart(8, '0');
    board.type(command + '\n');
    const bytes = [0];
    const sent = () => panel.bytes.command + panel.bytes.data;
    let drawn = 0;
    board.onLine = (text) => {
        if (text === 'draw') board.counting = drawn++ === 1;
        if (text === 'drawn') board.counting = false;
        if (text === 'show' || text === 'shown') bytes.push(sent());
        if (text === 'first') write(`${picture}-first`, board.picture(turn));
    };
    const code = board.run(SECONDS);
    panel.finish();
    write(picture, board.picture(turn));
    const faults = [...board.faults, ...panel.faults];
    if (code !== 0) faults.push(code === undefined ? 'did not end' : `ended with ${code}`);
    if (!board.lines.some((line) => line.text === heldLine)) faults.push(`no line "${heldLine}"`);
    if (board.backlight !== 1) faults.push(`backlight at ${board.backlight}`);
    faults.forEach((text) => console.error(`${image}: ${text}`));
    const draw = passages(board.lines, 'draw', 'drawn'), show = passages(board.lines, 'show', 'shown');
    console.log(`${command}: cycles ${draw[1]} drawn, ${show[0]} sent whole, ${show[1]} sent by changes;`,
        `bytes ${bytes[2] - bytes[1]}, ${bytes[4] - bytes[3]}; SPI ${board.spiHz / 1e6} MHz, CPU ${board.mcu.clkSys / 1e6} MHz`);
    if (symbols) profile(board.counts);
    process.exit(faults.length ? 1 : 0);
} catch (error) {
    console.error(error.message);
    process.exit(3);
}

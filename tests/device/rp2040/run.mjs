// SPDX-License-Identifier: MIT
// run.mjs MODULES IMAGE.uf2 "COMMAND" PICTURE: runs panel.c on the emulated board with that line on its UART, writes
// what the panel shows, turned as it was mounted, as PICTURE-first and PICTURE, .raw (RGB565) and .png, and prints what
// the program cost.
// MODULES is the folder that rp2040js was installed into.
import fs from 'node:fs';
import {createRequire} from 'node:module';
import path from 'node:path';
import {Board, flashFromUf2} from './board.mjs';
import {png} from './png.mjs';
import {St7789} from './st7789.mjs';

const SECONDS = 5;
const [modules, image, command, picture] = process.argv.slice(2);
if (!picture) {
    console.error('usage: run.mjs MODULES IMAGE.uf2 "COMMAND" PICTURE');
    process.exit(2);
}

const turn = +(command.split(' ')[4] ?? 0);

// Cycles of each passage from one line to another, from the end of the first to the begin of the second.
function passages(lines, from, to) {
    return lines.flatMap((line, i) => line.text === from && lines[i + 1]?.text === to ? [lines[i + 1].begin - line.end] : []);
}

function write(name, shown) {
    fs.writeFileSync(`${name}.raw`, Buffer.from(shown.buffer));
    fs.writeFileSync(`${name}.png`, png(shown, 240, 240));
}

try {
    const panel = new St7789(), board = new Board(createRequire(path.resolve(modules) + '/')('rp2040js'), panel);
    board.boot(flashFromUf2(image));
    board.type(command + '\n');
    const bytes = [0];
    const sent = () => panel.bytes.command + panel.bytes.data;
    board.onLine = (text) => {
        if (text === 'show' || text === 'shown') bytes.push(sent());
        if (text === 'first') write(`${picture}-first`, panel.picture(turn));
    };
    const code = board.run(SECONDS);
    panel.finish();
    write(picture, panel.picture(turn));
    const faults = [...board.faults, ...panel.faults];
    if (code !== 0) faults.push(code === undefined ? 'did not end' : `ended with ${code}`);
    if (board.backlight !== 1) faults.push(`backlight at ${board.backlight}`);
    faults.forEach((text) => console.error(`${image}: ${text}`));
    const draw = passages(board.lines, 'draw', 'drawn'), show = passages(board.lines, 'show', 'shown');
    console.log(`${command}: cycles ${draw[1]} drawn, ${show[0]} sent whole, ${show[1]} sent by changes;`,
        `bytes ${bytes[2] - bytes[1]}, ${bytes[4] - bytes[3]}; SPI ${board.spiHz / 1e6} MHz, CPU ${board.mcu.clkSys / 1e6} MHz`);
    process.exit(faults.length ? 1 : 0);
} catch (error) {
    console.error(error.message);
    process.exit(3);
}

// SPDX-License-Identifier: MIT
// run.mjs MODULES IMAGE.uf2 "COMMAND" PICTURE: runs an image on the emulated board with that line on its UART, writes
// what the panel shows as PICTURE.raw (RGB565) and PICTURE.png, and prints what the program cost.
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

// Cycles between the end of one line and the begin of another.
function between(lines, from, to) {
    const a = lines.find((l) => l.text === from), b = lines.find((l) => l.text === to);
    return a && b ? b.begin - a.end : undefined;
}

try {
    const panel = new St7789(), board = new Board(createRequire(path.resolve(modules) + '/')('rp2040js'), panel);
    board.boot(flashFromUf2(image));
    board.type(command + '\n');
    const code = board.run(SECONDS);
    panel.finish();
    const shown = panel.picture();
    fs.writeFileSync(`${picture}.raw`, Buffer.from(shown.buffer));
    fs.writeFileSync(`${picture}.png`, png(shown, 240, 240));
    const faults = [...board.faults, ...panel.faults];
    faults.forEach((text) => console.error(`${image}: ${text}`));
    board.lines.filter((l) => /^error/.test(l.text)).forEach((l) => console.error(`${image}: ${l.text}`));
    if (code !== 0) console.error(`${image}: ${code === undefined ? 'did not end' : `ended with ${code}`}`);
    const draw = between(board.lines, 'draw', 'drawn'), show = between(board.lines, 'show', 'shown');
    console.log([command, `${draw} cycles a frame drawn`, `${show} drawn and sent`, `${panel.bytes.data} bytes`,
        `SPI ${board.spiHz / 1e6} MHz`, `CPU ${board.mcu.clkSys / 1e6} MHz`].join(', '));
    process.exit(code === 0 && !faults.length ? 0 : 1);
} catch (error) {
    console.error(error.message);
    process.exit(3);
}

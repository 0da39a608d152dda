// SPDX-License-Identifier: MIT
// show.mjs MODULES IMAGE.uf2 PICTURE SECONDS [BUTTON@MS...]: runs any image on the emulated board for so long of its
// time, holds each button for a tenth of a second at its moment (up down left right A B X Y, A+up together), passes on
// what the serial line says and writes what the panel shows then as PICTURE.png and PICTURE.raw (RGB565).
import fs from 'node:fs';
import {createRequire} from 'node:module';
import path from 'node:path';
import {Board, BUTTON, flashFromUf2} from './board.mjs';
import {png} from './png.mjs';
import {St7789} from './st7789.mjs';

const HELD_MS = 100;
const [modules, image, picture, seconds, ...presses] = process.argv.slice(2);
const moments = presses.map((press) => /^([\w+]+)@(\d+)$/.exec(press))
    .flatMap((m) => m ? [[+m[2], m[1], true], [+m[2] + HELD_MS, m[1], false]] : [[NaN]]).sort((a, b) => a[0] - b[0]);
if (!(seconds > 0) || moments.some(([ms, names]) => !(ms < 1000 * seconds) || names.split('+').some((n) => !(n in BUTTON)))) {
    console.error('usage: show.mjs MODULES IMAGE.uf2 PICTURE SECONDS [BUTTON@MS...]');
    process.exit(2);
}

try {
    const panel = new St7789(), board = new Board(createRequire(path.resolve(modules) + '/')('rp2040js'), panel);
    board.boot(flashFromUf2(image));
    board.onLine = (text) => console.log(text);
    let code, now = 0;
    for (const [ms, names, held] of [...moments, [1000 * seconds, '', false]]) {
        code = code ?? board.run((ms - now) / 1000);
        now = ms;
        names.split('+').filter(Boolean).forEach((name) => board.press(name, held));
    }
    const shown = panel.picture();
    fs.writeFileSync(`${picture}.raw`, Buffer.from(shown.buffer));
    fs.writeFileSync(`${picture}.png`, png(shown, 240, 240));
    [...board.faults, ...panel.faults].forEach((text) => console.error(`${image}: ${text}`));
    process.exit(code || board.faults.length || panel.faults.length ? 1 : 0);
} catch (error) {
    console.error(error.message);
    process.exit(3);
}

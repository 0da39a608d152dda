// SPDX-License-Identifier: MIT
// show.mjs MODULES IMAGE.uf2 PICTURE SECONDS [BUTTON@MS...]: runs any image on the emulated board that the environment's
// BOARD names (else a PicoSystem) for so long of its time, holds each button for a tenth of a second at its moment (up
// down left right A B X Y, A+up together; A@700-1500 from 700 to 1500 ms), passes on what the serial line says and
// writes what the panel shows then as PICTURE.png and PICTURE.raw (RGB565).
import fs from 'node:fs';
import {flashFromUf2, openBoard} from './board.mjs';
import {png} from './png.mjs';

const HELD_MS = 100;
const [modules, image, picture, seconds, ...presses] = process.argv.slice(2);

// [[ms, buttons, held]...] in the order of their times
function moments(buttons) {
    return presses.flatMap((press) => {
        const [, names, from, to] = /^([\w+]+)@(\d+)(?:-(\d+))?$/.exec(press) ?? [], end = +(to ?? +from + HELD_MS);
        const wrong = names?.split('+').find((name) => !(name in buttons));
        if (!names || wrong || !(end > from) || !(end <= 1000 * seconds))
            throw new RangeError(`${press}: ${wrong ? `no button ${wrong}` : 'not BUTTON@MS within the time'}; buttons: ${Object.keys(buttons).join(' ')}`);
        return [[+from, names.split('+'), true], [end, names.split('+'), false]];
    }).sort((a, b) => a[0] - b[0]);
}

try {
    if (!(seconds > 0)) throw new RangeError(seconds === undefined ?
        'usage: show.mjs MODULES IMAGE.uf2 PICTURE SECONDS [BUTTON@MS...]' : `SECONDS=${seconds}: no number above 0`);
    const board = openBoard(modules), script = moments(board.wires.buttons);
    board.boot(flashFromUf2(image));
    board.onLine = (text) => console.log(text);
    let code, now = 0;
    for (const [ms, names, held] of [...script, [1000 * seconds, [], false]]) {
        code = code ?? board.run((ms - now) / 1000);
        now = ms;
        names.forEach((name) => board.press(name, held));
    }
    const shown = board.picture();
    fs.writeFileSync(`${picture}.raw`, Buffer.from(shown.pixels.buffer));
    fs.writeFileSync(`${picture}.png`, png(shown));
    const faults = [...board.faults, ...board.panel.faults];
    faults.forEach((text) => console.error(`${image}: ${text}`));
    process.exit(code || faults.length ? 1 : 0);
} catch (error) {
    console.error(error.message);
    process.exit(error instanceof RangeError ? 2 : 3);
}

// SPDX-License-Identifier: MIT
// wasm.mjs MODULE: runs tests/golden/wasm.c's module; its lines go to standard output.
import { readFileSync, writeSync } from "node:fs";

let memory;
const write_text = (at, length) => {
    for (let done = 0; done < length;) done += writeSync(1, new Uint8Array(memory.buffer, at + done, length - done));
};
const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), { env: { write_text } });
memory = instance.exports.memory;
process.exitCode = instance.exports.program_start();

// node run_wasm.mjs PROGRAM [ARG…]: a program built for WebAssembly, which sees the machine's files.
import { readFileSync } from 'node:fs';
import { WASI } from 'node:wasi';

const [program, ...args] = process.argv.slice(2);
globalThis.wasi = new WASI({ // global: node 20 collects it while it is in use
    version: 'preview1', args: [program, ...args], env: process.env, preopens: { '/': '/', '.': '.' }, returnOnExit: true,
});
const instance = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(program)), wasi.getImportObject());
process.exitCode = wasi.start(instance);

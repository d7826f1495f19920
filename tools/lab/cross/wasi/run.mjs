// run.mjs - runs a wasm32-wasi build of Curtain in node: files, arguments and exit code by node's own WASI, and what
// Lua needs in place of setjmp (lua_try.h).
// The program sees the folder it is started in and those below; a name that begins with / is looked up there too.
//
//     node --no-warnings tools/lab/cross/wasi/run.mjs PROGRAM.wasm [ARGUMENT...]

import { readFileSync } from 'node:fs'
import { setFlagsFromString } from 'node:v8'
import { WASI } from 'node:wasi'

// Node 20 dies of a write after a folder was listed, when wasm calls its WASI without going through JavaScript.
setFlagsFromString('--no-turbo-fast-api-calls')

const [file, ...args] = process.argv.slice(2)
const thrown = Symbol('a Lua error')
let program // its exports

const lua = {
  host_throw() {
    throw thrown
  },
  host_try(f, L, ud) {
    const stack = program.__stack_pointer.value
    try {
      program.__indirect_function_table.get(f)(L, ud)
      return 0
    } catch (e) {
      if (e !== thrown) throw e
      program.__stack_pointer.value = stack
      return 1
    }
  },
}

const wasi = new WASI({
  version: 'preview1',
  args: ['curtain', ...args],
  env: process.env,
  preopens: { '/': '.' },
  returnOnExit: true,
})
const module = await WebAssembly.compile(readFileSync(file))
const instance = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: wasi.wasiImport, lua })
program = instance.exports
process.exitCode = wasi.start(instance)

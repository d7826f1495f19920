/*
 * setjmp.h - empty: wasi-libc has none. Lua's ldo.c includes it, and with lua_try.h uses nothing of it.
 * floor: tools    used by: Lua, when it is built for wasm
 */

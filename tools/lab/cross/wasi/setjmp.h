/*
 * setjmp.h - wasi-libc has none, and there is none: a jump ends the program. Lua's ldo.c includes it, and with
 * lua_try.h uses nothing of it; png.c leaves stb's compressor by it where memory is short.
 * Used by: Lua and player/picture/png.c, when they are built for wasm
 */
#ifndef WASI_SETJMP_H
#define WASI_SETJMP_H

#include <stdlib.h>

typedef int jmp_buf[1];

#define setjmp(from)      ((void)(from), 0)
#define longjmp(to, what) ((void)(to), (void)(what), abort())

#endif

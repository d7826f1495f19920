/*
 * lua_try.h - how Lua raises errors where there is no setjmp: the host calls the protected function and catches.
 * Used by: Lua, when it is built for wasm (-include lua_try.h)
 *
 * The host (run.mjs, or a browser's loader) has two imports of module "lua". host_try calls f(L, ud) and returns 0, or
 * 1 when host_throw ended it; then it also puts back the stack pointer. Lua notes why in the jump buffer's status
 * before it throws, so nothing else has to cross.
 */
#ifndef LUA_TRY_H
#define LUA_TRY_H

struct lua_State;

__attribute__((import_module("lua"), import_name("host_try"))) int host_try(void (*f)(struct lua_State *, void *),
                                                                            struct lua_State *L, void *ud);
__attribute__((import_module("lua"), import_name("host_throw"), noreturn)) void host_throw(void);

#define luai_jmpbuf      int
#define LUAI_THROW(L, c) ((void)(c), host_throw())
/* ldo.c has the function in f and its argument in ud; a is a statement that calls it. */
#define LUAI_TRY(L, c, a) ((void)(c), (void)host_try(f, L, ud))

#define l_signalT          int /* no signals */
#define l_randomizePivot() 0u  /* no clock(); of Lua's own sort, which Curtain replaces */

#endif

/*
 * fuzz_bulletml.c - libFuzzer: any bytes as a BulletML document. What is refused says file, line, column and why, in
 * one line. What is taken compiles to a program that the board takes, as Lua is a script that compiles, and runs on a
 * board for a while, to its end or to a fault that says something.
 */
#include <lauxlib.h>
#include "../machine/rig.h"
#include "../../src/workbench/bulletml/as_lua.h"
#include "../../src/workbench/bulletml/compile.h"
#include "../../src/workbench/bulletml/document.h"
#include "fuzz.h"

enum { FRAMES = 40, COSTLY = 20000 /* bytes: a longer one is read, compiled and written, but not run */ };

static struct rig_game game;

static void told(void *context, const char *sentence)
{
    (void)context;
    need(strncmp(sentence, "a.xml:", 6) == 0);
    need_line(sentence);
}

/* Limits of Lua's own are no faults of the script: 200 levels of a source's nesting, 255 registers. */
static void as_script(const struct document *d)
{
    char *script = as_lua(d, "a.xml");

    if (!script)
        return;
    lua_State *L = luaL_newstate();
    if (L && luaL_loadbufferx(L, script, strlen(script), "a.lua", "t") != LUA_OK) {
        const char *why = lua_tostring(L, -1);
        need(strstr(why, "too many") || strstr(why, "overflow") || strstr(why, "too long") || strstr(why, "memory"));
    }
    if (L)
        lua_close(L);
    free(script);
}

static void run(const uint8_t *program, size_t size)
{
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct rig_game with = game;
    struct lump lumps[RIG_LUMPS];
    int n = (int)game.image.rom.count;
    struct rig r;

    for (int i = 0; i < n; i++)
        rom_lump(&game.image.rom, i, &lumps[i]);
    lumps[n++] = (struct lump){ "bulletml/doc", program, (uint32_t)size };
    rig_write(&with, lumps, n);
    rig_power_any(&r, &with, NULL);
    for (int i = 0; i < FRAMES && !rig_fault(&r); i++)
        board_tick(r.b, none);
    need(!rig_fault(&r) || rig_fault(&r)->message[0]);
    rig_free(&r);
    rig_game_free(&with);
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    struct manifest m = rig_manifest();

    (void)argc, (void)argv;
    m.bulletml_runners = 128;
    rig_script(&game, &m,
               "bullet.def('dot', { sprite = 'dot', hit = { circle = 2 } })\n"
               "if #bullet.documents() == 1 then\n"
               "  bullet.ml { name = 'doc', x = 120, y = 80, kind = 'dot', rank = 0.7, seed = 1 }\n"
               "end\n");
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    uint8_t *copy = fuzz_copy(data, size), *program = NULL;
    struct document d;
    char err[1200] = "", why[128];
    size_t bytes;

    if (!document_read(&d, (const char *)copy, size, "a.xml", told, NULL, err, sizeof err)) {
        need(strncmp(err, "a.xml:", 6) == 0);
        need_line(err);
    } else if (!bulletml_compile(&d, "a.xml", &program, &bytes, err, sizeof err)) {
        need_line(err);
    } else {
        need(ml_check(program, bytes, why, sizeof why));
        as_script(&d);
        if (size < COSTLY)
            run(program, bytes);
        free(program);
    }
    document_free(&d);
    free(copy);
    return 0;
}

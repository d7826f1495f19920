/*
 * api_gone.c - what Lua has elsewhere and this board has not, and what to use instead: for `check`, and for faults.
 */
#include <string.h>
#include "api_parts.h"

static const struct {
    const char *space, *name, *instead;
} gone[] = {
    { NULL, "os", "board.frame() tells the time, save.set keeps things" },
    { NULL, "io", "rom.text reads a text of the game, print writes to the log" },
    { NULL, "debug", "print and board.note tell what happens" },
    { NULL, "package", "require loads the game's scripts" },
    { NULL, "coroutine", "task.go starts a task, wait(n) lets frames pass" },
    { NULL, "next", "pairs visits a table in an order that is always the same" },
    { NULL, "dofile", "require runs another script" },
    { NULL, "loadfile", "require runs another script" },
    { NULL, "loadstring", "load takes a text" },
    { NULL, "collectgarbage", "the board collects between frames" },
    { NULL, "xpcall", "pcall catches what error raises" },
    { NULL, "unpack", "it is table.unpack" },
    { NULL, "setfenv", "load takes an environment" },
    { NULL, "getfenv", "load takes an environment" },
    { NULL, "module", "a script returns what it shares" },
    { "math", "random", "rng.int, rng.number, rng.pick or rng.chance" },
    { "math", "randomseed", "the run has a seed: --seed" },
    { "math", "exp", "results differ between machines" },
    { "math", "log", "results differ between machines" },
    { "math", "log10", "results differ between machines" },
    { "math", "pow", "x * x, or math.sqrt" },
    { "math", "ldexp", "x * 2.0 and so on" },
    { "math", "frexp", "math.modf splits a number" },
    { "math", "mod", "it is math.fmod" },
    { "string", "dump", "compiled Lua does not run here" },
    { "string", "pack", "its bytes differ between machines; string.char makes bytes" },
    { "string", "packsize", "sizes differ between machines" },
    { "string", "unpack", "its bytes differ between machines; string.byte reads bytes" },
    { "string", "gfind", "it is string.gmatch" },
    { "table", "getn", "#t is the length of t" },
    { "table", "maxn", "#t is the length of t" },
    { "table", "foreach", "for key, value in pairs(t) do" },
    { "table", "foreachi", "for i, value in ipairs(t) do" },
};

const char *api_instead(const char *space, const char *name)
{
    for (size_t i = 0; i < sizeof gone / sizeof *gone; i++)
        if (!gone[i].space == !space && (!space || !strcmp(gone[i].space, space)) && !strcmp(gone[i].name, name))
            return gone[i].instead;
    return NULL;
}

const char *api_instead_field(const char *name, const char **space)
{
    for (size_t i = 0; i < sizeof gone / sizeof *gone; i++)
        if (gone[i].space && !strcmp(gone[i].name, name)) {
            *space = gone[i].space;
            return gone[i].instead;
        }
    return NULL;
}

/*
 * api_gone.c - standard Lua names that this board lacks, and what to use instead; for the command `check` and for fault
 * messages.
 */
#include <string.h>
#include "api_parts.h"

static const struct {
    const char *library, *name, *advice;
} missing_names[] = {
    { NULL, "os", "use board.frame() for time and save.set for saved data" },
    { NULL, "io", "use rom.text to read the game's text files, and print to write to the log" },
    { NULL, "debug", "use print and board.note" },
    { NULL, "package", "use require" },
    { NULL, "coroutine", "use task.go to start a task and wait(n) to let frames pass" },
    { NULL, "next", "use pairs, whose order is always the same" },
    { NULL, "dofile", "use require" },
    { NULL, "loadfile", "use require" },
    { NULL, "loadstring", "use load" },
    { NULL, "collectgarbage", "garbage is collected between frames" },
    { NULL, "xpcall", "use pcall" },
    { NULL, "unpack", "use table.unpack" },
    { NULL, "setfenv", "pass an environment to load" },
    { NULL, "getfenv", "pass an environment to load" },
    { NULL, "module", "return the module's table from its script" },
    { "math", "random", "use rng.int, rng.number, rng.pick or rng.chance" },
    { "math", "randomseed", "set the seed of a run with --seed" },
    { "math", "exp", "results differ between machines" },
    { "math", "log", "results differ between machines" },
    { "math", "log10", "results differ between machines" },
    { "math", "pow", "use x * x or math.sqrt" },
    { "math", "ldexp", "multiply by a power of two, as in x * 2.0" },
    { "math", "frexp", "use math.modf to split a number" },
    { "math", "mod", "use math.fmod" },
    { "string", "dump", "compiled Lua cannot be loaded" },
    { "string", "pack", "byte layouts differ between machines; use string.char" },
    { "string", "packsize", "sizes differ between machines" },
    { "string", "unpack", "byte layouts differ between machines; use string.byte" },
    { "string", "gfind", "use string.gmatch" },
    { "table", "getn", "use #t" },
    { "table", "maxn", "use #t" },
    { "table", "foreach", "use `for key, value in pairs(t) do`" },
    { "table", "foreachi", "use `for i, value in ipairs(t) do`" },
};

const char *api_replacement(const char *library, const char *name)
{
    for (size_t i = 0; i < sizeof missing_names / sizeof *missing_names; i++)
        if (!missing_names[i].library == !library && (!library || !strcmp(missing_names[i].library, library)) &&
            !strcmp(missing_names[i].name, name))
            return missing_names[i].advice;
    return NULL;
}

const char *api_find_replacement(const char *name, const char **library)
{
    for (size_t i = 0; i < sizeof missing_names / sizeof *missing_names; i++)
        if (missing_names[i].library && !strcmp(missing_names[i].name, name)) {
            *library = missing_names[i].library;
            return missing_names[i].advice;
        }
    return NULL;
}

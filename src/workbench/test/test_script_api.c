/*
 * test_script_api.c - the table of the functions and fields of test scripts, for binding, help and editors.
 */
#include <stdio.h>
#include <string.h>
#include "test_script_parts.h"

static const struct {
    struct test_script_entry doc;
    lua_CFunction call; /* NULL: a field */
} entries[] = {
    { { "test.run", "options: test.options?", "run",
        "starts a run and plays options.frames frames or a whole demo; without options, the run starts at the title" },
      test_script_start_run },
    { { "test.expect", "value: any, what: string?", "boolean",
        "fails the test if `value` is false or nil, but the script continues; returns whether the check passed" },
      test_script_expect },
    { { "test.equal", "got: any, want: any, what: string?", "boolean",
        "like test.expect, but fails unless `got` equals `want`; compares the contents of tables and reports both "
        "values" },
      test_script_equal },
    { { "test.shot", "name: string, run: run?", "boolean",
        "compares the run's frame with tests/golden/NAME.png, pixel by pixel; default: the newest run" },
      test_script_shot },
    { { "test.hash", "name: string, run: run?", "boolean",
        "compares the state of every part with tests/golden/NAME.hash; reports the parts that differ" },
      test_script_hash },

    { { "options.stage", "", "string?", "start at \"NAME\", \"NAME:MARK\" or \"BOSS/PHASE\", like play --stage" },
      NULL },
    { { "options.seed", "", "integer?", "seed of the random streams; default: 0" }, NULL },
    { { "options.difficulty", "", "string?", "one of rom.lua's difficulties; default: the `difficulty` in rom.lua" },
      NULL },
    { { "options.frames", "", "integer?", "number of frames to run, 0 to 216000; default: 0, or the demo's length" },
      NULL },
    { { "options.pads", "", "(string|fun(run: run): string?)?",
        "buttons to hold: \"fire,left@60:90\", as in --press (2.fire for player 2); or a function called before each "
        "frame" },
      NULL },
    { { "options.demo", "", "string?",
        "use the start settings and buttons of a demo in the game, such as \"demos/run.demo\"" },
      NULL },
    { { "options.lang", "", "string?", "the game's language, from lang/NAME.txt" }, NULL },
    { { "options.lives", "", "integer?", "with stage: number of lives, 1 to 99" }, NULL },
    { { "options.invincible", "", "boolean?", "with stage: the player cannot be hit" }, NULL },
    { { "options.registers", "", "table?", "with stage: starting values of the ship's registers: { bombs = 1 }" },
      NULL },
    { { "options.dips", "", "table?", "the game's DIP switches: { coins = \"free\" }" }, NULL },
    { { "options.faults", "", "boolean?",
        "true: an error in the game sets run.fault instead of failing and ending the test" },
      NULL },

    { { "run:step", "frames: integer?", "", "runs this many frames; default: 1" }, test_run_step },
    { { "run:wait", "condition: string|(fun(run: run): boolean), most: integer", "boolean",
        "runs until the condition is true, for at most `most` frames; returns whether it is true; the condition is a "
        "line of the game's Lua or a function" },
      test_run_wait },
    { { "run:press", "pads: (string|fun(run: run): string?)?", "",
        "buttons to hold from now on, like options.pads; frames count from the start of the run; nil: no buttons" },
      test_run_press },
    { { "run:eval", "line: string", "any",
        "like the console: runs a line of Lua in the game, returns its values and undoes its changes" },
      test_run_eval },
    { { "run:exec", "line: string", "any", "like run:eval, but keeps the changes" }, test_run_exec },
    { { "run:live", "part: string", "integer",
        "number of live entities of one kind, such as \"bullets\" or \"enemies\"" },
      test_run_live },
    { { "run:refused", "part: string", "integer",
        "number of times that something did not spawn because its pool was full" },
      test_run_refused },
    { { "run:heard", "sound: string", "integer", "number of times that the sound was started" }, test_run_heard },
    { { "run:printed", "words: string", "boolean", "true if a printed line contains these words" }, test_run_printed },
    { { "run:moment", "kind: string, name: string?", "test.moment?",
        "the first moment of this kind (and with this name, if given), or nil" },
      test_run_moment },
    { { "run.frame", "", "integer", "frames since power-on" }, NULL },
    { { "run.score", "", "integer", "points of player 1" }, NULL },
    { { "run.score2", "", "integer", "points of player 2" }, NULL },
    { { "run.hash", "", "string", "state hash, 16 hexadecimal digits, as printed by curtain hash" }, NULL },
    { { "run.fault", "", "string?", "the error that stopped the game; nil while it runs" }, NULL },
    { { "run.music", "", "string?", "the music that is playing" }, NULL },
    { { "run.difficulty", "", "string?", "the run's difficulty" }, NULL },
    { { "run.log", "", "string[]", "the lines that the game has printed" }, NULL },
    { { "run.moments", "", "test.moment[]",
        "all moments so far (stages, bosses, deaths and so on): { frame, kind, name, of, title, value }; kinds: stage "
        "mark wave boss phase death clear won lost start game over row" },
      NULL },
};
enum { ENTRIES = sizeof entries / sizeof *entries };

bool test_script_entry(int n, struct test_script_entry *out)
{
    if (n < 0 || n >= ENTRIES)
        return false;
    *out = entries[n].doc;
    return true;
}

void test_script_set_functions(lua_State *L, const char *prefix)
{
    const size_t n = strlen(prefix);

    for (int i = 0; i < ENTRIES; i++) {
        if (!entries[i].call || strncmp(entries[i].doc.name, prefix, n) != 0)
            continue;
        lua_pushcfunction(L, entries[i].call);
        lua_setfield(L, -2, entries[i].doc.name + n);
    }
}

/* Writes "what: string?, run: run?" as "what, run". */
static void short_params(const char *params, char *out, size_t size)
{
    size_t n = 0;
    bool name = true;
    int deep = 0;

    for (const char *p = params; *p && n + 1 < size; p++) {
        deep += (*p == '(') - (*p == ')');
        if (*p == ':' && deep == 0)
            name = false;
        if (*p == ',' && deep == 0)
            name = true;
        if (name)
            out[n++] = *p;
    }
    out[n] = 0;
}

void test_script_help(void (*line)(const char *))
{
    char params[80], head[128], text[400];

    for (int i = 0; i < ENTRIES; i++) {
        const struct test_script_entry *e = &entries[i].doc;
        short_params(e->params, params, sizeof params);
        const bool option = strncmp(e->name, "options.", 8) == 0;
        if (option)
            snprintf(head, sizeof head, "  %s =", e->name + 8);
        else
            snprintf(head, sizeof head, entries[i].call ? "%s(%s)" : "%s", e->name, params);
        snprintf(text, sizeof text, "  %-26s %s", head, e->help);
        line(text);
    }
}

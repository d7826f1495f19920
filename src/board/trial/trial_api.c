/*
 * trial_api.c - the table of what test scripts can call and read: functions are bound by it, help and editors print it.
 */
#include <stdio.h>
#include <string.h>
#include "trial_parts.h"

static const struct {
    struct trial_entry is;
    lua_CFunction call; /* NULL: a field */
} entries[] = {
    { { "test.run", "options: test.options?", "run",
        "begins a game and runs it: frames of them, or a demo's to its end; without options the game from its title" },
      trial_test_run },
    { { "test.expect", "value: any, what: string?", "boolean",
        "value is neither false nor nil; else the test has failed, and the script goes on; gives whether it held" },
      trial_test_expect },
    { { "test.equal", "got: any, want: any, what: string?", "boolean",
        "got is want, tables by what is in them; as test.expect, and says both" },
      trial_test_equal },
    { { "test.shot", "name: string, run: run?", "boolean",
        "the picture of the frame is tests/golden/NAME.png, to the pixel; of the newest run, if none is given" },
      trial_test_shot },
    { { "test.hash", "name: string, run: run?", "boolean",
        "the state of every part is that of tests/golden/NAME.hash; says which parts differ" },
      trial_test_hash },

    { { "options.stage", "", "string?", "start at \"NAME\", \"NAME:MARK\" or \"BOSS/PHASE\", as play --stage" }, NULL },
    { { "options.seed", "", "integer?", "seed of the random streams; without it 0" }, NULL },
    { { "options.difficulty", "", "string?", "a name of rom.lua's difficulties; without it rom.lua's" }, NULL },
    { { "options.frames", "", "integer?", "so many frames, 0 to 216000; without it none, or a demo's all" }, NULL },
    { { "options.pads", "", "(string|fun(run: run): string?)?",
        "what is held: \"fire,left@60:90\" as --press takes it, 2.fire of player 2; or a function that is asked before "
        "each frame" },
      NULL },
    { { "options.demo", "", "string?", "start and buttons of that file of the game, \"demos/run.demo\"" }, NULL },
    { { "options.lang", "", "string?", "a language of the game, lang/NAME.txt" }, NULL },
    { { "options.lives", "", "integer?", "with stage: so many lives in all, 1 to 99" }, NULL },
    { { "options.invincible", "", "boolean?", "with stage: nothing hits the player" }, NULL },
    { { "options.registers", "", "table?", "with stage: what registers of the ship start with: { bombs = 1 }" }, NULL },
    { { "options.dips", "", "table?", "DIP switches of the game: { coins = \"free\" }" }, NULL },
    { { "options.faults", "", "boolean?",
        "a fault of the game is no failure: run.fault has it; else it ends the test" },
      NULL },

    { { "run:step", "frames: integer?", "", "so many frames more, 1 if it is not said" }, trial_run_step },
    { { "run:wait", "condition: string|(fun(run: run): boolean), most: integer", "boolean",
        "runs until the condition, Lua of the game or a function, is true, at most so many frames; gives whether it "
        "is" },
      trial_run_wait },
    { { "run:press", "pads: (string|fun(run: run): string?)?", "",
        "what is held from now on, as test.run's pads; frames are counted from the run's beginning; nil: nothing" },
      trial_run_press },
    { { "run:eval", "line: string", "any",
        "the values of a line of the game's Lua, as the console reads it; what it does is undone" },
      trial_run_eval },
    { { "run:exec", "line: string", "any", "the same, and what it does stays" }, trial_run_exec },
    { { "run:live", "part: string", "integer", "what is alive in a part: \"bullets\", \"enemies\"" }, trial_run_live },
    { { "run:refused", "part: string", "integer", "how often that part had no room for one" }, trial_run_refused },
    { { "run:heard", "sound: string", "integer", "how often that sound was begun" }, trial_run_heard },
    { { "run:printed", "words: string", "boolean", "was a line printed that has these words?" }, trial_run_printed },
    { { "run:moment", "kind: string, name: string?", "test.moment?",
        "the first moment of that kind, and of that name; nil: there was none" },
      trial_run_moment },
    { { "run.frame", "", "integer", "frames since power-on" }, NULL },
    { { "run.score", "", "integer", "points of player 1" }, NULL },
    { { "run.score2", "", "integer", "points of player 2" }, NULL },
    { { "run.hash", "", "string", "the state's hash, 16 hexadecimal digits, as curtain hash prints it" }, NULL },
    { { "run.fault", "", "string?", "why the game has stopped; nil: it runs" }, NULL },
    { { "run.music", "", "string?", "the piece of music that plays" }, NULL },
    { { "run.difficulty", "", "string?", "the difficulty that is played" }, NULL },
    { { "run.log", "", "string[]", "the lines that the game has printed" }, NULL },
    { { "run.moments", "", "test.moment[]",
        "stages, bosses, deaths and the like so far: { frame, kind, name, of, title, value }; kinds: stage mark wave "
        "boss phase death clear won lost start game over row" },
      NULL },
};
enum { ENTRIES = sizeof entries / sizeof *entries };

bool trial_entry(int n, struct trial_entry *out)
{
    if (n < 0 || n >= ENTRIES)
        return false;
    *out = entries[n].is;
    return true;
}

void trial_set_functions(lua_State *L, const char *prefix)
{
    const size_t n = strlen(prefix);

    for (int i = 0; i < ENTRIES; i++) {
        if (!entries[i].call || strncmp(entries[i].is.name, prefix, n) != 0)
            continue;
        lua_pushcfunction(L, entries[i].call);
        lua_setfield(L, -2, entries[i].is.name + n);
    }
}

/* "what: string?, run: run?" as "what, run". */
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

void trial_help(void (*line)(const char *))
{
    char params[80], head[128], text[400];

    for (int i = 0; i < ENTRIES; i++) {
        const struct trial_entry *e = &entries[i].is;
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

/*
 * test_told.c - messages about an author's mistakes: writes to read-only properties, full pools, and faults inside the
 * library.
 */
#include "../../src/script/api/api_parts.h"
#include "rig.h"

static const char kinds[] =
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } }) shot.def('bolt', { sprite = 'dot', hit = { circle = 3 "
    "} }) "
    "enemy.def('wall', { sprite = 'dot', hit = { circle = 9 }, hp = 9 }) enemy.def('foe', { sprite = 'dot', hit = "
    "'none', hp = 9 }) spark.def('glow', { sprite = 'dot', life = 9 }) item.def('gem', { sprite = 'dot', radius = 3 }) "
    "laser.def('ray', { strip = 'dot', width = 4, hit = 'none' }) "
    "option.def('bead', { sprite = 'dot', run = function(o) string.bead = o end }) "
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, registers = { power = 3 }, options = { kind = 'bead', "
    "levels = { { wide = { { 9, 9 } } } } } }) "
    "string.route = path.def { { x = 9, y = 9 }, { wait = 999 } }\n";

static struct rig_game g;
static struct rig rig;

/* What a script prints in so many frames, from line 2 of main.lua on. */
static const char *said(const char *text, int frames)
{
    static char script[1 << 14];
    struct manifest m = rig_manifest();

    m.items = m.lines = m.lasers = 8;
    m.curve_points = 64;
    m.options = 4;
    snprintf(script, sizeof script, "%s%s", kinds, text);
    rig_with_sys(&g, &m, script);
    const char *all = rig_said(&g, frames, true);
    rig_game_free(&g);
    return all;
}

/* ---- read-only ---- */

/* A thing of each kind. */
static const char *const made[HANDLE_KINDS] = {
    NULL,
    "bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 }",
    "shot.fire { kind = 'bolt', x = 9, y = 9, speed = 0 }",
    "enemy.spawn { kind = 'foe', x = 9, y = 9 }",
    "player.get(1)",
    "sprite.put { sprite = 'dot', x = 9, y = 9 }",
    "task.go(function() wait(forever) end)",
    "motion.def { { wait = 1 } }",
    "bullet.group('t')",
    "shot.group('t')",
    "enemy.group('t')",
    "(function() item.drop { kind = 'gem', x = 9, y = 9 } return query.near { what = 'item', x = 9, y = 9, radius = 1 "
    "}[1] end)()",
    "item.group('t')",
    "text.line { x = 9, y = 9, text = 'words' }",
    [H_LASER] = "laser.beam { kind = 'ray', x = 9, y = 9, length = 5, hold = forever }",
    [H_LASERS] = "laser.group('t')",
    [H_OPTION] = "string.bead",
};

TEST(read_only)
{
    char text[300], want[200];

    for (int k = 1; k < HANDLE_KINDS; k++) {
        const struct api_thing *t = api_table.things[k];
        if (!made[k]) /* what is of backgrounds has nothing that is read-only */
            continue;
        for (int i = -1; i < t->n; i++) {
            const char *name = i < 0 ? "alive" : t->props[i].name;
            if (i < 0 ? k == H_MOTION || handle_kind_is_group((enum handle_kind)k) : t->props[i].access & PROP_WRITE)
                continue;
            snprintf(text, sizeof text,
                     "string.sys.join(1, 'ship') task.go(function() wait(2) local t = %s t.%s = 1 end)", made[k], name);
            snprintf(want, sizeof want, "main.lua:2: %s: %s is read-only", t->name, name);
            assert_string_equal(said(text, 9), want);
        }
    }
}

/* ---- reserved names ---- */

static bool has_global(const char *name)
{
    const size_t n = strlen(name);

    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const char *entry = api_get_entry(&api_table, i)->name;
        if (!strncmp(entry, name, n) && (!entry[n] || entry[n] == '.'))
            return true;
    }
    return false;
}

/* No reserved global exists: the error would be wrong. */
TEST(none_is_there)
{
    char word[32];
    int n = 0;

    for (const char *names = api_reserved_globals; *names; names += strspn(names, " "), n++) {
        const size_t length = strcspn(names, " ");
        snprintf(word, sizeof word, "%.*s", (int)length, names);
        names += length;
        if (has_global(word))
            fail_msg("reserved global %s exists", word);
        assert_true(api_is_reserved(word));
    }
    assert_true(n > 0 && has_global("bullet"));
    assert_false(api_is_reserved(""));
    assert_false(api_is_reserved("te"));
    assert_false(api_is_reserved("est"));
}

/* ---- full pools ---- */

/* Each is reported once, whatever follows, with the line that asked, also through the library. */
TEST(full)
{
    static const char text[] =
        "task.go(function() for k = 1, 3 do\n"
        "for i = 1, 257 do bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 } end\n"
        "for i = 1, 20 do sprite.put { sprite = 'dot', x = 9, y = 9 } end\n"
        "item.drop { kind = 'gem', x = 9, y = 9, n = 9 }\n"
        "for i = 1, 3 do laser.curve { kind = 'ray', x = 9, y = 9, speed = 0, points = 33 } end\n"
        "stage.wave { kind = 'foe', n = 40, every = 1, path = string.route }\n"
        "for i = 1, 99 do task.scope() end\n"
        "for i = 1, 3 do local steps = {} for k = 1, 200 do steps[k] = { wait = i } end motion.def(steps) end\n"
        "for i = 1, 99 do motion.def { { wait = i } } end\n"
        "wait(60) end end)";

    assert_string_equal(
        said(text, 200),
        "main.lua:3: bullet pool full (256): new bullets are dropped; raise `board.bullets` in rom.lua\n"
        "main.lua:4: sprite pool full (16): new sprites are dropped; raise `board.sprites` in rom.lua\n"
        "main.lua:5: item pool full (8): new items are discarded; raise `board.items` in rom.lua\n"
        "main.lua:6: curve point pool full (64): new curves are dropped; raise `board.curve_points` in rom.lua\n"
        "main.lua:8: task pool full (64): new tasks do not start; raise `board.tasks` in rom.lua\n"
        "main.lua:9: motion step pool full (512): bullets with a new motion fly straight; raise `board.motions` in "
        "rom.lua\n"
        "main.lua:10: motion pool full (32): bullets with a new motion fly straight; raise `board.motions` in "
        "rom.lua\n"
        "main.lua:7: enemy pool full (32): new enemies are dropped; raise `board.enemies` in rom.lua\n");
    assert_string_equal(said("for i = 1, 256 do bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 } end", 1), "");
    /* a thing that nobody is left to own is not refused */
    assert_string_equal(
        said("local s = string.sys.scene(task.scope())\n"
             "task.own(s, function() local c <close> = setmetatable({}, { __close = function()\n"
             "print(sprite.put { sprite = 'dot', x = 9, y = 9 }.alive, board.refused('sprites')) end })\n"
             "wait(forever) end)\n"
             "task.go(function() wait(2) task.stop(s) end)",
             9),
        "false\t0\n");
    /* however much was printed in that frame */
    assert_non_null(strstr(said("task.go(function() for i = 1, 100 do print(('x'):rep(70)) end\n"
                                "for i = 1, 17 do sprite.put { sprite = 'dot', x = 9, y = 9 } end end)",
                                1),
                           "x\nmain.lua:3: sprite pool full"));
}

/* A run that continues from a snapshot reports what the other reported, and a reset is a new run. */
TEST(full_again)
{
    static const char text[] =
        "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"
        "task.go(function() wait(5) for i = 1, 300 do bullet.fire { kind = 'dot', x = 9, y = 9, speed = "
        "0 } end wait(5) if save.get('n', 0) < 2 then save.set('n', save.get('n', 0) + 1) board.reset() "
        "end end)";
    const uint16_t none[MAX_PLAYERS] = { 0 };

    rig_script(&g, NULL, text);
    for (int spoilt = 0; spoilt < 2; spoilt++) {
        rig_power(&rig, &g, NULL);
        for (int f = 0; f < 60; f++) {
            const struct board_out *out = board_tick(rig.b, none);
            rig_sound(&rig);
            assert_int_equal(out->full_pool_count, f == 5 || f == 16 || f == 27);
            if (out->full_pool_count) {
                assert_string_equal(out->full_pool[0].part, "bullets");
                assert_memory_equal(out->full_pool[0].line, out->log, out->log_size - 1);
            }
            if (spoilt)
                rig_spoil(&rig);
        }
        rig_free(&rig);
    }
    rig_game_free(&g);
}

/* ---- mistakes in the library ---- */

/* A fault that Lua raises inside a library file is shown after the author's line. */
TEST(places_in_library)
{
    static const char library[] = "return { def = function(a)\nreturn a.b.c end, known = function() end,\n"
                                  "run = function() task.go(function() wait(1)\nreturn nil + 1 end) end }";
    static const struct {
        const char *text, *says;
    } of[] = {
        { "path.def {}", "main.lua:1: @std/path.lua:2: attempt to index a nil value (field 'b')" },
        { "task.go(function()\nlocal ok, fault = pcall(path.def, {}) error(fault, 0) end)",
          "main.lua:2: @std/path.lua:2: attempt to index a nil value (field 'b')" },
        { "\npath.run()", "main.lua:2: @std/path.lua:4: attempt to perform arithmetic on a nil value" },
    };

    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        const struct rig_script scripts[] = { { "@std/path", library }, { "main", of[i].text } };
        rig_scripts(&g, NULL, scripts, 2);
        assert_string_equal(rig_said(&g, 4, true), of[i].says);
        rig_game_free(&g);
    }
}

/* A piece is run anew each time it is read, with sys, and one that is not there is a fault. */
TEST(pieces)
{
    static const char piece[] = "local sys = ...\nstring.runs = (string.runs or 0) + 1\n"
                                "return function(x) return x .. string.runs .. type(sys.read) end";
    static const char game[] = "local read = string.sys.read\n"
                               "assert(read('boot/list')('a') == 'a1function')\n"
                               "task.go(function()\n"
                               "  assert(read('boot/list')('b') == 'b2function')\n"
                               "  wait(2)\n"
                               "  read('boot/lists')\n"
                               "end)";
    const struct rig_script scripts[] = { { "@std/boot/list", piece },
                                          { "@std/prelude", "string.sys = ... return {}" },
                                          { "main", game } };

    rig_scripts(&g, NULL, scripts, 3);
    assert_string_equal(rig_said(&g, 4, true), "main.lua:6: sys.read: no library file \"boot/lists\" in this ROM");
    rig_game_free(&g);
}

/* ---- requests to the host ---- */

/* A frame's request is made once, and is in the digest of what scripts did, another one for each screen. */
TEST(ask)
{
    static const char *const words[] = { "settings", "replays", "practice", "keys", "quit" };
    uint64_t hash[HOST_SCREENS];
    char text[120];

    for (int i = 0; i < HOST_SCREENS; i++) {
        snprintf(text, sizeof text, "task.go(function() wait(5) board.ask '%s' wait(forever) end)", words[i]);
        rig_script(&g, NULL, text);
        rig_power(&rig, &g, NULL);
        for (int f = 0; f < 10; f++) {
            rig_run(&rig, 1);
            const struct board_out *out = board_last_output(rig.b);
            assert_int_equal(out->request, f == 5 ? REQUEST_HOST_SCREEN : REQUEST_NONE);
            if (f == 5)
                assert_int_equal(out->host_screen, i);
        }
        hash[i] = board_hash(rig.b);
        for (int k = 0; k < i; k++)
            assert_true(hash[k] != hash[i]);
        rig_close(&rig);
    }
}

/* Every default is one of the words that the function takes. */
TEST(words)
{
    for (int i = 0; i < api_count_entries(&api_table); i++)
        for (int k = 0; k < api_get_entry(&api_table, i)->count; k++) {
            const struct api_param *p = &api_get_entry(&api_table, i)->params[k];
            struct api_value v = { 0 };
            int n;
            const char *const *words = api_get_type_words(p->type, &n);
            if (!words || !p->def)
                continue;
            api_fill_default(p, &v);
            if (v.i >= n || strcmp(words[v.i], p->def) != 0)
                fail_msg("%s: %s: \"%s\" is %s", api_get_entry(&api_table, i)->name, p->name, p->def, words[v.i]);
        }
}

RUN_TESTS(NULL, NULL)

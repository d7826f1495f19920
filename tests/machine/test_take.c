/*
 * test_take.c - pad.take: each press once, while it is fresh, by whoever asks first; the game's and the pause's apart;
 * and every example of the guide that waits for a button, with a press at every phase of its loop.
 */
#include <glob.h>
#include "rig.h"

/* ---- against a model: presses as a list, each with the frames of its side since ---- */

enum { MOST = 4096 };

static struct {
    int n;
    struct press {
        uint32_t p, button, age;
        enum press_side side;
        bool gone;
    } list[MOST];
} model;

static void model_latch(const struct input *in, enum press_side side)
{
    for (int i = 0; i < model.n; i++)
        model.list[i].age += model.list[i].side == side;
    for (uint32_t p = 0; p < MAX_PLAYERS; p++)
        for (uint32_t k = 0; k < PAD_BUTTON_COUNT; k++)
            if (in->pressed[p] >> k & 1) {
                assert_true(model.n < MOST);
                model.list[model.n++] = (struct press){ p, k, 0, side, false };
            }
}

static bool model_take(uint32_t p, uint32_t button, uint32_t n, enum press_side side)
{
    for (int i = 0; i < model.n; i++) {
        struct press *one = &model.list[i];
        if (one->gone || one->p != p || one->button != button || one->side != side || one->age > n)
            continue;
        one->gone = true;
        return true;
    }
    return false;
}

static void model_forget(uint32_t p, enum press_side side)
{
    for (int i = 0; i < model.n; i++)
        if (model.list[i].p == p && model.list[i].side == side)
            model.list[i].gone = true;
}

TEST(model)
{
    struct rig_game g;
    struct rig r;
    struct rng rng;
    int taken = 0;

    rig_script(&g, NULL, "");
    rig_power(&r, &g, NULL);
    struct input *in = &r.b->input;
    rng_seed(&rng, 11);
    memset(&model, 0, sizeof model);
    for (int f = 0; f < 600; f++) {
        const uint16_t pads[MAX_PLAYERS] = { (uint16_t)(rng_next(&rng) & rng_next(&rng)), (uint16_t)rng_next(&rng) };
        enum press_side side = f / 50 % 3 == 1 ? PRESS_PAUSE : PRESS_GAME;
        input_latch(in, pads, side, false);
        model_latch(in, side);
        for (int i = 0; i < 6; i++) {
            uint32_t p = (uint32_t)rng_below(&rng, MAX_PLAYERS), k = (uint32_t)rng_below(&rng, PAD_BUTTON_COUNT);
            uint32_t n =
                rng_below(&rng, 3) ? (uint32_t)rng_below(&rng, 6) : (uint32_t)rng_below(&rng, MAX_PRESS_AGE + 1);
            bool want = model_take(p, k, n, side);
            assert_int_equal(input_take(in, p, k, n, side), want);
            taken += want;
        }
        if (rng_below(&rng, 40) == 0) {
            uint32_t p = (uint32_t)rng_below(&rng, MAX_PLAYERS);
            input_drop_presses(in, p, side, PAD_ALL);
            model_forget(p, side);
        }
    }
    assert_true(taken > 500);
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- as scripts have it ---- */

static struct rig_game g;
static struct rig rig;
static char told[4096]; /* what was printed, a letter a line */

static void open(const char *text)
{
    rig_with_sys(&g, NULL, text);
    rig_power(&rig, &g, NULL);
    told[0] = 0;
}

static void shut(void)
{
    rig_free(&rig);
    rig_game_free(&g);
}

static void frame(uint16_t first, uint16_t second)
{
    const uint16_t pads[MAX_PLAYERS] = { first, second };
    size_t n = strlen(told);

    rig_tick(&rig, pads);
    const struct board_out *out = board_last_output(rig.b);
    for (size_t i = 0; i < out->log_size && n + 1 < sizeof told; i++)
        if (out->log[i] != '\n')
            told[n++] = out->log[i];
    told[n] = 0;
    rig_spoil(&rig);
}

static void frames(int n)
{
    while (n-- > 0)
        frame(0, 0);
}

TEST(ages)
{
    /* n = 0 is this very frame; n = 3 is this one and the three before */
    for (int n = 0; n <= 3; n++)
        for (int age = 0; age <= 5; age++) {
            char text[200];
            snprintf(text, sizeof text,
                     "task.go(function() wait(6) if pad.take('bomb', %d) then print 'x' end "
                     "if pad.take('bomb', 60) then print 'y' end end)",
                     n);
            open(text);
            for (int f = 0; f <= 6; f++)
                frame(f == 6 - age ? PAD_BOMB : 0, 0);
            assert_string_equal(told, age <= n ? "x" : "y");
            shut();
        }
    /* at most a second old */
    for (int age = 60; age <= 61; age++) {
        open("task.go(function() wait(70) print(pad.take('bomb', 60) and 'x' or '-') end)");
        for (int f = 0; f <= 70; f++)
            frame(f == 70 - age ? PAD_BOMB : 0, 0);
        assert_string_equal(told, age <= 60 ? "x" : "-");
        shut();
    }
}

TEST(once)
{
    /* held is one press; who asks first has it; two presses between two looks are two; each player's are their own */
    open("task.go(function() while true do if pad.take('fire', 4) then print 'a' end wait(1) end end)\n"
         "task.go(function() while true do if pad.take('fire', 4) then print 'b' end wait(1) end end)\n"
         "task.go(function() while true do if pad.take('fire', 4, 2) then print 'c' end wait(1) end end)\n"
         "task.go(function() while true do if pad.take('bomb', 9) then print 'd' end wait(9) end end)");
    frames(3);
    for (int i = 0; i < 20; i++)
        frame(PAD_FIRE, 0);
    assert_string_equal(told, "a");
    frame(0, PAD_FIRE);
    frame(PAD_FIRE, PAD_FIRE);
    assert_string_equal(told, "aca");
    frames(1);
    frame(PAD_BOMB, 0);
    frames(1);
    frame(PAD_BOMB, 0);
    frames(30);
    assert_string_equal(told, "acadd");
    /* taking changes nothing of what pad.pressed says, and pad.pressed takes nothing */
    shut();
    open("task.go(function() while true do if pad.pressed('fire') then print 'p' end if pad.take('fire', 0) then print "
         "'t' end if pad.pressed('fire') then print 'q' end wait(1) end end)");
    frames(1);
    frame(PAD_FIRE, 0);
    frames(3);
    assert_string_equal(told, "ptq");
    /* nobody's handle has no presses; a player's has its own */
    shut();
    open("task.go(function() wait(2) print(pad.take('fire', 9, player.nearest(0, 0)) and 'x' or '-') print(pad.take("
         "'fire', 9, player.get(2)) and 'y' or '-') end)");
    frame(PAD_FIRE, PAD_FIRE);
    frames(4);
    assert_string_equal(told, "-y");
    shut();
}

TEST(opposites)
{
    /* as pad.pressed has it: right is held still, so left is none, until right comes up */
    open("task.go(function() while true do for _, k in ipairs { 'left', 'right' } do if pad.take(k, 0) then "
         "print(k:sub(1, 1)) end end wait(1) end end)");
    frame(PAD_RIGHT, 0);
    frame(PAD_RIGHT | PAD_LEFT, 0);
    frame(PAD_RIGHT | PAD_LEFT, 0);
    assert_string_equal(told, "r");
    frame(PAD_LEFT, 0);
    assert_string_equal(told, "rl");
    shut();
}

static const char pausing[] =
    "local sys = string.sys\n"
    "task.go(function() while true do wait(4) if pad.take('bomb', 4) then print 'g' end end end)\n"
    "task.go(function()\n"
    "  while true do\n"
    "    wait(1)\n"
    "    if pad.take('start', 0) then\n"
    "      local screen = sys.scope()\n"
    "      task.own(screen, function()\n"
    "        repeat if pad.take('bomb', 60) then print 'p' end wait(1) until pad.take('start', 0)\n"
    "        sys.freeze()\n"
    "        task.stop(screen)\n"
    "      end)\n"
    "      sys.freeze(screen)\n"
    "    end\n"
    "  end\n"
    "end)\n";

/* However the press, the pause and the loop lie: what was pressed before the pause is the game's and waits for it, what
 * was pressed in the pause is the pause's, and each counts once. */
TEST(pause)
{
    for (int phase = 0; phase < 4; phase++)
        for (int before = 0; before <= 4; before++) {
            open(pausing);
            frames(8 + phase);
            frame(PAD_BOMB, 0);
            frames(before);
            frame(PAD_START, 0);
            frames(7);
            bool early = strcmp(told, "g") == 0; /* the loop came by before the pause */
            assert_true(early || told[0] == 0);
            frame(PAD_BOMB, 0);
            frames(70); /* longer than any press is kept */
            assert_string_equal(told, early ? "gp" : "p");
            frame(PAD_BOMB, 0);
            frame(0, 0);
            frame(PAD_START, 0); /* goes on */
            frames(20);
            assert_string_equal(told, early ? "gpp" : "ppg");
            frame(PAD_START, 0); /* and the next pause begins with none */
            frames(3);
            frame(PAD_START, 0);
            frames(20);
            assert_string_equal(told, early ? "gpp" : "ppg");
            shut();
        }
    /* the press that ends the pause is not the game's, held or not */
    open(pausing);
    frames(3);
    frame(PAD_START, 0);
    frames(3);
    assert_true(rig.b->core.frozen);
    frame(PAD_START | PAD_BOMB, 0);
    assert_false(rig.b->core.frozen);
    for (int i = 0; i < 20; i++)
        frame(PAD_BOMB, 0);
    frame(PAD_START, 0);
    frames(3);
    assert_true(rig.b->core.frozen);
    assert_string_equal(told, ""); /* and not the next pause's */
    shut();
}

TEST(joining)
{
    /* what was pressed before the player came is not for the ship, the other player's presses stay */
    open("player.def('ship', { sprite = 'dot', hit = { circle = 2 }, run = function(p) while true do if "
         "pad.take('bomb', "
         "60, p) then print(p.index) end wait(1) end end })\n"
         "task.go(function() wait(5) string.sys.join(1, 'ship') wait(5) string.sys.join(2, 'ship') end)");
    frames(1);
    frame(PAD_BOMB, PAD_BOMB);
    frames(3);
    frame(PAD_BOMB, 0);
    frames(2);
    frame(PAD_BOMB, 0);
    frames(20);
    assert_string_equal(told, "1");
    frame(0, PAD_BOMB);
    frames(20);
    assert_string_equal(told, "12");
    shut();
}

TEST(menu)
{
    /* a press from before a menu opens is stale, the one that answers it is not the game's, and every step counts */
    open("task.go(function() wait(10) print(menu.choose { items = { 'a', 'b', 'c' }, row = 3 })\n"
         "  while true do if pad.take('fire', 7) then print 'g' end wait(7) end end)");
    frames(5);
    frame(PAD_FIRE, 0);
    frames(10);
    assert_string_equal(told, "");
    frame(PAD_DOWN, 0);
    frame(0, PAD_DOWN);
    frame(PAD_DOWN, 0);
    frame(PAD_UP, 0);
    frame(PAD_FIRE, 0);
    frames(70);
    assert_string_equal(told, "3");
    frame(PAD_FIRE, 0);
    frames(10);
    assert_string_equal(told, "3g");
    shut();
    /* so it is when one player alone is asked */
    open("task.go(function() wait(10) print(menu.choose { items = { 'a', 'b' }, row = 3, p = 2 }) end)");
    frames(5);
    frame(PAD_FIRE, PAD_FIRE);
    frames(10);
    frame(PAD_DOWN | PAD_FIRE, 0);
    frames(3);
    assert_string_equal(told, "");
    frame(0, PAD_DOWN);
    frame(0, PAD_FIRE);
    assert_string_equal(told, "2");
    shut();
}

TEST(errors)
{
    static const struct {
        const char *call, *says;
    } wrong[] = {
        { "pad.take('bomb')", "main.lua:1: pad.take: n: expected a whole number from 0 to 60 frames, got nil" },
        { "pad.take('bomb', 61)", "main.lua:1: pad.take: n: expected a whole number from 0 to 60 frames, got 61" },
        { "pad.take('bomb', -1)", "main.lua:1: pad.take: n: expected a whole number from 0 to 60 frames, got -1" },
        { "pad.take('bomb', 1.5)", "main.lua:1: pad.take: n: expected a whole number from 0 to 60 frames, got 1.5" },
        { "pad.take('bomb', 4, 3)", "main.lua:1: pad.take: p: expected 1, 2 or a player, got 3" },
    };

    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        rig_script(&g, NULL, wrong[i].call);
        rig_power_any(&rig, &g, NULL);
        assert_non_null(rig_fault(&rig));
        assert_string_equal(rig_fault(&rig)->message, wrong[i].says);
        shut();
    }
}

/* ---- the guide's examples ---- */

static const char driver[] = "require 'kinds'\n"
                             "local ships, def = {}, player.def\n"
                             "function player.def(name, ...) ships[#ships + 1] = name return def(name, ...) end\n"
                             "for _, ask in ipairs { 'pressed', 'take', 'released', 'repeated' } do\n"
                             "  local real = pad[ask]\n"
                             "  pad[ask] = function(button, ...)\n"
                             "    local yes = real(button, ...)\n"
                             "    if yes then print('\\1' .. ask .. ' ' .. button) end\n"
                             "    return yes\n"
                             "  end\n"
                             "end\n"
                             "local try = require 'try'\n"
                             "stage.def('drive', function()\n"
                             "  local e, p = enemy.spawn { kind = 'jelly', x = 120, y = 70 }, player.get(1)\n"
                             "  e.safe = forever\n"
                             "  if type(try) == 'function' then task.own(e, try, p) end\n"
                             "  while true do\n"
                             "    if ships[1] then p.bombs = 99 end\n" /* there is always one left */
                             "    wait(1)\n"
                             "  end\n"
                             "end)\n"
                             "boot.run { stages = { 'drive' }, players = #ships > 0 and ships or { 'ship' } }\n";

/* The sandbox with other texts in place of two scripts. */
static void sandbox(const char *try)
{
    const struct {
        const char *name, *text;
    } mine[] = { { "script/main.lua", driver }, { "script/try.lua", try } };
    struct rom_image image;
    struct lump lumps[RIG_LUMPS];
    char err[512];

    if (!pack_load_game("examples/sandbox", false, &image, err, sizeof err))
        fail_msg("%s", err);
    int n = (int)image.rom.count;
    assert_true(n <= RIG_LUMPS);
    for (int i = 0; i < n; i++) {
        rom_lump(&image.rom, i, &lumps[i]);
        for (size_t k = 0; k < sizeof mine / sizeof *mine; k++)
            if (!strcmp(lumps[i].name, mine[k].name))
                lumps[i] =
                    (struct lump){ lumps[i].name, (const uint8_t *)mine[k].text, (uint32_t)strlen(mine[k].text) };
    }
    rig_write(&g, lumps, n);
    free(image.bytes);
}

static int said(const char *words)
{
    const struct board_out *out = board_last_output(rig.b);
    char line[64];
    int n = 0, k = snprintf(line, sizeof line, "\1%s\n", words);

    for (size_t i = 0; i + (size_t)k <= out->log_size; i++)
        n += memcmp(out->log + i, line, (size_t)k) == 0;
    return n;
}

enum { PRESSES = 36, LONG = 29 /* frames from press to press: it meets every phase of shorter loops */ };

/* Presses the button at every phase of the loop; every press must be told once. */
static void press_all(const char *page, const char *text, const char *ask, const char *button)
{
    static const char *const names[] = PAD_BUTTON_NAMES;
    struct board_start start = { .seed = 1, .difficulty = -1, .practice = { .section = "drive", .invincible = true } };
    char words[64];
    int k = 0, n = 0;

    snprintf(words, sizeof words, "%s %s", ask, button);
    while (k < PAD_BUTTON_COUNT && strcmp(names[k], button))
        k++;
    assert_true(k < PAD_BUTTON_COUNT);
    sandbox(text);
    for (int i = 0; i < g.cart.manifest.n_dips; i++)
        start.dip[i] = g.cart.manifest.dips[i].default_value;
    rig_power(&rig, &g, &start);
    for (int f = 0; f < (PRESSES + 1) * LONG; f++) {
        bool down = f >= LONG && f % LONG < 1 + f / LONG % 3;
        const uint16_t pads[MAX_PLAYERS] = { (uint16_t)(down ? 1 << k : 0), 0 };
        rig_tick(&rig, pads);
        n += said(words);
    }
    if (n != PRESSES)
        fail_msg("%s: pad.%s(\"%s\"): of %d presses %d counted, in\n%s", page, ask, button, PRESSES, n, text);
    shut();
}

/* Every pad.ASK("BUTTON" of an example but pad.down, which is no press. Returns how many. */
static int play(const char *page, const char *text)
{
    int n = 0;

    for (const char *at = text; (at = strstr(at, "pad.")) != NULL; at++) {
        char ask[16], button[16];
        if (sscanf(at, "pad.%15[a-z](\"%15[a-z]\"", ask, button) != 2 || !strcmp(ask, "down"))
            continue;
        press_all(page, text, ask, button);
        n++;
    }
    return n;
}

/* Plays the Lua examples of a page; returns how many asks for buttons they have. */
static int play_page(const char *page)
{
    static char text[1 << 16];
    char line[512];
    bool in = false, lua = false, task = false;
    int n = 0;
    FILE *f = fopen(page, "r");

    assert_non_null(f);
    while (fgets(line, sizeof line, f)) {
        if (strncmp(line, "```", 3)) {
            if (in && lua)
                strncat(text, line, sizeof text - strlen(text) - 1);
            continue;
        }
        in = !in;
        if (in) {
            task = !strncmp(line, "```lua task", 11);
            lua = task || !strcmp(line, "```lua\n");
            strcpy(text, task ? "return function(e, p)\n" : "");
        } else if (lua) {
            strcat(text, task ? "end\n" : "");
            n += play(page, text);
        }
    }
    fclose(f);
    return n;
}

TEST(examples)
{
    glob_t pages;
    int n = 0;

    assert_int_equal(glob("docs/guide/*.md", 0, NULL, &pages), 0);
    for (size_t i = 0; i < pages.gl_pathc; i++)
        n += play_page(pages.gl_pathv[i]);
    globfree(&pages);
    assert_true(n >= 4);
    play_page("README.md");
}

RUN_TESTS(NULL, NULL)

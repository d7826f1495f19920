/*
 * test_take.c - pad.take: each press once, while it is fresh, by whoever asks first; the game's and the pause's apart.
 */
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
    rig_close(&r);
}

/* ---- as scripts have it ---- */

static struct rig_game g;
static struct rig rig;
static char told[4096]; /* what was printed, a letter a line */

/* A task that prints a letter for each press that it takes; it asks every so many frames. */
static const char watch[] = "local function watch(letter, button, n, every, p)\n"
                            "  task.go(function()\n"
                            "    while true do\n"
                            "      if pad.take(button, n, p) then print(letter) end\n"
                            "      wait(every)\n"
                            "    end\n"
                            "  end)\n"
                            "end\n";

static void open(const char *text)
{
    static char script[4096];

    snprintf(script, sizeof script, "%s%s", watch, text);
    rig_with_sys(&g, NULL, script);
    rig_power(&rig, &g, NULL);
    told[0] = 0;
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

/* n = 0 is this very frame; n = 3 is this one and the three before; a press is kept for a second. */
TEST(ages)
{
    static const int most[] = { 0, 3, 60 };

    for (int i = 0; i < 3; i++)
        for (int age = most[i]; age <= most[i] + 1; age++) {
            char text[200];
            snprintf(text, sizeof text, "task.go(function() wait(70) print(pad.take('bomb', %d) and 'x' or '-') end)",
                     most[i]);
            open(text);
            frames(70 - age);
            frame(PAD_BOMB, 0);
            frames(age);
            assert_string_equal(told, age == most[i] ? "x" : "-");
            rig_close(&rig);
        }
}

/* A button that is held is one press; the first that asks has it; each player's presses are their own. */
TEST(once)
{
    open("watch('a', 'fire', 4, 1)\n"
         "watch('b', 'fire', 4, 1)\n"
         "watch('c', 'fire', 4, 1, 2)\n"
         "watch('d', 'bomb', 9, 9)");
    frames(3);
    for (int i = 0; i < 20; i++)
        frame(PAD_FIRE, 0);
    assert_string_equal(told, "a");
    frame(0, PAD_FIRE);
    frame(PAD_FIRE, PAD_FIRE);
    assert_string_equal(told, "aca");
    frames(1);
    for (int i = 0; i < 2; i++) { /* two presses between two looks are two */
        frame(PAD_BOMB, 0);
        frames(1);
    }
    frames(30);
    assert_string_equal(told, "acadd");
    rig_close(&rig);
}

/* Taking changes nothing of what pad.pressed says, and pad.pressed takes nothing. */
TEST(pressed)
{
    open("task.go(function()\n"
         "  while true do\n"
         "    if pad.pressed('fire') then print 'p' end\n"
         "    if pad.take('fire', 0) then print 't' end\n"
         "    if pad.pressed('fire') then print 'q' end\n"
         "    wait(1)\n"
         "  end\n"
         "end)");
    frames(1);
    frame(PAD_FIRE, 0);
    frames(3);
    assert_string_equal(told, "ptq");
    rig_close(&rig);
}

/* As pad.pressed has it: right is held still, so left is none, until right comes up. */
TEST(opposites)
{
    open("watch('l', 'left', 0, 1) watch('r', 'right', 0, 1)");
    frame(PAD_RIGHT, 0);
    frame(PAD_RIGHT | PAD_LEFT, 0);
    frame(PAD_RIGHT | PAD_LEFT, 0);
    assert_string_equal(told, "r");
    frame(PAD_LEFT, 0);
    assert_string_equal(told, "rl");
    rig_close(&rig);
}

static const char pausing[] =
    "local sys = string.sys\n"
    "watch('g', 'bomb', 4, 4)\n"
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
            rig_close(&rig);
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
    rig_close(&rig);
}

/* What was pressed before the player came is not for the ship; the other player's presses stay. */
TEST(joining)
{
    open("player.def('ship', { sprite = 'dot', hit = { circle = 2 }, run = function(p)\n"
         "  while true do\n"
         "    if pad.take('bomb', 60, p) then print(p.index) end\n"
         "    wait(1)\n"
         "  end\n"
         "end })\n"
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
    rig_close(&rig);
}

/* A press from before a menu opens is stale, the one that answers it is not the game's, and every step counts. */
TEST(menu)
{
    open("task.go(function()\n"
         "  wait(10)\n"
         "  print(menu.choose { items = { 'a', 'b', 'c' }, row = 3 })\n"
         "  watch('g', 'fire', 7, 7)\n"
         "end)");
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
    rig_close(&rig);
    /* the same for one player, whom alone the menu asks */
    open("task.go(function() wait(10) print(menu.choose { items = { 'a', 'b' }, row = 3, p = 2 }) end)");
    frames(5);
    frame(PAD_FIRE, PAD_FIRE);
    frames(10);
    frame(PAD_DOWN | PAD_FIRE, 0);
    frame(0, PAD_DOWN);
    frame(0, PAD_FIRE);
    assert_string_equal(told, "2");
    rig_close(&rig);
}

RUN_TESTS(NULL, NULL)

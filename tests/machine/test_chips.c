/*
 * test_chips.c - each chip by itself, with exact numbers: slots, input, bullets and every motion step, enemies' moves,
 * players, sparks, text, palette, nvram, events.
 */
#include "../unit/big.h"
#include "rig.h"

static fx px(double v)
{
    return (fx)(v * 65536);
}

/* ---- slots ---- */

static const struct column thing_columns[] = { { "v", sizeof(struct slots), 4, 1, false, false, COL_GAME, NULL, 0 } };
static const struct chip thing_chip = { .name = "things", CHIP_COLUMNS(thing_columns) };
struct thing {
    struct slots s;
    uint32_t *v;
};

enum { CAP = 200 }; /* no multiple of 64 */

/* Against a list that is as plain as can be. */
TEST(slots)
{
    static uint8_t room[8192];
    uint64_t words[4];
    uint32_t gen[256], live = 0, refused = 0, holding = 0;
    bool used[256] = { false }, held[256] = { false };
    uint8_t *next = room;
    struct thing t;
    struct rng rng;

    assert_true(slots_size(&thing_chip, CAP, 0) <= sizeof room);
    slots_layout(&thing_chip, &t, CAP, 0, &next);
    assert_int_equal(next - room, slots_size(&thing_chip, CAP, 0));
    for (int i = 0; i < 256; i++)
        gen[i] = 1;
    rng_seed(&rng, 1);
    for (int n = 0; n < 20000; n++) {
        bool fill = n / 1000 % 2 == 0;
        if (rng_below(&rng, 8) < (fill ? 6u : 2u)) {
            int32_t i = slots_take(&t.s), lowest = 0;
            while (lowest < CAP && (used[lowest] || held[lowest]))
                lowest++;
            assert_int_equal(i, lowest < CAP ? lowest : NO_SLOT);
            if (i == NO_SLOT)
                refused++;
            else
                used[i] = true, live++;
        } else {
            uint32_t i = (uint32_t)rng_below(&rng, CAP);
            if (used[i] && rng_below(&rng, 3)) {
                slots_drop(&t.s, i);
                used[i] = false;
                gen[i]++;
                live--;
            } else if (used[i] && (!holding || i < t.s.held_top)) { /* as in a frame: held when others took theirs */
                slots_hold(&t.s, words, i);
                used[i] = false;
                held[i] = true;
                live--;
                holding++;
            }
        }
        if (n % 64 == 63 && rng_below(&rng, 2))
            EACH_HELD (i, &t.s) {
                assert_true(held[i]);
                slots_release(&t.s, i);
                held[i] = false;
                gen[i]++;
                holding--;
            }
        assert_int_equal(t.s.held_count, holding);
        if (rng_below(&rng, 4) == 0)
            slots_trim(&t.s);
        assert_int_equal(t.s.live, live);
        assert_int_equal(t.s.refused, refused);
        assert_true(t.s.top % 64 == 0 && t.s.high_water % 64 == 0 && t.s.top <= t.s.high_water &&
                    t.s.high_water <= 256);
        uint32_t at = 0;
        for (uint32_t i = 0; i < CAP; i++) {
            assert_int_equal(slots_has(&t.s, i, gen[i]), used[i]);
            assert_false(slots_has(&t.s, i, gen[i] + 1));
            assert_int_equal(slots_has_held(&t.s, i, gen[i]), held[i]);
            assert_false(slots_has_held(&t.s, i, gen[i] + 1));
            if (used[i]) {
                assert_int_equal(slots_next(&t.s, at), i);
                at = i + 1;
            }
        }
        assert_int_equal(slots_next(&t.s, at), t.s.top > at ? t.s.top : t.s.top);
    }
    for (uint32_t i = 0; i < CAP; i++)
        if (used[i])
            slots_drop(&t.s, i);
    EACH_HELD (i, &t.s)
        slots_release(&t.s, i);
    assert_null(t.s.held);
    slots_trim(&t.s);
    assert_int_equal(t.s.top, 0);
}

/* Slots near their last generation, among others: none is given a second time under the same one, and a pool of slots
 * that have had their last tenant is full. */
TEST(retired_slots)
{
    static uint8_t room[8192], copy[8192];
    uint32_t last[CAP] = { 0 }, refused = 0, left[CAP];
    uint8_t *next = room;
    struct thing t;
    struct rng rng;

    slots_layout(&thing_chip, &t, CAP, 0, &next);
    for (int i = 0; i < CAP; i++)
        assert_int_equal(slots_take(&t.s), i);
    rng_seed(&rng, 2);
    for (uint32_t i = 0; i < CAP; i++) { /* none to three tenants are left */
        left[i] = (uint32_t)rng_below(&rng, 4);
        t.s.gen[i] = RETIRED_GENERATION - 1 - left[i];
        last[i] = t.s.gen[i];
        slots_drop(&t.s, i);
    }
    for (uint32_t live = 0, rounds = 0; rounds < 4000; rounds++) {
        int32_t lowest = 0;
        while (lowest < CAP && (slots_has(&t.s, (uint32_t)lowest, last[lowest]) || !left[lowest]))
            lowest++;
        int32_t i = slots_take(&t.s);
        assert_int_equal(i, lowest < CAP ? lowest : NO_SLOT);
        if (i == NO_SLOT) {
            assert_int_equal(t.s.refused, ++refused);
        } else {
            assert_true(t.s.gen[i] > last[i] && t.s.gen[i] < RETIRED_GENERATION);
            last[i] = t.s.gen[i];
            left[i]--;
            live++;
        }
        assert_int_equal(t.s.live, live);
        for (uint32_t k = 0; k < CAP; k++)
            if (slots_has(&t.s, k, last[k]) && rng_below(&rng, 3) == 0) {
                slots_drop(&t.s, k);
                live--;
            }
        if (rng_below(&rng, 2)) {
            struct thing was = t; /* as the board's struct is copied */
            slots_save(&thing_chip, &t, copy);
            memset(room, 0xa5, sizeof room);
            t = was;
            slots_restore(&thing_chip, &t, copy);
        }
        slots_trim(&t.s);
    }
    assert_true(refused > 1000);
    for (uint32_t k = 0; k < CAP; k++)
        assert_int_equal(left[k], 0);
}

/* ---- input ---- */

TEST(input)
{
    struct rig_game g;
    struct rig r;
    const struct input *in;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    rig_script(&g, NULL, "");
    rig_power(&r, &g, NULL);
    in = &r.b->input;
    pads[0] = PAD_LEFT | PAD_RIGHT | PAD_UP | PAD_FIRE | 0xfc00;
    pads[1] = PAD_UP | PAD_DOWN | PAD_LEFT;
    rig_tick(&r, pads);
    assert_int_equal(in->held[0], PAD_UP | PAD_FIRE);
    assert_int_equal(in->pressed[0], PAD_UP | PAD_FIRE);
    assert_int_equal(in->held[1], PAD_LEFT);
    pads[0] = PAD_LEFT | PAD_FIRE;
    rig_tick(&r, pads);
    assert_int_equal(in->pressed[0], PAD_LEFT);
    assert_int_equal(in->released[0], PAD_UP);
    assert_int_equal(in->pressed[1] | in->released[1], 0);
    pads[0] = PAD_RIGHT | PAD_LEFT; /* held together: neither, so left comes up */
    rig_tick(&r, pads);
    assert_int_equal(in->released[0], PAD_LEFT | PAD_FIRE);
    pads[0] = 0;
    rig_tick(&r, pads);
    pads[0] = PAD_DOWN;
    for (int f = 0; f <= 41; f++) {
        rig_tick(&r, pads);
        bool again = f == 0 || f == 20 || f == 25 || f == 30 || f == 35 || f == 40;
        assert_int_equal(in->repeated[0], again ? PAD_DOWN : 0);
        assert_int_equal(in->pressed[0], f == 0 ? PAD_DOWN : 0);
    }
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- bullets ---- */

TEST(bullets)
{
    struct rig_game g;
    struct rig r;
    struct bullet_spec s = { .x = px(100), .y = px(50), .speed = px(3), .dir = 0 };

    rig_script(&g, NULL, "");
    rig_power(&r, &g, NULL);
    struct board *b = r.b;
    const int w = b->cart.manifest.field_w, h = b->cart.manifest.field_h, margin = b->cart.manifest.margin;
    assert_int_equal(bullets_fire(&b->bullets, &s, 0), 0);
    s.dir = 0x40000000; /* down */
    s.speed = px(-1.5);
    assert_int_equal(bullets_fire(&b->bullets, &s, 0), 1);
    rig_run(&r, 4);
    assert_int_equal(b->bullets.x[0], px(112));
    assert_int_equal(b->bullets.y[0], px(50));
    assert_int_equal(b->bullets.x[1], px(100));
    assert_int_equal(b->bullets.y[1], px(44));
    assert_int_equal(board_counts(b).moved, 2);

    /* the keep box: its edges belong to it */
    const fx x0 = px(-margin), y0 = px(-margin), x1 = px(w + margin), y1 = px(h + margin);
    const struct {
        fx x, y;
        bool in;
    } at[] = { { x0, y0, true },         { x1, y1, true },         { x0 - 1, px(9), false },
               { x1 + 1, px(9), false }, { px(9), y0 - 1, false }, { px(9), y1 + 1, false } };
    s.speed = 0;
    for (int i = 0; i < 6; i++) {
        s.x = at[i].x;
        s.y = at[i].y;
        assert_int_equal(bullets_fire(&b->bullets, &s, 0), 2);
        rig_run(&r, 1);
        assert_int_equal(b->bullets.s.live_bits[0] >> 2 & 1, at[i].in);
        if (at[i].in)
            bullets_drop(&b->bullets, 2);
        assert_int_equal(b->bullets.x[2], 0);
        assert_int_equal(b->bullets.vx[2] | b->bullets.vy[2], 0);
    }
    /* vx, vy and dir, speed; at speed 0 dir stays */
    bullets_set_velocity(&b->bullets, 0, (int64_t)3 << 32, -((int64_t)4 << 32));
    assert_int_equal(b->bullets.speed[0], px(5));
    assert_int_equal(b->bullets.dir[0], trig_atan2(px(-4), px(3)));
    ang dir = b->bullets.dir[0];
    bullets_set_velocity(&b->bullets, 0, 0, 0);
    assert_int_equal(b->bullets.dir[0], dir);
    assert_int_equal(b->bullets.speed[0], 0);
    /* full: no slot, and it is counted */
    while (b->bullets.s.live < b->bullets.s.cap)
        assert_true(bullets_fire(&b->bullets, &s, 0) != NO_SLOT);
    assert_int_equal(bullets_fire(&b->bullets, &s, 0), NO_SLOT);
    assert_int_equal(board_refused_count(b, "bullets"), 1);
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- motion ---- */

struct flight {
    const char *steps;     /* the program; bullets start at (100, 100) with speed 2 to the right */
    const char *meanwhile; /* run in a task started after the bullet, or NULL */
    double at[10][2];      /* where it is after each frame; x 0: gone or not looked at any more */
};

#define GONE                                                                                                           \
    {                                                                                                                  \
        -1, -1                                                                                                         \
    }

#define TWO_THIRDS (43691 / 65536.0)

static const struct flight flights[] = {
    { "{ wait = 1 }", NULL, { { 102, 100 }, { 104, 100 }, { 106, 100 } } },
    { "{ wait = 3 }, { speed = 0 }", NULL, { { 102, 100 }, { 104, 100 }, { 106, 100 }, { 106, 100 }, { 106, 100 } } },
    { "{ wait = 0 }, { speed = 1 }", NULL, { { 101, 100 }, { 102, 100 } } },
    { "{ wait = forever }, { speed = 0 }", NULL, { { 102, 100 }, { 104, 100 }, { 106, 100 } } },
    /* at once */
    { "{ dir = 90 }", NULL, { { 100, 102 }, { 100, 104 } } },
    { "{ dir = 270 }, { speed = 3 }", NULL, { { 100, 97 }, { 100, 94 } } },
    { "{ turn = 90 }", NULL, { { 100, 102 }, { 100, 104 } } },
    { "{ turn = 90 }, { turn = -180 }", NULL, { { 100, 98 }, { 100, 96 } } },
    { "{ speed = -1 }", NULL, { { 99, 100 }, { 98, 100 } } },
    { "{ accel = 0.5 }", NULL, { { 102.5, 100 }, { 105, 100 } } },
    { "{ aim = true }", NULL, { { 100, 102 }, { 100, 104 } } },
    { "{ aim = true, speed = 4 }", NULL, { { 100, 104 }, { 100, 108 } } },
    { "{ dir = 180, turn = 90 }", NULL, { { 100, 98 }, { 100, 96 } } },
    /* aim comes before turn in the order of the table */
    { "{ aim = true, turn = 90 }", NULL, { { 98, 100 }, { 96, 100 } } },
    { "{ speed = 1, accel = 1 }", NULL, { { 102, 100 }, { 104, 100 } } },
    { "{ die = true }", NULL, { GONE } },
    { "{ wait = 2 }, { die = true }", NULL, { { 102, 100 }, { 104, 100 }, GONE } },
    /* over time: exactly so many frames, the next step in the frame after */
    { "{ speed = 4, over = 4 }", NULL, { { 102.5, 100 }, { 105.5, 100 }, { 109, 100 }, { 113, 100 }, { 117, 100 } } },
    { "{ speed = 0, over = 1 }", NULL, { { 100, 100 }, { 100, 100 } } },
    { "{ accel = 0.5, over = 3 }", NULL, { { 102.5, 100 }, { 105.5, 100 }, { 109, 100 }, { 112.5, 100 } } },
    { "{ turn = 90, over = 2 }", NULL, { { 100, 102 }, { 98, 102 }, { 96, 102 }, { 94, 102 } } },
    { "{ turn = 90, speed = 4, over = 2 }", NULL, { { 100, 103 }, { 96, 103 }, { 92, 103 } } },
    { "{ speed = 4, accel = 1, over = 2 }", NULL, { { 104, 100 }, { 109, 100 }, { 114, 100 } } },
    { "{ home = 90, over = 1 }", NULL, { { 100, 102 }, { 100, 104 } } },
    { "{ home = 180, over = 5 }, { dir = 0 }",
      NULL,
      { { 100, 102 }, { 100, 104 }, { 100, 106 }, { 100, 108 }, { 100, 110 }, { 102, 110 } } },
    { "{ aim = true, over = 2 }, { wait = 1 }, { speed = 0 }",
      NULL,
      { { 100, 102 }, { 100, 104 }, { 100, 106 }, { 100, 106 } } },
    { "{ speed = 3, over = 1 }, { speed = 1, over = 1 }, { dir = 180 }",
      NULL,
      { { 103, 100 }, { 104, 100 }, { 103, 100 } } },
    { "{ bank = 3, over = 2 }, { speed = 0 }", NULL, { { 102, 100 }, { 104, 100 }, { 104, 100 } } },
    /* loops */
    { "{ loop = 2, { turn = 90 }, { wait = 1 } }", NULL, { { 100, 102 }, { 98, 102 }, { 96, 102 } } },
    { "{ loop = forever, { turn = 90, over = 1 } }",
      NULL,
      { { 100, 102 }, { 98, 102 }, { 98, 100 }, { 100, 100 }, { 100, 102 } } },
    { "{ loop = 0, { turn = 90, over = 1 } }, { speed = 1 }", NULL, { { 101, 100 }, { 102, 100 } } },
    { "{ loop = 3, { accel = 1 } }", NULL, { { 105, 100 }, { 110, 100 } } },
    { "{ loop = 2, { loop = 2, { accel = 1 }, { wait = 1 } }, { dir = 90 } }",
      NULL,
      { { 103, 100 }, { 107, 100 }, { 107, 105 }, { 107, 111 }, { 107, 117 } } },
    { "{ loop = 2, { loop = 2, { loop = 2, { loop = 2, { accel = 0.25 } } } } }",
      NULL,
      { { 106, 100 }, { 112, 100 } } },
    /* a script's write wins over the step that drives the same thing; the program goes on */
    { "{ turn = 90, over = 4 }, { speed = 1 }",
      "wait(1) b.dir = 0",
      { { 100, 102 }, { 102, 102 }, { 104, 102 }, { 106, 102 }, { 107, 102 } } },
    { "{ turn = 90, speed = 4, over = 2 }, { turn = 90 }",
      "wait(1) b.speed = 8",
      { { 100, 103 }, { 92, 103 }, { 92, 95 } } },
    { "{ turn = 90, over = 4 }", "wait(1) b.speed = 1", { { 100, 102 }, { 99, 102 }, { 99, 101 }, { 100, 101 } } },
    { "{ turn = 90, speed = 4, over = 3 }, { turn = 90 }",
      "wait(1) b.vx = 3 b.vy = 0",
      { { 100, 102 + TWO_THIRDS }, { 103, 102 + TWO_THIRDS }, { 106, 102 + TWO_THIRDS }, { 106, 105 + TWO_THIRDS } } },
    { "{ turn = 90, over = 9 }", "wait(2) b.motion = nil", { { 100, 102 }, { 98, 102 }, { 96, 102 }, { 94, 102 } } },
    { "{ turn = 90, over = 2 }",
      "wait(2) b.motion = 'p'",
      { { 100, 102 }, { 98, 102 }, { 98, 100 }, { 100, 100 }, { 102, 100 } } },
    { "{ turn = 90, over = 2 }", "wait(1) b.x, b.y = 50, 60", { { 100, 102 }, { 48, 60 }, { 46, 60 } } },
    { "{ turn = 90, over = 2 }", "wait(1) b:turn(180)", { { 100, 102 }, { 100, 100 }, { 100, 98 } } },
    { "{ turn = 90, over = 2 }", "wait(1) b:aim()", { { 100, 102 }, { 100, 104 }, { 100, 106 } } },
};

static void fly(const struct flight *f)
{
    static const char text[] =
        "bullet.def('dot', { sprite = 'dot', hit = 'none' })\n"
        "player.def('ship', { sprite = 'dot', hit = { circle = 1 } })\n"
        "local p = motion.def { name = 'p', %s }\n"
        "stage.def('s', function()\n"
        "  local me = player.get(1) me.x, me.y = 100, 230\n"
        "  local b = bullet.fire { kind = 'dot', x = 100, y = 100, dir = 0, speed = 2, motion = p }\n"
        "  task.go(function() %s end) wait(forever)\n"
        "end)\n"
        "boot.run { stages = { 's' }, players = { 'ship' } }\n";
    static char code[4096];
    struct board_start start = { .seed = 1, .difficulty = -1, .practice.section = "s" };
    struct rig_game g;
    struct rig r;

    snprintf(code, sizeof code, text, f->steps, f->meanwhile ? f->meanwhile : "");
    rig_script(&g, NULL, code);
    rig_power(&r, &g, &start);
    while (!r.b->bullets.s.live && board_frame(r.b) < 5 && f->at[0][0] > 0)
        rig_run(&r, 1);
    if (f->at[0][0] < 0)
        rig_run(&r, 2);
    for (int n = 0; n < 10 && f->at[n][0] != 0; n++) {
        bool live = r.b->bullets.s.live;
        if (live != (f->at[n][0] > 0))
            fail_msg("%s: frame %d: the bullet %s", f->steps, n + 1, live ? "lives" : "is gone");
        double x = r.b->bullets.x[0] / 65536.0, y = r.b->bullets.y[0] / 65536.0;
        if (live && (x != f->at[n][0] || y != f->at[n][1]))
            fail_msg("%s (%s): frame %d: at %.9g %.9g, expected %.9g %.9g", f->steps, f->meanwhile ? f->meanwhile : "",
                     n + 1, x, y, f->at[n][0], f->at[n][1]);
        rig_run(&r, 1);
    }
    rig_free(&r);
    rig_game_free(&g);
}

TEST(motion)
{
    for (size_t i = 0; i < sizeof flights / sizeof *flights; i++)
        fly(&flights[i]);
}

/* Runs a script as the board's only task for some frames; its asserts are the test. */
static void holds(const char *text, int frames)
{
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL, text);
    rig_power(&r, &g, NULL);
    rig_run(&r, frames);
    rig_free(&r);
    rig_game_free(&g);
}

#define DOTS                                                                                                           \
    "bullet.def('dot', { sprite = 'dot', hit = 'none', bank = 2 })\n"                                                  \
    "bullet.def('red', { sprite = 'dot', hit = 'none', bank = 9 })\n"                                                  \
    "local function dot(m, s) return bullet.fire { kind = 'dot', x = 100, y = 100, speed = s or 0, dir = 0, motion = " \
    "m } end\n"

TEST(styles)
{
    /* a kind brings its bank, unless the step gives one; with over, at the start */
    holds(DOTS
          "task.go(function()\n"
          "  local b = dot(motion.def { { wait = 1 }, { kind = 'red' }, { wait = 1 }, { bank = 4 }, { wait = 1 },\n"
          "    { kind = 'dot', bank = 5, over = 2 }, { kind = 'red', over = 2 } })\n"
          "  assert(b.kind == 'dot' and b.bank == 2)\n"
          "  wait(1) assert(b.kind == 'dot')\n"
          "  wait(1) assert(b.kind == 'red' and b.bank == 9)\n"
          "  wait(1) assert(b.bank == 4)\n"
          "  wait(1) assert(b.kind == 'dot' and b.bank == 5)\n"
          "  b.bank = 7 wait(1) assert(b.bank == 7)\n"
          "  wait(1) assert(b.kind == 'red' and b.bank == 9 and b.motion)\n"
          "  wait(2) assert(b.motion == nil)\n"
          "end)",
          12);
    /* aim without anybody: it stays as it is */
    holds(DOTS "task.go(function()\n"
               "  local b = dot(motion.def { { aim = true }, { home = 9, over = 3 } }, 1)\n"
               "  wait(5) assert(b.dir == 0 and b.x == 105)\n"
               "  local a = bullet.fire { kind = 'dot', x = 9, y = 9, speed = 1, aim = true } assert(a.dir == 90)\n"
               "  local c = bullet.fire { kind = 'dot', x = 9, y = 9, speed = 1, aim = true, dir = 10 } "
               "assert(math.abs(c.dir - 100) < 1e-6)\n"
               "end)",
          8);
    /* equal programs are one; a full store gives a dead motion, and the bullet flies straight */
    holds(DOTS "local a, b = motion.def { { turn = 3, over = 4 } }, motion.def { name = 'n', { turn = 3, over = 4 } }\n"
               "assert(a == b and board.live 'motions' == 1)\n"
               "for i = 1, 40 do motion.def { { wait = i } } end\n"
               "assert(board.live 'motions' == 32 and board.refused 'motions' == 9)\n"
               "local dead = motion.def { { wait = 999 } }\n"
               "task.go(function() local x = dot(dead, 1) assert(x.motion == nil) wait(2) assert(x.x == 102) end)",
          4);
    /* forever is more than the 65535 rounds that are counted */
    holds(DOTS "dot(motion.def { { loop = forever, { wait = 1 } }, { die = true } })\n"
               "dot(motion.def { { loop = 65534, { wait = 1 } }, { die = true } })\n"
               "task.go(function() wait(65534) assert(board.live 'bullets' == 2) wait(9) assert(board.live 'bullets' "
               "== 1) end)",
          65550);
    /* speeds end exactly where they should, however odd the steps */
    holds(DOTS
          "task.go(function()\n"
          "  for _, n in ipairs { 1, 3, 7, 11, 59 } do\n"
          "    local b = dot(motion.def { { speed = 1.7, over = n } }, 0.3) local target = dot(nil, 1.7)\n"
          "    wait(n) assert(b.speed == target.speed) wait(1) assert(b.speed == target.speed and b.motion == nil)\n"
          "  end\n"
          "end)",
          90);
}

/* ---- enemies ---- */

TEST(enemies)
{
    static const double eased[4][4] = {
        { 25, 50, 75, 100 }, { 6.25, 25, 56.25, 100 }, { 43.75, 75, 93.75, 100 }, { 12.5, 50, 87.5, 100 }
    };
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL, "");
    rig_power(&r, &g, NULL);
    rig_reserve_kinds(r.b);
    struct board *b = r.b;
    b->enemy_kinds.s.live = 1;
    b->enemy_kinds.hp[0] = 7;
    b->enemy_kinds.bank[0] = 3;
    b->enemy_kinds.flags[0] = 0;
    b->enemy_kinds.sprite[0] = 0;
    /* a move of up to MAX_SPEED in a frame is a way; beyond it, on either axis, a jump */
    static const struct {
        fx dx, dy;
        bool jump;
    } moves[] = { { MAX_SPEED << 16, 0, false },
                  { (MAX_SPEED << 16) + 1, 0, true },
                  { -(MAX_SPEED << 16), 0, false },
                  { -(MAX_SPEED << 16) - 1, 0, true },
                  { 0, (MAX_SPEED << 16) + 1, true },
                  { 0, -(MAX_SPEED << 16) - 1, true },
                  { MAX_SPEED << 16, -(MAX_SPEED << 16), false } };
    for (int k = 0; k < 7; k++) {
        const struct box world = { FX_MIN, FX_MIN, FX_MAX, FX_MAX };
        uint32_t i = (uint32_t)enemies_spawn(&b->enemies, &b->enemy_kinds, 0, -px(3), px(5), 0);
        enemies_move_to(&b->enemies, i, -px(3) + moves[k].dx, px(5) + moves[k].dy, 1, EASE_LINEAR);
        enemies_move(&b->enemies, &world, NULL);
        assert_int_equal(b->enemies.prev_x[i], moves[k].jump ? b->enemies.x[i] : -px(3));
        assert_int_equal(b->enemies.prev_y[i], moves[k].jump ? b->enemies.y[i] : px(5));
        enemies_move(&b->enemies, &world, NULL);
        assert_true(b->enemies.prev_x[i] == b->enemies.x[i] && b->enemies.prev_y[i] == b->enemies.y[i]);
        enemies_drop(&b->enemies, i);
    }
    for (int ease = 0; ease < 4; ease++) {
        assert_int_equal(enemies_spawn(&b->enemies, &b->enemy_kinds, 0, px(10), px(200), b->core.clock), ease);
        assert_int_equal(b->enemies.hp[ease], 7);
        assert_int_equal(b->enemies.bank[ease], 3);
        enemies_move_to(&b->enemies, (uint32_t)ease, px(110), px(0), 4, (enum ease)ease);
    }
    for (int f = 0; f < 6; f++) {
        rig_run(&r, 1);
        for (int ease = 0; ease < 4; ease++) {
            double way = eased[ease][f < 4 ? f : 3];
            assert_int_equal(b->enemies.x[ease], px(10 + way));
            assert_int_equal(b->enemies.y[ease], px(200 - 2 * way));
            assert_int_equal(b->enemies.move_duration[ease], f < 3 ? 4 : 0);
        }
    }
    /* over = 1 arrives at once; odd ways and times arrive exactly */
    struct rng rng;
    rng_seed(&rng, 4);
    for (int n = 0; n < 300; n++) {
        fx x = (fx)rng_below(&rng, 200 << 16), y = (fx)rng_below(&rng, 200 << 16);
        uint32_t over = 1 + (uint32_t)rng_below(&rng, 20);
        enemies_move_to(&b->enemies, 0, x, y, over, (enum ease)(n % 4));
        for (uint32_t f = 0; f < over; f++) {
            assert_int_equal(b->enemies.move_duration[0], over);
            rig_run(&r, 1);
        }
        assert_int_equal(b->enemies.x[0], x);
        assert_int_equal(b->enemies.y[0], y);
        assert_int_equal(b->enemies.move_duration[0], 0);
    }
    /* the longest way in the longest time */
    enemies_move_to(&b->enemies, 1, px(-16383), px(16383), 1000000000, EASE_BOTH);
    b->enemies.x0[1] = px(16383);
    b->enemies.move_elapsed[1] = 999999999;
    rig_run(&r, 1);
    assert_int_equal(b->enemies.s.live_bits[0] >> 1 & 1, 0); /* outside: it left */
    rig_free(&r);
    rig_game_free(&g);

    /* safe = n: n frames, this one included */
    holds("enemy.def('foe', { sprite = 'dot', hit = { box = { 8, 8 } }, hp = 100, touch = false })\n"
          "shot.def('bolt', { sprite = 'dot', hit = { box = { 8, 8 } } })\n"
          "task.go(function()\n"
          "  local e = enemy.spawn { kind = 'foe', x = 50, y = 50 }\n"
          "  local function frame() shot.fire { kind = 'bolt', x = 50, y = 50, speed = 0 } wait(1) return e.hp end\n"
          "  assert(frame() == 99) e.safe = 2 assert(frame() == 99) assert(frame() == 99) assert(frame() == 98)\n"
          "  e.safe = forever for i = 1, 9 do assert(frame() == 98) end assert(e.safe == forever)\n"
          "  e.safe = 0 assert(frame() == 97)\n"
          "  assert(e.kind == 'foe' and e.age == 14 and e.tag == nil)\n"
          "end)",
          20);
}

/* ---- players ---- */

/* Where an enemy is after k of n frames, against wide integers: the place nearest to from + (to - from) * share, ties
 * to the even one, where share is k/n, (k/n)^2, 1 - (1 - k/n)^2, and for "both" 2(k/n)^2 up to the middle, then 1 - 2(1
 * - k/n)^2. */
static bool nearest_place(fx from, fx to, uint32_t k, uint32_t n, enum ease ease, fx place)
{
    struct big whole = big_mul(big_int(n), big_int(n)), part, rest = big_mul(big_int(n - k), big_int(n - k));

    switch (ease) {
    case EASE_IN:
        part = big_mul(big_int(k), big_int(k));
        break;
    case EASE_OUT:
        part = big_sub(whole, rest);
        break;
    case EASE_BOTH:
        part = 2 * (uint64_t)k < n ? big_mul(big_int(2), big_mul(big_int(k), big_int(k)))
                                   : big_sub(whole, big_mul(big_int(2), rest));
        break;
    default:
        part = big_mul(big_int(k), big_int(n));
    }
    struct big way = big_mul(big_sub(big_int(to), big_int(from)), part);
    return big_rounds_to(big_add(big_mul(big_int(from), whole), way), whole, place, (int64_t)FX_MIN - 1,
                         (int64_t)FX_MAX + 1);
}

TEST(enemy_ways)
{
    static const uint32_t times[] = { 1,     2,     3,     4,     7,       60,         1000,     46341,
                                      65534, 65535, 65536, 65537, 1000000, 1000000000, INT32_MAX };
    static const fx ends[] = { 0, 1, -1, 65536, 16383 << 16, -(16383 << 16), (16383 << 16) - 1, FX_MAX, FX_MIN };
    const struct box world = { FX_MIN, FX_MIN, FX_MAX, FX_MAX };
    struct rig_game g;
    struct rig r;
    struct rng rng;

    rig_script(&g, NULL, "");
    rig_power(&r, &g, NULL);
    rig_reserve_kinds(r.b);
    struct enemies *e = &r.b->enemies;
    r.b->enemy_kinds.s.live = 1;
    uint32_t i = (uint32_t)enemies_spawn(e, &r.b->enemy_kinds, 0, 0, 0, 0);
    rng_seed(&rng, 6);
    for (int round = 0; round < 400000; round++) {
        enum ease ease = (enum ease)(round % 4);
        uint32_t n = round % 3 ? times[rng_below(&rng, 15)] : 1 + (uint32_t)rng_below(&rng, 1u << rng_below(&rng, 31));
        uint32_t k = rng_below(&rng, 3) ? 1 + (uint32_t)rng_below(&rng, n)
                                        : (uint32_t[]){ 1, n, (n + 1) / 2, n - (n > 1) }[rng_below(&rng, 4)];
        fx p[4];
        for (int c = 0; c < 4; c++) {
            fx any = (fx)rng_below(&rng, 2 * (16383u << 16)) - (16383 << 16), near = (fx)rng_below(&rng, 64) - 32;
            p[c] = rng_below(&rng, 4) ? rng_below(&rng, 2) ? any : near : ends[rng_below(&rng, 9)];
        }
        e->x[i] = p[0], e->y[i] = p[1];
        enemies_move_to(e, i, p[2], p[3], n, ease);
        e->move_elapsed[i] = k - 1;
        enemies_move(e, &world, NULL);
        if (!nearest_place(p[0], p[2], k, n, ease, e->x[i]) || !nearest_place(p[1], p[3], k, n, ease, e->y[i]))
            fail_msg("ease %d, frame %u of %u: from %d, %d to %d, %d it is at %d, %d", (int)ease, k, n, p[0], p[1],
                     p[2], p[3], e->x[i], e->y[i]);
        assert_int_equal(e->move_duration[i], k == n ? 0 : n);
    }
    rig_free(&r);
    rig_game_free(&g);
}

/* The last tenants of slots, whose handles must stay dead; and the last game of a player. */
TEST(last_generations)
{
    static const char text[] =
        "bullet.def('dot', { sprite = 'dot', hit = 'none' }) shot.def('bolt', { sprite = 'dot', hit = 'none' })\n"
        "enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 1 })\n"
        "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
        "local sys = string.sys\n"
        "local function make()\n"
        "  return { bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 }, shot.fire { kind = 'bolt', x = 9, y = 9, "
        "speed = 0 },\n"
        "    enemy.spawn { kind = 'foe', x = 9, y = 9 }, sprite.put { sprite = 'dot', x = 9, y = 9 } }\n"
        "end\n"
        "local function sleeper() return task.go(function() wait(forever) end) end\n"
        "task.go(function()\n"
        "  wait(1)\n" /* the generations have been set */
        "  local a, s = make(), sleeper()\n"
        "  sys.join(1, 'ship')\n"
        "  local p = player.get(1)\n"
        "  for i, h in ipairs(a) do assert(h.alive, i) h:remove() end\n"
        "  assert(p.alive and task.alive(s)) task.stop(s)\n"
        "  wait(1)\n"
        "  local b, z = make(), sleeper()\n"
        "  for i, h in ipairs(b) do assert(h.alive and h ~= a[i] and not a[i].alive, i) end\n"
        "  assert(task.alive(z) and z ~= s and not task.alive(s))\n"
        "  sys.leave(1) sys.leave(1)\n"
        "  assert(not p.alive and not player.get(1).alive)\n"
        "  sys.join(1, 'ship')\n"
        "end)\n";
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct rig_game g;
    struct rig r;

    rig_with_sys(&g, NULL, text);
    rig_power(&r, &g, NULL);
    rig_run(&r, 1);
    struct slots *pools[] = { &r.b->bullets.s, &r.b->shots.s, &r.b->enemies.s, &r.b->sprites.s, &r.b->tasks.s };
    int32_t slot[5];
    for (int i = 0; i < 5; i++) { /* the slot that comes next */
        slot[i] = slots_take(pools[i]);
        slots_drop(pools[i], (uint32_t)slot[i]);
        slots_trim(pools[i]); /* who takes it next parks the others */
        pools[i]->gen[slot[i]] = RETIRED_GENERATION - 1;
    }
    r.b->player.gen[0] = RETIRED_GENERATION - 1;
    rig_run(&r, 1);
    board_tick(r.b, none);
    assert_non_null(rig_fault(&r));
    assert_string_equal(rig_fault(&r)->message, "main.lua:23: player 1 has joined 1073741822 games; restart the board");
    for (int i = 0; i < 5; i++) {
        assert_int_equal(pools[i]->gen[slot[i]], RETIRED_GENERATION);
        assert_false(slots_has(pools[i], (uint32_t)slot[i], RETIRED_GENERATION));
    }
    rig_free(&r);
    rig_game_free(&g);
}

TEST(score)
{
    char text[] =
        "player.def('ship', { sprite = 'dot', hit = { circle = 2 } }) string.sys.join(1, 'ship')\n"
        "local p = player.get(1)\n"
        "local function is(n) assert(p.score == n, p.score) end\n"
        "score.add(-1, 1) is(0) score.add(5, 1) is(5) score.add(-6, 1) is(0) score.add(-1000000000000, 1) is(0)\n"
        "score.add(999999999998, 1) score.add(1, 1) is(999999999999) score.add(1, 1) is(999999999999)\n"
        "score.add(1000000000000, 1) is(999999999999) score.add(-999999999998, 1) is(1)\n"
        "score.add(-1000000000000, 1) is(0) score.add(1000000000000, 1) is(999999999999)\n";
    struct rig_game g;
    struct rig r;

    rig_with_sys(&g, NULL, text);
    rig_power(&r, &g, NULL);
    rig_free(&r);
    rig_game_free(&g);
}

TEST(player)
{
    static const char text[] =
        "player.def('a', { sprite = 'dot', hit = { circle = 2 }, speed = 4, focus = 1.5, lives = 3, safe = 5 })\n"
        "player.def('b', { sprite = 'dot', hit = { circle = 2 }, registers = { zeal = 7, bombs = 2 } })\n"
        "stage.def('s', function() wait(forever) end) boot.run { stages = { 's' }, players = { 'a', 'b' } }\n";
    struct board_start start = { .seed = 1, .difficulty = -1, .practice.section = "s" };
    const uint16_t right[MAX_PLAYERS] = { PAD_RIGHT }, up_left[MAX_PLAYERS] = { PAD_UP | PAD_LEFT },
                   slow[MAX_PLAYERS] = { PAD_DOWN | PAD_FOCUS }, none[MAX_PLAYERS] = { 0 };
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL, text);
    rig_power(&r, &g, &start);
    rig_run(&r, 1);
    struct board *b = r.b;
    struct player *p = &b->player;
    const int w = b->cart.manifest.field_w, h = b->cart.manifest.field_h;
    assert_int_equal(p->x[0], px(w / 2.0));
    assert_int_equal(p->y[0], px(h * 7 / 8.0));
    assert_int_equal(p->lives[0], 2);
    assert_int_equal(p->x[1], PARK_COORDINATE);
    fx x = p->x[0], y = p->y[0];
    rig_tick(&r, right);
    assert_int_equal(p->x[0], x += px(4));
    assert_int_equal(p->prev_x[0], x - px(4));
    rig_tick(&r, up_left);
    assert_int_equal(p->x[0], x -= 185364); /* 4 / sqrt 2 */
    assert_int_equal(p->y[0], y -= 185364);
    rig_tick(&r, slow);
    assert_int_equal(p->y[0], y += px(1.5));
    assert_int_equal(p->flags[0], PLAYER_FOCUS);
    for (int i = 0; i < 200; i++)
        rig_tick(&r, up_left);
    assert_int_equal(p->x[0], px(8));
    assert_int_equal(p->y[0], px(8));
    rig_tick(&r, none);
    assert_int_equal(p->prev_x[0], px(8));
    player_set_position(p, 0, px(50), px(60));
    assert_int_equal(p->prev_y[0], px(60));
    player_join(p, &b->player_kinds, 1, 1, px(20), px(30));
    assert_int_equal(board_get_register(r.b, 1, 0), 2); /* by name */
    assert_int_equal(board_get_register(r.b, 1, 1), 7);
    assert_int_equal(p->lives[1], 2);
    assert_int_equal(p->safe_left[1], 120);
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- sparks ---- */

TEST(sparks)
{
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL,
               "spark.def('a', { sprite = 'dot', life = 5, gravity = 0.5, drag = 0.25 })\n"
               "spark.def('b', { sprite = 'dot', life = 9 })");
    rig_power(&r, &g, NULL);
    struct sparks *s = &r.b->sparks;
    struct spark_burst burst = { .x = px(50), .y = px(60), .n = 1, .kind = 0 };
    sparks_burst(s, &burst);
    s->vx[0] = px(8);
    s->vy[0] = px(-4);
    rig_run(&r, 1);
    assert_int_equal(s->vx[0], px(6));
    assert_int_equal(s->vy[0], px(-2.5));
    assert_int_equal(s->x[0], px(56));
    assert_int_equal(s->y[0], px(57.5));
    rig_run(&r, 1);
    assert_int_equal(s->vx[0], px(4.5));
    assert_int_equal(s->vy[0], px(-1.375));
    rig_run(&r, 2);
    assert_int_equal(s->s.live, 1);
    rig_run(&r, 1);
    assert_int_equal(s->s.live, 0); /* life = 5 frames */

    /* directions within the spread, speeds from half to all of it */
    burst = (struct spark_burst){
        .x = px(50), .y = px(60), .n = 60, .kind = 1, .speed = px(4), .dir = 0x40000000, .spread = 0x20000000
    };
    sparks_burst(s, &burst);
    assert_int_equal(s->s.live, 60);
    int32_t least = INT32_MAX, largest = INT32_MIN;
    for (int i = 0; i < 60; i++) {
        fx speed = fx_hypot(s->vx[i], s->vy[i]);
        int32_t off = trig_difference(burst.dir, trig_atan2(s->vy[i], s->vx[i]));
        assert_in_range(speed, px(2) - 2, px(4) + 2);
        assert_true(off >= -0x10000000 - 40000 && off <= 0x10000000 + 40000);
        least = off < least ? off : least;
        largest = off > largest ? off : largest;
    }
    assert_true(least < -0x0c000000 && largest > 0x0c000000);
    /* a full pool takes no more, and counts */
    burst.n = 1000;
    sparks_burst(s, &burst);
    assert_int_equal(s->s.live, s->s.cap);
    assert_int_equal(s->s.refused, 1);
    rig_run(&r, 9);
    assert_int_equal(s->s.live, 0);
    /* what leaves the keep box is gone */
    burst.n = 1;
    burst.x = px(-r.b->cart.manifest.margin);
    sparks_burst(s, &burst);
    s->vx[0] = -1;
    s->vy[0] = 0;
    rig_run(&r, 1);
    assert_int_equal(s->s.live, 0);
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- text ---- */

static void row_is(const struct fix *f, uint32_t row, const char *s)
{
    for (uint32_t i = 0; i < f->cols; i++) {
        char want = i < strlen(s) && s[i] != '.' ? s[i] : 0;
        assert_int_equal(f->code[row * f->cols + i], want);
    }
}

TEST(fix)
{
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    m.screen_w = 80;
    m.screen_h = 76; /* 9 rows and a half */
    m.field_w = 80;
    m.field_h = 76;
    rig_script(&g, &m, "");
    rig_power(&r, &g, NULL);
    struct fix *f = &r.b->fix;
    assert_int_equal(f->cols, 10);
    assert_int_equal(f->rows, 9);
    fix_write(f, 2, 1, "abc", 3, 5, 0);
    row_is(f, 1, "..abc");
    assert_int_equal(f->bank[12], 5);
    fix_write(f, -2, 2, "abcd", 4, 1, 0);
    row_is(f, 2, "cd");
    fix_write(f, 8, 3, "abcd", 4, 1, 0);
    row_is(f, 3, "........ab");
    fix_write(f, 0, -1, "x", 1, 1, 0);
    fix_write(f, 0, 9, "x", 1, 1, 0);
    fix_write(f, INT32_MAX, 0, "xyz", 3, 1, 0);
    fix_write(f, INT32_MIN, 0, "xyz", 3, 1, 0);
    row_is(f, 0, "");
    row_is(f, 8, "");
    /* characters, not bytes; what no cell can hold; a byte that is no UTF-8 */
    fix_write(f, 1, 4,
              "\xc3\xa9\xe5\xbc\xbe\xf0\x9f\x98\x80\x89"
              "b",
              11, 2, 0);
    assert_memory_equal(f->code + 40,
                        "\0\xe9\1\1\x89"
                        "b\0",
                        7);
    assert_memory_equal(f->bank + 40, "\0\2\2\2\2\2\0", 7);
    fix_clear(f, 0, 4, 10, 1);
    row_is(f, 4, "");
    /* twice as large: a quarter a cell, cut off as all else */
    fix_write(f, 8, 4, "ab", 2, 3 | FIX_RIM | FIX_BIG, 0);
    fix_write(f, 1, 8, "a", 1, 3 | FIX_BIG, 0);
    row_is(f, 4, "........aa");
    row_is(f, 5, "........aa");
    row_is(f, 8, ".aa");
    const uint8_t look = 3 | FIX_RIM;
    const uint8_t quarters[] = { look | FIX_BIG, look | 2 * FIX_BIG, look | 3 * FIX_BIG, look | 4 * FIX_BIG };
    assert_memory_equal(f->bank + 48, quarters, 2);
    assert_memory_equal(f->bank + 58, quarters + 2, 2);
    assert_int_equal(f->bank[82], 3 | 2 * FIX_BIG);
    fix_clear(f, 0, 4, 10, 5);
    fix_clear(f, 3, 1, 1, 1);
    row_is(f, 1, "..a.c");
    fix_clear(f, -5, 1, 8, 2);
    row_is(f, 1, "....c");
    row_is(f, 2, "");
    fix_clear(f, INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX);
    row_is(f, 1, "....c");
    fix_clear(f, -1000, -1000, INT32_MAX, INT32_MAX);
    row_is(f, 1, "");
    row_is(f, 3, "");
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- palette ---- */

/* After k of n frames |2 (rgb - from) n - 2 (to - from) k| <= n, and where it is n the colour is the one nearer to
 * `to`. */
TEST(fades)
{
    struct rig_game g;
    struct rig r;
    struct rng rng;

    rig_script(&g, NULL, "");
    rig_power(&r, &g, NULL);
    struct pal *p = &r.b->pal;
    rng_seed(&rng, 8);
    for (int round = 0; round < 20000; round++) {
        uint32_t from = (uint32_t)rng_below(&rng, 1 << 24), to = (uint32_t)rng_below(&rng, 1 << 24);
        uint16_t n = (uint16_t)(1 + rng_below(&rng, round % 2 ? 60 : 65535)), k = (uint16_t)(1 + rng_below(&rng, n));
        pal_set(p, 3, from);
        pal_fade(p, 3, to, n);
        p->fade_age[3] = (uint16_t)(k - 1);
        pal_step(p);
        for (int shift = 0; shift < 24; shift += 8) {
            int a = from >> shift & 255, b = to >> shift & 255, c = p->rgb[3] >> shift & 255;
            int off = 2 * (c - a) * n - 2 * (b - a) * k; /* in halves of 1/n */
            assert_true(b >= a ? off <= n && off > -n : off >= -n && off < n);
        }
    }
    rig_free(&r);
    rig_game_free(&g);
}

TEST(pal)
{
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL, "");
    rig_power(&r, &g, NULL);
    struct pal *p = &r.b->pal;
    const uint8_t *rom = cart_palette(&g.cart, "main");
    assert_int_equal(p->rgb[7], (uint32_t)rom[21] << 16 | (uint32_t)rom[22] << 8 | rom[23]);
    pal_set(p, 1, 0xff102030);
    assert_int_equal(p->rgb[1], 0x102030);
    pal_set(p, 2, 0x0000ff);
    pal_fade(p, 2, 0xff0000, 4);
    static const uint32_t fade[] = { 0x4000bf, 0x80007f, 0xbf0040, 0xff0000, 0xff0000 };
    for (int i = 0; i < 5; i++) {
        rig_run(&r, 1);
        assert_int_equal(p->rgb[2], fade[i]);
    }
    assert_int_equal(p->rgb[2], 0xff0000);
    pal_fade(p, 2, 0x123456, 0);
    assert_int_equal(p->rgb[2], 0x123456);
    pal_fade(p, 2, 0, 9);
    pal_set(p, 2, 0x777777); /* ends the fade */
    rig_run(&r, 3);
    assert_int_equal(p->rgb[2], 0x777777);

    for (int i = 0; i < 4; i++)
        pal_set(p, 10 + i, (uint32_t)i);
    assert_true(pal_cycle(p, 10, 13, 2));
    rig_run(&r, 1);
    assert_int_equal(p->rgb[10], 0);
    rig_run(&r, 1);
    assert_int_equal(p->rgb[10], 3);
    assert_int_equal(p->rgb[11], 0);
    rig_run(&r, 6);
    assert_int_equal(p->rgb[10], 0);
    assert_true(pal_cycle(p, 10, 13, 0));
    rig_run(&r, 4);
    assert_int_equal(p->rgb[10], 0);
    for (int i = 0; i < CYCLES; i++)
        assert_true(pal_cycle(p, (uint8_t)(20 + i), (uint8_t)(30 + i), 1));
    assert_false(pal_cycle(p, 100, 110, 1));
    assert_true(pal_cycle(p, 100, 110, 0)); /* nothing to stop */
    assert_true(pal_cycle(p, 21, 31, 7));   /* the same range again */
    pal_stop(p);
    assert_true(pal_cycle(p, 100, 110, 1));
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- nvram ---- */

/* A board with room for so many KiB. */
static void nvram_power(struct rig *r, struct rig_game *g, int32_t kib, const struct board_start *start)
{
    struct manifest m = rig_manifest();

    m.nvram_kib = kib;
    rig_script(g, &m, "");
    rig_power(r, g, start);
}

static void nvram_free(struct rig *r, struct rig_game *g)
{
    rig_free(r);
    rig_game_free(g);
}

static const uint8_t *nvram_image(const struct rig *r, size_t *size)
{
    uint32_t changed;
    const uint8_t *image = board_nvram(r->b, size, &changed);

    assert_true(nvram_is_valid(image, *size));
    return image;
}

static size_t nvram_size(const struct rig *r)
{
    size_t size;

    nvram_image(r, &size);
    return size;
}

static uint32_t nvram_changed(const struct rig *r)
{
    uint32_t changed;
    size_t size;

    board_nvram(r->b, &size, &changed);
    return changed;
}

/* Values of every type under keys of every length; what goes leaves no gap. */
TEST(nvram_saves)
{
    struct rig_game g;
    struct rig r;
    struct nv_value v = { .type = NV_INT, .bits = 42 };

    nvram_power(&r, &g, 1, NULL);
    struct nvram *nv = &r.b->nvram;
    assert_int_equal(nvram_size(&r), 4);
    assert_int_equal(nvram_get(nv, "k").type, NV_NONE);
    assert_true(nvram_set(nv, "k", &v));
    assert_int_equal(r.b->nvram.s.live, nvram_size(&r)); /* what snapshots and hashes have */
    assert_int_equal(nvram_get(nv, "k").bits, 42);
    assert_int_equal(nvram_size(&r), 4 + 3 + 1 + 8);
    v = (struct nv_value){ .type = NV_TEXT, .text = "a\0b", .length = 3 };
    assert_true(nvram_set(nv, "other", &v));
    assert_true(nvram_set(nv, "k", &v));
    assert_int_equal(nvram_get(nv, "k").length, 3);
    assert_memory_equal(nvram_get(nv, "k").text, "a\0b", 3);
    assert_memory_equal(nvram_get(nv, "other").text, "a\0b", 3);
    assert_int_equal(nvram_size(&r), 4 + 3 + 1 + 3 + 3 + 5 + 3);
    assert_int_equal(nvram_changed(&r), 3);
    v = (struct nv_value){ .type = NV_BOOL, .bits = 1 };
    assert_true(nvram_set(nv, "k", &v) && nvram_get(nv, "k").type == NV_BOOL && nvram_get(nv, "k").bits == 1);
    v = (struct nv_value){ .type = NV_FLOAT, .bits = 0x3ff8000000000000u };
    assert_true(nvram_set(nv, "1234567890123456789012345678901", &v));
    assert_true(nvram_get(nv, "1234567890123456789012345678901").bits == v.bits);
    assert_int_equal(nvram_get(nv, "123456789012345678901234567890").type, NV_NONE);
    v.type = NV_NONE;
    assert_true(nvram_set(nv, "k", &v) && nvram_set(nv, "k", &v) && nvram_set(nv, "other", &v));
    assert_int_equal(nvram_get(nv, "other").type, NV_NONE);
    assert_true(nvram_set(nv, "1234567890123456789012345678901", &v));
    assert_int_equal(nvram_size(&r), 4);
    nvram_free(&r, &g);
}

/* Best first, equals behind those before, ten rows. */
static int enter(struct nvram *nv, const char *table, const char *name, int64_t score)
{
    struct nv_row row = { .score = score };

    snprintf(row.name, sizeof row.name, "%s", name);
    return nvram_enter_row(nv, table, &row);
}

static bool best_row(const struct nvram *nv, const char *table, int r, char name[NV_MAX_NAME + 1], int64_t *score)
{
    struct nv_row rows[NV_MAX_ROWS];

    if (r >= NV_MAX_ROWS || r >= nvram_get_rows(nv, table, NULL, rows))
        return false;
    memcpy(name, rows[r].name, NV_MAX_NAME + 1);
    *score = rows[r].score;
    return true;
}

TEST(nvram_tables)
{
    static const int64_t scores[] = { 50, 70, 50, -3, 900, 70, 60, 10, 20, 30 };
    static const int rows[] = { 0, 0, 2, 3, 0, 2, 3, 6, 6, 6 };
    struct nv_value v = { .type = NV_INT, .bits = 1 };
    struct rig_game g;
    struct rig r;
    char name[NV_MAX_NAME + 1];
    int64_t score;

    nvram_power(&r, &g, 1, NULL);
    struct nvram *nv = &r.b->nvram;
    assert_true(nvram_set(nv, "t", &v)); /* a key of the same name is another thing */
    for (int i = 0; i < NV_MAX_ROWS; i++) {
        snprintf(name, sizeof name, "n%d", i);
        assert_int_equal(enter(nv, "t", name, scores[i]), rows[i]);
        assert_int_equal(nvram_size(&r), 4 + 12 + 4 + 24 * (i + 1));
    }
    const uint32_t changed = nvram_changed(&r);
    assert_int_equal(enter(nv, "t", "low", -3), -1);
    v.type = NV_NONE;
    assert_true(nvram_set(nv, "of nobody", &v));
    assert_int_equal(nvram_changed(&r), changed); /* nothing was */
    assert_int_equal(enter(nv, "t", "fifteen letters", 1), 9);
    assert_true(best_row(nv, "t", 9, name, &score));
    assert_string_equal(name, "fifteen letters");
    assert_int_equal(score, 1);
    assert_true(best_row(nv, "t", 0, name, &score));
    assert_int_equal(score, 900);
    assert_string_equal(name, "n4");
    assert_false(best_row(nv, "t", 10, name, &score));
    assert_false(best_row(nv, "u", 0, name, &score));
    assert_int_equal(nvram_get(nv, "t").bits, 1);
    nvram_free(&r, &g);
}

/* Each ship has ten rows of its own, under its own name; the table shows the best of all. How far a score went is kept
 * with it, in the bytes that a row had before. */
TEST(nvram_ships)
{
    struct nv_row row = { .ship = "crow", .stage = 3, .continues = 2 }, rows[NV_MAX_ROWS];
    struct rig_game g;
    struct rig r;

    nvram_power(&r, &g, 1, NULL);
    struct nvram *nv = &r.b->nvram;
    assert_int_equal(enter(nv, "t", "alone", 55), 0);
    for (int i = 0; i < NV_MAX_ROWS; i++) {
        row.score = 10 * i;
        assert_int_equal(nvram_enter_row(nv, "t", &row), 0);
    }
    assert_int_equal(nvram_size(&r), 4 + 4 + 24 + (3 + 6) + 24 * NV_MAX_ROWS);
    strcpy(row.ship, "heron");
    row.score = 60, row.stage = NV_STAGE_CLEARED, row.continues = NV_MAX_CONTINUES;
    assert_int_equal(nvram_enter_row(nv, "t", &row), 0);
    assert_int_equal(nvram_get_rows(nv, "t", "crow", rows), NV_MAX_ROWS);
    assert_true(rows[0].score == 90 && rows[9].score == 0 && rows[0].stage == 3 && rows[0].continues == 2);
    assert_int_equal(nvram_get_rows(nv, "t", "heron", rows), 1);
    assert_true(rows[0].stage == NV_STAGE_CLEARED && rows[0].continues == NV_MAX_CONTINUES);
    assert_int_equal(nvram_get_rows(nv, "t", "her", rows), 0);
    assert_int_equal(nvram_get_rows(nv, "t", "", rows), 1);
    assert_int_equal(nvram_get_rows(nv, "t\ncrow", NULL, rows), NV_MAX_ROWS); /* its name in the image */
    assert_int_equal(nvram_get_rows(nv, "t", NULL, rows), NV_MAX_ROWS);
    assert_true(rows[3].score == 60 && !strcmp(rows[3].ship, "crow")); /* of equals, who came first */
    assert_true(rows[4].score == 60 && !strcmp(rows[4].ship, "heron"));
    assert_true(rows[5].score == 55 && !rows[5].ship[0] && !rows[5].stage && !strcmp(rows[5].name, "alone"));
    assert_int_equal(rows[9].score, 20);
    assert_true(nvram_is_valid(nvram_image(&r, &(size_t){ 0 }), nvram_size(&r)));
    nvram_free(&r, &g);
}

/* As many small records as the manifest has room for; then nothing more fits, and nothing is lost. */
TEST(nvram_full)
{
    static const int32_t sizes[] = { 1, 32, 256 };
    struct rig_game g;
    struct rig r;
    char key[NV_MAX_KEY + 1], name[NV_MAX_NAME + 1];
    int64_t score;

    for (int k = 0; k < 3; k++) {
        struct nv_value v = { .type = NV_INT };
        int tables = sizes[k] == 1 ? 2 : 40, n = 0;
        nvram_power(&r, &g, sizes[k], NULL);
        struct nvram *nv = &r.b->nvram;
        for (int t = 0; t < tables; t++) {
            snprintf(key, sizeof key, "table %d", t);
            for (int i = 0; i < NV_MAX_ROWS; i++)
                assert_int_equal(enter(nv, key, "me", 1000 * t + i), 0);
        }
        do
            v.bits = (uint64_t)n * 7, snprintf(key, sizeof key, "boss/spell %d", n);
        while (nvram_set(nv, key, &v) && ++n);
        print_message("# %d KiB: %d tables of ten rows, and %d records\n", (int)sizes[k], tables, n);
        assert_true(n > (sizes[k] - 1) * 1024 / 26 - tables * 252 / 26);
        assert_int_equal(nvram_get(nv, key).type, NV_NONE);
        assert_true(nvram_size(&r) + 3 + strlen(key) + 8 > (size_t)sizes[k] * 1024);
        uint32_t changed = nvram_changed(&r);
        assert_int_equal(enter(nv, "one table more", "me", 1), -2);
        assert_int_equal(nvram_changed(&r), changed);
        assert_int_equal(enter(nv, "table 1", "you", 5000000), 0); /* in place of the last */
        v = (struct nv_value){ .type = NV_TEXT, .length = NV_MAX_STRING };
        changed = nvram_changed(&r);
        assert_false(nvram_set(nv, "boss/spell 3", &v)); /* a longer one */
        assert_int_equal(nvram_changed(&r), changed);
        for (int i = 0; i < n; i++) {
            snprintf(key, sizeof key, "boss/spell %d", i);
            assert_int_equal(nvram_get(nv, key).bits, 7 * i);
        }
        assert_true(best_row(nv, "table 1", 1, name, &score) && score == 1009);
        nvram_free(&r, &g);
    }
}

/* The image is the whole of it; a damaged one is blank; of one for which there is no room comes what fits. */
TEST(nvram_image)
{
    static uint8_t image[64 << 10];
    struct board_start start = { .difficulty = -1, .nvram = image };
    struct nv_value v = { .type = NV_TEXT, .text = "text", .length = 4 };
    struct rig_game g;
    struct rig r;
    char key[NV_MAX_KEY + 1];
    size_t size;

    nvram_power(&r, &g, 64, NULL);
    for (int i = 0; i < 900; i++) {
        snprintf(key, sizeof key, "%d", i);
        assert_true(nvram_set(&r.b->nvram, key, &v));
    }
    assert_int_equal(enter(&r.b->nvram, "t", "me", 5), 0);
    memcpy(image, nvram_image(&r, &start.nvram_size), nvram_size(&r));
    nvram_free(&r, &g);
    nvram_power(&r, &g, 64, &start);
    assert_int_equal(nvram_size(&r), start.nvram_size);
    assert_memory_equal(nvram_image(&r, &size), image, start.nvram_size);
    assert_int_equal(nvram_changed(&r), 0);
    nvram_free(&r, &g);
    nvram_power(&r, &g, 1, &start);
    assert_true(nvram_size(&r) <= 1024 && nvram_size(&r) > 1024 - 11);
    assert_memory_equal(nvram_image(&r, &size), image, nvram_size(&r));
    nvram_free(&r, &g);
    static const struct {
        size_t at;
        uint8_t is;
    } lies[] = { { 0, 'X' }, { 3, '3' }, { 4, 0 },  { 4, 6 },  { 4, 1 },
                 { 4, 4 },   { 4, 5 },   { 5, 32 }, { 6, 61 }, { 6, 5 } };
    for (size_t i = 0; i < sizeof lies / sizeof *lies; i++) {
        uint8_t was = image[lies[i].at];
        image[lies[i].at] = lies[i].is;
        nvram_power(&r, &g, 64, &start);
        assert_int_equal(nvram_size(&r), 4);
        nvram_free(&r, &g);
        image[lies[i].at] = was;
    }
    start.nvram_size--;
    nvram_power(&r, &g, 64, &start);
    assert_int_equal(nvram_size(&r), 4);
    nvram_free(&r, &g);
}

/* nvram-1.nv was saved by a program of core version 4, full: 256 keys, 16 tables. All of it is there, and as much of
 * it comes into less room as fits. */
TEST(nvram_old)
{
    static uint8_t image[NV_OLD_IMAGE_SIZE];
    struct board_start start = { .difficulty = -1, .nvram = image, .nvram_size = sizeof image };
    struct rig_game g;
    struct rig r;
    FILE *f = fopen("tests/machine/nvram-1.nv", "rb");

    assert_true(f && fread(image, 1, sizeof image, f) == sizeof image && fgetc(f) == EOF && !fclose(f));
    assert_true(nvram_is_valid(image, sizeof image));
    nvram_power(&r, &g, NV_DEFAULT_KIB, &start);
    for (int i = 0; i < 256; i++) { /* as the script that kept them did */
        char key[64];
        int n = snprintf(key, sizeof key, "key %d ", i);
        for (; n < 31; n++)
            key[n] = 'k';
        key[7 + i % 25] = 0;
        struct nv_value v = nvram_get(&r.b->nvram, key);
        double d = i / 8.0;
        if (i % 4 == 0)
            assert_true(v.type == NV_INT && (int64_t)v.bits == (int64_t)i * i - 300);
        else if (i % 4 == 1)
            assert_true(v.type == NV_TEXT && v.length == (size_t)i % 61 && strspn(v.text, "v") >= v.length);
        else if (i % 4 == 2)
            assert_true(v.type == NV_FLOAT && !memcmp(&d, &v.bits, sizeof d));
        else
            assert_true(v.type == NV_BOOL && v.bits == (i % 8 == 3));
    }
    for (int t = 0; t < 16; t++)
        for (int row = 0; row < NV_MAX_ROWS; row++) {
            char table[32], name[NV_MAX_NAME + 1], want[32];
            int64_t score;
            snprintf(table, sizeof table, "table %d", t);
            snprintf(want, sizeof want, "row %d", row);
            bool there = t >= 10 || row <= t; /* the script's loop counted from 0 */
            assert_int_equal(best_row(&r.b->nvram, table, row, name, &score), there);
            if (there)
                assert_string_equal(name, want);
            if (there)
                assert_true(score == t * INT64_C(1000000007) - row * 5);
        }
    size_t whole = nvram_size(&r);
    nvram_free(&r, &g);
    nvram_power(&r, &g, 4, &start);
    assert_true(nvram_size(&r) < whole && nvram_size(&r) > 3000 && nvram_get(&r.b->nvram, "key 0 k").type == NV_INT);
    nvram_free(&r, &g);
    static const int at[] = { 0, 4 + 31, 4 + 32, 4 + 33, 4 + 256 * 96 + 31, 4 + 256 * 96 + 32 + 15 };
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) { /* a key without an end, a type that is none ... */
        image[at[i]] ^= 0x7f;
        nvram_power(&r, &g, NV_DEFAULT_KIB, &start);
        assert_int_equal(nvram_size(&r), 4);
        nvram_free(&r, &g);
        image[at[i]] ^= 0x7f;
    }
}

/* A full list has kept every event as it was, in memory of no more than it asks for. */
TEST(events)
{
    enum { FULL = 100, FENCE = 0xa5 };
    struct events e;
    uint64_t size = events_size(FULL);
    uint8_t *memory = malloc(size + 64);

    assert_non_null(memory);
    memset(memory, FENCE, size + 64);
    events_init(&e, FULL, memory);
    assert_int_equal(e.n, 0);
    for (int i = 0; i < FULL; i++)
        assert_true(events_push(&e, (enum event_kind)(i % 10), INT64_MIN + i, INT64_MAX - i));
    assert_false(events_push(&e, EV_HIT, 1, 2));
    assert_int_equal(e.n, FULL);
    for (int i = 0; i < FULL; i++) {
        const struct event at = events_at(&e, (uint32_t)i);
        assert_true(at.kind == (uint32_t)(i % 10) && at.a == INT64_MIN + i && at.b == INT64_MAX - i);
    }
    for (int i = 0; i < 64; i++)
        assert_int_equal(memory[size + (uint64_t)i], FENCE);
    free(memory);
}

RUN_TESTS(NULL, NULL)

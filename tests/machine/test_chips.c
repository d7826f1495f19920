/*
 * test_chips.c - each chip by itself, with exact numbers: slots, input, bullets, enemies' moves, players, sparks, text,
 * palette, nvram, events.
 */
#include "../unit/big.h"
#include "rig.h"

static struct rig_game g;
static struct rig r;

static int end(void **state __attribute__((unused)))
{
    rig_close(&r);
    return 0;
}

static void power(const char *script)
{
    rig_with_sys(&g, NULL, script);
    rig_power(&r, &g, NULL);
}

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
        assert_int_equal(slots_next(&t.s, at), t.s.top);
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
    const struct input *in;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    power("");
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
}

/* ---- bullets ---- */

/* The edges of the keep box belong to it. */
TEST(keep_box)
{
    struct bullet_spec s = { .speed = 0 };

    power("");
    struct bullets *b = &r.b->bullets;
    const struct manifest *m = &r.b->cart.manifest;
    const fx x0 = px(-m->margin), y0 = x0, x1 = px(m->field_w + m->margin), y1 = px(m->field_h + m->margin);
    const struct {
        fx x, y;
        bool in;
    } at[] = { { x0, y0, true },         { x1, y1, true },         { x0 - 1, px(9), false },
               { x1 + 1, px(9), false }, { px(9), y0 - 1, false }, { px(9), y1 + 1, false } };
    for (int i = 0; i < 6; i++) {
        s.x = at[i].x;
        s.y = at[i].y;
        assert_int_equal(bullets_fire(b, &s, 0), 0);
        rig_run(&r, 1);
        assert_int_equal(b->s.live_bits[0] & 1, at[i].in);
        if (at[i].in)
            bullets_drop(b, 0);
    }
}

TEST(velocity)
{
    struct bullet_spec s = { .x = px(100), .y = px(50), .speed = px(-1.5), .dir = 0x40000000 };

    power("");
    struct bullets *b = &r.b->bullets;
    bullets_fire(b, &s, 0);
    rig_run(&r, 4);
    assert_int_equal(b->x[0], px(100));
    assert_int_equal(b->y[0], px(44));
    bullets_set_velocity(b, 0, (int64_t)3 << 32, -((int64_t)4 << 32));
    assert_int_equal(b->speed[0], px(5));
    assert_int_equal(b->dir[0], trig_atan2(px(-4), px(3)));
    ang dir = b->dir[0];
    bullets_set_velocity(b, 0, 0, 0);
    assert_int_equal(b->dir[0], dir); /* a bullet that stands keeps its direction */
    assert_int_equal(b->speed[0], 0);
}

/* ---- enemies ---- */

/* A move of up to MAX_SPEED in a frame is a path, along which the enemy hits; beyond it, on either axis, a jump. */
TEST(enemy_jumps)
{
    static const struct {
        fx dx, dy;
        bool jump;
    } moves[] = {
        { MAX_SPEED << 16, -(MAX_SPEED << 16), false },
        { (MAX_SPEED << 16) + 1, 0, true },
        { -(MAX_SPEED << 16) - 1, 0, true },
        { 0, (MAX_SPEED << 16) + 1, true },
        { 0, -(MAX_SPEED << 16) - 1, true },
    };
    const struct box world = { FX_MIN, FX_MIN, FX_MAX, FX_MAX };

    power("enemy.def('foe', { sprite = 'dot', hit = 'none' })");
    struct enemies *e = &r.b->enemies;
    for (int k = 0; k < 5; k++) {
        uint32_t i = (uint32_t)enemies_spawn(e, &r.b->enemy_kinds, 0, -px(3), px(5), 0);
        enemies_move_to(e, i, -px(3) + moves[k].dx, px(5) + moves[k].dy, 1, EASE_LINEAR);
        enemies_move(e, &world, NULL);
        assert_int_equal(e->prev_x[i], moves[k].jump ? e->x[i] : -px(3));
        assert_int_equal(e->prev_y[i], moves[k].jump ? e->y[i] : px(5));
        enemies_move(e, &world, NULL);
        assert_true(e->prev_x[i] == e->x[i] && e->prev_y[i] == e->y[i]);
    }
}

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
    struct rng rng;

    power("enemy.def('foe', { sprite = 'dot', hit = 'none' })");
    struct enemies *e = &r.b->enemies;
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
}

/* The last tenants of slots, whose handles must stay dead; and the last game of a player. */
TEST(last_generations)
{
    static const char text[] = "bullet.def('dot', { sprite = 'dot', hit = 'none' })\n"
                               "enemy.def('foe', { sprite = 'dot', hit = 'none' })\n"
                               "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
                               "local sys = string.sys\n"
                               "local function make()\n"
                               "  return { bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 }, enemy.spawn { kind = "
                               "'foe', x = 9, y = 9 } }\n"
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

    power(text);
    rig_run(&r, 1);
    struct slots *pools[] = { &r.b->bullets.s, &r.b->enemies.s, &r.b->tasks.s };
    int32_t slot[3];
    for (int i = 0; i < 3; i++) { /* the slot that comes next */
        slot[i] = slots_take(pools[i]);
        slots_drop(pools[i], (uint32_t)slot[i]);
        slots_trim(pools[i]); /* who takes it next parks the others */
        pools[i]->gen[slot[i]] = RETIRED_GENERATION - 1;
    }
    r.b->player.gen[0] = RETIRED_GENERATION - 1;
    rig_run(&r, 1);
    board_tick(r.b, none);
    assert_non_null(rig_fault(&r));
    assert_string_equal(rig_fault(&r)->message, "main.lua:22: player 1 has joined 1073741822 games; restart the board");
    for (int i = 0; i < 3; i++) {
        assert_int_equal(pools[i]->gen[slot[i]], RETIRED_GENERATION);
        assert_false(slots_has(pools[i], (uint32_t)slot[i], RETIRED_GENERATION));
    }
}

/* ---- players ---- */

TEST(player)
{
    static const uint16_t right[MAX_PLAYERS] = { PAD_RIGHT }, up_left[MAX_PLAYERS] = { PAD_UP | PAD_LEFT },
                          slow[MAX_PLAYERS] = { PAD_DOWN | PAD_FOCUS };

    power("player.def('a', { sprite = 'dot', hit = { circle = 2 }, speed = 4, focus = 1.5, lives = 3 })\n"
          "player.def('b', { sprite = 'dot', hit = { circle = 2 }, registers = { zeal = 7, bombs = 2 } })\n"
          "string.sys.join(1, 'a')");
    struct player *p = &r.b->player;
    fx x = px(r.b->cart.manifest.field_w / 2.0), y = px(r.b->cart.manifest.field_h * 7 / 8.0);
    assert_int_equal(p->x[0], x);
    assert_int_equal(p->y[0], y);
    assert_int_equal(p->lives[0], 2);
    assert_int_equal(p->x[1], PARK_COORDINATE);
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
    assert_true(p->x[0] == px(8) && p->y[0] == px(8) && p->prev_x[0] == px(8));
    player_join(p, &r.b->player_kinds, 1, 1, px(20), px(30));
    assert_int_equal(board_get_register(r.b, 1, 0), 2); /* in the order of their names */
    assert_int_equal(board_get_register(r.b, 1, 1), 7);
    assert_int_equal(p->safe_left[1], 120);
}

/* ---- sparks ---- */

TEST(sparks)
{
    struct spark_burst one = { .x = px(50), .y = px(60), .n = 1 };
    struct spark_burst many = {
        .x = px(50), .y = px(60), .n = 60, .speed = px(4), .dir = 0x40000000, .spread = 0x20000000
    };
    int32_t least = INT32_MAX, largest = INT32_MIN;

    power("spark.def('a', { sprite = 'dot', life = 5, gravity = 0.5, drag = 0.25 })\n"
          "spark.def('b', { sprite = 'dot', life = 9 })");
    struct sparks *s = &r.b->sparks;
    many.kind = (uint16_t)(r.b->spark_kinds.s.live - 1); /* the library declares some, too */
    one.kind = (uint16_t)(many.kind - 1);
    sparks_burst(s, &one);
    s->vx[0] = px(8);
    s->vy[0] = px(-4);
    rig_run(&r, 2);
    assert_int_equal(s->vx[0], px(4.5));
    assert_int_equal(s->vy[0], px(-1.375));
    assert_int_equal(s->x[0], px(60.5));
    assert_int_equal(s->y[0], px(56.125));
    rig_run(&r, 2);
    assert_int_equal(s->s.live, 1);
    rig_run(&r, 1);
    assert_int_equal(s->s.live, 0);
    one.x = px(-r.b->cart.manifest.margin); /* the edge of the keep box */
    sparks_burst(s, &one);
    s->vx[0] = -1;
    rig_run(&r, 1);
    assert_int_equal(s->s.live, 0);

    /* directions within the spread, speeds from half to all of it */
    sparks_burst(s, &many);
    for (int i = 0; i < 60; i++) {
        int32_t off = trig_difference(many.dir, trig_atan2(s->vy[i], s->vx[i]));
        assert_in_range(fx_hypot(s->vx[i], s->vy[i]), px(2) - 2, px(4) + 2);
        least = off < least ? off : least;
        largest = off > largest ? off : largest;
    }
    assert_true(least >= -0x10000000 - 40000 && least < -0x0c000000);
    assert_true(largest <= 0x10000000 + 40000 && largest > 0x0c000000);
    many.n = 1000;
    sparks_burst(s, &many);
    assert_int_equal(s->s.live, s->s.cap);
    assert_int_equal(s->s.refused, 1);
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

    m.screen_w = 80;
    m.screen_h = 76; /* 9 rows and a half */
    m.field_w = 80;
    m.field_h = 76;
    rig_script(&g, &m, "");
    rig_power(&r, &g, NULL);
    struct fix *f = &r.b->fix;
    assert_int_equal(f->cols, 10);
    assert_int_equal(f->rows, 9);
    fix_write(f, -16, 16, "abcd", 4, 1, 8, 5, 0);
    row_is(f, 2, "cd");
    assert_int_equal(f->style[20], 5);
    fix_write(f, 64, 24, "abcd", 4, 1, 8, 1, 0);
    row_is(f, 3, "........ab");
    fix_write(f, 0, -8, "x", 1, 1, 8, 1, 0);
    fix_write(f, 0, 72, "x", 1, 1, 8, 1, 0);
    fix_write(f, INT32_MAX, 0, "xyz", 3, 1, 8, 1, 0);
    fix_write(f, INT32_MIN, 0, "xyz", 3, 1, 8, 1, 0);
    row_is(f, 0, "");
    row_is(f, 8, "");
    /* characters, not bytes; what no cell can hold; a byte that is no UTF-8 */
    fix_write(f, 8, 32, "\xc3\xa9\xe5\xbc\xbe\xf0\x9f\x98\x80\x89z", 11, 1, 8, 2, 0);
    assert_memory_equal(f->code + 40, "\0\xe9\1\1\x89z\0", 7);
    assert_memory_equal(f->style + 40, ((uint16_t[]){ 0, 2, 2, 2, 2, 2, 0 }), 14);
    fix_clear(f, 0, 4, 10, 1);
    row_is(f, 4, "");
    /* larger letters: a part in each cell */
    fix_write(f, 64, 32, "ab", 2, 2, 8, 3 | FIX_RIM, 0);
    row_is(f, 4, "........aa");
    row_is(f, 5, "........aa");
    const uint16_t look = 3 | FIX_RIM;
    const uint16_t quarters[] = { look | FIX_DOUBLE, look | 2 * FIX_DOUBLE, look | 3 * FIX_DOUBLE,
                                  look | 4 * FIX_DOUBLE };
    assert_memory_equal(f->style + 48, quarters, 4);
    assert_memory_equal(f->style + 58, quarters + 2, 4);
    fix_write(f, 8, 48, "c", 1, 3, 8, 3, 0);
    row_is(f, 8, ".ccc");
    assert_int_equal(f->style[61], 3 | FIX_TRIPLE);
    assert_int_equal(f->style[83], 3 | (FIX_TRIPLE + (8 << 5)));
    /* at any px: in the cell of its corner, shifted from there */
    fix_write(f, 8 + 3, 0 + 7, "d", 1, 1, 8, 3, 0);
    row_is(f, 0, ".d");
    assert_int_equal(fix_x(f, 1), 11);
    assert_int_equal(fix_y(f, 1), 7);
    fix_write(f, -3, 0, "ef", 2, 1, 8, 3, 0);
    row_is(f, 0, "fd");
    assert_int_equal(fix_x(f, 0), 5);
    fix_clear(f, 0, 0, 10, 1);
    /* full-width letters, 12 px each: the cell between two is cleared */
    fix_write(f, 0, 0, "abcdefgh", 8, 1, 8, 1, 0);
    fix_write(f, 4, 0, "\xe5\xbc\xbe\xe5\xb9\x95z", 7, 1, 12, 1, 0);
    assert_memory_equal(f->code, "\1\0\1zefgh", 8);
    assert_int_equal(f->style[0], 1 | 4 * FIX_SHIFT_X | FIX_FULL_WIDTH);
    assert_int_equal(f->style[2], 1 | FIX_FULL_WIDTH);
    assert_int_equal(f->style[3], 1 | 4 * FIX_SHIFT_X);
    fix_write(f, 0, 0, "\xe5\xbc\xbe\xe5\xb9\x95z", 7, 1, 16, 1, 0);
    assert_memory_equal(f->code, "\1\0\1\0zfgh", 8);
    fix_write(f, 0, 0, "\xe5\xbc\xbe\xe5\xb9\x95z", 7, 2, 16, 1, 0); /* not those of size 2 */
    assert_memory_equal(f->code, "\1\1\1\1zzgh", 8);
    assert_int_equal(f->style[0], 1 | FIX_DOUBLE);
    assert_int_equal(fix_text_width("\xe5\xbc\xbe\xe5\xb9\x95z", 7, 12), 32);
    fix_clear(f, 0, 0, 10, 2);
    fix_clear(f, -5, 3, 14, 1);
    row_is(f, 3, ".........b");
    fix_clear(f, INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX);
    row_is(f, 3, ".........b");
    fix_clear(f, -1000, -1000, INT32_MAX, INT32_MAX);
    row_is(f, 3, "");
}

/* ---- palette ---- */

/* After k of n frames |2 (rgb - from) n - 2 (to - from) k| <= n, and where it is n the colour is the one nearer to
 * `to`. */
TEST(fades)
{
    struct rng rng;

    power("");
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
}

TEST(palette)
{
    power("");
    struct pal *p = &r.b->pal;
    const uint8_t *rom = cart_palette(&g.cart, "main");
    assert_int_equal(p->rgb[7], (uint32_t)rom[21] << 16 | (uint32_t)rom[22] << 8 | rom[23]);
    pal_fade(p, 2, 0x123456, 0);
    assert_int_equal(p->rgb[2], 0x123456);
    pal_fade(p, 2, 0, 9);
    pal_set(p, 2, 0xff777777); /* ends the fade */
    rig_run(&r, 3);
    assert_int_equal(p->rgb[2], 0x777777);
}

TEST(palette_cycles)
{
    power("");
    struct pal *p = &r.b->pal;
    for (uint8_t i = 0; i < 4; i++)
        pal_set(p, 10 + i, i);
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
    for (uint8_t i = 0; i < CYCLES; i++)
        assert_true(pal_cycle(p, 20 + i, 30 + i, 1));
    assert_false(pal_cycle(p, 100, 110, 1));
    assert_true(pal_cycle(p, 21, 31, 7)); /* the same range again */
    pal_stop(p);
    assert_true(pal_cycle(p, 100, 110, 1));
}

/* ---- nvram ---- */

/* A board with that many KiB. */
static struct nvram *nvram_power(int32_t kib, const struct board_start *start)
{
    struct manifest m = rig_manifest();

    end(NULL);
    m.nvram_kib = kib;
    rig_script(&g, &m, "");
    rig_power(&r, &g, start);
    return &r.b->nvram;
}

static const uint8_t *nvram_image(size_t *size, uint32_t *changed)
{
    const uint8_t *image = board_nvram(r.b, size, changed);

    assert_true(nvram_is_valid(image, *size));
    return image;
}

static size_t nvram_size(void)
{
    uint32_t changed;
    size_t size;

    nvram_image(&size, &changed);
    return size;
}

static uint32_t nvram_changed(void)
{
    uint32_t changed;
    size_t size;

    nvram_image(&size, &changed);
    return changed;
}

/* Values of every type; removed ones leave no gap. */
TEST(nvram_saves)
{
    static const struct nv_value values[] = {
        { .type = NV_INT, .bits = 42 },
        { .type = NV_TEXT, .text = "a\0b", .length = 3 },
        { .type = NV_BOOL, .bits = 1 },
        { .type = NV_FLOAT, .bits = 0x3ff8000000000000u },
    };
    static const char longest[] = "1234567890123456789012345678901";
    const struct nv_value none = { .type = NV_NONE };
    struct nvram *nv = nvram_power(1, NULL);

    assert_int_equal(nvram_size(), 4);
    assert_true(nvram_set(nv, longest, &values[1]));
    for (int i = 0; i < 4; i++) {
        assert_true(nvram_set(nv, "k", &values[i]));
        const struct nv_value v = nvram_get(nv, "k");
        assert_true(v.type == values[i].type && v.bits == values[i].bits && v.length == values[i].length);
        assert_memory_equal(nvram_get(nv, longest).text, "a\0b", 3);
    }
    assert_int_equal(nvram_changed(), 5);
    assert_int_equal(nvram_size(), 4 + 3 + 31 + 3 + 3 + 1 + 8);
    assert_int_equal(r.b->nvram.s.live, nvram_size()); /* what snapshots and hashes have */
    assert_int_equal(nvram_get(nv, "123456789012345678901234567890").type, NV_NONE);
    assert_true(nvram_set(nv, longest, &none) && nvram_set(nv, "k", &none));
    assert_int_equal(nvram_get(nv, "k").type, NV_NONE);
    assert_int_equal(nvram_size(), 4);
    assert_true(nvram_set(nv, "k", &none)); /* nothing to remove */
    assert_int_equal(nvram_changed(), 7);
}

static int enter(struct nvram *nv, const char *table, const char *name, int64_t score)
{
    struct nv_row row = { .score = score };

    snprintf(row.name, sizeof row.name, "%s", name);
    return nvram_enter_row(nv, table, &row);
}

/* Ten rows, the best first, equal scores in the order in which they came. */
TEST(nvram_tables)
{
    static const int64_t scores[] = { 50, 70, 50, -3, 900, 70, 60, 10, 20, 30 };
    static const int places[] = { 0, 0, 2, 3, 0, 2, 3, 6, 6, 6 };
    const struct nv_value v = { .type = NV_INT, .bits = 1 };
    struct nv_row rows[NV_MAX_ROWS];
    struct nvram *nv = nvram_power(1, NULL);

    assert_true(nvram_set(nv, "t", &v)); /* a key of the same name is another thing */
    for (int i = 0; i < NV_MAX_ROWS; i++) {
        assert_int_equal(enter(nv, "t", i == 4 ? "fifteen letters" : "n", scores[i]), places[i]);
        assert_int_equal(nvram_size(), 4 + 12 + 4 + 24 * (i + 1));
    }
    const uint32_t changed = nvram_changed();
    assert_int_equal(enter(nv, "t", "low", -3), -1);
    assert_int_equal(nvram_changed(), changed);
    assert_int_equal(enter(nv, "t", "last", 1), 9);
    assert_int_equal(nvram_get_rows(nv, "t", NULL, rows), NV_MAX_ROWS);
    assert_true(rows[0].score == 900 && !strcmp(rows[0].name, "fifteen letters"));
    assert_true(rows[9].score == 1 && !strcmp(rows[9].name, "last"));
    assert_int_equal(nvram_get_rows(nv, "u", NULL, rows), 0);
    assert_int_equal(nvram_get(nv, "t").bits, 1);
}

/* Each ship has ten rows under its own name; the table shows the best of all. */
TEST(nvram_ships)
{
    struct nv_row row = { .ship = "crow", .stage = 3, .continues = 2 }, rows[NV_MAX_ROWS];
    struct nvram *nv = nvram_power(1, NULL);

    assert_int_equal(enter(nv, "t", "alone", 55), 0);
    for (int i = 0; i < NV_MAX_ROWS; i++) {
        row.score = 10 * i;
        assert_int_equal(nvram_enter_row(nv, "t", &row), 0);
    }
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
}

/* When nothing more fits, nothing is lost. */
TEST(nvram_full)
{
    static const int32_t sizes[] = { 1, 256 };
    char key[NV_MAX_KEY + 1];

    for (int k = 0; k < 2; k++) {
        struct nv_value v = { .type = NV_INT };
        struct nvram *nv = nvram_power(sizes[k], NULL);
        uint64_t n = 0;
        for (int i = 0; i < NV_MAX_ROWS; i++)
            assert_int_equal(enter(nv, "table", "me", i), 0);
        do {
            v.bits = n * 7;
            snprintf(key, sizeof key, "boss/spell %d", (int)n);
        } while (nvram_set(nv, key, &v) && ++n);
        assert_int_equal(nvram_get(nv, key).type, NV_NONE);
        assert_true(nvram_size() + 3 + strlen(key) + 8 > (size_t)sizes[k] * 1024);
        const uint32_t changed = nvram_changed();
        assert_int_equal(enter(nv, "another table", "me", 1), -2);
        v = (struct nv_value){ .type = NV_TEXT, .length = NV_MAX_STRING };
        assert_false(nvram_set(nv, "boss/spell 3", &v)); /* a longer one */
        assert_int_equal(nvram_changed(), changed);
        assert_int_equal(enter(nv, "table", "you", 5000000), 0); /* in place of the last */
        for (uint64_t i = 0; i < n; i++) {
            snprintf(key, sizeof key, "boss/spell %d", (int)i);
            assert_int_equal(nvram_get(nv, key).bits, 7 * i);
        }
    }
}

/* A damaged image is blank; of one that is too large the first records that fit are taken. */
TEST(nvram_image)
{
    static const struct {
        size_t at;
        uint8_t is;
    } lies[] = { { 0, 'X' }, { 4, 0 }, { 4, 6 }, { 4, 1 }, { 4, 4 }, { 4, 5 }, { 5, 32 }, { 6, 61 }, { 6, 5 } };
    static uint8_t image[64 << 10];
    const struct nv_value v = { .type = NV_TEXT, .text = "text", .length = 4 };
    struct board_start start = { .difficulty = -1, .nvram = image };
    struct nvram *nv = nvram_power(64, NULL);
    uint32_t changed;
    size_t size;
    char key[NV_MAX_KEY + 1];

    for (int i = 0; i < 900; i++) {
        snprintf(key, sizeof key, "%d", i);
        assert_true(nvram_set(nv, key, &v));
    }
    assert_int_equal(enter(nv, "t", "me", 5), 0);
    memcpy(image, nvram_image(&start.nvram_size, &changed), nvram_size());
    nvram_power(64, &start);
    const uint8_t *got = nvram_image(&size, &changed);
    assert_int_equal(size, start.nvram_size);
    assert_memory_equal(got, image, size);
    assert_int_equal(changed, 0);
    nvram_power(1, &start);
    got = nvram_image(&size, &changed);
    assert_memory_equal(got, image, size);
    assert_true(size <= 1024 && size > 1024 - 11);
    for (size_t i = 0; i < sizeof lies / sizeof *lies; i++) {
        uint8_t was = image[lies[i].at];
        image[lies[i].at] = lies[i].is;
        nvram_power(64, &start);
        assert_int_equal(nvram_size(), 4);
        image[lies[i].at] = was;
    }
    start.nvram_size--;
    nvram_power(64, &start);
    assert_int_equal(nvram_size(), 4);
}

/* nvram-1.nv was saved by a program of core version 4, full: 256 keys, 16 tables. All of it is there, and as much of
 * it comes into less room as fits. */
TEST(nvram_old)
{
    static uint8_t image[NV_OLD_IMAGE_SIZE];
    struct board_start start = { .difficulty = -1, .nvram = image, .nvram_size = sizeof image };
    FILE *f = fopen("tests/machine/nvram-1.nv", "rb");

    assert_true(f && fread(image, 1, sizeof image, f) == sizeof image && fgetc(f) == EOF && !fclose(f));
    assert_true(nvram_is_valid(image, sizeof image));
    struct nvram *nv = nvram_power(NV_DEFAULT_KIB, &start);
    for (int i = 0; i < 256; i++) { /* as the script that kept them did */
        char key[64];
        int n = snprintf(key, sizeof key, "key %d ", i);
        for (; n < 31; n++)
            key[n] = 'k';
        key[7 + i % 25] = 0;
        struct nv_value v = nvram_get(nv, key);
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
    for (int t = 0; t < 16; t++) {
        struct nv_row rows[NV_MAX_ROWS];
        char table[32], name[32];
        snprintf(table, sizeof table, "table %d", t);
        const int n = nvram_get_rows(nv, table, NULL, rows);
        assert_int_equal(n, t >= 10 ? NV_MAX_ROWS : t + 1);
        for (int row = 0; row < n; row++) {
            snprintf(name, sizeof name, "row %d", row);
            assert_string_equal(rows[row].name, name);
            assert_true(rows[row].score == t * INT64_C(1000000007) - row * 5);
        }
    }
    size_t whole = nvram_size();
    nv = nvram_power(4, &start);
    assert_true(nvram_size() < whole && nvram_size() > 3000 && nvram_get(nv, "key 0 k").type == NV_INT);
    static const int at[] = { 0, 4 + 31, 4 + 32, 4 + 33, 4 + 256 * 96 + 31, 4 + 256 * 96 + 32 + 15 };
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) { /* a key without an end, a type that is none ... */
        image[at[i]] ^= 0x7f;
        nvram_power(NV_DEFAULT_KIB, &start);
        assert_int_equal(nvram_size(), 4);
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

RUN_TESTS_EACH(NULL, end)

/*
 * test_items.c - items: how they fall against a closed form, how they fly to a player, who takes which against plain
 * arithmetic in 128 bits. tests/scripts/items.lua has what they give and where they come from.
 */
#include "../../src/machine/collision/hit.h"
#include "rig.h"

__extension__ typedef __int128 wide;

static struct rng rng;
static struct rig_game g;
static struct rig rig;

static int64_t between(int64_t lo, int64_t hi)
{
    return lo + (int64_t)rng_below(&rng, (uint64_t)(hi - lo) + 1);
}

static void power(const char *text)
{
    static const char kinds[] = "player.def('ship', { sprite = 'dot', hit = { circle = 3 } })\n"
                                "item.def('gem', { sprite = 'dot', radius = 5, magnet = false })\n"
                                "item.def('rock', { sprite = 'dot', radius = 5, gravity = 0 })\n";
    static char script[1024];
    struct manifest m = rig_manifest();

    m.items = 64;
    snprintf(script, sizeof script, "%s%s", kinds, text);
    rig_with_sys(&g, &m, script);
    rig_power(&rig, &g, NULL);
}

/* ---- the fall ---- */

/* Sum of the first n steps of what starts at v, changes by d a step and stops at `to`; v is what the last one was. */
static int64_t sum(int64_t start, int64_t d, int64_t to, int64_t n, int64_t *v)
{
    int64_t way = to > start ? to - start : start - to, sign = to > start ? 1 : -1, most = d ? way / d : n;
    int64_t k = n < most ? n : most;
    int64_t s = k * start + sign * d * (k * (k + 1) / 2);

    *v = start + sign * d * k;
    if (n == k)
        return s;
    *v = d ? to : start;
    return s + (n - k) * *v;
}

/* Both axes after n frames in closed form: down to `top`, and sideways to 0 from the frame on that does not rise. */
TEST(fall)
{
    power("");
    struct items *s = &rig.b->items;
    struct item_kinds *k = &rig.b->item_kinds;
    const struct item_pull none[MAX_PLAYERS] = { { 0 } };
    long capped = 0;
    rng_seed(&rng, 11);
    for (int round = 0; round < 4000; round++) {
        fx gravity = k->gravity[0] = (fx)between(0, round % 2 ? 4000 : 40),
           top = k->max_fall_speed[0] = (fx)between(0, 1 << 18);
        fx vx = (fx)between(-(1 << 18), 1 << 18), vy = (fx)between(-(1 << 18), 1 << 19);
        if (round % 5 == 0) /* a frame in which it stands at its highest */
            vy = -(fx)between(0, 60) * gravity;
        uint32_t i = (uint32_t)items_spawn(s, 0, 0, 0, 0);
        int64_t n = between(1, 600), rises = 0, x, y, end;
        s->vx[i] = vx;
        s->vy[i] = vy;
        for (int f = 0; f < n; f++)
            items_move(s, k, none);
        y = sum(vy, gravity, top, n, &end);
        assert_int_equal(s->y[i], y);
        assert_int_equal(s->vy[i], end);
        if (vy < 0) /* frames whose speed is below 0 */
            rises = gravity ? (-(int64_t)vy - 1) / gravity : n;
        rises = rises > n ? n : rises;
        x = sum(vx, gravity, 0, n - rises, &end) + rises * vx;
        assert_int_equal(s->x[i], x);
        assert_int_equal(s->vx[i], end);
        capped += end == 0 && rises;
        slots_drop(&s->s, i);
    }
    assert_true(capped > 100);
    rig_close(&rig);
}

/* ---- the pull ---- */

static wide square(wide v)
{
    return v * v;
}

/* Straight, never past the player, and no slower than asked by more than what two units of rounding are. */
TEST(pull)
{
    power("");
    struct items *s = &rig.b->items;
    rng_seed(&rng, 12);
    for (int round = 0; round < 1500; round++) {
        int64_t span = round % 3 ? 1 << 24 : 1000, speed = between(1, round % 3 ? 1 << 20 : 300);
        struct item_pull pull[MAX_PLAYERS] = { { 0 }, { 0 } };
        uint32_t i = (uint32_t)items_spawn(s, 0, (fx)between(-span, span), (fx)between(-span, span), 0);
        pull[1] = (struct item_pull){ (fx)between(-span, span), (fx)between(-span, span), 0, false, true, (fx)speed };
        items_pull(s, i, 1);
        for (int f = 0; f < 400 && (s->x[i] != pull[1].x || s->y[i] != pull[1].y); f++) {
            int64_t dx = (int64_t)pull[1].x - s->x[i], dy = (int64_t)pull[1].y - s->y[i];
            items_move(s, &rig.b->item_kinds, pull);
            int64_t mx = s->x[i] - s->prev_x[i], my = s->y[i] - s->prev_y[i];
            assert_true(dx < 0 ? mx <= 0 && mx >= dx : mx >= 0 && mx <= dx); /* never past it */
            assert_true(dy < 0 ? my <= 0 && my >= dy : my >= 0 && my <= dy);
            if (square(dx) + square(dy) <= square(speed))
                assert_true(mx == dx && my == dy); /* lands */
            else {
                /* nearest way, to two units on each axis: |m * dist - d * speed| <= 2 dist */
                wide dd = square(dx) + square(dy);
                wide ex = (wide)mx * mx * dd - square(dx) * square(speed);
                assert_true(square(mx) + square(my) <= square(speed));
                assert_true(square(speed) * dd <=
                            (square((mx < 0 ? -mx : mx) + 2) + square((my < 0 ? -my : my) + 2)) * dd);
                assert_true(ex <= 0);
            }
            assert_true(s->vx[i] == mx && s->vy[i] == my);
        }
        slots_drop(&s->s, i);
    }
    rig_close(&rig);
}

/* ---- who takes it ---- */

/* Does a point that starts at (x, y) and moves by (wx, wy) come within r of 0? */
static bool comes_within(wide x, wide y, wide wx, wide wy, wide r)
{
    wide along = -(x * wx + y * wy), ww = square(wx) + square(wy);

    if (along <= 0 || !ww)
        return square(x) + square(y) <= square(r);
    if (along >= ww)
        return square(x + wx) + square(y + wy) <= square(r);
    return square(x * wy - y * wx) <= square(r) * ww;
}

struct taken {
    int by[64]; /* 0: nobody, else the player's number */
};

static struct taken reference(const struct board *b)
{
    const struct items *s = &b->items;
    const struct player *p = &b->player;
    struct taken t = { { 0 } };

    EACH_LIVE (i, &s->s) {
        wide best = 0;
        for (uint32_t k = 0; k < MAX_PLAYERS; k++) {
            wide x = (wide)s->prev_x[i] - p->prev_x[k], y = (wide)s->prev_y[i] - p->prev_y[k];
            wide wx = (wide)s->x[i] - s->prev_x[i] - p->x[k] + p->prev_x[k];
            wide wy = (wide)s->y[i] - s->prev_y[i] - p->y[k] + p->prev_y[k];
            wide r = (wide)b->item_kinds.radius[s->kind[i]] + b->player_kinds.radius[p->kind[k]];
            if (!p->in_game[k] || !comes_within(x, y, wx, wy, r) || (t.by[i] && square(x) + square(y) >= best))
                continue;
            best = square(x) + square(y);
            t.by[i] = (int)k + 1;
        }
    }
    return t;
}

/* Random scenes, far and near, fast and slow; the events against the reference, in slot order. */
TEST(taken)
{
    long takes = 0, misses = 0, seconds = 0, left = 0;

    power("string.sys.join(1, 'ship') string.sys.join(2, 'ship')");
    struct board *b = rig.b;
    struct items *s = &b->items;
    rng_seed(&rng, 13);
    for (int round = 0; round < 3000; round++) {
        int64_t span = 1ll << between(4, 24), grain = round % 3 ? 1 : span / 4;
        EACH_LIVE (i, &s->s)
            slots_drop(&s->s, i);
        b->events.n = 0;
        b->item_kinds.radius[0] = (fx)between(0, span / 2);
        b->item_kinds.radius[1] = (fx)between(0, span / 8);
        for (uint32_t k = 0; k < MAX_PLAYERS; k++) {
            b->player.in_game[k] = (uint8_t)(k == 0 || round % 4 > 0);
            b->player.x[k] = (fx)(between(-span, span) / grain * grain);
            b->player.y[k] = (fx)(between(-span, span) / grain * grain);
            b->player.prev_x[k] = (fx)(between(-span, span) / grain * grain);
            b->player.prev_y[k] = (fx)(between(-span, span) / grain * grain);
        }
        for (int n = 0; n < 20; n++) {
            uint32_t i = (uint32_t)items_spawn(s, (uint16_t)between(0, 1), (fx)(between(-span, span) / grain * grain),
                                               (fx)(between(-span, span) / grain * grain), 0);
            s->prev_x[i] = (fx)(between(-span, span) / grain * grain);
            s->prev_y[i] = (fx)(between(-span, span) / grain * grain);
        }
        struct taken want = reference(b);
        uint32_t had = s->s.live, k = 0;
        hit_run(b);
        for (uint32_t i = 0; i < 20; i++) {
            bool out = s->x[i] < b->keep_box.x0 || s->x[i] > b->keep_box.x1 || s->y[i] < b->keep_box.y0 ||
                       s->y[i] > b->keep_box.y1;
            assert_int_equal(slots_has(&s->s, i, s->s.gen[i]), want.by[i] || !out);
            if (want.by[i]) {
                assert_true(k < b->events.n && b->events.kind[k] == EV_TAKE);
                assert_int_equal(b->events.a[k], board_handle(b, H_PLAYER, want.by[i] - 1));
                assert_int_equal(b->events.b[k], board_handle(b, H_ITEM, (int32_t)i));
                k++;
            }
            takes += want.by[i] > 0;
            misses += !want.by[i];
            seconds += want.by[i] == 2;
        }
        left += had - s->s.live;
        assert_int_equal(b->events.n, k);
    }
    assert_true(takes > 2000 && misses > 2000 && seconds > 500 && left > 1000);
    b->events.n = 0;
    rig_close(&rig);
}

/* ---- how they set out ---- */

/* The middles of n equal parts of the spread, cut to whole units. */
TEST(directions)
{
    for (uint32_t n = 1; n < 40; n++)
        for (uint64_t spread = 0; spread <= 1ull << 32; spread += 1u << 28)
            for (uint32_t k = 0; k < n; k++) {
                const double got = (int32_t)(items_spread_direction(7, spread, k, n) - 7);
                const double want = (double)spread * ((k + 0.5) / n - 0.5);
                assert_true(got - want <= 1 && want - got <= 1);
            }
}

/* ---- points ---- */

TEST(points)
{
    int64_t low[1] = { 3 }, high[1] = { 9 };
    const struct item_kinds k = { .low_points = low, .high_points = high };

    assert_int_equal(items_points(&k, 0, 70, 70, 50), 9); /* a line below the bottom */
    assert_int_equal(items_points(&k, 0, 71, 70, 50), 3);
    rng_seed(&rng, 14);
    for (int i = 0; i < 20000; i++) {
        fx line = (fx)between(-(20 << 16), 400 << 16), bottom = (fx)between(16 << 16, 1024 << 16);
        fx y = (fx)between(-(100 << 16), 1200 << 16);
        low[0] = between(0, ITEM_MAX_POINTS);
        high[0] = between(low[0], ITEM_MAX_POINTS);
        int64_t points = items_points(&k, 0, y, line, bottom);
        assert_true(points >= low[0] && points <= high[0]);
        assert_true(y > line || points == high[0]);
        assert_true(y <= line || y < bottom || points == low[0]);
        if (y > line && y < bottom) { /* points <= exact < points + 1 */
            wide exact = (wide)(high[0] - low[0]) * ((wide)bottom - y), one = (wide)bottom - line;
            assert_true((wide)(points - low[0]) * one <= exact && exact < (wide)(points - low[0] + 1) * one);
        }
    }
}

/* Without items their parts have no hash, as those of all that a game can leave out. */
TEST(absent)
{
    struct manifest m = rig_manifest();
    uint64_t hashes[MAX_PARTS], all[2];

    for (int with = 0; with < 2; with++) {
        m.items = with ? 16 : 0;
        rig_script(&g, &m, "");
        rig_power(&rig, &g, NULL);
        board_hashes(rig.b, hashes);
        for (int i = FIRST_OPTIONAL_PART; i < PART_COUNT; i++)
            assert_int_equal(hashes[i] != 0, with && !strncmp(board_part_name(rig.b, i), "item", 4));
        all[with] = board_hash(rig.b);
        rig_close(&rig);
    }
    assert_true(all[0] != all[1]);
}

RUN_TESTS(NULL, NULL)

/*
 * test_meets.c - bullets that meet bullets: who meets whom, against all pairs and the reference of hits.h; and by hand
 * what comes of it.
 */
#include "hits.h"

enum { BULLETS = 320, KINDS = 14, PIECES = 6 /* kinds from there on */, TAGS = 5 };

static fx length(fx most)
{
    return one_in(9) ? most : one_in(9) ? 0 : (fx)(rng_below(&rng, (uint64_t)most + 1) >> rng_below(&rng, 24));
}

static fx slower(fx v)
{
    return v < fastest ? v : fastest;
}

/* ---- who meets whom ---- */

static void draw_kinds(struct bullet_kinds *k, fx size)
{
    const struct shape_columns columns = { k->shape, k->a, k->b, k->x, k->y };

    k->s.live = KINDS;
    for (uint32_t i = 0; i < KINDS; i++) {
        k->shape[i] = (uint8_t)(one_in(9) ? SHAPE_NONE : one_in(2) ? SHAPE_CIRCLE : SHAPE_BOX);
        k->a[i] = k->shape[i] ? length(one_in(20) ? fastest : size) : 0;
        k->b[i] = k->shape[i] == SHAPE_BOX ? length(size) : 0;
        k->x[i] = k->y[i] = 0;
        k->flags[i] =
            (uint16_t)((one_in(3) ? 0 : KIND_SWEPT) | (one_in(3) ? KIND_FIXED : 0) | (one_in(2) ? KIND_TURNS : 0));
    }
    for (uint32_t i = PIECES; i < KINDS; i += 4)
        draw_pieces(&columns, i, i + 3, false, size);
}

static void draw_pairs(struct bullets *s)
{
    s->n_meet_pairs = 1 + (uint32_t)rng_below(&rng, 4);
    for (uint32_t p = 0; p < s->n_meet_pairs; p++) {
        s->meet_first[p] = (uint16_t)(1 + rng_below(&rng, TAGS));
        s->meet_second[p] = (uint16_t)(1 + rng_below(&rng, TAGS));
        s->meet_flags[p] = (uint8_t)rng_below(&rng, 8);
    }
}

/* grain: places are multiples of it, so that many are equally far apart. */
static void draw_bullets(struct bullets *s, uint64_t n, fx span, fx speed, fx grain)
{
    while (n--) {
        struct bullet_spec shape = { .kind = (uint16_t)rng_below(&rng, KINDS),
                                     .delay = one_in(9),
                                     .dir = (ang)rng_next(&rng) };
        shape.tag = (uint16_t)rng_below(&rng, TAGS + 1);
        uint32_t i = (uint32_t)bullets_fire(s, &shape, 0);
        bool still = one_in(3) || shape.delay;
        fx most = one_in(30) ? fastest : speed;
        s->vx[i] = still ? 0 : within(most) / grain * grain;
        s->vy[i] = still ? 0 : within(most) / grain * grain;
        s->x[i] = clamped((int64_t)within(span) / grain * grain + s->vx[i], edge);
        s->y[i] = clamped((int64_t)within(span) / grain * grain + s->vy[i], edge);
        if (one_in(9))
            bullets_drop(s, i);
        else if (one_in(9))
            slots_hold(&s->s, s->leaving, i);
    }
}

static void empty(struct board *b)
{
    bullets_release_all(&b->bullets);
    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    slots_trim(&b->bullets.s);
    b->events.n = 0;
}

/* The same where the kind stands. */
static struct whole body(const struct board *b, uint32_t i)
{
    struct whole w = flier(&b->bullets, &b->bullet_kinds, i);

    for (int k = 0; k < w.n && !(b->bullet_kinds.flags[b->bullets.kind[i]] & KIND_SWEPT); k++) {
        w.piece[k].was_x = w.piece[k].x;
        w.piece[k].was_y = w.piece[k].y;
    }
    return w;
}

static struct {
    long met, ties, alone, held, passed, stood, pieces;
    bool first[BULLETS], gone[BULLETS];
} plain;

static bool there(const struct board *b, uint32_t i, uint16_t tag)
{
    const struct bullets *s = &b->bullets;
    bool live = s->s.live_bits[i / 64] >> (i & 63) & 1, held = i < s->s.held_top && s->s.held[i / 64] >> (i & 63) & 1;

    return (live || held) && s->tag[i] == tag && !(s->flags[i] & BULLET_DELAYED) && !plain.gone[i];
}

static wide apart(const struct bullets *s, uint32_t i, uint32_t k)
{
    return square((wide)s->x[i] - s->vx[i] - ((wide)s->x[k] - s->vx[k])) +
           square((wide)s->y[i] - s->vy[i] - ((wide)s->y[k] - s->vy[k]));
}

/* Whom bullet i meets as the first of pair p; NO_SLOT: nobody. */
static int32_t plain_partner(const struct board *b, uint32_t p, uint32_t i)
{
    const struct bullets *s = &b->bullets;
    bool alone = s->meet_first[p] == s->meet_second[p];
    struct whole me = body(b, i);
    int32_t found = NO_SLOT;
    wide best = 0;

    for (uint32_t k = 0; k < s->s.top; k++) {
        if (k == i || !there(b, k, s->meet_second[p]) || (alone && plain.first[k]))
            continue;
        wide d = apart(s, i, k);
        if (found != NO_SLOT && d > best)
            continue;
        if (!meets(me, body(b, k), true)) {
            plain.passed++;
            continue;
        }
        plain.ties += found != NO_SLOT && d == best;
        if (found != NO_SLOT && d == best)
            continue;
        best = d;
        found = (int32_t)k;
    }
    return found;
}

static void mark(const struct board *b, uint32_t p, uint32_t i, uint32_t k)
{
    const struct bullets *s = &b->bullets;
    const uint16_t *flags = b->bullet_kinds.flags;
    bool all = s->meet_flags[p] & MEET_ALL, alone = s->meet_first[p] == s->meet_second[p];

    plain.first[i] = true;
    plain.first[k] |= alone;
    if (s->meet_flags[p] & MEET_FIRST && (all || !(flags[s->kind[i]] & KIND_FIXED)))
        plain.gone[i] = true;
    if (s->meet_flags[p] & MEET_SECOND && (all || !(flags[s->kind[k]] & KIND_FIXED)))
        plain.gone[k] = true;
    plain.met++;
    plain.alone += alone;
    plain.held += i < s->s.held_top && s->s.held[i / 64] >> (i & 63) & 1;
    plain.stood += !(flags[s->kind[i]] & KIND_SWEPT) != !(flags[s->kind[k]] & KIND_SWEPT);
    plain.pieces += (b->bullet_kinds.shape[s->kind[i]] | b->bullet_kinds.shape[s->kind[k]]) > SHAPE_MAX_SIMPLE;
}

static void reference_meets(const struct board *b)
{
    const struct bullets *s = &b->bullets;

    expected_n = 0;
    memset(plain.first, 0, sizeof plain.first);
    memset(plain.gone, 0, sizeof plain.gone);
    for (uint32_t p = 0; p < s->n_meet_pairs; p++)
        for (uint32_t i = 0; i < s->s.top; i++) {
            int32_t k = there(b, i, s->meet_first[p]) && !plain.first[i] ? plain_partner(b, p, i) : NO_SLOT;
            if (k == NO_SLOT)
                continue;
            expect(b, EV_MEET, H_BULLET, i, H_BULLET, (uint32_t)k);
            expected[expected_n - 1].pair = p;
            mark(b, p, i, (uint32_t)k);
        }
}

static void compare_pairs(const struct board *b, int scene)
{
    compare(b, scene);
    for (int i = 0; i < expected_n; i++)
        if (events_at(&b->events, (uint32_t)i).pair != expected[i].pair)
            fail_msg("scene %d, event %d: pair %u, expected %u", scene, i, events_at(&b->events, (uint32_t)i).pair,
                     expected[i].pair);
}

/* At all scales up to the ends of the world: crowds of small ones, single large or fast ones, places in a raster. */
TEST(random)
{
    int n = rig_long() ? 60000 : 6000;
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    m.bullets = BULLETS;
    m.bullets_can_meet = 1;
    rig_script(&g, &m, "");
    rig_power(&r, &g, NULL);
    rig_reserve_kinds(r.b);
    rng_seed(&rng, 5);
    for (int i = 0; i < n; i++) {
        fx span = (fx)(1 + (rng_below(&rng, (uint64_t)edge) >> rng_below(&rng, 22)));
        fx size = slower(1 + span / (fx)(1 + rng_below(&rng, 60))),
           speed = slower(span / (fx)(1 + rng_below(&rng, 40)));
        fx grain = one_in(2) ? 1 : 1 + span / (fx)(1 + rng_below(&rng, 9));
        empty(r.b);
        draw_kinds(&r.b->bullet_kinds, size);
        draw_pairs(&r.b->bullets);
        draw_bullets(&r.b->bullets, 1 + rng_below(&rng, one_in(4) ? BULLETS : 40), span, speed, grain);
        reference_meets(r.b);
        r.b->bullets.holds_all = true; /* as the move does, in a game where bullets meet */
        hit_run(r.b);
        compare_pairs(r.b, i);
    }
    if (plain.met < 2 * n || plain.passed < 9 * n || plain.ties < n / 9 || plain.alone < n / 9 || plain.held < n / 9 ||
        plain.stood < n / 9 || plain.pieces < n)
        fail_msg("too few: met %ld passed %ld ties %ld of one tag %ld held %ld standing %ld in pieces %ld", plain.met,
                 plain.passed, plain.ties, plain.alone, plain.held, plain.stood, plain.pieces);
    rig_free(&r);
    rig_game_free(&g);
}

/* In a crowd each looks at few: 4,000 and 4,000 in a field, and one that is fast and large. */
TEST(crowd)
{
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    m.bullets = 8000;
    m.bullets_can_meet = 1;
    rig_script(&g, &m,
               "bullet.def('dot', { sprite = 'dot', hit = { circle = 2 } })\n"
               "bullet.def('moon', { sprite = 'dot', hit = { circle = 60 } })\n"
               "bullet.meet('fire', 'ice', { on_meet = function() end })\n"
               "bullet.fire { kind = 'moon', x = 99, y = 99, speed = 200, tag = 'ice' }\n"
               "for i = 1, 7999 do\n"
               "  bullet.fire { kind = 'dot', x = rng.number(0, 240), y = rng.number(0, 320), dir = i, speed = 2,\n"
               "    tag = i % 2 == 0 and 'fire' or 'ice' }\n"
               "end\n");
    rig_power(&r, &g, NULL);
    rig_run(&r, 1);
    assert_int_equal(r.b->bullets.s.live, 8000);
    if (r.b->counts.tested < 4000 || r.b->counts.tested > 4000 * 9)
        fail_msg("%u shapes tested", (unsigned)r.b->counts.tested);
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- what comes of it ---- */

static const char kinds[] =
    "spark.def('ping', { sprite = 'dot', life = 300, drag = 1 })\n"
    "spark.def('pong', { sprite = 'wink', life = 300 })\n"
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 4 }, vanish = 'pong', cloud = 'wink' })\n"
    "bullet.def('still', { sprite = 'dot', hit = { circle = 4 }, swept = false })\n"
    "bullet.def('rock', { sprite = 'dot', hit = { box = { 6, 6 } }, clearable = false })\n"
    "bullet.def('bar', { sprite = 'dot', hit = { capsule = { 12, 2 } } })\n"
    "bullet.def('shade', { sprite = 'dot', hit = { circle = 9 }, harmless = true })\n"
    "shot.def('eraser', { sprite = 'dot', hit = { circle = 3 }, cancels = true })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, lives = 3 }) string.sys.join(1, 'ship')\n"
    "local p = player.get(1)\n"
    "string.good = 0\n"
    "local told, at = '', { }\n"
    "local function tell(a, b)\n"
    "  assert(a.alive or b.alive or a.x)\n"
    "  told = told .. a.tag .. (at[a] or '') .. b.tag .. (at[b] or '') .. ' '\n"
    "end\n"
    "local function fire(tag, x, y, more)\n"
    "  local t = { kind = 'dot', x = x, y = y, speed = 0, tag = tag }\n"
    "  for k, v in pairs(more or { }) do t[k] = v end\n"
    "  return bullet.fire(t)\n"
    "end\n";

static void holds(const char *pairs, const char *task, int pings, int pongs)
{
    static char text[8192];
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;
    int sparks[2] = { 0 };

    m.bullets_can_meet = m.has_freeze = m.has_hp = 1;
    snprintf(text, sizeof text, "%s%s\ntask.go(function() wait(1) %s string.good = 1 end)\n", kinds, pairs, task);
    rig_with_sys(&g, &m, text);
    rig_power(&r, &g, NULL);
    for (int i = 0; i < 40; i++) {
        board_tick(r.b, (uint16_t[MAX_PLAYERS]){ 0 });
        if (rig_fault(&r))
            fail_msg("%s: %s", task, rig_fault(&r)->message);
        rig_spoil(&r);
    }
    lua_getglobal(r.b->vm.L, "string");
    lua_getfield(r.b->vm.L, -1, "good");
    if (lua_tointeger(r.b->vm.L, -1) != 1)
        fail_msg("%s: it did not come to its end", task);
    EACH_LIVE (i, &r.b->sparks.s)
        sparks[r.b->sparks.kind[i]]++;
    if (sparks[0] != pings || sparks[1] != pongs)
        fail_msg("%s: %d and %d sparks, expected %d and %d", task, sparks[0], sparks[1], pings, pongs);
    rig_free(&r);
    rig_game_free(&g);
}

TEST(clear)
{
    const char *two = "local a, b = fire('fire', 50, 50), fire('ice', 57, 50) wait(1) ";
    char text[400];

#define TWO(asserted) (snprintf(text, sizeof text, "%sassert(%s)", two, asserted), text)
    holds("bullet.meet('fire', 'ice', { clear = 'both' })", TWO("not a.alive and not b.alive"), 0, 2);
    holds("bullet.meet('fire', 'ice', { clear = 'first' })", TWO("not a.alive and b.alive"), 0, 1);
    holds("bullet.meet('fire', 'ice', { clear = 'second', spark = 'ping' })", TWO("a.alive and not b.alive"), 1, 0);
    holds("bullet.meet('ice', 'fire', { clear = 'first', on_meet = tell })",
          TWO("a.alive and not b.alive and told == 'icefire '"), 0, 1);
    holds("bullet.meet('fire', 'ice', { on_meet = tell })",
          TWO("a.alive and b.alive and told == 'fireice ' and board.live 'bullets' == 2"), 0, 0);
    holds("bullet.meet('fire', 'fire', { clear = 'both' })", TWO("a.alive and b.alive"), 0, 0);
    holds("bullet.meet('fire', 'ice', { clear = 'none', on_meet = function(a, b) a:remove() end })",
          TWO("not a.alive and b.alive"), 0, 0);
    holds("bullet.meet('fire', 'ice', { clear = 'both', on_meet = function(a, b) a:remove() end })",
          TWO("not a.alive and not b.alive"), 0, 1);
    holds("bullet.meet('fire', 'ice', { clear = 'both' })",
          "local a, b = fire('fire', 50, 50), fire('ice', 50, 50, { kind = 'rock' }) wait(1)\n"
          "assert(not a.alive and b.alive)",
          0, 1);
    holds("bullet.meet('fire', 'ice', { clear = 'both', all = true })",
          "local a, b = fire('fire', 50, 50), fire('ice', 50, 50, { kind = 'rock' }) b.hp = 9 wait(1)\n"
          "assert(not a.alive and not b.alive)",
          0, 1);
}

/* One that is taken away meets no more; one that stays meets all that touch it. */
TEST(many)
{
    holds("bullet.meet('fire', 'ice', { clear = 'both' })",
          "for i = 1, 5 do fire('fire', 50, 50) end for i = 1, 3 do fire('ice', 50, 50) end wait(1)\n"
          "assert(bullet.group('fire').count == 2 and bullet.group('ice').count == 0)",
          0, 6);
    holds("bullet.meet('fire', 'ice', { clear = 'first' })",
          "for i = 1, 5 do fire('fire', 50, 50) end local b = fire('ice', 50, 50) wait(1)\n"
          "assert(bullet.group('fire').count == 0 and b.alive)",
          0, 5);
    holds("bullet.meet('fire', 'ice', { clear = 'second' })",
          "local a = fire('fire', 50, 50) for i = 1, 3 do fire('ice', 50, 50) end wait(1)\n"
          "assert(a.alive and bullet.group('ice').count == 2) wait(1) assert(bullet.group('ice').count == 1)",
          0, 3);
    holds("bullet.meet('fire', 'fire', { on_meet = tell })",
          "for i = 1, 3 do at[fire('fire', 50, 50)] = i end wait(1) assert(told == 'fire1fire2 ')", 0, 0);
    holds("bullet.meet('fire', 'ice', { on_meet = tell }) bullet.meet('ice', 'fire', { on_meet = tell })\n"
          "bullet.meet('fire', 'fire', { on_meet = tell })",
          "for i = 1, 2 do at[fire('fire', 50, 50)] = i at[fire('ice', 50, 50)] = i end wait(1)\n"
          "assert(told == 'fire1ice1 fire2ice1 ice1fire1 ice2fire1 ')",
          0, 0);
    holds("bullet.meet('fire', 'ice', { on_meet = tell })",
          "at[fire('ice', 50, 50)], at[fire('ice', 56, 50)], at[fire('ice', 53, 50)] = 1, 2, 3\n"
          "at[fire('fire', 59, 50)] = 1 at[fire('fire', 51.5, 50)] = 2 wait(1)\n"
          "assert(told == 'fire1ice2 fire2ice1 ')",
          0, 0);
    holds("bullet.meet('fire', 'ice', { clear = 'both', on_meet = function(a) bullet.group('fire'):remove() end })",
          "fire('fire', 50, 50) fire('fire', 90, 50) fire('ice', 50, 50) local b = fire('ice', 90, 50) wait(1)\n"
          "assert(b.alive and bullet.group().count == 1)",
          0, 1);
}

TEST(who)
{
    const char *both = "bullet.meet('fire', 'ice', { clear = 'both', on_meet = tell })";

    /* on their ways, or where a kind that is not swept stands */
    holds(both,
          "local a, b = fire('fire', 50, 50, { dir = 0, speed = 90 }), fire('ice', 100, 50) wait(1)\n"
          "assert(not a.alive and not b.alive)",
          0, 2);
    holds(both,
          "local a, b = fire('fire', 50, 50, { dir = 0, speed = 90, kind = 'still' }), fire('ice', 100, 50) wait(1)\n"
          "assert(a.alive and b.alive)",
          0, 0);
    holds(both,
          "local a, b = fire('fire', 50, 50, { dir = 0, speed = 90, kind = 'still' }),\n"
          "  fire('ice', 180, 50, { dir = 180, speed = 80 }) wait(1) assert(not a.alive and not b.alive)",
          0, 1);
    /* shapes in pieces */
    holds(both,
          "local a, b = fire('fire', 50, 50, { dir = 0, kind = 'bar' }), fire('ice', 60, 50) wait(1)\n"
          "assert(not a.alive) a, b = fire('fire', 50, 50, { dir = 90, kind = 'bar' }), fire('ice', 60, 50) wait(1)\n"
          "assert(a.alive)",
          0, 1);
    /* a cloud is harmless */
    holds(both,
          "local a, b = fire('fire', 50, 50, { delay = 5 }), fire('ice', 50, 50) wait(5) assert(a.alive and b.alive)\n"
          "wait(1) assert(not a.alive and not b.alive)",
          0, 2);
    holds(both,
          "local a, b = fire('fire', 50, 50), fire('ice', 50, 50, { delay = 5 }) wait(5) assert(a.alive and b.alive)\n"
          "wait(1) assert(not a.alive and not b.alive)",
          0, 2);
    /* what is frozen takes part */
    holds(both,
          "local a, b = fire('fire', 50, 50, { dir = 0, speed = 9 }), fire('ice', 60, 50) a.frozen = 3 wait(3)\n"
          "assert(a.alive and b.alive) wait(1) assert(not a.alive and not b.alive)",
          0, 2);
    holds(both,
          "local a, b = fire('fire', 50, 50, { dir = 0, speed = 3 }), fire('ice', 60, 50) b.frozen = forever wait(2)\n"
          "assert(not a.alive and not b.alive)",
          0, 2);
    /* what leaves the field does */
    holds(both,
          "local a, b = fire('fire', 280, 50, { dir = 0, speed = 60 }), fire('ice', 300, 50) wait(1)\n"
          "assert(not a.alive and not b.alive and told == 'fireice ')",
          0, 1);
    holds(both,
          "local a, b = fire('fire', 300, 50), fire('ice', 280, 50, { dir = 0, speed = 60 }) wait(1)\n"
          "assert(not a.alive and not b.alive and told == 'fireice ')",
          0, 1);
    /* a tag that is taken off, and one that is put on */
    holds(both,
          "local a, b = fire('fire', 50, 50), fire('ice', 50, 50) b.tag = nil wait(1) assert(a.alive and b.alive)\n"
          "b.tag = 'ice' wait(1) assert(not a.alive and not b.alive)",
          0, 2);
    /* a shot that took one of them came first */
    holds(both,
          "local a, b = fire('fire', 50, 50), fire('ice', 57, 50) shot.fire { kind = 'eraser', x = 43, y = 50, speed = "
          "0 }\n"
          "wait(1) assert(not a.alive and b.alive and told == '')",
          0, 1);
}

TEST(harmless)
{
    holds("on.hit(function() told = told .. 'hit ' end) on.graze(function() told = told .. 'graze ' end)",
          "p.safe = 0 local b = fire('fire', p.x, p.y, { kind = 'shade' }) fire('fire', p.x + 14, p.y, { kind = "
          "'shade' }) wait(3)\n"
          "assert(told == '' and b.alive, told) b.kind = 'dot' p.safe = 0 wait(2) assert(told == 'hit ', "
          "told)",
          0, 0);
}

/* The pairs are in the trace. */
struct pair_seen {
    int meets, firsts;
    uint64_t last;
};

static void see(void *context, const struct slots_value *v)
{
    struct pair_seen *s = context;

    s->meets += !strcmp(v->column, "n_meet_pairs");
    s->firsts += !strcmp(v->column, "meet_first");
    if (!strcmp(v->column, "n_meet_pairs"))
        s->last = v->value;
}

TEST(trace)
{
    for (int on = 0; on < 2; on++) {
        struct manifest m = rig_manifest();
        struct pair_seen s = { 0 };
        struct rig_game g;
        struct rig r;
        m.bullets_can_meet = on;
        rig_script(&g, &m,
                   on ? "bullet.meet('a', 'b', { clear = 'both' }) bullet.meet('b', 'a', { clear = 'both' })" : "");
        rig_power(&r, &g, NULL);
        for (int i = 0; i < PART_COUNT; i++)
            board_trace(r.b, i, see, &s);
        assert_int_equal(s.meets, on);
        assert_int_equal(s.firsts, on * MAX_MEET_PAIRS);
        assert_int_equal(s.last, 2 * on);
        assert_int_equal(r.b->bullets.meet_next != NULL, on);
        rig_free(&r);
        rig_game_free(&g);
    }
}

static void fault(bool on, const char *text, const char *words)
{
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    m.bullets_can_meet = on;
    rig_script(&g, &m, text);
    rig_power_any(&r, &g, NULL);
    for (int i = 0; i < 3 && !rig_fault(&r); i++)
        board_tick(r.b, (uint16_t[MAX_PLAYERS]){ 0 });
    assert_non_null(rig_fault(&r));
    assert_string_equal(rig_fault(&r)->message, words);
    rig_free(&r);
    rig_game_free(&g);
}

TEST(errors)
{
    fault(false, "bullet.meet('a', 'b', { clear = 'both' })",
          "main.lua:1: bullet.meet: disabled; add `meet = true` to `board` in rom.lua");
    fault(true, "bullet.meet('a', 'b', { clear = 'frist' })",
          "main.lua:1: bullet.meet: clear: expected none, first, second or both, got \"frist\"");
    fault(true, "bullet.meet('a', 'b', { })",
          "main.lua:1: bullet.meet: expected `clear` or `on_meet` (without either, a meeting has no effect)");
    fault(true, "bullet.meet('a', 'b', { clear = 'none', all = true, on_meet = print })",
          "main.lua:1: bullet.meet: all: requires `clear`");
    fault(true,
          "bullet.meet('a', 'b', { clear = 'both' }) bullet.meet('b', 'a', { clear = 'both' })\n"
          "bullet.meet('a', 'b', { clear = 'first' })",
          "main.lua:2: bullet.meet: tags \"a\" and \"b\" are already declared as a pair");
    fault(true, "for i = 1, 17 do bullet.meet('a', 'b' .. i, { clear = 'both' }) end",
          "main.lua:1: bullet.meet: too many pairs of tags (at most 16)");
    fault(true, "task.go(function() wait(1) bullet.meet('a', 'b', { clear = 'both' }) end)",
          "main.lua:1: bullet.meet: can only be called while scripts load");
}

RUN_TESTS(NULL, NULL)

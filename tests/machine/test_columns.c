/*
 * test_columns.c - the column tables: they describe every byte of the parts' structs, and are right about each column.
 * Every bit of state is hashed by one part, in live slots alone; derived columns can be computed from the others.
 */
#include "rig.h"

/* ---- the tables against the structs ---- */

enum { STRUCT_SIZE = 2048 };

/* The alignment of each byte's column; 0: no column has it. Parts follow each other to the end of struct board. */
static size_t fill_alignments(int part, uint8_t alignment[STRUCT_SIZE])
{
    const struct chip *chip = machine_parts[part].chip;
    const size_t end = part + 1 < PART_COUNT ? machine_parts[part + 1].offset : sizeof(struct board);
    const size_t size = end - machine_parts[part].offset;

    assert_true(size <= STRUCT_SIZE);
    memset(alignment, 0, STRUCT_SIZE);
    memset(alignment, 8, sizeof(struct slots));
    for (int i = 0; i < chip->count; i++) {
        const struct column *c = &chip->columns[i];
        const uint8_t align = c->is_register && c->kind != COL_DERIVED ? c->width : sizeof(void *);
        const size_t n = c->is_register ? (size_t)c->width * c->n : sizeof(void *);
        assert_true(c->offset + n <= size);
        for (size_t k = c->offset; k < c->offset + n; k++) {
            if (alignment[k])
                fail_msg("part %s: column %s overlaps another", chip->name, c->name);
            alignment[k] = align;
        }
    }
    return size;
}

/* A column that is missing in a table leaves more bytes than alignment does. */
TEST(tables)
{
    uint8_t alignment[STRUCT_SIZE];

    assert_true((int)PART_COUNT <= (int)MAX_PARTS);
    for (int i = 0; i < PART_COUNT; i++) {
        const size_t size = fill_alignments(i, alignment);
        size_t gap = 0;
        for (size_t k = 0; k <= size; k++) {
            const size_t align = k < size ? alignment[k] : 8;
            if (align && gap >= align)
                fail_msg("part %s: the bytes before %zu are in no column", machine_parts[i].chip->name, k);
            gap = align ? 0 : gap + 1;
        }
        for (int k = 0; k < i; k++)
            assert_string_not_equal(machine_parts[k].chip->name, machine_parts[i].chip->name);
    }
}

/* ---- the hashes ---- */

struct sums {
    uint64_t part[MAX_PARTS], all;
};

static struct sums sums_of(const struct board *b)
{
    struct sums s = { .all = board_hash(b) };

    board_hashes(b, s.part);
    return s;
}

static struct slots *slots_at(struct board *b, int i)
{
    return (struct slots *)((uint8_t *)b + machine_parts[i].offset);
}

static uint8_t *bytes_at(struct board *b, int i, const struct column *c)
{
    uint8_t *at = (uint8_t *)b + machine_parts[i].offset + c->offset;

    if (!c->is_register)
        memcpy(&at, at, sizeof(uint8_t *));
    return at;
}

/* Flips one bit; exactly the hash of part i changes, and (unless it is unhashed) the combined one; none for i < 0. */
static void flip(struct board *b, const struct sums *was, uint8_t *byte, int bit, int i, const char *what)
{
    *byte ^= (uint8_t)(1 << bit);
    struct sums now = sums_of(b);
    *byte ^= (uint8_t)(1 << bit);
    for (int k = 0; k < PART_COUNT; k++)
        if ((now.part[k] != was->part[k]) != (k == i))
            fail_msg("%s: a flipped bit: the hash of %s %s", what, machine_parts[k].chip->name,
                     k == i ? "stays" : "changes");
    if ((now.all != was->all) != (i >= 0 && !machine_parts[i].chip->unhashed))
        fail_msg("%s: the combined hash %s", what, now.all == was->all ? "stays" : "changes");
}

/* A live slot of part i (the one after skipping some), or NO_SLOT. */
static int32_t live_slot(struct board *b, int i, uint64_t skip)
{
    const struct slots *s = slots_at(b, i);
    uint32_t end = s->live_bits ? s->top : s->live, at = slots_next(s, 0);

    if (!s->live)
        return NO_SLOT;
    for (skip %= s->live; skip--;)
        at = slots_next(s, at + 1);
    assert_true(at < end);
    return (int32_t)at;
}

/* A slot below top that is dead, or NO_SLOT. */
static int32_t dead_slot(struct board *b, int i)
{
    const struct slots *s = slots_at(b, i);

    for (uint32_t k = 0; s->live_bits && k < s->top; k++)
        if (!(s->live_bits[k / 64] >> (k & 63) & 1))
            return (int32_t)k;
    return NO_SLOT;
}

/* Returns false when the part has no live slot to try it on. */
static bool check_column(struct board *b, const struct sums *was, struct rng *rng, int i, const struct column *c)
{
    char what[80];
    int32_t slot = c->is_register ? 0 : live_slot(b, i, rng_next(rng)),
            dead = c->is_register ? NO_SLOT : dead_slot(b, i);
    size_t size = (size_t)c->width * c->n;

    snprintf(what, sizeof what, "%s.%s", machine_parts[i].chip->name, c->name);
    if (slot == NO_SLOT)
        return false;
    if (c->is_per_block) {
        slot /= SLOTS_BLOCK;
        dead = NO_SLOT;
    }
    for (size_t k = 0; k < size; k++) /* every value of the slot, every byte of it */
        flip(b, was, bytes_at(b, i, c) + (size_t)slot * size + k, (int)rng_below(rng, 8), c->kind == COL_GAME ? i : -1,
             what);
    if (dead != NO_SLOT)
        flip(b, was, bytes_at(b, i, c) + (size_t)dead * size, (int)rng_below(rng, 8), -1, what);
    return true;
}

static bool check_slots(struct board *b, const struct sums *was, struct rng *rng, int i)
{
    struct slots *s = slots_at(b, i);
    char what[80];

    snprintf(what, sizeof what, "slots of %s", machine_parts[i].chip->name);
    flip(b, was, (uint8_t *)&s->refused, (int)rng_below(rng, 8), i, what);
    flip(b, was, (uint8_t *)&s->cap, (int)rng_below(rng, 8), -1, what);
    flip(b, was, (uint8_t *)&s->high_water, (int)rng_below(rng, 8), -1, what);
    flip(b, was, (uint8_t *)&s->first_free_word, (int)rng_below(rng, 8), -1, what);
    if (s->live_bits && s->top) {
        int32_t slot = live_slot(b, i, rng_next(rng)), dead = dead_slot(b, i);
        s->top += 64; /* nothing lives there */
        s->live_bits[s->top / 64 - 1] = 0;
        struct sums now = sums_of(b);
        s->top -= 64;
        assert_memory_equal(&now, was, sizeof now);
        if (slot == NO_SLOT)
            return false;
        flip(b, was, (uint8_t *)&s->gen[slot], (int)rng_below(rng, 8), i, what);
        flip(b, was, (uint8_t *)&s->live_bits[slot / 64] + slot % 64 / 8, slot % 8, i, what);
        if (dead != NO_SLOT)
            flip(b, was, (uint8_t *)&s->gen[dead], (int)rng_below(rng, 8), -1, what);
    }
    return true;
}

/* Room for `top += 64` above. */
static bool has_room(struct board *b)
{
    for (int i = 0; i < PART_COUNT; i++)
        if (slots_at(b, i)->live_bits && slots_at(b, i)->top + 64 > (slots_at(b, i)->cap + 63) / 64 * 64)
            return false;
    return true;
}

/* A scene in which every part has live slots, and pools have dead ones between. */
static const char scene[] =
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"
    "shot.def('bolt', { sprite = 'arrow', hit = { box = { 4, 8 } }, turns = true })\n"
    "enemy.def('foe', { sprite = 'wink', hit = { box = { 9, 9 } }, hp = 50 })\n"
    "option.def('bead', { sprite = 'dot' })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, options = { kind = 'bead', levels = { { wide = {\n"
    "  { 9, 9 }, { -9, 9 }, { 0, 20 } } } } }, registers = { a = 1, b = { start = 2, max = 9 }, c = { drain = 1 } } "
    "})\n"
    "spark.def('glow', { sprite = 'dot', life = 500 })\n"
    "item.def('gem', { sprite = 'dot', radius = 5, gives = { score = { 1, 5 }, lives = 2, a = 3 }, full = 'b' })\n"
    "laser.def('ray', { strip = 'dot', width = 8, hit = { share = 1 } })\n"
    "motion.def { name = 'm', { loop = forever, { turn = 1, over = 9 }, { loop = 2, { wait = 3 } } } }\n"
    "stage.def('s', function()\n"
    "  for i = 1, 20 do\n"
    "    local e = enemy.spawn { kind = 'foe', x = 20 + 9 * i, y = 20 }\n"
    "    local things = { e,\n"
    "      bullet.fire { kind = 'dot', x = 60 + i, y = 30, speed = 0.25, motion = 'm', tag = 't' },\n"
    "      shot.fire { kind = 'bolt', x = 50 + i, y = 200, speed = 0.5 },\n"
    "      laser.curve { kind = 'ray', x = 50 + i, y = 60, speed = 0.5, motion = 'm', points = 40 },\n"
    "      sprite.put { sprite = 'wink', x = i, y = i },\n"
    "      text.line { x = i, y = i, text = 'words' .. i, letter = 1 } }\n"
    "    laser.beam { kind = 'ray', follow = e, length = 9, hold = 300, tag = 't' }\n"
    "    item.drop { kind = 'gem', x = 50 + i, y = 30, speed = 0.5, tag = 'gem' .. i % 2 }\n"
    "    e:move { x = 100, y = 100, over = 100 }\n"
    "    spark.burst { kind = 'glow', x = 100, y = 100, n = 2, speed = 0.5 }\n"
    "    task.go(function()\n"
    "      wait(10 + i)\n"
    "      for _, thing in ipairs(i % 2 == 0 and things or {}) do thing:remove() end\n"
    "      wait(i)\n"
    "    end)\n"
    "  end\n"
    "  for i = 1, 6 do\n"
    "    local d = bullet.ml { name = 'doc', kind = 'dot', x = 100, y = 20 * i }\n"
    "    task.go(function() wait(i) if i % 2 == 0 then d:stop() end end)\n"
    "  end\n"
    "  task.go(function() wait(12) item.group('gem0'):remove() end)\n"
    "  bg.lines(2, { 1, 2, 3 })\n"
    "  bg.plane().fog = { to = 0, far = 9 }\n"
    "  text.put { col = 1, row = 1, text = 'words' }\n"
    "  palette.fade { to = 0, over = 99 } palette.cycle { first = 3, last = 9, every = 5 }\n"
    "  save.set('key', 1)\n"
    "  screen.shake { size = 3, over = 99 }\n"
    "  wait(forever)\n"
    "end)\n"
    "boot.run { stages = { 's' }, players = { 'ship' }, pause = { { 'Map', print } } }\n";
static const char document[] =
    "<bulletml><action label='top'><repeat><times>9</times><action><fire><bulletRef label='b'><param>$rand*90</param>"
    "</bulletRef></fire><wait>1</wait></action></repeat></action><bullet label='b'><speed>0.3</speed><action><repeat>"
    "<times>3</times><action><changeDirection><direction type='sequence'>$1</direction><term>50</term>"
    "</changeDirection><wait>3+$rand*9</wait></action></repeat><vanish/></action></bullet></bulletml>";

/* A game of the scene, with everything. */
static void write_scene(struct rig_game *g)
{
    struct manifest m = rig_manifest();

    m.tasks = m.sprites = m.shots = m.enemies = 128;
    m.bullet_values = m.shot_values = m.enemy_values = MAX_VALUES;
    m.has_hp = m.has_orbit = m.has_freeze = m.bullets_can_meet = m.has_wide_text = m.has_backgrounds = m.has_bodies =
        m.has_pierce = m.has_sound = m.has_transforms = 1;
    m.items = m.lines = m.lasers = m.options = m.bulletml_runners = 192; /* of two bits: one may be flipped */
    m.curve_points = 96 * 64;
    m.view_w = 120;
    m.view_h = 160;
    rig_script(g, &m, scene);
    rig_sounds(g);
    rig_document(g, "doc", document);
}

static const struct board_start in_scene = { .seed = 1, .difficulty = -1, .practice.section = "s" };

TEST(flips)
{
    struct rig_game g;
    struct rig r;
    struct rng rng;

    write_scene(&g);
    rig_power(&r, &g, &in_scene);
    rig_run(&r, 26);
    assert_true(has_room(r.b));
    rng_seed(&rng, 3);
    struct sums was = sums_of(r.b);
    for (int i = 0; i < PART_COUNT; i++) {
        const struct chip *chip = machine_parts[i].chip;
        if (!check_slots(r.b, &was, &rng, i))
            fail_msg("part %s has no live slot", chip->name);
        for (int k = 0; k < chip->count; k++)
            if (slots_has_column(&chip->columns[k], slots_at(r.b, i)->groups) &&
                !check_column(r.b, &was, &rng, i, &chip->columns[k]))
                fail_msg("part %s has no live slot", chip->name);
        if (slots_at(r.b, i)->live_bits)
            assert_true(dead_slot(r.b, i) != NO_SLOT);
    }
    assert_true(was.all == board_hash(r.b));
    rig_close(&r);
}

/* Columns of a group that the manifest does not ask for take no RAM, and registers are not hashed. */
TEST(groups)
{
    struct rig_game few, many;
    struct rig a, b;
    int there = 0;

    rig_script(&few, NULL, "");
    write_scene(&many);
    rig_power(&a, &few, NULL);
    rig_power(&b, &many, &in_scene);
    const struct sums was = sums_of(a.b);
    for (int i = 0; i < PART_COUNT; i++) {
        const struct chip *chip = machine_parts[i].chip;
        const struct slots *s = slots_at(a.b, i), *t = slots_at(b.b, i);
        for (int k = 0; k < chip->count; k++) {
            const struct column *c = &chip->columns[k];
            if (c->group == 0)
                continue;
            assert_false(slots_has_column(c, s->groups));
            if (c->is_register) {
                flip(a.b, &was, bytes_at(a.b, i, c), 0, -1, c->name);
                continue;
            }
            assert_null(bytes_at(a.b, i, c));
            if (slots_has_column(c, t->groups))
                assert_non_null(bytes_at(b.b, i, c)), there++;
        }
    }
    assert_true(there >= 3 * MAX_VALUES);
    rig_close(&a);
    rig_close(&b);
}

/* What is derived, and rewritten in every frame, may be anything before: no frame after differs. */
TEST(derived)
{
    struct rig_game g;
    struct rig a, b;

    write_scene(&g);
    rig_power(&a, &g, &in_scene);
    rig_power(&b, &g, &in_scene);
    for (int f = 0; f < 120; f++) {
        rig_run(&a, 1);
        b.b->bullets.n_moved = 77;
        b.b->shots.n_moved = 99;
        b.b->laser_heads.n_moved = 11;
        b.b->laser_heads.work_done = 12;
        for (int p = 0; p < MAX_PLAYERS; p++)
            b.b->player.prev_x[p] = b.b->player.prev_y[p] = (fx)(f * 65536);
        for (uint32_t i = 0; i < b.b->items.s.cap; i++)
            b.b->items.prev_x[i] = b.b->items.prev_y[i] = (fx)(f * 65536);
        assert_int_equal(b.b->tasks.current, NO_SLOT);
        rig_run(&b, 1);
        if (rig_differs(&a, &b))
            fail_msg("frame %d: part %s differs", f, rig_differs(&a, &b));
    }
    rig_free(&a);
    rig_close(&b);
}

/* bullet_kinds.live_count: how many live bullets have each kind. */
static void count_again(const struct bullets *s, const struct bullet_kinds *k)
{
    static uint32_t n[MAX_KINDS];

    memset(n, 0, sizeof n);
    EACH_LIVE (i, &s->s)
        n[s->kind[i]]++;
    assert_ptr_equal(s->kind_counts, k->live_count);
    for (uint32_t i = 0; i < k->s.live; i++)
        assert_int_equal(k->live_count[i], n[i]);
}

static void check_counts(const struct board *b)
{
    count_again(&b->bullets, &b->bullet_kinds);
    count_again(&b->shots, &b->shot_kinds);
}

/* tasks.next, prev, first, last: the live slots by serial. */
static void check_links(const struct tasks *t)
{
    uint32_t n = 0, before = UINT32_MAX;

    for (uint32_t i = t->first; i != UINT32_MAX; before = i, i = t->next[i], n++) {
        assert_true(slots_has(&t->s, i, t->s.gen[i]));
        assert_int_equal(t->prev[i], before);
        if (before != UINT32_MAX)
            assert_true(t->serial[before] < t->serial[i]);
    }
    assert_int_equal(t->last, before);
    assert_int_equal(n, t->s.live);
}

/* Bullets of two kinds are fired, get the other kind, wait, are hit, cleared and fly away. */
TEST(counts)
{
    static const char script[] =
        "bullet.def('one', { sprite = 'dot', hit = { circle = 3 }, cloud = 'wink' })\n"
        "bullet.def('two', { sprite = 'dot', hit = { circle = 4 }, hp = 2, cloud = 'dot' })\n"
        "shot.def('bolt', { sprite = 'dot', hit = { circle = 3 } })\n"
        "player.def('ship', { sprite = 'dot', hit = { circle = 9 }, graze = 16, lives = 9 })\n"
        "motion.def { name = 'm', { wait = 9 }, { kind = 'two' }, { wait = 8 }, { kind = 'one', speed = 2, over = 5 "
        "},\n"
        "  { die = true } }\n"
        "string.sys.join(1, 'ship')\n"
        "task.go(function() while true do\n"
        "  for k = 1, 6 do\n"
        "    local b = bullet.fire { kind = k % 2 == 0 and 'one' or 'two', x = 40 * k, y = 360, dir = 50 * k,\n"
        "                            speed = k * k, delay = k // 2, motion = k == 3 and 'm' or nil }\n"
        "    shot.fire { kind = 'bolt', x = 40 * k, y = 370, dir = 270, speed = 9 }\n"
        "    if k == 4 then b.kind = 'two' end\n"
        "  end\n"
        "  if board.frame() % 50 == 0 then bullet.clear() end\n"
        "  wait(1)\n"
        "end end)\n";
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;
    int some = 0;

    m.has_hp = 1;
    rig_with_sys(&g, &m, script);
    rig_power(&r, &g, NULL);
    for (int f = 0; f < 300; f++) {
        rig_run(&r, 1);
        if (f % 70 == 50)
            rig_spoil(&r);
        check_counts(r.b);
        some += r.b->bullets.s.live && r.b->shots.s.live;
    }
    assert_true(some > 200);
    rig_close(&r);
}

TEST(torture)
{
    struct rig_game g;
    struct rig r;
    struct rng rng;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    rig_folder(&g, "torture");
    rig_power(&r, &g, NULL);
    rng_seed(&rng, 11);
    for (int f = 0; f < 600; f++) {
        rig_pads(&rng, pads);
        rig_tick(&r, pads);
        check_counts(r.b);
        check_links(&r.b->tasks);
    }
    rig_close(&r);
}

RUN_TESTS(NULL, NULL)

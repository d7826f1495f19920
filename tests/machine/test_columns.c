/*
 * test_columns.c - the column tables: complete, and what they say of each column is so. Every bit of state is hashed by
 * one part, in live slots alone; what is not hashed has its reason.
 *
 * That no member was forgotten is seen by reading the headers: every member of a chip's struct stands in its table.
 */
#include <ctype.h>
#include "rig.h"

/* ---- the tables against the headers ---- */

/* Where each chip's struct is declared. */
struct home {
    const char *chip, *file, *name;
    size_t size;
};

#define HOME(chip, file, name)                                                                                         \
    {                                                                                                                  \
        chip, "src/" file, #name, sizeof(struct name)                                                                  \
    }
static const struct home homes[] = {
    HOME("script", "machine/machine.h", script),
    HOME("board", "machine/machine.h", core),
    HOME("input", "machine/input.h", input),
    HOME("tasks", "machine/task_table.h", tasks),
    HOME("bullets", "entities/bullets.h", bullets),
    HOME("bullet_kinds", "entities/bullets.h", bullet_kinds),
    HOME("shots", "entities/bullets.h", bullets),
    HOME("shot_kinds", "entities/bullets.h", bullet_kinds),
    HOME("enemies", "entities/enemies.h", enemies),
    HOME("enemy_kinds", "entities/enemies.h", enemy_kinds),
    HOME("player", "entities/player.h", player),
    HOME("player_kinds", "entities/player.h", player_kinds),
    HOME("motions", "entities/motion.h", motions),
    HOME("steps", "entities/motion.h", steps),
    HOME("sprites", "entities/sprites.h", sprites),
    HOME("fix", "entities/fix.h", fix),
    HOME("pal", "machine/video/pal.h", pal),
    HOME("nvram", "machine/nvram.h", nvram),
    HOME("sparks", "entities/sparks.h", sparks),
    HOME("spark_kinds", "entities/sparks.h", spark_kinds),
    HOME("items", "entities/items.h", items),
    HOME("item_kinds", "entities/items.h", item_kinds),
    HOME("lines", "entities/lines.h", lines),
    HOME("bg", "entities/bg.h", bg),
    HOME("bg_lines", "entities/bg.h", bg_lines),
    HOME("bg_shades", "entities/bg.h", bg_shades),
    HOME("screen", "machine/video/screen.h", screen),
    HOME("lasers", "entities/lasers.h", lasers),
    HOME("laser_heads", "entities/bullets.h", bullets),
    HOME("laser_kinds", "entities/lasers.h", laser_kinds),
    HOME("laser_points", "entities/lasers.h", laser_points),
    HOME("registers", "entities/registers.h", registers),
    HOME("options", "entities/options.h", options),
    HOME("option_kinds", "entities/options.h", option_kinds),
    HOME("option_ways", "entities/options.h", option_paths),
    HOME("music", "sound/seq.h", seq),
    HOME("cues", "sound/seq.h", cues),
    HOME("voices", "sound/voices.h", voices),
    HOME("bulletml", "entities/bulletml.h", ml_roots),
    HOME("ml_runners", "entities/bulletml.h", ml_runners),
    HOME("ml_frames", "entities/bulletml.h", ml_frames),
    HOME("ml_params", "entities/bulletml.h", ml_params),
};

/* A file without its comments. */
static char *source(const char *path)
{
    FILE *f = fopen(path, "rb");
    static char text[1 << 16];

    if (!f)
        fail_msg("%s: run this in the repository's root", path);
    size_t n = fread(text, 1, sizeof text - 1, f);
    fclose(f);
    text[n] = 0;
    for (char *p = text, *end; (p = strstr(p, "/*")) != NULL;) {
        end = strstr(p, "*/");
        assert_non_null(end);
        memset(p, ' ', (size_t)(end + 2 - p));
    }
    return text;
}

/* The members of `struct NAME { ... };`: "name", "*name" for a pointer, "name[" for an array. */
static int members(const char *path, const char *name, char out[][40], char types[][40], int most)
{
    char head[64], word[40], type[40] = "";
    int n = 0;

    snprintf(head, sizeof head, "struct %s {", name);
    char *p = strstr(source(path), head), *end;
    if (!p)
        fail_msg("%s: no struct %s", path, name);
    p += strlen(head);
    end = strstr(p, "};");
    while (p < end) {
        size_t k = 0;
        bool pointer = false;
        while (isspace((unsigned char)*p) || *p == '*')
            pointer |= *p++ == '*';
        while (isalnum((unsigned char)*p) || *p == '_')
            word[k++] = *p++;
        word[k] = 0;
        while (isspace((unsigned char)*p))
            p++;
        if (*p == '(') { /* a list of fields, from which the table is made too */
            p = strchr(p, ')') + 1;
            while (isspace((unsigned char)*p))
                p++;
            continue;
        }
        if (*p == '[' || *p == ',' || *p == ';') {
            assert_true(n < most);
            snprintf(out[n], 40, "%s%.30s%s", pointer ? "*" : "", word, *p == '[' ? "[" : "");
            if (types)
                snprintf(types[n], 40, "%s", type);
            n++;
            while (*p != ',' && *p != ';')
                p++;
            p++;
            while (isspace((unsigned char)*p))
                p++;
        } else
            snprintf(type, sizeof type, "%s", word);
    }
    return n;
}

static const struct column *column_named(const struct chip *chip, const char *name)
{
    for (int i = 0; i < chip->count; i++)
        if (!strcmp(chip->columns[i].name, name))
            return &chip->columns[i];
    return NULL;
}

static void check_member(const struct chip *chip, const char *member)
{
    char name[40];
    bool pointer = member[0] == '*', array;

    snprintf(name, sizeof name, "%s", member + pointer);
    array = name[strlen(name) - 1] == '[';
    if (array)
        name[strlen(name) - 1] = 0;
    const struct column *c = column_named(chip, name);
    if (!c)
        fail_msg("chip %s: member %s is not in the column table", chip->name, name);
    assert_true(c->is_register == !pointer ||
                (c->is_register && c->kind == COL_DERIVED)); /* kind_counts: a pointer to another chip's */
    if (!pointer)
        assert_int_equal(c->n > 1, array);
}

/* No two columns share a byte, none reaches outside, and what is between is smaller than the alignment that makes it.
 */
static void check_bytes(const struct chip *chip, const struct home *home)
{
    uint8_t *of = calloc(home->size, 1);
    size_t gap = 0;

    memset(of, 1, sizeof(struct slots));
    for (int i = 0; i < chip->count; i++) {
        const struct column *c = &chip->columns[i];
        size_t n = c->is_register ? (size_t)c->width * c->n : sizeof(void *);
        assert_true(c->offset >= sizeof(struct slots) && c->offset + n <= home->size);
        assert_true(c->width == 1 || c->width == 2 || c->width == 4 || c->width == 8);
        for (size_t k = 0; k < n; k++) {
            if (of[c->offset + k])
                fail_msg("chip %s: column %s lies on another", chip->name, c->name);
            of[c->offset + k] = 1;
        }
    }
    for (size_t k = 0; k < home->size; k++) {
        gap = of[k] ? 0 : gap + 1;
        if (gap >= 8)
            fail_msg("chip %s: byte %zu of its struct is in no column", chip->name, k);
    }
    free(of);
}

TEST(tables)
{
    char names[64][40];

    assert_int_equal(sizeof homes / sizeof *homes, PART_COUNT);
    for (int i = 0; i < PART_COUNT; i++) {
        const struct chip *chip = machine_parts[i].chip;
        assert_string_equal(homes[i].chip, chip->name);
        int n = members(homes[i].file, homes[i].name, names, NULL, 64);
        assert_string_equal(names[0], "s");
        for (int k = 1; k < n; k++)
            check_member(chip, names[k]);
        if (n > 1) /* otherwise its members come from a list of fields */
            assert_int_equal(n - 1, chip->count);
        check_bytes(chip, &homes[i]);
        for (int k = 0; k < i; k++)
            assert_string_not_equal(machine_parts[k].chip->name, chip->name);
    }
}

/* Every chip's struct in struct board is a part, in the order of machine_parts[]. */
TEST(parts)
{
    char names[64][40], types[64][40];
    int n, first = 0;

    assert_true((int)PART_COUNT <= (int)MAX_PARTS);
    n = members("src/machine/machine.h", "board", names, types, 64);
    while (first < n && strcmp(names[first], "script"))
        first++;
    assert_int_equal(n - first, PART_COUNT);
    for (int i = 0; i < PART_COUNT; i++) {
        assert_string_equal(types[first + i], homes[i].name);
        if (i)
            assert_true(machine_parts[i].offset > machine_parts[i - 1].offset);
    }
    assert_int_equal(machine_parts[0].offset, offsetof(struct board, script));
}

TEST(reasons)
{
    for (int i = 0; i < PART_COUNT; i++)
        for (int k = 0; k < machine_parts[i].chip->count; k++) {
            const struct column *c = &machine_parts[i].chip->columns[k];
            assert_int_equal(c->kind == COL_DERIVED, c->reason != NULL);
            if (c->reason)
                assert_true(strlen(c->reason) > 10);
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
#define SCENE(DEF, DROP, REMOVE)                                                                                       \
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"                                                    \
    "shot.def('bolt', { sprite = 'arrow', hit = { box = { 4, 8 } }, turns = true })\n"                                 \
    "enemy.def('foe', { sprite = 'wink', hit = { box = { 9, 9 } }, hp = 50 })\n"                                       \
    "option.def('bead', { sprite = 'dot' })\n"                                                                         \
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, options = { kind = 'bead', levels = { { wide = {\n"    \
    "  { 9, 9 }, { -9, 9 }, { 0, 20 } } } } }, registers = { a = 1, b = { start = 2, max = 9 }, c = { drain = 1 } } "  \
    "})\n"                                                                                                             \
    "spark.def('glow', { sprite = 'dot', life = 500 })\n" DEF                                                          \
    "laser.def('ray', { strip = 'dot', width = 8, hit = { share = 1 } })\n"                                            \
    "motion.def { name = 'm', { loop = forever, { turn = 1, over = 9 }, { loop = 2, { wait = 3 } } } }\n"              \
    "stage.def('s', function()\n"                                                                                      \
    "  for i = 1, 20 do\n" DROP                                                                                        \
    "    local b = bullet.fire { kind = 'dot', x = 60 + i, y = 30, speed = 0.25, motion = 'm', tag = 't' }\n"          \
    "    local s = shot.fire { kind = 'bolt', x = 50 + i, y = 200, speed = 0.5 }\n"                                    \
    "    local e = enemy.spawn { kind = 'foe', x = 20 + 9 * i, y = 20 }\n"                                             \
    "    local y = laser.beam { kind = 'ray', follow = e, length = 9, hold = 300, tag = 't' }\n"                       \
    "    local c = laser.curve { kind = 'ray', x = 50 + i, y = 60, speed = 0.5, motion = 'm', points = 40 }\n"         \
    "    local p = sprite.put { sprite = 'wink', x = i, y = i }\n"                                                     \
    "    local l = text.line { x = i, y = i, text = 'words' .. i, letter = 1 }\n"                                      \
    "    e:move { x = 100, y = 100, over = 100 }\n"                                                                    \
    "    spark.burst { kind = 'glow', x = 100, y = 100, n = 2, speed = 0.5 }\n"                                        \
    "    task.go(function() wait(10 + i) if i % 2 == 0 then b:remove() s:remove() e:remove() p:remove() l:remove() "   \
    "c:remove() "                                                                                                      \
    "end "                                                                                                             \
    "wait(i) "                                                                                                         \
    "end)\n"                                                                                                           \
    "  end\n" REMOVE "  text.put { col = 1, row = 1, text = 'words' }\n"                                               \
    "  palette.fade { to = 0, over = 99 } palette.cycle { first = 3, last = 9, every = 5 }\n"                          \
    "  save.set('key', 1)\n"                                                                                           \
    "  screen.shake { size = 3, over = 99 }\n"                                                                         \
    "  wait(forever)\n"                                                                                                \
    "end)\n"                                                                                                           \
    "boot.run { stages = { 's' }, players = { 'ship' } }\n"
static const char scene[] = SCENE(
    "item.def('gem', { sprite = 'dot', radius = 5, gives = { score = { 1, 5 }, lives = 2, a = 3 }, full = 'b' })\n",
    "    item.drop { kind = 'gem', x = 50 + i, y = 30, speed = 0.5, tag = 'gem' .. i % 2 }\n",
    "  task.go(function() wait(12) item.group('gem0'):remove() end)\n"
    "  bg.lines(2, { 1, 2, 3 })\n"
    "  bg.plane().fog = { to = 0, far = 9 }\n"
    "  for i = 1, 6 do\n"
    "    local d = bullet.ml { name = 'doc', kind = 'dot', x = 100, y = 20 * i }\n"
    "    task.go(function() wait(i) if i % 2 == 0 then d:stop() end end)\n"
    "  end\n");
static const char document[] =
    "<bulletml><action label='top'><repeat><times>9</times><action><fire><bulletRef label='b'><param>$rand*90</param>"
    "</bulletRef></fire><wait>1</wait></action></repeat></action><bullet label='b'><speed>0.3</speed><action><repeat>"
    "<times>3</times><action><changeDirection><direction type='sequence'>$1</direction><term>50</term>"
    "</changeDirection><wait>3+$rand*9</wait></action></repeat><vanish/></action></bullet></bulletml>";
static const char without_items[] = SCENE("", "", "");

TEST(flips)
{
    struct manifest m = rig_manifest();
    struct board_start start = { .seed = 1, .difficulty = -1, .practice.section = "s" };
    struct rig_game g;
    struct rig r;
    struct rng rng;

    m.tasks = 128;
    m.sprites = 128;
    m.shots = m.enemies = 128;
    m.bullet_values = m.shot_values = m.enemy_values = MAX_VALUES;
    m.has_hp = m.has_orbit = m.has_freeze = m.bullets_can_meet = m.has_wide_text = m.has_backgrounds = m.has_bodies =
        m.has_pierce = 1;
    m.options = 192;
    m.items = m.lines = m.lasers = 192; /* of two bits: with one flipped the part is still there */
    m.curve_points = 96 * 64;
    m.has_sound = 1;
    m.bulletml_runners = 192;
    rig_script(&g, &m, scene);
    rig_sounds(&g);
    rig_document(&g, "doc", document);
    rig_power(&r, &g, &start);
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
    rig_free(&r);
    rig_game_free(&g);
}

/* Columns of a group that the manifest does not ask for take no RAM. */
TEST(groups)
{
    struct manifest m = rig_manifest(), all;
    struct board_start start = { .seed = 1, .difficulty = -1, .practice.section = "s" };
    struct rig_game few, many;
    struct rig a, b;
    int there = 0;

    m.lasers = 128;
    m.curve_points = 4096;
    m.options = 64;
    all = m;
    all.bullet_values = all.shot_values = all.enemy_values = MAX_VALUES;
    all.has_hp = all.has_orbit = all.has_freeze = all.bullets_can_meet = all.has_backgrounds = all.has_bodies =
        all.has_pierce = 1;
    all.items = 64;
    all.bulletml_runners = 64;
    rig_script(&few, &m, without_items);
    rig_script(&many, &all, scene);
    rig_document(&many, "doc", document);
    rig_power(&a, &few, &start);
    rig_power(&b, &many, &start);
    const struct sums was = sums_of(a.b);
    for (int i = 0; i < PART_COUNT; i++) {
        const struct chip *chip = machine_parts[i].chip;
        const struct slots *s = slots_at(a.b, i), *t = slots_at(b.b, i);
        for (int k = 0; k < chip->count; k++) {
            const struct column *c = &chip->columns[k];
            if (c->group == 0)
                continue;
            assert_false(slots_has_column(c, s->groups));
            if (c->is_register) { /* it is in the struct, but is not hashed */
                flip(a.b, &was, bytes_at(a.b, i, c), 0, -1, c->name);
                continue;
            }
            assert_null(bytes_at(a.b, i, c));
            if (slots_has_column(c, t->groups))
                assert_non_null(bytes_at(b.b, i, c)), there++;
        }
        if (chip == &bullets_chip)
            assert_true(slots_size(chip, s->cap, s->groups) + 16 * (uint64_t)s->cap <=
                        slots_size(chip, t->cap, t->groups));
    }
    assert_true(there >= 3 * MAX_VALUES);
    rig_free(&a);
    rig_free(&b);
    rig_game_free(&few);
    rig_game_free(&many);
}

/* Derived columns are what they say: spoiling those that a frame rewrites changes no frame after. */
TEST(derived)
{
    struct board_start start = { .seed = 1, .difficulty = -1, .practice.section = "s" };
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig a, b;

    m.items = 64;
    m.has_backgrounds = 1;
    m.lines = 32;
    m.lasers = 128;
    m.curve_points = 4096;
    m.options = 64;
    m.bulletml_runners = 64;
    rig_script(&g, &m, scene);
    rig_document(&g, "doc", document);
    rig_power(&a, &g, &start);
    rig_power(&b, &g, &start);
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
    rig_free(&b);
    rig_game_free(&g);
}

/* How many live bullets have each kind. */
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

static void count_both(const struct board *b)
{
    count_again(&b->bullets, &b->bullet_kinds);
    count_again(&b->shots, &b->shot_kinds);
}

/* bullet_kinds.live: kept up to date by what fires bullets, gives them another kind, holds them and takes them away. */
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
    struct rng rng;
    uint16_t pads[MAX_PLAYERS] = { 0 };
    int some = 0;

    m.has_hp = 1;
    rig_with_sys(&g, &m, script);
    rig_power(&r, &g, NULL);
    for (int f = 0; f < 300; f++) {
        rig_run(&r, 1);
        if (f % 70 == 50)
            rig_spoil(&r); /* and restores a snapshot */
        count_both(r.b);
        some += r.b->bullets.s.live && r.b->shots.s.live;
    }
    assert_true(some > 200);
    rig_free(&r);
    rig_game_free(&g);
    rig_folder(&g, "torture");
    rig_power(&r, &g, NULL);
    rng_seed(&rng, 11);
    for (int f = 0; f < 600; f++) {
        rig_pads(&rng, pads);
        rig_tick(&r, pads);
        count_both(r.b);
    }
    rig_free(&r);
    rig_game_free(&g);
}

/* tasks.next, prev, first, last: the live slots by serial. */
TEST(links)
{
    struct rig_game g;
    struct rig r;
    struct rng rng;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    rig_folder(&g, "torture");
    rig_power(&r, &g, NULL);
    rng_seed(&rng, 9);
    for (int f = 0; f < 600; f++) {
        const struct tasks *t = &r.b->tasks;
        uint32_t n = 0, before = UINT32_MAX;
        for (uint32_t i = t->first; i != UINT32_MAX; before = i, i = t->next[i], n++) {
            assert_true(slots_has(&t->s, i, t->s.gen[i]));
            assert_int_equal(t->prev[i], before);
            if (before != UINT32_MAX)
                assert_true(t->serial[before] < t->serial[i]);
        }
        assert_int_equal(t->last, before);
        assert_int_equal(n, t->s.live);
        rig_pads(&rng, pads);
        rig_tick(&r, pads);
    }
    rig_free(&r);
    rig_game_free(&g);
}

RUN_TESTS(NULL, NULL)

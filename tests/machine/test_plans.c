/*
 * test_plans.c - arguments that are read by a plan (api_plan.c) are those that are read without one: the same results,
 * messages, digests and states, whatever stands in the table, and whatever stands among the guesses.
 */
#include "rig.h"
#include "../../src/script/api/eval.h"

static const char scene[] = "value.def('curl')\n"
                            "value.def('fade', { start = 2 })\n"
                            "bullet.def('dot', { sprite = 'dot', hit = { circle = 2 } })\n"
                            "bullet.def('arrow', { sprite = 'arrow', hit = { circle = 2 }, turns = true })\n"
                            "shot.def('bolt', { sprite = 'dot', hit = { circle = 2 } })\n"
                            "enemy.def('fly', { sprite = 'dot', hp = 5, hit = { circle = 8 } })\n"
                            "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
                            "spark.def('ember', { sprite = 'dot', life = 9 })\n"
                            "item.def('coin', { sprite = 'dot', radius = 4 })\n"
                            "string.way = motion.def { name = 'way', { turn = 1, over = 60 } }\n"
                            "task.go(function()\n"
                            "  string.sys.join(1, 'ship')\n"
                            "  string.foe = enemy.spawn { kind = 'fly', x = 100, y = 50, tag = 'flies' }\n"
                            "  string.gone = bullet.fire { kind = 'dot', x = 1, y = 9, speed = 1 }\n"
                            "  string.gone:remove()\n"
                            "end)\n";

struct bed {
    struct rig_game g;
    struct rig r;
    uint8_t *image;
    struct rng rng;
    char line[2][1 << 14];
    size_t n;
};

static int bed_open(void **state)
{
    struct bed *t = calloc(1, sizeof *t);
    struct manifest m = rig_manifest();

    m.bullet_values = 2;
    m.has_orbit = true;
    m.items = 32;
    m.lasers = 16;
    m.curve_points = 256;
    rig_with_sys(&t->g, &m, scene);
    rig_power(&t->r, &t->g, NULL);
    rig_run(&t->r, 5);
    rng_seed(&t->rng, 18);
    *state = t;
    return 0;
}

static int bed_close(void **state)
{
    struct bed *t = *state;

    free(t->image);
    rig_free(&t->r);
    rig_game_free(&t->g);
    free(t);
    return 0;
}

static void keep(struct bed *t)
{
    t->image = realloc(t->image, board_snapshot_size(t->r.b));
    board_save(t->r.b, t->image);
}

/* ---- random lines ---- */

static uint32_t below(struct bed *t, uint32_t n)
{
    return (uint32_t)(rng_next(&t->rng) % n);
}

static void put(struct bed *t, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    t->n += (size_t)vsnprintf(t->line[0] + t->n, sizeof t->line[0] - t->n, format, args);
    va_end(args);
    assert_true(t->n < sizeof t->line[0]);
}

#define PICK(t, list) (list)[below((t), sizeof(list) / sizeof *(list))]

static void put_junk(struct bed *t)
{
    static const char *const junk[] = {
        "nil",        "0/0",   "1/0",   "1e300",          "-0.0",     "math.mininteger",
        "0.5",        "true",  "''",    "'a\\0b'",        "{ 1, 2 }", "print",
        "'12'",       "-1",    "70000", "string.foe",     "'x'",      "string.gone",
        "string.way", "'fly'", "32768", "function() end", "forever",
    };

    put(t, "%s", PICK(t, junk));
}

static const struct {
    int type;
    const char *text[3];
} words[] = {
    { A_BOOL, { "true", "false" } },         { A_THING, { "string.foe", "string.gone", "player.get(1)" } },
    { A_MOTION, { "string.way", "'way'" } }, { A_BULLET_KIND, { "'dot'", "'arrow'" } },
    { A_SPRITE, { "'dot'", "'arrow'" } },    { A_SHOT_KIND, { "'bolt'" } },
    { A_ENEMY_KIND, { "'fly'" } },           { A_SPARK_KIND, { "'ember'" } },
    { A_ITEM_KIND, { "'coin'" } },           { A_FUNC, { "function() end" } },
    { A_SPAN, { "{ 1, 2 }", "{ 1, 8 }" } },
};

static void put_word(struct bed *t, int type)
{
    static const char *const others[] = { "'dot'", "'arrow'", "'fly'", "'flies'", "'bullet'", "'shot'" };
    uint32_t n = 0;

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (words[i].type == type) {
            while (n < 3 && words[i].text[n])
                n++;
            put(t, "%s", words[i].text[below(t, n)]);
            return;
        }
    put(t, "%s", PICK(t, others));
}

/* One that p may take, or nearly. */
static void put_value(struct bed *t, const struct api_param *p)
{
    const double span = p->hi - p->lo;

    if (below(t, 50) == 0) {
        put_junk(t);
        return;
    }
    switch ((int)p->type) {
    case A_INT:
    case A_COUNT:
        put(t, "%.0f", p->lo + (span < 40 ? below(t, (uint32_t)span + 1) : below(t, 40)));
        break;
    case A_NUM:
    case A_FX:
        if (below(t, 4) == 0)
            put(t, "%.17g", below(t, 2) ? p->lo : p->hi);
        else
            put(t, below(t, 2) ? "%.3f" : "%.0f", p->lo < 0 ? (double)below(t, 200) - 50 : p->lo + below(t, 9) / 4.0);
        break;
    case A_SCALE:
        put(t, "%g", (1 + below(t, 34)) / 8.0);
        break;
    case A_DIR:
        put(t, below(t, 2) ? "%d" : "%d.25", (int)below(t, 1000) - 500);
        break;
    default:
        put_word(t, p->type);
    }
}

/* What a table may have besides. */
static void put_odd(struct bed *t, const char *name)
{
    switch (below(t, 9)) {
    case 0:
        put(t, "t[%d] = 1 ", (int)below(t, 3));
        break;
    case 1:
        put(t, "t.%.*ss = 1 ", (int)strlen(name), name);
        break;
    case 2:
        put(t, "t[%s] = 1 ", below(t, 2) ? "1.5" : "{}");
        break;
    case 3:
        put(t, "setmetatable(t, { __index = function() return 7 end, __len = function() return 3 end }) ");
        break;
    case 4:
        put(t, "t[true] = 1 ");
        break;
    case 5:
        put(t, "t.curl, t.fade = 0.5, %s ", below(t, 8) ? "1" : "'x'");
        break;
    case 6:
        put(t, "t[('%s'):rep(9)] = 1 ", name);
        break;
    default:
        put(t, "t[('%.1s') .. '%s'] = t.%s t.more = 1 t.more = nil ", name, name + 1, name);
    }
}

/* Does the function take arguments by name, and can it be called whenever it is? */
static bool fits(const struct api_entry *e)
{
    const unsigned never = API_LOAD_ONLY | API_METHOD | API_SYS | API_VARARGS;
    const bool lua = e->flags & API_LUA && !(e->flags & API_PATTERN); /* volleys are patterns' */

    return e->count > e->positional_count && !(e->flags & never) && !lua &&
           !api_disabled_reason(&(struct manifest){ 0 }, e->name);
}

/* A parameter of what e fires has the number it has behind e's own. */
static const struct api_param *param(const struct api_entry *e, const struct api_entry *fire, int i)
{
    return i < e->count ? &e->params[i] : &fire->params[i - e->count];
}

static const struct api_entry *entry_named(const char *name)
{
    for (int i = 0; i < api_count_entries(&api_table); i++)
        if (!strcmp(api_get_entry(&api_table, i)->name, name))
            return api_get_entry(&api_table, i);
    return NULL;
}

/* A place is x and y, or from a thing. */
static bool often(const struct api_param *p)
{
    return !p->optional || !strcmp(p->name, "x") || !strcmp(p->name, "y");
}

static bool seldom(const struct api_param *p)
{
    return !strcmp(p->name, "from") || !strncmp(p->name, "to_", 3) || !strcmp(p->name, "around");
}

/* `local t = { .. } .. print(f(t))`; good: nothing of it is wrong on purpose. */
static void put_call(struct bed *t, const struct api_entry *e, bool good)
{
    const struct api_entry *fire = e->flags & API_PATTERN ? entry_named("bullet.fire") : NULL;
    const int n = e->count + (fire ? fire->count : 0), from = (int)below(t, (uint32_t)n);

    put(t, "do local t = { ");
    for (int k = 0; k < n; k++) {
        const struct api_param *p = param(e, fire, (from + k) % n);
        if ((from + k) % n < e->positional_count ||
            (often(p) ? !good && below(t, 24) == 0 : below(t, seldom(p) ? 24 : 4) > 0))
            continue;
        put(t, "%s = ", p->name);
        put_value(t, p);
        put(t, ", ");
    }
    put(t, "} ");
    if (!good && below(t, 4) == 0)
        put_odd(t, e->params[e->positional_count + (int)below(t, (uint32_t)(e->count - e->positional_count))].name);
    if (!good && below(t, 8) == 0)
        put(t, "t.%s = nil ",
            e->params[e->positional_count + (int)below(t, (uint32_t)(e->count - e->positional_count))].name);
    put(t, "print(%s(", e->name);
    for (int i = 0; i < e->positional_count; i++) {
        put_value(t, &e->params[i]);
        put(t, ", ");
    }
    put(t, below(t, 40) ? "t)) end " : "t, t)) end ");
}

/* ---- both ways ---- */

struct end {
    bool fine;
    char out[EVAL_TEXT_SIZE];
    uint64_t hash, digest, calls;
};

static struct end *run(struct bed *t, bool plain, bool rubbish, struct end *end)
{
    struct board *b = t->r.b;

    board_restore(b, t->image);
    b->vm.skips_plans = plain;
    for (size_t i = 0; rubbish && i < sizeof b->vm.guesses; i++)
        ((uint8_t *)&b->vm.guesses)[i] = (uint8_t)rng_next(&t->rng);
    memset(end->out, 0, sizeof end->out);
    end->fine = board_eval(b, t->line[0], end->out, sizeof end->out);
    if (end->fine)
        rig_run(&t->r, 1);
    end->hash = board_hash(b);
    end->digest = b->script.digest;
    end->calls = b->script.calls;
    return end;
}

static void expect_equal(struct bed *t, const struct end *a, const struct end *b)
{
    if (a->fine != b->fine || strcmp(a->out, b->out))
        fail_msg("by a plan: %s; without: %s; %s", a->out, b->out, t->line[0]);
    if (a->fine && (a->hash != b->hash || a->digest != b->digest || a->calls != b->calls))
        fail_msg("by a plan the state is another: %s", t->line[0]);
}

/* Calls each entry so often that it has a plan. Those that end in an error have none: their tables were wrong. */
static void warm(struct bed *t, const struct api_entry *e)
{
    static struct end end;

    for (int k = 0, fine = 0; k < 200 && fine < 24; k++) {
        keep(t);
        t->n = 0;
        put_call(t, e, true);
        if (run(t, false, false, &end)->fine)
            fine++;
        else
            board_restore(t->r.b, t->image);
    }
    keep(t);
}

/* Every function that takes named arguments, with tables of all sorts. */
TEST(random)
{
    static struct end planned, plain;
    struct bed *t = *state;
    const int lines = rig_long() ? 5000 : 250;
    int fine = 0, wrong = 0;
    uint32_t used = 0;

    for (int i = 0; i < api_count_entries(&api_table); i++)
        if (fits(api_get_entry(&api_table, i)))
            warm(t, api_get_entry(&api_table, i));
    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const struct api_entry *e = api_get_entry(&api_table, i);
        for (int k = 0; fits(e) && k < lines; k++) {
            t->n = 0;
            for (uint32_t calls = 1 + below(t, 3); calls > 0; calls--)
                put_call(t, e, below(t, 3) == 0);
            const uint32_t before = t->r.b->vm.plan_count;
            run(t, false, below(t, 4) == 0, &planned);
            used += t->r.b->vm.plan_count != before;
            expect_equal(t, &planned, run(t, true, below(t, 4) == 0, &plain));
            fine += plain.fine;
            wrong += !plain.fine;
        }
    }
    if (getenv("TEST_SAYS"))
        printf("# %d lines ran, %d were refused, %u used a plan\n", fine, wrong, used);
    assert_true(fine > 5 * lines && wrong > 5 * lines && used > 5 * (uint32_t)lines);
}

/* A plan is used once there are calls enough, and is none of a state: neither hash nor digest has anything of it. */
TEST(used)
{
    struct bed *t = *state;
    char out[EVAL_TEXT_SIZE];
    struct board *b = t->r.b;
    const char *line = "for i = 1, 40 do bullet.fire { kind = 'dot', x = i, y = 2, speed = 1 } end";

    b->vm.plan_count = 0;
    assert_true(board_eval(b, line, out, sizeof out));
    assert_int_equal(b->vm.plan_count, 40 + 1 - 15); /* the scene fired one */
    b->vm.skips_plans = true;
    assert_true(board_eval(b, line, out, sizeof out));
    assert_int_equal(b->vm.plan_count, 40 + 1 - 15);
}

RUN_TESTS_EACH(bed_open, bed_close)

/*
 * prices.c - section "prices": what a bullet costs that does more than fly straight, and what an item does. One board a
 * price; those of a table are run in turns, with one whose bullets fly straight among them.
 */
#include <stdlib.h>
#include "bench.h"

enum { N = 4096, ROUNDS = 25, FRAMES = 8, ITEMS = 512 };

/* A value of the DIP price of roms/bench, or of one whose name goes on from it. */
struct price {
    const char *dip, *what;
    enum {
        PLAIN,
        GROUPS,  /* needs room for hp, around, frozen or a value */
        UNLISTED /* has no row of its own */
    } how;
};

/* The first row of each is what the others are beyond. */
static const struct price MOTION[] = {
    { "straight", "flies straight", PLAIN },
    { "accel", "runs `accel`", PLAIN },
    { "turn", "runs `turn`", PLAIN },
    { "drive", "runs `turn` and `speed`", PLAIN },
    { "aim", "runs `aim`", PLAIN },
    { "home", "runs `home`", PLAIN },
    { "go_to", "runs `go_to`", PLAIN },
    { "polar", "runs `polar`", PLAIN },
    { "orbit", "runs `orbit` around a point", PLAIN },
    { "around", "runs `orbit` around an entity (property `around`)", GROUPS },
    { "wave", "runs `wave`", PLAIN },
    { "bounce", "runs `bounce`, with no wall nearby", PLAIN },
    { "path", "runs `path`", PLAIN },
    { "await", "runs `wait_for` with `near`", PLAIN },
    { "signal", "runs `wait_for` with `tag`", PLAIN },
    { "named", "runs `turn` with a declared value", GROUPS },
    { "mixed", "runs one of ten programs, one for each op of `wait kind bank dir aim turn home speed accel loop`",
      PLAIN },
    { "fine", "is `fine` and flies straight", PLAIN },
    { "fine_drive", "is `fine` and runs `turn` and `speed`", PLAIN },
    { "frozen", "is `frozen`", GROUPS },
    { "delay", "waits for its `delay` to end", PLAIN },
    { "task", "has a Lua task that wakes in every frame", PLAIN },
    { "half", "", UNLISTED },
};

static const struct price SHAPES[] = {
    { "straight", "flies straight", PLAIN },
    { "circle", "has a circle as its hitbox, close to the player", PLAIN },
    { "box", "has a box as its hitbox, close to the player", PLAIN },
    { "capsule", "has a capsule as its hitbox, close to the player", PLAIN },
    { "circles", "has three circles as its hitbox, close to the player", PLAIN },
    { "turned_circles", "has three circles with `turns` as hitbox, close to the player", PLAIN },
    { "hp", "has hp, while 64 distant shots look for bullets with hp", GROUPS },
};

static const struct price VERBS[] = {
    { "straight", "flies straight", PLAIN },
    { "group", "is written through a group", PLAIN },
    { "value", "has a declared value written through a group", GROUPS },
    { "shift", "is shifted through a group", PLAIN },
    { "turn_all", "is turned through a group", PLAIN },
    { "aim_all", "is aimed through a group", PLAIN },
    { "each", "is visited by `bullet.each` and written", PLAIN },
    { "clear_circle", "is tested by a `clear` in a circle, but is outside it", PLAIN },
    { "clear_box", "is tested by a `clear` in a box, but is outside it", PLAIN },
    { "clear_line", "is tested by a `clear` along a line, but is not on it", PLAIN },
    { "sweep", "is tested by a `bullet.sweep`, but not reached", PLAIN },
    { "near", "is tested by `query.near`, but not found", PLAIN },
    { "near_box", "is tested by `query.box`, but not found", PLAIN },
    { "near_line", "is tested by `query.line`, but not found", PLAIN },
    { "found", "is found by `query.box`", PLAIN },
};

static const struct price FIRING[] = {
    { "fire", "`bullet.fire` with a table constructor in the call", PLAIN },
    { "kept", "`bullet.fire` with one table that is reused", PLAIN },
    { "valued", "`bullet.fire` with a table constructor and a declared value", GROUPS },
    { "ring", "`pattern.ring`", PLAIN },
    { "fan", "`pattern.fan`", PLAIN },
    { "arc", "`pattern.arc`", PLAIN },
    { "stack", "`pattern.stack`", PLAIN },
    { "line", "`pattern.line`", PLAIN },
    { "polygon", "`pattern.polygon`", PLAIN },
    { "star", "`pattern.star`", PLAIN },
    { "ellipse", "`pattern.ellipse`", PLAIN },
    { "rose", "`pattern.rose`", PLAIN },
    { "whip", "`pattern.whip`", PLAIN },
    { "scatter", "`pattern.scatter`", PLAIN },
    { "points", "`pattern.points`", PLAIN },
    { "dots", "`pattern.picture`", PLAIN },
    { "emit", "the `emit` step, with a ring", PLAIN },
};

/* A price being measured. */
struct run {
    struct scene scene;
    struct samples ns;
    double took;
};

static void measure(struct run *runs, const struct price *prices, int n)
{
    struct scene_want want = { .does = "prices", .n = N, .bullets = N };

    for (int i = 0; i < n; i++) {
        want.price = prices[i].dip;
        want.groups = prices[i].how == GROUPS;
        bench_scene(&runs[i].scene, &want);
    }
    for (int round = -1; round < ROUNDS; round++) { /* the first warms up */
        bench_look();
        for (int i = 0; i < n; i++) {
            struct run *r = &runs[i];
            bench_clock_for(r->took);
            for (int f = 0; f < FRAMES; f++) {
                double from = bench_now();
                bench_tick(&r->scene);
                r->took = bench_since(from);
                if (round >= 0 && f > 0) /* the first fetches its board into the caches */
                    samples_add(&r->ns, r->took);
            }
        }
    }
    bench_own_clock(false);
}

static void print_table(struct run *runs, const struct price *prices, int n, const char *columns)
{
    double first = samples_median(&runs[0].ns);

    report_table(NULL, columns);
    for (int i = 0; i < n; i++)
        if (prices[i].how != UNLISTED)
            report_row(i == 0, prices[i].what, samples_figure(&runs[i].ns, N),
                       i ? report_string("%s", report_figure((samples_median(&runs[i].ns) - first) / N)) : "",
                       i ? report_figure(samples_ratio(&runs[i].ns, &runs[0].ns)) : "", NULL);
    report_table_end();
}

static void free_runs(struct run *runs, int n)
{
    for (int i = 0; i < n; i++) {
        samples_free(&runs[i].ns);
        scene_close(&runs[i].scene);
    }
    free(runs);
}

/* Measures a table's prices and prints it. The runs are the caller's to free. */
static struct run *print_prices(const struct price *prices, int n, const char *columns)
{
    struct run *runs = calloc((size_t)n, sizeof *runs);

    if (!runs)
        report_fail("out of memory");
    measure(runs, prices, n);
    print_table(runs, prices, n, columns);
    return runs;
}

static void print_motion(void)
{
    enum { COUNT = sizeof MOTION / sizeof *MOTION, HALF = COUNT - 1 };
    struct run *runs = print_prices(MOTION, COUNT, "a bullet that | total> | difference> | ratio>");
    double half = samples_median(&runs[HALF].ns) / 1e3;

    report_text("If half of the %s bullets run these ten programs, in equal numbers and with an op active in every "
                "frame, the tick takes **%s µs**.",
                report_count(N), samples_figure(&runs[HALF].ns, 1e3));
    bench_target("the tick of 4,096 bullets, half of which run motion programs", "60 µs",
                 report_string("%s µs", report_figure(half)), half < 60);
    free_runs(runs, COUNT);
}

static void print_others(const struct price *prices, int n, const char *columns)
{
    free_runs(print_prices(prices, n, columns), n);
}

/* What of it is C: the chip's own function, without a script, its arguments or its digest. */
static void fire_in_c(void)
{
    struct bullet_spec shape = { .x = 128 << 16, .y = 8 << 16, .speed = 66 };
    struct samples ns = { 0 };
    struct scene s;

    bench_scene(&s, &(struct scene_want){ .does = "prices", .price = "straight", .n = 0, .bullets = N });
    for (int round = -2; round < ROUNDS; round++) {
        const double from = bench_now();
        for (int i = 0; i < N; i++) {
            shape.dir = (ang)i * 0x01000193;
            bullets_fire(&s.b->bullets, &shape, s.b->core.clock);
        }
        if (round >= 0)
            samples_add(&ns, bench_since(from));
        bench_claim(s.b->bullets.s.live == N ? NULL : "there was no room", "firing in C");
        for (uint32_t i = 0; i < N; i++)
            bullets_drop(&s.b->bullets, i);
        slots_trim(&s.b->bullets.s);
    }
    report_text("**C only.** Everything in this table calls the C function `bullets_fire`, which takes %s ns. "
                "`bullets_fire` finds a free slot, computes the velocity from the direction, and writes all columns. "
                "The rest of a `bullet.fire` call is spent on Lua, on reading and checking arguments, on the "
                "[digest](../internals/design.md#snapshots-and-hashes) of the call, and on the one frame for which the "
                "bullet lives.",
                samples_figure(&ns, N));
    samples_free(&ns);
    scene_close(&s);
}

/* What an item costs: a tick with so many more of them, and their pictures. */
static void item_prices(void)
{
    static const struct {
        const char *does, *what;
        int n;
    } rows[] = { { "straight", NULL, 0 }, { "straight", "falls", ITEMS }, { "home", "flies to the ship", ITEMS } };
    enum { ROWS = sizeof rows / sizeof *rows };
    struct scene s[ROWS];
    struct samples tick[ROWS] = { { 0 } }, draw[ROWS] = { { 0 } };

    for (int i = 0; i < ROWS; i++)
        bench_scene(&s[i],
                    &(struct scene_want){ .does = "items", .price = rows[i].does, .n = rows[i].n, .bullets = 64 });
    for (int round = -2; round < ROUNDS; round++)
        for (int i = 0; i < ROWS; i++)
            for (int f = 0; f < FRAMES; f++) {
                double from = bench_now();
                bench_tick(&s[i]);
                double ticked = bench_now();
                scene_draw(&s[i]);
                if (round < 0 || f == 0)
                    continue;
                samples_add(&tick[i], ticked - from);
                samples_add(&draw[i], bench_now() - ticked);
            }
    report_text("**Items.** The next table shows how many nanoseconds each of %s items of 12 px adds to a frame.",
                report_count(ITEMS));
    report_table(NULL, "an item that | tick> | draw>");
    for (int i = 1; i < ROWS; i++)
        report_row(i == 1, rows[i].what, report_figure((samples_median(&tick[i]) - samples_median(&tick[0])) / ITEMS),
                   report_figure((samples_median(&draw[i]) - samples_median(&draw[0])) / ITEMS), NULL);
    report_table_end();
    for (int i = 0; i < ROWS; i++) {
        samples_free(&tick[i]);
        samples_free(&draw[i]);
        scene_close(&s[i]);
    }
}

void section_prices(void)
{
    report_section("Cost per bullet");
    report_text(
        "The table shows the nanoseconds that a tick takes per bullet. There are %s bullets, which all do the same "
        "thing in every frame. Nothing is drawn, and no bullet comes near the player unless the row says so.",
        report_count(N));
    print_motion();
    report_text("**Hits.** In the next table, a bullet *close* to the player needs the exact test in every frame, but "
                "never touches the player.");
    print_others(SHAPES, sizeof SHAPES / sizeof *SHAPES, "a bullet that | total> | difference> | ratio>");
    report_text("**Scripts.** In the next table, a script acts on all bullets once per frame.");
    print_others(VERBS, sizeof VERBS / sizeof *VERBS, "a bullet that | total> | difference> | ratio>");
    report_text("**Firing.** The next table shows the nanoseconds that firing takes per bullet. Patterns fire 64 "
                "bullets at a time. Each bullet despawns in the frame in which it is fired.");
    print_others(FIRING, sizeof FIRING / sizeof *FIRING, "fired by | total> | difference> | ratio>");
    fire_in_c();
    floor_prices();
    item_prices();
    looks_prices();
}

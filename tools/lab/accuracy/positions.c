/*
 * positions.c - section 3: what a position is kept in. Straight flight for up to a million frames, and a pattern moved
 * by whole pixels.
 *
 * Each format has LANES bullets: every speed with every heading. The world wraps, so that fast bullets can be followed
 * as long as slow ones: a fixed-point position by its own overflow, a floating one by a step across the world that is
 * exact. Where a bullet ought to be is start + frames * velocity in doubles, good to 1e-8 px after the whole way; drift
 * is the distance from there, on the wrapped world.
 */
#include <math.h>
#include <string.h>
#include "engine.h"
#include "lab.h"

enum { HEADINGS = 64, SPEEDS = 8, LANES = HEADINGS * SPEEDS, BLOCK = 64, TIMED = LAB_VALUES, SPANS = 9 };

static const double SPEED[SPEEDS] = { 0.002, 0.01, 0.1, 1, 3, 8, 20, 64 };
static const double SPAN[SPANS] = { 1, 10, 100, 600, 3600, 36000, 100000, 300000, 1000000 };
enum { AT_600 = 3, AT_36000 = 5, AT_MILLION = 8 };
static const double START_X = 192, START_Y = 112;

/* Where bullets start and how they fly, in px; LANES of the drift, 65,536 of the timing. */
struct lanes {
    int n;
    double x[TIMED], y[TIMED], vx[TIMED], vy[TIMED];
    fx speed[TIMED];
    ang dir[TIMED];
};
static struct lanes lanes;

static union {
    struct {
        int32_t x[TIMED], y[TIMED], vx[TIMED], vy[TIMED];
    } i32;
    struct {
        int64_t x[TIMED], y[TIMED], vx[TIMED], vy[TIMED];
    } i64;
    struct {
        float x[TIMED], y[TIMED], vx[TIMED], vy[TIMED];
    } f32;
    struct {
        double x[TIMED], y[TIMED], vx[TIMED], vy[TIMED];
    } f64;
} now;
static uint8_t out[TIMED];
static struct board *plain, *fine;

/* ---- fixed point ---- */

/* v in units of 2^-bits, to the nearest. */
static int64_t units(double v, int bits)
{
    return (int64_t)floor(v * (double)(1ll << bits) + 0.5);
}

static void start32(int bits)
{
    for (int i = 0; i < lanes.n; i++) {
        now.i32.x[i] = (int32_t)units(lanes.x[i], bits);
        now.i32.y[i] = (int32_t)units(lanes.y[i], bits);
        now.i32.vx[i] = (int32_t)units(lanes.vx[i], bits);
        now.i32.vy[i] = (int32_t)units(lanes.vy[i], bits);
    }
}

static void start_q8(void)
{
    start32(8);
}

static void start_q20(void)
{
    start32(20);
}

static void start_q32(void)
{
    for (int i = 0; i < lanes.n; i++) {
        now.i64.x[i] = units(lanes.x[i], 32);
        now.i64.y[i] = units(lanes.y[i], 32);
        now.i64.vx[i] = units(lanes.vx[i], 32);
        now.i64.vy[i] = units(lanes.vy[i], 32);
    }
}

/* One frame of a block: the move, and which bullets are outside the world, as the engine's move tells. */
#define MOVE(name, type, half)                                                                                         \
    static int32_t name##_block(type *restrict x, type *restrict y, const type *restrict vx, const type *restrict vy,  \
                                uint8_t *restrict far)                                                                 \
    {                                                                                                                  \
        int32_t any = 0;                                                                                               \
                                                                                                                       \
        for (int i = 0; i < BLOCK; i++) {                                                                              \
            type nx = x[i] + vx[i], ny = y[i] + vy[i];                                                                 \
            int32_t f = (nx < -(half)) | (nx > (half)) | (ny < -(half)) | (ny > (half));                               \
            x[i] = nx;                                                                                                 \
            y[i] = ny;                                                                                                 \
            far[i] = (uint8_t)f;                                                                                       \
            any |= f;                                                                                                  \
        }                                                                                                              \
        return any;                                                                                                    \
    }
MOVE(i32, int32_t, INT32_MAX)
MOVE(i64, int64_t, INT64_MAX)
MOVE(f32, float, 16384)
MOVE(f64, double, 16384)

static void frame32(void)
{
    for (int i = 0; i < lanes.n; i += BLOCK)
        lab_sink = i32_block(now.i32.x + i, now.i32.y + i, now.i32.vx + i, now.i32.vy + i, out);
}

static void frame64(void)
{
    for (int i = 0; i < lanes.n; i += BLOCK)
        lab_sink = i64_block(now.i64.x + i, now.i64.y + i, now.i64.vx + i, now.i64.vy + i, out);
}

static double lane_q8(int i, int axis)
{
    return (axis ? now.i32.y : now.i32.x)[i] / 256.0;
}

static double lane_q20(int i, int axis)
{
    return (axis ? now.i32.y : now.i32.x)[i] / 1048576.0;
}

static double lane_q32(int i, int axis)
{
    return (double)(axis ? now.i64.y : now.i64.x)[i] / 4294967296.0;
}

/* ---- floating point ---- */

/* To the other end of the world: exact, for the last bit out there is not finer. */
#define FLOATING(name, type)                                                                                           \
    static void name##_start(void)                                                                                     \
    {                                                                                                                  \
        for (int i = 0; i < lanes.n; i++) {                                                                            \
            now.name.x[i] = (type)lanes.x[i];                                                                          \
            now.name.y[i] = (type)lanes.y[i];                                                                          \
            now.name.vx[i] = (type)lanes.vx[i];                                                                        \
            now.name.vy[i] = (type)lanes.vy[i];                                                                        \
        }                                                                                                              \
    }                                                                                                                  \
    static type name##_inside(type v)                                                                                  \
    {                                                                                                                  \
        return v > 16384 ? v - 32768 : v < -16384 ? v + 32768 : v;                                                     \
    }                                                                                                                  \
    static void name##_frame(void)                                                                                     \
    {                                                                                                                  \
        for (int i = 0; i < lanes.n; i += BLOCK) {                                                                     \
            if (!name##_block(now.name.x + i, now.name.y + i, now.name.vx + i, now.name.vy + i, out))                  \
                continue;                                                                                              \
            for (int k = i; k < i + BLOCK; k++) {                                                                      \
                now.name.x[k] = name##_inside(now.name.x[k]);                                                          \
                now.name.y[k] = name##_inside(now.name.y[k]);                                                          \
            }                                                                                                          \
        }                                                                                                              \
    }                                                                                                                  \
    static double name##_lane(int i, int axis)                                                                         \
    {                                                                                                                  \
        return (double)(axis ? now.name.y : now.name.x)[i];                                                            \
    }
FLOATING(f32, float)
FLOATING(f64, double)

/* ---- the engine's chips ---- */

static void clear(struct board *b)
{
    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    slots_trim(&b->bullets.s);
}

static void fire(struct board *b, uint16_t motion, bool is_fine)
{
    clear(b);
    for (int i = 0; i < lanes.n; i++) {
        const struct bullet_spec shape = { .x = PX(lanes.x[i]),
                                           .y = PX(lanes.y[i]),
                                           .speed = lanes.speed[i],
                                           .dir = lanes.dir[i],
                                           .motion = motion,
                                           .is_fine = is_fine };
        bullets_fire(&b->bullets, &shape, 0);
    }
}

static void engine_start(void)
{
    fire(plain, 0, false);
}

static void engine_frame(void)
{
    engine_move(plain, &ENGINE_EVERYWHERE);
}

static double engine_lane(int i, int axis)
{
    return (axis ? plain->bullets.y : plain->bullets.x)[i] / 65536.0;
}

/* Fine bullets need a program that says so; this one does nothing. */
static void fine_start(void)
{
    const struct motion_step wait = { .actions = DOES_WAIT, .duration = 1 };

    fire(fine, engine_motion(fine, &wait, 1, true), true);
}

static fx put_back(fx v)
{
    return v > PX(8192) ? v - PX(16384) : v < -PX(8192) ? v + PX(16384) : v;
}

/* Their place may not overflow: they are put back by hand, in time for the fastest. */
static void fine_frame(void)
{
    engine_move(fine, &ENGINE_EVERYWHERE);
    if (fine->core.clock % 64)
        return;
    for (int i = 0; i < lanes.n; i++) {
        fine->bullets.x[i] = put_back(fine->bullets.x[i]);
        fine->bullets.y[i] = put_back(fine->bullets.y[i]);
    }
}

static double fine_lane(int i, int axis)
{
    int64_t place[2];

    bullets_get_position(&fine->bullets, (uint32_t)i, &place[0], &place[1]);
    return (double)place[axis] / 4294967296.0;
}

/* ---- the formats ---- */

/* A row is added here. */
static const struct format {
    const char *name;
    int fraction;              /* bits of it, 0: floating */
    int headings;              /* flown: fewer where a frame is dear */
    double world;              /* px round the wrapped world */
    const char *range, *trade; /* of a coordinate; against the engine's */
    void (*start)(void), (*frame)(void);
    double (*lane)(int i, int axis);
    const char *who;
} FORMATS[] = {
    { "Q23.8", 8, HEADINGS, 16777216, "±8,388,608 px", "8 fractional bits, in exchange for more range", start_q8,
      frame32, lane_q8, "avoid: slow bullets drift off course or do not move" },
    { "Q15.16", 16, HEADINGS, 65536, "±32,768 px", "nothing", engine_start, engine_frame, engine_lane,
      "every scene: bullets live for seconds, not hours" },
    { "Q11.20", 20, HEADINGS, 4096, "±2,048 px", "range", start_q20, frame32, lane_q20,
      "a game where nothing ever leaves ±2,048 px" },
    { "Q15.16, `fine = true`", 32, 8, 16384, "±32,768 px", "time", fine_start, fine_frame, fine_lane,
      "slow bullets that live for minutes" },
    { "Q31.32", 32, HEADINGS, 4294967296.0, "±2,147,483,648 px", "4 bytes per coordinate", start_q32, frame64, lane_q32,
      "an engine with a world larger than ±16,383 px" },
    { "float32", 0, HEADINGS, 32768, "±16,384 px in this test", "consistency: results depend on the position",
      f32_start, f32_frame, f32_lane, "avoid: the same pattern flies differently in different places" },
    { "double", 0, HEADINGS, 32768, "±16,384 px in this test",
      "consistency: results depend on the position; 4 bytes per coordinate", f64_start, f64_frame, f64_lane,
      "an engine without portable replays" },
};
enum { COUNT = sizeof FORMATS / sizeof *FORMATS, Q8 = 0, FINE = 3, FLOAT = 5 };

static bool is_standard(const struct format *f)
{
    return f->fraction && 1ll << f->fraction == FX_ONE;
}

static int standard_row(void)
{
    for (int i = 0; i < COUNT; i++)
        if (is_standard(&FORMATS[i]))
            return i;
    return -1;
}

/* ---- drift ---- */

static void set_lanes(void)
{
    lanes.n = LANES;
    for (int i = 0; i < LANES; i++) {
        double c, s;
        lanes.speed[i] = (fx)units(SPEED[i % SPEEDS], 16);
        lanes.dir[i] = (ang)((uint64_t)(i / SPEEDS) * 0x9e3779b97f4a7c15u >> 32); /* spread evenly, on no axis */
        lab_direction(lanes.dir[i] / 4294967296.0, &c, &s);
        lanes.x[i] = START_X;
        lanes.y[i] = START_Y;
        lanes.vx[i] = fx_to_double(lanes.speed[i]) * c;
        lanes.vy[i] = fx_to_double(lanes.speed[i]) * s;
    }
}

/* v brought next to 0 in steps of the world. */
static double wrapped(double v, double world)
{
    return v - world * floor(v / world + 0.5);
}

struct drift {
    double most[SPANS][SPEEDS];
    double squares[SPANS]; /* over all lanes */
    double worst[SPANS];
    double still; /* share of the slowest lanes that never moved */
};
static struct drift drifts[COUNT];

static void measure(const struct format *f, struct drift *d, int span)
{
    double frames = SPAN[span];

    for (int i = 0; i < lanes.n; i++) {
        double ex = wrapped(f->lane(i, 0) - (START_X + frames * lanes.vx[i]), f->world);
        double ey = wrapped(f->lane(i, 1) - (START_Y + frames * lanes.vy[i]), f->world);
        double e = sqrt(ex * ex + ey * ey);
        double *most = &d->most[span][i % SPEEDS];
        *most = *most > e ? *most : e;
        d->squares[span] += e * e;
        if (span == AT_600 && i % SPEEDS == 0)
            d->still += (f->lane(i, 0) == START_X && f->lane(i, 1) == START_Y) / (double)f->headings;
    }
    for (int i = 0; i < SPEEDS; i++)
        d->worst[span] = d->worst[span] > d->most[span][i] ? d->worst[span] : d->most[span][i];
}

static void fly(const struct format *f, struct drift *d)
{
    double frames = 0;

    memset(d, 0, sizeof *d);
    lanes.n = f->headings * SPEEDS;
    f->start();
    for (int span = 0; span < SPANS; span++) {
        for (; frames < SPAN[span]; frames++)
            f->frame();
        measure(f, d, span);
    }
}

/* ---- translation ---- */

enum { PATTERN = 960, PATTERN_FRAMES = 120, SHIFTS = 8 };
static const double SHIFT[SHIFTS][2] = { { 1, 0 },    { 0, 1 },     { 7, 3 },     { 64, 64 },
                                         { -190, 5 }, { 211, 300 }, { -100, 97 }, { 640, 480 } };

static void set_pattern(double dx, double dy)
{
    struct rng r;

    rng_seed(&r, 3);
    lanes.n = PATTERN;
    for (int i = 0; i < PATTERN; i++) {
        double c, s;
        lanes.speed[i] = (fx)(6554 + rng_below(&r, 4 * 65536));
        lanes.dir[i] = (ang)rng_next(&r);
        lab_direction(lanes.dir[i] / 4294967296.0, &c, &s);
        lanes.x[i] = dx + START_X + (double)rng_below(&r, 64 * 256) / 256;
        lanes.y[i] = dy + START_Y + (double)rng_below(&r, 64 * 256) / 256;
        lanes.vx[i] = fx_to_double(lanes.speed[i]) * c;
        lanes.vy[i] = fx_to_double(lanes.speed[i]) * s;
    }
}

/* The bullets of the moved pattern that are not exactly where those of the first are, moved. */
static int translated(const struct format *f, double *worst)
{
    static double x[PATTERN], y[PATTERN];
    int differ = 0;

    *worst = 0;
    for (int k = -1; k < SHIFTS; k++) {
        double dx = k < 0 ? 0 : SHIFT[k][0], dy = k < 0 ? 0 : SHIFT[k][1];
        set_pattern(dx, dy);
        f->start();
        for (int n = 0; n < PATTERN_FRAMES; n++)
            f->frame();
        for (int i = 0; i < PATTERN; i++) {
            double px = f->lane(i, 0) - dx, py = f->lane(i, 1) - dy; /* exact in doubles, for every format */
            if (k < 0) {
                x[i] = px;
                y[i] = py;
                continue;
            }
            double ex = fabs(px - x[i]), ey = fabs(py - y[i]), e = ex > ey ? ex : ey;
            differ += e > 0;
            *worst = *worst > e ? *worst : e;
        }
    }
    return differ;
}

/* ---- the page ---- */

static void set_timed(void)
{
    struct rng r;

    rng_seed(&r, 4);
    lanes.n = TIMED;
    for (int i = 0; i < TIMED; i++) {
        lanes.speed[i] = 0;
        lanes.dir[i] = 0;
        lanes.x[i] = lab_random(&r, 0, 384);
        lanes.y[i] = lab_random(&r, 0, 448);
        lanes.vx[i] = lab_random(&r, -0.01, 0.01);
        lanes.vy[i] = lab_random(&r, -0.01, 0.01);
    }
}

/* A frame of a format, starting anew now and then: the columns of the formats share one room. */
static void run_frames(void *data)
{
    const struct format *f = data;

    for (int i = 0; i < 8; i++)
        f->frame();
}

static void time_all(struct lab_rival *rivals)
{
    set_timed();
    for (int i = 0; i < COUNT; i++)
        rivals[i] = (struct lab_rival){ .run = run_frames, .data = (void *)(uintptr_t)&FORMATS[i], .ops = 8.0 * TIMED };
    if (lab_exact())
        return;
    engine_start();
    fine_start();
    memset(&now, 0, sizeof now); /* a position that is nothing in any format: bits do not matter to the time */
    lab_time(rivals, COUNT, standard_row());
}

static const char *drift_cell(const struct drift *d, int speed)
{
    return report_string("%s / %s / %s", report_figure(d->most[AT_600][speed]), report_figure(d->most[AT_36000][speed]),
                         report_figure(d->most[AT_MILLION][speed]));
}

static void print_speeds(void)
{
    report_text("The next table shows the largest drift by speed, in px, after 600, 36,000 and 1,000,000 frames. "
                "Without `fine`,\n"
                "fixed-point positions drift by about the same distance at every speed: less than one unit in the last "
                "place per frame.\n"
                "The drift of float32 grows with the distance covered.");
    report_table(NULL, "format | 0.002 px/frame> | 0.1 px/frame> | 3 px/frame> | 20 px/frame> | 64 px/frame>");
    for (int i = 0; i < COUNT; i++)
        report_row(is_standard(&FORMATS[i]), FORMATS[i].name, drift_cell(&drifts[i], 0), drift_cell(&drifts[i], 2),
                   drift_cell(&drifts[i], 4), drift_cell(&drifts[i], 6), drift_cell(&drifts[i], 7), NULL);
    report_table_end();
}

static void plot_drift(void)
{
    report_plot(&(struct report_plot){
        .file = "drift",
        .title = "Drift of a bullet at 3 px/frame, worst of 64 headings",
        .x_name = "frames",
        .y_name = "distance from the true position, px",
        .described = "Drift over time for seven position formats: Q23.8 is worst, then float32, Q15.16, Q11.20, "
                     "Q31.32, double and fine motion",
    });
    for (int i = 0; i < COUNT; i++) {
        double y[SPANS];
        for (int k = 0; k < SPANS; k++)
            y[k] = drifts[i].most[k][4];
        report_plot_line(FORMATS[i].name, is_standard(&FORMATS[i]), SPAN, y, SPANS);
    }
    report_plot_end();
}

static void print_all(const struct lab_rival *rivals, const int *differ, const double *worst)
{
    report_table(NULL, "format | range | gives up | drift after 600 frames, max> | after 36,000, max (rms)> | after "
                       "1,000,000, max> | use");
    for (int i = 0; i < COUNT; i++) {
        const struct format *f = &FORMATS[i];
        const struct drift *d = &drifts[i];
        report_row(is_standard(f), f->name, f->range, f->trade, report_string("%s px", report_figure(d->worst[AT_600])),
                   report_string("%s px (%s)", report_figure(d->worst[AT_36000]),
                                 report_figure(sqrt(d->squares[AT_36000] / (f->headings * SPEEDS)))),
                   report_string("%s px", report_figure(d->worst[AT_MILLION])), f->who, NULL);
    }
    report_table_end();
    report_table(NULL, "format | differ when moved> | largest difference> | time per bullet> | ratio>");
    for (int i = 0; i < COUNT; i++)
        report_row(is_standard(&FORMATS[i]), FORMATS[i].name,
                   report_string("%s of %s", report_count(differ[i]), report_count(SHIFTS * PATTERN)),
                   worst[i] > 0 ? report_string("%s px", report_figure(worst[i])) : "0", lab_ns(&rivals[i]),
                   lab_ratio(&rivals[i]), NULL);
    report_table_end();
}

void section_positions(void)
{
    struct lab_rival rivals[COUNT];
    int differ[COUNT], me = standard_row();
    double worst[COUNT];

    plain = engine_power(TIMED, 0, 0);
    fine = engine_power(TIMED, 0, 0);
    set_lanes();
    for (int i = 0; i < COUNT; i++)
        fly(&FORMATS[i], &drifts[i]);
    for (int i = 0; i < COUNT; i++)
        differ[i] = translated(&FORMATS[i], &worst[i]);
    time_all(rivals);
    engine_free(plain);
    engine_free(fine);

    report_section("3. Position format");
    report_text("A bullet adds its velocity to its position in every frame, so the rounding error of the velocity "
                "accumulates. *Drift* is\n"
                "the distance between a bullet and its exact position. The tables show the drift for %d headings (8 "
                "for `fine`) and %d\n"
                "speeds from 0.002 to 64 px/frame. The world wraps at its edges so that fast bullets can fly for a "
                "million frames (4\n"
                "hours 38 minutes). The speeds are rounded to multiples of 2⁻¹⁶ px/frame first, and the error of this "
                "rounding is not\n"
                "counted. Section 8 counts this error and therefore shows slightly more drift at 0.002 px/frame.",
                HEADINGS, SPEEDS);
    report_text("For *differ when moved*, a pattern of %d bullets flies for %d frames, first in its original place and "
                "then shifted by\n"
                "whole pixels (%d different shifts). The column counts the bullets that do not end exactly at the "
                "shifted position. *Time\n"
                "per bullet* is for one frame with %s bullets. The engine's rows (Q15.16) run its whole motion pass, "
                "not only the\n"
                "addition.",
                PATTERN, PATTERN_FRAMES, SHIFTS, report_count(TIMED));
    print_all(rivals, differ, worst);
    plot_drift();
    print_speeds();
    const struct drift *d = &drifts[me];
    report_text(
        "A bullet takes 10 to 30 seconds to cross the field. In 30 seconds (1,800 frames), Q15.16 drifts by at "
        "most %s px, so\n"
        "Q11.20 and Q31.32 would make no visible difference. In fixed point, a pattern is also the same wherever "
        "it is fired.",
        report_figure(3 * d->worst[AT_600]));
    lab_claim(me >= 0, "a row of the table is the engine's format");
    lab_conclude("position format", FORMATS[me].name,
                 report_string("%s px of drift in 600 frames and %s px in 36,000 frames, the same at every position",
                               report_figure(d->worst[AT_600]), report_figure(d->worst[AT_36000])),
                 "use `motion.def{ fine = true }` for slow bullets that live for minutes",
                 d->worst[AT_600] < 0.01 && drifts[FINE].worst[AT_MILLION] < 1e-6 && differ[FINE] == 0 &&
                     differ[me] == 0 && drifts[Q8].worst[AT_600] > 1 && differ[FLOAT] > 0 && WORLD_EDGE < 32768 &&
                     WORLD_EDGE + MAX_SPEED < 32768 && (lab_exact() || rivals[FINE].ratio > 2));
}

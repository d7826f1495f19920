/*
 * acceleration.c - section 5: a bullet whose speed changes. Against the continuous motion x0 + v0 t + a t^2 / 2.
 *
 * All fly along +x, so that only speeds and places are rounded. Rows of the engine run motion programs on its chip; the
 * others are in doubles, which leaves the error of the method.
 */
#include <math.h>
#include <string.h>
#include "engine.h"
#include "lab.h"

enum { SCENES = 4, TIMED = LAB_VALUES, SAMPLES = 12 };

/* From one speed to another in so many frames. */
static const struct scene {
    const char *name;
    double from, to;
    int frames;
} SCENE[SCENES] = {
    { "1 to 1.05 in 3,600", 1, 1.05, 3600 },
    { "1 to 3 in 3,600", 1, 3, 3600 },
    { "1 to 3 in 600", 1, 3, 600 },
    { "0 to 8 in 60", 0, 8, 60 },
};
enum { PLOTTED = 1 };
static const int SAMPLE[SAMPLES] = { 1, 3, 10, 30, 60, 120, 300, 600, 1200, 1800, 2700, 3600 };

/* How far it has flown after each frame, frames 1 ... n at [1] ... [n]. */
typedef void flight(const struct scene *s, double *way);

/* ---- methods, in doubles ---- */

static void euler_speed_first(const struct scene *s, double *way)
{
    double a = (s->to - s->from) / s->frames, v = s->from, x = 0;

    for (int t = 1; t <= s->frames; t++) {
        v += a;
        way[t] = x += v;
    }
}

static void euler_place_first(const struct scene *s, double *way)
{
    double a = (s->to - s->from) / s->frames, v = s->from, x = 0;

    for (int t = 1; t <= s->frames; t++) {
        way[t] = x += v;
        v += a;
    }
}

static void trapezoid(const struct scene *s, double *way)
{
    double a = (s->to - s->from) / s->frames, v = s->from, x = 0;

    for (int t = 1; t <= s->frames; t++) {
        way[t] = x += v + a / 2;
        v += a;
    }
}

static double continuous(const struct scene *s, double t)
{
    return s->from * t + (s->to - s->from) / s->frames * t * t / 2;
}

/* The true place, rounded to fx. */
static void closed_form(const struct scene *s, double *way)
{
    for (int t = 1; t <= s->frames; t++)
        way[t] = floor(continuous(s, t) * 65536 + 0.5) / 65536;
}

/* ---- the engine ---- */

static struct motion_step program(const struct scene *s, bool by_accel, bool fine)
{
    struct motion_step p = { .duration = (uint32_t)s->frames };
    double units = fine ? 4294967296.0 : 65536.0, shift = fine ? 1 : 65536.0;

    if (by_accel) {
        p.actions = DOES_ACCEL;
        p.accel = (int64_t)(floor((s->to - s->from) / s->frames * units + 0.5) * shift);
    } else {
        p.actions = DOES_SPEED;
        p.speed = (int64_t)(floor(s->to * units + 0.5) * shift);
    }
    return p;
}

static void fire(struct board *b, const struct scene *s, bool by_accel, bool fine, int n)
{
    struct motion_step p = program(s, by_accel, fine);
    struct bullet_spec shape = { .speed = PX(s->from), .is_fine = fine };

    shape.motion = engine_motion(b, &p, 1, fine);
    for (int i = 0; i < n; i++)
        bullets_fire(&b->bullets, &shape, 0);
}

static void engine_flight(const struct scene *s, double *way, bool by_accel, bool fine)
{
    struct board *b = engine_power(64, 0, 0);

    fire(b, s, by_accel, fine, 1);
    for (int t = 1; t <= s->frames; t++) {
        int64_t x, y;
        engine_move(b, &ENGINE_EVERYWHERE);
        bullets_get_position(&b->bullets, 0, &x, &y);
        way[t] = (double)x / 4294967296.0;
    }
    engine_free(b);
}

static void engine_over(const struct scene *s, double *way)
{
    engine_flight(s, way, false, false);
}

static void engine_accel(const struct scene *s, double *way)
{
    engine_flight(s, way, true, false);
}

static void engine_over_fine(const struct scene *s, double *way)
{
    engine_flight(s, way, false, true);
}

static void engine_accel_fine(const struct scene *s, double *way)
{
    engine_flight(s, way, true, true);
}

/* ---- times: a frame of one bullet among 65,536 that accelerate along their headings ---- */

static struct {
    double x[TIMED], y[TIMED], v[TIMED], a[TIMED], c[TIMED], s[TIMED];
    double t;
} now;

static void time_euler(void *data)
{
    (void)data;
    for (int i = 0; i < TIMED; i++) {
        now.v[i] += now.a[i];
        now.x[i] += now.v[i] * now.c[i];
        now.y[i] += now.v[i] * now.s[i];
    }
    lab_sink = (int64_t)now.x[5];
}

static void time_trapezoid(void *data)
{
    (void)data;
    for (int i = 0; i < TIMED; i++) {
        double v = now.v[i] + now.a[i] / 2;
        now.v[i] += now.a[i];
        now.x[i] += v * now.c[i];
        now.y[i] += v * now.s[i];
    }
    lab_sink = (int64_t)now.x[5];
}

static void time_closed(void *data)
{
    (void)data;
    now.t += 1;
    for (int i = 0; i < TIMED; i++) {
        double way = (now.v[i] + now.a[i] * now.t / 2) * now.t;
        now.x[i] = 100 + way * now.c[i];
        now.y[i] = 100 + way * now.s[i];
    }
    lab_sink = (int64_t)now.x[5];
}

static void time_engine(void *data)
{
    engine_move(data, &ENGINE_EVERYWHERE);
}

/* ---- the page ---- */

static const struct method {
    const char *name, *trade;
    flight *run;
    void (*time)(void *data);
    bool engine, by_accel, fine;
    const char *who;
} METHODS[] = {
    { "`speed = v, over = n`", "half a frame's acceleration", engine_over, time_engine, true, false, false,
      "everything" },
    { "`accel = a`", "accuracy: the rounded acceleration is added in every frame", engine_accel, time_engine, true,
      true, false, "changes that take less than ten seconds or never end" },
    { "`speed = v, over = n`, fine", "half a frame's acceleration", engine_over_fine, time_engine, true, false, true,
      "positions that must agree to within 1e-9 px" },
    { "`accel = a`, fine", "half a frame's acceleration", engine_accel_fine, time_engine, true, true, true,
      "slow changes over minutes" },
    { "Euler, speed first", "half a frame's acceleration", euler_speed_first, time_euler, false, false, false,
      "comparison with the engine: the same method without rounding" },
    { "Euler, position first", "half a frame's acceleration, in the other direction", euler_place_first, time_euler,
      false, false, false, "avoid: no more accurate, and a bullet fired at rest starts to move a frame late" },
    { "trapezoid", "the time for one more addition", trapezoid, time_trapezoid, false, false, false,
      "physics simulations" },
    { "closed form", "aiming, turning and later changes", closed_form, time_closed, false, false, false,
      "fixed paths that nothing can change" },
};
enum { COUNT = sizeof METHODS / sizeof *METHODS, OVER = 0, ACCEL = 1, OVER_FINE = 2, CLOSED = 7 };

static double most[COUNT][SCENES], rounding[COUNT][SCENES], squares[COUNT], sampled[COUNT][SAMPLES];
static int frames;

/* Errors against the continuous motion; `rounding` against exact sums in the engine's order. */
static void measure(void)
{
    static double way[4096], sum[4096];

    for (int k = 0; k < COUNT; k++)
        for (int c = 0; c < SCENES; c++) {
            const struct scene *s = &SCENE[c];
            METHODS[k].run(s, way);
            euler_speed_first(s, sum);
            for (int t = 1; t <= s->frames; t++) {
                double e = fabs(way[t] - continuous(s, t)), r = fabs(way[t] - sum[t]);
                most[k][c] = most[k][c] > e ? most[k][c] : e;
                rounding[k][c] = rounding[k][c] > r ? rounding[k][c] : r;
                squares[k] += e * e;
            }
            for (int i = 0; c == PLOTTED && i < SAMPLES; i++)
                sampled[k][i] = fabs(way[SAMPLE[i]] - continuous(s, SAMPLE[i]));
            frames += k == 0 ? s->frames : 0;
        }
}

static void time_methods(struct lab_rival *rivals)
{
    static const struct scene LONG = { "", 0, 3, 1000000 };
    struct board *boards[COUNT] = { NULL };

    for (int i = 0; i < TIMED; i++) {
        now.v[i] = 1;
        now.a[i] = 1e-5;
        lab_direction(i / (double)TIMED, &now.c[i], &now.s[i]);
    }
    for (int k = 0; k < COUNT; k++) {
        const struct method *m = &METHODS[k];
        if (m->engine && !lab_exact()) {
            boards[k] = engine_power(TIMED, 0, 0);
            fire(boards[k], &LONG, m->by_accel, m->fine, TIMED);
        }
        rivals[k] = (struct lab_rival){ .run = m->time, .data = boards[k], .ops = TIMED };
    }
    lab_time(rivals, COUNT, OVER);
    for (int k = 0; k < COUNT; k++)
        if (boards[k])
            engine_free(boards[k]);
}

static void print_methods(const struct lab_rival *rivals)
{
    report_table(NULL, "method | gives up | from 1 to 1.05 px/frame in 3,600 frames, max> | 1 to 3 in 3,600> | 1 to 3 "
                       "in 600> | 0 to 8 in 60> | rms of all> | use");
    for (int k = 0; k < COUNT; k++) {
        const char *cell[SCENES];
        for (int c = 0; c < SCENES; c++)
            cell[c] = report_string("%s px", report_figure(most[k][c]));
        report_row(k == OVER, METHODS[k].name, METHODS[k].trade, cell[0], cell[1], cell[2], cell[3],
                   report_string("%s px", report_figure(sqrt(squares[k] / frames))), METHODS[k].who, NULL);
    }
    report_table_end();
    report_table(NULL,
                 "method | rounding error alone, from 1 to 3 px/frame in 3,600 frames> | time per bullet> | ratio>");
    for (int k = 0; k < COUNT; k++)
        report_row(k == OVER, METHODS[k].name,
                   METHODS[k].engine ? report_string("%s px", report_figure(rounding[k][PLOTTED])) : "-",
                   lab_ns(&rivals[k]), lab_ratio(&rivals[k]), NULL);
    report_table_end();
}

static void plot_flights(void)
{
    double x[SAMPLES];

    report_plot(&(struct report_plot){
        .file = "acceleration",
        .title = "From 1 to 3 px/frame in 3,600 frames",
        .x_name = "frames",
        .y_name = "distance from the continuous motion, px",
        .described = "Error over time: an acceleration rounded to Q15.16 is 39 px off after a minute, an interpolated "
                     "speed is 1 px off, and the closed form is a hundred-thousandth of a pixel off",
    });
    for (int i = 0; i < SAMPLES; i++)
        x[i] = SAMPLE[i];
    for (int k = 0; k < COUNT; k++)
        if (k == OVER || k == ACCEL || k == CLOSED)
            report_plot_line(METHODS[k].name, k == OVER, x, sampled[k], SAMPLES);
    report_plot_end();
}

void section_acceleration(void)
{
    struct lab_rival rivals[COUNT];
    double worst = 0, fine = 0;

    measure();
    time_methods(rivals);
    for (int c = 0; c < SCENES; c++) {
        worst = worst > rounding[OVER][c] ? worst : rounding[OVER][c];
        fine = fine > rounding[OVER_FINE][c] ? fine : rounding[OVER_FINE][c];
    }

    report_section("5. Changing speed");
    report_text("A bullet flies straight while its speed changes. The error is the bullet's largest distance from the "
                "continuous motion\n"
                "x₀ + v₀t + at²/2 in any frame. In each frame, the engine first changes the speed, then moves the "
                "bullet. The bullet is\n"
                "therefore ahead by half the change in speed: 1 px for a change from 1 to 3 px/frame, however long the "
                "change takes. The\n"
                "rest of the error is rounding. There is no default method; ▶ marks the recommended one.");
    print_methods(rivals);
    plot_flights();
    report_text(
        "`accel = a` rounds the acceleration to 2⁻¹⁶ px/frame² and adds it in every frame. Within a minute, the error "
        "can reach\n"
        "dozens of pixels. `speed = v, over = n` computes each speed from the first and the last speed, so its "
        "rounding errors\n"
        "cancel out. The bullet stays within %s px of the exact sum of its speeds, or within %s px with `fine`.",
        report_figure(worst), report_figure(fine));
    lab_claim(fabs(most[OVER][PLOTTED] - 1) < 0.01, "the engine is half a change of speed ahead");
    lab_conclude("acceleration", "none; recommended: `speed = v, over = n`",
                 report_string("at most %s px of rounding error, instead of up to %s px with `accel = a`",
                               report_figure(worst), report_figure(rounding[ACCEL][PLOTTED])),
                 "use `accel = a` for changes of speed that are short or never end",
                 worst < 0.1 && rounding[ACCEL][PLOTTED] > 10 && fine < 1e-4);
}

/*
 * angles.c - section 4: what a direction is kept in. Headings that turn by the same step for ever, and rings.
 */
#include <math.h>
#include <string.h>
#include "engine.h"
#include "lab.h"

enum { STEPS = 64, SPANS = 4, RINGS = 7 };

static const int SPAN[SPANS] = { 100, 1000, 10000, 100000 };
static const int RING[RINGS] = { 5, 7, 48, 100, 360, 1000, 5000 };

/* Degrees a step: the golden angle, whole and tenth degrees, and others from 0 to 180. */
static double step[STEPS];

static void set_steps(void)
{
    static const double KNOWN[] = { 137.50776405003785, 1, 7, 13, 0.1, 3.7, 111.1 };
    struct rng r;

    rng_seed(&r, 5);
    for (int i = 0; i < STEPS; i++)
        step[i] = i < 7 ? KNOWN[i] : lab_random(&r, 0, 180);
}

/* Degrees between two headings. */
static double apart(double a, double b)
{
    double d = a - b;

    d -= 360 * floor(d / 360 + 0.5);
    return fabs(d);
}

/* ---- the formats: what step i comes to after so many frames, in degrees ---- */

static double after_bits(int bits, int i, int frames)
{
    double turn = (double)(1ll << bits);
    int64_t unit = (int64_t)floor(step[i] / 360 * turn + 0.5);

    return (double)((unit * frames) & ((1ll << bits) - 1)) / turn * 360;
}

static double after_8(int i, int frames)
{
    return after_bits(8, i, frames);
}

static double after_16(int i, int frames)
{
    return after_bits(16, i, frames);
}

/* The chip's own turning: bullets whose programs turn them for the longest span; read off on the way. */
static double engine_heading[STEPS][SPANS];

static void run_engine(void)
{
    struct board *b = engine_power(STEPS, 0, 0);
    int frame = 0;

    for (int i = 0; i < STEPS; i++) {
        struct motion_step turn = { .actions = DOES_TURN, .duration = (uint32_t)SPAN[SPANS - 1] + 1 };
        struct bullet_spec shape = { .x = 0 };
        trig_turn_from_degrees(step[i], &turn.turn);
        shape.motion = engine_motion(b, &turn, 1, false);
        bullets_fire(&b->bullets, &shape, 0);
    }
    for (int s = 0; s < SPANS; s++) {
        for (; frame < SPAN[s]; frame++)
            engine_move(b, &ENGINE_EVERYWHERE);
        for (int i = 0; i < STEPS; i++)
            engine_heading[i][s] = trig_to_degrees(b->bullets.dir[i]);
    }
    engine_free(b);
}

static double after_engine(int i, int frames)
{
    int s = 0;

    while (SPAN[s] != frames)
        s++;
    return engine_heading[i][s];
}

static double after_float(int i, int frames)
{
    float a = 0, by = (float)step[i];

    for (int f = 0; f < frames; f++) {
        a += by;
        a = a >= 360 ? a - 360 : a;
    }
    return (double)a;
}

static double after_double(int i, int frames)
{
    double a = 0;

    for (int f = 0; f < frames; f++) {
        a += step[i];
        a = a >= 360 ? a - 360 : a;
    }
    return a;
}

/* ---- rings: the heading of shot i of n, worked out from i, or by adding a step ---- */

static double of_bits(int bits, int i, int n, bool repeated)
{
    double turn = (double)(1ll << bits);
    double unit = repeated ? floor(turn / n + 0.5) * i : floor(turn * i / n + 0.5);

    return fmod(unit, turn) / turn * 360;
}

static double ring_8(int i, int n, bool repeated)
{
    return of_bits(8, i, n, repeated);
}

static double ring_16(int i, int n, bool repeated)
{
    return of_bits(16, i, n, repeated);
}

/* As pattern.ring does it: degrees, each made into an angle. */
static double ring_engine(int i, int n, bool repeated)
{
    ang a, by;

    trig_from_degrees(360.0 * i / n, &a);
    trig_from_degrees(360.0 / n, &by);
    return trig_to_degrees(repeated ? by * (ang)i : a);
}

/* How far the widest and the narrowest gap of the ring are apart. */
static double unevenness(double (*ring)(int, int, bool), int n, bool repeated)
{
    double least = 360, most = -360, last = ring(n - 1, n, repeated);

    for (int i = 0; i < n; i++) {
        double at = ring(i, n, repeated), gap = at - last;
        gap -= 360 * floor(gap / 360 + 0.5); /* negative: the end has passed the start */
        least = least < gap ? least : gap;
        most = most > gap ? most : gap;
        last = at;
    }
    return most - least;
}

/* ---- times: one turn of each of 65,536 headings ---- */

static union {
    uint8_t u8[2][LAB_VALUES];
    uint16_t u16[2][LAB_VALUES];
    ang u32[2][LAB_VALUES];
    float f32[2][LAB_VALUES];
    double f64[2][LAB_VALUES];
} now;

#define TURN(name, type, reduce)                                                                                       \
    static void turn_##name(void *data)                                                                                \
    {                                                                                                                  \
        type *a = now.name[0];                                                                                         \
        const type *by = now.name[1];                                                                                  \
                                                                                                                       \
        (void)data;                                                                                                    \
        for (int i = 0; i < LAB_VALUES; i++) {                                                                         \
            type v = (type)(a[i] + by[i]);                                                                             \
            a[i] = reduce;                                                                                             \
        }                                                                                                              \
        lab_sink = (int64_t)a[77];                                                                                     \
    }
TURN(u8, uint8_t, v)
TURN(u16, uint16_t, v)
TURN(u32, ang, v)
TURN(f32, float, v >= 360 ? v - 360 : v)
TURN(f64, double, v >= 360 ? v - 360 : v)

static const struct format {
    const char *name, *unit, *trade;
    int bits; /* of a binary angle, or 0 */
    double (*after)(int i, int frames);
    double (*ring)(int i, int n, bool repeated);
    void (*turn)(void *data);
    const char *who;
} FORMATS[] = {
    { "8 bits", "1.4°", "24 bits; saves 3 bytes", 8, after_8, ring_8, turn_u8,
      "a machine with a 256-entry sine table" },
    { "16 bits", "0.0055°", "16 bits; saves 2 bytes", 16, after_16, ring_16, turn_u16,
      "headings that are set but never turned" },
    { "32 bits", "8.4e-8°", "nothing", 32, after_engine, ring_engine, turn_u32, "everything" },
    { "float32 degrees", "up to 3.1e-5°", "8 bits; automatic wrap-around; time", 0, after_float, NULL, turn_f32,
      "avoid: less accurate, and must be wrapped at 360 explicitly" },
    { "double degrees", "up to 5.7e-14°", "4 bytes; automatic wrap-around; time", 0, after_double, NULL, turn_f64,
      "calculations in scripts" },
};
enum { COUNT = sizeof FORMATS / sizeof *FORMATS, BITS16 = 1, FLOAT = 3 };

static bool is_standard(const struct format *f)
{
    return f->bits == 8 * (int)sizeof(ang);
}

static double most[COUNT][SPANS], squares[COUNT][SPANS];

static void measure(void)
{
    run_engine();
    for (int k = 0; k < COUNT; k++)
        for (int s = 0; s < SPANS; s++)
            for (int i = 0; i < STEPS; i++) {
                double e = apart(FORMATS[k].after(i, SPAN[s]), step[i] * SPAN[s]);
                most[k][s] = most[k][s] > e ? most[k][s] : e;
                squares[k][s] += e * e;
            }
}

static const char *error_cell(int k, int s)
{
    return report_string("%s° (%s)", report_figure(most[k][s]), report_figure(sqrt(squares[k][s] / STEPS)));
}

static void print_formats(const struct lab_rival *rivals)
{
    report_table(NULL, "heading | resolution> | gives up | error after 100 steps, max (rms)> | 1,000> | 10,000> | "
                       "100,000> | time per step> | ratio> | use");
    for (int k = 0; k < COUNT; k++)
        report_row(is_standard(&FORMATS[k]), FORMATS[k].name, FORMATS[k].unit, FORMATS[k].trade, error_cell(k, 0),
                   error_cell(k, 1), error_cell(k, 2), error_cell(k, 3), lab_ns(&rivals[k]), lab_ratio(&rivals[k]),
                   FORMATS[k].who, NULL);
    report_table_end();
}

static void print_rings(void)
{
    report_table(
        "Rings of n shots: difference between the widest and the narrowest gap, with shot i placed at i/n of a "
        "turn (first value) and with a rounded step added repeatedly (second value)",
        "n> | 8 bits> | 16 bits> | 32 bits (engine)>");
    for (int r = 0; r < RINGS; r++) {
        const char *cells[3];
        for (int k = 0; k < 3; k++)
            cells[k] = RING[r] > 256 && FORMATS[k].bits == 8
                           ? "-"
                           : report_string("%s° / %s°", report_figure(unevenness(FORMATS[k].ring, RING[r], false)),
                                           report_figure(unevenness(FORMATS[k].ring, RING[r], true)));
        report_row(false, report_count(RING[r]), cells[0], cells[1], cells[2], NULL);
    }
    report_table_end();
}

static void plot_turns(void)
{
    double x[SPANS];

    report_plot(&(struct report_plot){
        .file = "turns",
        .title = "A heading turned by a constant step, worst of 64 steps",
        .x_name = "steps",
        .y_name = "distance from the true heading, degrees",
        .described = "Heading error by number of steps: 8 bits fail immediately, 16 bits are off by a degree after "
                     "hundreds of steps, 32 bits by 0.004 degrees after 100,000",
    });
    for (int s = 0; s < SPANS; s++)
        x[s] = SPAN[s];
    for (int k = 0; k < COUNT; k++)
        report_plot_line(FORMATS[k].name, is_standard(&FORMATS[k]), x, most[k], SPANS);
    report_plot_end();
}

void section_angles(void)
{
    struct lab_rival rivals[COUNT];
    int me = 0;

    while (!is_standard(&FORMATS[me]))
        me++;
    set_steps();
    measure();
    memset(&now, 0, sizeof now);
    for (int k = 0; k < COUNT; k++)
        rivals[k] = (struct lab_rival){ .run = FORMATS[k].turn, .ops = LAB_VALUES };
    lab_time(rivals, COUNT, me);

    report_section("4. Direction format");
    report_text("A spiral adds the same step to its heading repeatedly, so a rounding error in the step accumulates. "
                "The table shows the\n"
                "error of the heading for %d step sizes between 0° and 180°, including the golden angle. The engine's "
                "row uses a motion\n"
                "program.",
                STEPS);
    print_formats(rivals);
    plot_turns();
    print_rings();
    report_text("At a distance of 400 px, rounding a heading to 16 bits moves a bullet by at most 0.02 px, so 16 bits "
                "are enough for\n"
                "aiming but not for repeated steps. A 32-bit heading needs only 2 bytes more.");
    lab_conclude("directions", "32-bit binary angles",
                 report_string("an error of %s° after 10,000 steps, instead of %s° with 16 bits",
                               report_figure(most[me][2]), report_figure(most[BITS16][2])),
                 "none: 16 bits save only 2 bytes per bullet",
                 most[me][2] < 0.001 && most[BITS16][2] > 1 && unevenness(ring_engine, 1000, false) < 2e-7 &&
                     (lab_exact() || rivals[me].ns < 1));
}

/*
 * border.c - the lab's section on the border to scripts: what a position or an angle is after it went to Lua and came
 * back. A Lua number is a double; scripts see pixels and degrees.
 */
#include <lua.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "../../../src/base/trig.h"
#include "lab.h"

_Static_assert(LUA_FLOAT_TYPE == LUA_FLOAT_DOUBLE, "Lua's numbers are doubles");

enum { VALUES = 1 << 20, TEXTS = 1 << 17 };

static const double ANGS_A_RADIAN = 683565275.5764316, RADIANS_AN_ANG = 1.4629180792671596e-9; /* 2^32 / (2 pi) */

/* A way over the border and back. */
struct way {
    const char *name;
    bool standard, slow;
    int32_t (*back)(int32_t v);
    const char *trade, *who;
};

static int64_t whole(double v)
{
    return (int64_t)(v + (v < 0 ? -0.5 : 0.5));
}

static double through_text(const char *format, double v)
{
    char text[64];

    snprintf(text, sizeof text, format, v);
    return strtod(text, NULL);
}

/* ---- positions ---- */

static fx from_pixels(double v)
{
    fx r = v > 0 ? FX_MAX : FX_MIN;

    fx_from_double(v, &r);
    return r;
}

static int32_t fx_double(int32_t v)
{
    return from_pixels(fx_to_double(v));
}

static int32_t fx_float(int32_t v)
{
    return from_pixels((float)fx_to_double(v));
}

static int32_t fx_text14(int32_t v)
{
    return from_pixels(through_text("%.14g", fx_to_double(v)));
}

static int32_t fx_text6(int32_t v)
{
    return from_pixels(through_text("%g", fx_to_double(v)));
}

static int32_t fx_hundredths(int32_t v)
{
    return from_pixels((double)whole(fx_to_double(v) * 100) / 100);
}

static int32_t fx_pixels(int32_t v)
{
    return from_pixels((double)whole(fx_to_double(v)));
}

static const struct way POSITIONS[] = {
    { "pixels as a double", true, false, fx_double, "nothing", "every script" },
    { "pixels as text, %.14g", false, true, fx_text14, "time", "readable files; tostring writes this format" },
    { "pixels as text, %g", false, true, fx_text6, "10 of 32 bits; time", "messages" },
    { "pixels as float32", false, false, fx_float, "8 of 32 bits", "drawing" },
    { "hundredths of a pixel", false, false, fx_hundredths, "9 of 32 bits", "hand-written level files" },
    { "whole pixels", false, false, fx_pixels, "16 of 32 bits", "tiles" },
};

/* ---- angles ---- */

static int32_t from_degrees(double deg)
{
    ang a = 0;

    trig_from_degrees(deg, &a);
    return (int32_t)a;
}

static int32_t ang_double(int32_t v)
{
    return from_degrees(trig_to_degrees((ang)v));
}

static int32_t ang_text14(int32_t v)
{
    return from_degrees(through_text("%.14g", trig_to_degrees((ang)v)));
}

static int32_t ang_text6(int32_t v)
{
    return from_degrees(through_text("%g", trig_to_degrees((ang)v)));
}

static int32_t ang_float(int32_t v)
{
    return from_degrees((float)trig_to_degrees((ang)v));
}

static int32_t ang_radians(int32_t v)
{
    return (int32_t)(ang)whole((ang)v * RADIANS_AN_ANG * ANGS_A_RADIAN);
}

static int32_t ang_radians_f(int32_t v)
{
    return (int32_t)(ang)whole((float)((ang)v * RADIANS_AN_ANG) * ANGS_A_RADIAN);
}

static int32_t ang_16(int32_t v)
{
    return (int32_t)(((ang)v + 0x8000) & 0xffff0000);
}

static int32_t ang_whole(int32_t v)
{
    return from_degrees((double)whole(trig_to_degrees((ang)v)));
}

static const struct way ANGLES[] = {
    { "degrees as a double", true, false, ang_double, "nothing", "every script: 90 is exactly a quarter turn" },
    { "radians as a double", false, false, ang_radians, "exact fractions of a turn",
      "textbook formulas that need no exact fractions of a turn" },
    { "degrees as text, %.14g", false, true, ang_text14, "time", "readable files; tostring writes this format" },
    { "degrees as text, %g", false, true, ang_text6, "13 of 32 bits; time", "messages" },
    { "degrees as float32", false, false, ang_float, "8 of 32 bits", "drawing" },
    { "radians as float32", false, false, ang_radians_f, "8 of 32 bits", "drawing" },
    { "16-bit angle", false, false, ang_16, "16 of 32 bits", "a 16-bit look" },
    { "whole degrees", false, false, ang_whole, "23 of 32 bits", "hand-written level files" },
};

/* ---- measuring ---- */

struct trip {
    int32_t (*back)(int32_t v);
    int32_t *values;
};

static void run(void *data)
{
    const struct trip *t = data;
    int64_t sum = 0;

    for (int i = 0; i < LAB_VALUES; i++)
        sum += t->back(t->values[i]);
    lab_sink = sum;
}

/* How many of n values do not come back, and how far off the worst is; an angle goes the shorter way. */
static int64_t lost(const struct way *w, bool circular, const int32_t *values, int n, double *most)
{
    int64_t count = 0;

    *most = 0;
    for (int i = 0; i < n; i++) {
        int32_t back = w->back(values[i]);
        int64_t off = circular ? (int32_t)((uint32_t)back - (uint32_t)values[i]) : (int64_t)back - values[i];
        count += off != 0;
        *most = fabs((double)off) > *most ? fabs((double)off) : *most;
    }
    return count;
}

/* All 2^32. */
static bool all_come_back(int32_t (*back)(int32_t v))
{
    uint32_t v = 0;

    do
        if (back((int32_t)v) != (int32_t)v)
            return false;
    while (++v);
    return true;
}

static void measure(const struct way *ways, int n, bool circular, struct lab_rival time[], double most[],
                    const int32_t *values)
{
    struct trip trips[16];

    for (int i = 0; i < n; i++) {
        trips[i] = (struct trip){ ways[i].back, (int32_t *)values };
        time[i] = (struct lab_rival){ .run = run, .data = &trips[i], .ops = LAB_VALUES };
    }
    lab_time(time, n, 0);
    report_table(
        circular ? "Angles" : "Positions",
        report_string(
            "%s|gives up|values tried|changed by a round trip>|largest change, %s>|round-trip time>|ratio>|use",
            circular ? "angle passed as" : "position passed as", circular ? "2⁻³² of a turn" : "ulp"));
    for (int i = 0; i < n; i++) {
        int count = ways[i].slow ? TEXTS : VALUES;
        int64_t gone = lost(&ways[i], circular, values, count, &most[i]);
        report_row(ways[i].standard, ways[i].name, ways[i].trade, ways[i].standard ? "all 2³²" : report_count(count),
                   report_percent((double)gone / count), report_figure(most[i]), lab_ns(&time[i]), lab_ratio(&time[i]),
                   ways[i].who, NULL);
        lab_claim(!ways[i].standard || gone == 0, "values come back from scripts as they went");
    }
    report_table_end();
}

/* The largest difference between degrees a script writes and what it reads back. */
static double degrees_back(void)
{
    double most = 0;

    for (int tenths = 0; tenths < 3600; tenths++) {
        double deg = tenths / 10.0, off = fabs(trig_to_degrees((ang)from_degrees(deg)) - deg);
        most = off > most ? off : most;
    }
    return most;
}

static void draw(const struct lab_rival time[], const double most[], int n)
{
    const struct report_plot plot = {
        .file = "border",
        .title = "An angle passed to a script and back",
        .x_name = "nanoseconds per round trip",
        .y_name = "largest error, 2⁻³² of a turn",
        .timed = true,
        .described =
            "Cost and largest error of each way to pass an angle to a script; degrees as a double have no error"
    };

    report_plot(&plot);
    for (int i = 0; i < n; i++)
        report_plot_point(ANGLES[i].name, ANGLES[i].standard, time[i].ns, most[i]);
    report_plot_end();
}

void section_border(void)
{
    enum { N_POSITIONS = sizeof POSITIONS / sizeof *POSITIONS, N_ANGLES = sizeof ANGLES / sizeof *ANGLES };
    static int32_t values[VALUES];
    static const int32_t FIRST[] = { INT32_MIN, INT32_MIN + 1, -1, 0, 1, INT32_MAX - 1, INT32_MAX };
    struct lab_rival time[16];
    double most[16];
    struct rng rng;

    rng_seed(&rng, 7);
    for (int i = 0; i < VALUES; i++)
        values[i] = i < 7 ? FIRST[i] : (int32_t)(uint32_t)(rng_next(&rng) >> 32);
    report_section("7. The script interface");
    report_text(
        "Scripts read and write positions in pixels and angles in degrees, as Lua numbers, which are doubles. The "
        "tables show\n"
        "round trips from the engine to a script and back, for random values over the whole range, including its ends. "
        "For the\n"
        "engine's own method, `make accuracy` tries all 2³² values of each type, and `make test` tries %s of them.",
        report_count(VALUES));
    measure(POSITIONS, N_POSITIONS, false, time, most, values);
    bool positions = most[0] == 0 && (lab_exact() || all_come_back(fx_double));
    measure(ANGLES, N_ANGLES, true, time, most, values);
    draw(time, most, N_ANGLES);
    report_text("In the other direction, a script that writes a multiple of 0.1° reads back a value that is at most "
                "%s° off (half of\n"
                "2⁻³² of a turn). Multiples of 360°/2ⁿ are read back unchanged.",
                report_figure(degrees_back()));
    lab_conclude("positions in scripts", "pixels as a double", "all 2³² values survive a round trip through a script",
                 "use text with 14 digits in files", positions);
    lab_conclude("angles in scripts", "degrees as a double",
                 "all 2³² values survive a round trip through a script; a quarter turn is exactly 90",
                 "use whole degrees in hand-written files", most[0] == 0 && (lab_exact() || all_come_back(ang_double)));
}

/*
 * functions.c - the lab's first section: each function of the engine's arithmetic against what could stand in its
 * place. Errors over random arguments of a scene, and separately at the edges of what an argument can be.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lab.h"
#include "rivals.h"
#include "truth.h"
#include "../../../src/base/trig.h"

enum { MOST_RIVALS = 16, MOST_EDGES = 4096 };

static const double RADIANS_AN_ANG = 1.4629180792671596e-9; /* 2 pi / 2^32 */

/* A function, and how it is examined. */
struct quantity {
    const char *title;
    const char *file, *question, *instead; /* NULL: neither a plot nor a conclusion */
    const char *arguments, *unit;
    const struct rivals *rivals;
    int results;
    bool circular; /* results are angles: the error is the shorter way */
    void (*draw)(struct rng *r, struct sample *s);
    int (*edges)(struct sample *out);
    void (*truth)(const struct sample *s, struct truth out[]);
    bool wide;          /* results may leave 32 bits */
    const char *inputs; /* its arguments, a letter each: a b t bits of Q15.16, d dir, e the other angle, g degrees */
};

/* What was found of one rival. */
struct found {
    double max, rms, misrounded;
    int wrong;
};

static struct sample samples[LAB_VALUES], edges[MOST_EDGES];
static struct truth truths[LAB_VALUES][2];

/* ---- arguments ---- */

static void turn_to(struct sample *s, ang dir)
{
    s->dir = dir;
    s->radians = (int32_t)dir * RADIANS_AN_ANG;
    s->rad = (int32_t)floor(s->radians * FX_ONE + 0.5);
}

/* Up to `pixels` either way. */
static fx within(struct rng *r, int pixels)
{
    return (fx)rng_below(r, (uint64_t)pixels * 2 * FX_ONE + 1) - pixels * FX_ONE;
}

/* Between 1 ulp and `bits` bits, each size as likely. */
static fx any_size(struct rng *r, int bits)
{
    uint64_t v = (uint64_t)1 << (bits - 1 - (int)rng_below(r, (uint64_t)bits));

    return (fx)(v | (rng_next(r) & (v - 1)));
}

static void draw_mul(struct rng *r, struct sample *s)
{
    s->a = within(r, 512);
    s->b = within(r, rng_below(r, 2) ? 1 : 16);
}

/* 1/16 to 64 px. */
static fx medium(struct rng *r)
{
    fx high = any_size(r, 10) << 12;

    return high | (fx)rng_below(r, 4096);
}

static void draw_div(struct rng *r, struct sample *s)
{
    s->a = within(r, 512);
    s->b = medium(r);
    s->b *= rng_below(r, 2) ? 1 : -1;
    s->other = 65536.0 / s->b;
}

static void draw_root(struct rng *r, struct sample *s)
{
    s->a = any_size(r, 31);
    s->b = s->a & 0x7fffff; /* what a root may be compared with */
}

static void draw_vector(struct rng *r, struct sample *s)
{
    int far = rng_below(r, 4) ? 512 : 8;

    do {
        s->a = within(r, far);
        s->b = within(r, far);
    } while (s->a == 0 && s->b == 0);
}

static void draw_angle(struct rng *r, struct sample *s)
{
    turn_to(s, (ang)(rng_next(r) >> 32));
}

static void draw_polar(struct rng *r, struct sample *s)
{
    draw_angle(r, s);
    s->a = medium(r);
}

static void set_difference(struct sample *s, ang from, ang to)
{
    s->dir = from;
    s->a = (fx)to;
    s->deg = trig_to_degrees(from);
    s->other = trig_to_degrees(to);
}

static void draw_difference(struct rng *r, struct sample *s)
{
    ang from = (ang)(rng_next(r) >> 32);

    set_difference(s, from, (ang)(rng_next(r) >> 32));
}

static void draw_lerp(struct rng *r, struct sample *s)
{
    s->a = within(r, 512);
    s->b = within(r, 512);
    s->t = (fx)rng_below(r, FX_ONE);
}

static void draw_degrees(struct rng *r, struct sample *s)
{
    s->deg = rng_below(r, 2) ? ((double)rng_below(r, 7201) - 3600) / 10 : lab_random(r, -360, 360);
}

/* ---- edges ---- */

static const fx EDGES[] = {
    FX_MIN, FX_MIN + 1, -200 * FX_ONE, -FX_ONE - 1, -FX_ONE,    -32768, -2,          -1,         0,          1,     2,
    3,      32768,      65535,         FX_ONE,      FX_ONE + 1, 98304,  200 * 65536, 0x40000001, FX_MAX - 1, FX_MAX
};
enum { N_EDGES = sizeof EDGES / sizeof *EDGES };

static const ang TURNS[] = { 0,          1,          2,          0x1fffffff, 0x20000000, 0x20000001,
                             0x3fffffff, 0x40000000, 0x40000001, 0x7fffffff, 0x80000000, 0x80000001,
                             0xa0000000, 0xbfffffff, 0xc0000000, 0xc0000001, 0xfffffffe, 0xffffffff };
enum { N_TURNS = sizeof TURNS / sizeof *TURNS };

static int edges_pair(struct sample *out)
{
    int n = 0;

    for (int i = 0; i < N_EDGES; i++)
        for (int j = 0; j < N_EDGES; j++, n++) {
            out[n].a = EDGES[i];
            out[n].b = EDGES[j];
        }
    return n;
}

static int edges_div(struct sample *out)
{
    int n = 0, all = edges_pair(out);

    for (int i = 0; i < all; i++)
        if (out[i].b)
            out[n++] = out[i];
    return n;
}

static int edges_vector(struct sample *out)
{
    int n = 0, all = edges_pair(out);

    for (int i = 0; i < all; i++)
        if (out[i].a || out[i].b)
            out[n++] = out[i];
    return n;
}

/* The largest arguments whose root is r and the smallest whose root is r + 1, for small, middle and large r. */
static int edges_root(struct sample *out)
{
    int n = 0;

    for (int i = 0; i < N_EDGES; i++)
        if (EDGES[i] > 0)
            out[n++].a = EDGES[i];
    for (int64_t r = 1; r < 11863283; r = r * 5 / 4 + 1) {
        int64_t x = (r * r + r) >> 16;
        out[n++].a = (fx)(x > 0 ? x : 1);
        out[n++].a = (fx)(x + 1);
    }
    return n;
}

static int edges_turn(struct sample *out)
{
    for (int i = 0; i < N_TURNS; i++)
        turn_to(&out[i], TURNS[i]);
    return N_TURNS;
}

static int edges_difference(struct sample *out)
{
    for (int i = 0; i < N_TURNS * N_TURNS; i++)
        set_difference(&out[i], TURNS[i / N_TURNS], TURNS[i % N_TURNS]);
    return N_TURNS * N_TURNS;
}

static int edges_polar(struct sample *out)
{
    int n = 0;

    for (int i = 0; i < N_EDGES; i++)
        for (int j = 0; j < N_TURNS; j++, n++) {
            out[n].a = EDGES[i];
            turn_to(&out[n], TURNS[j]);
        }
    return n;
}

static int edges_lerp(struct sample *out)
{
    static const fx PART_COUNT[] = { FX_MIN, -FX_ONE, -1, 0, 1, 32768, 65535, FX_ONE, FX_MAX };
    int n = 0;

    for (int i = 0; i < N_EDGES; i++)
        for (int j = 0; j < N_EDGES; j++)
            for (size_t k = 0; k < sizeof PART_COUNT / sizeof *PART_COUNT; k++, n++)
                out[n] = (struct sample){ .a = EDGES[i], .b = EDGES[j], .t = PART_COUNT[k] };
    return n;
}

static int edges_degrees(struct sample *out)
{
    int n = 0;

    for (int k = -32; k <= 32; k++)
        for (int e = -1; e <= 1; e++) /* 22.5 degrees, and half an ang on either side, where a double can say that */
            out[n++].deg = k * 22.5 + e * (45.0 / 1073741824);
    out[n++].deg = 1e-300;
    out[n++].deg = -1e-300;
    out[n++].deg = 1048575.9;
    out[n++].deg = -1048575.9;
    return n;
}

/* ---- truths ---- */

static void mul_is(const struct sample *s, struct truth out[])
{
    out[0] = truth_mul(s->a, s->b);
}

static void div_is(const struct sample *s, struct truth out[])
{
    out[0] = truth_div(s->a, s->b);
}

static void sqrt_is(const struct sample *s, struct truth out[])
{
    out[0] = truth_sqrt(s->a);
}

static void rsqrt_is(const struct sample *s, struct truth out[])
{
    out[0] = truth_rsqrt(s->a);
}

static void hypot_is(const struct sample *s, struct truth out[])
{
    out[0] = truth_hypot(s->a, s->b);
}

static void sin_is(const struct sample *s, struct truth out[])
{
    out[0] = truth_sin((int64_t)1 << 32, s->dir);
}

static void cos_is(const struct sample *s, struct truth out[])
{
    out[0] = truth_sin((int64_t)1 << 32, s->dir + 0x40000000);
}

static void atan2_is(const struct sample *s, struct truth out[])
{
    out[0] = truth_atan2(s->b, s->a);
}

static void polar_is(const struct sample *s, struct truth out[])
{
    out[0] = truth_sin((int64_t)s->a * FX_ONE, s->dir + 0x40000000);
    out[1] = truth_sin((int64_t)s->a * FX_ONE, s->dir);
}

static void unit_is(const struct sample *s, struct truth out[])
{
    out[0] = truth_unit(s->a, s->b);
    out[1] = truth_unit(s->b, s->a);
}

static void lerp_is(const struct sample *s, struct truth out[])
{
    out[0] = truth_lerp(s->a, s->b, s->t);
}

static void degrees_is(const struct sample *s, struct truth out[])
{
    out[0] = truth_degrees(s->deg);
}

static void difference_is(const struct sample *s, struct truth out[])
{
    out[0] = (struct truth){ .near = (int64_t)(ang)s->a - s->dir };
}

/* In 2^-29 degrees: 360 / 2^32 is 45 / 2^29. */
static void to_degrees_is(const struct sample *s, struct truth out[])
{
    out[0] = (struct truth){ .near = 45 * (int64_t)s->dir };
}

#define VECTORS "x and y within ±512 px, a quarter of them within ±8 px"
#define ANG     "in units of 2⁻³² turn (1° = 11,930,465)"

static const struct quantity QUANTITIES[] = {
    { "Multiplication", "mul", "a product", "round half up where nothing can overflow",
      "a within ±512 px, b within ±1 or ±16", "in ulp", &rivals_mul, 1, false, draw_mul, edges_pair, mul_is, false,
      "ab" },
    { "Division", "div", "a quotient", "multiply by a stored inverse to divide many numbers by the same divisor",
      "a within ±512 px, b from 1/16 to 64, positive and negative", "in ulp", &rivals_div, 1, false, draw_div,
      edges_div, div_is, false, "ab" },
    { "Square root", "sqrt", "a square root", "compare squares instead of roots: exact and cheaper",
      "all sizes from 1 ulp to 32767", "in ulp", &rivals_sqrt, 1, false, draw_root, edges_root, sqrt_is, false, "a" },
    { "Reciprocal square root", "rsqrt", "1/√x",
      "use trig_normalise for a direction: it rounds each component only once", "all sizes from 1 ulp to 32767",
      "in ulp", &rivals_rsqrt, 1, false, draw_root, edges_root, rsqrt_is, false, "a" },
    { "Length of a vector", "hypot", "a length",
      "compare squares; to sort roughly by distance, add ⅜ of the smaller component to the larger one", VECTORS,
      "in ulp", &rivals_hypot, 1, false, draw_vector, edges_pair, hypot_is, false, "ab" },
    { "Sine", "sin", "a sine", "use a small table for visual effects", "all angles", "in ulp", &rivals_sin, 1, false,
      draw_angle, edges_turn, sin_is, false, "d" },
    { "Cosine", "cos", "a cosine", "use a small table for visual effects", "all angles", "in ulp", &rivals_cos, 1,
      false, draw_angle, edges_turn, cos_is, false, "d" },
    { "Direction of a vector", "atan2", "a direction", "use a table of 1025 entries where a 16-bit angle is enough",
      VECTORS, ANG, &rivals_atan2, 1, true, draw_vector, edges_vector, atan2_is, false, "ab" },
    { "Speed and direction to velocity", "polar", "a velocity", "use fine motion for bullets that live for minutes",
      "speeds from 1/16 to 64 px, all angles", "both components, in ulp", &rivals_polar, 2, false, draw_polar,
      edges_polar, polar_is, false, "ad" },
    { "Normalising a vector", "normalise", "a unit vector", "store speed and direction instead of the vector", VECTORS,
      "both components, in ulp", &rivals_normalise, 2, false, draw_vector, edges_vector, unit_is, false, "ab" },
    { "Interpolation between two values", "lerp", "an interpolated value", "round half up in 64 bits where 0 ≤ t ≤ 1",
      "a and b within ±512 px, 0 ≤ t < 1", "in ulp", &rivals_lerp, 1, false, draw_lerp, edges_lerp, lerp_is, false,
      "abt" },
    { "Degrees to angle", "degrees", "degrees", "multiply by 2³²/360 where ties do not matter",
      "multiples of 0.1° and random numbers within ±360°", ANG, &rivals_degrees, 1, true, draw_degrees, edges_degrees,
      degrees_is, false, "g" },
    { "Difference of two angles", NULL, NULL, NULL, "all pairs of angles", ANG, &rivals_difference, 1, true,
      draw_difference, edges_difference, difference_is, false, "de" },
    { "Angle to degrees", NULL, NULL, NULL, "all angles", "in units of 2⁻²⁹°", &rivals_to_degrees, 1, false, draw_angle,
      edges_turn, to_degrees_is, true, "d" },
};

/* ---- measuring ---- */

/* How far v is from the truth, in its last bits; *wrong: it is not the nearest value there is. */
static double error_of(const struct quantity *q, int64_t v, const struct truth *t, bool *wrong)
{
    if (q->circular) {
        int32_t off = (int32_t)((uint32_t)v - (uint32_t)t->near);
        *wrong = off != 0;
        return fabs(off - t->rest);
    }
    *wrong = v != (q->wide ? t->near : fx_sat(t->near));
    return fabs((double)(v - t->near) - t->rest);
}

static struct found examine(const struct quantity *q, const struct rival *r, int n_edges)
{
    struct found f = { 0 };
    double squares = 0, misrounded = 0, n = (double)LAB_VALUES * q->results;
    int64_t out[2];
    struct truth t[2];
    bool wrong;

    for (int i = 0; i < LAB_VALUES; i++) {
        r->at(&samples[i], out);
        for (int k = 0; k < q->results; k++) {
            double e = error_of(q, out[k], &truths[i][k], &wrong);
            f.max = e > f.max ? e : f.max;
            squares += e * e;
            misrounded += wrong;
        }
    }
    for (int i = 0; i < n_edges; i++) {
        bool any = false;
        r->at(&edges[i], out);
        q->truth(&edges[i], t);
        for (int k = 0; k < q->results; k++) {
            error_of(q, out[k], &t[k], &wrong);
            any |= wrong;
        }
        f.wrong += any;
    }
    f.rms = sqrt(squares / n);
    f.misrounded = misrounded / n;
    return f;
}

/* Half an ulp is the least there can be, so a little more has to show. */
static const char *figure(double v)
{
    return v < 9.9995 ? report_string("%.3f", v) : report_figure(v);
}

/* The result of a library's function: not the same everywhere. Its blanks become such as do not end a figure. */
static const char *loose(bool host, const char *cell)
{
    const char *joined = "≈";

    if (!host)
        return cell;
    for (size_t n; *cell && !lab_exact(); cell += n + (cell[n] == ' ')) {
        n = strcspn(cell, " ");
        joined = report_string("%s%.*s%s", joined, (int)n, cell, cell[n] ? "\u00a0" : "");
    }
    return joined;
}

static void print_row(const struct rival *r, const struct found *f, const struct lab_rival *t, int n_edges)
{
    const char *wrong = report_string("%s of %s", report_count(f->wrong), report_count(n_edges));

    if (!r->at)
        report_row(false, r->name, r->trade, "-", "-", "-", "-", lab_ns(t), lab_ratio(t), r->who, NULL);
    else
        report_row(r->kind == ENGINE, r->name, r->trade, loose(r->host, figure(f->max)), loose(r->host, figure(f->rms)),
                   loose(r->host, report_percent(f->misrounded)), loose(r->host, f->wrong ? wrong : "0"), lab_ns(t),
                   lab_ratio(t), r->who, NULL);
}

static void draw_plot(const struct quantity *q, const struct found found[], const struct lab_rival time[])
{
    const char *described =
        report_string("%s: cost and largest error of each method; lower and further left is better", q->title);
    struct report_plot plot = { .file = q->file,
                                .title = q->title,
                                .x_name = "nanoseconds",
                                .y_name = q->circular ? "largest error, 2⁻³² of a turn" : "largest error, ulp",
                                .timed = true,
                                .described = described };

    report_plot(&plot);
    for (int i = 0; i < q->rivals->n; i++)
        if (q->rivals->row[i].kind != ORACLE && q->rivals->row[i].at)
            report_plot_point(q->rivals->row[i].name, q->rivals->row[i].kind == ENGINE, time[i].ns, found[i].max);
    report_plot_end();
}

/* Nothing that was right here costs much less; a guess without the exact test behind it may cost a third. */
static void conclude(const struct quantity *q, int engine, const struct found found[], const struct lab_rival time[])
{
    bool cheapest = true;

    for (int i = 0; i < q->rivals->n; i++)
        if (q->rivals->row[i].at && found[i].misrounded == 0 && found[i].wrong == 0 && time[i].ratio < 0.33)
            cheapest = false;
    lab_conclude(
        q->question, q->rivals->row[engine].name,
        report_string("every result correctly rounded in these tests and in `make prove`; %s", lab_ns(&time[engine])),
        q->instead, lab_exact() || cheapest);
}

/* ---- the edges, said: from the arrays that were tried ---- */

enum { MOST_SETS = 26, MOST_INPUTS = 3, SET_BYTES = 8192 };

/* The values that one argument takes at the edges, in the order in which they come. */
struct column {
    double of[MOST_EDGES]; /* 32 bits, or degrees: exact */
    int n;
};

static char sets[MOST_SETS][SET_BYTES], edge_rows[64][512];
static int n_sets, n_edge_rows;

static double input_of(const struct sample *s, char which)
{
    switch (which) {
    case 'a':
        return s->a;
    case 'b':
        return s->b;
    case 't':
        return s->t;
    case 'd':
        return s->dir;
    case 'e':
        return (ang)s->a;
    default:
        return s->deg;
    }
}

static const char *input_text(char which, double v)
{
    if (which == 'g')
        return report_string("%.17g", v);
    return which == 'd' || which == 'e' ? report_string("0x%08x", (unsigned)v) : report_string("%.0f", v);
}

static bool has(const struct column *c, double v)
{
    int i = 0;

    while (i < c->n && c->of[i] != v)
        i++;
    return i < c->n;
}

static void take_column(struct column *c, char which, int n_edges)
{
    c->n = 0;
    for (int i = 0; i < n_edges; i++)
        if (!has(c, input_of(&edges[i], which)))
            c->of[c->n++] = input_of(&edges[i], which);
}

/* The letter of a set of values, which is added if it is not there. */
static char set_of(const struct column *c, char which)
{
    static char text[SET_BYTES];
    size_t n = 0;
    int i = 0;

    for (int k = 0; k < c->n && n < sizeof text - 32; k++)
        n += (size_t)snprintf(text + n, sizeof text - n, "%s%s", k ? " " : "", input_text(which, c->of[k]));
    while (i < n_sets && strcmp(sets[i], text) != 0)
        i++;
    if (i == n_sets)
        memcpy(sets[n_sets++], text, n + 1);
    return (char)('A' + i);
}

static bool was_tried(const char *inputs, const double *v, int n_edges)
{
    for (int i = 0; i < n_edges; i++) {
        int k = 0;
        while (inputs[k] && input_of(&edges[i], inputs[k]) == v[k])
            k++;
        if (!inputs[k])
            return true;
    }
    return false;
}

/* Adds the combinations that were not tried to a text: " but (0, 0)". */
static void left_out(const char *inputs, const struct column *c, int n_edges, int all, char *out, size_t size)
{
    size_t n = strlen(out);

    for (int i = 0; i < all; i++) {
        double v[MOST_INPUTS];
        for (int k = 0, at = i; inputs[k]; at /= c[k++].n)
            v[k] = c[k].of[at % c[k].n];
        if (was_tried(inputs, v, n_edges))
            continue;
        n += (size_t)snprintf(out + n, size - n, " but (");
        for (int k = 0; inputs[k]; k++)
            n += (size_t)snprintf(out + n, size - n, "%s%s", k ? ", " : "", input_text(inputs[k], v[k]));
        n += (size_t)snprintf(out + n, size - n, ")");
    }
}

/* Keeps a row of the appendix: what of which set, and how many combinations of them. */
static void note_edges(const struct quantity *q, int n_edges)
{
    static struct column c[MOST_INPUTS];
    char *row = edge_rows[n_edge_rows++];
    size_t n = (size_t)snprintf(row, sizeof edge_rows[0], "%s|", q->title);
    int all = 1;

    for (int k = 0; q->inputs[k]; k++) {
        take_column(&c[k], q->inputs[k], n_edges);
        all *= c[k].n;
        n += (size_t)snprintf(row + n, sizeof edge_rows[0] - n, "%s%c", k ? " × " : "", set_of(&c[k], q->inputs[k]));
    }
    n += (size_t)snprintf(row + n, sizeof edge_rows[0] - n, "|%d|all", n_edges);
    left_out(q->inputs, c, n_edges, all, row, sizeof edge_rows[0]);
}

static void print_edges(void)
{
    report_text("### The edges");
    report_text("The letters stand for the sets below. Each argument of a function has its own set. The tests use "
                "every combination of\n"
                "values from these sets, except where the last column excludes one. Plain numbers are raw Q15.16 "
                "values (65536 is 1), and\n"
                "numbers that start with 0x are raw angles. The values for *Degrees to angle* are in degrees.");
    report_table(NULL, "function|sets|inputs>|combinations");
    for (int i = 0; i < n_edge_rows; i++) {
        const char *cell[4];
        char *at = edge_rows[i];
        for (int k = 0; k < 4; k++) {
            cell[k] = at;
            at += strcspn(at, "|");
            if (*at)
                *at++ = 0;
        }
        report_row(false, cell[0], cell[1], cell[2], cell[3], NULL);
    }
    report_table_end();
    for (int i = 0; i < n_sets; i++)
        report_text("%c: `%s`", 'A' + i, sets[i]);
}

static void measure(const struct quantity *q, uint64_t seed)
{
    struct lab_rival time[MOST_RIVALS];
    struct found found[MOST_RIVALS];
    struct rng rng;
    int engine = 0, n = q->rivals->n;

    rng_seed(&rng, seed);
    memset(samples, 0, sizeof samples);
    memset(edges, 0, sizeof edges);
    for (int i = 0; i < LAB_VALUES; i++) {
        q->draw(&rng, &samples[i]);
        q->truth(&samples[i], truths[i]);
    }
    int n_edges = q->edges(edges);
    note_edges(q, n_edges);
    for (int i = 0; i < n; i++) {
        const struct rival *r = &q->rivals->row[i];
        engine = r->kind == ENGINE ? i : engine;
        found[i] = r->at ? examine(q, r, n_edges) : (struct found){ 0 };
        time[i] = (struct lab_rival){ .run = r->run, .data = samples, .ops = LAB_VALUES };
    }
    lab_time(time, n, engine);
    report_text("### %s", q->title);
    report_text("Arguments: %s. Errors: %s.", q->arguments, q->unit);
    report_table(NULL, "method|gives up|max>|rms>|misrounded>|wrong at edges>|time>|ratio>|use");
    for (int i = 0; i < n; i++)
        print_row(&q->rivals->row[i], &found[i], &time[i], n_edges);
    report_table_end();
    lab_claim(found[engine].misrounded == 0 && found[engine].wrong == 0,
              report_string("%s gives the nearest value everywhere", q->rivals->row[engine].name));
    if (!q->file)
        return;
    draw_plot(q, found, time);
    conclude(q, engine, found, time);
}

void section_functions(void)
{
    rivals_begin();
    report_section("1. Functions");
    report_text("This section compares each arithmetic function in src/base with cheaper and more expensive methods. "
                "The true results are\n"
                "computed to 106 bits of precision. Each function gets %s random arguments of realistic size. The "
                "function is then\n"
                "tested at *edges*, the arguments most likely to cause wrong rounding or overflow. [The "
                "edges](#the-edges) are listed\n"
                "below.\n"
                "\n"
                "*Misrounded* is the share of results that are not the representable value nearest to the true result. "
                "Even the nearest\n"
                "value can be up to 0.5 ulp off. At an edge, the correct result is the true result, "
                "rounded and\n"
                "clamped to the representable range; *wrong at edges* counts all other results.\n"
                "\n"
                "Numbers that depend on the C library (libm) are marked ≈, because libraries differ between systems. "
                "The libfixmath rows\n"
                "use Debian's build of that library. In each plot, a line joins the methods that no other method beats "
                "in both time and\n"
                "error. The plots omit the 106-bit reference.\n"
                "\n"
                "Division by 0, roots of negative numbers and the direction of (0, 0) have no true result, so they are "
                "not tested here.\n"
                "src/base/fx.h and trig.h define the engine's results.",
                report_count(LAB_VALUES));
    for (size_t i = 0; i < sizeof QUANTITIES / sizeof *QUANTITIES; i++)
        measure(&QUANTITIES[i], 1000 + i);
    print_edges();
}

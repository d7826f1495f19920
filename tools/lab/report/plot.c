/*
 * plot.c - plots: points or lines with their names beside them, as SVG.
 *
 * A plot is collected, then scaled to what it holds, so nothing has to be said about axes but their names. It brings
 * its own light background, to be read on dark pages too. Names are put where they cover the least; the widths of
 * texts are estimated, for the reader's font is not known. Coordinates have one decimal, from mathematics that is the
 * same everywhere, so equal data make equal files.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "report.h"

enum {
    MOST_SERIES = 64,
    MOST_POINTS = 4096,
    MOST_TICKS = 64,
    WIDE = 680, /* small, so that a narrow screen does not make it unreadable */
    HIGH = 500,
    LEFT = 84,
    TOP = 62,
    BOTTOM = 440,
    RIGHT_LINES = 486,  /* names of lines stand to the right of it */
    RIGHT_POINTS = 660, /* names of points stand inside */
    ZERO_BAND = 30,     /* below a logarithmic axis, for y = 0 */
    NAME_ROOM = 60,     /* below the lowest point, for names */
    LINE_HIGH = 17,
    FONT = 14,
    DOT = 5,
    LARGE_DOT = 8
};

static const char *const COLOURS[] = { "#3b6ea5", "#2f8a6c", "#8a63a8", "#a9762a", "#4aa3b8",
                                       "#6f8a3a", "#a3527a", "#77685a", "#24507a" };
static const char STANDARD[] = "#cc3d26";

struct series {
    char label[96];
    bool standard, line;
    int first, n;
};

/* A rectangle that is taken. */
struct area {
    double x0, y0, x1, y1;
};

struct axis {
    bool linear, zero;
    double band;          /* of zero, in pixels */
    double low, high;     /* of the scaled values */
    double start, length; /* in pixels; y runs upwards: length < 0 */
};

static struct {
    struct report_plot p;
    struct series series[MOST_SERIES];
    int n_series, n;
    double x[MOST_POINTS], y[MOST_POINTS];
    struct axis ax, ay;
    double zero_y;
    struct area taken[2 * MOST_POINTS];
    int n_taken;
    FILE *f;
} plot;

static void fail(const char *what)
{
    report_fail(report_string("plot %s: %s", plot.p.file, what));
}

void report_plot(const struct report_plot *p)
{
    plot.p = *p;
    plot.n_series = plot.n = plot.n_taken = 0;
}

static void add(double x, double y)
{
    if (plot.n == MOST_POINTS)
        fail("too many points");
    plot.x[plot.n] = x;
    plot.y[plot.n++] = y;
}

static struct series *begin(const char *label, bool standard, bool line)
{
    if (plot.n_series == MOST_SERIES)
        fail("too many series");

    struct series *s = &plot.series[plot.n_series++];

    *s = (struct series){ .standard = standard, .line = line, .first = plot.n };
    for (size_t n = 0; *label && n < sizeof s->label - 1; label++)
        if (*label != '`') /* of Markdown */
            s->label[n++] = *label;
    return s;
}

void report_plot_point(const char *label, bool standard, double x, double y)
{
    begin(label, standard, false)->n = 1;
    add(x, y);
}

void report_plot_line(const char *label, bool standard, const double *x, const double *y, int n)
{
    begin(label, standard, true)->n = n;
    for (int i = 0; i < n; i++)
        add(x[i], y[i]);
}

/* ---- scales ---- */

static double scaled(const struct axis *a, double v)
{
    return a->linear ? v : report_log10(v);
}

static double place(const struct axis *a, double v)
{
    return a->start + a->length * (scaled(a, v) - a->low) / (a->high - a->low);
}

static double place_y(double v)
{
    return v <= 0 && !plot.ay.linear ? plot.zero_y : place(&plot.ay, v);
}

static void fit(struct axis *a, bool linear, const double *v, int n)
{
    bool any = false;

    *a = (struct axis){ .linear = linear };
    for (int i = 0; i < n; i++) {
        if (!linear && v[i] <= 0) {
            a->zero = true;
            continue;
        }
        double s = scaled(a, v[i]);
        a->low = any && a->low < s ? a->low : s;
        a->high = any && a->high > s ? a->high : s;
        any = true;
    }
    if (linear && a->low > 0 && a->low < a->high / 2)
        a->low = 0;
    double room = (a->high - a->low) * 0.05;
    room = room > 0 ? room : 0.5;
    a->low -= linear && a->low == 0 ? 0 : room;
    a->high += room;
}

static double power10(int e)
{
    double v = 1;

    for (; e > 0; e--)
        v *= 10;
    for (; e < 0; e++)
        v /= 10;
    return v;
}

/* The values of the marks along an axis. */
static int ticks(const struct axis *a, double *out)
{
    static const int STEPS[] = { 1, 2, 5 };
    double span = a->high - a->low;
    int n = 0;

    if (a->linear) {
        double step = power10((int)floor(report_log10(span / 6)));
        while (span / step > 8)
            step *= span / step > 16 ? 5 : 2;
        for (double v = ceil(a->low / step) * step; v <= a->high + step * 1e-9 && n < MOST_TICKS; v += step)
            out[n++] = v;
        return n;
    }
    int every = span > 9 ? 2 : 1, steps = span < 3.2 ? 3 : 1;
    for (int e = (int)floor(a->low); e <= a->high; e++)
        for (int i = 0; i < steps; i++) {
            double v = power10(e) * STEPS[i];
            if (e % every == 0 && scaled(a, v) >= a->low && scaled(a, v) <= a->high && n < MOST_TICKS)
                out[n++] = v;
        }
    return n;
}

static const char *superscript(int e)
{
    static const char *const DIGITS[] = { "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹" };

    return report_string("%s%s%s", e < 0 ? "⁻" : "", abs(e) > 9 ? DIGITS[abs(e) / 10] : "", DIGITS[abs(e) % 10]);
}

static const char *tick_name(const struct axis *a, double v, bool percent)
{
    const char *unit = percent ? " %" : "";
    double size = fabs(v);

    if (a->linear || (size > 0.0009 && size < 2e6)) {
        if (size >= 1000)
            return report_string("%s%s", report_count((int64_t)(v + 0.5)), unit);
        return report_string("%.*g%s", 6, v, unit);
    }
    return report_string("10%s%s", superscript((int)floor(report_log10(v) + 0.5)), unit);
}

/* ---- drawing ---- */

static void text(double x, double y, const char *anchor, int size, const char *colour, bool bold, const char *s)
{
    fprintf(plot.f, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" font-size=\"%d\" fill=\"%s\"%s>", x, y, anchor,
            size, colour, bold ? " font-weight=\"bold\"" : "");
    for (; *s; s++) {
        if (*s == '<' || *s == '&')
            fputs(*s == '<' ? "&lt;" : "&amp;", plot.f);
        else
            fputc(*s, plot.f);
    }
    fputs("</text>\n", plot.f);
}

static void line(double x0, double y0, double x1, double y1, const char *colour, double width, const char *more)
{
    fprintf(plot.f, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"%.1f\"%s/>\n",
            x0, y0, x1, y1, colour, width, more);
}

static void draw_axes(double right)
{
    const double bottom = BOTTOM - plot.ay.band;
    double v[MOST_TICKS];
    int n = ticks(&plot.ax, v);

    for (int i = 0; i < n; i++) {
        double x = place(&plot.ax, v[i]);
        line(x, TOP, x, BOTTOM, "#e6e5de", 1, "");
        text(x, BOTTOM + 18, "middle", 13, "#55534d", false, tick_name(&plot.ax, v[i], plot.p.x_percent));
    }
    n = ticks(&plot.ay, v);
    for (int i = 0; i < n; i++) {
        double y = place(&plot.ay, v[i]);
        line(LEFT, y, right, y, "#e6e5de", 1, "");
        text(LEFT - 8, y + 4, "end", 13, "#55534d", false, tick_name(&plot.ay, v[i], plot.p.y_percent));
    }
    if (plot.ay.zero) {
        line(LEFT, bottom + 8, right, bottom + 8, "#b9b7ae", 1, " stroke-dasharray=\"2 4\"");
        line(LEFT, plot.zero_y, right, plot.zero_y, "#e6e5de", 1, "");
        text(LEFT - 8, plot.zero_y + 4, "end", 13, "#55534d", false, "0");
    }
    line(LEFT, BOTTOM, right, BOTTOM, "#8b897f", 1, "");
    line(LEFT, TOP, LEFT, BOTTOM, "#8b897f", 1, "");
    text((LEFT + right) / 2, BOTTOM + 44, "middle", FONT, "#33322e", false, plot.p.x_name);
    text(LEFT - 66, TOP - 11, "start", FONT, "#33322e", false, plot.p.y_name);
}

static const char *colour_of(int i)
{
    int k = 0;

    if (plot.series[i].standard)
        return STANDARD;
    for (int j = 0; j < i; j++)
        k += !plot.series[j].standard;
    return plot.series[i].line ? COLOURS[k % (int)(sizeof COLOURS / sizeof *COLOURS)] : "#3b6ea5";
}

/* ---- names ---- */

static double width_of(const struct series *s)
{
    double n = 0;

    for (const char *c = s->label; *c; c++)
        n += (*c & 0xc0) != 0x80;
    return n * (s->standard ? 7.8 : 7.1) + 2;
}

static void take(double x0, double y0, double x1, double y1)
{
    if (plot.n_taken < (int)(sizeof plot.taken / sizeof *plot.taken))
        plot.taken[plot.n_taken++] = (struct area){ x0, y0, x1, y1 };
}

/* How much of what is taken the rectangle covers, and of what is outside the frame. */
static double covers(struct area a)
{
    double sum = 0;

    for (int i = 0; i < plot.n_taken; i++) {
        const struct area *t = &plot.taken[i];
        double w = (a.x1 < t->x1 ? a.x1 : t->x1) - (a.x0 > t->x0 ? a.x0 : t->x0);
        double h = (a.y1 < t->y1 ? a.y1 : t->y1) - (a.y0 > t->y0 ? a.y0 : t->y0);
        sum += w > 0 && h > 0 ? w * h : 0;
    }
    if (a.x0 < LEFT + 2 || a.x1 > RIGHT_POINTS || a.y0 < TOP || a.y1 > BOTTOM - 2)
        sum += 4000;
    return sum;
}

/* A way from a point to the near side of its name, in steps that are small rectangles. */
struct leader {
    double x0, y0, x1, y1;
    int steps;
};

static struct leader leader_to(double px, double py, struct area a)
{
    double ex = px < a.x0 ? a.x0 - 2 : px > a.x1 ? a.x1 + 2 : px, ey = py < a.y0 ? a.y0 : py > a.y1 ? a.y1 : py;
    double far = sqrt((ex - px) * (ex - px) + (ey - py) * (ey - py));

    return (struct leader){ px, py, ex, ey, far > 13 ? (int)(far / 3) : 0 };
}

static struct area leader_step(const struct leader *l, int i)
{
    double x = l->x0 + (l->x1 - l->x0) * i / l->steps, y = l->y0 + (l->y1 - l->y0) * i / l->steps;

    return (struct area){ x - 1.5, y - 1.5, x + 1.5, y + 1.5 };
}

/* What the leader runs over, its own dot left out; crossing something is worse than touching a rim. */
static double crosses(const struct leader *l)
{
    double sum = 0;

    for (int i = 10 / 3; i < l->steps; i++)
        sum += 6 * covers(leader_step(l, i));
    return sum;
}

/* Puts the name of a point in the best of the places around it; a thin line leads to it from afar. */
static void name_point(int i)
{
    static const double WAYS[][2] = { { 1, 0 },   { -1, 0 }, { 0, -1 },  { 0, 1 },    { 1, -1 },    { 1, 1 },
                                      { -1, -1 }, { -1, 1 }, { 1, 0.5 }, { 1, -0.5 }, { -1, -0.5 }, { -1, 0.5 } };
    const struct series *s = &plot.series[i];
    double px = place(&plot.ax, plot.x[s->first]), py = place_y(plot.y[s->first]), w = width_of(s), least = 1e30;
    struct area best = { 0, 0, 0, 0 };

    for (int far = 0; far < 10; far++)
        for (int k = 0; k < (int)(sizeof WAYS / sizeof *WAYS); k++) {
            double gap = (s->standard ? LARGE_DOT : DOT) + 4 + 12 * far, dx = WAYS[k][0] * gap,
                   dy = WAYS[k][1] * (gap + (dx == 0 ? 5 : 0));
            double x0 = px + dx - (dx < 0 ? w : dx > 0 ? 0 : w / 2);
            struct area a = { x0, py + dy - LINE_HIGH / 2.0, x0 + w, py + dy + LINE_HIGH / 2.0 };
            struct leader l = leader_to(px, py, a);
            double cost = covers(a) + crosses(&l) + far * 12 + k * 0.5;
            if (cost < least) {
                least = cost;
                best = a;
            }
        }
    struct leader l = leader_to(px, py, best);
    for (int k = 10 / 3; k < l.steps; k++) {
        struct area a = leader_step(&l, k);
        take(a.x0, a.y0, a.x1, a.y1);
    }
    take(best.x0, best.y0, best.x1, best.y1);
    if (l.steps)
        line(l.x0, l.y0, l.x1, l.y1, "#a8a69c", 0.8, "");
    bool left = best.x1<px, right = best.x0> px; /* of the point: the name is set from its near end */
    text(right  ? best.x0
         : left ? best.x1
                : px,
         best.y1 - 4,
         right  ? "start"
         : left ? "end"
                : "middle",
         FONT, s->standard ? STANDARD : "#33322e", s->standard, s->label);
}

/* Points that cannot be told apart have one name: the first's, the others' behind it. */
static void merge_names(void)
{
    for (int i = 0; i < plot.n_series; i++)
        for (int k = 0; k < i; k++) {
            struct series *a = &plot.series[k], *b = &plot.series[i];
            double x = place(&plot.ax, plot.x[a->first]) - place(&plot.ax, plot.x[b->first]);
            double y = place_y(plot.y[a->first]) - place_y(plot.y[b->first]);
            size_t n = strlen(a->label);
            if (a->line || b->line || a->standard || b->standard || !*a->label || x * x + y * y > DOT * DOT ||
                n + strlen(b->label) > 40)
                continue;
            snprintf(a->label + n, sizeof a->label - n, " / %s", b->label);
            *b->label = 0;
            break;
        }
}

static void draw_points(void)
{
    for (int i = 0; i < plot.n_series; i++) {
        const struct series *s = &plot.series[i];
        double x = place(&plot.ax, plot.x[s->first]), y = place_y(plot.y[s->first]), r = s->standard ? LARGE_DOT : DOT;
        if (!s->line)
            take(x - r, y - r, x + r, y + r);
    }
    merge_names();
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < plot.n_series; i++)
            if (!plot.series[i].line && plot.series[i].standard == (pass == 0) && *plot.series[i].label)
                name_point(i);
    for (int pass = 0; pass < 2; pass++) /* the large one below: it hides nothing */
        for (int i = 0; i < plot.n_series; i++) {
            const struct series *s = &plot.series[i];
            if (s->line || s->standard != (pass == 0))
                continue;
            fprintf(plot.f,
                    "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%d\" fill=\"%s\" stroke=\"#fcfcfa\" stroke-width=\"1.2\"/>\n",
                    place(&plot.ax, plot.x[s->first]), place_y(plot.y[s->first]), s->standard ? LARGE_DOT : DOT,
                    colour_of(i));
        }
}

/* The point that is next to the right on the front, which is below y: the leftmost of those, the lowest of these. */
static int next_of_front(double y)
{
    int best = -1;

    for (int i = 0; i < plot.n; i++)
        if (plot.y[i] < y &&
            (best < 0 || plot.x[i] < plot.x[best] || (plot.x[i] == plot.x[best] && plot.y[i] < plot.y[best])))
            best = i;
    return best;
}

/* A line in steps through the points that nothing beats in both; names keep off it. */
static void draw_front(void)
{
    int i = next_of_front(HUGE_VAL), next = next_of_front(plot.y[i]);

    if (next < 0)
        return;
    text(RIGHT_POINTS, TOP - 11, "end", 12, "#8f6b1f", false, "line: best trade-offs of time and error");
    fprintf(plot.f, "<path fill=\"none\" stroke=\"#c9a04a\" stroke-width=\"1.2\" d=\"M%.1f,%.1f",
            place(&plot.ax, plot.x[i]), place_y(plot.y[i]));
    for (; next >= 0; i = next, next = next_of_front(plot.y[i])) {
        double x0 = place(&plot.ax, plot.x[i]), y0 = place_y(plot.y[i]);
        double x1 = place(&plot.ax, plot.x[next]), y1 = place_y(plot.y[next]);
        fprintf(plot.f, "H%.1fV%.1f", x1, y1);
        take(x0, y0 - 1, x1, y0 + 1);
        take(x1 - 1, y0, x1 + 1, y1);
    }
    fprintf(plot.f, "\"/>\n");
}

static void draw_line(int i)
{
    const struct series *s = &plot.series[i];

    fprintf(plot.f, "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"%s\" stroke-linejoin=\"round\" points=\"",
            colour_of(i), s->standard ? "3.4" : "1.8");
    for (int k = s->first; k < s->first + s->n; k++)
        fprintf(plot.f, "%s%.1f,%.1f", k == s->first ? "" : " ", place(&plot.ax, plot.x[k]), place_y(plot.y[k]));
    fprintf(plot.f, "\"/>\n");
    for (int k = s->first; s->n <= 16 && k < s->first + s->n; k++)
        fprintf(plot.f, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%s\" fill=\"%s\"/>\n", place(&plot.ax, plot.x[k]),
                place_y(plot.y[k]), s->standard ? "4" : "2.6", colour_of(i));
}

/* Names of lines in the order of their ends, pushed apart just far enough. */
static void name_lines(double right)
{
    int order[MOST_SERIES], n = 0;
    double want[MOST_SERIES], at[MOST_SERIES];

    for (int i = 0; i < plot.n_series; i++) {
        if (!plot.series[i].line)
            continue;
        double y = place_y(plot.y[plot.series[i].first + plot.series[i].n - 1]);
        int k = n++;
        for (; k > 0 && want[k - 1] > y; k--) {
            want[k] = want[k - 1];
            order[k] = order[k - 1];
        }
        want[k] = y;
        order[k] = i;
    }
    memcpy(at, want, sizeof at);
    for (int round = 0; round < 400; round++)
        for (int k = 1; k < n; k++) {
            double push = (LINE_HIGH + 1 - (at[k] - at[k - 1])) / 2;
            if (push > 0) {
                at[k] += push;
                at[k - 1] -= push;
            }
        }
    for (int k = 0; k < n; k++) {
        const struct series *s = &plot.series[order[k]];
        double x = place(&plot.ax, plot.x[s->first + s->n - 1]);
        line(x + 4, want[k], right + 12, at[k], colour_of(order[k]), 0.8, " stroke-opacity=\"0.6\"");
        text(right + 15, at[k] + 5, "start", FONT, colour_of(order[k]), s->standard, s->label);
    }
}

static void draw(void)
{
    bool lines = false;

    for (int i = 0; i < plot.n_series; i++)
        lines |= plot.series[i].line;
    double right = lines ? RIGHT_LINES : RIGHT_POINTS;
    fit(&plot.ax, plot.p.x_linear, plot.x, plot.n);
    fit(&plot.ay, plot.p.y_linear, plot.y, plot.n);
    if (plot.ax.zero)
        fail("x = 0 on a logarithmic axis");
    plot.ax.start = LEFT;
    plot.ax.length = right - LEFT;
    plot.ay.band = !plot.ay.zero ? 0 : lines ? ZERO_BAND : ZERO_BAND + NAME_ROOM;
    plot.ay.start = BOTTOM - plot.ay.band;
    plot.ay.length = TOP - plot.ay.start;
    plot.zero_y = lines ? BOTTOM - 9 : BOTTOM - NAME_ROOM;
    if (!lines && !plot.ay.zero)
        plot.ay.low -= (plot.ay.high - plot.ay.low) * NAME_ROOM / (BOTTOM - TOP - NAME_ROOM);

    fprintf(plot.f,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" "
            "font-family=\"Helvetica, Arial, sans-serif\">\n"
            "<rect x=\"0.5\" y=\"0.5\" width=\"%d\" height=\"%d\" rx=\"8\" fill=\"#fcfcfa\" stroke=\"#d8d6cc\"/>\n",
            WIDE, HIGH, WIDE, HIGH, WIDE - 1, HIGH - 1);
    text(LEFT - 66, 28, "start", 17, "#22211e", true, plot.p.title);
    draw_axes(right);
    if (!lines)
        draw_front();
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < plot.n_series; i++)
            if (plot.series[i].line && plot.series[i].standard == (pass == 1))
                draw_line(i);
    name_lines(right);
    draw_points();
    fprintf(plot.f, "</svg>\n");
}

void report_plot_end(void)
{
    plot.f = report_plot_file(plot.p.file, plot.p.timed);
    if (plot.f) {
        draw();
        if (fclose(plot.f))
            fail("cannot be written");
    }
    report_text("![%s](%s/%s.svg)", plot.p.described, report_page(), plot.p.file);
}

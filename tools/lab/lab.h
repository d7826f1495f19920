/*
 * lab.h - the accuracy lab: sections measure, and print what they found as text, tables and plots of docs/accuracy.md.
 * floor: tools
 *
 * A figure that depends on the machine begins with the character "≈" and ends before the next blank or bar. With
 * `lab --exact` no time is taken and each of them is "≈" alone, so two pages can be compared. All other figures must be
 * the same wherever the lab runs: integers and doubles with + - * / and sqrt, printed with few digits.
 */
#ifndef LAB_LAB_H
#define LAB_LAB_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../src/base/rng.h"

/* ---- sections, called in this order ---- */

void section_functions(void);
void section_collision(void);
void section_positions(void);
void section_angles(void);
void section_acceleration(void);
void section_broad(void);
void section_border(void);
void section_models(void);

/* No times are to be taken. */
bool lab_exact(void);

/* ---- text ---- */

#ifdef __GNUC__
#define LAB_PRINTF(n) __attribute__((format(printf, n, n + 1)))
#else
#define LAB_PRINTF(n)
#endif

/* "## TITLE"; it begins a section. */
void lab_section(const char *title);

/* Markdown as it stands, followed by an empty line. */
void lab_text(const char *format, ...) LAB_PRINTF(1);

/* A string that stays good for the next 64 calls. */
const char *lab_string(const char *format, ...) LAB_PRINTF(1);

/* A figure with 2 or 3 significant digits: "0", "0.00012", "3.4", "120", "1,200,000"; "1.5e-9" below 10^-5. */
const char *lab_figure(double v);

/* A whole number with thousands: "65,536". */
const char *lab_count(int64_t n);

/* A share of one as "12.3 %". "0" is exactly none; "<0.01 %" is a little. */
const char *lab_percent(double share);

/* ---- tables ---- */

/* Columns are separated by '|'; one that ends in '>' is set to the right. title may be NULL. */
void lab_table(const char *title, const char *columns);

/* A row: each cell a string, the last followed by NULL. The engine's own default (standard) is set bold and marked. */
void lab_row(int standard, ...);
void lab_table_end(void);

/* ---- times ---- */

enum { LAB_VALUES = 65536 }; /* random values a timed loop walks: more than a branch predictor learns */

/* One rival of a table. `run` does `ops` operations; it must be out of line and its result must reach lab_sink. */
struct lab_rival {
    void (*run)(void *data);
    void *data;
    double ops;
    double ns, low, high; /* out: an operation's median and quartiles over the rounds; 0 with --exact */
    double ratio;         /* out: ns / the default's ns; 0 with --exact */
};

/* Runs all rivals in turn, round by round. rivals[standard] is the engine's default, whose ratio is 1. */
void lab_time(struct lab_rival *rivals, int n, int standard);

/* Cells: "≈2.31±0.05 ns", where ± is half the distance of the quartiles, or µs for ops = 1000; and "≈1.25". */
const char *lab_ns(const struct lab_rival *r);
const char *lab_us(const struct lab_rival *r);
const char *lab_ratio(const struct lab_rival *r);

/* Any other figure that follows from times: "≈" and the digits, or "≈" alone. */
const char *lab_about(double v);

extern volatile int64_t lab_sink;

/* ---- conclusions, for the table that opens the page ---- */

/*
 * One line of it. `justified` says whether the figures just measured bear it out; if not, the lab says so and ends with
 * exit code 1. What follows from times is only asked without --exact: pass lab_exact() || (...).
 */
void lab_conclude(const char *question, const char *engine, const char *because, const char *instead, bool justified);

/* A claim of the text. If it does not hold, the lab says so and ends with exit code 1. */
void lab_claim(bool holds, const char *claim);

/* ---- plots: accuracy/FILE.svg, shown where lab_plot_end is called ---- */

struct lab_plot {
    const char *file, *title;
    const char *x_name, *y_name;
    bool x_linear, y_linear; /* else logarithmic */
    bool x_percent, y_percent;
    bool timed;            /* some coordinate is a time: not written with --exact, and not compared */
    const char *described; /* the alternative text: what the reader is to see in it */
};

void lab_plot(const struct lab_plot *plot);

/* A labelled point. y = 0 on a logarithmic axis stands on a line of its own, "0". */
void lab_plot_point(const char *label, bool standard, double x, double y);

/* A line with its label at its end. */
void lab_plot_line(const char *label, bool standard, const double *x, const double *y, int n);
void lab_plot_end(void);

/* ---- mathematics that gives the same bits everywhere; good to about 2^-50 ---- */

double lab_log10(double x);

/* Cosine and sine of a fraction of a turn. */
void lab_direction(double turns, double *c, double *s);

/* Uniform in [low, high). */
double lab_random(struct rng *r, double low, double high);

/* ---- for main.c ---- */

void lab_begin(bool exact, const char *folder);

/* Writes the page: title, machine, conclusions, then what the sections printed. The exit code. */
int lab_finish(void);

/* The folder for the page's plots; opens FILE.svg in it. */
void *lab_plot_file(const char *file);

#endif

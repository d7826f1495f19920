/*
 * lab.h - the accuracy lab: sections measure, and report what they found: text, tables and plots of
 * docs/measured/accuracy.md.
 *
 * A figure that depends on the machine begins with the character "≈" and ends before the next blank or bar. With
 * `lab --exact` no time is taken and each of them is "≈" alone, so two pages can be compared. All other figures must be
 * the same wherever the lab runs: integers and doubles with + - * / and sqrt, printed with few digits.
 */
#ifndef LAB_LAB_H
#define LAB_LAB_H

#include "../../../src/base/rng.h"
#include "../report/report.h"

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

/* ---- mathematics that gives the same bits everywhere; good to about 2^-50 ---- */

/* Cosine and sine of a fraction of a turn. */
void lab_direction(double turns, double *c, double *s);

/* Uniform in [low, high). */
double lab_random(struct rng *r, double low, double high);

/* ---- for main.c ---- */

void lab_begin(bool exact, const char *folder);

/* Writes the page: title, machine, conclusions, then what the sections printed. The exit code. */
int lab_finish(void);

#endif

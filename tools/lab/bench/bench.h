/*
 * bench.h - what `make bench` is made of: sections that measure and report, their clock, and the targets they are held
 * to.
 */
#ifndef BENCH_BENCH_H
#define BENCH_BENCH_H

#include "../../../src/demo/demo.h"
#include "../report/report.h"
#include "scene.h"

/* ---- sections, called in this order ---- */

void section_machine(void);
void section_boss(void);
void section_crowd(void);
void section_prices(void);
void section_battle(void);
void section_pictures(void);
void section_lasers(void);
void section_together(void);
void section_threads(void);
void section_game(void);
void section_games(void);
void section_rewind(void);
void section_replay(void);
void section_memory(void);
void section_sound(void);
void section_guards(void);

/* The end of section "prices": what is only seen; and what of a script's time is Lua's own. */
void looks_prices(void);
void floor_prices(void);

/* The end of section "pictures": backgrounds. */
void scenery_prices(void);

/* ---- times ---- */

/* Nanoseconds of a clock that never goes back. */
double bench_now(void);

/* How long ago that was, less what reading the clock takes. */
double bench_since(double from);

/* From now on bench_now is the thread's own time, for what takes longer than some 100 us; or the wall's again. */
void bench_own_clock(bool on);

/* The clock for what took so long last time: the thread's own if that is long enough to be interrupted. */
void bench_clock_for(double ns);

/* Times of one thing. */
struct samples {
    double *ns;
    int n, room;
};

void samples_add(struct samples *s, double ns);
void samples_free(struct samples *s);

/* The share of the samples below it is `share`: 0.5 is the median. */
double samples_quantile(const struct samples *s, double share);
double samples_median(const struct samples *s);

/* The median of a's samples in b's, each in that which was taken in its turn: the same number. */
double samples_ratio(const struct samples *a, const struct samples *b);

/* Looks how fast the machine's clock is: once a round. And says how fast it was since that was said last. */
void bench_look(void);
void bench_say_clock(void);

/* "2.31±0.05": the median of the samples, each divided by `by`, and half the distance of their quartiles. */
const char *samples_figure(const struct samples *s, double by);

/* Where a frame's time goes: a board's phases, and what a window does then. */
enum lap { LAP_SCRIPTS, LAP_MOTION, LAP_HITS, LAP_EVENTS, LAP_REST, LAP_DRAW, LAP_PRESENT, LAPS };

/* A clock for one board, to be read as the frame goes on. */
struct laps {
    double last, ns[LAPS];
};

/* board_set_phase_callback's: pass it with a struct laps. */
void laps_phase(void *laps, enum board_phase phase);

/* A frame begins. */
void laps_begin(struct laps *l);

/* What ran since the last of these was `lap`. */
void laps_end(struct laps *l, enum lap lap);

/* ---- scenes of roms/bench ---- */

/* Opens one, or ends the program. */
void bench_scene(struct scene *s, const struct scene_want *want);

/* A tick; a fault ends the program. */
void bench_tick(struct scene *s);

/* roms/bench itself. */
const struct rom *bench_rom(void);

/* ---- the built-in game ---- */

#define BENCH_GAME "roms/glasstide"
#define BENCH_DEMO BENCH_GAME "/demos/run.demo"

/* Loads it and its whole run, or ends the program. */
void bench_game(struct rom_image *game, struct demo *run);

/* ---- the machine's limits, as plain C meets them ---- */

/* Bytes a nanosecond of x[i] += v[i] over that many bytes of columns, two of three parts read and one written back. */
double limit_update(size_t bytes);

/* Nanoseconds an 8-byte store takes when 8 of them go to 8 lines of a picture. */
double limit_store(void);

/* ---- claims ---- */

/* A line of the table of targets that opens the page. */
void bench_target(const char *what, const char *goal, const char *measured, bool met);

/* What must be so whatever the machine; if not, the bench says so and ends with exit code 1. */
void bench_claim(const char *wrong, const char *where);

#endif

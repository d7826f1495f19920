/*
 * side.h - one of two runs of a document that are compared frame by frame: libbulletml's or the board's.
 */
#ifndef BULLETML_SIDE_H
#define BULLETML_SIDE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What both sides are given. */
struct side_setup {
    const char *file;
    double rank;
    uint32_t seed; /* of the stream that $rand draws from, random.h; not 0 */
    bool loop;     /* a root that has come to its end starts anew */
};

/* A bullet where the reference has it: the origin in the middle of the field, in px. */
struct side_bullet {
    int32_t id;              /* numbered by creation, from 1 */
    double x, y, dir, speed; /* degrees and px a frame; the reference's alone */
};

/* The root of a document is no bullet; it does not leave the field either. */
enum { SIDE_MOST = 20000 /* bullets alive: a further one is not made */, SIDE_ERROR = 200 };

struct side {
    /* One frame with the player there; all bullets that are alive after it, by number. -1: `error` says why. */
    int32_t (*frame)(struct side *s, int32_t player_x, int32_t player_y, const struct side_bullet **out);

    /* Those of these numbers are taken away, after each frame; one that is gone is passed over. */
    bool (*leave)(struct side *s, const int32_t *ids, int32_t n);

    void (*close)(struct side *s);

    /* A document libbulletml cannot bear: it crashed, or a frame had no end. Only of the reference. */
    bool broke;
    char error[SIDE_ERROR];
    void *own;
};

/* How a side made of libbulletml rounds what doubles cannot hold. All are as right as the first. */
enum side_rounding { ROUND_NEAREST, ROUND_DOWN, ROUND_UP, ROUND_ZERO, SIDE_ROUNDINGS };
extern const char *const side_rounding_name[SIDE_ROUNDINGS];

/* The document in a process of its own (apart.c), which ends after APART_SECONDS of the processor's time. */
enum { APART_SECONDS = 40 };
bool side_apart(struct side *s, const struct side_setup *setup, enum side_rounding rounding);

/* The document on a board (board.c). */
bool side_board(struct side *s, const struct side_setup *setup);

/* Numbers in [0, 1) of 24 bits, the stream that bullet.ml draws from: Marsaglia's xorshift with 13, 17 and 5. */
static inline double side_random(void *state)
{
    uint32_t *s = state;

    *s ^= *s << 13;
    *s ^= *s >> 17;
    *s ^= *s << 5;
    return (double)(*s >> 8) / (1 << 24);
}

/* Where the player is: round a square on its point, in whole px. */
static inline int32_t side_swing(int32_t frame, int32_t period, int32_t reach)
{
    const int32_t quarter = period / 4, step = reach / quarter, at = frame % period;

    return at < quarter ? at * step : at < 3 * quarter ? reach - (at - quarter) * step : (at - period) * step;
}

static inline int32_t side_player_x(int32_t frame)
{
    return side_swing(frame, 240, 120);
}

static inline int32_t side_player_y(int32_t frame)
{
    return 60 + side_swing(frame, 160, 40);
}

#endif

/*
 * sparks.h - particles. They are outside the board's hash and scripts cannot read them; they have their own random
 * stream and their own hash.
 */
#ifndef ENTITIES_SPARKS_H
#define ENTITIES_SPARKS_H

#include "../base/fx.h"
#include "../base/rng.h"
#include "motion.h"
#include "../base/slots.h"

enum {
    SPARK_BANK = 15,      /* in a kind's `bank`: the palette banks to add */
    SPARK_BLEND = 3 << 4, /* blend mode in units of SPARK_BLEND_ONE: 0 opaque, otherwise blend + 1 */
    SPARK_BLEND_ONE = 1 << 4,
    SPARK_UNDER_PLAYERS = 1 << 6, /* drawn under players and bullets */
    SPARK_DOT = 65535,            /* in a kind's `sprite`: no sprite; its sparks are dots */
    SPARK_MAX_BANKS = 8 /* maximum banks of a kind over a spark's lifetime; the second and later ones are in the rows
                           * after the kind's, which have life 0 */
};

/* Declared by spark.def. */
struct spark_kinds {
    struct slots s;
    uint16_t *sprite;
    uint16_t *lifetime; /* frames */
    fx *gravity;        /* downward acceleration, px/frame^2 */
    fx *drag;           /* share of the velocity lost each frame, 0 to 1 */
    uint8_t *bank;      /* bank and blend: SPARK_ bits */
};

struct sparks {
    struct slots s;
    fx *x, *y, *vx, *vy;
    uint16_t *kind;
    uint16_t *age;
    uint64_t stream[4];
};

struct spark_burst {
    fx x, y, speed;
    ang dir, spread;     /* directions are within dir +- spread/2; spread UINT32_MAX: full circle */
    fx radius;           /* radius of a ring on which sparks start evenly spaced, flying outwards, turned by dir; 0:
                          * none */
    fx line_dx, line_dy; /* vector of a line from (x, y) on which sparks start evenly spaced, both ends included */
    uint16_t kind;
    uint32_t n;
};

extern const struct chip sparks_chip, spark_kinds_chip;

/* Spawns n sparks, each with a random direction within the spread and a random speed from 1/2 to 1 of `speed`. Sparks
 * that do not fit into the pool are dropped. */
void sparks_burst(struct sparks *s, const struct spark_burst *burst);

/* Returns the `bank` of a spark of that age: each of the kind's n banks applies for 1/n of the lifetime. */
uint8_t sparks_bank(const struct spark_kinds *kinds, uint16_t kind, uint16_t age);
void sparks_move(struct sparks *s, const struct spark_kinds *kinds, const struct box *keep_box);

#endif

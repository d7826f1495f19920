/*
 * sparks.h - particles: unhashed, no script can read them. They have their own random stream and their own hash.
 */
#ifndef ENTITIES_SPARKS_H
#define ENTITIES_SPARKS_H

#include "../base/fx.h"
#include "../base/rng.h"
#include "motion.h"
#include "../base/slots.h"

enum {
    SPARK_BANK = 15,      /* of a kind's `bank`: banks to add */
    SPARK_BLEND = 3 << 4, /* how it is drawn, in units of SPARK_BLEND_ONE: 0 opaque, else blend + 1 */
    SPARK_BLEND_ONE = 1 << 4,
    SPARK_UNDER = 1 << 6, /* drawn under players and bullets */
    SPARK_BANKS = 8       /* one after the other in a life: each but the first is a row after its kind's, with life 0 */
};

/* What spark.def declares. */
struct spark_kinds {
    struct slots s;
    uint16_t *sprite;
    uint16_t *life; /* frames */
    fx *gravity;    /* px/frame more downwards, a frame */
    fx *drag;       /* share of the velocity lost a frame, 0 to 1 */
    uint8_t *bank;  /* and blend: SPARK_ */
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
    ang dir, spread;     /* thrown within dir +- spread/2; UINT32_MAX: all round */
    fx radius;           /* of a ring they start on, evenly, each thrown outwards, turned by dir; 0: none */
    fx along_x, along_y; /* of a line they start on, evenly, from (x, y) on, both ends included */
    uint16_t kind;
    uint32_t n;
};

extern const struct chip sparks_chip, spark_kinds_chip;

/* Throws n sparks, each at a random direction within the spread and a speed of 1/2 to 1 of `speed`. No room: no spark.
 */
void sparks_burst(struct sparks *s, const struct spark_burst *burst);

/* `bank` of a spark of that age: of n, each for a share of 1/n of the life. */
uint8_t sparks_bank(const struct spark_kinds *kinds, uint16_t kind, uint16_t age);
void sparks_move(struct sparks *s, const struct spark_kinds *kinds, const struct box *keep);

#endif

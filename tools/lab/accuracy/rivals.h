/*
 * rivals.h - the engine's functions and what could stand in their places, for the lab's first section.
 */
#ifndef LAB_RIVALS_H
#define LAB_RIVALS_H

#include "../../../src/base/fx.h"

/* One set of arguments. Each quantity says below which it uses. */
struct sample {
    fx a, b, t;
    ang dir;
    int32_t rad; /* dir as radians in Q15.16, -pi to pi */
    double deg;
    union {
        double radians; /* dir likewise */
        double other;   /* division: 65536 / b; difference: degrees of the other angle */
    };
};

/* An oracle is too slow to stand in a plot with the others. */
enum rival_kind { CHEAPER, ENGINE, DEARER, LIBRARY, ORACLE };

struct rival {
    enum rival_kind kind;
    bool host; /* its results are the C library's, so its errors depend on the machine */
    const char *name, *trade;
    void (*run)(void *data);                           /* LAB_VALUES samples, for lab_time */
    void (*at)(const struct sample *s, int64_t out[]); /* one, in the engine's last bits; NULL: another question */
    const char *who;
};

struct rivals {
    const struct rival *row;
    int n;
};

/* Arguments: a, b; sqrt and rsqrt a; sin, cos and polar dir, polar's speed a; atan2, hypot and normalise x = a, y = b;
 * lerp a, b, t; degrees deg; difference from dir to a, as degrees from deg to other; to_degrees dir. polar and
 * normalise have two results. */
extern const struct rivals rivals_mul, rivals_div, rivals_sqrt, rivals_rsqrt, rivals_hypot, rivals_sin, rivals_cos,
    rivals_atan2, rivals_polar, rivals_normalise, rivals_lerp, rivals_degrees, rivals_difference, rivals_to_degrees;

/* Fills the tables of those that look things up. */
void rivals_begin(void);

/* The engine's integer twins. */
fx twin_div(fx a, fx b);
fx twin_sqrt(fx x);
fx twin_rsqrt(fx x);
fx twin_hypot(fx x, fx y);
ang twin_atan2(fx y, fx x);
void twin_polar(fx speed, ang dir, fx *vx, fx *vy);
void twin_normalise(fx x, fx y, fx *ux, fx *uy);

#endif

/*
 * reference.h - the crowd of roms/bench in plain C, three times, with nothing of the engine: what it is measured and
 * checked against.
 *
 *     array      an array of structs of doubles; every bullet is looked at, every pixel asked whether it is opaque
 *     columns    columns of int32; blocks of 64 go through one loop without branches; rows of 8 pixels are masked words
 *     least      the same with vectors, and without all that this one scene could do without: it counts what is moved,
 *                hit and drawn alone
 *
 * All keep a kind's bullets together, in the order in which they are drawn, so that neither has to sort.
 */
#ifndef BENCH_REFERENCE_H
#define BENCH_REFERENCE_H

#include <stdbool.h>
#include <stdint.h>

enum {
    CROWD_KINDS = 16,
    CROWD_SIDE = 8,  /* px of a bullet's picture, each way */
    CROWD_LEG = 60,  /* frames a bullet flies between two turns */
    CROWD_GUARD = 48 /* px round the picture, so that nothing is clipped: more than margin and half a bullet */
};

/* Positions are pixels * 65536. */
struct crowd_bullet {
    int32_t x, y, vx, vy;
    uint16_t kind;
    uint16_t turn; /* frames until it turns round, which comes before the move: 0 is in the next frame */
    bool grazed;
    uint32_t slot; /* the engine's, and the order among its kind */
};

/* A crowd as it stands, by slot, and the world it is in. */
struct crowd {
    int n, w, h; /* bullets; px of the picture, which is the field */
    int32_t margin;
    int32_t radius, player_radius, player_graze;
    uint8_t pix[CROWD_KINDS][CROWD_SIDE * CROWD_SIDE]; /* 0: transparent; else the colour, its bank included */
    uint8_t ship[CROWD_SIDE * CROWD_SIDE];             /* the player's, drawn below all bullets */
    const struct crowd_bullet *bullets;
};

/* The player in a frame: after its move, and before. */
struct crowd_player {
    int32_t x, y, was_x, was_y;
};

/* Summed over all frames. tested: their way of a frame, as a box, comes within reach of the player. left: they are out
 * of the field and its margin, which no bullet of this crowd may be. */
struct crowd_counts {
    uint64_t moved, tested, hit, grazed, drawn, left;
};

/* A reference, to be called as the engine is. */
struct reference {
    const char *name;
    void *(*open)(const struct crowd *c); /* NULL: out of memory */
    void (*close)(void *);
    void (*tick)(void *, const struct crowd_player *p, struct crowd_counts *counts);
    void (*draw)(void *, struct crowd_counts *counts);

    /* The picture's pixel (0, 0), and bytes a row. */
    const uint8_t *(*picture)(const void *, int *pitch);

    /* Where the bullet at `i` in its own order is; returns its slot. */
    uint32_t (*where)(const void *, int i, int32_t *x, int32_t *y);
};

extern const struct reference reference_array, reference_columns, reference_least;

/* The picture by a painter who copies pixel by pixel and asks of each whether it is on it: out is w x h bytes. It draws
 * from xy, which holds the places of the crowd's bullets by slot. */
void reference_paint(const struct crowd *c, const int32_t *xy, const struct crowd_player *p, uint8_t *out);

/* Palette indices to 32-bit pixels, one by one. */
void reference_expand(uint32_t *out, const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256]);

/* The order in which bullets are drawn: by kind, then by slot. order has room for n. */
void reference_order(const struct crowd *c, uint32_t *order);

#endif

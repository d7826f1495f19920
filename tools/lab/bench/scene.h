/*
 * scene.h - a scene of roms/bench on a board of its own: the ROM's own scripts, with capacities and pictures made for
 * the measurement.
 */
#ifndef BENCH_SCENE_H
#define BENCH_SCENE_H

#include "../../../src/board/board.h"
#include "../../../src/machine/machine.h"
#include "../../../src/workbench/pack/pack.h"

/* What zero means stands behind each. */
struct scene_want {
    const char *does, *price, *picture; /* values of the DIPs of these names (price: or price_..); NULL: the default */
    int n;                              /* DIP n */
    int bullets;                        /* capacity; 0: the ROM's own */
    int side;                           /* px each way of the picture kind1; 0: as the others */
    bool groups;                        /* bullets have room for hp, around, frozen and a value */
    int sparks;                         /* capacity */
    bool scenery;                       /* there is room for backgrounds */
    uint64_t seed;                      /* of the game and of the pictures */
    const char *script;                 /* in place of main.lua; NULL: the ROM's */
    void (*manifest)(struct manifest *m); /* what else is changed; NULL: nothing */
    const char *document;                 /* a BulletML document, which the script calls "doc"; NULL: none */
};

struct scene {
    struct rom_image image;
    struct board *b;
    void *ram, *mem, *scratch;
    size_t ram_size;
    struct fb fb;
    uint32_t rgb[256]; /* the picture's colours */
    uint64_t drawn;    /* sprites in it */
};

/*
 * Powers a board of the ROM with that start, and runs its first frame, in which a scene makes all its things. The
 * pixels of each of the crowd's pictures are the disc's, shuffled: as many are opaque, but no two pictures or seeds are
 * alike. False and one sentence else.
 */
bool scene_open(struct scene *s, const struct rom *rom, const struct scene_want *want, char *err, size_t err_size);

/* The same before the first frame. */
bool scene_power(struct scene *s, const struct rom *rom, const struct scene_want *want, char *err, size_t err_size);
void scene_close(struct scene *s);

/* A frame of the game, in which the player wanders over the whole field; false: a fault, see board_last_output. */
bool scene_tick(struct scene *s);

/* The picture. */
void scene_draw(struct scene *s);

/* Bytes of RAM a board of the ROM takes with room for that many bullets; 0: it cannot be had. */
size_t scene_ram(const struct rom *rom, int bullets);

#endif

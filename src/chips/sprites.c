/*
 * sprites.c - see sprites.h. Nothing moves by itself here; the chip is its columns.
 */
#include "sprites.h"

static const struct column columns[] = {
    COLUMN(sprites, x),     COLUMN(sprites, y),     COLUMN(sprites, sprite), COLUMN(sprites, bank),
    COLUMN(sprites, layer), COLUMN(sprites, flags), COLUMN(sprites, born),
};

const struct chip sprites_chip = { "sprites", columns, sizeof columns / sizeof *columns, false, false };

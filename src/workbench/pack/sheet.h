/*
 * sheet.h - a sheet of rom.lua, from a PNG or an Aseprite file.
 */
#ifndef WORKBENCH_SHEET_H
#define WORKBENCH_SHEET_H

#include "ase_sprite.h"

struct sheet {
    bool is_ase;
    struct ase ase;
    struct art_picture picture; /* of a PNG */
};

/* Reads a PNG by its indices or by its colours. False and one sentence, without the file's name. */
bool sheet_read_png(struct art_picture *picture, const uint8_t *data, size_t n, bool by_index, char *err,
                    size_t err_size);

/* Reads a sheet; close it either way. False and one sentence, without the file's name. */
bool sheet_read(struct sheet *s, const struct art_sheet *asked, const uint8_t *data, size_t n, char *err,
                size_t err_size);
void sheet_close(struct sheet *s);

/* The input of art_make_sprite for a sprite; for a PNG, its picture is the sheet's. Close it after true. */
bool sheet_sprite(const struct sheet *s, const struct art_sheet *asked, const struct art_sprite *sprite,
                  struct ase_sprite *out, char *err, size_t err_size);
void sheet_sprite_close(const struct sheet *s, struct ase_sprite *sprite);

/* A byte per pixel of a sheet's picture: 1 inside its sprites. malloc; NULL: out of memory. i: the sheet's place. */
uint8_t *sheet_marked(const struct sheet *s, const struct art *art, int i);

#endif

/*
 * sheet.c - see sheet.h.
 */
#include "sheet.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../player/picture/png.h"

bool sheet_read_png(struct art_picture *picture, const uint8_t *data, size_t n, bool by_index, char *err,
                    size_t err_size)
{
    *picture = (struct art_picture){ .by_index = by_index };
    if (!png_read_indexed(data, n, &picture->rgba, &picture->index, &picture->w, &picture->h, err, err_size))
        return false;
    if (!by_index || picture->index)
        return true;
    art_picture_free(picture);
    return err_set(err, err_size, "match = \"index\" needs an indexed picture; this one is RGB or greyscale");
}

bool sheet_read(struct sheet *s, const struct art_sheet *asked, const uint8_t *data, size_t n, char *err,
                size_t err_size)
{
    memset(s, 0, sizeof *s);
    s->is_ase = art_is_ase(asked->file);
    if (s->is_ase)
        return ase_read(&s->ase, data, n, png_inflate, err, err_size);
    return sheet_read_png(&s->picture, data, n, asked->by_index, err, err_size);
}

void sheet_close(struct sheet *s)
{
    ase_free(&s->ase);
    art_picture_free(&s->picture);
}

bool sheet_sprite(const struct sheet *s, const struct art_sheet *asked, const struct art_sprite *sprite,
                  struct ase_sprite *out, char *err, size_t err_size)
{
    if (s->is_ase)
        return ase_make_sprite(&s->ase, sprite, asked->by_index, out, err, err_size);
    memset(out, 0, sizeof *out);
    out->picture = s->picture;
    out->sprite = *sprite;
    return true;
}

void sheet_sprite_close(const struct sheet *s, struct ase_sprite *sprite)
{
    if (s->is_ase)
        art_picture_free(&sprite->picture);
}

/* Ignores a sprite that is not inside the sheet. */
static void mark(const struct art_picture *sheet, const struct art_sprite *s, uint8_t *marked)
{
    const int64_t w = (int64_t)s->w * s->frames;

    if (s->x + w > sheet->w || s->y + s->h > sheet->h)
        return;
    for (int y = 0; y < s->h; y++)
        memset(marked + (size_t)(s->y + y) * (size_t)sheet->w + s->x, 1, (size_t)w);
}

uint8_t *sheet_marked(const struct sheet *s, const struct art *art, int i)
{
    uint8_t *marked = calloc((size_t)s->picture.w, (size_t)s->picture.h);

    for (int k = 0; marked && k < art->n_sprites; k++)
        if (art->sprites[k].sheet == i)
            mark(&s->picture, &art->sprites[k], marked);
    return marked;
}

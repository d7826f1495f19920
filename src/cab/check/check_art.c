/*
 * check_art.c - rom.lua and the pictures it names: those that are missing, no PNG, too small for their sprites, or have
 * a colour their bank has not.
 */
#include "check_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../pack/art.h"
#include "../pack/png.h"

static void refuse(struct check *c, const char *file, int line, const char *why)
{
    diagnostics_add(&c->found, file, line, "%s", why);
    c->broken = true;
}

/* A picture that rom.lua names in that line. False, with a diagnostic: it is not there, or no PNG. */
static bool load_picture(struct check *c, const char *file, int line, struct art_picture *out)
{
    char why[256];
    uint8_t *data;
    size_t size;

    if (!tree_has(&c->files, file)) {
        snprintf(why, sizeof why, "there is no %s", file);
        refuse(c, "rom.lua", line, why);
        return false;
    }
    if (!check_load(c, file, TREE_FILE, &data, &size))
        return false;
    bool good = png_read(data, size, &out->rgba, &out->w, &out->h, why, sizeof why);
    free(data);
    if (!good)
        refuse(c, file, 0, why);
    return good;
}

static bool load_palette(struct check *c, const char *file, int line, uint8_t rgb[CART_PALETTE])
{
    struct art_picture picture;
    char why[256];

    if (!load_picture(c, file, line, &picture))
        return false;
    bool good = art_make_palette(&picture, rgb, why, sizeof why);
    free(picture.rgba);
    if (!good)
        refuse(c, file, 0, why);
    return good;
}

static bool load_palettes(struct check *c, uint8_t rgb[CART_PALETTE])
{
    uint8_t other[CART_PALETTE];

    for (int i = 0; i < c->art.n_palettes; i++) {
        const struct art_palette *p = &c->art.palettes[i];
        load_palette(c, p->file, CHECK_LINE(c, "palettes", p->name), other);
    }
    art_default_palette(rgb);
    return c->art.palette[0] == '\0' || load_palette(c, c->art.palette, CHECK_LINE(c, "palette"), rgb);
}

static void note_strays(struct check *c, const char *file, int bank, struct art_strays s)
{
    char other[48] = "", count[48] = "";

    if (s.n == 0 || c->nearest)
        return;
    if (s.bank >= 0)
        snprintf(other, sizeof other, " but in bank %d", s.bank);
    if (s.n > 1)
        snprintf(count, sizeof count, "; %ld such pixels in all", s.n);
    diagnostics_add(&c->found, file, 0, "pixel %d,%d: colour #%02x%02x%02x is not in bank %d%s%s", s.x, s.y, s.c[0],
                    s.c[1], s.c[2], bank, other, count);
}

static void check_font(struct check *c, const uint8_t *rgb)
{
    struct art_picture picture;
    char why[256];
    uint8_t *data;
    size_t size;

    if (c->art.font[0] == '\0' || !load_picture(c, c->art.font, CHECK_LINE(c, "font"), &picture))
        return;
    if (!art_make_font(&picture, rgb, true, &data, &size, why, sizeof why)) {
        refuse(c, c->art.font, 0, why);
    } else {
        free(data);
        note_strays(c, c->art.font, 0, art_find_strays(&picture, NULL, 0, rgb));
    }
    free(picture.rgba);
}

/* The colours of a font's picture; what else is wrong with a font the packer says. */
static void check_cells(struct check *c, const struct art_font *font, const uint8_t *rgb)
{
    struct art_picture picture;

    if (font->w == 0 || !load_picture(c, font->file, CHECK_LINE(c, "fonts", font->name, "file"), &picture))
        return;
    note_strays(c, font->file, 0, art_find_strays(&picture, NULL, 0, rgb));
    free(picture.rgba);
}

/* Marks the pixels of a sprite; false: it is not inside the sheet. */
static bool mark(const struct art_picture *sheet, const struct art_sprite *s, uint8_t *marked)
{
    int64_t w = (int64_t)s->w * s->frames;

    if (s->x + w > sheet->w || s->y + s->h > sheet->h)
        return false;
    for (int y = 0; y < s->h; y++)
        memset(marked + (size_t)(s->y + y) * (size_t)sheet->w + s->x, 1, (size_t)w);
    return true;
}

/* What the packer would say of a sprite. */
static void check_sprite(struct check *c, const struct art_picture *sheet, const struct art_sprite *s, int bank,
                         const uint8_t *rgb)
{
    char why[256];
    uint8_t *data;
    size_t size;

    if (art_make_sprite(sheet, s, bank, rgb, true, &data, &size, why, sizeof why)) {
        free(data);
        return;
    }
    diagnostics_add(&c->found, "rom.lua", CHECK_LINE(c, "sprites", s->name), "sprite \"%s\": %s", s->name, why);
    c->broken = true;
}

/* rgb NULL: the palette is no good. */
static void check_sheet(struct check *c, int i, const uint8_t *rgb)
{
    const struct art_sheet *sheet = &c->art.sheets[i];
    struct art_picture picture;

    if (!load_picture(c, sheet->file, CHECK_LINE(c, "sheets", sheet->name, "file"), &picture))
        return;
    uint8_t *marked = calloc((size_t)picture.w, (size_t)picture.h);
    c->found.failed = c->found.failed || marked == NULL;
    for (int k = 0; rgb != NULL && marked != NULL && k < c->art.n_sprites; k++) {
        const struct art_sprite *s = &c->art.sprites[k];
        if (s->sheet != i)
            continue;
        mark(&picture, s, marked);
        check_sprite(c, &picture, s, sheet->bank, rgb);
    }
    if (rgb != NULL && marked != NULL)
        note_strays(c, sheet->file, sheet->bank, art_find_strays(&picture, marked, sheet->bank, rgb));
    free(marked);
    free(picture.rgba);
}

void check_art(struct check *c)
{
    uint8_t rgb[CART_PALETTE];

    if (!c->manifest)
        return;
    bool colours = load_palettes(c, rgb);
    if (colours)
        check_font(c, rgb);
    for (int i = 0; colours && i < c->art.n_fonts; i++)
        check_cells(c, &c->art.fonts[i], rgb);
    for (int i = 0; i < c->art.n_sheets; i++)
        check_sheet(c, i, colours ? rgb : NULL);
}

/*
 * check_art.c - the pictures in rom.lua: missing files, other formats than PNG, pictures too small for their sprites,
 * and colours that are not in their bank.
 */
#include "check_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../pack/sheet.h"

/* Reads a picture that rom.lua names in the line. False: it cannot be read, which is a finding. */
static bool load_art(struct check *c, const char *file, int line, uint8_t **data, size_t *size)
{
    char why[256];

    if (tree_has(&c->files, file))
        return check_load(c, file, TREE_FILE, data, size);
    snprintf(why, sizeof why, "%s does not exist", file);
    check_add_broken(c, "rom.lua", line, why);
    return false;
}

/* Reads and decodes a PNG. */
static bool load_picture(struct check *c, const char *file, int line, bool by_index, struct art_picture *out)
{
    char why[256];
    uint8_t *data;
    size_t size;

    if (!load_art(c, file, line, &data, &size))
        return false;
    bool good = sheet_read_png(out, data, size, by_index, why, sizeof why);
    free(data);
    if (!good)
        check_add_broken(c, file, 0, why);
    return good;
}

static bool load_palette(struct check *c, const char *file, int line, uint8_t rgb[CART_PALETTE_SIZE])
{
    struct art_picture picture;
    char why[256];

    if (!load_picture(c, file, line, false, &picture))
        return false;
    bool good = art_make_palette(&picture, rgb, why, sizeof why);
    art_picture_free(&picture);
    if (!good)
        check_add_broken(c, file, 0, why);
    return good;
}

/* The main palette and the other palettes, in the order of rom.lua. */
struct colours {
    uint8_t main[CART_PALETTE_SIZE], other[MAX_ART_PALETTES][CART_PALETTE_SIZE];
    bool good, other_good[MAX_ART_PALETTES];
};

static void load_palettes(struct check *c, struct colours *to)
{
    for (int i = 0; i < c->art.n_palettes; i++) {
        const struct art_palette *p = &c->art.palettes[i];
        to->other_good[i] = load_palette(c, p->file, CHECK_LINE(c, "palettes", p->name), to->other[i]);
    }
    art_default_palette(to->main);
    to->good = c->art.palette[0] == '\0' || load_palette(c, c->art.palette, CHECK_LINE(c, "palette"), to->main);
}

/* Returns the colours of a palette ("": the main palette); NULL: it is invalid. */
static const uint8_t *find_colours(const struct check *c, const struct colours *colours, const char *name)
{
    for (int i = 0; i < c->art.n_palettes; i++)
        if (strcmp(c->art.palettes[i].name, name) == 0)
            return colours->other_good[i] ? colours->other[i] : NULL;
    return colours->good ? colours->main : NULL;
}

/* Returns advice for a picture whose palette was changed, or "". */
static const char *palette_advice(const struct art_strays *s)
{
    return s->indices_fit ? " (the picture's indices fit the bank; to use them, set match = \"index\" in rom.lua)" : "";
}

static void report_strays(struct check *c, const char *file, int bank, const struct art_picture *picture,
                          struct art_strays s)
{
    char other[48] = "", count[48] = "", place[ART_PLACE];

    if (s.n == 0 || (c->nearest && s.index < 0))
        return;
    art_place(picture, s.x, s.y, place);
    if (s.bank >= 0 && s.index < 0)
        snprintf(other, sizeof other, " but in bank %d", s.bank);
    if (s.n > 1)
        snprintf(count, sizeof count, "; %ld such pixels in total", s.n);
    if (s.index >= 0)
        diagnostics_add(&c->found, file, 0, "%s: index %d is in bank %d, expected bank %d%s", place, s.index,
                        s.index / 16, bank, count);
    else
        diagnostics_add(&c->found, file, 0, "%s: colour #%02x%02x%02x is not in bank %d%s%s%s", place, s.c[0], s.c[1],
                        s.c[2], bank, other, count, palette_advice(&s));
    c->broken = c->broken || s.index >= 0; /* such an index has no nearest colour */
}

static void check_font(struct check *c, const uint8_t *rgb)
{
    struct art_picture picture;
    char why[256];
    uint8_t *data;
    size_t size;

    if (c->art.font[0] == '\0' || !load_picture(c, c->art.font, CHECK_LINE(c, "font"), c->art.by_index, &picture))
        return;
    if (!art_make_font(&picture, rgb, true, &data, &size, why, sizeof why)) {
        check_add_broken(c, c->art.font, 0, why);
    } else {
        free(data);
        report_strays(c, c->art.font, 0, &picture, art_find_strays(&picture, NULL, 0, rgb));
    }
    art_picture_free(&picture);
}

/* Checks the colours of a font's picture; the packer reports other mistakes. */
static void check_font_colours(struct check *c, const struct art_font *font, const uint8_t *rgb)
{
    struct art_picture picture;

    if (font->w == 0 ||
        !load_picture(c, font->file, CHECK_LINE(c, "fonts", font->name, "file"), font->by_index, &picture))
        return;
    report_strays(c, font->file, 0, &picture, art_find_strays(&picture, NULL, 0, rgb));
    art_picture_free(&picture);
}

/* Checks a sprite as the packer does. */
static void check_sprite(struct check *c, const struct sheet *sheet, const struct art_sheet *of,
                         const struct art_sprite *s, const uint8_t *rgb)
{
    struct ase_sprite made;
    char why[256];
    uint8_t *data;
    size_t size;
    bool pixel = false;
    const bool made_sprite = sheet_sprite(sheet, of, s, &made, why, sizeof why);

    if (made_sprite && sheet->is_ase)
        report_strays(c, of->file, of->bank, &made.picture, art_find_strays(&made.picture, NULL, of->bank, rgb));
    const bool good = made_sprite && art_make_sprite(&made.picture, &made.sprite, of->bank, rgb, true, &data, &size,
                                                     &pixel, why, sizeof why);
    if (made_sprite)
        sheet_sprite_close(sheet, &made);
    if (good)
        free(data);
    else if (!pixel) { /* report_strays has reported pixels */
        diagnostics_add(&c->found, "rom.lua", CHECK_LINE(c, "sprites", s->name), "sprite \"%s\": %s", s->name, why);
        c->broken = true;
    }
}

/* Checks the colours of all sprites of a PNG. */
static void check_colours(struct check *c, const struct sheet *sheet, int i, const uint8_t *rgb)
{
    const struct art_sheet *of = &c->art.sheets[i];
    uint8_t *marked = sheet_marked(sheet, &c->art, i);

    c->found.failed = c->found.failed || marked == NULL;
    if (marked != NULL)
        report_strays(c, of->file, of->bank, &sheet->picture, art_find_strays(&sheet->picture, marked, of->bank, rgb));
    free(marked);
}

/* rgb NULL: the palette is invalid. */
static void check_sheet(struct check *c, int i, const uint8_t *rgb)
{
    const struct art_sheet *of = &c->art.sheets[i];
    struct sheet sheet;
    char why[256];
    uint8_t *data;
    size_t size;

    if (!load_art(c, of->file, CHECK_LINE(c, "sheets", of->name, "file"), &data, &size))
        return;
    const bool good = sheet_read(&sheet, of, data, size, why, sizeof why);
    free(data);
    if (!good)
        check_add_broken(c, of->file, 0, why);
    if (good && rgb != NULL && !sheet.is_ase)
        check_colours(c, &sheet, i, rgb);
    for (int k = 0; good && rgb != NULL && k < c->art.n_sprites; k++)
        if (c->art.sprites[k].sheet == i)
            check_sprite(c, &sheet, of, &c->art.sprites[k], rgb);
    sheet_close(&sheet);
}

void check_art(struct check *c)
{
    struct colours colours;

    if (!c->manifest)
        return;
    load_palettes(c, &colours);
    if (colours.good)
        check_font(c, colours.main);
    for (int i = 0; colours.good && i < c->art.n_fonts; i++)
        check_font_colours(c, &c->art.fonts[i], colours.main);
    for (int i = 0; i < c->art.n_sheets; i++)
        check_sheet(c, i, find_colours(c, &colours, c->art.sheets[i].palette));
}

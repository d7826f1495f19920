/*
 * theme.h - the look and the sounds of the program's screens in a game: `theme` in rom.lua, or made of the game's font
 * and palette.
 *
 * The lump "ui/theme" has THEME_SIZE bytes: i32 ink, accent, rule, paper (THEME_DEFAULT: the default), u32 cursor (0:
 * the default); then names of ART_NAME_SIZE bytes, padded with NULs ("": the default): font, frame, and each sound in
 * the order of enum theme_sound. No tick reads it, and it is not part of the game's hash.
 */
#ifndef ROM_THEME_H
#define ROM_THEME_H

#include "cart.h"

#define THEME_LUMP "ui/theme" /* not between "sound/" and "tune/", as ticks compute with their distance */

enum { THEME_BANKS = 16, THEME_RIM = 10 /* the shade of a plate's rim, as in sprite.plate */ };
enum { THEME_SIZE = 20 + (2 + THEME_SOUNDS) * ART_NAME_SIZE };

/* A theme with its defaults filled in. */
struct theme {
    const struct cart *cart;
    const uint8_t *palette; /* palette/main, 256 x R G B */
    bool has_font;          /* false: the game has no font */
    struct face face;       /* data NULL: the font of text cells */
    int ink, accent, rule, paper;
    uint32_t shades[16];                     /* how often letters use each shade from 2 to 15; 1 is a shadow */
    int height, capital_top, capital_height; /* px, of a line; from its top to the top of capitals; of capitals */
    int full_width; /* px, of full-width letters; 0: the language has none, or they are as high as others */
    bool has_frame;
    struct sprite frame; /* cut into nine parts; its corners are a third of its width and height */
    uint32_t cursor;
    const char *sounds[THEME_SOUNDS]; /* names; NULL: silent */
};

/* Converts the settings to the lump. */
void theme_pack(const struct art_theme *s, uint8_t out[THEME_SIZE]);

/* Checks the lump of a ROM whose other lumps were checked. Returns false, with one sentence in err, if it is out of
 * range or names a font, sprite or sound that the ROM lacks. */
bool theme_check(const struct cart *cart, const struct lump *lump, char *err, size_t err_size);

/* Opens the theme of a game. cart must outlive it. */
void theme_open(struct theme *theme, const struct cart *cart);

/* Sets full_width for the language of the screens, by its name; words.data may be NULL. */
void theme_set_language(struct theme *theme, const struct words *words);

/* Finds the glyph of a character in the theme's font (cart_find_glyph), or of a full-width letter
 * (cart_find_full_width_glyph). Returns false if the game has none. */
bool theme_find_glyph(const struct theme *theme, uint32_t code, struct face_glyph *out);

/* Returns the colour (0xRRGGBB) of entry i of palette/main, and the mean colour of letters in a bank. */
uint32_t theme_colour(const struct theme *theme, int i);
uint32_t theme_text_colour(const struct theme *theme, int bank);

/* Returns the contrast ratio of two colours (0xRRGGBB) as defined by WCAG 2, in hundredths, 100 to 2100. */
int theme_contrast(uint32_t a, uint32_t b);

/* Text needs this contrast (WCAG 2, level AA). */
enum { THEME_MIN_CONTRAST = 450 };

#endif

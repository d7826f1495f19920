/*
 * theme.c - see theme.h.
 */
#include "theme.h"

#include <string.h>
#include "../base/bytes.h"
#include "../base/err.h"
#include "../../fb/text.h"
#include "../../fb/utf8.h"

/* The characters for menus in the fonts of the library's screens (scripts/menu/page.lua), and their substitutes. */
enum { ARROW = 140, PLAIN_ARROW = '>' };

/* The names of sounds that play by default. */
static const char *const default_sounds[THEME_SOUNDS] = {
    [THEME_OPEN] = "pause", [THEME_MOVE] = "menu", [THEME_ACCEPT] = "select", [THEME_BACK] = "back"
};

/* ---- the lump ---- */

enum { NAMES = THEME_SIZE - (2 + THEME_SOUNDS) * ART_NAME_SIZE }; /* the offset of the names */

void theme_pack(const struct art_theme *s, uint8_t out[THEME_SIZE])
{
    bytes_put32(out, (uint32_t)s->ink);
    bytes_put32(out + 4, (uint32_t)s->accent);
    bytes_put32(out + 8, (uint32_t)s->rule);
    bytes_put32(out + 12, (uint32_t)s->paper);
    bytes_put32(out + 16, s->cursor);
    memcpy(out + NAMES, s->font, ART_NAME_SIZE);
    memcpy(out + NAMES + ART_NAME_SIZE, s->frame, ART_NAME_SIZE);
    memcpy(out + NAMES + 2 * ART_NAME_SIZE, s->sounds, sizeof s->sounds);
}

static struct art_theme unpack(const uint8_t *data)
{
    struct art_theme s = { .ink = (int32_t)bytes_get32(data),
                           .accent = (int32_t)bytes_get32(data + 4),
                           .rule = (int32_t)bytes_get32(data + 8),
                           .paper = (int32_t)bytes_get32(data + 12),
                           .cursor = bytes_get32(data + 16) };

    memcpy(s.font, data + NAMES, ART_NAME_SIZE);
    memcpy(s.frame, data + NAMES + ART_NAME_SIZE, ART_NAME_SIZE);
    memcpy(s.sounds, data + NAMES + 2 * ART_NAME_SIZE, sizeof s.sounds);
    return s;
}

/* Returns whether a name is empty, or that of an entry of the folder. */
static bool name_ok(const struct cart *cart, enum cart_folder folder, const char name[ART_NAME_SIZE])
{
    return memchr(name, 0, ART_NAME_SIZE) && (!name[0] || cart_find(cart, folder, name) >= 0);
}

static bool in_range(int32_t v, int32_t limit)
{
    return v >= THEME_DEFAULT && v < limit;
}

bool theme_check(const struct cart *cart, const struct lump *lump, char *err, size_t err_size)
{
    if (lump->size != THEME_SIZE)
        return err_set(err, err_size, "lump \"" THEME_LUMP "\": %u bytes long, expected %d", (unsigned)lump->size,
                       THEME_SIZE);
    const struct art_theme s = unpack(lump->data);
    if (!in_range(s.ink, THEME_BANKS) || !in_range(s.accent, THEME_BANKS) || !in_range(s.rule, THEME_BANKS) ||
        !in_range(s.paper, 256) || s.cursor > 0x10FFFF)
        return err_set(err, err_size, "lump \"" THEME_LUMP "\": a number is out of range");
    if (!name_ok(cart, CART_FACES, s.font))
        return err_set(err, err_size, "lump \"" THEME_LUMP "\": the font does not exist");
    if (!name_ok(cart, CART_SPRITES, s.frame))
        return err_set(err, err_size, "lump \"" THEME_LUMP "\": the frame's sprite does not exist");
    for (int i = 0; i < THEME_SOUNDS; i++)
        if (!name_ok(cart, CART_SOUNDS, s.sounds[i]))
            return err_set(err, err_size, "lump \"" THEME_LUMP "\": a sound does not exist");
    return true;
}

/* ---- the font ---- */

bool theme_find_glyph(const struct theme *theme, uint32_t code, struct face_glyph *out)
{
    const struct face *face = theme->face.data ? &theme->face : NULL;

    if (!theme->has_font)
        return false;
    if (theme->cart->manifest.full_width == TEXT_SIDE || !utf8_is_full_width(code))
        return cart_find_glyph(theme->cart, face, code, out);
    return cart_find_full_width_glyph(theme->cart, face, code, out);
}

/* Measures the capital H, without its shadow. */
static void measure_capitals(struct theme *t)
{
    struct face_glyph g;
    int top = -1, bottom = 0;

    if (!theme_find_glyph(t, 'H', &g))
        return;
    for (int i = 0; i < g.w * g.h; i++)
        if (g.pix[i / g.w * g.pitch + i % g.w] > 1) {
            top = top < 0 ? i / g.w : top;
            bottom = i / g.w;
        }
    if (top < 0)
        return;
    t->capital_top = g.y + top;
    t->capital_height = bottom - top + 1;
}

/* Chooses the font of text cells or, in a game without it, the first of `fonts`. */
static void open_font(struct theme *t, const char *name)
{
    const int face = name[0] ? cart_find(t->cart, CART_FACES, name) : t->cart->glyphs ? -1 : 0;
    struct face_glyph g;

    t->has_font = t->cart->glyphs || t->cart->count[CART_FACES] > 0;
    if (face >= 0 && face < t->cart->count[CART_FACES])
        t->face = cart_face(t->cart, face);
    for (uint32_t code = '!'; code <= '~'; code++)
        for (int i = 0; theme_find_glyph(t, code, &g) && i < g.w * g.h; i++)
            t->shades[g.pix[i / g.w * g.pitch + i % g.w]]++;
    t->shades[0] = t->shades[1] = 0;
    if (!t->has_font)
        t->shades[THEME_RIM] = t->shades[15] = 1; /* letters of the program's font are between these */
    t->height = t->face.data ? t->face.height : TEXT_SIDE;
    t->capital_height = t->height - 1;
    measure_capitals(t);
}

void theme_set_language(struct theme *theme, const struct words *words)
{
    const char *name = words_find(words, "name", 4), *end = name ? name + strlen(name) : NULL;

    theme->full_width = 0;
    while (name && name < end)
        if (utf8_is_full_width(utf8_next(&name, end)) && theme->cart->manifest.full_width > TEXT_SIDE)
            theme->full_width = theme->cart->manifest.full_width;
}

/* ---- colours ---- */

uint32_t theme_colour(const struct theme *theme, int i)
{
    const uint8_t *rgb = theme->palette + 3 * i;

    return (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
}

uint32_t theme_text_colour(const struct theme *theme, int bank)
{
    uint64_t sum[3] = { 0 }, n = 0;

    for (int shade = 0; shade < 16; shade++) {
        for (int c = 0; c < 3; c++)
            sum[c] += (uint64_t)theme->shades[shade] * theme->palette[3 * (16 * bank + shade) + c];
        n += theme->shades[shade];
    }
    return n ? (uint32_t)(sum[0] / n << 16 | sum[1] / n << 8 | sum[2] / n) : theme_colour(theme, 16 * bank + 15);
}

/* Returns the linear value of an sRGB component, 0 to 65535: ((c / 255 + 0.055) / 1.055) ^ 2.4, or c / 255 / 12.92 for
 * a dark one. x ^ 2.4 is computed as x ^ 2 * y, where y ^ 5 = x ^ 2. */
static uint32_t linear(uint32_t c)
{
    const uint64_t x = ((1000 * (uint64_t)c + 14025) << 30) / 269025; /* 1 << 30: 1.0 */
    uint64_t y = 0;                                                   /* 1 << 12: 1.0 */

    if (c <= 10)
        return c * 65535 * 100 / (255 * 1292);
    for (uint64_t bit = 1 << 12; bit; bit >>= 1) {
        const uint64_t next = y | bit;
        y = next <= 1 << 12 && next * next * next * next * next <= x * x ? next : y;
    }
    return (uint32_t)(((x >> 14) * (x >> 14) * y >> 28) * 65535 >> 16);
}

/* Returns the relative luminance of a colour, 0 to 65535. */
static uint32_t luminance(uint32_t rgb)
{
    return (2126 * linear(rgb >> 16 & 255) + 7152 * linear(rgb >> 8 & 255) + 722 * linear(rgb & 255)) / 10000;
}

int theme_contrast(uint32_t a, uint32_t b)
{
    const uint32_t haze = 65535 / 20, la = luminance(a) + haze, lb = luminance(b) + haze; /* haze: 0.05 */

    return (int)(la > lb ? la * 100 / lb : lb * 100 / la);
}

/* Returns the darkest opaque colour of a range of entries. The first of a bank is transparent in pictures. */
static int find_darkest(const struct theme *t, int first, int n)
{
    uint32_t least = UINT32_MAX;
    int best = first;

    for (int i = first; i < first + n; i++) {
        const uint32_t light = i % 16 ? luminance(theme_colour(t, i)) : UINT32_MAX;
        best = light < least ? i : best;
        least = light < least ? light : least;
    }
    return best;
}

/* Returns the darkest colour of the ink's bank, like the plates of the game's menus, or of all if text could not be
 * read on that. */
static int find_paper(const struct theme *t)
{
    const int plate = find_darkest(t, 16 * t->ink, 16);
    const int contrast = theme_contrast(theme_text_colour(t, t->ink), theme_colour(t, plate));

    return contrast >= THEME_MIN_CONTRAST ? plate : find_darkest(t, 0, 256);
}

static int distance(uint32_t a, uint32_t b)
{
    int sum = 0;

    for (int shift = 0; shift < 24; shift += 8) {
        const int d = (int)(a >> shift & 255) - (int)(b >> shift & 255);
        sum += d * d;
    }
    return sum;
}

/* Returns how far a bank's letters, and the rim of its plates, are from yellow. */
static int yellow_distance(const struct theme *t, int bank)
{
    const uint32_t yellow = 0xFFE050;

    return distance(theme_text_colour(t, bank), yellow) + distance(theme_colour(t, 16 * bank + THEME_RIM), yellow);
}

/* Returns the bank that is nearest to yellow, of those that can be read; the ink's bank if there is none. */
static int find_accent(const struct theme *t)
{
    const uint32_t paper = theme_colour(t, t->paper);
    int best = t->ink;

    for (int bank = 0; bank < THEME_BANKS; bank++)
        if (theme_contrast(theme_text_colour(t, bank), paper) >= THEME_MIN_CONTRAST &&
            yellow_distance(t, bank) < yellow_distance(t, best))
            best = bank;
    return best;
}

/* ---- opening ---- */

static const char *find_sound(const struct cart *cart, const char *name)
{
    const int i = cart_find(cart, CART_SOUNDS, name);

    return i >= 0 ? cart_name(cart, CART_SOUNDS, i) : NULL;
}

void theme_open(struct theme *theme, const struct cart *cart)
{
    struct art_theme s = {
        .ink = THEME_DEFAULT, .accent = THEME_DEFAULT, .rule = THEME_DEFAULT, .paper = THEME_DEFAULT
    };
    const int at = rom_find(cart->rom, THEME_LUMP);
    struct lump lump;
    struct face_glyph g;

    if (at >= 0) {
        rom_lump(cart->rom, at, &lump);
        s = unpack(lump.data);
    }
    *theme = (struct theme){ .cart = cart, .palette = cart_palette(cart, "main") };
    open_font(theme, s.font);
    theme->ink = s.ink >= 0 ? s.ink : 0;
    theme->paper = s.paper >= 0 ? s.paper : find_paper(theme);
    theme->accent = s.accent >= 0 ? s.accent : find_accent(theme);
    theme->rule = s.rule >= 0 ? s.rule : theme->ink;
    theme->cursor = s.cursor ? s.cursor : theme_find_glyph(theme, ARROW, &g) ? ARROW : PLAIN_ARROW;
    theme->has_frame = s.frame[0] != 0;
    if (theme->has_frame)
        cart_sprite(cart, cart_find(cart, CART_SPRITES, s.frame), &theme->frame);
    for (int i = 0; i < THEME_SOUNDS; i++)
        theme->sounds[i] = find_sound(cart, s.sounds[i][0] ? s.sounds[i] : default_sounds[i]);
}

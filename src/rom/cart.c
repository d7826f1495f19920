/*
 * cart.c - see cart.h. This file checks everything that other code trusts. Sizes are computed in 64 bits. Every pixel
 * is checked, because a blit copies eight pixels at a time and would show padding that is not 0.
 */
#include "cart.h"

#include <assert.h>
#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../base/bytes.h"
#include "../base/err.h"
#include "../base/int.h"
#include "../entities/motion.h"
#include "../../fb/blit.h"
#include "../../fb/text.h"
#include "../sound/adpcm.h"
#include "../sound/tune.h"
#include "theme.h"

/* Returns the index of the lump named folder + name + suffix, or -1. */
static int find_index(const struct rom *rom, const char *folder, const char *name, const char *suffix)
{
    char full[ROM_MAX_NAME];
    const int n = snprintf(full, sizeof full, "%s%s%s", folder, name, suffix);

    return n > 0 && n < ROM_MAX_NAME ? rom_find(rom, full) : -1;
}

static bool find_lump(const struct rom *rom, const char *folder, const char *name, const char *suffix, struct lump *l)
{
    const int i = find_index(rom, folder, name, suffix);

    if (i >= 0)
        rom_lump(rom, i, l);
    return i >= 0;
}

/* A lump whose contents are being checked. A check that fails stores the reason in err. */
struct check {
    const struct cart *cart;
    const char *name; /* without the folder's prefix */
    struct lump lump;
    char err[256];
};
typedef bool check_lump(struct check *k);
static check_lump check_sprite, check_lang, check_map, check_bulletml, check_face, check_tune, check_hitbox;

static const struct {
    const char *prefix, *upper_bound; /* upper_bound: the prefix with its last byte incremented */
    int max_lumps;
    uint32_t lump_size; /* bytes of each lump; 0: any */
    check_lump *check;  /* NULL: any contents */
} folders[CART_FOLDERS] = {
    [CART_SPRITES] = { "gfx/", "gfx0", INT_MAX, 0, check_sprite },
    [CART_PALETTES] = { "palette/", "palette0", INT_MAX, CART_PALETTE_SIZE, NULL },
    [CART_BLENDS] = { "blend/", "blend0", CART_MAX_BLENDS, CART_BLEND_SIZE, NULL },
    [CART_LANGS] = { "lang/", "lang0", INT_MAX, 0, check_lang },
    [CART_MAPS] = { "map/", "map0", CART_MAX_MAPS, 0, check_map },
    [CART_BULLETML] = { "bulletml/", "bulletml0", CART_MAX_BULLETML, 0, check_bulletml },
    [CART_FACES] = { "fonts/", "fonts0", CART_MAX_FACES, 0, check_face },
    [CART_TUNES] = { "tune/", "tune0", CART_MAX_TUNES, 0, check_tune },
    [CART_SOUNDS] = { "sound/", "sound0", CART_MAX_TUNES, 0, check_tune },
    [CART_SHADE_TABLES] = { "shade/", "shade0", INT_MAX, CART_SHADES_SIZE, NULL },
    [CART_BLEND_TABLES] = { "blends/", "blends0", INT_MAX, CART_BLEND_SIZE, NULL },
    [CART_HITBOXES] = { "hit/", "hit0", INT_MAX, 0, check_hitbox },
};

static struct lump get_lump(const struct cart *c, enum cart_folder f, int i)
{
    struct lump l;

    assert(i >= 0 && i < c->count[f]);
    rom_lump(c->rom, c->first[f] + i, &l);
    return l;
}

const char *cart_name(const struct cart *cart, enum cart_folder folder, int i)
{
    return get_lump(cart, folder, i).name + strlen(folders[folder].prefix);
}

int cart_find(const struct cart *cart, enum cart_folder folder, const char *name)
{
    const int i = find_index(cart->rom, folders[folder].prefix, name, "");

    return i < 0 ? -1 : i - cart->first[folder];
}

static bool check_size(const struct lump *l, uint32_t size, char *err, size_t err_size)
{
    return l->size == size ||
           err_set(err, err_size, "lump \"%s\": %" PRIu32 " bytes long, expected %" PRIu32, l->name, l->size, size);
}

/* Checks the number of a folder's lumps, and each of them. */
static bool open_folder(struct cart *c, enum cart_folder f, char *err, size_t err_size)
{
    struct check k = { .cart = c };

    if (c->count[f] > folders[f].max_lumps)
        return f == CART_TUNES || f == CART_SOUNDS
                   ? err_set(err, err_size, "%d sounds and pieces of music, expected at most %d", c->count[f],
                             CART_MAX_TUNES)
                   : err_set(err, err_size, "%d lumps named \"%s...\", expected at most %d", c->count[f],
                             folders[f].prefix, folders[f].max_lumps);
    for (int i = 0; i < c->count[f]; i++) {
        k.name = cart_name(c, f, i);
        k.lump = get_lump(c, f, i);
        if (folders[f].lump_size && !check_size(&k.lump, folders[f].lump_size, err, err_size))
            return false;
        if (folders[f].check && !folders[f].check(&k))
            return err_set(err, err_size, "lump \"%s\": %s", k.lump.name, k.err);
    }
    return true;
}

static bool open_folders(struct cart *c, char *err, size_t err_size)
{
    for (int f = 0; f < CART_FOLDERS; f++) {
        c->first[f] = rom_find_first(c->rom, folders[f].prefix);
        c->count[f] = rom_find_first(c->rom, folders[f].upper_bound) - c->first[f];
    }
    for (int f = 0; f < CART_FOLDERS; f++)
        if (!open_folder(c, (enum cart_folder)f, err, err_size))
            return false;
    return cart_palette(c, "main") != NULL ? true : err_set(err, err_size, "no lump \"palette/main\"");
}

static bool open_manifest(struct cart *c, char *err, size_t err_size)
{
    struct lump l;
    char detail[256];

    if (!find_lump(c->rom, "", "manifest", "", &l))
        return err_set(err, err_size, "no lump \"manifest\"");
    if (!manifest_unpack(l.data, l.size, &c->manifest, detail, sizeof detail))
        return err_set(err, err_size, "lump \"manifest\": %s", detail);
    if (!find_lump(c->rom, "script/", c->manifest.entry, ".lua", &l))
        return err_set(err, err_size, "no lump \"script/%s.lua\", the entry script", c->manifest.entry);
    return true;
}

/* Returns the blend rule with the same results as a table, or BLIT_TABLE if there is none. */
static uint8_t find_rule(const uint8_t table[CART_BLEND_SIZE])
{
    for (uint8_t rule = BLIT_RAMP_ADD; rule < BLIT_MIXES; rule++) {
        int i = 0;
        while (i < CART_BLEND_SIZE && table[i] == blit_ramp_entry(rule, (uint8_t)(i >> 8), (uint8_t)i))
            i++;
        if (i == CART_BLEND_SIZE)
            return rule;
    }
    return BLIT_TABLE;
}

static void set_blend(struct cart_colour_tables *tables, int i, const uint8_t *blend)
{
    tables->blend[i] = blend;
    tables->mix[i] = find_rule(blend);
}

/* Finds the tables of palette i. In place of missing tables, it uses those of palette/main. */
static void find_palette_tables(struct cart *c, int i)
{
    struct cart_colour_tables *tables = &c->palette_tables[i];
    char folder[2 * ROM_MAX_NAME];
    struct lump l;

    *tables = c->main_tables;
    if (find_lump(c->rom, "shade/", cart_name(c, CART_PALETTES, i), "", &l))
        tables->shades = l.data;
    snprintf(folder, sizeof folder, "blends/%s/", cart_name(c, CART_PALETTES, i));
    for (int k = 0; k < c->count[CART_BLENDS]; k++)
        if (find_lump(c->rom, folder, cart_name(c, CART_BLENDS, k), "", &l))
            set_blend(tables, k, l.data);
}

static bool open_colour_tables(struct cart *c, char *err, size_t err_size)
{
    struct lump l;
    const bool has_shades = find_lump(c->rom, "", "shades", "", &l);

    c->main_tables.shades = has_shades ? l.data : NULL;
    if (has_shades && !check_size(&l, CART_SHADES_SIZE, err, err_size))
        return false;
    for (int i = 0; i < c->count[CART_BLENDS]; i++)
        set_blend(&c->main_tables, i, get_lump(c, CART_BLENDS, i).data);
    c->has_palette_tables = c->count[CART_SHADE_TABLES] + c->count[CART_BLEND_TABLES] > 0;
    if (c->has_palette_tables && c->count[CART_PALETTES] > CART_MAX_TABLED_PALETTES)
        return err_set(err, err_size, "%d lumps named \"palette/...\" with shade or blend tables, expected at most %d",
                       c->count[CART_PALETTES], CART_MAX_TABLED_PALETTES);
    for (int i = 0; i < c->count[CART_PALETTES] && c->has_palette_tables; i++)
        find_palette_tables(c, i);
    return true;
}

static bool check_face(struct check *k)
{
    struct face face;

    return face_open(&face, k->lump.data, k->lump.size, k->err, sizeof k->err);
}

static bool check_lang(struct check *k)
{
    struct words words;

    if (!manifest_setting_name_ok(k->name))
        return err_set(k->err, sizeof k->err, "expected a name of 1 to %d letters, digits, _ and -",
                       MAX_SETTING_NAME - 1);
    return words_open(&words, k->lump.data, k->lump.size, k->err, sizeof k->err);
}

static bool open_font(struct cart *c, char *err, size_t err_size)
{
    struct lump l;

    c->glyphs = NULL;
    c->n_glyphs = 0;
    if (!find_lump(c->rom, "", "font", "", &l))
        return true;
    if (l.size == 0 || l.size % CART_GLYPH_SIZE != 0 || l.size / CART_GLYPH_SIZE > CART_MAX_GLYPHS)
        return err_set(err, err_size,
                       "lump \"font\": %" PRIu32 " bytes long, expected %d bytes for each of 1 to %d characters",
                       l.size, CART_GLYPH_SIZE, CART_MAX_GLYPHS);
    for (uint32_t i = 0; i < l.size; i++)
        if (l.data[i] > 15)
            return err_set(err, err_size, "lump \"font\": shade %d in character %" PRIu32 ", expected 0 to 15",
                           l.data[i], CART_FIRST_CHAR + i / CART_GLYPH_SIZE);
    c->glyphs = l.data;
    c->n_glyphs = (int)(l.size / CART_GLYPH_SIZE);
    return true;
}

static void read_sprite(const struct lump *l, struct sprite *s)
{
    const uint8_t *p = l->data;

    s->w = bytes_get16(p);
    s->h = bytes_get16(p + 2);
    s->pitch = bytes_get16(p + 4);
    s->ox = (int16_t)bytes_get16(p + 6);
    s->oy = (int16_t)bytes_get16(p + 8);
    s->frames = bytes_get16(p + 10);
    s->frame_ticks = bytes_get16(p + 12);
    s->rotations = bytes_get16(p + 14);
    s->bank = bytes_get16(p + 16);
    s->palette = bytes_get16(p + 18);
    s->pix = p + CART_GFX_HEADER_SIZE;
}

static bool in_range(int v, int lo, int hi)
{
    return v >= lo && v <= hi;
}

static bool header_ok(const struct sprite *s)
{
    return in_range(s->w, 1, CART_MAX_SIDE) && in_range(s->h, 1, CART_MAX_SIDE) && s->pitch % 8 == 0 &&
           in_range(s->pitch, s->w, CART_MAX_SIDE) && in_range(s->ox, -CART_MAX_SIDE, 2 * CART_MAX_SIDE) &&
           in_range(s->oy, -CART_MAX_SIDE, 2 * CART_MAX_SIDE) && in_range(s->frames, 1, CART_MAX_FRAMES) &&
           s->frame_ticks >= 1 && in_range(s->rotations, 1, CART_MAX_ROTATIONS) && s->bank <= 15;
}

/* Checks a row of a picture, eight pixels at a time. A pixel must be 0, or have the bank in its upper four bits and not
 * 0 in its lower four bits. Padding must be 0. */
static bool row_ok(const uint8_t *row, const struct sprite *s)
{
    const uint64_t ones = 0x0101010101010101, uppers = 0xf0 * ones, lowers = 0x0f * ones;

    for (int x = 0; x < s->pitch; x += 8) {
        uint64_t pixels;
        memcpy(&pixels, row + x, sizeof pixels);
        const uint64_t drawn = ((pixels & lowers) + lowers) >> 4 & ones; /* 1 in each byte whose lower half is not 0 */
        if ((pixels & uppers) != drawn * ((uint64_t)s->bank << 4))
            return false;
    }
    for (int x = s->w; x < s->pitch; x++)
        if (row[x] != 0)
            return false;
    return true;
}

static bool check_sprite(struct check *k)
{
    const struct lump *l = &k->lump;
    struct sprite s;

    if (l->size < CART_GFX_HEADER_SIZE)
        return err_set(k->err, sizeof k->err, "too short for a sprite (%" PRIu32 " bytes)", l->size);
    read_sprite(l, &s);
    if (!header_ok(&s) || s.palette > k->cart->count[CART_PALETTES] || bytes_get32(l->data + 20) != 0)
        return err_set(k->err, sizeof k->err, "its header is out of range");
    uint64_t rows = (uint64_t)s.frames * s.rotations * s.h;
    if (l->size != CART_GFX_HEADER_SIZE + rows * s.pitch)
        return err_set(k->err, sizeof k->err, "%" PRIu32 " bytes long, its header says %" PRIu64, l->size,
                       CART_GFX_HEADER_SIZE + rows * s.pitch);
    for (uint64_t y = 0; y < rows; y++)
        if (!row_ok(s.pix + y * s.pitch, &s))
            return err_set(k->err, sizeof k->err,
                           "row %" PRIu64 " has a pixel beyond its width or with a colour outside bank %d", y, s.bank);
    return true;
}

/* ---- hitboxes ---- */

/* A hitbox is stored as its 32-bit words. */
_Static_assert(sizeof(struct cart_hitbox) == CART_HITBOX_SIZE, "struct cart_hitbox has no padding");

void cart_pack_hitbox(const struct cart_hitbox *hit, uint8_t out[CART_HITBOX_SIZE])
{
    uint32_t words[CART_HITBOX_SIZE / 4];

    memcpy(words, hit, sizeof words);
    for (size_t i = 0; i < COUNT(words); i++)
        bytes_put32(out + 4 * i, words[i]);
}

static void read_hitbox(const uint8_t *p, struct cart_hitbox *hit)
{
    uint32_t words[CART_HITBOX_SIZE / 4];

    for (size_t i = 0; i < COUNT(words); i++)
        words[i] = bytes_get32(p + 4 * i);
    memcpy(hit, words, sizeof words);
}

/* Returns whether lengths are not negative, nothing is too large, and values that the shape does not use are 0. */
static bool hitbox_row_ok(const struct cart_hitbox *h, uint32_t i)
{
    const int64_t limit = (int64_t)MAX_SPEED << 16, a = h->row[i].a, b = h->row[i].b;
    const int64_t x = h->row[i].x, y = h->row[i].y, reach = int64_abs(x) + int64_abs(y) + a;

    if (i >= h->rows)
        return a == 0 && b == 0 && x == 0 && y == 0;
    if (a < 0 || b < 0 || b > limit || reach > limit)
        return false;
    return (h->shape == SHAPE_BOX || b == 0) &&
           (h->shape == SHAPE_CAPSULE || h->shape == SHAPE_CIRCLES || (x == 0 && y == 0));
}

static bool hitbox_ok(const struct cart_hitbox *h)
{
    if (h->shape != SHAPE_CIRCLE && h->shape != SHAPE_BOX && h->shape != SHAPE_CAPSULE && h->shape != SHAPE_CIRCLES)
        return false;
    if (h->rows < 1 || h->rows > (h->shape == SHAPE_CIRCLES ? SHAPE_MAX_CIRCLES : 1))
        return false;
    for (uint32_t i = 0; i < SHAPE_MAX_CIRCLES; i++)
        if (!hitbox_row_ok(h, i))
            return false;
    return true;
}

static bool check_hitbox(struct check *k)
{
    struct cart_hitbox h;

    if (cart_find(k->cart, CART_SPRITES, k->name) < 0)
        return err_set(k->err, sizeof k->err, "no sprite has this name");
    if (k->lump.size == CART_HITBOX_SIZE)
        read_hitbox(k->lump.data, &h);
    return (k->lump.size == CART_HITBOX_SIZE && hitbox_ok(&h)) || err_set(k->err, sizeof k->err, "not a hitbox");
}

bool cart_find_hitbox(const struct cart *cart, const char *name, struct cart_hitbox *out)
{
    struct lump l;

    if (!find_lump(cart->rom, "hit/", name, "", &l))
        return false;
    read_hitbox(l.data, out);
    return true;
}

static void read_map(const struct lump *l, struct map *m)
{
    const uint8_t *p = l->data;

    m->cols = bytes_get16(p);
    m->rows = bytes_get16(p + 2);
    m->tile_side = bytes_get16(p + 4);
    m->n_tiles = bytes_get16(p + 6);
    m->bank = bytes_get16(p + 8);
    m->all_solid = bytes_get16(p + 10) != 0;
    m->cells = p + CART_MAP_HEADER_SIZE;
    m->solid = m->cells + 2 * (size_t)m->cols * (size_t)m->rows;
    m->pix = m->solid + m->n_tiles;
}

static bool map_header_ok(const struct map *m)
{
    return (m->tile_side == 8 || m->tile_side == 16 || m->tile_side == 32) &&
           in_range(m->cols, 1, CART_MAX_MAP_SIDE / m->tile_side) &&
           in_range(m->rows, 1, CART_MAX_MAP_SIDE / m->tile_side) && m->cols * m->rows <= CART_MAX_MAP_CELLS &&
           m->n_tiles >= 1 && m->bank <= 15;
}

/* Checks a tile: tile 0 must be empty, pixels must be 0 or in the bank, and m->solid[tile] must be 1 if no pixel is 0,
 * otherwise 0. */
static bool tile_ok(const struct map *m, int tile)
{
    const int n = m->tile_side * m->tile_side;
    const uint8_t *p = m->pix + (size_t)tile * (size_t)n;
    bool solid = true;

    for (int i = 0; i < n; i++) {
        if (p[i] != 0 && (tile == 0 || p[i] >> 4 != m->bank || p[i] % 16 == 0))
            return false;
        solid = solid && p[i] != 0;
    }
    return m->solid[tile] == solid;
}

static bool check_map(struct check *k)
{
    const struct lump *l = &k->lump;
    struct map m;

    if (l->size < CART_MAP_HEADER_SIZE)
        return err_set(k->err, sizeof k->err, "too short for a map (%" PRIu32 " bytes)", l->size);
    read_map(l, &m);
    if (!map_header_ok(&m) || bytes_get16(l->data + 10) > 1 || bytes_get32(l->data + 12) != 0)
        return err_set(k->err, sizeof k->err, "its header is out of range");
    uint64_t cells = (uint64_t)m.cols * (uint64_t)m.rows;
    uint64_t size =
        CART_MAP_HEADER_SIZE + 2 * cells + (uint64_t)m.n_tiles * (1 + (uint64_t)m.tile_side * (uint64_t)m.tile_side);
    if (l->size != size)
        return err_set(k->err, sizeof k->err, "%" PRIu32 " bytes long, its header says %" PRIu64, l->size, size);
    bool all_solid = true;
    for (uint64_t i = 0; i < cells; i++) {
        if (bytes_get16(m.cells + 2 * i) >= m.n_tiles)
            return err_set(k->err, sizeof k->err, "cell %" PRIu64 " has tile %d, but the map has %d tiles", i,
                           bytes_get16(m.cells + 2 * i), m.n_tiles);
        all_solid = all_solid && m.solid[bytes_get16(m.cells + 2 * i)];
    }
    if (all_solid != m.all_solid)
        return err_set(k->err, sizeof k->err, "wrong flag for empty cells");
    for (int i = 0; i < m.n_tiles; i++)
        if (!tile_ok(&m, i))
            return err_set(k->err, sizeof k->err, "tile %d does not match the map's flags", i);
    return true;
}

static bool check_bulletml(struct check *k)
{
    return ml_check(k->lump.data, k->lump.size, k->err, sizeof k->err);
}

/* Checks a sound or a piece of music. The samples of a stream, which only music can be, must exist and be valid. */
static bool check_tune(struct check *k)
{
    struct lump samples;

    if (!tune_validate(k->lump.data, k->lump.size, k->err, sizeof k->err))
        return false;
    const struct tune t = tune_of(k->lump.data);
    if (tune_is_stream(&t) &&
        !(strncmp(k->lump.name, "tune/", 5) == 0 && find_lump(k->cart->rom, "wave/", k->name, "", &samples) &&
          samples_are_valid(samples.data, samples.size, t.channels)))
        return err_set(k->err, sizeof k->err, "samples (lump wave/%s) are missing or damaged", k->name);
    return true;
}

const char *const cart_cue_names[CART_CUES] = { "shot",  "hit",    "graze",    "kill",    "item",  "bomb",   "warning",
                                                "menu",  "extend", "spell",    "bonus",   "time",  "select", "back",
                                                "wrong", "pause",  "continue", "mission", "failed" };

static void find_sounds(struct cart *c)
{
    if (c->count[CART_SOUNDS] + c->count[CART_TUNES] > 0) /* sounds and music are adjacent in the ROM */
        c->tune_data =
            get_lump(c, c->count[CART_SOUNDS] > 0 ? CART_SOUNDS : CART_TUNES, 0).data - CART_FIRST_TUNE_OFFSET;
    for (int i = 0; i < CART_CUES; i++) {
        const int sound = cart_find(c, CART_SOUNDS, cart_cue_names[i]);
        c->cue_offset[i] = sound < 0 ? 0 : cart_tune_offset(c, CART_SOUNDS, sound);
    }
}

static bool check_theme(const struct cart *c, char *err, size_t err_size)
{
    struct lump l;

    return !find_lump(c->rom, "", THEME_LUMP, "", &l) || theme_check(c, &l, err, err_size);
}

static void measure_sprites(struct cart *cart)
{
    cart->max_sprite_w = cart->max_sprite_h = 0;
    for (int i = 0; i < cart->count[CART_SPRITES]; i++) {
        struct sprite s;
        cart_sprite(cart, i, &s);
        cart->max_sprite_w = int_max(cart->max_sprite_w, s.w);
        cart->max_sprite_h = int_max(cart->max_sprite_h, s.h);
    }
}

bool cart_open(struct cart *cart, const struct rom *rom, char *err, size_t err_size)
{
    cart->rom = rom;
    if (!open_manifest(cart, err, err_size) || !open_folders(cart, err, err_size) ||
        !open_colour_tables(cart, err, err_size) || !open_font(cart, err, err_size))
        return false;
    find_sounds(cart);
    measure_sprites(cart);
    return check_theme(cart, err, err_size);
}

void cart_sprite(const struct cart *cart, int i, struct sprite *out)
{
    const struct lump l = get_lump(cart, CART_SPRITES, i);

    read_sprite(&l, out);
}

bool cart_open_lang(const struct cart *cart, const char *name, struct words *out)
{
    struct lump l;
    const bool found = name[0] && find_lump(cart->rom, "lang/", name, "", &l);

    *out = found ? words_of(l.data) : (struct words){ NULL, 0 };
    return found || !name[0];
}

void cart_map(const struct cart *cart, int i, struct map *out)
{
    const struct lump l = get_lump(cart, CART_MAPS, i);

    read_map(&l, out);
}

const uint8_t *cart_palette_at(const struct cart *cart, int i)
{
    return get_lump(cart, CART_PALETTES, i).data;
}

void cart_bulletml(const struct cart *cart, int i, struct ml *out)
{
    ml_open(out, get_lump(cart, CART_BULLETML, i).data);
}

const uint8_t *cart_palette(const struct cart *cart, const char *name)
{
    struct lump l;

    return find_lump(cart->rom, "palette/", name, "", &l) ? l.data : NULL;
}

struct face cart_face(const struct cart *cart, int i)
{
    return face_of(get_lump(cart, CART_FACES, i).data);
}

/* Converts a glyph of the font of text cells. y: px from the line's top. */
static bool find_cell_glyph(const struct cart *cart, uint32_t code, int y, struct face_glyph *g)
{
    const struct font font = { cart->glyphs, CART_FIRST_CHAR, cart->n_glyphs };
    const uint8_t *pix = text_find_glyph(&font, code);

    if (pix)
        *g = (struct face_glyph){ pix, TEXT_SIDE, TEXT_SIDE, TEXT_SIDE, 0, y, TEXT_SIDE };
    return pix != NULL;
}

bool cart_find_glyph(const struct cart *cart, const struct face *face, uint32_t code, struct face_glyph *g)
{
    const int side = face ? face->height : TEXT_SIDE;

    if (face && face_find(face, code, g))
        return true;
    if (text_is_blank(code)) {
        *g = (struct face_glyph){ .advance = face && code != 0x3000 ? side / 3 : side };
        return true;
    }
    if (!face && find_cell_glyph(cart, code, 0, g))
        return true;
    for (int i = 0; i < cart->count[CART_FACES]; i++) {
        const struct face other = cart_face(cart, i);
        if (!face_find(&other, code, g))
            continue;
        g->y += side - other.height;
        return true;
    }
    return find_cell_glyph(cart, code, side - TEXT_SIDE, g);
}

bool cart_find_full_width_glyph(const struct cart *cart, const struct face *face, uint32_t code, struct face_glyph *g)
{
    const int width = cart->manifest.full_width;
    int height = TEXT_SIDE, nearest = INT_MAX;
    struct face_glyph found;

    if (face && face_find(face, code, g)) {
        height = face->height;
    } else if (cart_find_glyph(cart, NULL, code, g)) {
        for (int i = 0; i < cart->count[CART_FACES]; i++) {
            const struct face other = cart_face(cart, i);
            const int distance = abs(other.height - width);
            if (distance >= nearest || !face_find(&other, code, &found))
                continue;
            nearest = distance;
            height = other.height;
            *g = found;
        }
    } else {
        return false;
    }
    g->x += (width - g->advance) / 2;
    g->y += ((face ? face->height : TEXT_SIDE) - height) / 2;
    g->advance = width;
    return true;
}

bool cart_has_glyph(const struct cart *cart, uint32_t code)
{
    struct face_glyph g;

    return cart_find_glyph(cart, NULL, code, &g);
}

uint32_t cart_tune_offset(const struct cart *cart, enum cart_folder folder, int i)
{
    return (uint32_t)(get_lump(cart, folder, i).data - cart->tune_data);
}

/* Returns the place of the samples of the tune at place `tune`, which is a recording; 0: none. */
static uint32_t find_samples_offset(const struct cart *cart, uint32_t tune)
{
    const uint32_t at = bytes_get32(cart->tune_data + tune + 12);
    struct lump l;
    int i = 0;

    if (at)
        return tune + at;
    while (i < cart->count[CART_TUNES] && cart_tune_offset(cart, CART_TUNES, i) != tune)
        i++;
    if (i == cart->count[CART_TUNES] || !find_lump(cart->rom, "wave/", cart_name(cart, CART_TUNES, i), "", &l))
        return 0;
    return (uint32_t)(l.data - cart->tune_data);
}

size_t cart_wave_size(const struct cart *cart, int i)
{
    struct lump l;

    return i >= 0 && find_lump(cart->rom, "wave/", cart_name(cart, CART_TUNES, i), "", &l) ? l.size : 0;
}

uint32_t cart_recording_offset(const struct cart *cart, uint32_t tune, const uint8_t *inst)
{
    const bool is_named = inst_sample_name(inst)[0] != 0;
    const int sound = is_named ? cart_find(cart, CART_SOUNDS, inst_sample_name(inst)) : -1;
    const uint32_t source = sound < 0 ? tune : cart_tune_offset(cart, CART_SOUNDS, sound);
    const struct tune t = tune_of(cart->tune_data + source);

    if (inst[0] != INST_SAMPLE || (is_named && sound < 0) || t.channels == 0)
        return 0;
    const uint32_t first = find_samples_offset(cart, source);
    if (first == 0 || t.channels == 1 || is_named || inst == tune_inst(&t, 0))
        return first;
    const struct sample s = sample_of(cart->tune_data + first);
    return first + (uint32_t)sample_size(s.n, s.coding);
}

static bool find_text(const struct cart *cart, const char *folder, const char *name, const char *suffix,
                      const char **text, size_t *size)
{
    struct lump l;

    if (!find_lump(cart->rom, folder, name, suffix, &l))
        return false;
    *text = (const char *)l.data;
    *size = l.size;
    return true;
}

bool cart_find_script(const struct cart *cart, const char *name, const char **text, size_t *size)
{
    return find_text(cart, "script/", name, ".lua", text, size);
}

bool cart_find_text(const struct cart *cart, const char *name, const char **text, size_t *size)
{
    return find_text(cart, "data/", name, "", text, size);
}

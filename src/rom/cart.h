/*
 * cart.h - a ROM that the board can run: the manifest and assets of a struct rom, checked once and then trusted.
 *
 * Lumps:  manifest        manifest.h
 *         script/X.lua    scripts of the game; script/@std/X.lua: modules of the standard library,
 *                         of which a ROM can lack some
 *         palette/main    768 bytes, 256 x R G B; palette/X: further palettes
 *         shades          CART_SHADES_SIZE bytes, for palette/main: for each of 256 entries, the entry shown where a
 *                         view dims (view.h) by a quarter; then by a half; then by three quarters; older ROMs lack it
 *         shade/X         like shades, but for palette/X; only if it differs from shades
 *         blend/X         CART_BLEND_SIZE bytes: the palette entry for each entry underneath (256 * entry) and each
 *                         entry on top; at most CART_MAX_BLENDS lumps
 *         blends/P/X      the table of blend X while palette/P is loaded; only if it differs from blend/X
 *         fonts/X         a proportional font: face.h
 *         font            64 bytes a character from 32 on, 8x8 shades 0..15
 *         gfx/X           a sprite: CART_GFX_HEADER_SIZE bytes (u16 w h pitch, i16 ox oy, u16 frames frame_ticks
 *                         rotations bank palette, 4 zero bytes; struct sprite), then frames * rotations pictures of
 *                         pitch * h bytes; picture = frame * rotations + rotation
 *         hit/X           the hitbox drawn with sprite X, CART_HITBOX_SIZE bytes: u32 shape (motion.h), u32 rows, then
 *                         four times i32 a b x y, as in the rows of a kind (a capsule: x, y is one end of its axis);
 *                         unused rows are 0. Ticks read this lump
 *         lang/X          a language: words.h
 *         bulletml/X      a BulletML document's program: bulletml.h
 *         map/X           a map of tiles: CART_MAP_HEADER_SIZE bytes (u16 cols rows tile_side tiles bank all_solid, 4
 * zero
 *                         bytes; struct map); cols * rows tile numbers, u16, row by row; a byte per tile, 1: solid,
 *                         none of its pixels is transparent; then the tiles, tile_side * tile_side bytes each. Tile 0
 *                         is empty; all_solid: 1 if the tiles of all cells are solid
 *         ui/theme        the look of the program's screens: theme.h
 *         demo/X          demos
 *         tune/X          a piece of music: tune.h; ticks read this lump
 *         sound/X         a sound: tune.h, with its samples at the end
 *         wave/X          samples of the piece of music X, if it is a stream: adpcm.h
 *         data/X          text files for rom.text
 */
#ifndef ROM_CART_H
#define ROM_CART_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "rom.h"
#include "bulletml.h"
#include "manifest.h"
#include "face.h"
#include "words.h"

enum {
    CART_GFX_HEADER_SIZE = 24,
    CART_HITBOX_SIZE = 72,
    CART_PALETTE_SIZE = 768, /* bytes */
    CART_BLEND_SIZE = 65536, /* bytes */
    CART_SHADES_SIZE = 768,  /* bytes */
    CART_MAX_BLENDS = 3,
    CART_MAX_TABLED_PALETTES = 65, /* maximum number of palettes if any palette has its own tables */
    CART_MAX_FACES = 8,
    CART_GLYPH_SIZE = 64, /* bytes per character */
    CART_FIRST_CHAR = 32,
    CART_MAX_GLYPHS = 224,
    CART_MAX_SIDE = 1024, /* maximum width, height and pitch of a sprite's picture, px */
    CART_MAX_FRAMES = 256,
    CART_MAX_ROTATIONS = 256,
    CART_MAP_HEADER_SIZE = 16,
    CART_MAX_MAPS = 1024,
    CART_MAX_MAP_SIDE = 16384, /* maximum width and height of a map, px */
    CART_MAX_MAP_CELLS = 1 << 20,
    CART_MAX_TUNES = 1024, /* maximum pieces of music; also maximum sounds */
    CART_MAX_BULLETML = 1024
};

enum { CART_FIRST_TUNE_OFFSET = 16 /* offset of the first tune: a sound or a piece of music */ };

/* Sounds that play automatically if the game has them; cart_cue_names has their names. */
enum cart_cue {
    CUE_SHOT,
    CUE_HIT,
    CUE_GRAZE,
    CUE_KILL,
    CUE_ITEM,
    CUE_BOMB,
    CUE_WARNING,
    CUE_MENU,
    CUE_EXTEND,
    /* The standard library plays these sounds, as well as "warning" and "menu", by name. */
    CUE_SPELL,
    CUE_BONUS,
    CUE_TIME,
    CUE_SELECT,
    CUE_BACK,
    CUE_WRONG,
    CUE_PAUSE,
    CUE_CONTINUE,
    CUE_MISSION,
    CUE_FAILED,
    CART_CUES
};
extern const char *const cart_cue_names[CART_CUES]; /* names of the automatic sounds, such as "shot" */

/* The colour tables of one palette. */
struct cart_colour_tables {
    const uint8_t *shades;                 /* NULL: none */
    const uint8_t *blend[CART_MAX_BLENDS]; /* in ascending order of the blends' names */
    uint8_t mix[CART_MAX_BLENDS]; /* enum blit_mix: the rule with the same results as the table, or BLIT_TABLE */
};

/* The folders of the ROM whose lumps have indices, ascending by name. */
enum cart_folder {
    CART_SPRITES,
    CART_PALETTES,
    CART_BLENDS,
    CART_LANGS,
    CART_MAPS,
    CART_BULLETML,
    CART_FACES,
    CART_TUNES,
    CART_SOUNDS,
    CART_SHADE_TABLES,
    CART_BLEND_TABLES,
    CART_HITBOXES,
    CART_FOLDERS
};

struct cart {
    const struct rom *rom;
    struct manifest manifest;
    int first[CART_FOLDERS], count[CART_FOLDERS]; /* entry i of folder f is lump first[f] + i, 0 <= i < count[f] */
    int max_sprite_w, max_sprite_h;               /* px: greatest width and height of the sprites' pictures */
    bool has_palette_tables;               /* a palette has its own tables; otherwise all palettes use `main_tables` */
    struct cart_colour_tables main_tables; /* tables of palette/main, and of palettes that have none */
    struct cart_colour_tables
        palette_tables[CART_MAX_TABLED_PALETTES]; /* tables of each palette, if has_palette_tables */
    const uint8_t *glyphs;                        /* NULL: no font */
    int n_glyphs;
    const uint8_t *tune_data;       /* the address of place 0 of sounds and music */
    uint32_t cue_offset[CART_CUES]; /* place of each automatic sound; 0: not in the game */
};

struct sprite {
    uint16_t w, h, pitch;                    /* px; pitch is a multiple of 8, pixels beyond w are 0 */
    int16_t ox, oy;                          /* the anchor, px from the picture's top left corner */
    uint16_t frames, frame_ticks, rotations; /* frame_ticks: ticks per picture; rotation r shows turn r / rotations */
    uint16_t bank;                           /* pixels are 0 or bank * 16 + 1..15 */
    uint16_t palette; /* of its sheet; 0: palette/main, otherwise 1 + the index for cart_palette_at */
    const uint8_t *pix;
};

struct map {
    int cols, rows;       /* tiles */
    int tile_side;        /* px of a tile: 8, 16 or 32 */
    int n_tiles, bank;    /* pixels are 0 or bank * 16 + 1..15 */
    bool all_solid;       /* every cell's tile is solid */
    const uint8_t *cells; /* cols * rows numbers below tiles, u16 */
    const uint8_t *solid; /* a byte per tile; 1: solid */
    const uint8_t *pix;
};

/* Opens a ROM: checks all lumps listed at the top of this file, and that the entry script exists. Returns false, with
 * one sentence in err, if a check fails. rom must outlive cart. */
bool cart_open(struct cart *cart, const struct rom *rom, char *err, size_t err_size);

/* cart_name returns the name of entry i of a folder, 0 <= i < count[folder], without the folder's prefix; cart_find the
 * index of the entry with that name, or -1. */
const char *cart_name(const struct cart *cart, enum cart_folder folder, int i);
int cart_find(const struct cart *cart, enum cart_folder folder, const char *name);

/* Store entry i in *out. */
void cart_sprite(const struct cart *cart, int i, struct sprite *out);
void cart_map(const struct cart *cart, int i, struct map *out);
void cart_bulletml(const struct cart *cart, int i, struct ml *out);

/* The hitbox drawn with a sprite: a SHAPE_ constant, and the rows of the shape in fx px, relative to the sprite's
 * origin. */
struct cart_hitbox {
    uint32_t shape, rows;
    struct {
        int32_t a, b, x, y;
    } row[4];
};
void cart_pack_hitbox(const struct cart_hitbox *hit, uint8_t out[CART_HITBOX_SIZE]);

/* Reads the hitbox of the sprite with that name. Returns false if the sprite has no drawn hitbox. */
bool cart_find_hitbox(const struct cart *cart, const char *name, struct cart_hitbox *out);

/* Opens the translations of the language with that name; "" opens an empty table. Returns false if the game has no such
 * language. */
bool cart_open_lang(const struct cart *cart, const char *name, struct words *out);

/* cart_palette returns the palette with that name, as 256 x R G B, or NULL if there is none; "main" always exists.
 * cart_palette_at returns palette i. */
const uint8_t *cart_palette(const struct cart *cart, const char *name);
const uint8_t *cart_palette_at(const struct cart *cart, int i);

/* Returns font i of rom.lua's `fonts`. */
struct face cart_face(const struct cart *cart, int i);

/* Returns the place of piece of music or sound i: the offset of its lump (tune.h) from tune_data, never 0. Ticks
 * compute with places, so places must depend on no lumps other than sounds and music. */
uint32_t cart_tune_offset(const struct cart *cart, enum cart_folder folder, int i);

/* Returns the size in bytes of the samples of a stream, piece of music i; 0 if the piece is not a stream or i is
 * negative. */
size_t cart_wave_size(const struct cart *cart, int i);

/* Returns the place of the recording that an instrument of the tune at place `tune` plays; 0: none. inst: the
 * instrument's bytes in the tune. */
uint32_t cart_recording_offset(const struct cart *cart, uint32_t tune, const uint8_t *inst);

/* Finds the glyph of a character in one of the game's proportional fonts, or in the font of text cells if face is NULL.
 * If that font has no such glyph, uses the first of `fonts` that has one, then the font of text cells; such a glyph is
 * aligned with the bottom of the line. A blank without a glyph has no pixels. Returns false if no font has the
 * character. */
bool cart_find_glyph(const struct cart *cart, const struct face *face, uint32_t code, struct face_glyph *out);

/* The same for a full-width letter that is `screen.full_width` px wide. If face is NULL or has no such glyph, uses the
 * font whose lines are nearest that height. The glyph is in the middle of the line and of its width. */
bool cart_find_full_width_glyph(const struct cart *cart, const struct face *face, uint32_t code,
                                struct face_glyph *out);

/* Returns whether a font of the game can show the character. Blanks can always be shown. */
bool cart_has_glyph(const struct cart *cart, uint32_t code);

/* Finds the text of a script, such as "stages/one" or "@std/pattern". Returns false if there is no such script. The
 * text is not NUL-terminated. */
bool cart_find_script(const struct cart *cart, const char *name, const char **text, size_t *size);

/* Finds the text of a data file, such as "names.txt". Returns false if there is no such file. The text is not
 * NUL-terminated. */
bool cart_find_text(const struct cart *cart, const char *name, const char **text, size_t *size);

#endif

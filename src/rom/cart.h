/*
 * cart.h - a ROM the board can run: the manifest and art of a struct rom, checked once and then trusted.
 *
 * Lumps:  manifest        manifest.h
 *         script/X.lua    scripts of the game; script/@std/X.lua: modules of the standard library,
 *                         of which a ROM can lack some
 *         palette/main    768 bytes, 256 x R G B; palette/X: further palettes
 *         shades          CART_SHADES bytes, for palette/main: the entry shown for each of 256 where a view dims
 *                         (board.h) by a quarter, then by a half, then by three quarters; older ROMs have none
 *         shade/X         the same for palette/X, if it differs
 *         blend/X         CART_BLEND bytes: the palette entry for each entry underneath (256 * entry) and each entry on
 *                         top; at most CART_MAX_BLENDS lumps
 *         blends/P/X      the table of blend X while palette/P is loaded, if it differs
 *         fonts/X         a proportional font: face.h
 *         font            64 bytes a character from 32 on, 8x8 shades 0..15
 *         gfx/X           a sprite: CART_GFX_HEADER bytes (u16 w h pitch, i16 ox oy, u16 frames every rotations bank,
 *                         6 zero bytes), then frames * rotations pictures of pitch * h bytes;
 *                         picture = frame * rotations + rotation
 *         hit/X           the hitbox drawn with sprite X, CART_HIT bytes: u32 shape (motion.h), u32 rows, then four
 *                         times i32 a b x y, as in the rows of a kind (a capsule: x, y is one end of its axis); unused
 *                         rows are 0. Ticks read it
 *         lang/X          a language: words.h
 *         bulletml/X      a BulletML document's program: bulletml.h
 *         map/X           a map of tiles: CART_MAP_HEADER bytes (u16 columns rows side tiles bank whole, 4 zero
 *                         bytes); columns * rows tile numbers, u16, row by row; a byte a tile, 1 if none of its pixels
 *                         is transparent; then the tiles, side * side bytes each. Tile 0 is empty; whole: 1 if the
 *                         tiles of all cells are solid
 *         demo/X          demos
 *         tune/X          a piece of music: tune.h; ticks read it
 *         sound/X         a sound: tune.h, with its recording at the end
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
    CART_GFX_HEADER = 24,
    CART_HIT = 72,
    CART_PALETTE = 768, /* bytes */
    CART_BLEND = 65536, /* bytes */
    CART_SHADES = 768,  /* bytes */
    CART_MAX_BLENDS = 3,
    CART_MAX_LOOKS = 65, /* maximum palettes if any has its own tables */
    CART_MAX_FACES = 8,
    CART_GLYPH = 64, /* bytes */
    CART_FIRST_CHAR = 32,
    CART_MAX_GLYPHS = 224,
    CART_MAX_SIDE = 1024, /* px of a sprite's picture */
    CART_MAX_FRAMES = 256,
    CART_MAX_ROTATIONS = 256,
    CART_MAP_HEADER = 16,
    CART_MAX_MAPS = 1024,
    CART_MAP_SIDE = 16384, /* px of a map */
    CART_MAP_CELLS = 1 << 20,
    CART_MAX_TUNES = 1024, /* the limit for sounds is the same */
    CART_MAX_BULLETML = 1024
};

/* Sounds with these names play automatically. */
enum { TUNES_FIRST = 16 /* the place of the first sound or piece of music */ };
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
    /* The library plays these, "warning" and "menu" by name. */
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
extern const char *const cart_cues[CART_CUES]; /* their names, such as "shot" */

/* The colour tables of one palette. */
struct cart_look {
    const uint8_t *shades;                 /* NULL: none */
    const uint8_t *blend[CART_MAX_BLENDS]; /* ascending by name */
    uint8_t mix[CART_MAX_BLENDS]; /* enum blit_mix: the rule with the same result as the table, or BLIT_TABLE */
};

struct cart {
    const struct rom *rom;
    struct manifest m;
    int first_sprite, sprites; /* lumps gfx/...; sprite i is lump first_sprite + i */
    int first_palette, palettes;
    bool has_looks; /* some palette has its own tables; otherwise all share those of main */
    int first_blend, blends;
    int first_lang, langs;
    int first_map, maps;
    int first_bulletml, bulletmls;
    struct cart_look main;                  /* of palette/main, and of palettes without their own */
    struct cart_look looks[CART_MAX_LOOKS]; /* of each palette, if has_looks */
    const uint8_t *glyphs;                  /* NULL: no font */
    int n_glyphs;
    int first_face, faces;
    int first_tune, tunes;
    const uint8_t *tune_data; /* base of the places of sounds and music */
    int first_sound, sounds;
    uint32_t cue[CART_CUES]; /* places of the automatic sounds; 0: not in the game */
};

struct sprite {
    uint16_t w, h, pitch;              /* px; pitch is a multiple of 8, pixels beyond w are 0 */
    int16_t ox, oy;                    /* the anchor, px from the picture's top left corner */
    uint16_t frames, every, rotations; /* every: ticks per picture; rotation r shows turn r / rotations */
    uint16_t bank;                     /* pixels are 0 or bank * 16 + 1..15 */
    const uint8_t *pix;
};

struct map {
    int cols, rows;       /* tiles */
    int side;             /* px of a tile: 8, 16 or 32 */
    int tiles, bank;      /* pixels are 0 or bank * 16 + 1..15 */
    bool whole;           /* every cell's tile is solid */
    const uint8_t *cells; /* cols * rows numbers below tiles, u16 */
    const uint8_t *solid; /* a byte a tile */
    const uint8_t *pix;
};

/* Checks all lumps listed above, and that the entry script exists. Returns false, with one sentence in err, if a check
 * fails. rom must outlive cart. */
bool cart_open(struct cart *cart, const struct rom *rom, char *err, size_t err_size);

/* Return sprite i, 0 <= i < sprites; its name without "gfx/"; the index of a name, or -1. */
void cart_sprite(const struct cart *cart, int i, struct sprite *out);
const char *cart_sprite_name(const struct cart *cart, int i);
int cart_find_sprite(const struct cart *cart, const char *name);

/* The hitbox drawn with a sprite: a SHAPE_ constant and its rows; lengths in fx px, from the sprite's origin. */
struct cart_hit {
    uint32_t shape, rows;
    struct {
        int32_t a, b, x, y;
    } row[4];
};
void cart_hit_pack(const struct cart_hit *hit, uint8_t out[CART_HIT]);

/* Reads the hitbox of the sprite with that name. Returns false if none was drawn. */
bool cart_find_hit(const struct cart *cart, const char *name, struct cart_hit *out);

/* Return the name of blend i, 0 <= i < blends, without "blend/"; the index of a name, or -1. */
const char *cart_blend_name(const struct cart *cart, int i);
int cart_find_blend(const struct cart *cart, const char *name);

/* Returns the name of language i, 0 <= i < langs, without "lang/". */
const char *cart_lang_name(const struct cart *cart, int i);

/* Opens the translations of a language; "" gives an empty table. Returns false if the game has no such language. */
bool cart_lang(const struct cart *cart, const char *name, struct words *out);

/* Return map i, 0 <= i < maps; its name without "map/"; the index of a name, or -1. */
void cart_map(const struct cart *cart, int i, struct map *out);
const char *cart_map_name(const struct cart *cart, int i);
int cart_find_map(const struct cart *cart, const char *name);

/* Return the program of document i, 0 <= i < bulletmls; its name without "bulletml/"; the index of a name, or -1. */
void cart_bulletml(const struct cart *cart, int i, struct ml *out);
const char *cart_bulletml_name(const struct cart *cart, int i);
int cart_find_bulletml(const struct cart *cart, const char *name);

/* Returns the palette with a name, without "palette/", as 256 x R G B; NULL: none. "main" always exists. */
const uint8_t *cart_palette(const struct cart *cart, const char *name);
const char *cart_palette_name(const struct cart *cart, int i); /* 0 <= i < palettes */
const uint8_t *cart_palette_at(const struct cart *cart, int i);

/* Return the name of font i of rom.lua's `fonts`, 0 <= i < faces; the font; the index of a name, or -1. */
const char *cart_face_name(const struct cart *cart, int i);
struct face cart_face(const struct cart *cart, int i);
int cart_find_face(const struct cart *cart, const char *name);

/* Return the name of piece of music i, 0 <= i < tunes, or of sound i; its place, an offset from tune_data (tune.h); the
 * index of a name, or -1. A place is never 0. Ticks compute with places, so they depend on no lumps other than sounds
 * and music. */
const char *cart_tune_name(const struct cart *cart, int i);
uint32_t cart_tune(const struct cart *cart, int i);
int cart_find_tune(const struct cart *cart, const char *name);
const char *cart_sound_name(const struct cart *cart, int i);
uint32_t cart_sound(const struct cart *cart, int i);
int cart_find_sound(const struct cart *cart, const char *name);

/* Returns the bytes of the samples of piece of music i; 0: not a stream, or i is negative. */
size_t cart_wave_size(const struct cart *cart, int i);

/* Returns the place of the recording of an instrument, whose bytes are `inst`, of the tune at place `tune`; 0: none. */
uint32_t cart_recording(const struct cart *cart, uint32_t tune, const uint8_t *inst);

/* Returns whether a font of the game can show the character. Blanks can always be shown. */
bool cart_has_glyph(const struct cart *cart, uint32_t code);

/* Finds the text of a script, such as "stages/one" or "@std/pattern"; it is not NUL-terminated. Returns false if there
 * is none. */
bool cart_script(const struct cart *cart, const char *name, const char **text, size_t *size);

/* Finds the text of a data file, such as "names.txt". Returns false if there is none. */
bool cart_text(const struct cart *cart, const char *name, const char **text, size_t *size);

#endif

/*
 * cart.h - a ROM the board can run: the manifest and art of a struct rom, checked once and then trusted.
 *
 * Lumps:  manifest        manifest.h
 *         script/X.lua    scripts of the game; script/@std/X.lua modules of the standard library, not always all
 *         palette/main    768 bytes, 256 x R G B; palette/X more of them
 *         shades          CART_SHADES bytes, of palette/main: the entry shown for each of 256 where a view dims
 *                         (board.h) by a quarter, then by a half, then by three quarters; older ROMs have none
 *         shade/X         the same of palette/X, where it is another
 *         blend/X         CART_BLEND bytes: the palette entry for each that lies under (256 * it) and each over it; at
 *                         most CART_MAX_BLENDS of them
 *         blends/P/X      the table of blend X while palette/P is loaded, where it is another
 *         font/X          a font of its own widths: face.h
 *         font            64 bytes a character from 32 on, 8x8 shades 0..15
 *         gfx/X           a sprite: CART_GFX_HEADER bytes (u16 w h pitch, i16 ox oy, u16 frames every rotations bank,
 *                         6 zero bytes), then frames * rotations pictures of pitch * h bytes;
 *                         picture = frame * rotations + rotation
 *         hit/X           the hit shape that was drawn with sprite X, CART_HIT bytes: u32 shape (motion.h), u32 rows,
 *                         then four times i32 a b x y, as the rows of a kind have them (a capsule: x, y is one end of
 *                         its bar); rows that are not used are 0. A tick reads it
 *         lang/X          a language: words.h
 *         bulletml/X      a BulletML document's program: bulletml.h
 *         map/X           a map of tiles: CART_MAP_HEADER bytes (u16 columns rows side tiles bank whole, 4 zero
 *                         bytes); columns * rows tile numbers, u16, row by row; a byte a tile, 1 if none of its pixels
 *                         is transparent; then the tiles, side * side bytes each. Tile 0 is empty; whole: 1 if all
 *                         tiles in it are solid
 *         demo/X          demos
 *         tune/X          a piece of music: tune.h; a tick reads it
 *         sound/X         a sound: tune.h, its recording behind it
 *         wave/X          samples of the piece of music X, which is a stream: adpcm.h
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
    CART_MAX_LOOKS = 65, /* palettes that have tables of their own */
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
    CART_MAX_TUNES = 1024, /* and so many sounds */
    CART_MAX_BULLETML = 1024
};

/* Sounds of these names play by themselves. */
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
    /* Those from here on the library asks for by their names, and "warning" and "menu". */
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
extern const char *const cart_cues[CART_CUES]; /* "shot" */

/* Tables that follow from colours: those of one palette. */
struct cart_look {
    const uint8_t *shades;                 /* NULL: none */
    const uint8_t *blend[CART_MAX_BLENDS]; /* in the order of their names */
    uint8_t mix[CART_MAX_BLENDS];          /* enum blit_mix: the rule that makes the same table, or BLIT_TABLE */
};

struct cart {
    const struct rom *rom;
    struct manifest m;
    int first_sprite, sprites; /* lumps gfx/...: sprite i is lump first_sprite + i */
    int first_palette, palettes;
    bool has_looks; /* some palette has tables of its own; else all have those of main */
    int first_blend, blends;
    int first_lang, langs;
    int first_map, maps;
    int first_bulletml, bulletmls;
    struct cart_look main;                  /* of palette/main, and of all that have none */
    struct cart_look looks[CART_MAX_LOOKS]; /* of each palette, where has_looks */
    const uint8_t *glyphs;                  /* NULL: no font */
    int n_glyphs;
    int first_face, faces;
    int first_tune, tunes;
    const uint8_t *tune_data; /* what places of sounds and music are counted from */
    int first_sound, sounds;
    uint32_t cue[CART_CUES]; /* places in the ROM of the sounds that play by themselves; 0: the game has none */
};

struct sprite {
    uint16_t w, h, pitch;              /* px; pitch a multiple of 8, what lies beyond w is 0 */
    int16_t ox, oy;                    /* the anchor, px from the picture's top left corner */
    uint16_t frames, every, rotations; /* every: frames of time a picture stands; rotation r shows turn r / rotations */
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

/* Checks all of the above, and that the entry script is there. False and one sentence else. rom must outlive cart. */
bool cart_open(struct cart *cart, const struct rom *rom, char *err, size_t err_size);

/* Sprite i, 0 <= i < sprites; its name without "gfx/"; the index of a name, or -1. */
void cart_sprite(const struct cart *cart, int i, struct sprite *out);
const char *cart_sprite_name(const struct cart *cart, int i);
int cart_find_sprite(const struct cart *cart, const char *name);

/* The hit shape drawn with a sprite: a SHAPE_ and its rows, lengths in fx px from the sprite's origin. */
struct cart_hit {
    uint32_t shape, rows;
    struct {
        int32_t a, b, x, y;
    } row[4];
};
void cart_hit_pack(const struct cart_hit *hit, uint8_t out[CART_HIT]);

/* Of the sprite of that name; false: none was drawn. */
bool cart_find_hit(const struct cart *cart, const char *name, struct cart_hit *out);

/* Blend i, 0 <= i < blends: its name without "blend/"; the index of a name, or -1. */
const char *cart_blend_name(const struct cart *cart, int i);
int cart_find_blend(const struct cart *cart, const char *name);

/* Language i, 0 <= i < langs: its name without "lang/". */
const char *cart_lang_name(const struct cart *cart, int i);

/* The words of a language; "": none, in which nothing is found. False: the game has no such language. */
bool cart_lang(const struct cart *cart, const char *name, struct words *out);

/* Map i, 0 <= i < maps; its name without "map/"; the index of a name, or -1. */
void cart_map(const struct cart *cart, int i, struct map *out);
const char *cart_map_name(const struct cart *cart, int i);
int cart_find_map(const struct cart *cart, const char *name);

/* Document i, 0 <= i < bulletmls: its program; its name without "bulletml/"; the index of a name, or -1. */
void cart_bulletml(const struct cart *cart, int i, struct ml *out);
const char *cart_bulletml_name(const struct cart *cart, int i);
int cart_find_bulletml(const struct cart *cart, const char *name);

/* 256 x R G B, or NULL. The name comes without "palette/"; "main" is always there. */
const uint8_t *cart_palette(const struct cart *cart, const char *name);
const char *cart_palette_name(const struct cart *cart, int i); /* from 0 on, below palettes */
const uint8_t *cart_palette_at(const struct cart *cart, int i);

/* Font i of rom.lua's `fonts`, 0 <= i < faces: its name; itself; the index of a name, or -1. */
const char *cart_face_name(const struct cart *cart, int i);
struct face cart_face(const struct cart *cart, int i);
int cart_find_face(const struct cart *cart, const char *name);

/* Piece of music i, 0 <= i < tunes, and sound i: its name; its place, counted from tune_data (tune.h); the index of a
 * name, or -1. A place is never 0, and the same whatever else is in the ROM: it is part of what a tick computes. */
const char *cart_tune_name(const struct cart *cart, int i);
uint32_t cart_tune(const struct cart *cart, int i);
int cart_find_tune(const struct cart *cart, const char *name);
const char *cart_sound_name(const struct cart *cart, int i);
uint32_t cart_sound(const struct cart *cart, int i);
int cart_find_sound(const struct cart *cart, const char *name);

/* Bytes of the samples of piece of music i; 0: it is no stream, or there is no i. */
size_t cart_wave_size(const struct cart *cart, int i);

/* The recording of an instrument, bytes `inst` of the tune at `tune`: its place; 0: there is none. */
uint32_t cart_recording(const struct cart *cart, uint32_t tune, const uint8_t *inst);

/* Can the character be shown by a font of the game? A blank can always. */
bool cart_has_glyph(const struct cart *cart, uint32_t code);

/* The text of script "stages/one" (or "@std/pattern"), not NUL-terminated; false: none. */
bool cart_script(const struct cart *cart, const char *name, const char **text, size_t *size);

/* The text of data file "names.txt"; false: none. */
bool cart_text(const struct cart *cart, const char *name, const char **text, size_t *size);

#endif

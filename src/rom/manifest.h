/*
 * manifest.h - the settings of a game: name, screen, capacities, DIP switches.
 *
 * An author writes them as rom.lua, which the packer reads with manifest_read. In a ROM they are the lump "manifest",
 * which is binary, has a fixed size per format, and is read by manifest_unpack. Both functions end with manifest_check,
 * so a struct manifest is always in range.
 */
#ifndef ROM_MANIFEST_H
#define ROM_MANIFEST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    MAX_DIPS = 16,
    MAX_DIP_VALUES = 16,
    MAX_DIP_RANGE = 1 << 16, /* maximum count of numbers from min to max, since hosts list them */
    MAX_DIFFICULTIES = 8,
    MAX_EXTENDS = 8,
    NV_KIB = 32,            /* default capacity of nvram */
    NV_MOST_KIB = 1024,     /* maximum */
    MAX_WORD = 16,          /* bytes of the name of a DIP, a DIP's value or a difficulty, with its NUL */
    MANIFEST_BYTES = 5256,  /* maximum size of the lump, the same on every host */
    MANIFEST_WORK = 8 << 20 /* bytes of scratch memory for manifest_read */
};

struct dip {
    char name[MAX_WORD];
    bool number;           /* true: a number from lo to hi; false: one of the named values, 0 to values - 1 */
    int32_t lo, hi, value; /* value: the default setting */
    int32_t values;        /* 0 for a number */
    char value_name[MAX_DIP_VALUES][MAX_WORD];
};

struct manifest {
    char id[32];    /* [a-z0-9_]; used in the names of demos and saves */
    char title[64]; /* any text without control characters */
    char author[64];
    char entry[64]; /* the script that runs first, without "script/" and ".lua" */
    int32_t version;
    int32_t screen_w, screen_h;                 /* px; width a multiple of 8 */
    int32_t field_x, field_y, field_w, field_h; /* px, inside the screen */
    int32_t margin;                             /* px by which the keep box exceeds the field on each side */
    int32_t bullets, shots, enemies, sparks, sprites, motions, tasks; /* capacities; 0: the chip is absent */
    int32_t bullet_values, shot_values, enemy_values;                 /* number of declared values per entity */
    int32_t hp, around, frozen;   /* 1: stored for bullets and other entities that support it; 0: not stored */
    int32_t meet;                 /* 1: bullets can meet other bullets */
    int32_t items;                /* capacity; default 0 */
    int32_t lines;                /* capacity for lines of text; default 0 */
    int32_t wide;                 /* 1: a text cell can hold any character, and its font */
    int32_t bg;                   /* 1: the game has backgrounds, which need maps */
    int32_t lasers, curve_points; /* capacities; points: for all curves together, allocated in units of 32 */
    int32_t registers;            /* for all ships and the run together */
    int32_t options;              /* capacity: options in flight at a time; default 0 */
    int32_t bodies;               /* 1: enemies have rates and parts, and can orbit and wander */
    int32_t pierce;               /* 1: shots can pierce */
    int32_t sound;                /* 1: the game has sounds or music */
    int32_t bulletml;             /* capacity: runners of BulletML documents; default 0 */
    int32_t lua_kib;
    int32_t nvram_kib; /* capacity for score tables and saves */
    int32_t players;
    int64_t extends[MAX_EXTENDS]; /* scores that grant a life, ascending */
    int32_t n_extends;
    char difficulties[MAX_DIFFICULTIES][MAX_WORD]; /* easiest first */
    int32_t n_difficulties, difficulty;            /* the default's index */
    struct dip dips[MAX_DIPS];                     /* ascending by name */
    int32_t n_dips;
};

/* The art and sound settings of rom.lua, which only the packer uses. Files are paths in the game's folder. */
enum {
    MAX_ART_PALETTES = 64,
    MAX_ART_BLENDS = 3,
    MAX_ART_SHEETS = 256,
    MAX_ART_SPRITES = 4096,
    MAX_ART_MAPS = 256,
    MAX_ART_CELLS = 1 << 16, /* of all maps whose rows are in rom.lua */
    MAX_ART_SIZES = 16,      /* extra sizes of a sprite */
    MAX_ART_FONTS = 8,
    MAX_ART_SOUNDS = 256,
    MAX_ART_TUNES = 64,
    MAX_ART_MARKERS = 512, /* of all recordings */
    ART_MML = 2048,        /* bytes of a sound's MML in rom.lua, with its NUL */
    ART_CHARS = 8192,      /* bytes of a list of characters, with its NUL */
    ART_NAME = 32,
    ART_FILE = 96,
    ART_TILES = 4 /* pictures with a map's tiles */
};

struct art_palette {
    char name[ART_NAME], file[ART_FILE];
};

struct art_blend {
    char name[ART_NAME];
    int32_t mix; /* percent of the upper colour, 1 to 99; 0: the sum; -1, -2, -3: ramp rules add, half, max */
};

struct art_font {
    char name[ART_NAME], file[ART_FILE];
    int32_t w, h;          /* of a cell; 0: a BDF font */
    char chars[ART_CHARS]; /* of the cells, in reading order */
    char also[ART_CHARS];  /* characters that are packed even if no text uses them */
    bool fixed;            /* all cells have the same width */
    bool shadow;
    bool by_index;
};

struct art_sheet {
    char name[ART_NAME], file[ART_FILE];
    char palette[ART_NAME]; /* the one of art.palettes that the picture uses; "": art.palette */
    int32_t bank;
    bool by_index; /* shades come from the picture's palette indices, not its colours */
};

/* For an Aseprite file, 0 in w, h, frames or every means: as in the file. */
struct art_sprite {
    char name[ART_NAME];
    int32_t sheet;      /* index */
    char tag[ART_NAME]; /* selects the frames of an Aseprite file; "": all */
    int32_t x, y, w, h;
    int32_t frames, every, rotations;
    int32_t percent; /* of the size on the sheet */
    int32_t ox, oy;  /* origin, in px of the sheet */
    bool origin;     /* ox, oy are set; otherwise the origin is the centre */
};

/* A tile map. Its cells are in a file, or in art.cells from index `cells` on. */
struct art_map {
    char name[ART_NAME], file[ART_FILE], layer[ART_NAME]; /* file "": the map has rows; layer: in a .tmx file */
    char tiles[ART_TILES][ART_FILE];                      /* n_tiles pictures; only a .tmx file can have several */
    char palette[ART_NAME];                               /* as in struct art_sheet */
    int32_t n_tiles, size, bank, first;                   /* size: px of a tile; 0: given by the file */
    bool by_index;
    int32_t cells, cols, rows;
};

/* The part of a recording that repeats. */
enum art_loops { LOOP_OF_FILE, LOOP_NONE, LOOP_WHOLE, LOOP_GIVEN };
struct art_loop {
    enum art_loops kind;
    bool seconds;         /* start and length are in seconds, not in frames of the file */
    double start, length; /* length 0: up to the end */
};

/* A marker in a piece of music. */
struct art_marker {
    char name[ART_NAME];
    double beat;
};

/* A sound or a piece of music: a file or, for a sound, MML text. */
struct art_sound {
    char name[ART_NAME], file[ART_FILE]; /* file "": mml */
    char mml[ART_MML];
    char title[64];
    int32_t volume, priority, limit; /* volume: of 255 */
    int32_t duck;                    /* how much softer music is while it plays, of 255 */
    /* the following fields are for recordings */
    bool exact;  /* stored with 16 bits per sample */
    bool stereo; /* plays on two voices if it has two channels */
    struct art_loop loop;
    int32_t tempo, bar; /* hundredths of a beat a minute, 0: not given; beats in a bar */
    double offset;      /* seconds before the first beat */
    int32_t first_marker, n_markers;
};

/* Returns whether file is the name of a recording; other files are MML. */
bool art_is_recording(const char *file);

/* Returns whether file is the name of an Aseprite file, .ase or .aseprite; other pictures are PNG. */
bool art_is_ase(const char *file);

struct art {
    char palette[ART_FILE], font[ART_FILE], border[ART_FILE]; /* "": none */
    bool by_index;                                            /* for the font, and the default for other pictures */
    char icon[ART_FILE];                                      /* a .png file, or the name of a sprite; "": none */
    struct art_palette palettes[MAX_ART_PALETTES];
    struct art_blend blends[MAX_ART_BLENDS];
    struct art_font fonts[MAX_ART_FONTS];
    struct art_sheet sheets[MAX_ART_SHEETS];
    struct art_sprite sprites[MAX_ART_SPRITES];
    struct art_map maps[MAX_ART_MAPS];
    struct art_sound sounds[MAX_ART_SOUNDS], tunes[MAX_ART_TUNES];
    struct art_marker markers[MAX_ART_MARKERS];
    uint16_t cells[MAX_ART_CELLS]; /* 0: empty; otherwise the tile's number, from 1 on */
    int n_palettes, n_blends, n_fonts, n_sheets, n_sprites, n_maps; /* each ascending by name */
    int n_cells, n_sounds, n_tunes, n_markers;
};

/* The numeric fields of a manifest: the name in rom.lua ("board.bullets"), the offset in the struct, the range. */
struct manifest_number {
    const char *name;
    size_t offset;
    int32_t lo, hi;
    bool flag; /* written as true or false in rom.lua */
};
enum { MANIFEST_NUMBERS = 37 };
extern const struct manifest_number manifest_numbers[MANIFEST_NUMBERS];

/* Sets all fields to their defaults; the id is "game". */
void manifest_default(struct manifest *m);

/* Returns whether every field is in range; if not, err is one sentence ("board.bullets: ..."). */
bool manifest_check(const struct manifest *m, char *err, size_t err_size);

/* Convert a manifest to the lump and back. manifest_pack uses the older of the two current formats if that can
 * represent the manifest, and returns the lump's size in bytes. manifest_unpack accepts only lumps that this or an
 * earlier version of manifest_pack writes for a manifest in range; otherwise it returns false, with one sentence in
 * err. */
uint32_t manifest_pack(const struct manifest *m, uint8_t out[MANIFEST_BYTES]);
bool manifest_unpack(const uint8_t *data, size_t size, struct manifest *m, char *err, size_t err_size);

/* Reads the text of rom.lua, n bytes. file is its name in messages; folder is the default of the id, in which invalid
 * characters become _. work is MANIFEST_WORK bytes of scratch, 16-byte aligned: the text is Lua, which runs without
 * functions and with bounded memory and time. On failure returns false, with one sentence in err ("rom.lua:
 * board.bulets: unknown name (did you mean "bullets"?)"). */
bool manifest_read(const char *text, size_t n, const char *file, const char *folder, struct manifest *m,
                   struct art *art, void *work, char *err, size_t err_size);

/* Returns whether s is a valid name of a DIP, a DIP's value or a difficulty: [A-Za-z0-9_-]+, shorter than MAX_WORD. */
bool manifest_word_ok(const char *s);

/* Returns whether s is a valid path of a script, sheet or data file in the game's folder: parts of [A-Za-z0-9_.-]+
 * joined by /, none of which starts with a dot. */
bool manifest_path_ok(const char *s);

#endif

/*
 * manifest.h - what a game says about itself: name, screen, capacities, DIP switches.
 *
 * An author writes it as rom.lua, which the packer reads with manifest_read. In a ROM it is the lump "manifest", binary
 * and of fixed size, which manifest_unpack reads. Both ways end in manifest_check, so a struct manifest is always in
 * range.
 */
#ifndef ROM_MANIFEST_H
#define ROM_MANIFEST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    MAX_DIPS = 16,
    MAX_DIP_VALUES = 16,
    MAX_DIP_RANGE = 1 << 16, /* numbers from min to max: hosts list them */
    MAX_DIFFICULTIES = 8,
    MAX_EXTENDS = 8,
    NV_KIB = 32,            /* room for nvram when rom.lua says nothing */
    NV_MOST_KIB = 1024,     /* the most */
    MAX_WORD = 16,          /* a name of a DIP, a DIP's value, a difficulty, with its NUL */
    MANIFEST_BYTES = 5256,  /* the lump's size at most, the same on every host */
    MANIFEST_WORK = 8 << 20 /* bytes of scratch manifest_read needs */
};

struct dip {
    char name[MAX_WORD];
    bool number;           /* a number from lo to hi; else one of the named values, 0 to values - 1 */
    int32_t lo, hi, value; /* value: the default */
    int32_t values;        /* 0 for a number */
    char value_name[MAX_DIP_VALUES][MAX_WORD];
};

struct manifest {
    char id[32];    /* [a-z0-9_]: names demos and saves */
    char title[64]; /* any text without control characters */
    char author[64];
    char entry[64]; /* the script that runs first, without "script/" and ".lua" */
    int32_t version;
    int32_t screen_w, screen_h;                 /* px; width a multiple of 8 */
    int32_t field_x, field_y, field_w, field_h; /* px, inside the screen */
    int32_t margin;                             /* px the keep box is larger than the field on every side */
    int32_t bullets, shots, enemies, sparks, sprites, motions, tasks; /* capacities; 0: the chip is absent */
    int32_t bullet_values, shot_values, enemy_values;                 /* numbers of its own that each has room for */
    int32_t hp, around, frozen;   /* 1: bullets have it, and what else can; 0: nothing has, and it takes no room */
    int32_t meet;                 /* 1: bullets may meet bullets */
    int32_t items;                /* a capacity: 0 unless rom.lua asks for them */
    int32_t lines;                /* the same of lines of text */
    int32_t wide;                 /* 1: a cell has room for any character, and for its font */
    int32_t bg;                   /* 1: there are backgrounds, which need maps */
    int32_t lasers, curve_points; /* capacities; points: of all curves together, in pieces of 32 */
    int32_t registers;            /* of all ships and the run together */
    int32_t options;              /* that fly at once; 0 unless rom.lua asks for them */
    int32_t bodies;               /* 1: enemies have rates and parts, go round and wander */
    int32_t pierce;               /* 1: shots may go through what they hit */
    int32_t sound;                /* 1: there are sounds or music */
    int32_t bulletml;             /* BulletML documents' runners; 0 unless rom.lua asks for them */
    int32_t lua_kib;
    int32_t nvram_kib; /* room for score tables and saves */
    int32_t players;
    int64_t extends[MAX_EXTENDS]; /* scores that give a life, ascending */
    int32_t n_extends;
    char difficulties[MAX_DIFFICULTIES][MAX_WORD]; /* easiest first */
    int32_t n_difficulties, difficulty;            /* the default's index */
    struct dip dips[MAX_DIPS];                     /* ascending by name */
    int32_t n_dips;
};

/* What rom.lua says of the art; only the packer sees it. Files are paths in the game's folder. */
enum {
    MAX_ART_PALETTES = 64,
    MAX_ART_BLENDS = 3,
    MAX_ART_SHEETS = 256,
    MAX_ART_SPRITES = 4096,
    MAX_ART_MAPS = 256,
    MAX_ART_CELLS = 1 << 16, /* of all maps whose rows stand in rom.lua */
    MAX_ART_SIZES = 16,      /* of a sprite, beside its own */
    MAX_ART_FONTS = 8,
    MAX_ART_SOUNDS = 256,
    MAX_ART_TUNES = 64,
    MAX_ART_MARKERS = 512, /* of all recordings */
    ART_MML = 2048,        /* bytes of a sound's MML in rom.lua, with its NUL */
    ART_CHARS = 8192,      /* bytes of a list of characters, with its NUL */
    ART_NAME = 32,
    ART_FILE = 96,
    ART_TILES = 4 /* pictures of a map's tiles */
};

struct art_palette {
    char name[ART_NAME], file[ART_FILE];
};

struct art_blend {
    char name[ART_NAME];
    int32_t mix; /* percent of the upper colour, 1 to 99; 0: the sum; -1, -2, -3: of ramps, add, half, max */
};

struct art_font {
    char name[ART_NAME], file[ART_FILE];
    int32_t w, h;          /* of a cell; 0: a BDF font */
    char chars[ART_CHARS]; /* of the cells, in reading order */
    char also[ART_CHARS];  /* packed even if no text has them */
    bool fixed;            /* all cells are as wide */
    bool shadow;
    bool by_index;
};

struct art_sheet {
    char name[ART_NAME], file[ART_FILE];
    char palette[ART_NAME]; /* one of art.palettes, whose colours the picture has; "": art.palette */
    int32_t bank;
    bool by_index; /* shades are the picture's palette indices, not its colours */
};

/* Of a file of Aseprite's, 0 in w, h, frames or every: as it is there. */
struct art_sprite {
    char name[ART_NAME];
    int32_t sheet;      /* index */
    char tag[ART_NAME]; /* of a file of Aseprite's: which frames; "": all */
    int32_t x, y, w, h;
    int32_t frames, every, rotations;
    int32_t percent; /* of the size on the sheet */
    int32_t ox, oy;  /* on the sheet */
    bool origin;     /* ox, oy were given; else the middle */
};

/* A map of tiles: its cells stand in a file, or in art.cells from `cells` on. */
struct art_map {
    char name[ART_NAME], file[ART_FILE], layer[ART_NAME]; /* file "": rows; layer: of a .tmx */
    char tiles[ART_TILES][ART_FILE];                      /* pictures, as many as n_tiles; several: of a .tmx */
    char palette[ART_NAME];                               /* as a sheet's */
    int32_t n_tiles, size, bank, first;                   /* size: px of a tile, 0 if the file says it */
    bool by_index;
    int32_t cells, cols, rows;
};

/* Which part of a recording repeats. */
enum art_loops { LOOP_OF_FILE, LOOP_NONE, LOOP_WHOLE, LOOP_GIVEN };
struct art_loop {
    enum art_loops kind;
    bool seconds;         /* start and length are in seconds, not in frames of the file */
    double start, length; /* length 0: to the end */
};

/* A place in a piece of music. */
struct art_marker {
    char name[ART_NAME];
    double beat;
};

/* A sound, or a piece of music: a file, or a sound's MML itself. */
struct art_sound {
    char name[ART_NAME], file[ART_FILE]; /* file "": mml */
    char mml[ART_MML];
    char title[64];
    int32_t volume, priority, limit; /* volume: of 255 */
    int32_t duck;                    /* of 255, how much softer music is while it plays */
    /* of a recording */
    bool exact;  /* kept as 16 bits */
    bool stereo; /* two voices, if it has two channels */
    struct art_loop loop;
    int32_t tempo, bar; /* hundredths of a beat a minute, 0: not said; beats */
    double offset;      /* seconds before the first beat */
    int32_t first_marker, n_markers;
};

/* Is that the name of a recording's file? Other ones are MML. */
bool art_is_recording(const char *file);

/* Is it that of a file of Aseprite's, .ase or .aseprite? Other pictures are PNG. */
bool art_is_ase(const char *file);

struct art {
    char palette[ART_FILE], font[ART_FILE], border[ART_FILE]; /* "": none */
    bool by_index;                                            /* the font, and what says nothing of its own */
    char icon[ART_FILE];                                      /* a .png, else the name of a sprite; "": none */
    struct art_palette palettes[MAX_ART_PALETTES];
    struct art_blend blends[MAX_ART_BLENDS];
    struct art_font fonts[MAX_ART_FONTS];
    struct art_sheet sheets[MAX_ART_SHEETS];
    struct art_sprite sprites[MAX_ART_SPRITES];
    struct art_map maps[MAX_ART_MAPS];
    struct art_sound sounds[MAX_ART_SOUNDS], tunes[MAX_ART_TUNES];
    struct art_marker markers[MAX_ART_MARKERS];
    uint16_t cells[MAX_ART_CELLS];                                  /* 0: empty, else a tile's number from 1 on */
    int n_palettes, n_blends, n_fonts, n_sheets, n_sprites, n_maps; /* each ascending by name */
    int n_cells, n_sounds, n_tunes, n_markers;
};

/* The plain numbers of a manifest: how rom.lua spells them ("board.bullets"), where they stand in the struct, what they
 * may be. */
struct manifest_number {
    const char *name;
    size_t offset;
    int32_t lo, hi;
    bool flag; /* rom.lua says true or false */
};
enum { MANIFEST_NUMBERS = 37 };
extern const struct manifest_number manifest_numbers[MANIFEST_NUMBERS];

/* All defaults but the id, which is "game". */
void manifest_default(struct manifest *m);

/* Is every field in range? False and one sentence ("board.bullets: ...") else. */
bool manifest_check(const struct manifest *m, char *err, size_t err_size);

/* The lump and back. The lump is of the oldest format that can say all of it; pack returns its bytes. unpack refuses
 * what is not exactly a lump that manifest_pack makes, or once made, of a manifest in range. */
uint32_t manifest_pack(const struct manifest *m, uint8_t out[MANIFEST_BYTES]);
bool manifest_unpack(const uint8_t *data, size_t size, struct manifest *m, char *err, size_t err_size);

/* Reads the text of rom.lua. file is its name for messages, folder the id's default (other characters become _). work
 * is MANIFEST_WORK bytes of scratch, 16-byte aligned: the text is Lua, run with no functions, bounded in memory and
 * time. False and one sentence ("rom.lua: board.bulets: unknown name (did you mean \"bullets\"?)") else. */
bool manifest_read(const char *text, size_t n, const char *file, const char *folder, struct manifest *m,
                   struct art *art, void *work, char *err, size_t err_size);

/* May this be a word (of MAX_WORD) in names of DIPs, their values and difficulties? [A-Za-z0-9_-]+ */
bool manifest_word_ok(const char *s);

/* A script, sheet or data path inside the game's folder: parts of [A-Za-z0-9_.-]+ joined by /, none of them starting
 * with a dot. */
bool manifest_path_ok(const char *s);

#endif

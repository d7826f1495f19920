/*
 * manifest.h - the settings of a game: name, screen, capacities, DIP switches.
 *
 * An author writes the settings in rom.lua, which the packer reads with manifest_read. In a ROM, the settings are the
 * lump "manifest", which is binary, has a fixed size per format, and is read by manifest_unpack. Both functions end
 * with manifest_check, so all fields of a struct manifest that was read are in range.
 */
#ifndef ROM_MANIFEST_H
#define ROM_MANIFEST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    MAX_DIPS = 16,
    MAX_DIP_VALUES = 16,
    MAX_DIP_RANGE = 1 << 16, /* maximum count of numbers from min to max, because hosts list all of them */
    MAX_DIFFICULTIES = 8,
    MAX_EXTENDS = 8,
    NV_DEFAULT_KIB = 32,            /* default nvram_kib */
    NV_MAX_KIB = 1024,              /* maximum nvram_kib */
    MAX_SETTING_NAME = 16,          /* bytes of the name of a DIP, a DIP's value or a difficulty, with its NUL */
    MANIFEST_BYTES = 5276,          /* maximum size of the lump; equal on all hosts */
    MANIFEST_SCRATCH_SIZE = 8 << 20 /* bytes of scratch memory for manifest_read */
};

struct dip {
    char name[MAX_SETTING_NAME];
    bool is_number; /* true: any number from lo to hi; false: the index of a named value, 0 to n_values - 1 */
    int32_t lo, hi, default_value; /* default_value: the default setting */
    int32_t n_values;              /* number of named values; 0 for a number */
    char value_name[MAX_DIP_VALUES][MAX_SETTING_NAME];
};

struct manifest {
    char id[32];    /* [a-z0-9_]+; used in the names of demos and saves */
    char title[64]; /* any text without control characters */
    char author[64];
    char entry[64]; /* the script that runs first, without "script/" and ".lua" */
    int32_t version;
    int32_t screen_w, screen_h;                 /* px; the width is a multiple of 8 */
    int32_t field_x, field_y, field_w, field_h; /* px; the part that is shown is inside the screen */
    int32_t view_w, view_h;                     /* px of the field that are shown; both 0: the whole field */
    int32_t zoom;                               /* px of the screen per px of the field */
    int32_t full_width; /* px from a full-width letter to the next, in text cells that ask for it */
    int32_t margin;     /* px between the field and the keep box, on each side; entities outside the keep box despawn */
    int32_t bullets, shots, enemies, sparks, sprites, motions, tasks; /* capacities; 0: the chip is absent */
    int32_t bullet_values, shot_values, enemy_values;                 /* number of values that each entity has */
    int32_t has_hp, has_orbit, has_freeze; /* 1: stored for bullets and other entities that support it; 0: not stored */
    int32_t bullets_can_meet;              /* 1: bullets can meet other bullets */
    int32_t items;                         /* capacity; default 0 */
    int32_t lines;                         /* capacity for lines of text; default 0 */
    int32_t has_wide_text;                 /* 1: a text cell stores a font and any character; 0: codes up to 255 */
    int32_t has_backgrounds;               /* 1: the game has backgrounds, which need maps */
    int32_t lasers, curve_points; /* capacities; curve_points: of all curves together, allocated in units of 32 */
    int32_t registers;            /* capacity: of all ships and the run together */
    int32_t options;              /* capacity: options active at a time; default 0 */
    int32_t has_bodies;           /* 1: enemies have rates and parts, and can orbit and wander */
    int32_t has_pierce;           /* 1: shots can pierce */
    int32_t has_sound;            /* 1: the game has sounds or music */
    int32_t bulletml_runners;     /* capacity for runners of BulletML documents; default 0 */
    int32_t has_transforms;       /* 1: pictures can turn, be scaled and be translucent */
    int32_t lua_kib;
    int32_t nvram_kib; /* capacity for score tables and saves */
    int32_t players;
    int64_t extends[MAX_EXTENDS]; /* scores that grant a life, ascending */
    int32_t n_extends;
    char difficulties[MAX_DIFFICULTIES][MAX_SETTING_NAME]; /* easiest first */
    int32_t n_difficulties, difficulty;                    /* difficulty: index of the default */
    struct dip dips[MAX_DIPS];                             /* ascending by name */
    int32_t n_dips;
};

enum { MIN_VIEW = 16 /* px, of each side of a view */ };

/* The size in px of the part of the field that is shown. */
static inline int manifest_view_w(const struct manifest *m)
{
    return m->view_w ? m->view_w : m->field_w;
}

static inline int manifest_view_h(const struct manifest *m)
{
    return m->view_h ? m->view_h : m->field_h;
}

/* The art and sound settings of rom.lua, which only the packer uses. File names are paths in the game's folder. */
enum {
    MAX_ART_PALETTES = 64,
    MAX_ART_BLENDS = 3,
    MAX_ART_SHEETS = 256,
    MAX_ART_SPRITES = 4096,
    MAX_ART_MAPS = 256,
    MAX_ART_CELLS = 1 << 16, /* in all maps whose rows are in rom.lua */
    MAX_ART_SIZES = 16,      /* extra sizes of a sprite */
    MAX_ART_FONTS = 8,
    MAX_ART_SOUNDS = 256,
    MAX_ART_TUNES = 64,
    MAX_ART_MARKERS = 512, /* in all recordings */
    ART_MML_SIZE = 2048,   /* bytes of a sound's MML in rom.lua, with its NUL */
    ART_CHARS_SIZE = 8192, /* bytes of a list of characters, with its NUL */
    ART_NAME_SIZE = 32,
    ART_FILE_SIZE = 96,
    MAX_ART_TILE_FILES = 4 /* maximum pictures of tiles per map */
};

struct art_palette {
    char name[ART_NAME_SIZE], file[ART_FILE_SIZE];
};

struct art_blend {
    char name[ART_NAME_SIZE];
    int32_t mix; /* percent of the upper colour, 1 to 99; 0: the sum; -1, -2, -3: ramp rules add, half, max */
};

struct art_font {
    char name[ART_NAME_SIZE], file[ART_FILE_SIZE];
    int32_t size;                     /* of a TrueType font, px per em; 0: the file is not one */
    int32_t w, h;                     /* of a character's cell, px; 0: the file is a TrueType or BDF font */
    char chars[ART_CHARS_SIZE];       /* characters of the cells, in reading order */
    char extra_chars[ART_CHARS_SIZE]; /* characters to pack even if no text uses them */
    bool fixed;                       /* all cells have the same width */
    int32_t ink;                      /* the brightest shade, 2 to 15; 0: as drawn */
    bool shadow;
    bool optional; /* packed only if the file exists */
    bool by_index;
};

struct art_sheet {
    char name[ART_NAME_SIZE], file[ART_FILE_SIZE];
    char palette[ART_NAME_SIZE]; /* name in art.palettes of the picture's palette; "": art.palette */
    int32_t bank;
    bool by_index; /* shades come from the picture's palette indices, not from its colours */
};

/* For an Aseprite file, w, h, frames or frame_ticks 0: the file's value. */
struct art_sprite {
    char name[ART_NAME_SIZE];
    int32_t sheet;           /* index in art.sheets */
    char tag[ART_NAME_SIZE]; /* selects the frames of an Aseprite file; "": all */
    int32_t x, y, w, h;
    int32_t frames, frame_ticks, rotations;
    int32_t scale_percent; /* percent of the size on the sheet */
    int32_t ox, oy;        /* origin, in px of the sheet */
    bool has_origin;       /* ox, oy are set; otherwise the origin is the centre */
};

/* A tile map. Its cells are in a file, or in art.cells from index `first_cell` on. */
struct art_map {
    char name[ART_NAME_SIZE], file[ART_FILE_SIZE],
        layer[ART_NAME_SIZE]; /* file "": cells are in art.cells; layer: of a .tmx file */
    char tile_files[MAX_ART_TILE_FILES]
                   [ART_FILE_SIZE]; /* n_tile_files pictures of tiles; only a .tmx file can have several */
    char palette[ART_NAME_SIZE];    /* as in struct art_sheet */
    int32_t n_tile_files, tile_size, bank, first_tile; /* tile_size: px of a tile; 0: given by the file */
    bool by_index;
    int32_t first_cell, cols, rows;
};

/* Which part of a sample loops. */
enum art_loop_kind { LOOP_FROM_FILE, LOOP_NONE, LOOP_WHOLE, LOOP_RANGE };
struct art_loop {
    enum art_loop_kind kind;
    bool in_seconds;      /* start and length are in seconds; otherwise in sample frames of the file */
    double start, length; /* length 0: up to the end */
};

/* A marker in a piece of music. */
struct art_marker {
    char name[ART_NAME_SIZE];
    double beat;
};

/* A sound or a piece of music: a file or, for a sound, MML text. */
struct art_sound {
    char name[ART_NAME_SIZE], file[ART_FILE_SIZE]; /* file "": the sound is in mml */
    char mml[ART_MML_SIZE];
    char title[64];
    int32_t volume, priority, limit; /* volume: of 255 */
    int32_t duck;                    /* how much softer music is while the sound plays, of 255 */
    /* the following fields are for recordings */
    bool exact;  /* stored with 16 bits per sample */
    bool stereo; /* a file with two channels plays on two voices */
    struct art_loop loop;
    int32_t tempo,
        beats_per_bar; /* tempo: hundredths of a beat per minute, 0: not given; beats_per_bar: beats in a bar */
    double offset;     /* seconds before the first beat */
    int32_t first_marker, n_markers;
};

/* Returns whether file is the name of a recording; other files are MML. */
bool art_is_recording(const char *file);

/* Returns whether file is the name of an Aseprite file, .ase or .aseprite; other pictures are PNG. */
bool art_is_ase(const char *file);

/* `theme`: the look and the sounds of the program's screens (theme.h). */
enum { THEME_DEFAULT = -1 };
enum theme_sound { THEME_OPEN, THEME_MOVE, THEME_ACCEPT, THEME_BACK, THEME_SOUNDS };
struct art_theme {
    bool is_set;
    int32_t ink, accent, rule; /* palette banks of text, 0 to 15, or THEME_DEFAULT */
    int32_t paper;             /* palette entry of the background, 0 to 255, or THEME_DEFAULT */
    uint32_t cursor;           /* the character in front of the chosen row; 0: the default */
    char font[ART_NAME_SIZE], frame[ART_NAME_SIZE], sounds[THEME_SOUNDS][ART_NAME_SIZE]; /* "": the default */
};

struct art {
    char palette[ART_FILE_SIZE], font[ART_FILE_SIZE], border[ART_FILE_SIZE]; /* "": none */
    bool by_index;            /* of the font, and the default for other pictures */
    char icon[ART_FILE_SIZE]; /* a .png file, or the name of a sprite; "": none */
    struct art_theme theme;
    char practice[8]; /* "all" or "reached": the sections open for practice; "": not given */
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

/* A numeric field of a manifest: its name in rom.lua ("board.bullets"), offset in struct manifest, range, default. */
struct manifest_number {
    const char *name;
    size_t offset;
    int32_t lo, hi, default_value;
    bool is_flag; /* written as true or false in rom.lua */
};
enum { MANIFEST_NUMBERS = 42 };
extern const struct manifest_number manifest_numbers[MANIFEST_NUMBERS];

/* Sets all fields to their defaults; the id is "game". */
void manifest_set_defaults(struct manifest *m);

/* Returns whether every field is in range. If not, stores one sentence in err ("board.bullets: ..."). */
bool manifest_check(const struct manifest *m, char *err, size_t err_size);

/* manifest_pack converts a manifest to the lump and returns the lump's size in bytes. It uses the oldest of the
 * current formats that can represent the manifest. manifest_unpack converts a lump to a manifest. It accepts only
 * lumps that this or an earlier version of manifest_pack writes for a manifest in range; for others it returns false,
 * with one sentence in err. */
uint32_t manifest_pack(const struct manifest *m, uint8_t out[MANIFEST_BYTES]);
bool manifest_unpack(const uint8_t *data, size_t size, struct manifest *m, char *err, size_t err_size);

/* Reads the text of rom.lua, n bytes. file is the file's name in messages. folder is the default of the id; invalid
 * characters in it become _. scratch is MANIFEST_SCRATCH_SIZE bytes, 16-byte aligned: the text is Lua,
 * which runs without functions and with bounded memory and time. On failure returns false, with one sentence in err
 * ("rom.lua: board.bulets: unknown key (did you mean "bullets"?)"). */
bool manifest_read(const char *text, size_t n, const char *file, const char *folder, struct manifest *m,
                   struct art *art, void *scratch, char *err, size_t err_size);

/* Returns whether s is a valid name of a DIP, a DIP's value or a difficulty: [A-Za-z0-9_-]+, shorter than
 * MAX_SETTING_NAME. */
bool manifest_setting_name_ok(const char *s);

/* Returns whether s is a valid path of a script, sheet or data file in the game's folder: parts of [A-Za-z0-9_.-]+
 * joined by /, none of which starts with a dot. */
bool manifest_path_ok(const char *s);

#endif

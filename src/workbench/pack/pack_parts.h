/*
 * pack_parts.h - shared by pack.c, pack_art.c and unpack.c.
 */
#ifndef WORKBENCH_PACK_PARTS_H
#define WORKBENCH_PACK_PARTS_H

#include "art.h"
#include "pack_font.h"
#include "pack.h"
#include "../../common/tree.h"

enum { PATH = TREE_PATH };

struct lumps {
    struct lump *lump; /* names and data are malloc */
    int n;
};

struct packer {
    const char *dir;
    bool nearest;
    struct tree files;
    struct lumps lumps;
    struct manifest m;
    struct art art;
    uint8_t palette[CART_PALETTE_SIZE],
        palettes[MAX_ART_PALETTES][CART_PALETTE_SIZE]; /* the main palette, and art.palettes */
    struct pack_font_chars shown;                      /* characters of the game's text */
    char *rom_text;                                    /* of rom.lua; malloc, NUL-terminated */
    uint64_t std;                                      /* modules used by the scripts so far (std.h) */
    pack_warning *warn;                                /* may be NULL */
    void *context;
    int done; /* files, for progress */
    char *err;
    size_t err_size;
};

/* Adds the lump folder + name. Takes ownership of data (malloc), also on failure. */
bool pack_add(struct packer *p, const char *folder, const char *name, uint8_t *data, size_t size);
bool pack_add_copy(struct packer *p, const char *folder, const char *name, const void *data, size_t size);

/* Reports progress: one more file. */
void pack_progress(struct packer *p, const char *file);

/* Read a whole file of the folder. pack_load_named reads a file that rom.lua names. */
bool pack_load(struct packer *p, const char *name, size_t max, uint8_t **data, size_t *size);
bool pack_load_text(struct packer *p, const char *name, size_t max, uint8_t **text, size_t *size);
bool pack_load_named(struct packer *p, const char *file, size_t most, uint8_t **data, size_t *size);

/* Sets the error about a missing file that rom.lua names, with the line. Returns false. */
bool pack_refuse_missing(struct packer *p, const char *file);

bool pack_starts_with(const char *s, const char *head);

/* Add the pictures and the sounds of rom.lua. */
bool pack_add_art(struct packer *p);
bool pack_add_sounds(struct packer *p);

#endif

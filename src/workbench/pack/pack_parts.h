/*
 * pack_parts.h - what pack.c, pack_art.c and unpack.c share.
 */
#ifndef WORKBENCH_PACK_PARTS_H
#define WORKBENCH_PACK_PARTS_H

#include "art.h"
#include "faces.h"
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
        palettes[MAX_ART_PALETTES][CART_PALETTE_SIZE]; /* the first one, and art.palettes */
    struct faces_set shown;                            /* characters of the game's texts */
    char *rom_text;                                    /* of rom.lua, malloc, with a 0 behind it */
    uint64_t std;                                      /* modules that the scripts so far name (std.h) */
    void (*warn)(void *context, const char *sentence); /* NULL: nobody is told */
    void *context;
    int told; /* files that progress was told of */
    char *err;
    size_t err_size;
};

/* Adds the lump folder + name; data (malloc) is the list's from here, also when this fails. */
bool pack_add(struct packer *p, const char *folder, const char *name, uint8_t *data, size_t size);
bool pack_add_copy(struct packer *p, const char *folder, const char *name, const void *data, size_t size);

/* One more of the files that go in. */
void pack_tell(struct packer *p, const char *file);

/* A file of the folder, whole; pack_load_named: one that rom.lua names. */
bool pack_load(struct packer *p, const char *name, size_t max, uint8_t **data, size_t *size);
bool pack_load_text(struct packer *p, const char *name, size_t max, uint8_t **text, size_t *size);
bool pack_load_named(struct packer *p, const char *file, size_t most, uint8_t **data, size_t *size);

/* The error for a file that rom.lua names and that is not there, with the line. */
bool pack_refuse_missing(struct packer *p, const char *file);

bool pack_starts_with(const char *s, const char *head);

/* The pictures and the sounds of rom.lua. */
bool pack_add_art(struct packer *p);
bool pack_add_sounds(struct packer *p);

#endif

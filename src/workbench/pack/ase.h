/*
 * ase.h - reads pictures, tags and slices of Aseprite and LibreSprite files (.ase, .aseprite).
 *
 * Read from the published format: indexed, grey and RGBA sprites; cels raw, compressed or linked; layers in groups,
 * with opacity and blend modes; both kinds of palette chunk. Skipped: user data, colour profiles, external files,
 * paths. Errors, if they are visible: tilemaps, groups with an opacity or blend of their own, and the blend modes soft
 * light, hue, saturation, colour and luminosity.
 */
#ifndef WORKBENCH_ASE_H
#define WORKBENCH_ASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    ASE_NAME = 32, /* bytes of a name with its NUL; longer ones are cut */
    ASE_MAX_SIDE = 4096,
    ASE_MAX_FRAMES = 4096,
    ASE_MAX_LAYERS = 1024,
    ASE_MAX_LIST = 4096,       /* tags, and keys of slices */
    ASE_MAX_BYTES = 128 << 20, /* of all cels, as they inflate */
    ASE_MAX_PICTURE = 1 << 24  /* pixels of one frame, or of a sprite's frames together */
};

enum ase_blend {
    ASE_NORMAL,
    ASE_MULTIPLY,
    ASE_SCREEN,
    ASE_OVERLAY,
    ASE_DARKEN,
    ASE_LIGHTEN,
    ASE_DODGE,
    ASE_BURN,
    ASE_HARD_LIGHT,
    ASE_SOFT_LIGHT,
    ASE_DIFFERENCE,
    ASE_EXCLUSION,
    ASE_HUE,
    ASE_SATURATION,
    ASE_COLOUR,
    ASE_LUMINOSITY,
    ASE_ADDITION,
    ASE_SUBTRACT,
    ASE_DIVIDE,
    ASE_BLENDS
};

struct ase_layer {
    char name[ASE_NAME];
    bool shown;      /* and all groups it is in */
    bool background; /* of an indexed sprite: no index is transparent */
    uint8_t opacity, blend;
};

struct ase_image {
    uint8_t *pix; /* w * h pixels of `depth` bytes; malloc */
    int w, h;
};

struct ase_cel {
    int layer, x, y, z, image;
    uint8_t opacity;
};

struct ase_frame {
    int ms;
    int first_cel, cels; /* in the order of the file */
};

enum ase_way { ASE_FORWARD, ASE_REVERSE, ASE_PING_PONG, ASE_PING_PONG_REVERSE };

struct ase_tag {
    char name[ASE_NAME];
    int from, to; /* frames, from 0 on, both included */
    enum ase_way way;
};

/* A slice starting at a frame: its rectangle on the canvas. */
struct ase_key {
    char name[ASE_NAME];
    int slice, frame; /* slices are numbered in order */
    int32_t x, y, w, h;
    bool pivoted;
    int32_t px, py; /* of the pivot, from the rectangle's corner */
};

struct ase {
    int w, h, depth; /* px; bytes of a pixel: 4, 2 (grey, opacity) or 1 */
    int clear;       /* the transparent index */
    bool mixed;      /* something shown is blended, so that pixels of an indexed sprite have no index */
    uint8_t palette[256][4];
    int colours; /* of the file: those from 256 on have no index in a pixel, and are not stored */
    struct ase_layer *layers;
    struct ase_image *images;
    struct ase_cel *cels;
    struct ase_frame *frames;
    struct ase_tag *tags;
    struct ase_key *keys;
    int n_layers, n_images, n_cels, n_frames, n_tags, n_keys;
};

/* Inflates zlib data to exactly `size` bytes; out has space for one more. False: it is damaged. See png_inflate. */
typedef bool ase_inflate(const uint8_t *packed, size_t n, uint8_t *out, size_t size);

/* Reads a whole file. False and one sentence, without the file's name; close it either way. */
bool ase_read(struct ase *a, const uint8_t *data, size_t n, ase_inflate *inflate, char *err, size_t err_size);
void ase_close(struct ase *a);

/* Merges the layers of a frame (from 0 on) into rgba, w * h * 4 bytes, and where index is not NULL the palette indices
 * of the topmost pixels; of an indexed sprite that is not `mixed`. False and one sentence. */
bool ase_merge(const struct ase *a, int frame, uint8_t *rgba, uint8_t *index, char *err, size_t err_size);

/* A colour over another, both R G B and opacity: `under` is replaced. */
void ase_blend(enum ase_blend mode, uint8_t under[4], const uint8_t colour[4]);

#endif

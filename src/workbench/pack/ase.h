/*
 * ase.h - reads cels, tags and slices of Aseprite and LibreSprite files (.ase, .aseprite).
 *
 * Supported: indexed, greyscale and RGBA sprites; raw, compressed and linked cels; layers in groups, with opacity and
 * blend modes; both kinds of palette chunk. Skipped: user data, colour profiles, external files, paths. Errors, if
 * visible: tilemaps, groups with their own opacity or blend mode, and the blend modes soft light, hue, saturation,
 * colour and luminosity.
 */
#ifndef WORKBENCH_ASE_H
#define WORKBENCH_ASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    ASE_NAME = 32, /* bytes of a name with its NUL; longer names are cut */
    ASE_MAX_SIDE = 4096,
    ASE_MAX_FRAMES = 4096,
    ASE_MAX_LAYERS = 1024,
    ASE_MAX_LIST = 4096,       /* tags, and keys of slices */
    ASE_MAX_BYTES = 128 << 20, /* of all cels, uncompressed */
    ASE_MAX_PICTURE = 1 << 24  /* pixels of a frame, or of all frames of a sprite */
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
    bool visible;    /* the layer and all its groups are visible */
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

enum ase_direction { ASE_FORWARD, ASE_REVERSE, ASE_PING_PONG, ASE_PING_PONG_REVERSE };

struct ase_tag {
    char name[ASE_NAME];
    int from, to; /* first and last frame, from 0 */
    enum ase_direction direction;
};

/* A key of a slice: its rectangle on the canvas from a frame on. */
struct ase_slice_key {
    char name[ASE_NAME];
    int slice, frame; /* slices are numbered in order */
    int32_t x, y, w, h;
    bool has_pivot;
    int32_t px, py; /* the pivot, relative to the rectangle's corner */
};

struct ase {
    int w, h, depth;       /* px; depth: bytes per pixel: 4, 2 (grey, opacity) or 1 */
    int transparent_index; /* the transparent index */
    bool blended;          /* a visible layer or cel is blended, so merged pixels have no index */
    uint8_t palette[256][4];
    int colours; /* in the file; only 256 of them are stored, because pixels cannot use more */
    struct ase_layer *layers;
    struct ase_image *images;
    struct ase_cel *cels;
    struct ase_frame *frames;
    struct ase_tag *tags;
    struct ase_slice_key *keys;
    int n_layers, n_images, n_cels, n_frames, n_tags, n_keys;
};

/* Inflates zlib data to exactly `size` bytes; out has space for one more. False: damaged data. See png_inflate. */
typedef bool ase_inflate(const uint8_t *packed, size_t n, uint8_t *out, size_t size);

/* Reads a whole file. On failure, err is one sentence without the file's name. Free it in either case. */
bool ase_read(struct ase *a, const uint8_t *data, size_t n, ase_inflate *inflate, char *err, size_t err_size);
void ase_free(struct ase *a);

/* Merges the layers of a frame (from 0) into rgba, w * h * 4 bytes. index: receives the palette indices of the topmost
 * pixels, or NULL; only for an indexed sprite that is not `blended`. */
bool ase_merge(const struct ase *a, int frame, uint8_t *rgba, uint8_t *index, char *err, size_t err_size);

/* Blends a colour over `under`; both are R G B and opacity. */
void ase_blend(enum ase_blend mode, uint8_t under[4], const uint8_t colour[4]);

#endif

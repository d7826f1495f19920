/*
 * ase.c - see ase.h: the file format. A file consists of frames, and a frame of chunks with their sizes, so unknown
 * chunks can be skipped. Reads past the end of a chunk return zeros and set `past`, which is checked once, at its end.
 */
#include "ase.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/err.h"
#include "../../common/array.h"
#include "../../common/result.h"

enum {
    FILE_MAGIC = 0xa5e0,
    FRAME_MAGIC = 0xf1fa,
    FILE_HEADER = 128,
    FRAME_HEADER = 16,
    CHUNK_HEADER = 6,
    MAX_LEVEL = 64,        /* of nested groups */
    MAX_PALETTE = 1 << 16, /* colours */
    CHUNK_PALETTE_OLD = 0x0004,
    CHUNK_PALETTE_OLDER = 0x0011, /* channels of 6 bits */
    CHUNK_LAYER = 0x2004,
    CHUNK_CEL = 0x2005,
    CHUNK_TAGS = 0x2018,
    CHUNK_PALETTE = 0x2019,
    CHUNK_SLICE = 0x2022
};

struct reader {
    const uint8_t *p;
    size_t n, at; /* bytes of the chunk, and read position */
    bool past;    /* a read was past the end */
    struct ase *a;
    ase_inflate *inflate;
    bool layer_opacity, group_opacity; /* header flags: layers, groups have a valid opacity */
    bool new_palette;
    bool group_visible[MAX_LEVEL + 1]; /* visibility of the enclosing groups, by level */
    int level;                         /* of the innermost enclosing group; -1: none */
    size_t bytes;                      /* of all images */
    int slices;
    char *err;
    size_t err_size;
};

__attribute__((format(printf, 2, 3))) static bool refuse(struct reader *r, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    vsnprintf(r->err, r->err_size, format, args);
    va_end(args);
    return false;
}

/* ---- reading ---- */

static const uint8_t *read_bytes(struct reader *r, size_t n)
{
    static const uint8_t zeros[8];

    if (n > r->n - r->at) {
        r->past = true;
        r->at = r->n;
        return zeros;
    }
    r->at += n;
    return r->p + r->at - n;
}

static void skip(struct reader *r, size_t n)
{
    if (n > r->n - r->at)
        r->past = true;
    r->at = r->past ? r->n : r->at + n;
}

static int read8(struct reader *r)
{
    return *read_bytes(r, 1);
}

static int read16(struct reader *r)
{
    return bytes_get16(read_bytes(r, 2));
}

static int read16s(struct reader *r)
{
    return (int16_t)bytes_get16(read_bytes(r, 2));
}

static uint32_t read32(struct reader *r)
{
    return bytes_get32(read_bytes(r, 4));
}

static void read_name(struct reader *r, char out[ASE_NAME])
{
    size_t n = (size_t)read16(r), length = n < ASE_NAME ? n : ASE_NAME - 1;
    const bool complete = n <= r->n - r->at;

    memset(out, 0, ASE_NAME);
    if (complete)
        memcpy(out, r->p + r->at, length);
    for (size_t i = 0; i < length; i++)
        out[i] = (unsigned char)out[i] < 32 || out[i] == 127 ? '?' : out[i];
    skip(r, n);
}

static bool fail_memory(struct reader *r)
{
    result_set_host_failed();
    return refuse(r, "out of memory");
}

/* ---- chunks ---- */

static const char *const blend_names[ASE_BLENDS] = { "normal",     "multiply",   "screen",       "overlay",
                                                     "darken",     "lighten",    "colour dodge", "colour burn",
                                                     "hard light", "soft light", "difference",   "exclusion",
                                                     "hue",        "saturation", "colour",       "luminosity",
                                                     "addition",   "subtract",   "divide" };

static bool is_supported_blend(int blend)
{
    return blend < ASE_BLENDS && blend != ASE_SOFT_LIGHT && (blend < ASE_HUE || blend > ASE_LUMINOSITY);
}

enum { LAYER_IMAGE, LAYER_GROUP, LAYER_TILEMAP };

/* Checks a visible layer. */
static bool check_layer(struct reader *r, const struct ase_layer *l, int type)
{
    if (type == LAYER_TILEMAP)
        return refuse(r, "layer \"%s\" is a tilemap: convert it to a normal layer", l->name);
    if (type == LAYER_GROUP && (l->opacity != 255 || l->blend != ASE_NORMAL))
        return refuse(r, "group \"%s\" has its own opacity or blend mode: set them on its layers", l->name);
    if (!is_supported_blend(l->blend))
        return refuse(r, "layer \"%s\": blend mode \"%s\" is not supported: merge the layer with the one below",
                      l->name, l->blend < ASE_BLENDS ? blend_names[l->blend] : "unknown");
    return true;
}

static bool read_layer(struct reader *r)
{
    enum { VISIBLE = 1, BACKGROUND = 8, REFERENCE = 64 };
    struct ase *a = r->a;
    const int flags = read16(r), type = read16(r), level = read16(r);

    if (a->n_layers == ASE_MAX_LAYERS)
        return refuse(r, "the Aseprite file has more than %d layers", ASE_MAX_LAYERS);
    if (type > LAYER_TILEMAP || level > r->level + 1 || level >= MAX_LEVEL)
        return refuse(r, "damaged Aseprite file: unknown layer type %d", a->n_layers + 1);
    struct ase_layer *l = array_append(&a->layers, (size_t)a->n_layers, sizeof *l);
    if (!l)
        return fail_memory(r);
    a->n_layers++;
    skip(r, 4);
    const int blend = read16(r), opacity = read8(r);
    skip(r, 3);
    read_name(r, l->name);
    const bool has_opacity = type == LAYER_GROUP ? r->group_opacity : r->layer_opacity;
    l->opacity = has_opacity ? (uint8_t)opacity : 255;
    l->blend = type == LAYER_GROUP && !r->group_opacity ? ASE_NORMAL : blend < 255 ? (uint8_t)blend : 255;
    l->background = flags & BACKGROUND;
    l->visible = flags & VISIBLE && !(flags & REFERENCE) && r->group_visible[level];
    r->group_visible[level + 1] = l->visible;
    r->level = type == LAYER_GROUP ? level : level - 1;
    return r->past || !l->visible || check_layer(r, l, type);
}

/* Reads the pixels of a raw or compressed cel as a new image. */
static bool read_image(struct reader *r, int layer, bool packed, int *image)
{
    struct ase *a = r->a;
    const int w = read16(r), h = read16(r), frame = a->n_frames;
    const size_t size = (size_t)w * (size_t)h * (size_t)a->depth;

    if (r->past)
        return true;
    if (w < 1 || h < 1 || size > ASE_MAX_BYTES - r->bytes)
        return refuse(r, "frame %d, layer \"%s\": a cel of %dx%d pixels is too %s", frame, a->layers[layer].name, w, h,
                      w < 1 || h < 1 ? "small" : "large");
    struct ase_image *i = array_append(&a->images, (size_t)a->n_images, sizeof *i);
    if (!i || !(i->pix = malloc(size + 1)))
        return fail_memory(r);
    *image = a->n_images++;
    r->bytes += size;
    i->w = w;
    i->h = h;
    const size_t left = r->n - r->at;
    const uint8_t *from = r->p + r->at;
    r->at = r->n;
    if (!packed && left >= size)
        memcpy(i->pix, from, size);
    else if (!packed || !r->inflate(from, left, i->pix, size))
        return refuse(r, "frame %d, layer \"%s\": damaged pixels", frame, a->layers[layer].name);
    return true;
}

/* Finds the image of the same layer in an earlier frame (from 0). */
static bool find_linked_image(struct reader *r, int layer, int frame, int *image)
{
    const struct ase *a = r->a;

    if (frame < a->n_frames - 1)
        for (int i = 0; i < a->frames[frame].cels; i++)
            if (a->cels[a->frames[frame].first_cel + i].layer == layer) {
                *image = a->cels[a->frames[frame].first_cel + i].image;
                return true;
            }
    return refuse(r, "frame %d, layer \"%s\": its cel is linked to frame %d, which has no cel in this layer",
                  a->n_frames, a->layers[layer].name, frame + 1);
}

static bool read_cel(struct reader *r)
{
    enum { RAW, LINKED, COMPRESSED, TILES };
    struct ase *a = r->a;
    struct ase_frame *f = &a->frames[a->n_frames - 1];
    struct ase_cel c = { .layer = read16(r) };

    c.x = read16s(r);
    c.y = read16s(r);
    c.opacity = (uint8_t)read8(r);
    const int type = read16(r);
    c.z = read16s(r);
    skip(r, 5);
    if (r->past)
        return true;
    if (c.layer >= a->n_layers)
        return refuse(r, "damaged Aseprite file: frame %d has a cel in layer %d, but the last layer is %d", a->n_frames,
                      c.layer + 1, a->n_layers);
    if (type == TILES)
        return true; /* in a hidden layer */
    if (type > TILES)
        return refuse(r, "frame %d, layer \"%s\": unknown cel type", a->n_frames, a->layers[c.layer].name);
    for (int i = 0; i < f->cels; i++)
        if (a->cels[f->first_cel + i].layer == c.layer)
            return refuse(r, "damaged Aseprite file: frame %d has two cels in layer \"%s\"", a->n_frames,
                          a->layers[c.layer].name);
    const bool good = type == LINKED ? find_linked_image(r, c.layer, read16(r), &c.image)
                                     : read_image(r, c.layer, type == COMPRESSED, &c.image);
    if (!good || r->past)
        return good;
    struct ase_cel *to = array_append(&a->cels, (size_t)a->n_cels, sizeof *to);
    if (!to)
        return fail_memory(r);
    *to = c;
    a->n_cels++;
    f->cels++;
    return true;
}

static bool read_tags(struct reader *r)
{
    struct ase *a = r->a;
    const int n = read16(r);

    skip(r, 8);
    for (int i = 0; i < n && !r->past; i++) {
        struct ase_tag *t = a->n_tags < ASE_MAX_LIST ? array_append(&a->tags, (size_t)a->n_tags, sizeof *t) : NULL;
        if (!t)
            return a->n_tags < ASE_MAX_LIST ? fail_memory(r)
                                            : refuse(r, "the Aseprite file has more than %d tags", ASE_MAX_LIST);
        a->n_tags++;
        t->from = read16(r);
        t->to = read16(r);
        const int direction = read8(r);
        skip(r, 12);
        read_name(r, t->name);
        t->direction = direction > ASE_PING_PONG_REVERSE ? ASE_FORWARD : (enum ase_direction)direction;
    }
    return true;
}

static bool read_palette(struct reader *r)
{
    struct ase *a = r->a;
    const uint32_t size = read32(r), first = read32(r), last = read32(r);

    skip(r, 8);
    if (r->past)
        return true;
    if (size < 1 || size > MAX_PALETTE || first > last || last >= size)
        return refuse(r, "the Aseprite file has a palette of %lu colours, expected 1 to %d", (unsigned long)size,
                      MAX_PALETTE);
    for (uint32_t i = first; i <= last && !r->past; i++) {
        const int named = read16(r) & 1;
        const uint8_t *rgba = read_bytes(r, 4);
        if (i < 256)
            memcpy(a->palette[i], rgba, 4);
        if (named)
            skip(r, (size_t)read16(r));
    }
    a->colours = (int)size;
    r->new_palette = true;
    return true;
}

/* The palette chunk of old versions consists of packets: a number of colours to skip, then colours to set. */
static bool read_old_palette(struct reader *r, bool six_bits)
{
    struct ase *a = r->a;
    const int packets = read16(r);
    int at = 0;

    for (int p = 0; p < packets && !r->past; p++) {
        at += read8(r);
        const int count = read8(r), n = count ? count : 256;
        for (int i = 0; i < n; i++, at++) {
            const uint8_t *rgb = read_bytes(r, 3);
            for (int c = 0; c < 4 && at < 256; c++)
                a->palette[at][c] = (uint8_t)(c == 3 ? 255 : six_bits ? rgb[c] % 64 * 255 / 63 : rgb[c]);
        }
        a->colours = at > a->colours ? at : a->colours;
    }
    return true;
}

static bool read_slice(struct reader *r)
{
    enum { NINE_PATCH = 1, PIVOT = 2 };
    struct ase *a = r->a;
    const uint32_t n = read32(r), flags = read32(r);
    char name[ASE_NAME];

    skip(r, 4);
    read_name(r, name);
    for (uint32_t i = 0; i < n && !r->past; i++) {
        struct ase_slice_key *k =
            a->n_keys < ASE_MAX_LIST ? array_append(&a->keys, (size_t)a->n_keys, sizeof *k) : NULL;
        if (!k)
            return a->n_keys < ASE_MAX_LIST ? fail_memory(r)
                                            : refuse(r, "the Aseprite file has more than %d slice keys", ASE_MAX_LIST);
        a->n_keys++;
        memcpy(k->name, name, sizeof name);
        k->slice = r->slices;
        k->frame = (int)(read32(r) & 0xffff);
        k->x = (int32_t)read32(r);
        k->y = (int32_t)read32(r);
        k->w = (int32_t)(read32(r) & INT32_MAX);
        k->h = (int32_t)(read32(r) & INT32_MAX);
        if (flags & NINE_PATCH)
            skip(r, 16);
        k->has_pivot = flags & PIVOT;
        k->px = k->has_pivot ? (int32_t)read32(r) : 0;
        k->py = k->has_pivot ? (int32_t)read32(r) : 0;
    }
    r->slices++;
    return true;
}

static bool read_chunk(struct reader *r, int type)
{
    const bool first = r->a->n_frames == 1; /* the sprite is read with its first palette */

    switch (type) {
    case CHUNK_LAYER:
        return read_layer(r);
    case CHUNK_CEL:
        return read_cel(r);
    case CHUNK_TAGS:
        return read_tags(r);
    case CHUNK_SLICE:
        return read_slice(r);
    case CHUNK_PALETTE:
        return !first || read_palette(r);
    case CHUNK_PALETTE_OLD:
    case CHUNK_PALETTE_OLDER:
        return !first || r->new_palette || read_old_palette(r, type == CHUNK_PALETTE_OLDER);
    default:
        return true;
    }
}

/* ---- frames ---- */

static bool fail_truncated(struct reader *r)
{
    return refuse(r, "truncated Aseprite file");
}

/* Reads the chunks of a frame, n bytes at p. */
static bool read_chunks(struct reader *r, const uint8_t *p, size_t n, uint32_t chunks)
{
    size_t at = 0;

    for (uint32_t i = 0; i < chunks; i++) {
        if (n - at < CHUNK_HEADER)
            return fail_truncated(r);
        const uint32_t size = bytes_get32(p + at);
        if (size < CHUNK_HEADER || size > n - at)
            return refuse(r, "damaged Aseprite file: chunk %lu in frame %d has the wrong size", (unsigned long)i + 1,
                          r->a->n_frames);
        r->p = p + at + CHUNK_HEADER;
        r->n = size - CHUNK_HEADER;
        r->at = 0;
        r->past = false;
        if (!read_chunk(r, bytes_get16(p + at + 4)))
            return false;
        if (r->past)
            return refuse(r, "damaged Aseprite file: chunk %lu in frame %d is too short", (unsigned long)i + 1,
                          r->a->n_frames);
        at += size;
    }
    return true;
}

static bool read_frames(struct reader *r, const uint8_t *data, size_t n, int frames)
{
    struct ase *a = r->a;
    size_t at = FILE_HEADER;

    for (int f = 0; f < frames; f++) {
        if (n - at < FRAME_HEADER)
            return fail_truncated(r);
        const uint32_t size = bytes_get32(data + at), chunks = bytes_get32(data + at + 12);
        if (bytes_get16(data + at + 4) != FRAME_MAGIC || size < FRAME_HEADER)
            return refuse(r, "damaged Aseprite file: frame %d has no header", f + 1);
        if (size > n - at)
            return fail_truncated(r);
        struct ase_frame *frame = array_append(&a->frames, (size_t)a->n_frames, sizeof *frame);
        if (!frame)
            return fail_memory(r);
        a->n_frames++;
        frame->ms = bytes_get16(data + at + 8);
        frame->first_cel = a->n_cels;
        if (!read_chunks(r, data + at + FRAME_HEADER, size - FRAME_HEADER,
                         chunks ? chunks : bytes_get16(data + at + 6)))
            return false;
        at += size;
    }
    return true;
}

static bool read_header(struct reader *r, const uint8_t *p, size_t n, int *frames)
{
    struct ase *a = r->a;
    const uint32_t flags = n >= 20 ? bytes_get32(p + 14) : 0;

    if (n < 6 || bytes_get16(p + 4) != FILE_MAGIC)
        return refuse(r, "not an Aseprite file");
    if (n < FILE_HEADER)
        return fail_truncated(r);
    *frames = bytes_get16(p + 6);
    a->w = bytes_get16(p + 8);
    a->h = bytes_get16(p + 10);
    const int bits = bytes_get16(p + 12);
    if (bits != 8 && bits != 16 && bits != 32)
        return refuse(r, "the Aseprite file has %d bits per pixel, expected 8, 16 or 32", bits);
    if (*frames < 1 || *frames > ASE_MAX_FRAMES)
        return refuse(r, "the Aseprite file has %d frames, expected 1 to %d", *frames, ASE_MAX_FRAMES);
    if (a->w < 1 || a->h < 1 || a->w > ASE_MAX_SIDE || a->h > ASE_MAX_SIDE)
        return refuse(r, "the Aseprite file has %dx%d pixels, expected 1x1 to %dx%d", a->w, a->h, ASE_MAX_SIDE,
                      ASE_MAX_SIDE);
    a->depth = bits / 8;
    a->transparent_index = a->depth == 1 ? p[28] : 0;
    r->layer_opacity = flags & 1;
    r->group_opacity = flags & 2;
    return true;
}

/* Checks the frames of tags, and finds out whether anything is blended. */
static bool check_tags(struct reader *r)
{
    struct ase *a = r->a;

    for (int i = 0; i < a->n_tags; i++)
        if (a->tags[i].from > a->tags[i].to || a->tags[i].to >= a->n_frames)
            return refuse(r, "tag \"%s\" covers frames %d to %d, but the file ends at frame %d", a->tags[i].name,
                          a->tags[i].from + 1, a->tags[i].to + 1, a->n_frames);
    for (int i = 0; i < a->n_cels; i++) {
        const struct ase_layer *l = &a->layers[a->cels[i].layer];
        a->blended =
            a->blended || (l->visible && (l->blend != ASE_NORMAL || l->opacity != 255 || a->cels[i].opacity != 255));
    }
    return true;
}

bool ase_read(struct ase *a, const uint8_t *data, size_t n, ase_inflate *inflate, char *err, size_t err_size)
{
    struct reader r = { .a = a, .inflate = inflate, .level = -1, .err = err, .err_size = err_size };
    int frames = 0;

    memset(a, 0, sizeof *a);
    r.group_visible[0] = true;
    return read_header(&r, data, n, &frames) && read_frames(&r, data, n, frames) && check_tags(&r);
}

void ase_free(struct ase *a)
{
    for (int i = 0; i < a->n_images; i++)
        free(a->images[i].pix);
    free(a->layers);
    free(a->images);
    free(a->cels);
    free(a->frames);
    free(a->tags);
    free(a->keys);
    memset(a, 0, sizeof *a);
}

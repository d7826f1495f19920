/*
 * ase_sprite.c - see ase_sprite.h.
 */
#include "ase_sprite.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../entities/motion.h"

enum { TICKS = 60, SECOND = 1000, HALF = 1 << 15 /* half a px */ };

/* ---- frames ---- */

static const struct ase_tag *find_tag(const struct ase *a, const char *name)
{
    for (int i = 0; i < a->n_tags; i++)
        if (strcmp(a->tags[i].name, name) == 0)
            return &a->tags[i];
    return NULL;
}

/* Lists the tags for a message: "fly", "sit". */
static void list_tags(const struct ase *a, char *out, size_t size)
{
    size_t n = 0;

    out[0] = '\0';
    for (int i = 0; i < a->n_tags && n + ASE_NAME + 8 < size; i++) {
        n += strlen(strcpy(out + n, i ? ", \"" : "\""));
        n += strlen(strcpy(out + n, a->tags[i].name));
        n += strlen(strcpy(out + n, "\""));
    }
}

static bool report_unknown_tag(const struct ase *a, const char *name, char *err, size_t err_size)
{
    char tags[128];

    list_tags(a, tags, sizeof tags);
    if (a->n_tags == 0)
        return err_set(err, err_size, "no tag \"%s\": the file has no tags", name);
    return err_set(err, err_size, "no tag \"%s\"; the file has %s", name, tags);
}

/* Writes the frames of a tag, from 0, in the order they are played; at most `most`. Returns how many there are. In
 * ping-pong tags, the first and the last frame are not repeated. */
static int play_order(const struct ase_tag *t, uint16_t *out, int most)
{
    const int n = t->to - t->from + 1;
    const bool ping_pong = t->direction == ASE_PING_PONG || t->direction == ASE_PING_PONG_REVERSE;
    const bool reverse = t->direction == ASE_REVERSE || t->direction == ASE_PING_PONG_REVERSE;
    const int all = ping_pong && n > 2 ? 2 * n - 2 : n;

    for (int i = 0; i < all && i < most; i++) {
        const int at = i < n ? i : 2 * n - 2 - i;
        out[i] = (uint16_t)(reverse ? t->to - at : t->from + at);
    }
    return all;
}

static int duration_ticks(const struct ase *a, int frame)
{
    const int ticks = (a->frames[frame].ms * TICKS + SECOND / 2) / SECOND;

    return ticks < 1 ? 1 : ticks;
}

static int gcd(int a, int b)
{
    while (b) {
        int remainder = a % b;
        a = b;
        b = remainder;
    }
    return a;
}

/* Repeats frames so that all have the same duration, the greatest common divisor. order: n frames, and capacity for
 * CART_MAX_FRAMES. */
static bool repeat_frames(const struct ase *a, uint16_t *order, int *n, int32_t *every, char *err, size_t err_size)
{
    uint16_t repeated[CART_MAX_FRAMES];
    int unit = 0, all = 0;

    for (int i = 0; i < *n; i++)
        unit = gcd(duration_ticks(a, order[i]), unit);
    for (int i = 0; i < *n; i++)
        for (int k = duration_ticks(a, order[i]) / unit; k > 0; k--, all++)
            if (all < CART_MAX_FRAMES)
                repeated[all] = order[i];
    if (all > CART_MAX_FRAMES)
        return err_set(err, err_size,
                       "its frames have different durations and need %d pictures, expected at most %d (set `every` in "
                       "rom.lua to give every frame the same duration)",
                       all, CART_MAX_FRAMES);
    memcpy(order, repeated, (size_t)all * sizeof *repeated);
    *n = all;
    *every = unit;
    return true;
}

static bool choose_frames(const struct ase *a, struct ase_sprite *s, char *err, size_t err_size)
{
    const struct ase_tag all = { .from = 0, .to = a->n_frames - 1 };
    const struct ase_tag *tag = s->sprite.tag[0] ? find_tag(a, s->sprite.tag) : &all;

    if (!tag)
        return report_unknown_tag(a, s->sprite.tag, err, err_size);
    int n = play_order(tag, s->frames, CART_MAX_FRAMES);
    if (n > CART_MAX_FRAMES)
        return err_set(err, err_size, "%d frames, expected at most %d (choose some with tag = \"NAME\")", n,
                       CART_MAX_FRAMES);
    if (s->sprite.frame_ticks == 0 && !repeat_frames(a, s->frames, &n, &s->sprite.frame_ticks, err, err_size))
        return false;
    s->sprite.frames = n;
    return true;
}

/* ---- pixels ---- */

/* Copies the sprite's rectangle of a canvas, `size` bytes per pixel, to the strip. */
static void copy_frame(const struct ase *a, const struct art_sprite *asked, const uint8_t *canvas, uint8_t *strip,
                       int frame, int frames, size_t size)
{
    const size_t row = (size_t)asked->w * size;

    for (int y = 0; y < asked->h; y++)
        memcpy(strip + ((size_t)y * (size_t)frames + (size_t)frame) * row,
               canvas + ((size_t)(asked->y + y) * (size_t)a->w + (size_t)asked->x) * size, row);
}

/* Fills in all frames. rgba, index: buffers for a merged frame. at: the sprite's rectangle. */
static bool fill_strip(const struct ase *a, const struct art_sprite *at, struct ase_sprite *s, uint8_t *rgba,
                       uint8_t *index, char *err, size_t err_size)
{
    const int n = s->sprite.frames;

    for (int i = 0; i < n; i++) {
        char why[160];
        if ((i == 0 || s->frames[i] != s->frames[i - 1]) &&
            !ase_merge(a, s->frames[i], rgba, s->picture.index ? index : NULL, why, sizeof why))
            return err_set(err, err_size, "frame %d: %s", s->frames[i] + 1, why);
        copy_frame(a, at, rgba, s->picture.rgba, i, n, 4);
        if (s->picture.index)
            copy_frame(a, at, index, s->picture.index, i, n, 1);
    }
    return true;
}

static bool make_strip(const struct ase *a, const struct art_sprite *at, bool by_index, struct ase_sprite *s, char *err,
                       size_t err_size)
{
    const size_t canvas = (size_t)a->w * (size_t)a->h;
    const size_t all = (size_t)at->w * (size_t)at->h * (size_t)s->sprite.frames;

    if (all > ASE_MAX_PICTURE)
        return err_set(err, err_size, "its %d frames of %dx%d pixels are too large", (int)s->sprite.frames, (int)at->w,
                       (int)at->h);
    s->picture = (struct art_picture){ .rgba = malloc(all * 4), .w = at->w * s->sprite.frames, .h = at->h };
    s->picture.index = a->depth == 1 && !a->blended ? malloc(all) : NULL;
    s->picture.by_index = by_index;
    s->picture.cell = at->w;
    uint8_t *buffer = malloc(canvas * 5);
    bool good = s->picture.rgba && buffer && (s->picture.index || a->depth != 1 || a->blended);
    if (good)
        good = fill_strip(a, at, s, buffer, buffer + canvas * 4, err, err_size);
    else
        result_set_host_error(err, err_size, "out of memory");
    free(buffer);
    if (!good)
        art_picture_free(&s->picture);
    return good;
}

static bool check_index(const struct ase *a, char *err, size_t err_size)
{
    if (a->depth != 1)
        return err_set(err, err_size, "match = \"index\" needs indexed colour; this sprite is RGB or greyscale");
    return !a->blended || err_set(err, err_size, "match = \"index\" needs opaque layers in normal mode");
}

/* ---- slices ---- */

/* Returns whether `word` is the first word of the name. */
static bool starts_with_word(const char *name, const char *word)
{
    const size_t n = strlen(word);
    const char next = strncmp(name, word, n) == 0 ? name[n] : 'x';

    return !((next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z'));
}

/* Returns the key of a slice that is in effect in the frame; NULL: the slice is not in the frame. *i is the slice's
 * first key, and is advanced past the last one. */
static const struct ase_slice_key *key_at_frame(const struct ase *a, int *i, int frame)
{
    const struct ase_slice_key *found = NULL;
    const int slice = a->keys[*i].slice;

    for (; *i < a->n_keys && a->keys[*i].slice == slice; ++*i)
        if (a->keys[*i].frame <= frame && (!found || a->keys[*i].frame >= found->frame))
            found = &a->keys[*i];
    return found && found->w > 0 && found->h > 0 ? found : NULL;
}

static bool is_near_canvas(const struct ase_slice_key *k)
{
    const int32_t most = ASE_MAX_SIDE;

    return k->x >= -most && k->x <= most && k->y >= -most && k->y <= most && k->w <= most && k->h <= most &&
           k->px >= -most && k->px <= most && k->py >= -most && k->py <= most;
}

/* Sets the origin from the first pivot of a slice, in px of the sprite. */
static void find_origin(const struct ase *a, struct ase_sprite *s, const struct art_sprite *at)
{
    s->sprite.ox = at->w / 2;
    s->sprite.oy = at->h / 2;
    for (int i = 0; i < a->n_keys;) {
        const struct ase_slice_key *k = key_at_frame(a, &i, s->frames[0]);
        if (!k || !k->has_pivot || !is_near_canvas(k))
            continue;
        s->sprite.ox = k->x + k->px - at->x;
        s->sprite.oy = k->y + k->py - at->y;
        s->sprite.has_origin = s->sprite.ox != at->w / 2 || s->sprite.oy != at->h / 2; /* otherwise the exact centre */
        return;
    }
}

/* Returns the distance of the origin from the edge in half pixels, as `pivot` in art.c. */
static int origin_half_px(int origin, int side)
{
    return origin == side / 2 ? side : 2 * origin + 1;
}

/* Converts half pixels to fx, scaled by the percentage in rom.lua. False: too large. */
static bool scale(int64_t half, int percent, int32_t *out)
{
    const int64_t to = half * HALF * percent, px = (to + (to < 0 ? -50 : 50)) / 100, most = (int64_t)MAX_SPEED << 16;

    *out = (int32_t)(px < -most ? -most : px > most ? most : px);
    return *out == px;
}

static bool add_shape(struct ase_sprite *s, const struct ase_slice_key *k, uint32_t shape, const struct art_sprite *at,
                      char *err, size_t err_size)
{
    const int64_t dx = 2 * ((int64_t)k->x - at->x) + k->w - origin_half_px(s->sprite.ox, at->w);
    const int64_t dy = 2 * ((int64_t)k->y - at->y) + k->h - origin_half_px(s->sprite.oy, at->h);
    const int32_t short_side = k->w < k->h ? k->w : k->h;
    struct cart_hitbox *h = &s->hit;
    const uint32_t i = h->rows;

    if (i > 0 && (shape != SHAPE_CIRCLES || h->shape != SHAPE_CIRCLES))
        return err_set(err, err_size, "slice \"%s\": too many shapes: expected one box, one capsule, or circles",
                       k->name);
    if (i == SHAPE_MAX_CIRCLES)
        return err_set(err, err_size, "more than %d slices named \"hit\"", SHAPE_MAX_CIRCLES);
    if (shape != SHAPE_CIRCLES && (dx < -1 || dx > 1 || dy < -1 || dy > 1))
        return err_set(err, err_size,
                       "slice \"%s\": its centre is %g,%g px from the origin; a %s must be centred on the origin (for "
                       "a hitbox elsewhere, use circles: slices named \"hit\")",
                       k->name, (double)dx / 2, (double)dy / 2, shape == SHAPE_BOX ? "box" : "capsule");
    h->shape = shape;
    h->rows = i + 1;
    const int percent = s->sprite.scale_percent;
    bool good = scale(shape == SHAPE_BOX ? k->w : short_side, percent, &h->row[i].a);
    if (shape == SHAPE_BOX)
        good = scale(k->h, percent, &h->row[i].b) && good;
    else
        good = scale(shape == SHAPE_CIRCLES ? dx : k->w - short_side, percent, &h->row[i].x) &&
               scale(shape == SHAPE_CIRCLES ? dy : k->h - short_side, percent, &h->row[i].y) && good;
    return good || err_set(err, err_size, "slice \"%s\" is far outside the picture", k->name);
}

static bool find_hitbox(const struct ase *a, struct ase_sprite *s, const struct art_sprite *at, char *err,
                        size_t err_size)
{
    static const struct {
        const char *word;
        uint32_t shape;
    } slices[] = { { "hit", SHAPE_CIRCLES }, { "box", SHAPE_BOX }, { "capsule", SHAPE_CAPSULE } };

    for (int i = 0; i < a->n_keys;) {
        const struct ase_slice_key *k = key_at_frame(a, &i, s->frames[0]);
        for (int w = 0; k && w < 3; w++)
            if (starts_with_word(k->name, slices[w].word) && !add_shape(s, k, slices[w].shape, at, err, err_size))
                return false;
    }
    if (s->hit.rows == 1 && s->hit.shape == SHAPE_CIRCLES && s->hit.row[0].x == 0 && s->hit.row[0].y == 0)
        s->hit.shape = SHAPE_CIRCLE;
    return true;
}

bool ase_make_sprite(const struct ase *a, const struct art_sprite *asked, bool by_index, struct ase_sprite *out,
                     char *err, size_t err_size)
{
    struct art_sprite at = *asked;

    memset(out, 0, sizeof *out);
    out->sprite = *asked;
    at.w = asked->w ? asked->w : a->w - asked->x;
    at.h = asked->h ? asked->h : a->h - asked->y;
    at.w = at.w < 1 ? 1 : at.w; /* so that the next check reports an origin outside the canvas */
    at.h = at.h < 1 ? 1 : at.h;
    if (at.x + at.w > a->w || at.y + at.h > a->h)
        return err_set(err, err_size, "%dx%d at %d,%d is outside the canvas of %dx%d pixels", (int)at.w, (int)at.h,
                       (int)at.x, (int)at.y, a->w, a->h);
    if (at.w > CART_MAX_SIDE || at.h > CART_MAX_SIDE)
        return err_set(err, err_size, "%dx%d pixels, expected at most %d in each direction (x, y, w, h choose a part)",
                       (int)at.w, (int)at.h, CART_MAX_SIDE);
    if ((by_index && !check_index(a, err, err_size)) || !choose_frames(a, out, err, err_size))
        return false;
    if (!asked->has_origin)
        find_origin(a, out, &at);
    if (!find_hitbox(a, out, &at, err, err_size) || !make_strip(a, &at, by_index, out, err, err_size))
        return false;
    for (int i = 0; i < out->sprite.frames; i++)
        out->frames[i]++; /* counted from 1 in messages */
    out->picture.frames = out->frames;
    out->sprite.x = out->sprite.y = 0;
    out->sprite.w = at.w;
    out->sprite.h = at.h;
    return true;
}

/*
 * scene.c - see scene.h. The ROM is taken apart and written anew with another manifest and other pictures, so that what
 * runs is a ROM like any other.
 */
#include "scene.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../src/base/bytes.h"
#include "../../../src/rom/cart.h"
#include "../../../src/workbench/bulletml/compile.h"

enum { ROTATIONS = 16, RAM_ALIGN = 64 };

/* Shuffles n pixels: Fisher and Yates. */
static void shuffle(uint8_t *pix, int n, struct rng *r)
{
    for (int i = n - 1; i > 0; i--) {
        int k = (int)(rng_next(r) % (uint64_t)(i + 1));
        uint8_t p = pix[i];
        pix[i] = pix[k];
        pix[k] = p;
    }
}

/* A lump of ROTATIONS pictures of side x side px. Three quarters and a bit of each are opaque, as of a disc. */
static uint8_t *large_picture(int side, uint32_t *size, struct rng *r)
{
    int pitch = (side + 7) / 8 * 8, n = side * side, opaque = n * 13 / 16;
    uint8_t *out = calloc(1, *size = (uint32_t)(CART_GFX_HEADER_SIZE + ROTATIONS * pitch * side));
    uint8_t *pix = malloc((size_t)n);

    if (out && pix) {
        const int head[] = { side, side, pitch, side / 2, side / 2, 1, 1, ROTATIONS, 0 };
        for (int i = 0; i < (int)(sizeof head / sizeof *head); i++)
            bytes_put16(out + 2 * i, (uint16_t)head[i]);
        for (int k = 0; k < ROTATIONS; k++) {
            for (int i = 0; i < n; i++)
                pix[i] = (uint8_t)(i < opaque ? 1 + i % 15 : 0);
            shuffle(pix, n, r);
            for (int y = 0; y < side; y++)
                memcpy(out + CART_GFX_HEADER_SIZE + (k * side + y) * pitch, pix + y * side, (size_t)side);
        }
    }
    free(pix);
    return out;
}

/* The lump's own pixels in another order; all 8 x 8 of them stand in a row, for the pitch is 8. */
static uint8_t *shuffled_picture(const struct lump *l, struct rng *r)
{
    uint8_t *out = malloc(l->size);

    if (out) {
        memcpy(out, l->data, l->size);
        shuffle(out + CART_GFX_HEADER_SIZE, (int)l->size - CART_GFX_HEADER_SIZE, r);
    }
    return out;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const struct lump *)a)->name, ((const struct lump *)b)->name);
}

/* Compiles a document; *out is malloc's. */
static bool compile(const char *xml, uint8_t **out, uint32_t *size, char *err, size_t err_size)
{
    struct document d;
    size_t n = 0;
    const bool fine = document_read(&d, xml, strlen(xml), "doc.xml", NULL, NULL, err, err_size) &&
                      bulletml_compile(&d, "doc.xml", out, &n, err, err_size);

    document_free(&d);
    *size = (uint32_t)n;
    return fine;
}

/* The ROM with `bullets` as its capacity and pictures of its own. */
static bool remake(struct rom_image *image, const struct rom *rom, const struct scene_want *want, char *err,
                   size_t err_size)
{
    const uint32_t most = rom->count + 1;
    struct lump *lumps = calloc(most, sizeof *lumps);
    uint8_t **made = calloc(most, sizeof *made), manifest[MANIFEST_BYTES];
    struct cart cart;
    struct rng r;
    bool fine = lumps && made && cart_open(&cart, rom, err, err_size);

    rng_seed(&r, want->seed);
    for (uint32_t i = 0; fine && i < rom->count; i++) {
        struct lump *l = &lumps[i];
        rom_lump(rom, (int)i, l);
        bool kind = !strncmp(l->name, "gfx/kind", 8);
        if (!strcmp(l->name, "manifest")) {
            cart.manifest.bullets = want->bullets ? want->bullets : cart.manifest.bullets;
            cart.manifest.sparks = want->sparks;
            cart.manifest.has_backgrounds = want->scenery;
            cart.manifest.has_hp = cart.manifest.has_orbit = cart.manifest.has_freeze = cart.manifest.bullet_values =
                want->groups;
            if (want->manifest)
                want->manifest(&cart.manifest);
            l->size = manifest_pack(&cart.manifest, manifest);
            l->data = manifest;
        } else if (want->script && !strcmp(l->name, "script/main.lua")) {
            l->data = (const uint8_t *)want->script;
            l->size = (uint32_t)strlen(want->script);
        } else if (kind) {
            bool large = want->side && !strcmp(l->name, "gfx/kind1");
            l->data = made[i] = large ? large_picture(want->side, &l->size, &r) : shuffled_picture(l, &r);
            fine = made[i];
        }
    }
    uint32_t n = rom->count;
    if (fine && want->document) {
        lumps[n].name = "bulletml/doc";
        fine = compile(want->document, &made[n], &lumps[n].size, err, err_size);
        lumps[n].data = made[n];
        n++;
        qsort(lumps, n, sizeof *lumps, by_name);
    }
    image->size = fine ? rom_write_size(lumps, (int)n) : 0;
    image->bytes = fine ? malloc(image->size) : NULL;
    if (image->bytes) {
        rom_write(image->bytes, lumps, (int)n);
        fine = rom_open(&image->rom, image->bytes, image->size, err, err_size);
    }
    for (uint32_t i = 0; made && i < most; i++)
        free(made[i]);
    free(made);
    free(lumps);
    return fine && image->bytes;
}

/* The number of a DIP's named value; -1: it has no such value. */
static int value_of(const struct dip *d, const char *name)
{
    for (int i = 0; i < d->n_values; i++)
        if (!strcmp(d->value_name[i], name))
            return i;
    return -1;
}

/* The DIP that has that value: `name`, or another whose name goes on from it; `name` if none has. -1: there is none. */
static int dip_with(const struct manifest *m, const char *name, const char *value)
{
    int first = -1;

    for (int i = 0; i < m->n_dips; i++) {
        if (strncmp(m->dips[i].name, name, strlen(name)))
            continue;
        if (value_of(&m->dips[i], value) >= 0)
            return i;
        first = first < 0 ? i : first;
    }
    return first;
}

static void set_dips(struct board_start *start, const struct manifest *m, const struct scene_want *want)
{
    const char *const names[] = { "does", "price", "picture" };
    const char *const values[] = { want->does, want->price, want->picture };

    for (int i = 0; i < m->n_dips; i++)
        start->dip[i] = !strcmp(m->dips[i].name, "n")        ? want->n % 65536
                        : !strcmp(m->dips[i].name, "n_high") ? want->n / 65536
                                                             : m->dips[i].default_value;
    for (int k = 0; k < 3; k++) {
        int i = values[k] ? dip_with(m, names[k], values[k]) : -1;
        if (i >= 0)
            start->dip[i] = value_of(&m->dips[i], values[k]);
    }
}

static bool power(struct scene *s, const struct scene_want *want, char *err, size_t err_size)
{
    struct board_start start = { .seed = want->seed, .difficulty = -1 };
    struct cart cart;
    int w, h;

    if (!cart_open(&cart, &s->image.rom, err, err_size) || !board_size(&s->image.rom, &s->ram_size, err, err_size))
        return false;
    set_dips(&start, &cart.manifest, want);
    s->ram = aligned_alloc(RAM_ALIGN, (s->ram_size + RAM_ALIGN - 1) / RAM_ALIGN * RAM_ALIGN);
    if (!s->ram)
        return false;
    s->b = board_power_on(s->ram, s->ram_size, &s->image.rom, &start, err, err_size);
    if (!s->b)
        return false;
    if (board_last_output(s->b)->fault) {
        snprintf(err, err_size, "%s", board_last_output(s->b)->fault->message);
        return false;
    }
    board_screen_size(s->b, &w, &h);
    s->mem = aligned_alloc(64, (fb_size(w, h) + 63) / 64 * 64); /* its offset in a cache line changes draw times */
    s->scratch = malloc(board_scratch_size(s->b));
    if (!s->mem || !s->scratch)
        return false;
    fb_init(&s->fb, s->mem, w, h);
    return true;
}

bool scene_power(struct scene *s, const struct rom *rom, const struct scene_want *want, char *err, size_t err_size)
{
    *s = (struct scene){ 0 };
    snprintf(err, err_size, "out of memory");
    return remake(&s->image, rom, want, err, err_size) && power(s, want, err, err_size);
}

bool scene_open(struct scene *s, const struct rom *rom, const struct scene_want *want, char *err, size_t err_size)
{
    if (!scene_power(s, rom, want, err, err_size))
        return false;
    if (scene_tick(s))
        return true;
    snprintf(err, err_size, "%s", board_last_output(s->b)->fault->message);
    return false;
}

void scene_close(struct scene *s)
{
    free(s->scratch);
    free(s->mem);
    free(s->ram);
    rom_image_free(&s->image);
}

bool scene_tick(struct scene *s)
{
    static const uint16_t way[] = { PAD_LEFT, PAD_UP, PAD_RIGHT, PAD_RIGHT | PAD_DOWN, PAD_UP | PAD_LEFT, PAD_DOWN };
    uint32_t f = board_frame(s->b);
    const uint16_t pads[MAX_PLAYERS] = { (uint16_t)(way[f / 37 % 6] | (f / 500 & 1 ? PAD_FOCUS : 0)), 0 };

    return !board_tick(s->b, pads)->fault;
}

void scene_draw(struct scene *s)
{
    s->drawn = board_draw(s->b, NULL, &s->fb, s->rgb, s->scratch);
}

size_t scene_ram(const struct rom *rom, int bullets)
{
    const struct scene_want want = { .bullets = bullets };
    struct rom_image image = { 0 };
    size_t size = 0;
    char err[256];

    if (remake(&image, rom, &want, err, sizeof err))
        board_size(&image.rom, &size, err, sizeof err);
    rom_image_free(&image);
    return size;
}

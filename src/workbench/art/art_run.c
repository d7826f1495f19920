/*
 * art_run.c - see art_run.h: `curtain art`. The hit shapes are those of the kinds that the scripts declare at power-on.
 * If a script faults, only the hit shapes are missing.
 */
#include "art_run.h"

#include <stdlib.h>
#include <string.h>
#include "../../board/board.h"
#include "../../entities/motion.h"
#include "../../common/files.h"
#include "../../common/report.h"
#include "../pack/pack.h"
#include "../../player/picture/png.h"
#include "../../player/run/guard.h"
#include "atlas.h"

struct art_game {
    struct rom_image image;
    struct cart cart;
    struct guard guard;
    bool powered;
    struct atlas_shapes shapes;
};

/* ---- hit shapes ---- */

static bool has_shape(const struct atlas_shapes *shapes, const char *sprite)
{
    for (int i = 0; i < shapes->n; i++)
        if (strcmp(shapes->list[i].sprite, sprite) == 0)
            return true;
    return false;
}

/* Converts a hitbox that was drawn with its sprite and is used by no kind. */
static struct inspect_kind_shape drawn_shape(const struct cart_hitbox *h, const char *sprite)
{
    struct inspect_kind_shape s = {
        .entity = "drawn", .name = "hit", .sprite = sprite, .scale = SCALE_ONE, .r = h->row[0].a
    };

    s.shape = h->shape == SHAPE_BOX       ? INSPECT_BOX
              : h->shape == SHAPE_CAPSULE ? INSPECT_CAPSULE
              : h->shape == SHAPE_CIRCLES ? INSPECT_CIRCLES
                                          : INSPECT_CIRCLE;
    s.x1 = h->row[0].a;
    s.y1 = h->row[0].b;
    s.bar_x = h->row[0].x;
    s.bar_y = h->row[0].y;
    s.n = (int)h->rows;
    for (uint32_t i = 0; i < h->rows; i++) {
        s.circle[i].x = h->row[i].x;
        s.circle[i].y = h->row[i].y;
        s.circle[i].r = h->row[i].a;
    }
    return s;
}

static void add_drawn_shapes(struct art_game *g)
{
    for (int i = 0; i < g->cart.count[CART_SPRITES]; i++) {
        const char *name = cart_name(&g->cart, CART_SPRITES, i);
        struct cart_hitbox hit;
        if (!cart_find_hitbox(&g->cart, name, &hit) || has_shape(&g->shapes, name))
            continue;
        const struct inspect_kind_shape shape = drawn_shape(&hit, name);
        atlas_shapes_add(&g->shapes, &shape);
    }
}

/* Powers on the game to find its kinds. */
static enum result find_shapes(struct art_game *g, const char *path)
{
    struct board_start start = { .difficulty = -1 };
    enum result result = RESULT_DONE;
    char err[512];

    for (int i = 0; i < g->cart.manifest.n_dips; i++)
        start.dip[i] = g->cart.manifest.dips[i].default_value;
    g->powered = guard_power(&g->guard, &g->image.rom, &start, err, sizeof err);
    if (!g->powered)
        return report_line(RESULT_REFUSED, "%s: %s", path, err);
    const struct board_fault *fault = board_last_output(g->guard.board)->fault;
    if (fault)
        result =
            report_line(RESULT_REFUSED, "hitboxes are missing because the scripts failed to load: %s", fault->message);
    else
        inspect_kinds(g->guard.board, atlas_shapes_add, &g->shapes);
    add_drawn_shapes(g);
    return g->shapes.failed ? report_line(RESULT_HOST_FAILED, "out of memory") : result;
}

/* ---- the list ---- */

static void print_shapes(const struct art_game *g, const char *sprite)
{
    char words[128];

    for (int i = 0; i < g->shapes.n; i++) {
        if (strcmp(g->shapes.list[i].sprite, sprite) != 0)
            continue;
        atlas_shape_describe(&g->shapes.list[i], words, sizeof words);
        report_print("; %s", words);
    }
}

static void print_sprites(const struct art_game *g)
{
    for (int i = 0; i < g->cart.count[CART_SPRITES]; i++) {
        struct sprite s;
        cart_sprite(&g->cart, i, &s);
        report_print("%s: %dx%d, bank %d, origin %d,%d", cart_name(&g->cart, CART_SPRITES, i), s.w, s.h, s.bank, s.ox,
                     s.oy);
        if (s.frames > 1)
            report_print(", %d frames, every = %d", s.frames, s.frame_ticks);
        if (s.rotations > 1)
            report_print(", %d rotations", s.rotations);
        print_shapes(g, cart_name(&g->cart, CART_SPRITES, i));
        report_print("\n");
    }
}

/* ---- the picture ---- */

static enum result write_atlas(const struct art_game *g, const char *file)
{
    uint8_t *rgb, *png = NULL;
    size_t size = 0;
    int w, h;

    if (g->cart.count[CART_SPRITES] == 0)
        return report_line(RESULT_REFUSED, "--atlas: this game has no sprites");
    const bool made = atlas_make(&g->cart, &g->shapes, &rgb, &w, &h);
    if (!made && h > PNG_MAX_SIDE)
        return report_line(RESULT_REFUSED, "--atlas: %d x %d pixels is too large for a PNG", w, h);
    if (made)
        png_write_rgb(rgb, w, h, &png, &size);
    free(rgb);
    return report_save_png(file, png, size);
}

enum result art_run(const char *path, bool nearest, const char *atlas)
{
    struct art_game g = { 0 };
    char err[1024];

    if (!pack_load_game(path, nearest, &g.image, err, sizeof err))
        return report_error(err);
    enum result result = RESULT_REFUSED;
    if (!cart_open(&g.cart, &g.image.rom, err, sizeof err))
        report_line(result, "%s: %s", path, err);
    else {
        result = find_shapes(&g, path);
        enum result output = RESULT_DONE;
        if (g.powered && atlas)
            output = write_atlas(&g, atlas);
        else if (g.powered)
            print_sprites(&g);
        result = output > result ? output : result;
    }
    atlas_shapes_free(&g.shapes);
    if (g.powered)
        guard_close(&g.guard);
    rom_image_free(&g.image);
    return report_stdout(result);
}

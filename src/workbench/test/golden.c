/*
 * golden.c - see golden.h.
 */
#include "golden.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../common/files.h"
#include "../../player/picture/png.h"
#include "outcome.h"

/* ---- files ---- */

static bool make_path(const struct golden *g, char path[FILES_PATH_SIZE], const char *folder, const char *name,
                      const char *ending)
{
    return snprintf(path, FILES_PATH_SIZE, "%s/%s/%s%s", g->dir, folder, name, ending) < FILES_PATH_SIZE;
}

static bool save(const struct golden *g, const char *folder, const char *name, const char *ending, const void *bytes,
                 size_t n)
{
    char path[FILES_PATH_SIZE], err[FILES_ERR_SIZE];

    if (bytes && make_path(g, path, folder, name, ending) && files_save(path, bytes, n, err, sizeof err))
        return true;
    outcome_write(g->out, LINE_HOST_ERROR, "%s", bytes ? err : "out of memory");
    return false;
}

/* ---- pictures ---- */

struct picture {
    uint8_t *rgb; /* 3 bytes per pixel; NULL: none */
    uint8_t *pix; /* palette indices; NULL: the picture was read from a file */
    int w, h;
    uint32_t colours[256];
};

static void free_picture(struct picture *p)
{
    free(p->rgb);
    free(p->pix);
}

static void colour(struct picture *p)
{
    uint8_t *to = p->rgb;

    for (size_t i = 0, pixels = (size_t)p->w * (size_t)p->h; i < pixels; i++) {
        const uint32_t c = p->colours[p->pix[i]];
        *to++ = (uint8_t)(c >> 16);
        *to++ = (uint8_t)(c >> 8);
        *to++ = (uint8_t)c;
    }
}

static bool draw(const struct board *b, struct picture *p)
{
    struct fb fb;

    board_screen_size(b, &p->w, &p->h);
    void *memory = malloc(fb_size(p->w, p->h)), *scratch = malloc(board_scratch_size(b) + 1);
    p->rgb = malloc((size_t)p->w * (size_t)p->h * 3);
    p->pix = malloc((size_t)p->w * (size_t)p->h);
    const bool good = memory && scratch && p->rgb && p->pix;
    if (good) {
        fb_init(&fb, memory, p->w, p->h);
        board_draw(b, NULL, &fb, p->colours, scratch);
        for (int y = 0; y < p->h; y++)
            memcpy(p->pix + (size_t)y * (size_t)p->w, fb.pix + (ptrdiff_t)y * fb.pitch, (size_t)p->w);
        colour(p);
    }
    free(memory);
    free(scratch);
    return good;
}

static bool save_picture(const struct golden *g, const char *folder, const char *name, const char *ending,
                         const struct picture *p)
{
    uint8_t *png = NULL;
    size_t n = 0;

    if (p->pix)
        png_write(p->pix, p->w, p->w, p->h, p->colours, &png, &n);
    else
        png_write_rgb(p->rgb, p->w, p->h, &png, &n);
    const bool good = save(g, folder, name, ending, png, n);
    free(png);
    return good;
}

/* Reads the picture in tests/golden. */
static bool read_golden(const char *path, const char *shown, struct picture *p, char *err, size_t err_size)
{
    char why[FILES_ERR_SIZE];
    uint8_t *data, *rgba = NULL;
    size_t n;

    if (!files_read(path, shown, PNG_MAX_BYTES, &data, &n, err, err_size))
        return false;
    const bool good = png_read(data, n, &rgba, &p->w, &p->h, why, sizeof why);
    free(data);
    if (!good)
        return err_set(err, err_size, "%s: %s", shown, why);
    for (size_t i = 0, pixels = (size_t)p->w * (size_t)p->h; i < pixels; i++)
        memmove(rgba + 3 * i, rgba + 4 * i, 3);
    p->rgb = rgba;
    return true;
}

/* Compares two pictures of the same size. Counts the pixels that differ, and finds the rectangle around them. */
struct difference {
    int64_t pixels;
    int x0, y0, x1, y1;
};

static struct difference find_difference(const struct picture *a, const struct picture *b)
{
    struct difference d = { 0, a->w, a->h, -1, -1 };

    for (int y = 0; y < a->h; y++)
        for (int x = 0; x < a->w; x++) {
            const size_t i = ((size_t)y * (size_t)a->w + (size_t)x) * 3;
            if (memcmp(a->rgb + i, b->rgb + i, 3) == 0)
                continue;
            d.pixels++;
            d.x0 = x < d.x0 ? x : d.x0;
            d.y0 = y < d.y0 ? y : d.y0;
            d.x1 = x > d.x1 ? x : d.x1;
            d.y1 = y > d.y1 ? y : d.y1;
        }
    return d;
}

/* Draws the expected picture in dark grey, and the pixels that differ in red: the larger the difference, the darker. */
static bool draw_difference(const struct picture *a, const struct picture *b, struct picture *to)
{
    const size_t pixels = (size_t)a->w * (size_t)a->h;

    *to = (struct picture){ .rgb = malloc(pixels * 3), .w = a->w, .h = a->h };
    for (size_t i = 0; to->rgb && i < pixels; i++) {
        const uint8_t *p = a->rgb + 3 * i, *q = b->rgb + 3 * i;
        const int far = abs(p[0] - q[0]) + abs(p[1] - q[1]) + abs(p[2] - q[2]);
        const uint8_t grey = (uint8_t)(16 + (p[0] * 2 + p[1] * 5 + p[2]) / 24);
        uint8_t *out = to->rgb + 3 * i;
        out[0] = far ? 255 : grey;
        out[1] = far ? (uint8_t)(160 - far * 140 / 765) : grey;
        out[2] = far ? 64 : grey;
    }
    return to->rgb != NULL;
}

/* Sets the error, and writes the pictures to tests/failed. */
static bool report_difference(const struct golden *g, const char *name, const struct picture *want,
                              const struct picture *got, char *err, size_t err_size)
{
    struct picture both = { 0 };

    save_picture(g, FAILED, name, ".expected.png", want);
    save_picture(g, FAILED, name, ".got.png", got);
    if (want->w != got->w || want->h != got->h)
        return err_set(err, err_size, "the picture is %d x %d, but " GOLDEN "/%s.png is %d x %d", got->w, got->h, name,
                       want->w, want->h);
    const struct difference d = find_difference(want, got);
    if (draw_difference(want, got, &both))
        save_picture(g, FAILED, name, ".difference.png", &both);
    free_picture(&both);
    return err_set(err, err_size, "%" PRId64 " of %d pixels differ from " GOLDEN "/%s.png, from %d,%d to %d,%d",
                   d.pixels, want->w * want->h, name, d.x0, d.y0, d.x1, d.y1);
}

static bool same_picture(const struct picture *a, const struct picture *b)
{
    return a->w == b->w && a->h == b->h && memcmp(a->rgb, b->rgb, (size_t)a->w * (size_t)a->h * 3) == 0;
}

/* Saves the picture to tests/golden. Always returns true: then nothing differs; a failure to write is reported. */
static bool update_picture(const struct golden *g, const char *name, const struct picture *got)
{
    if (save_picture(g, GOLDEN, name, ".png", got))
        outcome_write(g->out, LINE_UPDATED, GOLDEN "/%s.png", name);
    return true;
}

static bool compare_picture(const struct golden *g, const char *name, const struct picture *got, char *err,
                            size_t err_size)
{
    char path[FILES_PATH_SIZE], shown[128];
    struct picture want = { 0 };

    if (!make_path(g, path, GOLDEN, name, ".png"))
        return err_set(err, err_size, "path too long");
    snprintf(shown, sizeof shown, GOLDEN "/%s.png", name);
    outcome_write(g->out, LINE_GOLDEN, "%s", shown);
    if (plat_file_size(path) < 0) {
        if (g->update)
            return update_picture(g, name, got);
        save_picture(g, FAILED, name, ".got.png", got);
        return err_set(err, err_size, "no %s yet: check " FAILED "/%s.got.png, then run with --update to save it",
                       shown, name);
    }
    if (!read_golden(path, shown, &want, err, err_size))
        return g->update && update_picture(g, name, got);
    bool same = same_picture(&want, got);
    if (!same)
        same = g->update ? update_picture(g, name, got) : report_difference(g, name, &want, got, err, err_size);
    free_picture(&want);
    return same;
}

bool golden_picture(const struct golden *g, const struct board *b, const char *name, char *err, size_t err_size)
{
    struct picture got = { 0 };
    const bool same = draw(b, &got) ? compare_picture(g, name, &got, err, err_size)
                                    : result_set_host_error(err, err_size, "out of memory");

    free_picture(&got);
    return same;
}

void golden_save_got(const struct golden *g, const struct board *b, const char *name)
{
    struct picture got = { 0 };

    if (draw(b, &got))
        save_picture(g, FAILED, name, ".got.png", &got);
    free_picture(&got);
}

/* ---- hashes ---- */

enum { HASH_FILE = 1 << 16 };

/* Writes a line for each part of the board that this game has. */
static size_t write_hashes(const struct board *b, char *text, size_t size)
{
    size_t n = 0;

    for (int i = 0; i < board_part_count(b); i++) {
        const uint64_t hash = board_part_hash(b, i);
        if (hash)
            n += (size_t)snprintf(text + n, size - n, "%s %016" PRIx64 "\n", board_part_name(b, i), hash);
    }
    return n;
}

/* Returns the hash of a part in these lines, or 0. */
static uint64_t find_hash(const char *text, const char *part)
{
    const size_t n = strlen(part);

    for (const char *line = text; *line; line += strcspn(line, "\n"), line += *line == '\n')
        if (strncmp(line, part, n) == 0 && line[n] == ' ')
            return strtoull(line + n + 1, NULL, 16);
    return 0;
}

static bool compare_hashes(const struct board *b, const char *shown, const char *golden, char *err, size_t err_size)
{
    char list[MAX_PARTS * 18] = "";
    size_t n = 0;
    int parts = 0;

    for (int i = 0; i < board_part_count(b); i++) {
        if (find_hash(golden, board_part_name(b, i)) == board_part_hash(b, i))
            continue;
        n += (size_t)snprintf(list + n, sizeof list - n, "%s%s", n ? ", " : "", board_part_name(b, i));
        parts++;
    }
    if (!parts)
        return true;
    return err_set(err, err_size, "%s %s from %s", list, parts > 1 ? "differ" : "differs", shown);
}

bool golden_hash(const struct golden *g, const struct board *b, const char *name, char *err, size_t err_size)
{
    char path[FILES_PATH_SIZE], shown[128], now[MAX_PARTS * 40] = "";
    uint8_t *golden;
    size_t size;

    if (!make_path(g, path, GOLDEN, name, ".hash"))
        return err_set(err, err_size, "path too long");
    snprintf(shown, sizeof shown, GOLDEN "/%s.hash", name);
    outcome_write(g->out, LINE_GOLDEN, "%s", shown);
    const size_t n = write_hashes(b, now, sizeof now);
    const bool there = plat_file_size(path) >= 0;
    if (!there && !g->update)
        return err_set(err, err_size, "no %s yet: run with --update to save the hashes of this frame", shown);
    bool same = false;
    if (there) {
        if (!files_read_text(path, shown, HASH_FILE, &golden, &size, err, err_size))
            return false;
        same = compare_hashes(b, shown, (const char *)golden, err, err_size);
        free(golden);
    }
    if (!same && g->update) {
        if (save(g, GOLDEN, name, ".hash", now, n))
            outcome_write(g->out, LINE_UPDATED, "%s", shown);
        same = true;
    }
    return same;
}

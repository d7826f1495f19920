/*
 * sheet.c - 64 of the documents on one picture: each in the frame in which most of its bullets are in the field, at
 * half the size, with its name under it.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../fb/text.h"
#include "../../../src/board/board.h"
#include "../../../src/machine/machine.h"
#include "../../../src/player/picture/png.h"
#include "board.h"
#include "tool.h"

enum {
    ACROSS = 8,
    DOWN = 8,
    CELLS = ACROSS * DOWN,
    FRAMES = 600,
    CELL_W = 160,
    CELL_H = 120,
    LINE = 9,
    LABEL_LINES = 3,
    LABEL_CHARS = CELL_W / TEXT_SIDE - 1,
    STEP_W = CELL_W + 4,
    STEP_H = CELL_H + LABEL_LINES * LINE + 5,
    WIDTH = ACROSS * STEP_W,
    HEIGHT = DOWN * STEP_H,
    WHITE_BANK = 0,
    RAM_ALIGN = 64
};

/* A document's best frame. */
struct best {
    int document, frame, bullets;
};

static int in_field(const struct board *b)
{
    const fx w = fx_int(2 * CELL_W), h = fx_int(2 * CELL_H);
    int n = 0;

    for (uint32_t i = 0; i < b->bullets.s.top; i++)
        n += (b->bullets.s.live_bits[i / SLOTS_BLOCK] >> i % SLOTS_BLOCK & 1) && b->bullets.x[i] > 0 &&
             b->bullets.x[i] < w && b->bullets.y[i] > 0 && b->bullets.y[i] < h;
    return n;
}

static bool open_game(struct board_game *g, const char *path)
{
    const struct side_setup setup = { path, 1, TOOL_SEED, true };
    char err[SIDE_ERROR];

    if (board_game_open(g, "game", &setup, 1, err, sizeof err))
        return true;
    fprintf(stderr, "bulletml: %s: %s\n", path, err);
    return false;
}

static bool find_best(const char *path, struct best *out)
{
    struct board_game g;
    char err[SIDE_ERROR];

    if (!open_game(&g, path))
        return false;
    for (int f = 0; f < FRAMES && board_game_tick(&g, side_player_x(f), side_player_y(f), err, sizeof err); f++) {
        const int n = in_field(g.b);
        if (n > out->bullets) {
            out->bullets = n;
            out->frame = f;
        }
    }
    board_game_close(&g);
    return true;
}

/* ---- the picture ---- */

static int brightness(uint32_t rgb)
{
    return (int)((rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255));
}

/* The picture at half the size: of four pixels the brightest. */
static void put_half(struct fb *sheet, int x, int y, const struct fb *from, const uint32_t rgb[256])
{
    for (int j = 0; j < CELL_H; j++)
        for (int i = 0; i < CELL_W; i++) {
            uint8_t most = 0;
            for (int k = 0; k < 4; k++) {
                const uint8_t c = from->pix[(2 * j + k / 2) * from->pitch + 2 * i + k % 2];
                most = brightness(rgb[c]) > brightness(rgb[most]) ? c : most;
            }
            sheet->pix[(y + j) * sheet->pitch + x + i] = most;
        }
}

/* The name in up to three lines, cut where it is longer. */
static void put_label(struct fb *sheet, int x, int y, const struct board *b, const char *name)
{
    const struct font font = { b->cart.glyphs, CART_FIRST_CHAR, b->cart.n_glyphs };
    const char *file = strrchr(name, '/');
    char line[LABEL_CHARS + 1];

    snprintf(line, sizeof line, "%.*s", (int)(file - name), name);
    text_draw(sheet, &font, x, y, line, WHITE_BANK);
    for (file++; *file && (y += LINE); file += strlen(line)) {
        snprintf(line, sizeof line, "%s", file);
        text_draw(sheet, &font, x, y, line, WHITE_BANK);
    }
}

static bool put_cell(struct fb *sheet, int cell, const char *path, int frame, uint32_t rgb[256])
{
    const int x = cell % ACROSS * STEP_W, y = cell / ACROSS * STEP_H;
    struct board_game g;
    struct fb fb;
    char err[SIDE_ERROR];

    if (!open_game(&g, path))
        return false;
    void *pix = malloc(fb_size(2 * CELL_W, 2 * CELL_H));
    const size_t room = (board_scratch_size(g.b) + RAM_ALIGN) / RAM_ALIGN * RAM_ALIGN;
    void *scratch = aligned_alloc(RAM_ALIGN, room);
    for (int f = 0; f <= frame; f++)
        board_game_tick(&g, side_player_x(f), side_player_y(f), err, sizeof err);
    if (pix && scratch) {
        fb_init(&fb, pix, 2 * CELL_W, 2 * CELL_H);
        board_draw(g.b, NULL, &fb, rgb, scratch);
        put_half(sheet, x, y, &fb, rgb);
        fb_outline(sheet, x, y, CELL_W, CELL_H, 1);
        put_label(sheet, x, y + CELL_H + 3, g.b, list_name(path));
    }
    free(pix);
    free(scratch);
    board_game_close(&g);
    return pix && scratch;
}

static int by_bullets(const void *a, const void *b)
{
    const struct best *p = a, *q = b;

    return p->bullets == q->bullets ? p->document - q->document : q->bullets - p->bullets;
}

static int by_place(const void *a, const void *b)
{
    return ((const struct best *)a)->document - ((const struct best *)b)->document;
}

/* Is it the same file as an earlier one of the list, of another package? */
static bool again(const struct list *documents, int i)
{
    const char *name = strrchr(documents->path[i], '/');

    for (int k = 0; k < i; k++)
        if (!strcmp(strrchr(documents->path[k], '/'), name))
            return true;
    return false;
}

static bool write_png(const struct fb *sheet, const uint32_t rgb[256], const char *path)
{
    uint8_t *png;
    size_t size;
    FILE *f;

    if (!png_write(sheet->pix, sheet->pitch, sheet->w, sheet->h, rgb, &png, &size))
        return false;
    f = fopen(path, "wb");
    const bool fine = f && fwrite(png, 1, size, f) == size;
    free(png);
    return (!f || fclose(f) == 0) && fine;
}

bool tool_sheet(const struct list *documents, const char *path)
{
    struct best *best = calloc((size_t)documents->n, sizeof *best);
    void *mem = malloc(fb_size(WIDTH, HEIGHT));
    uint32_t rgb[256] = { 0 };
    struct fb sheet;
    bool fine = best && mem;
    int n = 0;

    for (int i = 0; fine && i < documents->n; i++) {
        if (again(documents, i))
            continue;
        best[n].document = i;
        fine = find_best(documents->path[i], &best[n++]);
    }
    if (fine) {
        fb_init(&sheet, mem, WIDTH, HEIGHT);
        qsort(best, (size_t)n, sizeof *best, by_bullets);
        n = n < CELLS ? n : CELLS;
        qsort(best, (size_t)n, sizeof *best, by_place);
    }
    for (int i = 0; fine && i < n; i++)
        fine = put_cell(&sheet, i, documents->path[best[i].document], best[i].frame, rgb);
    fine = fine && write_png(&sheet, rgb, path);
    free(best);
    free(mem);
    return fine;
}

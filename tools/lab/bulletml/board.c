/*
 * board.c - a document on a board: the folder game is packed with it, as any game is, and ticked. The board is powered
 * and its picture never drawn. What is asked of it from outside are the columns of its bullets; the player is put where
 * it is to be, and what is to leave is dropped between two frames.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "../../../src/board/board.h"
#include "../../../src/machine/machine.h"
#include "../../../src/workbench/pack/pack.h"
#include "board.h"

enum { MIDDLE_X = 160, MIDDLE_Y = 120, RAM_ALIGN = 64, THOUSAND = 1000, PATH = 1024 };

static const char TOOLS[] = "tools/lab/bulletml/", ART[] = "roms/bench/art/";

struct seen {
    struct side_bullet b;
    uint32_t slot;
};

struct on_board {
    struct board_game game;
    struct seen *seen;
    struct side_bullet *told;
    int32_t n;
};

/* ---- the game's folder ---- */

static bool copy(const char *from, const char *to)
{
    char bytes[4096];
    size_t n;
    FILE *in = fopen(from, "rb"), *out = fopen(to, "wb");
    bool fine = in && out;

    while (fine && (n = fread(bytes, 1, sizeof bytes, in)) > 0)
        fine = fwrite(bytes, 1, n, out) == n;
    fine = fine && !ferror(in);
    if (in)
        fclose(in);
    return (!out || fclose(out) == 0) && fine;
}

static bool write_run(const char *path, const struct side_setup *setup, int roots)
{
    FILE *f = fopen(path, "w");

    if (!f)
        return false;
    fprintf(f, "return { rank = %.17g, seed = %u, loop = %s, roots = %d }\n", setup->rank, setup->seed,
            setup->loop ? "true" : "false", roots);
    return fclose(f) == 0;
}

/* What the folder has: where from (NULL: it is written), where to. */
static const char *const files[][2] = {
    { "game/rom.lua", "rom.lua" },
    { "game/main.lua", "main.lua" },
    { "art/discs.png", "art/discs.png" },
    { "art/font.png", "art/font.png" },
    { "art/palette.png", "art/palette.png" },
    { "document", "bulletml/document.xml" },
    { NULL, "run.lua" },
};
static const char *const folders[] = { "art", "bulletml" };
enum { FILES = sizeof files / sizeof *files, FOLDERS = sizeof folders / sizeof *folders };

static bool fill_folder(const char *dir, const char *game, const struct side_setup *setup, int roots)
{
    char from[PATH], to[PATH];

    for (int i = 0; i < FOLDERS; i++) {
        snprintf(to, sizeof to, "%s/%s", dir, folders[i]);
        if (mkdir(to, 0777))
            return false;
    }
    for (int i = 0; i < FILES; i++) {
        const char *what = files[i][0];
        snprintf(to, sizeof to, "%s/%s", dir, files[i][1]);
        if (!what) {
            if (!write_run(to, setup, roots))
                return false;
            continue;
        }
        if (!strcmp(what, "document"))
            snprintf(from, sizeof from, "%s", setup->file);
        else
            snprintf(from, sizeof from, "%s%s%s", *what == 'g' ? TOOLS : ART, *what == 'g' ? game : "",
                     strchr(what, '/') + (*what != 'g'));
        if (!copy(from, to))
            return false;
    }
    return true;
}

static void remove_folder(const char *dir)
{
    char path[PATH];

    for (int i = 0; i < FILES; i++) {
        snprintf(path, sizeof path, "%s/%s", dir, files[i][1]);
        unlink(path);
    }
    for (int i = 0; i < FOLDERS; i++) {
        snprintf(path, sizeof path, "%s/%s", dir, folders[i]);
        rmdir(path);
    }
    rmdir(dir);
}

static bool pack(struct rom_image *image, const char *game, const struct side_setup *setup, int roots, char *err,
                 size_t err_size)
{
    char dir[] = "/tmp/curtain-bulletml-XXXXXX";
    bool fine;

    if (!mkdtemp(dir)) {
        snprintf(err, err_size, "/tmp: no folder can be made: %s", strerror(errno));
        return false;
    }
    fine = fill_folder(dir, game, setup, roots);
    if (!fine)
        snprintf(err, err_size, "%s: the game cannot be put together: %s", setup->file, strerror(errno));
    fine = fine && pack_load_game(dir, false, image, err, err_size);
    remove_folder(dir);
    return fine;
}

static bool power(struct board_game *g, char *err, size_t err_size)
{
    const struct board_start start = { .seed = 1, .difficulty = -1 };
    size_t size;

    if (!board_size(&g->image.rom, &size, err, err_size))
        return false;
    g->ram = aligned_alloc(RAM_ALIGN, (size + RAM_ALIGN - 1) / RAM_ALIGN * RAM_ALIGN);
    if (!g->ram) {
        snprintf(err, err_size, "no memory");
        return false;
    }
    g->b = board_power_on(g->ram, size, &g->image.rom, &start, err, err_size);
    if (!g->b)
        return false;
    if (board_last_output(g->b)->fault) {
        snprintf(err, err_size, "%.190s", board_last_output(g->b)->fault->message);
        return false;
    }
    player_join(&g->b->player, &g->b->player_kinds, 0, 0, fx_int(MIDDLE_X), fx_int(MIDDLE_Y));
    return true;
}

bool board_game_open(struct board_game *g, const char *game, const struct side_setup *setup, int roots, char *err,
                     size_t err_size)
{
    *g = (struct board_game){ 0 };
    if (pack(&g->image, game, setup, roots, err, err_size) && power(g, err, err_size))
        return true;
    board_game_close(g);
    return false;
}

void board_game_close(struct board_game *g)
{
    rom_image_free(&g->image);
    free(g->ram);
    *g = (struct board_game){ 0 };
}

bool board_game_tick(struct board_game *g, int32_t player_x, int32_t player_y, char *err, size_t err_size)
{
    const uint16_t pads[MAX_PLAYERS] = { 0 };

    player_set_position(&g->b->player, 0, fx_int(player_x + MIDDLE_X), fx_int(player_y + MIDDLE_Y));
    const struct board_out *after = board_tick(g->b, pads);
    if (after->fault)
        snprintf(err, err_size, "%.190s", after->fault->message);
    return !after->fault;
}

/* ---- frames ---- */

static double middle(fx v, int32_t from)
{
    return (double)v / FX_ONE - from;
}

static int by_number(const void *a, const void *b)
{
    const struct seen *p = a, *q = b;

    return (p->b.id > q->b.id) - (p->b.id < q->b.id);
}

static void look(struct on_board *o)
{
    const struct bullets *b = &o->game.b->bullets;

    o->n = 0;
    for (uint32_t i = 0; i < b->s.top; i++) {
        if (!(b->s.live_bits[i / SLOTS_BLOCK] >> i % SLOTS_BLOCK & 1))
            continue;
        const struct side_bullet at = { .id = fx_floor(b->value1[i]) + THOUSAND * fx_floor(b->value2[i]),
                                        .x = middle(b->x[i], MIDDLE_X),
                                        .y = middle(b->y[i], MIDDLE_Y) };
        o->seen[o->n++] = (struct seen){ at, i };
    }
    qsort(o->seen, (size_t)o->n, sizeof *o->seen, by_number);
    for (int32_t i = 0; i < o->n; i++)
        o->told[i] = o->seen[i].b;
}

static int32_t frame(struct side *s, int32_t player_x, int32_t player_y, const struct side_bullet **out)
{
    struct on_board *o = s->own;

    if (!board_game_tick(&o->game, player_x, player_y, s->error, sizeof s->error))
        return -1;
    look(o);
    *out = o->told;
    return o->n;
}

static bool leave(struct side *s, const int32_t *ids, int32_t n)
{
    struct on_board *o = s->own;

    for (int32_t i = 0; i < n; i++) {
        const struct seen wanted = { .b = { .id = ids[i] } };
        const struct seen *found = bsearch(&wanted, o->seen, (size_t)o->n, sizeof *o->seen, by_number);
        if (found)
            bullets_drop(&o->game.b->bullets, found->slot);
    }
    return true;
}

static void close_board(struct side *s)
{
    struct on_board *o = s->own;

    board_game_close(&o->game);
    free(o->seen);
    free(o->told);
    free(o);
    s->own = NULL;
}

static bool open_board(struct on_board *o, const struct side_setup *setup, char *err, size_t err_size)
{
    if (!board_game_open(&o->game, "game", setup, 1, err, err_size))
        return false;
    o->seen = calloc(SIDE_MOST, sizeof *o->seen);
    o->told = calloc(SIDE_MOST, sizeof *o->told);
    if (!o->seen || !o->told)
        snprintf(err, err_size, "no memory");
    return o->seen && o->told;
}

bool side_board(struct side *s, const struct side_setup *setup)
{
    struct on_board *o = calloc(1, sizeof *o);

    *s = (struct side){ .frame = frame, .leave = leave, .close = close_board, .own = o };
    if (o && open_board(o, setup, s->error, sizeof s->error))
        return true;
    if (o)
        close_board(s);
    return false;
}

/*
 * headless.c - see headless.h. A run is power, then ticks with the demo's pads; the two commands differ in what they do
 * between ticks.
 */
#include "headless.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"
#include "host/clean.h"
#include "cli.h"
#include "host/files.h"
#include "game.h"
#include "run/guard.h"
#include "pack/png.h"
#include "demo/trace.h"

enum { HASH_FRAMES = 600 /* without a demo or --frames */ };

struct run {
    struct game game;
    struct guard guard;
    struct demo_writer writer;
    const struct args *a;
};

/* ---- a run ---- */

static void pass_on_log(const struct board_out *out)
{
    char line[512];

    for (size_t i = 0; i < out->log_size;) {
        const char *from = out->log + i, *end = memchr(from, '\n', out->log_size - i);
        size_t n = end ? (size_t)(end - from) : out->log_size - i;
        snprintf(line, sizeof line, "%.*s", (int)(n < sizeof line ? n : sizeof line - 1), from);
        clean_line(line);
        plat_log(line);
        i += n + 1;
    }
}

/* The exit code after a power-on or tick. */
static int outcome(struct run *r)
{
    const struct board_out *out = board_last(r->guard.board);

    pass_on_log(out);
    return out->fault ? game_report_fault(out->fault, r->a->verbose) : EXIT_DONE;
}

static int run_open(struct run *r, const struct args *a)
{
    const char *path = a->n_words > 0 ? a->words[0] : NULL;
    char err[1024];

    memset(r, 0, sizeof *r);
    r->a = a;
    if (!game_open(&r->game, path, a, err, sizeof err))
        return game_refuse(err);
    if (!guard_power(&r->guard, &r->game.rom, &r->game.start, err, sizeof err))
        return game_report(EXIT_INPUT, "%s: %s", path ? path : "the built-in game", err);
    if (a->record && !demo_begin(&r->writer, a->record, &r->game.cart, r->guard.board, &r->game.start, 0))
        return game_report(EXIT_HOST, "%s", r->writer.err);
    return outcome(r);
}

static int run_tick(struct run *r)
{
    uint16_t pads[PADS] = { 0 };

    if (r->game.has_demo)
        demo_pads(&r->game.demo, board_frame(r->guard.board), pads);
    guard_tick(&r->guard, pads);
    if (!demo_frame(&r->writer, r->guard.board, pads))
        return game_report(EXIT_HOST, "%s", r->writer.err);
    return outcome(r);
}

/* Ends the run; code is what it came to so far. */
static int run_close(struct run *r, int code)
{
    if (r->guard.board && !demo_end(&r->writer, r->guard.board) && code == EXIT_DONE)
        code = game_report(EXIT_HOST, "%s", r->writer.err);
    demo_free(&r->writer.demo);
    guard_close(&r->guard);
    game_close(&r->game);
    return code;
}

static int stdout_done(int code)
{
    if (fflush(stdout) == 0 && !ferror(stdout))
        return code;
    return game_report(EXIT_HOST, "standard output cannot be written");
}

/* ---- render ---- */

enum { SHEET_GAP = 4, SHEET_GREY = 0x28, SHEET_PIXELS = 1 << 26 };

struct sheet {
    uint8_t *rgb; /* NULL: none is wanted */
    int w, h, columns;
    int count; /* pictures on it */
};

struct studio {
    struct fb fb;
    void *mem, *scratch;
    uint32_t rgb[256];
    struct sheet sheet;
};

static uint32_t count_wanted(const struct args *a)
{
    uint32_t n = 0, last = args_last_frame(a);

    for (uint32_t f = 0; f <= last; f++)
        n += args_wants(a, f);
    return n;
}

/* About as wide as high, in whole pictures. False: too large. */
static bool sheet_open(struct sheet *s, int64_t n, int w, int h)
{
    int64_t columns = 1, cell_w = w + SHEET_GAP, cell_h = h + SHEET_GAP;

    while (columns * columns * cell_w < n * cell_h)
        columns++;
    int64_t rows = (n + columns - 1) / columns;
    int64_t sheet_w = columns * cell_w + SHEET_GAP, sheet_h = rows * cell_h + SHEET_GAP;
    if (sheet_w > PNG_MAX_SIDE || sheet_h > PNG_MAX_SIDE || sheet_w * sheet_h > SHEET_PIXELS)
        return false;
    *s = (struct sheet){ .w = (int)sheet_w, .h = (int)sheet_h, .columns = (int)columns };
    s->rgb = malloc((size_t)(sheet_w * sheet_h * 3));
    if (s->rgb)
        memset(s->rgb, SHEET_GREY, (size_t)(sheet_w * sheet_h * 3));
    return s->rgb != NULL;
}

static void sheet_add(struct sheet *s, const struct fb *fb, const uint32_t rgb[256])
{
    int x0 = SHEET_GAP + s->count % s->columns * (fb->w + SHEET_GAP);
    int y0 = SHEET_GAP + s->count / s->columns * (fb->h + SHEET_GAP);

    s->count++;
    for (int y = 0; y < fb->h; y++) {
        uint8_t *to = s->rgb + ((size_t)(y0 + y) * (size_t)s->w + (size_t)x0) * 3;
        const uint8_t *from = fb->pix + (ptrdiff_t)y * fb->pitch;
        for (int x = 0; x < fb->w; x++, to += 3) {
            to[0] = (uint8_t)(rgb[from[x]] >> 16);
            to[1] = (uint8_t)(rgb[from[x]] >> 8);
            to[2] = (uint8_t)rgb[from[x]];
        }
    }
}

static void studio_close(struct studio *s)
{
    free(s->mem);
    free(s->scratch);
    free(s->sheet.rgb);
}

static int studio_open(struct studio *s, const struct run *r)
{
    int w, h;

    memset(s, 0, sizeof *s);
    board_screen(r->guard.board, &w, &h);
    s->mem = malloc(fb_size(w, h));
    s->scratch = malloc(board_scratch(r->guard.board) + 1);
    if (!s->mem || !s->scratch)
        return game_report(EXIT_HOST, "out of memory");
    fb_init(&s->fb, s->mem, w, h);
    if (r->a->sheet && !sheet_open(&s->sheet, count_wanted(r->a), w, h))
        return game_report(EXIT_INPUT, "--sheet: too many frames for one picture");
    return EXIT_DONE;
}

/* Writes and frees a PNG file; data NULL: it could not be made. */
static int save(const char *path, uint8_t *data, size_t size)
{
    char err[1200];
    bool made = data != NULL, ok = made && files_save(path, data, size, err, sizeof err);

    free(data);
    if (!made)
        return game_report(EXIT_HOST, "%s: out of memory", path);
    return ok ? EXIT_DONE : game_report(EXIT_HOST, "%s", err);
}

static int picture(struct studio *s, const struct run *r, uint32_t frame)
{
    char path[DEMO_PATH];
    const char *dir = r->a->out ? r->a->out : ".";
    size_t size = 0;
    uint8_t *png;

    board_draw(r->guard.board, &s->fb, s->rgb, s->scratch);
    if (s->sheet.rgb)
        sheet_add(&s->sheet, &s->fb, s->rgb);
    if (r->a->sheet && !r->a->out)
        return EXIT_DONE;
    if (snprintf(path, sizeof path, "%s/%06u.png", dir, (unsigned)frame) >= (int)sizeof path)
        return game_report(EXIT_INPUT, "-o: the path is too long");
    png_write(s->fb.pix, s->fb.pitch, s->fb.w, s->fb.h, s->rgb, &png, &size);
    return save(path, png, size);
}

static int render_frames(struct studio *s, struct run *r)
{
    uint32_t last = args_last_frame(r->a);
    int code = EXIT_DONE;

    for (uint32_t f = 0; code == EXIT_DONE; f++) {
        if (args_wants(r->a, f))
            code = picture(s, r, f);
        if (f == last || code != EXIT_DONE)
            break;
        code = run_tick(r);
    }
    return code;
}

static int sheet_save(struct studio *s, const char *path)
{
    size_t size = 0;
    uint8_t *png;

    png_write_rgb(s->sheet.rgb, s->sheet.w, s->sheet.h, &png, &size);
    return save(path, png, size);
}

int headless_render(const struct args *a)
{
    struct run *r = malloc(sizeof *r);
    struct studio s = { 0 };

    if (!r)
        return game_report(EXIT_HOST, "out of memory");
    if (!a->n_spans) {
        free(r);
        return game_report(EXIT_INPUT, "render needs --frames (curtain help render)");
    }
    int code = run_open(r, a);
    if (code == EXIT_DONE)
        code = studio_open(&s, r);
    if (code == EXIT_DONE)
        code = render_frames(&s, r);
    if (s.sheet.count > 0) { /* also of a run that stopped early */
        int saved = sheet_save(&s, a->sheet);
        code = code == EXIT_DONE ? saved : code;
    }
    studio_close(&s);
    code = run_close(r, code);
    free(r);
    return code;
}

/* ---- hash ---- */

struct hashing {
    uint64_t hashes[MAX_PARTS];
    void *copies;   /* of board_hashes_cached */
    uint32_t trace; /* parts to print instead, 1 << part */
};

static void print_hash(struct hashing *h, const struct board *b, bool parts)
{
    board_hashes_cached(b, h->copies, h->hashes);
    printf("%u %016llx", (unsigned)board_frame(b), (unsigned long long)board_hash_of(h->hashes));
    for (int i = 0; parts && i < board_parts(b); i++)
        printf(" %s=%016llx", board_part(b, i), (unsigned long long)h->hashes[i]);
    putchar('\n');
}

static int unknown_part(const struct board *b, const char *name, int n)
{
    const char *names[MAX_PARTS], *meant;
    char word[64];

    for (int i = 0; i < board_parts(b); i++)
        names[i] = board_part(b, i);
    snprintf(word, sizeof word, "%.*s", n, name);
    meant = args_near(word, names, board_parts(b));
    if (meant)
        return game_report(EXIT_INPUT, "--trace: unknown part \"%s\" (did you mean \"%s\"?)", word, meant);
    return game_report(EXIT_INPUT, "--trace: unknown part \"%s\" (hash --parts names them all)", word);
}

/* Adds the part of that name, or all, to *set; false: there is none. */
static bool add_part(const struct board *b, const char *name, size_t n, uint32_t *set)
{
    bool all = n == 3 && memcmp(name, "all", n) == 0, known = all;

    for (int i = 0; i < board_parts(b); i++) {
        const char *part = board_part(b, i);
        bool is = strlen(part) == n && memcmp(part, name, n) == 0;
        *set |= (uint32_t)(is || all) << i;
        known |= is;
    }
    return known;
}

static int read_traces(const struct args *a, const struct board *b, uint32_t *set)
{
    for (int i = 0; i < a->n_traces; i++) {
        for (const char *p = a->traces[i];; p++) {
            size_t n = strcspn(p, ",");
            if (!add_part(b, p, n, set))
                return unknown_part(b, p, (int)n);
            p += n;
            if (!*p)
                break;
        }
    }
    return EXIT_DONE;
}

static void print_frame(struct hashing *h, const struct run *r, uint32_t f)
{
    if (f % r->a->every != 0)
        return;
    if (!h->trace)
        print_hash(h, r->guard.board, r->a->parts);
    else if (!r->a->n_spans || args_wants(r->a, f))
        trace_frame(stdout, r->guard.board, h->trace);
}

static int hash_frames(struct run *r, uint32_t frames)
{
    struct hashing h = { .copies = calloc(1, board_hash_cache_size(r->guard.board)) };
    int code = h.copies ? read_traces(r->a, r->guard.board, &h.trace) : game_report(EXIT_HOST, "out of memory");

    for (uint32_t f = 0; code == EXIT_DONE; f++) {
        print_frame(&h, r, f);
        if (f == frames || ferror(stdout))
            break;
        code = run_tick(r);
    }
    free(h.copies);
    return code;
}

int headless_hash(const struct args *a)
{
    struct run *r;
    bool one = a->n_spans == 1 && a->spans[0].first == a->spans[0].last;

    if (a->n_spans && !one && !a->n_traces)
        return game_report(EXIT_INPUT, "--frames: hash takes one number, how many frames to run");
    if ((r = malloc(sizeof *r)) == NULL)
        return game_report(EXIT_HOST, "out of memory");
    int code = run_open(r, a);
    uint32_t frames = a->n_spans ? args_last_frame(a) : r->game.has_demo ? r->game.demo.frames : HASH_FRAMES;
    if (code == EXIT_DONE)
        code = hash_frames(r, frames);
    code = stdout_done(run_close(r, code));
    free(r);
    return code;
}

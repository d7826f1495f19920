/*
 * headless.c - see headless.h. Both commands play a run (headless_run.h) and write output between the ticks.
 */
#include "headless.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "contact.h"
#include "../../common/files.h"
#include "../../common/report.h"
#include "../../player/speaker/wav_writer.h"
#include "../../common/output_paths.h"
#include "../../../platform/platform.h"
#include "../../player/picture/png.h"
#include "../../player/picture/shade.h"
#include "../../demo/trace.h"
#include "headless_run.h"

enum { HASH_FRAMES = 600 /* without a demo or --frames */ };

/* ---- render ---- */

struct render {
    struct fb fb;
    void *mem, *scratch;
    uint32_t rgb[256];
    struct shade_cache shades;
    struct view view;
    struct game_files game; /* frames must not overwrite these */
    struct contact sheet;
    struct wav_writer wav;
};

static uint32_t count_wanted(const struct args *a)
{
    uint32_t n = 0, last = args_last_frame(a);

    for (uint32_t f = 0; f <= last; f++)
        n += args_has_frame(a, f);
    return n;
}

static void render_close(struct render *s)
{
    free(s->mem);
    free(s->scratch);
    game_files_close(&s->game);
    contact_close(&s->sheet);
    wav_writer_close(&s->wav);
}

static enum result render_open(struct render *s, const struct headless_run *r)
{
    int w, h;

    memset(s, 0, sizeof *s);
    board_screen_size(r->guard.board, &w, &h);
    game_files_open(&s->game, r->game.path);
    s->mem = malloc(fb_size(w, h));
    s->scratch = malloc(board_scratch_size(r->guard.board) + 1);
    if (!s->mem || !s->scratch)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    fb_init(&s->fb, s->mem, w, h);
    s->view = (struct view){ .dim = (enum view_dim)r->a->dim,
                             .softens_flashes = r->a->flashes,
                             .colour_blind_mode = (enum colour_blind_mode)r->a->colours,
                             .shades = shade_get_tables(&s->shades, &r->game.cart) };
    if (r->a->wav && !wav_writer_open(&s->wav))
        return report_line(RESULT_HOST_FAILED, "out of memory");
    if (r->a->sheet && !contact_open(&s->sheet, count_wanted(r->a), w, h))
        return report_line(RESULT_REFUSED, "--sheet: too many frames for one picture");
    return RESULT_DONE;
}

static enum result render_picture(struct render *s, const struct headless_run *r, uint32_t frame)
{
    char path[DEMO_PATH_SIZE];
    const char *dir = r->a->out ? r->a->out : ".";
    size_t size = 0;
    uint8_t *png;

    board_draw(r->guard.board, &s->view, &s->fb, s->rgb, s->scratch);
    if (s->sheet.rgb)
        contact_add(&s->sheet, &s->fb, s->rgb, frame);
    if ((r->a->sheet || r->a->wav) && !r->a->out)
        return RESULT_DONE;
    if (snprintf(path, sizeof path, "%s/%06u.png", dir, (unsigned)frame) >= (int)sizeof path)
        return report_line(RESULT_REFUSED, "-o: path too long");
    if (game_files_have(&s->game, path))
        return report_line(RESULT_REFUSED, "-o: %s is one of the game's files; choose another folder", path);
    if (!output_path_available(path, png_is_signed))
        return report_line(RESULT_REFUSED, "%s: already exists; remove it, or choose another folder with -o", path);
    if (r->a->sheet && plat_is_same_file(path, r->a->sheet))
        return report_line(RESULT_REFUSED, "--sheet: %s is also the name of a frame file; choose another name", path);
    png_write(s->fb.pix, s->fb.pitch, s->fb.w, s->fb.h, s->rgb, &png, &size);
    return report_save_png(path, png, size);
}

static enum result render_frames(struct render *s, struct headless_run *r)
{
    uint32_t last = args_last_frame(r->a);
    enum result result = RESULT_DONE;

    for (uint32_t f = 0; result == RESULT_DONE; f++) {
        if (args_has_frame(r->a, f))
            result = render_picture(s, r, f);
        if (f == last || result != RESULT_DONE)
            break;
        result = headless_run_tick(r);
        if (r->a->wav)
            wav_writer_add(&s->wav, r->guard.board);
    }
    return result;
}

static enum result save_wav(struct render *s, const char *path)
{
    char err[1200];

    return wav_writer_save(&s->wav, path, err, sizeof err) ? RESULT_DONE : report_line(RESULT_HOST_FAILED, "%s", err);
}

static enum result save_sheet(struct render *s, const char *path)
{
    size_t size = 0;
    uint8_t *png;

    png_write_rgb(s->sheet.rgb, s->sheet.w, s->sheet.h, &png, &size);
    return report_save_png(path, png, size);
}

enum result headless_render(const struct args *a)
{
    struct headless_run *r = malloc(sizeof *r);
    struct render s = { 0 };

    if (!r)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    if (!a->n_spans) {
        free(r);
        return report_line(RESULT_REFUSED, "render needs --frames (see curtain help render)");
    }
    enum result result = headless_run_open(r, a);
    if (result == RESULT_DONE)
        result = render_open(&s, r);
    if (result == RESULT_DONE)
        result = render_frames(&s, r);
    if (s.sheet.count > 0) { /* also after a run that stopped early */
        enum result saved = save_sheet(&s, a->sheet);
        result = result == RESULT_DONE ? saved : result;
    }
    if (s.wav.file.bytes) { /* also for frame 0 alone, which has no sound */
        enum result saved = save_wav(&s, a->wav);
        result = result == RESULT_DONE ? saved : result;
    }
    render_close(&s);
    result = headless_run_close(r, result);
    free(r);
    return result;
}

/* ---- hash ---- */

struct hasher {
    uint64_t hashes[MAX_PARTS];
    void *hash_cache; /* of board_hashes_cached */
    uint64_t trace;   /* parts to trace instead, bits 1 << part */
};

static void print_hash(struct hasher *h, const struct board *b, bool parts)
{
    board_hashes_cached(b, h->hash_cache, h->hashes);
    printf("%u %016llx", (unsigned)board_frame(b), (unsigned long long)board_combine_hashes(h->hashes));
    for (int i = 0; parts && i < board_part_count(b); i++)
        printf(" %s=%016llx", board_part_name(b, i), (unsigned long long)h->hashes[i]);
    putchar('\n');
}

static enum result report_unknown_part(const struct board *b, const char *name, int n)
{
    const char *names[MAX_PARTS], *meant;
    char word[64];

    for (int i = 0; i < board_part_count(b); i++)
        names[i] = board_part_name(b, i);
    snprintf(word, sizeof word, "%.*s", n, name);
    meant = args_near(word, names, board_part_count(b));
    if (meant)
        return report_line(RESULT_REFUSED, "--trace: unknown part \"%s\" (did you mean \"%s\"?)", word, meant);
    return report_line(RESULT_REFUSED, "--trace: unknown part \"%s\" (hash --parts lists all parts)", word);
}

/* Adds the part with the name, or all parts, to *set; false: unknown name. */
static bool add_part(const struct board *b, const char *name, size_t n, uint64_t *set)
{
    bool all = n == 3 && memcmp(name, "all", n) == 0, known = all;

    for (int i = 0; i < board_part_count(b); i++) {
        const char *part = board_part_name(b, i);
        bool is = strlen(part) == n && memcmp(part, name, n) == 0;
        *set |= (uint64_t)(is || all) << i;
        known |= is;
    }
    return known;
}

static enum result read_traces(const struct args *a, const struct board *b, uint64_t *set)
{
    for (int i = 0; i < a->n_traces; i++) {
        for (const char *p = a->traces[i];; p++) {
            size_t n = strcspn(p, ",");
            if (!add_part(b, p, n, set))
                return report_unknown_part(b, p, (int)n);
            p += n;
            if (!*p)
                break;
        }
    }
    return RESULT_DONE;
}

static void print_frame(struct hasher *h, const struct headless_run *r, uint32_t f)
{
    if (f % r->a->every != 0)
        return;
    if (!h->trace)
        print_hash(h, r->guard.board, r->a->parts);
    else if (!r->a->n_spans || args_has_frame(r->a, f))
        trace_frame(stdout, r->guard.board, h->trace);
}

static enum result hash_frames(struct headless_run *r, uint32_t frames)
{
    struct hasher h = { .hash_cache = calloc(1, board_hash_cache_size(r->guard.board)) };
    enum result result =
        h.hash_cache ? read_traces(r->a, r->guard.board, &h.trace) : report_line(RESULT_HOST_FAILED, "out of memory");

    for (uint32_t f = 0; result == RESULT_DONE; f++) {
        print_frame(&h, r, f);
        if (f == frames || ferror(stdout))
            break;
        result = headless_run_tick(r);
    }
    free(h.hash_cache);
    return result;
}

enum result headless_hash(const struct args *a)
{
    struct headless_run *r;
    bool one = a->n_spans == 1 && a->spans[0].first == a->spans[0].last;

    if (a->n_spans && !one && !a->n_traces)
        return report_line(RESULT_REFUSED, "--frames: hash takes one number, the number of frames to run");
    if ((r = malloc(sizeof *r)) == NULL)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    enum result result = headless_run_open(r, a);
    uint32_t frames = a->n_spans ? args_last_frame(a) : r->game.has_demo ? r->game.demo.frames : HASH_FRAMES;
    if (result == RESULT_DONE)
        result = hash_frames(r, frames);
    result = report_stdout(headless_run_close(r, result));
    free(r);
    return result;
}

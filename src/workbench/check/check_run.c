/*
 * check_run.c - packs the game and runs it without a window: every demo, or the first frames without input; then every
 * stage and every phase; then the runs of check_forced.c. It reports faults, demos that diverge, full pools, bullets
 * with little contrast and the use of Lua RAM.
 */
#include "check_run.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../machine/video/contrast.h"
#include "../../board/inspect.h"
#include "../pack/art.h"
#include "../../common/progress.h"
#include "../bench/sweep.h"

enum {
    IDLE_FRAMES = 600,       /* of a game without demos */
    MAX_DEMO_FRAMES = 36000, /* of a demo: ten minutes */
    MAX_LUA_PERCENT = 75,    /* percent of board.lua_kib */
    SAMPLE_EVERY = 120,      /* frames between two samples of contrast */
    SAMPLES = 150,           /* in a run */
    FEW_BULLETS = 40,        /* too few to report */
    TEXT_EVERY = 12          /* frames between two checks of the text on the screen */
};

#define NO_FRAME UINT32_MAX /* frames */

/* ---- hit shapes and pictures ---- */

/* Returns the file and line in which a kind is declared with a literal name; line 0: not found. */
static const char *find_declaration(const struct check *c, const char *of, const char *name, int *line)
{
    *line = 0;
    for (int i = 0; i < c->n_scripts; i++)
        for (int k = 0; k < c->scripts[i].symbols.n_calls; k++) {
            const struct symbol_call *call = &c->scripts[i].symbols.calls[k];
            if (!symbol_call_is(call, of, "def") || !symbols_same(call->arg[0], name))
                continue;
            *line = call->line;
            return c->scripts[i].path;
        }
    return "rom.lua";
}

/* Returns the size of a sprite's picture, unrotated: from rom.lua, or from the ROM if rom.lua has none. */
static void sprite_size(const struct run *r, const struct art_sprite *s, int *w, int *h)
{
    struct sprite packed;

    *w = art_resized(s->w, s->scale_percent);
    *h = art_resized(s->h, s->scale_percent);
    if (s->w && s->h)
        return;
    cart_sprite(&r->cart, cart_find(&r->cart, CART_SPRITES, s->name), &packed);
    *w = packed.w;
    *h = packed.h;
}

/* Reports a hit shape that is larger than its sprite, which is probably a mistake. */
static void report_large_shape(void *context, const struct inspect_kind_shape *kind)
{
    static const char *const words[] = { [INSPECT_CIRCLE] = "hit circle",
                                         [INSPECT_BOX] = "hit box",
                                         [INSPECT_CAPSULE] = "hit capsule",
                                         [INSPECT_CIRCLES] = "combined hit circles" };
    const struct run *r = context;
    struct check *c = r->c;
    int64_t w = (int64_t)kind->x1 - kind->x0, h = (int64_t)kind->y1 - kind->y0;
    int line;

    for (int i = 0; i < c->art.n_sprites; i++) {
        const struct art_sprite *s = &c->art.sprites[i];
        if (strcmp(s->name, kind->sprite) != 0)
            continue;
        int pic_w, pic_h;
        sprite_size(r, s, &pic_w, &pic_h);
        pic_w = pic_w * kind->scale / SCALE_ONE;
        pic_h = pic_h * kind->scale / SCALE_ONE;
        int side = pic_w > pic_h ? pic_w : pic_h;
        bool any_way = kind->is_rotated && kind->shape == INSPECT_BOX;
        if (w <= (int64_t)(any_way ? side : pic_w) << 16 && h <= (int64_t)(any_way ? side : pic_h) << 16)
            continue;
        const char *file = find_declaration(c, kind->entity, kind->name, &line);
        diagnostics_add(&c->found, file, line,
                        "%s \"%s\": its %s (%.7g x %.7g px) %s larger than its sprite \"%s\" (%d x %d px)",
                        kind->entity, kind->name, words[kind->shape], (double)w / 65536, (double)h / 65536,
                        kind->shape == INSPECT_CIRCLES ? "are" : "is", s->name, pic_w, pic_h);
    }
}

/* Luma of ITU-R BT.601, in thousandths. */
static int luminance(const uint8_t rgb[3])
{
    return 299 * rgb[0] + 587 * rgb[1] + 114 * rgb[2];
}

/* Returns the first colour of a bank that is darker than the one before it, or 0 if the bank is a ramp from dark to
 * bright. Black colours at its end are unused. */
static int find_darker(const uint8_t *bank)
{
    int last = 15, before = 0;

    while (last > 1 && luminance(bank + 3 * last) == 0)
        last--;
    for (int k = 1; k <= last; before = luminance(bank + 3 * k), k++)
        if (luminance(bank + 3 * k) < before)
            return k;
    return 0;
}

/* Reports a kind with a ramp blend whose bank is not a ramp. Ramp blends mix indices within a bank. */
static void report_ramp(void *context, const struct inspect_kind_shape *kind)
{
    struct run *r = context;
    int line, at = kind->ramp ? find_darker(cart_palette(&r->cart, "main") + 3 * 16 * kind->bank) : 0;

    if (at == 0)
        return;
    const char *file = find_declaration(r->c, kind->entity, kind->name, &line);
    diagnostics_add(&r->c->found, file, line,
                    "%s \"%s\": its blend \"%s\" needs a dark-to-light bank, but colour %d in bank %d "
                    "is darker than colour %d",
                    kind->entity, kind->name, kind->ramp, at, kind->bank, at - 1);
}

/* ---- games that cannot be started ---- */

/* Returns the first literal name in a call of space.def, or NULL. *found: there is a call. */
static const char *find_first_declared(const struct check *c, const char *space, bool *found)
{
    for (int i = 0; i < c->n_scripts; i++)
        for (int k = 0; k < c->scripts[i].symbols.n_calls; k++) {
            const struct symbol_call *call = &c->scripts[i].symbols.calls[k];
            if (!symbol_call_is(call, space, "def"))
                continue;
            *found = true;
            if (call->arg[0] != NULL)
                return call->arg[0];
        }
    return NULL;
}

/* Reports a game that never calls boot.run, which starts stages and ships. A game without stages may use tasks. */
static void check_boot(struct run *r)
{
    const struct board *b = r->guard.board;
    const bool idle = board_live_count(b, "tasks") == 0;
    bool stages = false, ships = false;
    char entry[TREE_PATH];

    if (board_called_boot_run(b) || board_last_output(b)->fault)
        return;
    snprintf(entry, sizeof entry, "%s.lua", r->c->m.entry);
    const char *ship = find_first_declared(r->c, "player", &ships),
               *stage = find_first_declared(r->c, "stage", &stages);
    if (stages || (ships && idle))
        diagnostics_add(
            &r->c->found, entry, 0,
            "boot.run is not called, so the game cannot be played; end this script with boot.run { stages = "
            "{ \"%s\" }, players = { \"%s\" } }",
            stage != NULL ? stage : "one", ship != NULL ? ship : "ship");
    else if (idle)
        diagnostics_note(&r->c->found, entry, 0,
                         "boot.run is not called and no task is started, so nothing will happen");
}

/* ---- one run ---- */

/* Writes the undeclared or nil name of a fault's message; "": another fault. */
static void find_missing_name(const char *message, char *name, size_t size)
{
    static const char *const before[] = { "undeclared global \"", "(field '", "(global '", "(method '" };

    name[0] = '\0';
    for (size_t i = 0; i < sizeof before / sizeof *before && !name[0]; i++) {
        const char *at = strstr(message, before[i]);
        if (at != NULL)
            snprintf(name, size, "%.*s", (int)strcspn(at + strlen(before[i]), "'\""), at + strlen(before[i]));
    }
}

/* Adds a fault, unless check_lua.c has reported the same missing name. */
static void report_fault(struct run *r, const struct board_fault *fault)
{
    struct diagnostics alone = { 0 };
    char name[64];

    r->memory_fault = r->memory_fault || fault->kind == FAULT_MEMORY;
    find_missing_name(fault->message, name, sizeof name);
    diagnostics_add_sentence(&alone, r->name, fault->message);
    const bool known = alone.n > 0 && name[0] && alone.list[0].line > 0 &&
                       diagnostics_misses(&r->c->found, alone.list[0].file, alone.list[0].line, name);
    diagnostics_close(&alone);
    if (!known)
        diagnostics_add_sentence(&r->c->found, r->name, fault->message);
}

/* Returns whether a script calls board.refused for the pool, so it handles a full pool. */
static bool is_watched(const struct check *c, const char *part)
{
    for (int i = 0; i < c->n_scripts; i++) {
        const struct symbols *f = &c->scripts[i].symbols;
        for (int k = 0; k < f->n_calls; k++) {
            const struct symbol_call *call = &f->calls[k];
            if (symbol_call_is(call, "board", "refused") && (call->arg[0] == NULL || strcmp(call->arg[0], part) == 0))
                return true;
        }
    }
    return false;
}

/* Reports pools that are full for the first time, except sparks, which no script depends on. */
static void report_full_pools(struct run *r, const struct board_out *out)
{
    for (int i = 0; i < out->full_pool_count && !r->forced; i++)
        if (strcmp(out->full_pool[i].part, "sparks") != 0 && !is_watched(r->c, out->full_pool[i].part))
            diagnostics_add_sentence(&r->c->found, r->name, out->full_pool[i].line);
}

static void add_shown(void *context, uint32_t code)
{
    check_note_shown(context, code);
}

const struct board_out *check_run_tick(struct run *r, const uint16_t pads[MAX_PLAYERS])
{
    const struct board_out *out = guard_tick(&r->guard, pads);

    report_full_pools(r, out);
    if (board_frame(r->guard.board) % TEXT_EVERY == 0 && !out->fault)
        inspect_codes(r->guard.board, add_shown, r->c);
    if (r->audio != NULL)
        check_audio_frame(r->audio, r->guard.board);
    return out;
}

void check_run_show_progress(const struct run *r, uint32_t f, uint32_t n)
{
    const uint64_t each = SWEEP_FRAMES;

    progress_update((uint64_t)r->runs * each + (n ? f * each / n : 0), (uint64_t)r->planned * each,
                    "%s, %d of %d, frame %" PRIu32, r->name, r->runs + 1, r->planned, f);
}

bool check_run_power_on(struct run *r, const char *what, const struct board_start *start)
{
    char err[512];

    r->name = what;
    r->forced = false;
    if (r->guard.ram != NULL ? guard_restart(&r->guard, start, err, sizeof err)
                             : guard_power(&r->guard, &r->image.rom, start, err, sizeof err)) {
        report_full_pools(r, board_last_output(r->guard.board));
        if (!r->measured) {
            inspect_kinds(r->guard.board, report_large_shape, r);
            inspect_kinds(r->guard.board, report_ramp, r);
        }
        r->boots = board_called_boot_run(r->guard.board);
        if (!r->measured)
            check_boot(r);
        r->measured = true;
        return true;
    }
    diagnostics_add_sentence(&r->c->found, "rom.lua", err);
    return false;
}

/* Ignores the peak of a run that ended in an infinite loop, which may have filled the memory. */
void check_run_finish(struct run *r)
{
    const struct board_fault *fault = board_last_output(r->guard.board)->fault;
    size_t peak = board_lua_peak(r->guard.board);

    if (fault)
        report_fault(r, fault);
    if (peak > r->lua_peak && !(fault && fault->kind == FAULT_LOOP)) {
        r->lua_peak = peak;
        snprintf(r->lua_peak_run, sizeof r->lua_peak_run, "%s", r->name);
    }
    r->runs++;
}

/* Starts to check the sound of a run. This takes longer than the run itself, so it isn't done for sections. */
static void start_audio(struct run *r)
{
    if (!board_has_sound(r->guard.board))
        return;
    r->audio = check_audio_open();
    r->c->found.failed = r->c->found.failed || r->audio == NULL;
}

static void finish_audio(struct run *r)
{
    if (r->audio != NULL)
        check_audio_report(r->c, r->audio, r->name);
    check_audio_close(r->audio);
    r->audio = NULL;
}

struct board_start check_run_start(const struct run *r)
{
    struct board_start start = { .difficulty = -1 };

    for (int i = 0; i < r->cart.manifest.n_dips; i++)
        start.dip[i] = r->cart.manifest.dips[i].default_value;
    return start;
}

static void run_idle(struct run *r)
{
    const uint16_t nothing[MAX_PLAYERS] = { 0 };
    struct board_start start = check_run_start(r);

    if (!check_run_power_on(r, "600 frames without input", &start))
        return;
    start_audio(r);
    for (uint32_t f = 0; f < IDLE_FRAMES && !board_last_output(r->guard.board)->fault; f++) {
        check_run_show_progress(r, f, IDLE_FRAMES);
        check_run_tick(r, nothing);
    }
    finish_audio(r);
    check_run_finish(r);
}

/* ---- contrast ---- */

/* Starts a run; only the entries that have been reported remain. */
static bool contrast_open(struct contrast *k, const struct board *b)
{
    int w, h, n = 0;

    for (int i = 0; i < k->n; i++)
        if (k->entry[i].reported)
            k->entry[n++] = k->entry[i];
    k->n = n;
    k->samples = 0;
    board_screen_size(b, &w, &h);
    k->pixels = malloc(fb_size(w, h));
    k->scratch = malloc(board_scratch_size(b));
    if (k->pixels == NULL || k->scratch == NULL)
        return false;
    fb_init(&k->fb, k->pixels, w, h);
    return true;
}

static void contrast_close(struct contrast *k)
{
    free(k->pixels);
    free(k->scratch);
    k->pixels = k->scratch = NULL;
}

/* Returns the entry of a kind and bank, or NULL if there are too many. */
static struct contrast_entry *find_entry(struct contrast *k, const struct contrast_bullet *b)
{
    int i = 0;

    while (i < k->n && (k->entry[i].bank != b->bank || strcmp(k->entry[i].kind, b->kind) != 0))
        i++;
    if (i == MAX_CONTRAST_ENTRIES || strlen(b->kind) >= sizeof k->entry[i].kind)
        return NULL;
    if (i == k->n) {
        k->n++;
        k->entry[i] = (struct contrast_entry){ .bank = b->bank };
        snprintf(k->entry[i].kind, sizeof k->entry[i].kind, "%s", b->kind);
    }
    return &k->entry[i];
}

static void add_bullet(void *context, const struct contrast_bullet *b)
{
    struct contrast *k = context;
    struct contrast_entry *contrast_entry = find_entry(k, b);

    if (contrast_entry == NULL)
        return;
    contrast_entry->total++;
    if (b->share > CONTRAST_FAINT_SHARE)
        return;
    if (contrast_entry->faint++ == 0) {
        contrast_entry->frame = k->frame;
        contrast_entry->x = b->x;
        contrast_entry->y = b->y;
    }
}

static void sample_contrast(struct run *r, uint32_t frame)
{
    struct contrast *k = &r->contrast;

    if (frame % SAMPLE_EVERY || k->samples == SAMPLES || board_last_output(r->guard.board)->fault)
        return;
    k->frame = frame;
    k->samples++;
    r->c->samples++;
    contrast_sample(r->guard.board, &k->fb, k->scratch, add_bullet, k);
}

/* Reports kinds of which most bullets have little contrast. */
static void report_contrast(struct run *r)
{
    struct contrast *k = &r->contrast;

    for (int i = 0; i < k->n; i++) {
        struct contrast_entry *l = &k->entry[i];
        if (l->reported || l->total < FEW_BULLETS || 2 * l->faint <= l->total)
            continue;
        l->reported = true;
        diagnostics_add(&r->c->found, r->name, 0,
                        "bullets \"%s\" in bank %d are hard to see: %d of %d in %d sampled frames; the "
                        "first is at %d,%d in frame %" PRIu32,
                        l->kind, l->bank, l->faint, l->total, k->samples, l->x, l->y, l->frame);
    }
}

/* ---- sections ---- */

static void play_section(struct run *r, const struct section *section)
{
    uint16_t pads[MAX_PLAYERS];
    bool over = false;

    for (uint32_t f = 0; f < SWEEP_FRAMES && !over && !board_last_output(r->guard.board)->fault; f++) {
        check_run_show_progress(r, f, SWEEP_FRAMES);
        sample_contrast(r, f);
        sweep_pads(f, pads);
        over = sweep_over(section->kind, check_run_tick(r, pads));
    }
}

/* Plays a stage or a phase with an invincible ship. */
static void run_section(struct run *r, const struct section *section)
{
    struct board_start start = check_run_start(r);

    snprintf(start.practice.section, sizeof start.practice.section, "%s", section->id);
    start.practice.invincible = true;
    if (!check_run_power_on(r, section->id, &start))
        return;
    if (contrast_open(&r->contrast, r->guard.board)) {
        play_section(r, section);
        report_contrast(r);
    } else {
        r->c->found.failed = true;
    }
    contrast_close(&r->contrast);
    check_run_finish(r);
    r->c->sections++;
}

static void run_sections(struct run *r)
{
    for (int i = 0; i < r->sections->n; i++)
        if (check_run_plays(&r->sections->section[i]))
            run_section(r, &r->sections->section[i]);
}

/* ---- a demo ---- */

/* Compares the board with the checksums of the demo. */
static bool matches_checksums(struct run *r, uint32_t frame)
{
    uint64_t hashes[MAX_PARTS];

    board_hashes_cached(r->guard.board, r->hash_cache, r->hashes);
    return demo_reorder_hashes(&r->demo, r->guard.board, r->hashes, hashes) == 0 &&
           demo_differing_parts(&r->demo, frame, hashes) == 0;
}

/* Returns whether the run agrees with the demo. A demo that ends in a fault must fault in the same way and frame. */
static bool is_as_recorded(struct run *r, uint32_t frame)
{
    const struct board_fault *fault = board_last_output(r->guard.board)->fault;
    const struct demo *d = &r->demo;

    if (fault)
        return d->fault == fault->kind && frame == d->frames;
    return matches_checksums(r, frame) && (frame < d->frames || d->fault == FAULT_NONE);
}

/* Plays the demo to its end. Returns the first frame that differs from the recording, or ALL. */
static uint32_t play(struct run *r)
{
    uint32_t last = r->demo.frames < MAX_DEMO_FRAMES ? r->demo.frames : MAX_DEMO_FRAMES, wrong = NO_FRAME;
    uint16_t pads[MAX_PLAYERS];

    for (uint32_t f = 0;; f++) {
        if (wrong == NO_FRAME && !is_as_recorded(r, f))
            wrong = f;
        sample_contrast(r, f);
        check_run_show_progress(r, f, last);
        if (f == last || board_last_output(r->guard.board)->fault)
            return wrong;
        demo_pads(&r->demo, f, pads);
        check_run_tick(r, pads);
    }
}

static void run_loaded(struct run *r)
{
    char warning[128];
    bool may_diverge = demo_replay_warning(&r->demo, &r->cart, warning, sizeof warning) != NULL;

    if (!check_run_power_on(r, r->name, &r->demo.start))
        return;
    r->hash_cache = calloc(1, board_hash_cache_size(r->guard.board));
    if (!contrast_open(&r->contrast, r->guard.board) || r->hash_cache == NULL) {
        r->c->found.failed = true;
        contrast_close(&r->contrast);
        free(r->hash_cache);
        return;
    }
    start_audio(r);
    uint32_t wrong = play(r);
    finish_audio(r);
    report_contrast(r);
    contrast_close(&r->contrast);
    free(r->hash_cache);
    if (wrong != NO_FRAME && !may_diverge)
        diagnostics_add(&r->c->found, r->name, 0,
                        "playback diverges at frame %" PRIu32 " (see curtain verify %s %s/%s)", wrong, r->c->dir,
                        r->c->dir, r->name);
    check_run_finish(r);
    r->c->demos++;
}

static void run_demo(struct run *r, const char *path)
{
    char err[512];
    uint8_t *data;
    size_t size;

    r->name = path;
    if (!check_load(r->c, path, DEMO_MAX_BYTES, &data, &size))
        return;
    bool good = demo_read(&r->demo, data, size, err, sizeof err);
    free(data);
    if (!good || !demo_check_cart(&r->demo, &r->cart, err, sizeof err))
        diagnostics_add(&r->c->found, path, 0, "%s", err);
    else if (!r->demo.complete)
        diagnostics_add(&r->c->found, path, 0, "truncated: no end mark");
    if (good && demo_check_cart(&r->demo, &r->cart, err, sizeof err))
        run_loaded(r);
    demo_free(&r->demo);
}

static bool is_demo(const char *path)
{
    size_t n = strlen(path), m = strlen(".demo");

    return strncmp(path, "demos/", 6) == 0 && n > 6 + m && strcmp(path + n - m, ".demo") == 0;
}

/* ---- all runs ---- */

static void check_memory(struct run *r)
{
    size_t room = (size_t)r->cart.manifest.lua_kib * 1024;

    r->c->lua_peak = r->lua_peak;
    if (r->lua_peak * 100 <= room * MAX_LUA_PERCENT || r->memory_fault)
        return;
    diagnostics_add(&r->c->found, "rom.lua", CHECK_LINE(r->c, "board", "lua_kib"),
                    "board.lua_kib = %d: %s used %zu KiB of it, more than %d %%; raise it to %d",
                    (int)r->cart.manifest.lua_kib, r->lua_peak_run, r->lua_peak / 1024, MAX_LUA_PERCENT,
                    (int)ram_enough_lua_kib(r->lua_peak));
}

static void count_runs(struct run *r)
{
    const struct board_start start = check_run_start(r);

    sections_list(r->sections, &r->image.rom, &start, false);
    for (int i = 0; i < r->c->files.n; i++)
        r->planned += is_demo(r->c->files.name[i]);
    r->planned += r->planned == 0; /* run_idle */
    for (int i = 0; i < r->sections->n; i++)
        r->planned += check_run_plays(&r->sections->section[i]);
    r->planned += r->sections->ships ? check_forced_count(r) : 0;
}

static void run_all(struct run *r)
{
    const struct tree *files = &r->c->files;

    count_runs(r);
    progress_begin();
    for (int i = 0; i < files->n; i++)
        if (is_demo(files->name[i]))
            run_demo(r, files->name[i]);
    if (!r->measured)
        run_idle(r);
    run_sections(r);
    if (r->boots)
        r->c->forced = check_forced_play(r);
    check_memory(r);
}

static void add_sentence(void *context, const char *sentence)
{
    struct check *c = context;

    check_rom_sentence(c, sentence);
}

/* Packs with the nearest colours, because check_art.c has reported wrong colours. */
void check_run(struct check *c)
{
    struct run *r = calloc(1, sizeof *r);
    char err[512];

    if (r == NULL) {
        c->found.failed = true;
        return;
    }
    r->c = c;
    if (!pack_folder(c->dir, true, add_sentence, c, &r->image.bytes, &r->image.size, err, sizeof err)) {
        r->image.bytes = NULL;
        check_rom_sentence(c, err);
        c->broken = true;
    } else if (!rom_open(&r->image.rom, r->image.bytes, r->image.size, err, sizeof err) ||
               !cart_open(&r->cart, &r->image.rom, err, sizeof err)) {
        check_rom_sentence(c, err);
        c->broken = true;
    } else if ((r->sections = calloc(1, sizeof *r->sections)) == NULL) {
        c->found.failed = true;
    } else {
        check_capacities(c, &r->cart);
        check_alpha(c, &r->cart);
        ram_describe(&r->cart, c->ram);
        run_all(r);
        check_text(c, &r->cart);
        check_theme(c, &r->cart);
    }
    guard_close(&r->guard);
    free(r->sections);
    rom_image_free(&r->image);
    free(r);
}

/*
 * curtain.c - the library's API (curtain.h): opening, frames, picture, sound, and facts about a run.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../base/err.h"
#include "../base/int.h"
#include "../board/inspect.h"
#include "../machine/collision/danger.h"
#include "../rom/compressed.h"
#include "lib.h"

/* ---- memory ---- */

/* A bump allocator for a block; `base` NULL: only counts bytes. */
struct arena {
    uint8_t *base;
    size_t n;
};

static void *allocate(struct arena *p, size_t size)
{
    uint8_t *out = p->base ? p->base + p->n : NULL;

    p->n += (size_t)int_align_cache_line(size);
    return out;
}

static uint32_t snapshot_count(const struct curtain_config *config)
{
    return config->snapshots == 0 ? LIB_DEFAULT_SNAPSHOTS : config->snapshots;
}

/* Lays out all memory after *c. ram_size: size of the board's RAM in bytes. */
static void lay_out(struct curtain *c, struct arena *p, const struct curtain_config *config, size_t ram_size)
{
    const struct manifest *m = &c->cart.manifest;
    const uint32_t snapshots = snapshot_count(config);
    const size_t nvram = (size_t)m->nvram_kib << 10,
                 log_size = config->state_room ? config->state_room : LIB_DEFAULT_STATE_BYTES,
                 past_size = snapshots * ram_size + ram_size / 4; /* more, so that the largest snapshot fits */

    c->ram_size = ram_size;
    c->ram = allocate(p, ram_size);
    c->backup = allocate(p, ram_size);
    c->backup_output = allocate(p, board_output_size());
    void *past = allocate(p, past_size);
    c->run_start = (struct lib_start){ .nvram = allocate(p, nvram), .nvram_cap = nvram };
    c->state_start = (struct lib_start){ .nvram = allocate(p, nvram), .nvram_cap = nvram };
    c->run_pads = (struct pads_log){ .bytes = allocate(p, log_size), .cap = log_size };
    c->state_pads = (struct pads_log){ .bytes = allocate(p, log_size), .cap = log_size };
    c->scratch = allocate(p, board_cart_scratch_size(&c->cart));
    c->sound_tables = m->has_sound ? allocate(p, board_sound_tables_size()) : NULL;
    uint8_t *pixels = allocate(p, fb_size(m->screen_w, m->screen_h));
    if (p->base) {
        fb_init(&c->fb, pixels, m->screen_w, m->screen_h);
        c->past = rewind_open(past, past_size, snapshots - snapshots / 4);
    }
}

/* Returns the size of the plain ROM in bytes, or 0 when it cannot be read. *unpack_size: bytes needed to unpack it, 0
 * if it is plain already. */
static size_t plain_size(const struct curtain_config *config, size_t *unpack_size, char *err, size_t err_size)
{
    *unpack_size = 0;
    if (!config->rom) {
        err_set(err, err_size, "rom: expected a ROM, got NULL");
        return 0;
    }
    if (!compressed_has_magic(config->rom, config->rom_size))
        return config->rom_size;
    return *unpack_size = compressed_plain_size(config->rom, config->rom_size, err, err_size);
}

size_t curtain_plain(const void *rom, size_t rom_size, void *out, size_t out_size, char *err, size_t err_size)
{
    const struct curtain_config config = { .rom = rom, .rom_size = rom_size };
    size_t unpack_size, size = plain_size(&config, &unpack_size, err, err_size);

    if (size == 0 || !out)
        return size;
    if (out_size < size) {
        err_set(err, err_size, "buffer for the plain ROM: expected %zu bytes, got %zu", size, out_size);
        return 0;
    }
    if (unpack_size == 0)
        memcpy(out, rom, size);
    else if (!compressed_unpack(rom, rom_size, out, err, err_size))
        return 0;
    return size;
}

/* Opens the plain ROM into c->rom and c->cart, and computes *total, the total memory in bytes, including `unpack_size`
 * bytes to unpack the ROM into. */
static bool open_and_measure(struct curtain *c, const struct curtain_config *config, const void *rom, size_t size,
                             size_t unpack_size, size_t *ram_size, size_t *total, char *err, size_t err_size)
{
    if (config->snapshots > LIB_MAX_SNAPSHOTS)
        return err_set(err, err_size, "snapshots: expected at most %d, got %lu", LIB_MAX_SNAPSHOTS,
                       (unsigned long)config->snapshots);
    if (config->state_room > SIZE_MAX / 4)
        return err_set(err, err_size, "state_room: too large");
    if (!rom_open(&c->rom, rom, size, err, err_size) || !cart_open(&c->cart, &c->rom, err, err_size) ||
        !board_size(&c->rom, ram_size, err, err_size))
        return false;
    struct curtain dry_run = *c;
    struct arena p = { NULL, 0 };
    const uint64_t snapshot_bytes = (uint64_t)*ram_size * ((uint64_t)snapshot_count(config) + 3);
    if (snapshot_bytes > SIZE_MAX / 2)
        return err_set(err, err_size, "snapshots: too many for the address space");
    allocate(&p, sizeof *c);
    allocate(&p, unpack_size);
    lay_out(&dry_run, &p, config, *ram_size);
    *total = p.n + LIB_ALIGN; /* the block may start at any address */
    return true;
}

size_t curtain_memory(const struct curtain_config *config, char *err, size_t err_size)
{
    struct curtain c;
    size_t ram_size, total = 0, unpack_size, size = plain_size(config, &unpack_size, err, err_size);
    void *plain = unpack_size > 0 ? malloc(unpack_size) : NULL;

    memset(&c, 0, sizeof c);
    if (unpack_size > 0 && !plain)
        err_set(err, err_size, "out of memory (%zu bytes for the plain ROM)", unpack_size);
    else if (size > 0 && (!plain || compressed_unpack(config->rom, config->rom_size, plain, err, err_size)) &&
             !open_and_measure(&c, config, plain ? plain : config->rom, size, unpack_size, &ram_size, &total, err,
                               err_size))
        total = 0;
    free(plain);
    return total;
}

bool lib_power_on(struct curtain *c, char *err, size_t err_size)
{
    c->board = board_power_on(c->ram, c->ram_size, &c->rom, &c->run_start.start, err, err_size);
    c->drawn = c->mixed = false;
    return c->board != NULL;
}

static struct curtain *refuse_memory(const struct curtain_config *config, const void *memory, size_t size, char *err,
                                     size_t err_size)
{
    const size_t need = curtain_memory(config, err, err_size);

    if (need > 0)
        err_set(err, err_size, "memory: expected %zu bytes, got %zu", need, memory ? size : 0);
    return NULL;
}

struct curtain *curtain_open(const struct curtain_config *config, void *memory, size_t size, char *err, size_t err_size)
{
    struct curtain *c = (struct curtain *)(uintptr_t)int_align_cache_line((uintptr_t)memory);
    struct arena p = { (uint8_t *)c, 0 };
    size_t ram_size, need = SIZE_MAX, unpack_size, rom_size = plain_size(config, &unpack_size, err, err_size);
    const void *rom = config->rom;

    if (rom_size == 0)
        return NULL;
    allocate(&p, sizeof *c);
    void *plain = allocate(&p, unpack_size);
    if (!memory || size < p.n + LIB_ALIGN)
        return refuse_memory(config, memory, size, err, err_size);
    if (unpack_size > 0) {
        if (!compressed_unpack(rom, config->rom_size, plain, err, err_size))
            return NULL;
        rom = plain;
    }
    memset(c, 0, sizeof *c);
    if (!open_and_measure(c, config, rom, rom_size, unpack_size, &ram_size, &need, err, err_size))
        return NULL;
    if (size < need)
        return refuse_memory(config, memory, size, err, err_size);
    c->game_hash = rom_game_hash(&c->rom);
    lay_out(c, &p, config, ram_size);
    const bool has_demo = config->demo != NULL;
    if (has_demo && !demo_read(&c->demo, config->demo, config->demo_size, err, err_size))
        return NULL;
    if (!lib_start_init(&c->run_start, &c->cart, config, has_demo ? &c->demo : NULL, err, err_size) ||
        !lib_power_on(c, err, err_size)) {
        demo_free(&c->demo);
        return NULL;
    }
    board_nvram(c->board, &(size_t){ 0 }, &c->nvram_writes);
    pads_log_begin(&c->run_pads, c->run_start.hash);
    if (c->sound_tables)
        board_sound_init_tables(c->sound_tables);
    return c;
}

void curtain_close(struct curtain *c)
{
    if (!c)
        return;
    demo_free(&c->demo);
    c->board = NULL;
}

/* ---- frames ---- */

static unsigned collect_events(struct curtain *c)
{
    const struct board_out *out = board_last_output(c->board);
    uint32_t writes;
    size_t size;
    unsigned events = out->fault ? CURTAIN_FAULT : 0;

    board_nvram(c->board, &size, &writes);
    if (writes != c->nvram_writes || c->nvram_changed)
        events |= CURTAIN_SAVED;
    c->nvram_writes = writes;
    c->nvram_changed = false;
    events |= out->log_size > 0 ? CURTAIN_LOG : 0;
    const struct inspect_pause pause = inspect_pause(c->board);
    events |= out->key_hint_count && !pause.is_listening ? CURTAIN_MENU : 0;
    for (int p = 0; p < MAX_PLAYERS; p++)
        events |= pause.is_listening && pause.in_play[p] ? (unsigned)CURTAIN_RUN_1 << p : 0;
    events |= out->request == REQUEST_QUIT ? CURTAIN_QUIT : 0;
    events |= out->request == REQUEST_ATTRACT ? CURTAIN_ATTRACT : 0;
    events |= c->demo.frames > 0 && c->run_pads.frames >= c->demo.frames ? CURTAIN_ENDED : 0;
    return events | (out->request == REQUEST_HOST_SCREEN ? CURTAIN_ASK : 0);
}

unsigned curtain_frame(struct curtain *c, const uint16_t pads[CURTAIN_PADS])
{
    uint16_t held[MAX_PLAYERS];

    if (board_last_output(c->board)->fault)
        return CURTAIN_FAULT;
    if (!pads)
        demo_pads(&c->demo, c->run_pads.frames, held);
    for (int i = 0; i < MAX_PLAYERS; i++) {
        held[i] = (pads ? pads : held)[i];
        held[i] = pad_is_valid(held[i]) ? held[i] : held[i] & PAD_ALL;
    }
    lib_take_key_snapshot(c);
    board_tick(c->board, held);
    pads_log_add(&c->run_pads, held);
    c->drawn = c->mixed = false;
    return collect_events(c);
}

void curtain_interrupt(struct curtain *c)
{
    (void)c; /* no-op, for old hosts; see curtain.h */
}

const char *curtain_attract(const struct curtain *c)
{
    const struct board_out *out = board_last_output(c->board);

    return out->request == REQUEST_ATTRACT ? out->attract : "";
}

const void *curtain_attract_demo(const struct curtain *c, size_t *size)
{
    char name[128];
    struct lump lump = { .size = 0 };
    int i = -1;

    if (snprintf(name, sizeof name, "demo/%s", curtain_attract(c)) < (int)sizeof name)
        i = rom_find(&c->rom, name);
    if (i >= 0)
        rom_lump(&c->rom, i, &lump);
    *size = lump.size;
    return lump.data;
}

const char *curtain_asked(const struct curtain *c)
{
    static const char *const names[HOST_SCREENS] = { "settings", "replays", "practice", "keys", "quit" };
    const struct board_out *out = board_last_output(c->board);

    return out->request == REQUEST_HOST_SCREEN ? names[out->host_screen] : "";
}

const char *curtain_log(const struct curtain *c)
{
    const struct board_out *out = board_last_output(c->board);
    struct curtain *writable = (struct curtain *)c; /* changes only the text buffer, which is not part of the state */
    const size_t n = out->log_size < sizeof writable->log_text ? out->log_size : sizeof writable->log_text - 1;

    if (n > 0)
        memcpy(writable->log_text, out->log, n);
    writable->log_text[n] = 0;
    return writable->log_text;
}

const char *curtain_fault(const struct curtain *c)
{
    const struct board_fault *fault = board_last_output(c->board)->fault;
    struct curtain *writable = (struct curtain *)c;

    if (!fault)
        return "";
    snprintf(writable->fault, sizeof writable->fault, "%s\n%s", fault->message, fault->trace);
    return writable->fault;
}

/* ---- picture and sound ---- */

int curtain_width(const struct curtain *c)
{
    return c->fb.w;
}

int curtain_height(const struct curtain *c)
{
    return c->fb.h;
}

static void draw(struct curtain *c)
{
    if (c->drawn)
        return;
    board_draw(c->board, NULL, &c->fb, c->rgb, c->scratch);
    for (int y = 0; y < c->fb.h; y++) /* pack the rows in place: w bytes apart instead of pitch */
        memmove(c->fb.pix + (size_t)y * (size_t)c->fb.w, c->fb.pix + (size_t)y * (size_t)c->fb.pitch, (size_t)c->fb.w);
    c->drawn = true;
}

const uint8_t *curtain_picture(struct curtain *c)
{
    draw(c);
    return c->fb.pix;
}

const uint32_t *curtain_palette(struct curtain *c)
{
    draw(c);
    return c->rgb;
}

size_t curtain_sound(struct curtain *c, int16_t *lr, size_t frames)
{
    if (!c->mixed) {
        if (c->sound_tables)
            board_mix_sound(c->board, c->sound_tables, c->lr);
        c->mixed = true;
        c->frames_read = 0;
    }
    const size_t left = BOARD_SOUND_FRAMES - c->frames_read, n = frames < left ? frames : left;
    memcpy(lr, c->lr + 2 * c->frames_read, n * 2 * sizeof *lr);
    c->frames_read += n;
    return n;
}

/* ---- the game and the run ---- */

int curtain_core(void)
{
    return CORE_VERSION;
}

const char *curtain_title(const struct curtain *c)
{
    return c->cart.manifest.title;
}

const char *curtain_id(const struct curtain *c)
{
    return c->cart.manifest.id;
}

int curtain_players(const struct curtain *c)
{
    return c->cart.manifest.players;
}

const char *curtain_difficulty(const struct curtain *c, int i)
{
    const struct manifest *m = &c->cart.manifest;

    return m->n_difficulties == 0 || i >= m->n_difficulties ? NULL : m->difficulties[i < 0 ? m->difficulty : i];
}

/* Writes the k-th value of a switch to out; returns false when there is none. */
static bool write_switch_value(const struct dip *dip, int32_t k, char *out, size_t size)
{
    if (k < 0 || (dip->is_number ? k > dip->hi - dip->lo : k >= dip->n_values))
        return false;
    if (dip->is_number)
        snprintf(out, size, "%d", (int)(dip->lo + k));
    else
        snprintf(out, size, "%s", dip->value_name[k]);
    return true;
}

bool curtain_switches(const struct curtain *c, int i, struct curtain_switch *out)
{
    const struct manifest *m = &c->cart.manifest;

    if (i < 0 || i >= m->n_dips)
        return false;
    const struct dip *dip = &m->dips[i];
    memcpy(out->name, dip->name, sizeof out->name);
    return write_switch_value(dip, c->run_start.start.dip[i] - (dip->is_number ? dip->lo : 0), out->value,
                              sizeof out->value);
}

bool curtain_switch_value(const struct curtain *c, int i, int k, char *value, size_t size)
{
    return i >= 0 && i < c->cart.manifest.n_dips && write_switch_value(&c->cart.manifest.dips[i], k, value, size);
}

uint32_t curtain_demo_frames(const struct curtain *c)
{
    return c->demo.frames;
}

uint32_t curtain_frames(const struct curtain *c)
{
    return board_frame(c->board);
}

uint64_t curtain_hash(const struct curtain *c)
{
    return board_hash(c->board);
}

const void *curtain_nvram(const struct curtain *c, size_t *size)
{
    uint32_t writes;

    return board_nvram(c->board, size, &writes);
}

size_t curtain_nvram_room(const struct curtain *c)
{
    return c->run_start.nvram_cap;
}

bool curtain_ship(const struct curtain *c, int i, struct curtain_ship *out)
{
    enum { UNIT = FX_ONE / 256 };
    struct danger_ship ship = { .in_game = false };

    if (i >= 0 && i < MAX_PLAYERS)
        danger_get_ship(c->board, i, &ship);
    *out = (struct curtain_ship){ .steers = false };
    if (!ship.in_game)
        return false;
    *out = (struct curtain_ship){ .steers = ship.can_steer,
                                  .x = ship.path.x / UNIT,
                                  .y = ship.path.y / UNIT,
                                  .speed = ship.speed / UNIT,
                                  .slow = ship.focused_speed / UNIT,
                                  .left = ship.area.x0 / UNIT,
                                  .top = ship.area.y0 / UNIT,
                                  .right = ship.area.x1 / UNIT,
                                  .bottom = ship.area.y1 / UNIT };
    return true;
}

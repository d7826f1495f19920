/*
 * curtain.c - the library's API (curtain.h): opening, frames, picture, sound, and facts about a run.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../base/err.h"
#include "../machine/collision/danger.h"
#include "../rom/compressed.h"
#include "lib.h"

static uint8_t *aligned(uint8_t *p)
{
    return (uint8_t *)(((uintptr_t)p + LIB_ALIGN - 1) & ~(uintptr_t)(LIB_ALIGN - 1));
}

/* ---- memory ---- */

/* A bump allocator for a block; `at` NULL: only counts bytes. */
struct pieces {
    uint8_t *at;
    size_t n;
};

static void *piece(struct pieces *p, size_t size)
{
    uint8_t *out = p->at ? p->at + p->n : NULL;

    p->n += (size + LIB_ALIGN - 1) / LIB_ALIGN * LIB_ALIGN;
    return out;
}

static uint32_t snapshots_of(const struct curtain_config *config)
{
    return config->snapshots == 0 ? LIB_SNAPSHOTS : config->snapshots;
}

/* Lays out all memory after *c. board: size of the board's RAM in bytes. */
static void lay_out(struct curtain *c, struct pieces *p, const struct curtain_config *config, size_t board)
{
    const struct manifest *m = &c->cart.m;
    const size_t nvram = (size_t)m->nvram_kib << 10, room = config->state_room ? config->state_room : LIB_STATE_ROOM;

    c->n = snapshots_of(config);
    c->keys = c->n / 4;
    c->ram_size = board;
    c->ram = piece(p, board);
    c->before = piece(p, board);
    c->before_out = piece(p, board_output_size());
    c->snapshot = piece(p, c->n * sizeof *c->snapshot);
    for (uint32_t i = 0; i < c->n; i++) {
        uint8_t *at = piece(p, board);
        if (p->at)
            c->snapshot[i] = (struct lib_snapshot){ .at = at };
    }
    c->begin = (struct lib_start){ .nvram = piece(p, nvram), .room = nvram };
    c->spare = (struct lib_start){ .nvram = piece(p, nvram), .room = nvram };
    c->log = (struct pads_log){ .bytes = piece(p, room), .room = room };
    c->other = (struct pads_log){ .bytes = piece(p, room), .room = room };
    c->scratch = piece(p, board_scratch_of(&c->cart));
    c->tables = m->sound ? piece(p, board_sound_tables()) : NULL;
    uint8_t *pixels = piece(p, fb_size(m->screen_w, m->screen_h));
    if (p->at)
        fb_init(&c->fb, pixels, m->screen_w, m->screen_h);
}

/* Returns the size of the plain ROM in bytes, or 0 when it cannot be read. *room: bytes needed to unpack it, 0 if it is
 * plain already. */
static size_t plain_size(const struct curtain_config *config, size_t *room, char *err, size_t err_size)
{
    *room = 0;
    if (!config->rom) {
        err_set(err, err_size, "rom: expected a ROM, got NULL");
        return 0;
    }
    if (!compressed_is(config->rom, config->rom_size))
        return config->rom_size;
    return *room = compressed_size(config->rom, config->rom_size, err, err_size);
}

size_t curtain_plain(const void *rom, size_t rom_size, void *out, size_t room, char *err, size_t err_size)
{
    const struct curtain_config config = { .rom = rom, .rom_size = rom_size };
    size_t packed, size = plain_size(&config, &packed, err, err_size);

    if (size == 0 || !out)
        return size;
    if (room < size) {
        err_set(err, err_size, "buffer for the plain ROM: expected %zu bytes, got %zu", size, room);
        return 0;
    }
    if (packed == 0)
        memcpy(out, rom, size);
    else if (!compressed_read(rom, rom_size, out, err, err_size))
        return 0;
    return size;
}

/* Opens the plain ROM into c->rom and c->cart, and computes *all, the total memory in bytes, including `room` bytes to
 * unpack the ROM into. */
static bool look_at(struct curtain *c, const struct curtain_config *config, const void *rom, size_t size, size_t room,
                    size_t *board, size_t *all, char *err, size_t err_size)
{
    if (config->snapshots > LIB_MOST_SNAPSHOTS)
        return err_set(err, err_size, "snapshots: expected at most %d, got %lu", LIB_MOST_SNAPSHOTS,
                       (unsigned long)config->snapshots);
    if (config->state_room > SIZE_MAX / 4)
        return err_set(err, err_size, "state_room: too large");
    if (!rom_open(&c->rom, rom, size, err, err_size) || !cart_open(&c->cart, &c->rom, err, err_size) ||
        !board_size(&c->rom, board, err, err_size))
        return false;
    struct curtain as_if = *c;
    struct pieces p = { NULL, 0 };
    const uint64_t slots = (uint64_t)*board * ((uint64_t)snapshots_of(config) + 2);
    if (slots > SIZE_MAX / 2)
        return err_set(err, err_size, "snapshots: too many for the address space");
    piece(&p, sizeof *c);
    piece(&p, room);
    lay_out(&as_if, &p, config, *board);
    *all = p.n + LIB_ALIGN; /* the block may start at any address */
    return true;
}

size_t curtain_memory(const struct curtain_config *config, char *err, size_t err_size)
{
    struct curtain c;
    size_t board, all = 0, room, size = plain_size(config, &room, err, err_size);
    void *plain = room > 0 ? malloc(room) : NULL;

    memset(&c, 0, sizeof c);
    if (room > 0 && !plain)
        err_set(err, err_size, "out of memory (%zu bytes for the plain ROM)", room);
    else if (size > 0 && (!plain || compressed_read(config->rom, config->rom_size, plain, err, err_size)) &&
             !look_at(&c, config, plain ? plain : config->rom, size, room, &board, &all, err, err_size))
        all = 0;
    free(plain);
    return all;
}

bool lib_power(struct curtain *c, char *err, size_t err_size)
{
    c->board = board_power(c->ram, c->ram_size, &c->rom, &c->begin.start, err, err_size);
    c->drawn = c->sounding = false;
    if (!c->board)
        return false;
    return true;
}

static struct curtain *too_little(const struct curtain_config *config, const void *memory, size_t size, char *err,
                                  size_t err_size)
{
    const size_t need = curtain_memory(config, err, err_size);

    if (need > 0)
        err_set(err, err_size, "memory: expected %zu bytes, got %zu", need, memory ? size : 0);
    return NULL;
}

struct curtain *curtain_open(const struct curtain_config *config, void *memory, size_t size, char *err, size_t err_size)
{
    struct curtain *c = (struct curtain *)aligned(memory);
    struct pieces p = { (uint8_t *)c, 0 };
    size_t board, need = SIZE_MAX, room, rom_size = plain_size(config, &room, err, err_size);
    const void *rom = config->rom;

    if (rom_size == 0)
        return NULL;
    piece(&p, sizeof *c);
    void *plain = piece(&p, room);
    if (!memory || size < p.n + LIB_ALIGN)
        return too_little(config, memory, size, err, err_size);
    if (room > 0) {
        if (!compressed_read(rom, config->rom_size, plain, err, err_size))
            return NULL;
        rom = plain;
    }
    memset(c, 0, sizeof *c);
    if (!look_at(c, config, rom, rom_size, room, &board, &need, err, err_size))
        return NULL;
    if (size < need)
        return too_little(config, memory, size, err, err_size);
    c->game_hash = rom_game_hash(&c->rom);
    lay_out(c, &p, config, board);
    const bool plays = config->demo != NULL;
    if (plays && !demo_read(&c->demo, config->demo, config->demo_size, err, err_size))
        return NULL;
    if (!lib_start_of(&c->begin, &c->cart, config, plays ? &c->demo : NULL, err, err_size) ||
        !lib_power(c, err, err_size)) {
        demo_free(&c->demo);
        return NULL;
    }
    board_nvram(c->board, &(size_t){ 0 }, &c->writes);
    pads_log_begin(&c->log, c->begin.hash);
    if (c->tables)
        board_sound_open(c->tables);
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

static unsigned events_of(struct curtain *c)
{
    const struct board_out *out = board_last(c->board);
    uint32_t writes;
    size_t size;
    unsigned events = out->fault ? CURTAIN_FAULT : 0;

    board_nvram(c->board, &size, &writes);
    if (writes != c->writes || c->saved)
        events |= CURTAIN_SAVED;
    c->writes = writes;
    c->saved = false;
    events |= out->log_size > 0 ? CURTAIN_LOG : 0;
    events |= out->menu ? CURTAIN_MENU : 0;
    events |= out->request == REQUEST_QUIT ? CURTAIN_QUIT : 0;
    events |= out->request == REQUEST_ATTRACT ? CURTAIN_ATTRACT : 0;
    events |= c->demo.frames > 0 && c->log.frames >= c->demo.frames ? CURTAIN_ENDED : 0;
    return events | (out->request == REQUEST_ASK ? CURTAIN_ASK : 0);
}

unsigned curtain_frame(struct curtain *c, const uint16_t pads[CURTAIN_PADS])
{
    uint16_t held[PADS];

    if (board_last(c->board)->fault)
        return CURTAIN_FAULT;
    if (!pads)
        demo_pads(&c->demo, c->log.frames, held);
    for (int i = 0; i < PADS; i++)
        held[i] = (pads ? pads : held)[i] & PAD_ALL;
    lib_keep_key(c);
    board_tick(c->board, held);
    pads_log_add(&c->log, held);
    c->drawn = c->sounding = false;
    return events_of(c);
}

void curtain_interrupt(struct curtain *c)
{
    (void)c; /* no-op, for old hosts; see curtain.h */
}

const char *curtain_attract(const struct curtain *c)
{
    const struct board_out *out = board_last(c->board);

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
    static const char *const names[ASKS] = { "settings", "replays", "practice", "keys" };
    const struct board_out *out = board_last(c->board);

    return out->request == REQUEST_ASK ? names[out->ask] : "";
}

const char *curtain_log(const struct curtain *c)
{
    const struct board_out *out = board_last(c->board);
    struct curtain *to = (struct curtain *)c; /* changes only the text buffer, which is not part of the state */
    const size_t n = out->log_size < sizeof to->log_text ? out->log_size : sizeof to->log_text - 1;

    if (n > 0)
        memcpy(to->log_text, out->log, n);
    to->log_text[n] = 0;
    return to->log_text;
}

const char *curtain_fault(const struct curtain *c)
{
    const struct board_fault *fault = board_last(c->board)->fault;
    struct curtain *to = (struct curtain *)c;

    if (!fault)
        return "";
    snprintf(to->fault, sizeof to->fault, "%s\n%s", fault->message, fault->trace);
    return to->fault;
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
    if (!c->sounding) {
        if (c->tables)
            board_sound(c->board, c->tables, c->lr);
        c->sounding = true;
        c->taken = 0;
    }
    const size_t left = BOARD_SOUND - c->taken, n = frames < left ? frames : left;
    memcpy(lr, c->lr + 2 * c->taken, n * 2 * sizeof *lr);
    c->taken += n;
    return n;
}

/* ---- the game and the run ---- */

int curtain_core(void)
{
    return CORE_VERSION;
}

const char *curtain_title(const struct curtain *c)
{
    return c->cart.m.title;
}

const char *curtain_id(const struct curtain *c)
{
    return c->cart.m.id;
}

int curtain_players(const struct curtain *c)
{
    return c->cart.m.players;
}

const char *curtain_difficulty(const struct curtain *c, int i)
{
    const struct manifest *m = &c->cart.m;

    return m->n_difficulties == 0 || i >= m->n_difficulties ? NULL : m->difficulties[i < 0 ? m->difficulty : i];
}

/* Writes the k-th value of a switch to out; returns false when there is none. */
static bool word_of(const struct dip *dip, int32_t k, char *out, size_t size)
{
    if (k < 0 || (dip->number ? k > dip->hi - dip->lo : k >= dip->values))
        return false;
    if (dip->number)
        snprintf(out, size, "%d", (int)(dip->lo + k));
    else
        snprintf(out, size, "%s", dip->value_name[k]);
    return true;
}

bool curtain_switches(const struct curtain *c, int i, struct curtain_switch *out)
{
    const struct manifest *m = &c->cart.m;

    if (i < 0 || i >= m->n_dips)
        return false;
    const struct dip *dip = &m->dips[i];
    memcpy(out->name, dip->name, sizeof out->name);
    return word_of(dip, c->begin.start.dip[i] - (dip->number ? dip->lo : 0), out->value, sizeof out->value);
}

bool curtain_switch_value(const struct curtain *c, int i, int k, char *value, size_t size)
{
    return i >= 0 && i < c->cart.m.n_dips && word_of(&c->cart.m.dips[i], k, value, size);
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
    return c->begin.room;
}

bool curtain_ship(const struct curtain *c, int i, struct curtain_ship *out)
{
    enum { UNIT = FX_ONE / 256 };
    struct danger_ship ship = { .in = false };

    if (i >= 0 && i < PADS)
        danger_ship(c->board, i, &ship);
    *out = (struct curtain_ship){ .steers = false };
    if (!ship.in)
        return false;
    *out = (struct curtain_ship){ .steers = ship.steers,
                                  .x = ship.way.x / UNIT,
                                  .y = ship.way.y / UNIT,
                                  .speed = ship.speed / UNIT,
                                  .slow = ship.focus / UNIT,
                                  .left = ship.area.x0 / UNIT,
                                  .top = ship.area.y0 / UNIT,
                                  .right = ship.area.x1 / UNIT,
                                  .bottom = ship.area.y1 / UNIT };
    return true;
}

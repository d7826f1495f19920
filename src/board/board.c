/*
 * board.c - power, RAM, the tick order, hashes and snapshots.
 */
#include "machine.h"
#include <assert.h>
#include <stdio.h>
#include <string.h>
#include "../base/hash.h"
#include "../base/ieee.h"
#include "events_run.h"
#include "hit.h"
#include "lasers_run.h"
#include "options_run.h"
#include "sound.h"
#include "../base/host.h"

static const struct column core_columns[] = {
    REGISTER(core, frame),      REGISTER(core, clock),
    REGISTER(core, difficulty), REGISTERS(core, random),
    REGISTER(core, frozen),     REGISTER(core, notes),
    REGISTERS(core, extended),  REGISTER(core, over),
    REGISTER(core, since),      REGISTERS(core, continues),
    REGISTERS(core, continued), DERIVED_REGISTER(core, drawn, "the number of random values drawn since the seed"),
};
static const struct column script_columns[] = { REGISTER(script, digest), REGISTER(script, calls) };

static const struct chip core_chip = { "board", core_columns, sizeof core_columns / sizeof *core_columns, true, false };
static const struct chip script_chip = { "script", script_columns, sizeof script_columns / sizeof *script_columns, true,
                                         false };

enum { A_STEP = 8 /* work: a motion step */ };
enum { MAX_PLAYER_KINDS = 64, MAX_ITEM_KINDS = 256, MAX_OPTION_KINDS = 64 };

/* The first n groups of values. */
static uint32_t value_groups(int32_t n)
{
    return SLOTS_GROUP(GROUP_VALUE + n) - SLOTS_GROUP(GROUP_VALUE);
}

/* The groups of columns that manifest m asks for. */
static uint32_t bullet_groups(const struct manifest *m)
{
    return value_groups(m->bullet_values) | (m->hp ? SLOTS_GROUP(GROUP_HP) : 0) |
           (m->around ? SLOTS_GROUP(GROUP_AROUND) : 0) | (m->frozen ? SLOTS_GROUP(GROUP_FROZEN) : 0) |
           (m->meet ? SLOTS_GROUP(GROUP_MEET) : 0);
}

static uint32_t shot_groups(const struct manifest *m)
{
    return value_groups(m->shot_values) | (m->around ? SLOTS_GROUP(GROUP_AROUND) : 0) |
           (m->frozen ? SLOTS_GROUP(GROUP_FROZEN) : 0) | (m->pierce ? SLOTS_GROUP(GROUP_PIERCE) : 0);
}

static uint32_t enemy_groups(const struct manifest *m)
{
    return value_groups(m->enemy_values) | (m->frozen ? SLOTS_GROUP(GROUP_FROZEN) : 0) |
           (m->bodies ? SLOTS_GROUP(GROUP_BODIES) : 0);
}

static uint32_t laser_groups(const struct manifest *m)
{
    return (m->around ? SLOTS_GROUP(GROUP_AROUND) : 0) | (m->frozen ? SLOTS_GROUP(GROUP_FROZEN) : 0);
}

/* The parts, in the order of struct board, of RAM, of the hashes and of demos. A line: the chip, the member of struct
 * board, the number of slots, and the groups of columns, by manifest m. */
#define PART_LIST(PART)                                                                                                \
    PART(script_chip, script, 0, 0)                                                                                    \
    PART(core_chip, core, 0, 0)                                                                                        \
    PART(input_chip, input, PADS, 0)                                                                                   \
    PART(tasks_chip, tasks, m->tasks, 0)                                                                               \
    PART(bullets_chip, bullets, m->bullets, bullet_groups(m))                                                          \
    PART(bullet_kinds_chip, bullet_kinds, m->bullets ? MAX_KINDS : 0, bullet_groups(m))                                \
    PART(shots_chip, shots, m->shots, shot_groups(m))                                                                  \
    PART(shot_kinds_chip, shot_kinds, m->shots ? MAX_KINDS : 0, shot_groups(m))                                        \
    PART(enemies_chip, enemies, m->enemies, enemy_groups(m))                                                           \
    PART(enemy_kinds_chip, enemy_kinds, m->enemies ? MAX_KINDS : 0, enemy_groups(m))                                   \
    PART(player_chip, player, PADS, 0)                                                                                 \
    PART(player_kinds_chip, player_kinds, MAX_PLAYER_KINDS, m->items ? SLOTS_GROUP(GROUP_ITEMS) : 0)                   \
    PART(motions_chip, motions, m->motions, 0)                                                                         \
    PART(steps_chip, steps, MOTION_STEPS * m->motions, 0)                                                              \
    PART(sprites_chip, sprites, m->sprites, 0)                                                                         \
    PART(fix_chip, fix, m->screen_w / FIX_CELL * (m->screen_h / FIX_CELL), m->wide ? SLOTS_GROUP(FIX_WIDE) : 0)        \
    PART(pal_chip, pal, COLOURS, 0)                                                                                    \
    PART(nvram_chip, nvram, m->nvram_kib * 1024, 0)                                                                    \
    PART(sparks_chip, sparks, m->sparks, 0)                                                                            \
    PART(spark_kinds_chip, spark_kinds, m->sparks ? MAX_KINDS : 0, 0)                                                  \
    PART(items_chip, items, m->items, m->frozen ? SLOTS_GROUP(GROUP_FROZEN) : 0)                                       \
    PART(item_kinds_chip, item_kinds, m->items ? MAX_ITEM_KINDS : 0, 0)                                                \
    PART(lines_chip, lines, m->lines, 0)                                                                               \
    PART(bg_chip, bg, m->bg ? BG_SLOTS : 0, 0)                                                                         \
    PART(bg_lines_chip, bg_lines, m->bg ? BG_LAYERS * m->field_h : 0, 0)                                               \
    PART(bg_shades_chip, bg_shades, m->bg ? BG_TABLES : 0, 0)                                                          \
    PART(screen_chip, screen, 0, 0)                                                                                    \
    PART(lasers_chip, lasers, m->lasers, 0)                                                                            \
    PART(laser_heads_chip, laser_heads, m->lasers, laser_groups(m))                                                    \
    PART(laser_kinds_chip, laser_kinds, m->lasers ? MAX_LASER_KINDS : 0, 0)                                            \
    PART(laser_points_chip, laser_points, m->lasers ? (m->curve_points + LASER_PIECE - 1) / LASER_PIECE : 0, 0)        \
    PART(registers_chip, registers, m->registers, 0)                                                                   \
    PART(options_chip, options, m->options, 0)                                                                         \
    PART(option_kinds_chip, option_kinds, m->options ? MAX_OPTION_KINDS : 0, 0)                                        \
    PART(option_ways_chip, option_ways, m->options ? PADS : 0, 0)                                                      \
    PART(seq_chip, music, m->sound ? SEQ_SLOTS : 0, 0)                                                                 \
    PART(cues_chip, cues, m->sound ? CUES : 0, 0)                                                                      \
    PART(voices_chip, voices, m->sound ? VOICE_ROOM : 0, 0)                                                            \
    PART(ml_roots_chip, ml_roots, int_min(m->bulletml, ML_ROOTS), 0)                                                   \
    PART(ml_runners_chip, ml_runners, m->bulletml, 0)                                                                  \
    PART(ml_frames_chip, ml_frames, ML_FRAMES * m->bulletml, 0)                                                        \
    PART(ml_params_chip, ml_params, m->bulletml, 0)

#define AS_PART(chip, name, slots, groups)     { &chip, offsetof(struct board, name), sizeof((struct board *)0)->name },
#define AS_CAPACITY(chip, name, slots, groups) (uint32_t)(slots),
#define AS_GROUPS(chip, name, slots, groups)   (uint32_t)(groups),
#define AS_ONE(chip, name, slots, groups)      +1
const struct part machine_parts[PARTS] = { PART_LIST(AS_PART) };
_Static_assert(PART_LIST(AS_ONE) == PARTS, "PART_LIST must have PARTS lines");

enum { RAM_ALIGN = 64 };
#ifndef MAX_RAM /* tests lower it */
#define MAX_RAM (1ull << 30)
#endif

static void *chip_at(const struct board *b, int i)
{
    return (uint8_t *)(uintptr_t)b + machine_parts[i].at;
}

static uint64_t aligned(uint64_t n)
{
    return (n + RAM_ALIGN - 1) / RAM_ALIGN * RAM_ALIGN;
}

/* What each part has room for. */
struct layout {
    uint32_t cap[PARTS], groups[PARTS];
};

static struct layout layout_of(const struct manifest *m)
{
    return (struct layout){ { PART_LIST(AS_CAPACITY) }, { PART_LIST(AS_GROUPS) } };
}

/* A bullet may graze or hit both players, be blocked and, where they do, meet another, a shot hits one thing, or as
 * many as it can go through, an enemy may touch, die and leave, an item is taken once and may give lives, a laser may
 * graze or hit both players, or shoot, and a document may tell of each bullet that it fires. */
static uint64_t event_room(const struct manifest *m)
{
    return (m->meet ? 4 : 3) * (uint64_t)m->bullets + (m->pierce ? PIERCED : 1) * (uint64_t)m->shots +
           8 * (uint64_t)m->enemies + 2 * (uint64_t)m->items + 2 * (uint64_t)m->lasers +
           (m->bulletml ? (uint64_t)m->bullets : 0) + 1024;
}

/* What documents fire in a frame. */
static uint32_t fresh_room(const struct manifest *m)
{
    return m->bulletml ? (uint32_t)m->bullets : 0;
}

uint64_t board_room(const struct cart *cart)
{
    const struct layout l = layout_of(&cart->m);
    uint64_t sum = aligned(sizeof(struct board)) + aligned(sizeof(struct output));

    for (int i = 0; i < PARTS; i++)
        sum += slots_size(machine_parts[i].chip, l.cap[i], l.groups[i]);
    sum += aligned((uint64_t)cart->sprites * sizeof(struct sprite));
    sum += aligned(events_size((uint32_t)event_room(&cart->m)));
    sum += aligned(fresh_room(&cart->m) * sizeof(struct ml_fired));
    return sum + aligned((uint64_t)cart->m.lua_kib * 1024) + RAM_ALIGN;
}

/* board_size, of a cart that it opens. */
static bool open_cart(struct cart *cart, const struct rom *rom, size_t *size, char *err, size_t err_size)
{
    memset(cart, 0, sizeof *cart); /* it goes into RAM */
    if (!cart_open(cart, rom, err, err_size))
        return false;
    uint64_t sum = board_room(cart);
    if (sum > MAX_RAM) {
        snprintf(err, err_size, "the capacities in rom.lua need %llu MiB of RAM (at most %llu); lower them",
                 (unsigned long long)(sum + 0xfffff) >> 20, MAX_RAM >> 20);
        return false;
    }
    *size = (size_t)sum;
    return true;
}

bool board_size(const struct rom *rom, size_t *size, char *err, size_t err_size)
{
    struct cart cart;

    return open_cart(&cart, rom, size, err, err_size);
}

static fx pixels(int v)
{
    return (fx)(v * 65536);
}

static void set_up(struct board *b)
{
    const struct manifest *m = &b->cart.m;
    struct rng r;

    b->keep = (struct box){ pixels(-m->margin), pixels(-m->margin), pixels(m->field_w + m->margin),
                            pixels(m->field_h + m->margin) };
    b->area = (struct box){ pixels(8), pixels(8), pixels(m->field_w - 8), pixels(m->field_h - 8) };
    for (int i = 0; i < b->cart.sprites; i++)
        cart_sprite(&b->cart, i, &b->pictures[i]);
    rng_seed(&r, b->start.seed);
    memcpy(b->core.random, r.s, sizeof r.s);
    rng_seed(&r, b->start.seed ^ 0x537061726b73u); /* "Sparks" */
    memcpy(b->sparks.stream, r.s, sizeof r.s);
    b->core.difficulty = (uint32_t)(b->start.difficulty < 0 ? m->difficulty : b->start.difficulty);
    b->script.digest = HASH_START;
    b->fix.cols = (uint32_t)m->screen_w / FIX_CELL;
    b->fix.rows = (uint32_t)m->screen_h / FIX_CELL;
    struct slots *full[] = { &b->input.s, &b->player.s, &b->fix.s,    &b->pal.s,
                             &b->music.s, &b->cues.s,   &b->voices.s, &b->option_ways.s };
    for (size_t i = 0; i < sizeof full / sizeof *full; i++)
        full[i]->live = full[i]->cap;
    for (uint32_t i = 0; i < PADS; i++)
        player_leave(&b->player, i);
    const uint8_t *rgb = cart_palette(&b->cart, "main");
    for (int i = 0; i < COLOURS; i++, rgb += 3)
        pal_set(&b->pal, i, (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2]);
    bg_clear(&b->bg, &b->bg_lines);
    tasks_empty(&b->tasks);
    b->bullets.of_kind = b->bullet_kinds.live;
    b->shots.of_kind = b->shot_kinds.live;
    if (b->voices.s.cap)
        sound_power(b);
}

/* Lays RAM out and clears the columns of lists, whose entries are read before they are written; those of nvram are
 * not, and stay through a reset.
 *
 * Memory map, from the beginning of RAM; each block is aligned to RAM_ALIGN bytes:
 *
 *   block                         bytes                              snapshot
 *   struct board                  sizeof                             whole
 *   struct output                 sizeof                             none; a restore clears it
 *   columns of each part, in the  slots_size of its chip and slots   of pools, the slots below top and high; of lists,
 *   order of PART_LIST                                               the live entries (slots.h)
 *   pictures                      a struct sprite for each of the    none; a restore reads the ROM
 *                                 ROM's sprites
 *   events                        events_size of event_room          none; there are no events between frames
 *   fresh bullets                 a struct ml_fired a bullet, where  none; there are none between frames
 *                                 documents may run
 *   Lua's heap                    board.lua_kib KiB                  what is in use
 */
static void lay_out(struct board *b)
{
    uint8_t *next = b->ram + aligned(sizeof *b);
    const struct layout l = layout_of(&b->cart.m);

    b->output = (struct output *)next;
    next += aligned(sizeof *b->output);
    for (int i = 0; i < PARTS; i++) {
        uint8_t *first = next;
        slots_layout(machine_parts[i].chip, chip_at(b, i), l.cap[i], l.groups[i], &next);
        if (machine_parts[i].chip->list && machine_parts[i].chip != &nvram_chip)
            memset(first, 0, (size_t)(next - first));
    }
    b->pictures = (struct sprite *)next;
    next += aligned((uint64_t)b->cart.sprites * sizeof(struct sprite));
    events_layout(&b->events, (uint32_t)event_room(&b->cart.m), next);
    next += aligned(events_size(b->events.cap));
    b->ml_fresh = (struct ml_fresh){ 0, fresh_room(&b->cart.m), (struct ml_fired *)next };
    next += aligned(b->ml_fresh.cap * sizeof(struct ml_fired));
    set_up(b);
    b->vm.heap = (struct heap *)next;
    b->vm.L = b->vm.running = NULL;
    b->option_plans = NULL;
}

static bool boot(struct board *b)
{
    if (!vm_open(b, b->vm.heap, (size_t)b->cart.m.lua_kib * 1024))
        return false;
    b->vm.loading = true;
    bool fine = vm_call(b, vm_boot);
    b->vm.loading = false;
    if (fine) /* invariant: between frames there are no events */
        vm_call(b, events_run);
    return true;
}

static bool practice_fits(const struct practice *p, char *err, size_t err_size)
{
    if (p->lives < 0 || p->lives > PRACTICE_LIVES)
        snprintf(err, err_size, "practice start: lives: expected 0 to %d, got %d", PRACTICE_LIVES, (int)p->lives);
    else if (p->registers < 0 || p->registers > PRACTICE_REGISTERS)
        snprintf(err, err_size, "practice start: expected at most %d registers, got %d", PRACTICE_REGISTERS,
                 (int)p->registers);
    else if (!p->section[0] && (p->lives || p->invincible || p->registers))
        snprintf(err, err_size, "lives, registers and invincibility require a practice start");
    else
        return true;
    return false;
}

static bool lang_fits(const char *lang, char *err, size_t err_size)
{
    for (; *lang; lang++) {
        if (*lang < 32 || *lang > 126) {
            snprintf(err, err_size, "language: expected printable ASCII, got byte %d", (unsigned char)*lang);
            return false;
        }
    }
    return true;
}

static bool open_lang(struct board *b, char *err, size_t err_size)
{
    if (!lang_fits(b->start.lang, err, err_size))
        return false;
    if (cart_lang(&b->cart, b->start.lang, &b->words))
        return true;
    snprintf(err, err_size, "language \"%s\": no lang/%s.txt in the game", b->start.lang, b->start.lang);
    return false;
}

/* Is what the start asks for in the manifest? */
static bool start_fits(const struct manifest *m, const struct board_start *start, char *err, size_t err_size)
{
    if (start->difficulty >= m->n_difficulties) {
        snprintf(err, err_size, "difficulty %d: the game has only %d", start->difficulty, m->n_difficulties);
        return false;
    }
    for (int i = 0; i < m->n_dips; i++) {
        const struct dip *d = &m->dips[i];
        int32_t lo = d->number ? d->lo : 0, hi = d->number ? d->hi : d->values - 1;
        if (start->dip[i] < lo || start->dip[i] > hi) {
            snprintf(err, err_size, "DIP switch %s: expected %d to %d, got %d", d->name, lo, hi, start->dip[i]);
            return false;
        }
    }
    return practice_fits(&start->practice, err, err_size);
}

/* The caller's texts may have no NUL. */
static void end_texts(struct board_start *start)
{
    struct practice *p = &start->practice;

    start->lang[sizeof start->lang - 1] = 0;
    p->section[sizeof p->section - 1] = 0;
    for (int i = 0; i < PRACTICE_REGISTERS; i++)
        p->reg[i].name[sizeof p->reg[i].name - 1] = 0;
}

static struct board *power(void *ram, size_t size, const struct rom *rom, const struct board_start *start, char *err,
                           size_t err_size)
{
    struct board *b = (struct board *)ram;
    const char *wrong = ieee_fault();
    struct cart cart;
    size_t need;

    if (wrong) {
        snprintf(err, err_size, "%s", wrong);
        return NULL;
    }
    if (!open_cart(&cart, rom, &need, err, err_size))
        return NULL;
    assert(size >= need && ((uintptr_t)ram & 15) == 0);
    memset(b, 0, sizeof *b);
    b->cart = cart;
    b->ram = ram;
    b->ram_size = size;
    b->start = *start;
    b->start.nvram = NULL;
    b->start.nvram_size = 0;
    end_texts(&b->start);
    if (!start_fits(&b->cart.m, start, err, err_size) || !open_lang(b, err, err_size))
        return NULL;
    lay_out(b);
    memset(b->output, 0, sizeof *b->output);
    nvram_load(&b->nvram, start->nvram, start->nvram_size);
    if (!boot(b)) {
        snprintf(err, err_size, "board.lua_kib = %d is too small to start Lua; raise it in rom.lua", b->cart.m.lua_kib);
        return NULL;
    }
    b->output->out.log = b->output->log;
    b->output->out.log_size = b->output->log_size;
    return b;
}

struct board *board_power(void *ram, size_t size, const struct rom *rom, const struct board_start *start, char *err,
                          size_t err_size)
{
    struct host host;

    host_enter(&host);
    struct board *b = power(ram, size, rom, start, err, err_size);
    host_leave(&host);
    return b;
}

/* board.reset: as after power-on, but frames and nvram go on. */
static void reset(struct board *b)
{
    uint32_t frame = b->core.frame;
    uint64_t digest = b->script.digest;
    const struct nvram was = b->nvram;

    lay_out(b);
    assert(b->nvram.bytes == was.bytes);
    b->nvram = was;
    b->core.frame = frame;
    script_fold(b, digest);
    b->reset = false;
    boot(b);
}

void board_on_phase(struct board *b, board_phase_done *done, void *context)
{
    b->output->phase_done = done;
    b->output->phase_context = context;
}

static void phase_done(const struct board *b, enum board_phase phase)
{
    if (b->output->phase_done)
        b->output->phase_done(b->output->phase_context, phase);
}

static void move_items(struct board *b)
{
    struct item_pull pull[PADS];

    board_pulls(b, pull);
    items_move(&b->items, &b->item_kinds, pull);
}

/* Where what an enemy goes round is: an enemy has moved then, unless many wait for each other. */
static bool orbited(struct enemies_world *w, int64_t thing, fx *x, fx *y)
{
    const int most = 32;
    struct board *b = w->context;

    if (!board_alive(b, thing))
        return false;
    if (handle_kind(thing) == H_ENEMY && w->deep < most) {
        w->deep++;
        enemies_settle(&b->enemies, handle_slot(thing), w);
        w->deep--;
    }
    return board_where(b, thing, x, y);
}

void board_move(struct board *b)
{
    struct motion_world w = board_world(b, false), ws = board_world(b, true);
    struct enemies_world we = { b, orbited, board_chance, 0 };
    const uint16_t held[PADS] = { (uint16_t)(b->input.held[0] & ~board_withheld(b, 0)),
                                  (uint16_t)(b->input.held[1] & ~board_withheld(b, 1)) };
    struct bullets_query query[PADS];
    const bool solid = hit_solid_possible(b);

    emit_none(b);
    player_move(&b->player, &b->player_kinds, held, &b->area);
    if (b->option_plans)
        options_follow(b);
    enemies_move(&b->enemies, &b->keep, &we);
    bullets_move(&b->shots, &ws, &b->keep, NULL, b->enemies.s.live > 0 || solid);
    if (b->ml_roots.s.live)
        board_ml_run(b);
    hit_queries(b, query);
    bullets_move(&b->bullets, &w, &b->keep, query, solid || b->bullets.meets);
    if (b->items.s.top)
        move_items(b);
    if (b->lasers.s.live)
        lasers_move(b);
    sparks_move(&b->sparks, &b->spark_kinds, &b->keep);
    b->counts.moved = b->bullets.moved;
}

/* The motion steps of this frame are work; with too many a move ended where it was. */
static void count_steps(struct board *b)
{
    const uint64_t ran = b->bullets.ran + b->shots.ran + b->laser_heads.ran;

    if (!board_work(b, A_STEP * ran))
        board_too_much(b,
                       "motions: too many steps in one frame (%llu, for %u bullets, %u shots and %u lasers); add waits "
                       "to their loops or give motions to fewer of these things",
                       (unsigned long long)ran, b->bullets.s.live, b->shots.s.live, b->lasers.s.live);
}

/* Moves, then hits, then what programs fire. For vm_call: a full event list is a fault. */
static int move_and_hit(lua_State *L)
{
    struct board *b = vm_board(L);

    events_players(b, L);
    if (b->option_plans)
        options_count(b, L);
    board_move(b);
    count_steps(b);
    phase_done(b, PHASE_MOTION);
    hit_run(b);
    if (b->ml_fresh.n)
        board_ml_let_go(b);
    emit_run(b);
    return 0;
}

/* Lines that follow a thing go with it. */
static void drop_lines(struct board *b)
{
    EACH_LIVE (i, &b->lines.s)
        if (b->lines.follow[i] && !board_alive(b, b->lines.follow[i]))
            slots_drop(&b->lines.s, i);
    slots_trim(&b->lines.s);
}

/* Sprites go with what they follow. */
static void drop_followers(struct board *b)
{
    struct sprites *s = &b->sprites;

    if (!s->following)
        return;
    s->following = 0;
    EACH_LIVE (i, &s->s) {
        if (!(s->flags[i] & SPRITE_FOLLOW))
            continue;
        if (board_alive(b, board_followed(b, i)))
            s->following++;
        else
            slots_drop(&s->s, i);
    }
    slots_trim(&s->s);
}

/* The game's clock goes on, but not for what stood in this frame's move. */
static void next_frame(struct board *b)
{
    b->core.clock++;
    bullets_stay(&b->bullets);
    bullets_stay(&b->shots);
    bullets_stay(&b->laser_heads);
    enemies_stay(&b->enemies);
    items_stay(&b->items);
}

static void drain_registers(struct board *b)
{
    for (uint32_t p = 0; p < PADS; p++)
        if (b->player.in[p])
            registers_drain(&b->registers, board_register_row(b, p, 0), b->player_kinds.registers[b->player.kind[p]],
                            p);
    registers_drain(&b->registers, b->registers.first, b->registers.count, 0);
}

/* The end of a frame that did not stand. */
static void end_frame(struct board *b)
{
    if (b->core.frozen < 0) /* from the next one on */
        input_done(&b->input);
    if (b->core.frozen > 0)
        return;
    bg_step(&b->bg);
    pal_step(&b->pal);
    next_frame(b);
}

/*
 * board.stop(n) sets core.frozen to -(n + 1). Each tick counts it up as it begins, and stands if it is still below 0:
 * no task gets a turn, nothing moves, the clock waits. What is pressed meanwhile counts as of the first tick after it.
 */
static bool count_stop(struct board *b, const uint16_t pads[PADS])
{
    const bool was = b->core.frozen < 0;

    b->core.frozen += was;
    const bool stopped = b->core.frozen < 0;
    input_latch(&b->input, pads, stopped ? PRESS_NOBODY : board_presses(b), was);
    return stopped;
}

/* Has the frame left events_run anything to do? */
static bool has_raised(const struct board *b)
{
    return b->events.n || b->bullets.s.holding || b->shots.s.holding || b->lasers.s.live;
}

/* Nothing to hand out. Of markers and full pools the counts say how many there are: they need not be wiped. */
static void clear_output(struct output *o)
{
    struct board_out *out = &o->out;

    out->request = REQUEST_NONE;
    out->attract[0] = '\0';
    out->log = o->log;
    out->log_size = o->log_size = 0;
    out->markers = out->fulls = 0;
    out->menu = false;
    out->fault = NULL;
}

/* For vm_call. */
static int count_picture(lua_State *L)
{
    board_charge_picture(vm_board(L));
    return vm_collect(L);
}

static void tick(struct board *b, const uint16_t pads[PADS])
{
    struct output *o = b->output;

    vm_begin(b, WORK_LIMIT);
    b->events.n = 0;
    b->counts = (struct board_counts){ 0 };
    b->laser_heads.ran = 0;
    const bool stopped = count_stop(b, pads);
    if (b->voices.s.cap)
        sound_begin(b);
    if (!b->core.frozen) {
        player_count_down(&b->player);
        if (b->registers.drains)
            drain_registers(b);
        enemies_count_down(&b->enemies);
    }
    bool fine = stopped || vm_call(b, tasks_run);
    phase_done(b, PHASE_SCRIPTS);
    if (!stopped && b->core.frozen <= 0)
        fine = fine && vm_call(b, move_and_hit);
    phase_done(b, PHASE_HITS);
    fine = fine && (!has_raised(b) || vm_call(b, events_run));
    phase_done(b, PHASE_EVENTS);
    if (fine) {
        drop_followers(b);
        if (b->lines.s.live)
            drop_lines(b);
        if (b->voices.s.cap)
            sound_end(b);
        b->core.frame++;
        if (!stopped)
            end_frame(b);
        if (b->reset)
            reset(b);
        else
            vm_call(b, count_picture);
    }
    phase_done(b, PHASE_REST);
    o->out.log_size = o->log_size;
}

const struct board_out *board_tick(struct board *b, const uint16_t pads[PADS])
{
    struct output *o = b->output;
    struct host host;

    clear_output(o);
    if (o->fault.kind != FAULT_NONE) { /* the run is over */
        o->out.fault = &o->fault;
        return &o->out;
    }
    host_enter(&host);
    tick(b, pads);
    host_leave(&host);
    return &o->out;
}

bool board_boots(const struct board *b)
{
    return b->vm.practice_read;
}

const struct board_out *board_last(const struct board *b)
{
    return &b->output->out;
}

void board_screen(const struct board *b, int *w, int *h)
{
    *w = b->cart.m.screen_w;
    *h = b->cart.m.screen_h;
}

uint32_t board_frame(const struct board *b)
{
    return b->core.frame;
}

int board_parts(const struct board *b)
{
    (void)b;
    return PARTS;
}

const char *board_part(const struct board *b, int i)
{
    (void)b;
    return machine_parts[i].chip->name;
}

size_t board_snapshot_size(const struct board *b)
{
    size_t n = (size_t)(aligned(sizeof *b) + aligned(heap_save(b->vm.heap, NULL)));

    for (int i = 0; i < PARTS; i++)
        n += slots_save(machine_parts[i].chip, chip_at(b, i), NULL);
    return n;
}

void board_save(const struct board *b, void *buf)
{
    uint8_t *p = buf;

    memcpy(p, b, sizeof *b);
    p += aligned(sizeof *b);
    p += aligned(heap_save(b->vm.heap, p));
    for (int i = 0; i < PARTS; i++)
        p += slots_save(machine_parts[i].chip, chip_at(b, i), p);
}

/* RAM may hold anything by now: only what has been copied back is read. */
void board_restore(struct board *b, const void *buf)
{
    const uint8_t *p = buf;

    memcpy(b, p, sizeof *b);
    p += aligned(sizeof *b);
    p += aligned(heap_restore(b->vm.heap, p));
    for (int i = 0; i < PARTS; i++)
        p += slots_restore(machine_parts[i].chip, chip_at(b, i), p);
    for (int i = 0; i < b->cart.sprites; i++)
        cart_sprite(&b->cart, i, &b->pictures[i]);
    memset(b->output, 0, sizeof *b->output);
}

size_t board_output_size(void)
{
    return sizeof(struct output);
}

void board_output_save(const struct board *b, void *buf)
{
    memcpy(buf, b->output, sizeof *b->output);
}

void board_output_restore(struct board *b, const void *buf)
{
    memcpy(b->output, buf, sizeof *b->output);
}

const uint8_t *board_nvram(const struct board *b, size_t *size, uint32_t *changed)
{
    *size = b->nvram.s.live;
    *changed = b->nvram.writes;
    return b->nvram.bytes;
}

int board_difficulty_now(const struct board *b)
{
    return (int)b->core.difficulty;
}

static int part_named(const char *name)
{
    for (int i = 0; i < PARTS; i++)
        if (!strcmp(machine_parts[i].chip->name, name))
            return i;
    return -1;
}

size_t board_lua_peak(const struct board *b)
{
    return heap_most(b->vm.heap);
}

int64_t board_live(const struct board *b, const char *part)
{
    int i = part_named(part);

    return i < 0 ? -1 : (int64_t)((const struct slots *)chip_at(b, i))->live;
}

int64_t board_points(const struct board *b, int i)
{
    return b->player.score[i];
}

int64_t board_refused(const struct board *b, const char *part)
{
    int i = part_named(part);

    return i < 0 ? -1 : (int64_t)((const struct slots *)chip_at(b, i))->refused;
}

struct board_counts board_counts(const struct board *b)
{
    return b->counts;
}

struct targets board_players(const struct board *b)
{
    return (struct targets){ &b->player.s, b->player.x, b->player.y, b->player.in };
}

/* Enemies and players have moved when bullets do, and shots too, unless it is shots that move. */
static bool where(const struct motion_world *w, int64_t around, uint32_t moved, bool before, fx *x, fx *y)
{
    const struct board *b = w->context;
    const enum handle_kind kind = handle_kind(around), moves = w->shots ? H_SHOT : H_BULLET;
    const struct bullets *s = kind == H_SHOT ? &b->shots : &b->bullets;
    const uint32_t i = handle_slot(around);

    if (!board_alive(b, around) || !board_where(b, around, x, y))
        return false;
    if (kind == moves ? i < moved : kind == H_SHOT && before) {
        *x -= s->vx[i];
        *y -= s->vy[i];
    } else if (before && kind == H_ENEMY) {
        *x = b->enemies.was_x[i];
        *y = b->enemies.was_y[i];
    } else if (before && kind == H_PLAYER) {
        *x = b->player.was_x[i];
        *y = b->player.was_y[i];
    } else if (before && kind == H_OPTION) {
        *x = b->options.was_x[i];
        *y = b->options.was_y[i];
    }
    return true;
}

struct motion_world board_world(const struct board *b, bool shots)
{
    struct motion_world w = { &b->motions,
                              &b->steps,
                              &b->bullet_kinds,
                              board_players(b),
                              b->core.clock,
                              shots,
                              where,
                              b,
                              { 0, 0, pixels(b->cart.m.field_w), pixels(b->cart.m.field_h) },
                              (b->vm.limit - b->vm.work) / A_STEP,
                              emit_queue };

    if (shots) {
        w.kinds = NULL;
        w.targets = (struct targets){ &b->enemies.s, b->enemies.x, b->enemies.y, NULL };
    }
    return w;
}

/* The list holds all that a frame raises by itself (event_room); only scripts can raise more, which is their fault. */
void board_event(struct board *b, enum event_kind kind, int64_t a, int64_t b2)
{
    if (!events_push(&b->events, kind, a, b2))
        vm_fault(b->vm.running, FAULT_SCRIPT, "too many events in one frame (at most %d)", (int)b->events.cap);
}

uint64_t board_chance(void *board, uint64_t below)
{
    struct board *b = board;
    struct rng r;

    memcpy(r.s, b->core.random, sizeof r.s);
    uint64_t v = below ? rng_below(&r, below) : rng_next(&r);
    memcpy(b->core.random, r.s, sizeof r.s);
    b->core.drawn++;
    return v;
}

/* Demos and the cabinet's font have printable ASCII only. */
static void copy_plain(char *to, size_t size, const char *from)
{
    snprintf(to, size, "%s", from);
    for (; *to; to++)
        if (*to < 32 || *to > 126)
            *to = '?';
}

void board_add_marker(struct board *b, enum board_marker_kind kind, const char *name, const char *of, const char *title,
                      int32_t value)
{
    struct board_out *out = &b->output->out;

    if (out->markers == BOARD_MARKERS)
        return;
    struct board_marker *m = &out->marker[out->markers++];
    m->kind = kind;
    m->value = value;
    copy_plain(m->name, sizeof m->name, name);
    copy_plain(m->of, sizeof m->of, of);
    copy_plain(m->title, sizeof m->title, title);
}

bool board_lists(const struct board *b)
{
    return strcmp(b->start.practice.section, PRACTICE_LIST) == 0;
}

void board_score(struct board *b, uint32_t i, int64_t points)
{
    const struct manifest *m = &b->cart.m;
    int64_t *score = &b->player.score[i];
    const int64_t most = 999999999999;

    if (!b->player.in[i])
        return;

    *score = points > most - *score ? most : *score + points < 0 ? 0 : *score + points;
    while (b->core.extended[i] < (uint32_t)m->n_extends && *score >= m->extends[b->core.extended[i]]) {
        b->core.extended[i]++;
        b->player.lives[i]++;
        board_event(b, EV_EXTEND, board_handle(b, H_PLAYER, (int32_t)i), 0);
    }
}

void board_vanish(struct board *b, uint32_t i)
{
    const struct bullets *s = &b->bullets;
    uint16_t spark = b->bullet_kinds.vanish[bullets_kind(s, &b->bullet_kinds, i)];

    if (spark)
        board_sparks(b, &(struct spark_burst){ .x = s->x[i], .y = s->y[i], .kind = (uint16_t)(spark - 1), .n = 1 });
}

static const struct slots *pool(const struct board *b, enum handle_kind kind)
{
    switch (kind) {
    case H_BULLET:
        return &b->bullets.s;
    case H_SHOT:
        return &b->shots.s;
    case H_ENEMY:
        return &b->enemies.s;
    case H_SPRITE:
        return &b->sprites.s;
    case H_ITEM:
        return &b->items.s;
    case H_LASER:
        return &b->lasers.s;
    case H_TASK:
        return &b->tasks.s;
    case H_LINE:
        return &b->lines.s;
    case H_OPTION:
        return &b->options.s;
    case H_BULLETML:
        return &b->ml_roots.s;
    default:
        return NULL;
    }
}

int64_t board_handle(const struct board *b, enum handle_kind kind, int32_t slot)
{
    const struct slots *s = pool(b, kind);

    if (slot == NO_SLOT)
        return handle_of(kind, 0, 0);
    if (kind == H_PLAYER)
        return handle_of(kind, b->player.gen[slot], (uint32_t)slot);
    return handle_of(kind, s ? s->gen[slot] : 1, (uint32_t)slot);
}

bool board_alive(const struct board *b, int64_t h)
{
    enum handle_kind kind = handle_kind(h);
    uint32_t slot = handle_slot(h), gen = handle_gen(h);
    const struct slots *s = pool(b, kind);

    if (kind == H_PLAYER)
        return slot < PADS && b->player.in[slot] && b->player.gen[slot] == gen;
    if (kind == H_TASK)
        return tasks_alive(b, slot, gen);
    if (kind == H_LAYER || kind == H_PLANE)
        return gen == 1 && slot < b->bg.s.live && (slot == BG_PLANE) == (kind == H_PLANE);
    if (kind == H_BULLETML && slots_has(s, slot, gen))
        return !(b->ml_roots.flags[slot] & ROOT_OVER);
    if (kind == H_ENEMY && slots_has(s, slot, gen))
        return !(b->enemies.flags[slot] & ENEMY_GONE);
    return s ? slots_has(s, slot, gen) : gen != 0;
}

bool board_there(const struct board *b, int64_t h)
{
    enum handle_kind kind = handle_kind(h);

    if (kind == H_ENEMY)
        return slots_has(&b->enemies.s, handle_slot(h), handle_gen(h));
    if ((kind == H_BULLET || kind == H_SHOT || kind == H_ITEM) &&
        slots_has_held(pool(b, kind), handle_slot(h), handle_gen(h)))
        return true;
    return board_alive(b, h);
}

int64_t board_followed(const struct board *b, uint32_t i)
{
    int follow = (b->sprites.flags[i] & SPRITE_FOLLOW) / SPRITE_FOLLOW_ONE;

    if (follow <= FOLLOW_OWNER)
        return follow ? b->sprites.owner[i] : 0;
    return board_handle(b, H_PLAYER, follow - FOLLOW_PLAYER);
}

uint8_t board_player_of(const struct board *b, int64_t h)
{
    const enum handle_kind kind = handle_kind(h);

    if ((kind != H_PLAYER && kind != H_OPTION) || !board_alive(b, h))
        return 0;
    return (uint8_t)(1 + (kind == H_PLAYER ? handle_slot(h) : b->options.player[handle_slot(h)]));
}

/* Where sprite i is; in the corner, if what it follows has just gone. */
static void sprite_where(const struct board *b, uint32_t i, fx *x, fx *y)
{
    int64_t followed = board_followed(b, i);

    *x = *y = 0;
    if (followed)
        board_where(b, followed, x, y);
    *x = fx_add(*x, b->sprites.x[i]);
    *y = fx_add(*y, b->sprites.y[i]);
}

bool board_where(const struct board *b, int64_t h, fx *x, fx *y)
{
    uint32_t i = handle_slot(h);

    if (!board_there(b, h))
        return false;
    switch (handle_kind(h)) {
    case H_BULLET:
        return *x = b->bullets.x[i], *y = b->bullets.y[i], true;
    case H_SHOT:
        return *x = b->shots.x[i], *y = b->shots.y[i], true;
    case H_ENEMY:
        return *x = b->enemies.x[i], *y = b->enemies.y[i], true;
    case H_PLAYER:
        return *x = b->player.x[i], *y = b->player.y[i], true;
    case H_SPRITE:
        return sprite_where(b, i, x, y), true;
    case H_ITEM:
        return *x = b->items.x[i], *y = b->items.y[i], true;
    case H_LASER:
        return *x = b->laser_heads.x[i], *y = b->laser_heads.y[i], true;
    case H_OPTION:
        return *x = b->options.x[i], *y = b->options.y[i], true;
    default:
        return false;
    }
}

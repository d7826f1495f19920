/*
 * board.c - power-on, RAM layout, the order of work in a tick, snapshots, and drawing; see board.h.
 */
#include "board.h"
#include "../machine/machine.h"
#include <assert.h>
#include <string.h>
#include "../base/err.h"
#include "../base/hash.h"
#include "../base/ieee.h"
#include "../script/bulletml_run.h"
#include "../script/events_run.h"
#include "../machine/collision/hit.h"
#include "../machine/lasers_run.h"
#include "../script/options_run.h"
#include "../machine/sound.h"
#include "../script/tasks.h"
#include "../machine/video/video.h"
#include "../machine/window.h"
#include "../script/vm.h"
#include "../base/host.h"

enum {
    RAM_ALIGN = 64,     /* as int_align_cache_line */
    SCRIPT_EVENTS = 256 /* events that scripts may raise in a frame, besides those of entities */
};
#ifndef MAX_RAM /* bytes; tests lower it */
#define MAX_RAM (1ull << 30)
#endif

/* Returns the most events a frame may raise. A bullet may graze or hit each player, be blocked and, if bullets can
 * meet, meet another one. A shot hits one entity or, if shots can pierce, up to MAX_PIERCED_TARGETS. An enemy may touch
 * each player, die and leave the field. An item is taken once and may give lives. A laser may graze or hit both
 * players, or hit enemies. A BulletML document may raise an event for each bullet it fires. */
static uint64_t event_capacity(const struct manifest *m)
{
    const uint64_t players = (uint64_t)m->players;

    return (players + (m->enemies > 0) + (m->bullets_can_meet != 0)) * (uint64_t)m->bullets +
           (m->has_pierce ? MAX_PIERCED_TARGETS : 1) * (uint64_t)m->shots + (players + 2) * (uint64_t)m->enemies +
           2 * (uint64_t)m->items + 2 * (uint64_t)m->lasers + (m->bulletml_runners ? (uint64_t)m->bullets : 0) +
           SCRIPT_EVENTS;
}

/* Returns the most bullets that BulletML documents may fire in a frame. */
static uint32_t fired_capacity(const struct manifest *m)
{
    return m->bulletml_runners ? (uint32_t)m->bullets : 0;
}

/* Returns the number of slots that part i has space for before scripts run. */
static uint32_t initial_slots(const struct part_capacities *capacities, int i)
{
    return machine_parts[i].grows ? 0 : capacities->slots[i];
}

uint64_t board_ram_needed(const struct cart *cart)
{
    const struct part_capacities capacities = parts_capacities(&cart->manifest);
    uint64_t sum = int_align_cache_line(sizeof(struct board)) + int_align_cache_line(sizeof(struct output));

    for (int i = 0; i < PART_COUNT; i++)
        sum += slots_size(machine_parts[i].chip, initial_slots(&capacities, i), capacities.groups[i]);
    sum += int_align_cache_line((uint64_t)cart->count[CART_SPRITES] * sizeof(struct sprite));
    sum += int_align_cache_line(events_size((uint32_t)event_capacity(&cart->manifest)));
    sum += int_align_cache_line(hit_grid_size((size_t)cart->manifest.enemies));
    sum += int_align_cache_line(fired_capacity(&cart->manifest) * sizeof(struct ml_fired_bullet));
    return sum + int_align_cache_line((uint64_t)cart->manifest.lua_kib * 1024) + RAM_ALIGN;
}

/* Opens the cart and sets *size as board_size does. Returns false with one sentence in err if it fails. */
static bool open_cart(struct cart *cart, const struct rom *rom, size_t *size, char *err, size_t err_size)
{
    memset(cart, 0, sizeof *cart); /* it is copied into RAM */
    if (!cart_open(cart, rom, err, err_size))
        return false;
    uint64_t sum = board_ram_needed(cart);
    if (sum > MAX_RAM)
        return err_set(err, err_size, "the capacities in rom.lua need %llu MiB of RAM (at most %llu); lower them",
                       (unsigned long long)(sum + 0xfffff) >> 20, MAX_RAM >> 20);
    *size = (size_t)sum;
    return true;
}

bool board_size(const struct rom *rom, size_t *size, char *err, size_t err_size)
{
    struct cart cart;

    return open_cart(&cart, rom, size, err, err_size);
}

static void set_initial_state(struct board *b)
{
    const struct manifest *m = &b->cart.manifest;
    struct rng r;

    b->keep_box = (struct box){ fx_int(-m->margin), fx_int(-m->margin), fx_int(m->field_w + m->margin),
                                fx_int(m->field_h + m->margin) };
    b->player_area = (struct box){ fx_int(8), fx_int(8), fx_int(m->field_w - 8), fx_int(m->field_h - 8) };
    for (int i = 0; i < b->cart.count[CART_SPRITES]; i++)
        cart_sprite(&b->cart, i, &b->sprite_images[i]);
    rng_seed(&r, b->start.seed);
    memcpy(b->core.random, r.s, sizeof r.s);
    rng_seed(&r, b->start.seed ^ 0x537061726b73u); /* "Sparks" */
    memcpy(b->sparks.stream, r.s, sizeof r.s);
    b->core.difficulty = (uint32_t)(b->start.difficulty < 0 ? m->difficulty : b->start.difficulty);
    b->script.digest = HASH_START;
    b->fix.cols = (uint32_t)m->screen_w / FIX_CELL_SIZE;
    b->fix.rows = (uint32_t)m->screen_h / FIX_CELL_SIZE;
    struct slots *always_live[] = { &b->input.s, &b->player.s, &b->fix.s,          &b->pal.s,   &b->music.s,
                                    &b->cues.s,  &b->voices.s, &b->option_paths.s, &b->camera.s };
    for (size_t i = 0; i < sizeof always_live / sizeof *always_live; i++)
        always_live[i]->live = always_live[i]->cap;
    for (uint32_t i = 0; i < MAX_PLAYERS; i++)
        player_leave(&b->player, i);
    const uint8_t *rgb = cart_palette(&b->cart, "main");
    for (int i = 0; i < COLOURS; i++, rgb += 3)
        pal_set(&b->pal, i, (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2]);
    bg_clear(&b->bg, &b->bg_lines);
    if (b->camera.s.live)
        camera_reset(&b->camera, m->field_w, m->field_h, m->view_w, m->view_h);
    tasks_init(&b->tasks);
    if (b->voices.s.cap)
        sound_reset(b);
}

/* Lays out RAM and clears the columns of lists, because their entries are read before they are written. The columns of
 * nvram are not cleared and survive a reset.
 *
 * Memory map, from the start of RAM; each block is aligned to RAM_ALIGN bytes:
 *
 *   block                         bytes                              snapshot
 *   struct board                  sizeof                             whole
 *   struct output                 sizeof                             none; a restore clears it
 *   columns of each part, in the  slots_size of its chip and slots,  of pools, the slots below top and high; of lists,
 *   order of PART_LIST            0 if it grows in Lua's heap        the live entries (slots.h)
 *   sprite_images                 a struct sprite per sprite of the  none; a restore reads the ROM
 *                                 ROM
 *   events                        events_size of event_capacity      none; there are no events between frames
 *   hit_grid                      hit_grid_size of the enemies       none; it is rebuilt whenever it is used
 *   ml_fired                      a struct ml_fired_bullet per       none; there are none between frames
 *                                 bullet, if BulletML documents may
 *                                 run
 *   Lua's heap                    board.lua_kib KiB                  the bytes in use
 */
static void lay_out(struct board *b)
{
    uint8_t *next = b->ram + int_align_cache_line(sizeof *b);
    const struct part_capacities capacities = parts_capacities(&b->cart.manifest);

    b->output = (struct output *)next;
    next += int_align_cache_line(sizeof *b->output);
    for (int i = 0; i < PART_COUNT; i++) {
        uint8_t *first = next;
        slots_layout(machine_parts[i].chip, part_of(b, i), initial_slots(&capacities, i), capacities.groups[i], &next);
        ((struct slots *)part_of(b, i))->cap = capacities.slots[i];
        if (machine_parts[i].chip->is_list && machine_parts[i].chip != &nvram_chip)
            memset(first, 0, (size_t)(next - first));
    }
    b->sprite_images = (struct sprite *)next;
    next += int_align_cache_line((uint64_t)b->cart.count[CART_SPRITES] * sizeof(struct sprite));
    events_init(&b->events, (uint32_t)event_capacity(&b->cart.manifest), next);
    next += int_align_cache_line(events_size(b->events.cap));
    b->hit_grid = next;
    next += int_align_cache_line(hit_grid_size((size_t)b->cart.manifest.enemies));
    b->ml_fired = (struct ml_fired_list){ 0, fired_capacity(&b->cart.manifest), (struct ml_fired_bullet *)next };
    next += int_align_cache_line(b->ml_fired.cap * sizeof(struct ml_fired_bullet));
    set_initial_state(b);
    b->vm.heap = (struct heap *)next;
    b->vm.L = b->vm.running = NULL;
    b->option_plans = NULL;
}

static bool boot(struct board *b)
{
    if (!vm_open(b, b->vm.heap, (size_t)b->cart.manifest.lua_kib * 1024))
        return false;
    b->vm.loading = true;
    bool ok = vm_call(b, vm_boot);
    b->vm.loading = false;
    if (ok) /* invariant: between frames there are no events */
        vm_call(b, events_run);
    return true;
}

static bool check_practice(const struct practice *p, char *err, size_t err_size)
{
    if (p->lives < 0 || p->lives > PRACTICE_MAX_LIVES)
        return err_set(err, err_size, "practice start: lives: expected 0 to %d, got %d", PRACTICE_MAX_LIVES,
                       (int)p->lives);
    if (p->register_count < 0 || p->register_count > PRACTICE_MAX_REGISTERS)
        return err_set(err, err_size, "practice start: expected at most %d registers, got %d", PRACTICE_MAX_REGISTERS,
                       (int)p->register_count);
    if (!p->section[0] && (p->lives || p->invincible || p->register_count))
        return err_set(err, err_size, "lives, registers and invincibility require a practice start");
    return true;
}

static bool open_lang(struct board *b, char *err, size_t err_size)
{
    for (const char *c = b->start.lang; *c; c++)
        if (*c < 32 || *c > 126)
            return err_set(err, err_size, "language: expected printable ASCII, got byte %d", (unsigned char)*c);
    return cart_open_lang(&b->cart, b->start.lang, &b->words) ||
           err_set(err, err_size, "language \"%s\": no lang/%s.txt in the game", b->start.lang, b->start.lang);
}

/* Returns whether the start's values are valid for the manifest; if not, writes one sentence to err. */
static bool check_start(const struct manifest *m, const struct board_start *start, char *err, size_t err_size)
{
    if (start->difficulty >= m->n_difficulties)
        return err_set(err, err_size, "difficulty %d: the game has only %d", start->difficulty, m->n_difficulties);
    for (int i = 0; i < m->n_dips; i++) {
        const struct dip *d = &m->dips[i];
        int32_t lo = d->is_number ? d->lo : 0, hi = d->is_number ? d->hi : d->n_values - 1;
        if (start->dip[i] < lo || start->dip[i] > hi)
            return err_set(err, err_size, "DIP switch %s: expected %d to %d, got %d", d->name, lo, hi, start->dip[i]);
    }
    return check_practice(&start->practice, err, err_size);
}

/* Terminates the start's strings, because the caller's strings may lack a NUL. */
static void terminate_strings(struct board_start *start)
{
    struct practice *p = &start->practice;

    start->lang[sizeof start->lang - 1] = 0;
    p->section[sizeof p->section - 1] = 0;
    for (int i = 0; i < PRACTICE_MAX_REGISTERS; i++)
        p->reg[i].name[sizeof p->reg[i].name - 1] = 0;
}

static bool power_on(struct board *b, size_t size, const struct rom *rom, const struct board_start *start, char *err,
                     size_t err_size)
{
    const char *fault = ieee_find_fault();
    struct cart cart;
    size_t need;

    if (fault)
        return err_set(err, err_size, "%s", fault);
    if (!open_cart(&cart, rom, &need, err, err_size))
        return false;
    assert(size >= need && ((uintptr_t)b & 15) == 0);
    memset(b, 0, sizeof *b);
    b->cart = cart;
    b->ram = (uint8_t *)b;
    b->ram_size = size;
    b->start = *start;
    b->start.nvram = NULL;
    b->start.nvram_size = 0;
    terminate_strings(&b->start);
    if (!check_start(&b->cart.manifest, start, err, err_size) || !open_lang(b, err, err_size))
        return false;
    lay_out(b);
    memset(b->output, 0, sizeof *b->output);
    nvram_load(&b->nvram, start->nvram, start->nvram_size);
    if (!boot(b))
        return err_set(err, err_size, "board.lua_kib = %d is too small to start Lua; raise it in rom.lua",
                       b->cart.manifest.lua_kib);
    b->output->out.log = b->output->log;
    b->output->out.log_size = b->output->log_size;
    return true;
}

struct board *board_power_on(void *ram, size_t size, const struct rom *rom, const struct board_start *start, char *err,
                             size_t err_size)
{
    struct host host;

    host_enter(&host);
    const bool good = power_on(ram, size, rom, start, err, err_size);
    host_leave(&host);
    return good ? ram : NULL;
}

/* Performs board.reset: the state is as after power-on, except that the frame counter, the script digest and nvram are
 * retained. */
static void reset(struct board *b)
{
    uint32_t frame = b->core.frame;
    uint64_t digest = b->script.digest;
    const struct nvram nvram = b->nvram;

    lay_out(b);
    assert(b->nvram.bytes == nvram.bytes);
    b->nvram = nvram;
    b->core.frame = frame;
    script_update_digest(b, digest);
    b->reset_requested = false;
    boot(b);
}

void board_set_phase_callback(struct board *b, board_phase_done *done, void *context)
{
    b->output->phase_done = done;
    b->output->phase_context = context;
}

static void report_phase(const struct board *b, enum board_phase phase)
{
    if (b->output->phase_done)
        b->output->phase_done(b->output->phase_context, phase);
}

static void move_items(struct board *b)
{
    struct item_pull pull[MAX_PLAYERS];

    board_get_pulls(b, pull);
    items_move(&b->items, &b->item_kinds, pull);
}

/* Finds the position of the entity an enemy orbits. If that entity is an enemy too, moves it first; this nests up to 32
 * levels deep. Returns false if the entity is not alive. */
static bool find_orbited_position(struct enemies_world *w, int64_t entity, fx *x, fx *y)
{
    const int max_depth = 32;
    struct board *b = w->context;

    if (!board_is_alive(b, entity))
        return false;
    if (handle_kind(entity) == H_ENEMY && w->depth < max_depth) {
        w->depth++;
        enemies_ensure_moved(&b->enemies, handle_slot(entity), w);
        w->depth--;
    }
    return board_get_position(b, entity, x, y);
}

void board_move_entities(struct board *b)
{
    struct motion_world w = board_motion_world(b, false), ws = board_motion_world(b, true);
    struct enemies_world we = { b, find_orbited_position, board_random, 0 };
    const uint16_t held[MAX_PLAYERS] = { (uint16_t)(input_held(&b->input, 0) & ~board_ignored_buttons(b, 0)),
                                         (uint16_t)(input_held(&b->input, 1) & ~board_ignored_buttons(b, 1)) };
    struct bullets_query query[MAX_PLAYERS];
    const bool has_solids = hit_solid_is_possible(b);

    emit_clear(b);
    player_move(&b->player, &b->player_kinds, held, &b->player_area);
    if (b->camera.s.live)
        window_move_camera(b);
    if (b->option_plans)
        options_follow(b);
    enemies_move(&b->enemies, &b->keep_box, &we);
    if (b->cart.manifest.has_transforms) {
        options_turn(&b->options, &b->option_kinds);
        enemies_turn(&b->enemies, &b->enemy_kinds);
    }
    bullets_move(&b->shots, &ws, &b->keep_box, NULL, b->enemies.s.live > 0 || has_solids);
    if (b->ml_roots.s.live)
        bulletml_run(b);
    hit_get_queries(b, query);
    bullets_move(&b->bullets, &w, &b->keep_box, query, has_solids || b->bullets.n_meet_pairs);
    if (b->items.s.top)
        move_items(b);
    if (b->lasers.s.live)
        lasers_move(b);
    sparks_move(&b->sparks, &b->spark_kinds, &b->keep_box);
    b->counts.moved = b->bullets.n_moved;
}

/* Charges this frame's motion steps as work. If there were too many, the moves have stopped early and the frame ends in
 * a fault. */
static void charge_steps(struct board *b)
{
    const uint64_t steps = b->bullets.work_done + b->shots.work_done + b->laser_heads.work_done;

    if (!board_charge_work(b, MOTION_WORK * steps))
        board_raise_overload(
            b,
            "motions: too many steps in one frame (%llu, for %u bullets, %u shots and %u lasers); add waits "
            "to their loops or give motions to fewer of these things",
            (unsigned long long)steps, b->bullets.s.live, b->shots.s.live, b->lasers.s.live);
}

/* Moves everything, tests collisions, then fires the bullets that BulletML documents and motion programs queued. Called
 * through vm_call, because a full event list is a fault. */
static int move_and_hit(lua_State *L)
{
    struct board *b = vm_board(L);

    events_step_players(b, L);
    if (b->option_plans)
        options_adjust_count(b, L);
    board_move_entities(b);
    charge_steps(b);
    report_phase(b, PHASE_MOTION);
    hit_run(b);
    if (b->ml_fired.n)
        bulletml_spawn_fired_bullets(b);
    emit_run(b);
    return 0;
}

/* Removes the lines of text whose followed entity is no longer alive. */
static void drop_lines(struct board *b)
{
    EACH_LIVE (i, &b->lines.s)
        if (b->lines.follow_target[i] && !board_is_alive(b, b->lines.follow_target[i]))
            slots_drop(&b->lines.s, i);
    slots_trim(&b->lines.s);
}

/* Removes the sprites whose followed entity is no longer alive, and counts the sprites that still follow one. */
static void drop_followers(struct board *b)
{
    struct sprites *s = &b->sprites;

    if (!s->n_following)
        return;
    s->n_following = 0;
    EACH_LIVE (i, &s->s) {
        if (!(s->flags[i] & SPRITE_FOLLOW))
            continue;
        if (board_is_alive(b, board_sprite_follow_target(b, i)))
            s->n_following++;
        else
            slots_drop(&s->s, i);
    }
    slots_trim(&s->s);
}

/* Turns the sprites with SPRITE_TURNS into the direction in which they moved in this frame, and counts them. */
static void turn_sprites(struct board *b)
{
    struct sprites *s = &b->sprites;

    if (!s->n_turning)
        return;
    s->n_turning = 0;
    EACH_LIVE (i, &s->s) {
        fx x, y;
        if (!(s->alpha[i] & SPRITE_TURNS))
            continue;
        s->n_turning++;
        board_get_position(b, board_handle(b, H_SPRITE, (int32_t)i), &x, &y);
        if (x != s->prev_x[i] || y != s->prev_y[i])
            s->dir[i] = trig_atan2(fx_sub(y, s->prev_y[i]), fx_sub(x, s->prev_x[i]));
        s->prev_x[i] = x;
        s->prev_y[i] = y;
    }
}

/* Advances the game's clock. Entities that stood still in this frame's move do not age. */
static void advance_clock(struct board *b)
{
    b->core.clock++;
    bullets_postpone_frozen(&b->bullets);
    bullets_postpone_frozen(&b->shots);
    bullets_postpone_frozen(&b->laser_heads);
    enemies_postpone_frozen(&b->enemies);
    items_postpone_frozen(&b->items);
}

static void drain_registers(struct board *b)
{
    for (uint32_t p = 0; p < MAX_PLAYERS; p++)
        if (b->player.in_game[p])
            registers_drain(&b->registers, board_register_row(b, p, 0), b->player_kinds.n_registers[b->player.kind[p]],
                            p);
    registers_drain(&b->registers, b->registers.first_run_row, b->registers.n_run_rows, 0);
}

/* Ends a frame that board.stop did not hold. */
static void end_frame(struct board *b)
{
    channel_end_frame(&b->channel);
    if (b->core.frozen < 0) /* board.stop was called in this frame and holds from the next one on */
        input_clear_edges(&b->input);
    if (b->core.frozen > 0)
        return;
    bg_step(&b->bg);
    pal_step(&b->pal);
    advance_clock(b);
}

/*
 * Latches the input and returns whether board.stop holds this tick. board.stop(n) sets core.frozen to -(n + 1). Each
 * tick starts by incrementing core.frozen if it is negative, and is held if it is still negative: no task resumes,
 * nothing moves, and the clock does not advance. Buttons pressed in held ticks count as pressed in the first tick
 * afterwards.
 */
static bool step_stop(struct board *b, const uint16_t pads[MAX_PLAYERS])
{
    const bool was_stopped = b->core.frozen < 0;

    b->core.frozen += was_stopped;
    const bool stopped = b->core.frozen < 0;
    input_latch(&b->input, pads, stopped ? PRESS_NOBODY : board_press_side(b), was_stopped);
    channel_latch(&b->channel, pads);
    return stopped;
}

/* Returns whether events_run has anything to do in this frame. */
static bool needs_events_run(const struct board *b)
{
    return b->events.n || b->bullets.s.held_count || b->shots.s.held_count || b->lasers.s.live;
}

/* Empties the output. The arrays of markers and full pools need no clearing, because their counts are zeroed. */
static void clear_output(struct output *o)
{
    struct board_out *out = &o->out;

    out->request = REQUEST_NONE;
    out->attract[0] = '\0';
    out->log = o->log;
    out->log_size = o->log_size = 0;
    out->marker_count = out->full_pool_count = out->key_hint_count = 0;
    out->typing = 0;
    out->back = 0;
    out->fault = NULL;
}

/* Charges the work of drawing this frame's picture, then runs the collector. Called through vm_call. */
static int charge_picture(lua_State *L)
{
    board_charge_picture(vm_board(L));
    return vm_collect_garbage(L);
}

static void tick(struct board *b, const uint16_t pads[MAX_PLAYERS])
{
    struct output *o = b->output;

    vm_reset_work(b, WORK_LIMIT);
    b->events.n = 0;
    b->counts = (struct board_counts){ 0 };
    b->laser_heads.work_done = 0;
    const bool stopped = step_stop(b, pads);
    if (b->voices.s.cap)
        sound_begin_tick(b);
    if (!b->core.frozen) {
        player_step_invulnerability(&b->player);
        if (b->registers.n_draining)
            drain_registers(b);
        enemies_step_timers(&b->enemies);
    }
    bool ok = stopped || vm_call(b, tasks_run);
    report_phase(b, PHASE_SCRIPTS);
    if (!stopped && b->core.frozen <= 0)
        ok = ok && vm_call(b, move_and_hit);
    report_phase(b, PHASE_HITS);
    ok = ok && (!needs_events_run(b) || vm_call(b, events_run));
    report_phase(b, PHASE_EVENTS);
    if (ok) {
        drop_followers(b);
        turn_sprites(b);
        if (b->lines.s.live)
            drop_lines(b);
        if (b->voices.s.cap)
            sound_end_tick(b);
        b->core.frame++;
        if (!stopped)
            end_frame(b);
        if (b->reset_requested)
            reset(b);
        else
            vm_call(b, charge_picture);
    }
    report_phase(b, PHASE_CLEANUP);
    o->out.log_size = o->log_size;
}

const struct board_out *board_tick(struct board *b, const uint16_t pads[MAX_PLAYERS])
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

bool board_called_boot_run(const struct board *b)
{
    return b->vm.practice_read;
}

const struct board_out *board_last_output(const struct board *b)
{
    return &b->output->out;
}

void board_screen_size(const struct board *b, int *w, int *h)
{
    *w = b->cart.manifest.screen_w;
    *h = b->cart.manifest.screen_h;
}

uint32_t board_frame(const struct board *b)
{
    return b->core.frame;
}

int board_part_count(const struct board *b)
{
    (void)b;
    return PART_COUNT;
}

const char *board_part_name(const struct board *b, int i)
{
    (void)b;
    return machine_parts[i].chip->name;
}

size_t board_snapshot_size(const struct board *b)
{
    size_t n = (size_t)(int_align_cache_line(sizeof *b) + int_align_cache_line(heap_save(b->vm.heap, NULL)));

    for (int i = 0; i < PART_COUNT; i++)
        n += machine_parts[i].grows ? 0 : slots_save(machine_parts[i].chip, part_of(b, i), NULL);
    return n;
}

void board_save(const struct board *b, void *buf)
{
    uint8_t *p = buf;

    memcpy(p, b, sizeof *b);
    p += int_align_cache_line(sizeof *b);
    p += int_align_cache_line(heap_save(b->vm.heap, p));
    for (int i = 0; i < PART_COUNT; i++)
        p += machine_parts[i].grows ? 0 : slots_save(machine_parts[i].chip, part_of(b, i), p);
}

/* RAM may hold anything at this point, so only bytes already copied back are read. */
void board_restore(struct board *b, const void *buf)
{
    const uint8_t *p = buf;

    memcpy(b, p, sizeof *b);
    p += int_align_cache_line(sizeof *b);
    p += int_align_cache_line(heap_restore(b->vm.heap, p));
    for (int i = 0; i < PART_COUNT; i++)
        p += machine_parts[i].grows ? 0 : slots_restore(machine_parts[i].chip, part_of(b, i), p);
    for (int i = 0; i < b->cart.count[CART_SPRITES]; i++)
        cart_sprite(&b->cart, i, &b->sprite_images[i]);
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

const uint8_t *board_nvram(const struct board *b, size_t *size, uint32_t *writes)
{
    *size = b->nvram.s.live;
    *writes = b->nvram.writes;
    return b->nvram.bytes;
}

int board_current_difficulty(const struct board *b)
{
    return (int)b->core.difficulty;
}

size_t board_lua_peak(const struct board *b)
{
    return heap_peak(b->vm.heap);
}

int64_t board_live_count(const struct board *b, const char *part)
{
    const struct slots *s = part_find(b, part);

    return s ? (int64_t)s->live : -1;
}

int64_t board_points(const struct board *b, int i)
{
    return b->player.score[i];
}

int64_t board_refused_count(const struct board *b, const char *part)
{
    const struct slots *s = part_find(b, part);

    return s ? (int64_t)s->refused : -1;
}

struct board_counts board_counts(const struct board *b)
{
    return b->counts;
}

/* ---- the picture ---- */

size_t board_scratch_size(const struct board *b)
{
    return video_scratch_size(&b->cart);
}

size_t board_cart_scratch_size(const struct cart *cart)
{
    return video_scratch_size(cart);
}

uint64_t board_draw(const struct board *b, const struct view *view, struct fb *fb, uint32_t rgb[256], void *scratch)
{
    struct video_work work;

    if (!video_fits(b, WORK_LIMIT, &work)) { /* the board has a fault, or its next tick will raise one */
        memcpy(rgb, b->pal.rgb, COLOURS * sizeof *rgb);
        fb_reset_clip(fb);
        fb_fill(fb, 0);
        return 0;
    }
    return video_draw(b, view, fb, rgb, scratch);
}

/* ---- Lua ---- */

const char *board_lua_release(void)
{
    return &LUA_RELEASE[sizeof "Lua"];
}

const char *board_lua_copyright(void)
{
    const char *notice = strstr(LUA_COPYRIGHT, "Copyright");

    return notice ? notice : LUA_COPYRIGHT;
}

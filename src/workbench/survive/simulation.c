/*
 * simulation.c - see simulation.h. Scripts' instructions are limited, so an infinite loop becomes a fault.
 */
#include "simulation.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../common/array.h"
#include "../../common/result.h"
#include "../../board/inspect.h"
#include "../../entities/player.h"
#include "../../demo/demo.h"

enum { ALIGN = 64 };

/* ---- forecasts ---- */

void forecast_clear(struct forecast *f, uint32_t from)
{
    f->from = from;
    f->frames = 0;
    f->n = 0;
    f->full = false;
}

void forecast_close(struct forecast *f)
{
    free(f->frame);
    free(f->list);
    *f = (struct forecast){ 0 };
}

static void hash_add(uint64_t *print, uint64_t v)
{
    *print = (*print ^ v) * 0x9e3779b97f4a7c15u;
    *print ^= *print >> 29;
}

static void hash_danger(uint64_t *print, const struct danger *d)
{
    hash_add(print, (uint64_t)d->shape << 8 | d->swept);
    hash_add(print, (uint64_t)(uint32_t)d->x << 32 | (uint32_t)d->y);
    hash_add(print, (uint64_t)(uint32_t)d->mx << 32 | (uint32_t)d->my);
    hash_add(print, (uint64_t)(uint32_t)d->a << 32 | (uint32_t)d->b);
    hash_add(print, (uint64_t)(uint32_t)d->c << 32 | (uint32_t)d->d);
    hash_add(print, (uint32_t)d->e);
}

static void add_danger(void *context, const struct danger *d)
{
    struct forecast *f = context;
    struct forecast_frame *frame = &f->frame[f->frames];

    struct danger *copy = array_append(&f->list, f->n, sizeof *copy);
    f->full |= !copy;
    if (!copy)
        return;
    frame->fired += d->age == 0 && d->source != DANGER_ENEMY;
    hash_danger(&frame->checksum, d);
    *copy = *d;
    f->n++;
    frame->n++;
}

static struct forecast_frame *next_frame(struct forecast *f)
{
    struct forecast_frame *frame = array_append(&f->frame, f->frames, sizeof *frame);

    f->full |= !frame;
    return frame;
}

struct enemy_finder {
    int32_t x, y, away;
    const struct danger_ship *ship;
    const struct board *board;
    int field_w; /* px */
};

static void consider_enemy(void *context, const struct inspect_body *body)
{
    struct enemy_finder *enemy_finder = context;
    int32_t x = body->x, y = body->y;
    inspect_to_field(enemy_finder->board, &x, &y);
    const int32_t away = fx_abs(x - enemy_finder->ship->path.x);

    if (body->kind != INSPECT_ENEMY || y < 0 || y > enemy_finder->ship->path.y || x < 0 ||
        x > enemy_finder->field_w * FX_ONE || away >= enemy_finder->away)
        return;
    enemy_finder->away = away;
    enemy_finder->x = x;
}

/* Called at the end of PHASE_MOTION: if nothing moves, nothing can hit. */
static void record_frame(struct simulation *t)
{
    struct forecast *f = t->recording;

    struct forecast_frame *frame = f->full ? NULL : next_frame(f);
    if (!frame)
        return;
    *frame = (struct forecast_frame){ .first = f->n };
    danger_get_ship(t->b, t->player, &frame->ship);
    frame->moves = t->moved && frame->ship.can_steer;
    frame->safe = frame->ship.is_safe;
    hash_add(&frame->checksum, (uint64_t)frame->moves << 2 | (uint64_t)frame->safe << 1 | frame->ship.in_game);
    hash_add(&frame->checksum, (uint64_t)(uint32_t)frame->ship.speed << 32 | (uint32_t)frame->ship.focused_speed);
    hash_add(&frame->checksum, (uint64_t)(uint32_t)frame->ship.path.radius);
    danger_visit_shapes(t->b, add_danger, f);
    struct enemy_finder enemy_finder = {
        .away = FX_MAX, .ship = &frame->ship, .board = t->b, .field_w = inspect_field(t->b).field_w
    };
    enemy_finder.x = enemy_finder.field_w * (FX_ONE / 2);
    inspect_bodies(t->b, consider_enemy, &enemy_finder);
    frame->enemy_x = enemy_finder.x;
}

/* ---- power ---- */

bool simulation_open(struct simulation *t, const struct rom *rom, const struct board_start *start, char *err,
                     size_t err_size)
{
    *t = (struct simulation){ .rom = rom, .start = start };
    if (!board_size(rom, &t->size, err, err_size))
        return false;
    t->block = malloc(t->size + ALIGN);
    if (!t->block)
        return result_set_host_error(err, err_size, "out of memory");
    const char *section = start->practice.section;
    t->section = !section[0] ? 0 : strchr(section, '/') ? '/' : ':';
    return simulation_restart(t, err, err_size);
}

bool simulation_restart(struct simulation *t, char *err, size_t err_size)
{
    void *ram = (void *)(((uintptr_t)t->block + ALIGN - 1) / ALIGN * ALIGN);

    t->starts = 0;
    t->moved = t->ship_was_moved = t->touched = false;
    t->ship = (struct danger_ship){ 0 };
    t->b = board_power_on(ram, t->size, t->rom, t->start, err, err_size);
    return t->b != NULL;
}

void simulation_close(struct simulation *t)
{
    free(t->block);
    *t = (struct simulation){ 0 };
}

/* ---- ticks ---- */

/* Computes where the buttons move the ship. */
static void steered_position(const struct danger_ship *s, uint16_t pads, fx *x, fx *y)
{
    int dx = !!(pads & PAD_RIGHT) - !!(pads & PAD_LEFT), dy = !!(pads & PAD_DOWN) - !!(pads & PAD_UP);
    fx speed = pads & PAD_FOCUS ? s->focused_speed : s->speed;

    if (dx && dy)
        speed = fx_mul(speed, PLAYER_DIAGONAL_FACTOR);
    *x = fx_clamp(s->path.prev_x + dx * speed, s->area.x0, s->area.x1);
    *y = fx_clamp(s->path.prev_y + dy * speed, s->area.y0, s->area.y1);
}

struct tick {
    struct simulation *t;
    uint16_t pads;
};

static void check_touch(void *context, const struct danger *d)
{
    struct tick *tick = context;
    const struct danger_path *move = &tick->t->ship.path;
    const int64_t reach = (int64_t)d->a + fx_max(fx_abs(d->b), fx_abs(d->c)) + move->radius +
                          fx_max(fx_abs(move->x - move->prev_x), fx_abs(move->y - move->prev_y));

    if (d->shape != DANGER_LASER_SEGMENT && ((int64_t)fx_abs(d->x - move->x) > reach + fx_abs(d->mx) ||
                                             (int64_t)fx_abs(d->y - move->y) > reach + fx_abs(d->my)))
        return;
    tick->t->touched |= danger_would_hit(d, move);
}

static void on_motion_done(void *context, enum board_phase phase)
{
    struct tick *tick = context;
    struct simulation *t = tick->t;
    const struct danger_path before = t->ship.path;
    const bool was_in = t->ship.in_game;
    fx x, y;

    if (phase != PHASE_MOTION)
        return;
    t->moved = true;
    danger_get_ship(t->b, t->player, &t->ship);
    if (t->recording)
        record_frame(t);
    if (t->ship.in_game && !t->ship.is_safe)
        danger_visit_shapes(t->b, check_touch, tick);
    if (!t->ship.in_game || !was_in || !t->ship.can_steer)
        return;
    steered_position(&t->ship, tick->pads, &x, &y);
    t->ship_was_moved |= t->ship.path.prev_x != before.x || t->ship.path.prev_y != before.y || x != t->ship.path.x ||
                         y != t->ship.path.y;
}

/* Returns whether a part of a stage ends at the marker. Practice at a mark passes that mark first. */
static bool ends_part(const struct simulation *t, const struct board_marker *m)
{
    const char *mark = strchr(t->start->practice.section, ':');

    return t->stop_at_marks && t->section == ':' && (m->kind == MARKER_BOSS || !mark || strcmp(m->name, mark + 1) != 0);
}

/* Returns whether the section ends at the marker. Phases of a stage's boss do not end the stage. */
static bool ends_section(struct simulation *t, const struct board_marker *m)
{
    switch (m->kind) {
    case MARKER_START:
        return ++t->starts > 1;
    case MARKER_WON:
    case MARKER_LOST:
        return t->section == '/';
    case MARKER_CLEAR:
        return t->section == ':';
    case MARKER_MARK:
    case MARKER_BOSS:
        return ends_part(t, m);
    case MARKER_OVER:
        return true;
    default:
        return false;
    }
}

/* If a script makes a touched ship safe (a deathbomb), that counts as a hit. */
static enum simulation_end tick_result(struct simulation *t, const struct board_out *out,
                                       const struct danger_ship *before)
{
    struct danger_ship now;
    bool over = out->request == REQUEST_QUIT, hit = false;

    if (out->fault)
        return SIMULATION_FAULT;
    for (int i = 0; i < out->marker_count; i++) {
        over |= ends_section(t, &out->marker[i]);
        hit |= out->marker[i].kind == MARKER_DEATH && out->marker[i].name[0] == '1' + t->player;
    }
    danger_get_ship(t->b, t->player, &now);
    hit |= t->touched && now.is_safe && !before->is_safe;
    hit |= now.in_game && (now.is_hit || (before->in_game && now.lives < before->lives));
    return hit ? SIMULATION_HIT : over ? SIMULATION_ENDED : SIMULATION_RUNNING;
}

enum simulation_end simulation_tick(struct simulation *t, const uint16_t pads[MAX_PLAYERS])
{
    struct danger_ship before;
    struct tick tick = { t, pads[t->player] };

    danger_get_ship(t->b, t->player, &before);
    t->moved = t->touched = false;
    board_set_phase_callback(t->b, on_motion_done, &tick);
    const struct board_out *out = board_tick(t->b, pads);
    board_set_phase_callback(t->b, NULL, NULL);
    t->ticks++;
    struct forecast_frame *frame = t->recording && !t->moved ? next_frame(t->recording) : NULL;
    if (frame)
        *frame = (struct forecast_frame){ .first = t->recording->n, .ship = t->ship };
    if (t->recording && !t->recording->full)
        t->recording->frames++;
    return tick_result(t, out, &before);
}

bool simulation_can_steer(const struct simulation *t)
{
    struct danger_ship now;

    danger_get_ship(t->b, t->player, &now);
    return now.in_game && now.can_steer;
}

uint16_t simulation_menu_pads(const struct simulation *t)
{
    const uint32_t frame = board_frame(t->b);
    struct danger_ship now;

    danger_get_ship(t->b, t->player, &now);
    if (now.in_game) /* in a dialogue, which start would pause */
        return frame % 75 == 60 ? PAD_FIRE : 0;
    return frame % 75 == 60 ? PAD_FIRE : frame % 75 == 20 ? PAD_START : 0;
}

/* ---- saved states ---- */

bool simulation_save(const struct simulation *t, struct simulation_state *m)
{
    const size_t need = board_snapshot_size(t->b);

    if (need > m->capacity) {
        free(m->block);
        m->capacity = need + need / 4;
        m->block = malloc(m->capacity + ALIGN);
        if (!m->block) {
            m->capacity = 0;
            return false;
        }
        m->snapshot = (void *)(((uintptr_t)m->block + ALIGN - 1) / ALIGN * ALIGN);
    }
    board_save(t->b, m->snapshot);
    danger_get_ship(t->b, t->player, &m->ship);
    m->starts = t->starts;
    m->frame = board_frame(t->b);
    return true;
}

void simulation_restore(struct simulation *t, const struct simulation_state *m)
{
    board_restore(t->b, m->snapshot);
    t->ship = m->ship;
    t->starts = m->starts;
}

void simulation_state_free(struct simulation_state *m)
{
    free(m->block);
    *m = (struct simulation_state){ 0 };
}

/* ---- a demo ---- */

bool simulation_record(struct simulation *t, const struct cart *cart, const uint16_t *pads, uint32_t frames,
                       const char *path, int checksums, char *err, size_t err_size)
{
    struct demo_writer w = { 0 };
    bool good = simulation_restart(t, err, err_size);

    if (good && (!demo_begin(&w, path, cart, t->b, t->start, 0) ||
                 !demo_set_checksum_rate(&w, (enum demo_checksum_rate)checksums)))
        good = err_set(err, err_size, "%s", w.err);
    for (uint32_t f = 0; good && f < frames; f++) {
        const uint16_t now[MAX_PLAYERS] = { pads[f], 0 };
        simulation_tick(t, now);
        if (!demo_record_frame(&w, t->b, now))
            good = err_set(err, err_size, "%s", w.err);
    }
    if (w.recording && !demo_end(&w, t->b) && good)
        good = err_set(err, err_size, "%s", w.err);
    demo_free(&w.demo);
    return good;
}

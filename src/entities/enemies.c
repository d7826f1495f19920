/*
 * enemies.c - the pool of enemies: spawning, damage, moves, and bodies with parts.
 */
#include "enemies.h"
#include "../base/int.h"
#include "../base/trig.h"

static const struct column kind_columns[] = {
    COLUMN(enemy_kinds, sprite),
    COLUMN(enemy_kinds, shape),
    COLUMN(enemy_kinds, a),
    COLUMN(enemy_kinds, b),
    COLUMN(enemy_kinds, x),
    COLUMN(enemy_kinds, y),
    COLUMN(enemy_kinds, hp),
    COLUMN(enemy_kinds, score),
    COLUMN(enemy_kinds, bank),
    COLUMN(enemy_kinds, flags),
    COLUMN(enemy_kinds, spark),
    GROUP_COLUMN(enemy_kinds, rate, GROUP_BODIES),
    GROUP_COLUMN(enemy_kinds, scale, GROUP_TRANSFORMS),
    GROUP_COLUMN(enemy_kinds, alpha, GROUP_TRANSFORMS),
};

static const struct column columns[] = {
    COLUMN(enemies, x),
    COLUMN(enemies, y),
    DERIVED_COLUMN(enemies, prev_x, "written by every move before hit tests read it"),
    DERIVED_COLUMN(enemies, prev_y, "written by every move before hit tests read it"),
    COLUMN(enemies, hp),
    COLUMN(enemies, kind),
    COLUMN(enemies, bank),
    COLUMN(enemies, tag),
    COLUMN(enemies, safe_left),
    COLUMN(enemies, born),
    COLUMN(enemies, owner_task),
    COLUMN(enemies, owner),
    COLUMN(enemies, flags),
    COLUMN(enemies, x0),
    COLUMN(enemies, y0),
    COLUMN(enemies, x1),
    COLUMN(enemies, y1),
    COLUMN(enemies, move_elapsed),
    COLUMN(enemies, move_duration),
    COLUMN(enemies, move_serial),
    REGISTER(enemies, move_count),
    COLUMN(enemies, ease),
    GROUP_COLUMN(enemies, value1, GROUP_VALUE + 0),
    GROUP_COLUMN(enemies, value2, GROUP_VALUE + 1),
    GROUP_COLUMN(enemies, value3, GROUP_VALUE + 2),
    GROUP_COLUMN(enemies, value4, GROUP_VALUE + 3),
    DERIVED_REGISTERS(enemies, initial_value, "set only while scripts load, like names"),
    GROUP_COLUMN(enemies, frozen_left, GROUP_FROZEN),
    GROUP_COLUMN(enemies, freeze_flags, GROUP_FROZEN),
    DERIVED_REGISTER(enemies, n_frozen, "the number of frozen enemies, counted from the column `freeze_flags`"),
    DERIVED_REGISTER(enemies, n_leaving, "rewritten by every move before hit tests read it"),
    GROUP_COLUMN(enemies, rate, GROUP_BODIES),
    GROUP_COLUMN(enemies, hp_deficit, GROUP_BODIES),
    GROUP_COLUMN(enemies, body, GROUP_BODIES),
    GROUP_COLUMN(enemies, n_parts, GROUP_BODIES),
    GROUP_COLUMN(enemies, dx, GROUP_BODIES),
    GROUP_COLUMN(enemies, dy, GROUP_BODIES),
    GROUP_COLUMN(enemies, damage_share, GROUP_BODIES),
    GROUP_COLUMN(enemies, lead_mode, GROUP_BODIES),
    GROUP_COLUMN(enemies, cx, GROUP_BODIES),
    GROUP_COLUMN(enemies, cy, GROUP_BODIES),
    GROUP_COLUMN(enemies, reach_x, GROUP_BODIES),
    GROUP_COLUMN(enemies, reach_y, GROUP_BODIES),
    GROUP_COLUMN(enemies, orbit_target, GROUP_BODIES),
    GROUP_COLUMN(enemies, angle, GROUP_BODIES),
    GROUP_COLUMN(enemies, spin, GROUP_BODIES),
    GROUP_COLUMN(enemies, leg_interval, GROUP_BODIES),
    GROUP_COLUMN(enemies, leg_wait, GROUP_BODIES),
    GROUP_COLUMN(enemies, leg_duration, GROUP_BODIES),
    GROUP_DERIVED_COLUMN(enemies, move_begun, GROUP_BODIES, "rewritten by every move"),
    GROUP_COLUMN(enemies, dir, GROUP_TRANSFORMS),
    GROUP_COLUMN(enemies, scale, GROUP_TRANSFORMS),
    GROUP_COLUMN(enemies, alpha, GROUP_TRANSFORMS),
};

const struct chip enemies_chip = { .name = "enemies", CHIP_COLUMNS(columns) };
const struct chip enemy_kinds_chip = { .name = "enemy_kinds", CHIP_COLUMNS(kind_columns), .is_list = true };

static void park(struct enemies *e, uint32_t i)
{
    e->x[i] = e->y[i] = PARK_COORDINATE;
    e->move_duration[i] = 0;
}

/* Initialises the GROUP_BODIES columns of new enemy i with its kind's rate. The enemy is not a part and has none. */
static void init_body(struct enemies *e, const struct enemy_kinds *kinds, uint32_t i)
{
    e->rate[i] = kinds->rate[e->kind[i]];
    e->hp_deficit[i] = 0;
    e->body[i] = e->n_parts[i] = 0;
    e->dx[i] = e->dy[i] = e->cx[i] = e->cy[i] = e->reach_x[i] = e->reach_y[i] = 0;
    e->damage_share[i] = e->spin[i] = 0;
    e->angle[i] = 0;
    e->leg_interval[i] = e->leg_wait[i] = e->leg_duration[i] = 0;
    e->lead_mode[i] = 0;
    e->orbit_target[i] = 0;
}

int32_t enemies_spawn(struct enemies *e, const struct enemy_kinds *kinds, uint16_t kind, fx x, fx y, uint32_t clock)
{
    uint32_t top = e->s.top;
    int32_t i = slots_take(&e->s);

    if (i == NO_SLOT)
        return i;
    for (uint32_t k = top; k < e->s.top; k++)
        park(e, k);
    e->x[i] = e->prev_x[i] = e->x0[i] = e->x1[i] = x;
    e->y[i] = e->prev_y[i] = e->y0[i] = e->y1[i] = y;
    e->hp[i] = kinds->hp[kind];
    e->kind[i] = kind;
    e->bank[i] = kinds->bank[kind] & ENEMY_BANK;
    e->tag[i] = 0;
    e->safe_left[i] = 0;
    e->born[i] = clock;
    e->owner_task[i] = 0;
    e->owner[i] = 0;
    e->flags[i] = 0;
    e->move_elapsed[i] = 0;
    e->move_duration[i] = 0;
    e->move_serial[i] = 0;
    e->ease[i] = EASE_LINEAR;
    for (int k = 0; k < MAX_VALUES && enemies_value_column(e, k); k++)
        enemies_value_column(e, k)[i] = e->initial_value[k];
    if (e->frozen_left)
        e->frozen_left[i] = e->freeze_flags[i] = 0;
    if (e->rate)
        init_body(e, kinds, (uint32_t)i);
    if (e->dir) {
        e->dir[i] = 0;
        e->scale[i] = kinds->scale[kind];
        e->alpha[i] = kinds->alpha[kind];
    }
    return i;
}

static void detach(struct enemies *e, uint32_t i)
{
    e->n_parts[e->body[i] - 1]--;
    e->body[i] = 0;
}

static void drop_parts(struct enemies *e, uint32_t i)
{
    EACH_LIVE (k, &e->s) {
        if (e->body[k] != i + 1)
            continue;
        if (e->flags[k] & ENEMY_DYING)
            detach(e, k);
        else
            enemies_drop(e, k);
    }
}

void enemies_drop(struct enemies *e, uint32_t i)
{
    if (e->body && e->body[i])
        detach(e, i);
    if (e->n_parts && e->n_parts[i])
        drop_parts(e, i);
    slots_drop(&e->s, i);
    park(e, i);
}

void enemies_drop_owned(struct enemies *e, int64_t owner)
{
    EACH_LIVE (i, &e->s)
        if (e->owner[i] == owner && !(e->flags[i] & ENEMY_DYING))
            enemies_drop(e, i);
}

static bool is_part(const struct enemies *e, uint32_t i)
{
    return e->body && e->body[i];
}

/* Return a pointer to the coordinate that enemy i's moves change: of the position or, if the enemy is a part, of the
 * offset from its body. */
static fx *local_x(const struct enemies *e, uint32_t i)
{
    return is_part(e, i) ? &e->dx[i] : &e->x[i];
}

static fx *local_y(const struct enemies *e, uint32_t i)
{
    return is_part(e, i) ? &e->dy[i] : &e->y[i];
}

/* Converts (*x, *y) from a position in the field to the coordinates that enemy i's moves change (local_x, local_y). */
static void convert_to_local(const struct enemies *e, uint32_t i, fx *x, fx *y)
{
    if (!is_part(e, i))
        return;
    *x = fx_sub(*x, e->x[e->body[i] - 1]);
    *y = fx_sub(*y, e->y[e->body[i] - 1]);
}

static void begin_move(struct enemies *e, uint32_t i, fx x, fx y, uint32_t duration, enum ease ease)
{
    e->x0[i] = *local_x(e, i);
    e->y0[i] = *local_y(e, i);
    e->x1[i] = x;
    e->y1[i] = y;
    e->move_elapsed[i] = 0;
    e->move_duration[i] = duration;
    e->ease[i] = (uint8_t)ease;
}

void enemies_halt(struct enemies *e, uint32_t i)
{
    e->move_duration[i] = 0;
    if (e->lead_mode) {
        e->lead_mode[i] = 0;
        e->orbit_target[i] = 0;
    }
}

bool enemies_is_moving(const struct enemies *e, uint32_t i, uint32_t serial)
{
    return e->move_serial[i] == serial && (e->move_duration[i] || (e->lead_mode && e->lead_mode[i]));
}

/* Ends the movement in progress and gives the next one its serial. */
static void begin_movement(struct enemies *e, uint32_t i)
{
    enemies_halt(e, i);
    e->move_count = e->move_count % (RETIRED_GENERATION - 1u) + 1;
    e->move_serial[i] = e->move_count;
}

void enemies_move_to(struct enemies *e, uint32_t i, fx x, fx y, uint32_t duration, enum ease ease)
{
    begin_movement(e, i);
    convert_to_local(e, i, &x, &y);
    begin_move(e, i, x, y, duration, ease);
}

void enemies_move_by(struct enemies *e, uint32_t i, fx dx, fx dy, uint32_t duration, enum ease ease)
{
    const bool is_relative = is_part(e, i);

    begin_movement(e, i);
    begin_move(e, i, is_relative ? dx : motion_shift(e->x[i], dx), is_relative ? dy : motion_shift(e->y[i], dy),
               duration, ease);
}

void enemies_set_position(struct enemies *e, uint32_t i, fx x, fx y)
{
    enemies_halt(e, i);
    e->x[i] = x;
    e->y[i] = y;
    convert_to_local(e, i, &x, &y);
    *local_x(e, i) = x;
    *local_y(e, i) = y;
}

void enemies_shift(struct enemies *e, uint32_t i, fx dx, fx dy)
{
    e->x[i] = motion_shift(e->x[i], dx);
    e->y[i] = motion_shift(e->y[i], dy);
    if (is_part(e, i)) {
        e->dx[i] = motion_shift(e->dx[i], dx);
        e->dy[i] = motion_shift(e->dy[i], dy);
    }
    if (e->lead_mode && e->lead_mode[i]) {
        e->cx[i] = motion_shift(e->cx[i], dx);
        e->cy[i] = motion_shift(e->cy[i], dy);
    }
    if (!e->move_duration[i])
        return;
    e->x0[i] = motion_shift(e->x0[i], dx);
    e->y0[i] = motion_shift(e->y0[i], dy);
    e->x1[i] = motion_shift(e->x1[i], dx);
    e->y1[i] = motion_shift(e->y1[i], dy);
}

static bool exceeds_max_speed(fx a, fx b)
{
    const int64_t limit = (int64_t)MAX_SPEED << 16;

    return (int64_t)a - b > limit || (int64_t)b - a > limit;
}

void enemies_postpone_frozen(struct enemies *e)
{
    if (!e->n_frozen)
        return;
    EACH_LIVE (i, &e->s)
        e->born[i] += e->freeze_flags[i] != 0;
}

/* Advances enemy i's move by a frame, and sets (*x, *y) to the result. */
static void step_move(struct enemies *e, uint32_t i, fx *x, fx *y)
{
    struct motion_share s = motion_ease((enum ease)e->ease[i], ++e->move_elapsed[i], e->move_duration[i]);

    *x = motion_lerp_share(e->x0[i], e->x1[i], s);
    *y = motion_lerp_share(e->y0[i], e->y1[i], s);
    if (e->move_elapsed[i] == e->move_duration[i])
        e->move_duration[i] = 0;
}

static void save_previous(struct enemies *e, uint32_t i, fx x, fx y)
{
    bool is_jump = exceeds_max_speed(e->x[i], x) || exceeds_max_speed(e->y[i], y);

    e->prev_x[i] = is_jump ? e->x[i] : x;
    e->prev_y[i] = is_jump ? e->y[i] : y;
}

void enemies_step_timers(struct enemies *e)
{
    EACH_LIVE (i, &e->s) {
        if (e->safe_left[i] > 0)
            e->safe_left[i]--;
        if (e->bank[i] >= ENEMY_BLINK_ONE)
            e->bank[i] -= ENEMY_BLINK_ONE;
    }
}

void enemies_blink(struct enemies *e, const struct enemy_kinds *kinds, uint32_t i)
{
    if (e->bank[i] < ENEMY_BLINK_ONE)
        e->bank[i] |= kinds->bank[e->kind[i]] & ENEMY_BLINK;
}

bool enemies_is_flashing(const struct enemies *e, const struct enemy_kinds *kinds, uint32_t i)
{
    return 4 * (e->bank[i] / ENEMY_BLINK_ONE) > 3 * (kinds->bank[e->kind[i]] / ENEMY_BLINK_ONE);
}

enum { SIDE_SPEED = FX_ONE / 2 }; /* px/frame from which an enemy shows its pictures `left` and `right` */

uint16_t enemies_sprite(const struct enemies *e, const struct enemy_kinds *kinds, uint32_t i)
{
    uint32_t kind = e->kind[i], n = e->flags[i] / ENEMY_PICTURE_ONE;
    const fx dx = e->x[i] - e->prev_x[i];

    if (n == 0 && kinds->flags[kind] & ENEMY_HURT_PICTURE) {
        if (e->bank[i] >= ENEMY_BLINK_ONE)
            n = 1;
        else if (kinds->flags[kind - 1] & ENEMY_SIDES && (dx >= SIDE_SPEED || dx <= -SIDE_SPEED))
            n = dx < 0 ? 2 : 3;
    }
    return kinds->sprite[kind - n];
}

/* ---- bodies ---- */

void enemies_attach(struct enemies *e, uint32_t i, uint32_t body, fx dx, fx dy, int32_t share)
{
    e->body[i] = (uint16_t)(body + 1);
    e->n_parts[body]++;
    e->dx[i] = dx;
    e->dy[i] = dy;
    e->damage_share[i] = share;
    e->x[i] = e->prev_x[i] = motion_shift(e->x[body], dx);
    e->y[i] = e->prev_y[i] = motion_shift(e->y[body], dy);
}

int enemies_part_depth(const struct enemies *e, uint32_t i)
{
    int n = 0;

    for (; e->body[i]; i = e->body[i] - 1u)
        n++;
    return n;
}

uint64_t enemies_scale_damage(uint64_t amount, int32_t share)
{
    const uint64_t s = (uint64_t)share, high = amount >> 16, limit = UINT64_MAX >> 1;

    if (s && high > limit / s)
        return limit;
    return high * s + ((amount & 0xffff) * s >> 16);
}

uint64_t enemies_damage(struct enemies *e, uint32_t i, uint64_t amount)
{
    const uint64_t exact_hp = ((uint64_t)e->hp[i] << 32) - e->hp_deficit[i],
                   n = enemies_scale_damage(amount, e->rate[i]);
    const uint64_t remaining_hp = n < exact_hp ? exact_hp - n : 0;

    e->hp[i] = (int32_t)((remaining_hp + UINT32_MAX) >> 32);
    e->hp_deficit[i] = (uint32_t)(((uint64_t)e->hp[i] << 32) - remaining_hp);
    return exact_hp - remaining_hp;
}

void enemies_start_orbit(struct enemies *e, uint32_t i, const struct enemies_orbit *o)
{
    begin_movement(e, i);
    e->lead_mode[i] = LEAD_ORBIT;
    e->orbit_target[i] = o->orbit_target;
    e->cx[i] = o->x;
    e->cy[i] = o->y;
    e->reach_x[i] = o->radius;
    e->reach_y[i] = o->radius_to;
    e->angle[i] = o->angle;
    e->spin[i] = o->spin;
    e->move_elapsed[i] = 0;
    e->move_duration[i] = o->duration;
}

void enemies_start_wandering(struct enemies *e, uint32_t i, const struct enemies_wander_area *area)
{
    begin_movement(e, i);
    e->lead_mode[i] = LEAD_WANDER;
    e->cx[i] = area->x;
    e->cy[i] = area->y;
    e->reach_x[i] = area->reach_x;
    e->reach_y[i] = area->reach_y;
    e->leg_interval[i] = area->leg_interval;
    e->leg_duration[i] = area->leg_duration;
    e->leg_wait[i] = 0;
    e->ease[i] = (uint8_t)area->ease;
}

static fx random_coordinate(const struct enemies_world *w, fx middle, fx reach)
{
    return motion_shift(middle, (fx)((int64_t)w->random_below(w->context, 2 * (uint64_t)reach + 1) - reach));
}

/* Starts the legs of the unfrozen wanderers that are due, and clears `move_begun` of all enemies. */
static void begin_legs(struct enemies *e, const struct enemies_world *w)
{
    EACH_LIVE (i, &e->s) {
        e->move_begun[i] = 0;
        if (e->lead_mode[i] != LEAD_WANDER || (e->frozen_left && e->frozen_left[i]))
            continue;
        if (!e->leg_wait[i]) {
            fx x = random_coordinate(w, e->cx[i], e->reach_x[i]), y = random_coordinate(w, e->cy[i], e->reach_y[i]);
            convert_to_local(e, i, &x, &y);
            begin_move(e, i, x, y, e->leg_duration[i], (enum ease)e->ease[i]);
            e->leg_wait[i] = e->leg_interval[i];
        }
        e->leg_wait[i]--;
    }
}

/* Advances enemy i's orbit by a frame, and sets (*x, *y) to the result. If the entity at the centre has despawned, the
 * orbit continues around that entity's last position. */
static void step_orbit(struct enemies *e, uint32_t i, struct enemies_world *w, fx *x, fx *y)
{
    const int64_t from = (int64_t)e->reach_x[i] * (1 << Q32_EXTRA_BITS),
                  to = (int64_t)e->reach_y[i] * (1 << Q32_EXTRA_BITS);
    const uint32_t k = ++e->move_elapsed[i], n = e->move_duration[i];

    if (e->orbit_target[i] && !w->get_position(w, e->orbit_target[i], &e->cx[i], &e->cy[i]))
        e->orbit_target[i] = 0;
    motion_offset_polar(e->cx[i], e->cy[i], n ? motion_lerp(from, to, k, n) : from, e->angle[i] + (ang)e->spin[i] * k,
                        x, y);
    convert_to_local(e, i, x, y);
    if (k == n)
        enemies_halt(e, i);
}

/* Sets part i's current and previous position: the body's, plus the part's offset now and before the move (prev_dx,
 * prev_dy). Hit tests thus sweep the body and the part along the same path. */
static void follow_body(struct enemies *e, uint32_t i, fx prev_dx, fx prev_dy)
{
    const uint32_t body = e->body[i] - 1u;

    e->x[i] = motion_shift(e->x[body], e->dx[i]);
    e->y[i] = motion_shift(e->y[body], e->dy[i]);
    save_previous(e, i, motion_shift(e->prev_x[body], prev_dx), motion_shift(e->prev_y[body], prev_dy));
}

void enemies_ensure_moved(struct enemies *e, uint32_t i, struct enemies_world *w)
{
    if (e->move_begun && e->move_begun[i])
        return;
    if (e->move_begun)
        e->move_begun[i] = 1;
    if (is_part(e, i))
        enemies_ensure_moved(e, e->body[i] - 1u, w);
    fx *x = local_x(e, i), *y = local_y(e, i), prev_x = *x, prev_y = *y;
    if (!motion_step_freeze(e->frozen_left, e->freeze_flags, i, &e->n_frozen)) {
        if (e->lead_mode && e->lead_mode[i] == LEAD_ORBIT)
            step_orbit(e, i, w, x, y);
        else if (e->move_duration[i])
            step_move(e, i, x, y);
    }
    if (is_part(e, i))
        follow_body(e, i, prev_x, prev_y);
    else
        save_previous(e, i, prev_x, prev_y);
}

/* ---- moving the enemies ---- */

static bool is_inside(const struct enemies *e, uint32_t i, const struct box *keep_box)
{
    return e->x[i] >= keep_box->x0 && e->x[i] <= keep_box->x1 && e->y[i] >= keep_box->y0 && e->y[i] <= keep_box->y1;
}

void enemies_turn(struct enemies *e, const struct enemy_kinds *kinds)
{
    EACH_LIVE (i, &e->s) {
        const fx dx = e->x[i] - e->prev_x[i], dy = e->y[i] - e->prev_y[i];
        if (kinds->flags[e->kind[i]] & ENEMY_TURNS && (dx || dy))
            e->dir[i] = trig_atan2(dy, dx);
    }
}

void enemies_move(struct enemies *e, const struct box *keep_box, struct enemies_world *w)
{
    e->n_leaving = 0;
    e->n_frozen = 0;
    if (e->rate)
        begin_legs(e, w);
    EACH_LIVE (i, &e->s) {
        enemies_ensure_moved(e, i, w);
        /* a boss may enter from outside *keep_box, and a part may reach outside it */
        if (e->flags[i] & (ENEMY_UNDYING | ENEMY_DYING) || is_part(e, i) || is_inside(e, i, keep_box))
            continue;
        e->flags[i] |= ENEMY_LEAVING;
        e->n_leaving++;
    }
    slots_trim(&e->s);
}

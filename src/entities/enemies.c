/*
 * enemies.c - the pool of enemies: spawning, damage, moves, and bodies with parts.
 */
#include "enemies.h"
#include "../base/int.h"

static const struct column kind_columns[] = {
    COLUMN(enemy_kinds, sprite), COLUMN(enemy_kinds, shape), COLUMN(enemy_kinds, a),
    COLUMN(enemy_kinds, b),      COLUMN(enemy_kinds, x),     COLUMN(enemy_kinds, y),
    COLUMN(enemy_kinds, hp),     COLUMN(enemy_kinds, score), COLUMN(enemy_kinds, bank),
    COLUMN(enemy_kinds, flags),  COLUMN(enemy_kinds, spark), GROUP_COLUMN(enemy_kinds, rate, GROUP_BODIES),
};

static const struct column columns[] = {
    COLUMN(enemies, x),
    COLUMN(enemies, y),
    DERIVED(enemies, was_x, "written by every move before hit tests read it"),
    DERIVED(enemies, was_y, "written by every move before hit tests read it"),
    COLUMN(enemies, hp),
    COLUMN(enemies, kind),
    COLUMN(enemies, bank),
    COLUMN(enemies, tag),
    COLUMN(enemies, safe),
    COLUMN(enemies, born),
    COLUMN(enemies, owner_task),
    COLUMN(enemies, owner),
    COLUMN(enemies, flags),
    COLUMN(enemies, x0),
    COLUMN(enemies, y0),
    COLUMN(enemies, x1),
    COLUMN(enemies, y1),
    COLUMN(enemies, made),
    COLUMN(enemies, over),
    COLUMN(enemies, ease),
    GROUP_COLUMN(enemies, value1, GROUP_VALUE + 0),
    GROUP_COLUMN(enemies, value2, GROUP_VALUE + 1),
    GROUP_COLUMN(enemies, value3, GROUP_VALUE + 2),
    GROUP_COLUMN(enemies, value4, GROUP_VALUE + 3),
    DERIVED_REGISTERS(enemies, value_start, "set only while scripts load, like names"),
    GROUP_COLUMN(enemies, frozen, GROUP_FROZEN),
    GROUP_COLUMN(enemies, stands, GROUP_FROZEN),
    DERIVED_REGISTER(enemies, standing, "the number of standing enemies, counted from the column `stands`"),
    DERIVED_REGISTER(enemies, leaving, "rewritten by every move before hit tests read it"),
    GROUP_COLUMN(enemies, rate, GROUP_BODIES),
    GROUP_COLUMN(enemies, wound, GROUP_BODIES),
    GROUP_COLUMN(enemies, body, GROUP_BODIES),
    GROUP_COLUMN(enemies, parts, GROUP_BODIES),
    GROUP_COLUMN(enemies, dx, GROUP_BODIES),
    GROUP_COLUMN(enemies, dy, GROUP_BODIES),
    GROUP_COLUMN(enemies, share, GROUP_BODIES),
    GROUP_COLUMN(enemies, lead, GROUP_BODIES),
    GROUP_COLUMN(enemies, cx, GROUP_BODIES),
    GROUP_COLUMN(enemies, cy, GROUP_BODIES),
    GROUP_COLUMN(enemies, reach_x, GROUP_BODIES),
    GROUP_COLUMN(enemies, reach_y, GROUP_BODIES),
    GROUP_COLUMN(enemies, around, GROUP_BODIES),
    GROUP_COLUMN(enemies, angle, GROUP_BODIES),
    GROUP_COLUMN(enemies, spin, GROUP_BODIES),
    GROUP_COLUMN(enemies, every, GROUP_BODIES),
    GROUP_COLUMN(enemies, due, GROUP_BODIES),
    GROUP_COLUMN(enemies, leg, GROUP_BODIES),
    GROUP_DERIVED(enemies, settled, GROUP_BODIES, "rewritten by every move"),
};

#define COUNT(table) (int)(sizeof table / sizeof *table)
const struct chip enemies_chip = { "enemies", columns, COUNT(columns), false, false };
const struct chip enemy_kinds_chip = { "enemy_kinds", kind_columns, COUNT(kind_columns), true, false };

static void park(struct enemies *e, uint32_t i)
{
    e->x[i] = e->y[i] = PARK;
    e->over[i] = 0;
}

/* Initialises the GROUP_BODIES columns of new enemy i with its kind's rate. The enemy is not a part and has none. */
static void begin_body(struct enemies *e, const struct enemy_kinds *kinds, uint32_t i)
{
    e->rate[i] = kinds->rate[e->kind[i]];
    e->wound[i] = 0;
    e->body[i] = e->parts[i] = 0;
    e->dx[i] = e->dy[i] = e->cx[i] = e->cy[i] = e->reach_x[i] = e->reach_y[i] = 0;
    e->share[i] = e->spin[i] = 0;
    e->angle[i] = 0;
    e->every[i] = e->due[i] = e->leg[i] = 0;
    e->lead[i] = 0;
    e->around[i] = 0;
}

int32_t enemies_spawn(struct enemies *e, const struct enemy_kinds *kinds, uint16_t kind, fx x, fx y, uint32_t clock)
{
    uint32_t top = e->s.top;
    int32_t i = slots_take(&e->s);

    if (i == NO_SLOT)
        return i;
    for (uint32_t k = top; k < e->s.top; k++)
        park(e, k);
    e->x[i] = e->was_x[i] = e->x0[i] = e->x1[i] = x;
    e->y[i] = e->was_y[i] = e->y0[i] = e->y1[i] = y;
    e->hp[i] = kinds->hp[kind];
    e->kind[i] = kind;
    e->bank[i] = kinds->bank[kind] & ENEMY_BANK;
    e->tag[i] = 0;
    e->safe[i] = 0;
    e->born[i] = clock;
    e->owner_task[i] = 0;
    e->owner[i] = 0;
    e->flags[i] = 0;
    e->made[i] = 0;
    e->over[i] = 0;
    e->ease[i] = EASE_LINEAR;
    for (int k = 0; k < MAX_VALUES && enemies_value(e, k); k++)
        enemies_value(e, k)[i] = e->value_start[k];
    if (e->frozen)
        e->frozen[i] = e->stands[i] = 0;
    if (e->rate)
        begin_body(e, kinds, (uint32_t)i);
    return i;
}

static void detach(struct enemies *e, uint32_t i)
{
    e->parts[e->body[i] - 1]--;
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
    if (e->parts && e->parts[i])
        drop_parts(e, i);
    slots_drop(&e->s, i);
    park(e, i);
}

void enemies_drop_of(struct enemies *e, int64_t owner)
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
static fx *led_x(const struct enemies *e, uint32_t i)
{
    return is_part(e, i) ? &e->dx[i] : &e->x[i];
}

static fx *led_y(const struct enemies *e, uint32_t i)
{
    return is_part(e, i) ? &e->dy[i] : &e->y[i];
}

/* Converts (*x, *y) from a position in the field to the coordinates that enemy i's moves change (led_x, led_y). */
static void led(const struct enemies *e, uint32_t i, fx *x, fx *y)
{
    if (!is_part(e, i))
        return;
    *x = fx_sub(*x, e->x[e->body[i] - 1]);
    *y = fx_sub(*y, e->y[e->body[i] - 1]);
}

static void set_out(struct enemies *e, uint32_t i, fx x, fx y, uint32_t over, enum ease ease)
{
    e->x0[i] = *led_x(e, i);
    e->y0[i] = *led_y(e, i);
    e->x1[i] = x;
    e->y1[i] = y;
    e->made[i] = 0;
    e->over[i] = over;
    e->ease[i] = (uint8_t)ease;
}

void enemies_halt(struct enemies *e, uint32_t i)
{
    e->over[i] = 0;
    if (e->lead) {
        e->lead[i] = 0;
        e->around[i] = 0;
    }
}

void enemies_go(struct enemies *e, uint32_t i, fx x, fx y, uint32_t over, enum ease ease)
{
    enemies_halt(e, i);
    led(e, i, &x, &y);
    set_out(e, i, x, y, over, ease);
}

static fx shifted(fx at, fx by)
{
    const fx edge = (fx)WORLD << 16;
    fx to = fx_add(at, by);

    return to > edge ? edge : to < -edge ? -edge : to;
}

void enemies_go_by(struct enemies *e, uint32_t i, fx dx, fx dy, uint32_t over, enum ease ease)
{
    const bool part = is_part(e, i);

    enemies_halt(e, i);
    set_out(e, i, part ? dx : shifted(e->x[i], dx), part ? dy : shifted(e->y[i], dy), over, ease);
}

void enemies_set_position(struct enemies *e, uint32_t i, fx x, fx y)
{
    enemies_halt(e, i);
    e->x[i] = x;
    e->y[i] = y;
    led(e, i, &x, &y);
    *led_x(e, i) = x;
    *led_y(e, i) = y;
}

void enemies_shift(struct enemies *e, uint32_t i, fx dx, fx dy)
{
    e->x[i] = shifted(e->x[i], dx);
    e->y[i] = shifted(e->y[i], dy);
    if (is_part(e, i)) {
        e->dx[i] = shifted(e->dx[i], dx);
        e->dy[i] = shifted(e->dy[i], dy);
    }
    if (e->lead && e->lead[i]) {
        e->cx[i] = shifted(e->cx[i], dx);
        e->cy[i] = shifted(e->cy[i], dy);
    }
    if (!e->over[i])
        return;
    e->x0[i] = shifted(e->x0[i], dx);
    e->y0[i] = shifted(e->y0[i], dy);
    e->x1[i] = shifted(e->x1[i], dx);
    e->y1[i] = shifted(e->y1[i], dy);
}

static bool far(fx a, fx b)
{
    const int64_t most = (int64_t)MAX_SPEED << 16;

    return (int64_t)a - b > most || (int64_t)b - a > most;
}

/* Counts down enemy i's frozen frames at the start of its move. Returns whether the enemy is frozen in this move. */
static bool stands(struct enemies *e, uint32_t i)
{
    if (!e->frozen)
        return false;
    bool is = e->frozen[i] != 0;
    e->frozen[i] -= e->frozen[i] > 0;
    e->stands[i] = is ? STOOD : 0;
    e->standing += is;
    return is;
}

void enemies_stay(struct enemies *e)
{
    if (!e->standing)
        return;
    EACH_LIVE (i, &e->s)
        e->born[i] += e->stands[i] != 0;
}

/* Advances enemy i's move by a frame, and sets (*x, *y) to the result. */
static void go_on(struct enemies *e, uint32_t i, fx *x, fx *y)
{
    struct motion_share s = motion_eased((enum ease)e->ease[i], ++e->made[i], e->over[i]);

    *x = motion_between(e->x0[i], e->x1[i], s);
    *y = motion_between(e->y0[i], e->y1[i], s);
    if (e->made[i] == e->over[i])
        e->over[i] = 0;
}

static void keep_was(struct enemies *e, uint32_t i, fx x, fx y)
{
    bool jump = far(e->x[i], x) || far(e->y[i], y);

    e->was_x[i] = jump ? e->x[i] : x;
    e->was_y[i] = jump ? e->y[i] : y;
}

static void step(struct enemies *e, uint32_t i)
{
    fx x = e->x[i], y = e->y[i];

    if (!stands(e, i) && e->over[i])
        go_on(e, i, &e->x[i], &e->y[i]);
    keep_was(e, i, x, y);
}

void enemies_count_down(struct enemies *e)
{
    EACH_LIVE (i, &e->s) {
        if (e->safe[i] > 0)
            e->safe[i]--;
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

uint16_t enemies_picture(const struct enemies *e, const struct enemy_kinds *kinds, uint32_t i)
{
    uint32_t kind = e->kind[i], n = e->flags[i] / ENEMY_PICTURE_ONE;

    if (n == 0 && e->bank[i] >= ENEMY_BLINK_ONE && kinds->flags[kind] & ENEMY_HURT)
        n = 1;
    return kinds->sprite[kind - n];
}

/* ---- bodies ---- */

void enemies_attach(struct enemies *e, uint32_t i, uint32_t body, fx dx, fx dy, int32_t share)
{
    e->body[i] = (uint16_t)(body + 1);
    e->parts[body]++;
    e->dx[i] = dx;
    e->dy[i] = dy;
    e->share[i] = share;
    e->x[i] = e->was_x[i] = shifted(e->x[body], dx);
    e->y[i] = e->was_y[i] = shifted(e->y[body], dy);
}

int enemies_depth(const struct enemies *e, uint32_t i)
{
    int n = 0;

    for (; e->body[i]; i = e->body[i] - 1u)
        n++;
    return n;
}

uint64_t enemies_share(uint64_t amount, int32_t share)
{
    const uint64_t s = (uint64_t)share, high = amount >> 16, most = UINT64_MAX >> 1;

    if (s && high > most / s)
        return most;
    return high * s + ((amount & 0xffff) * s >> 16);
}

uint64_t enemies_damage(struct enemies *e, uint32_t i, uint64_t amount)
{
    const uint64_t had = ((uint64_t)e->hp[i] << 32) - e->wound[i], n = enemies_share(amount, e->rate[i]);
    const uint64_t left = n < had ? had - n : 0;

    e->hp[i] = (int32_t)((left + UINT32_MAX) >> 32);
    e->wound[i] = (uint32_t)(((uint64_t)e->hp[i] << 32) - left);
    return had - left;
}

void enemies_circle(struct enemies *e, uint32_t i, const struct enemies_orbit *o)
{
    enemies_halt(e, i);
    e->lead[i] = LEAD_ORBIT;
    e->around[i] = o->around;
    e->cx[i] = o->x;
    e->cy[i] = o->y;
    e->reach_x[i] = o->radius;
    e->reach_y[i] = o->radius_to;
    e->angle[i] = o->angle;
    e->spin[i] = o->spin;
    e->made[i] = 0;
    e->over[i] = o->over;
}

void enemies_wander(struct enemies *e, uint32_t i, const struct enemies_ground *g)
{
    enemies_halt(e, i);
    e->lead[i] = LEAD_WANDER;
    e->cx[i] = g->x;
    e->cy[i] = g->y;
    e->reach_x[i] = g->reach_x;
    e->reach_y[i] = g->reach_y;
    e->every[i] = g->every;
    e->leg[i] = g->leg;
    e->due[i] = 0;
    e->ease[i] = (uint8_t)g->ease;
}

static fx within(const struct enemies_world *w, fx middle, fx reach)
{
    return shifted(middle, (fx)((int64_t)w->draw(w->context, 2 * (uint64_t)reach + 1) - reach));
}

/* Starts the legs of the unfrozen wanderers that are due, and clears `settled` of all enemies. */
static void begin_legs(struct enemies *e, const struct enemies_world *w)
{
    EACH_LIVE (i, &e->s) {
        e->settled[i] = 0;
        if (e->lead[i] != LEAD_WANDER || (e->frozen && e->frozen[i]))
            continue;
        if (!e->due[i]) {
            fx x = within(w, e->cx[i], e->reach_x[i]), y = within(w, e->cy[i], e->reach_y[i]);
            led(e, i, &x, &y);
            set_out(e, i, x, y, e->leg[i], (enum ease)e->ease[i]);
            e->due[i] = e->every[i];
        }
        e->due[i]--;
    }
}

/* Advances enemy i's orbit by a frame, and sets (*x, *y) to the result. If the entity at the centre has despawned, the
 * orbit continues around that entity's last position. */
static void orbit(struct enemies *e, uint32_t i, struct enemies_world *w, fx *x, fx *y)
{
    const int64_t from = (int64_t)e->reach_x[i] * (1 << PACE_BITS), to = (int64_t)e->reach_y[i] * (1 << PACE_BITS);
    const uint32_t k = ++e->made[i], n = e->over[i];

    if (e->around[i] && !w->where(w, e->around[i], &e->cx[i], &e->cy[i]))
        e->around[i] = 0;
    motion_round(e->cx[i], e->cy[i], n ? motion_part_way(from, to, k, n) : from, e->angle[i] + (ang)e->spin[i] * k, x,
                 y);
    led(e, i, x, y);
    if (k == n)
        enemies_halt(e, i);
}

/* Sets part i's position now and before this frame's move from the body's and from the part's offsets; (was_dx, was_dy)
 * is the offset before the move. Hit tests thus sweep the body and the part along the same path. */
static void follow(struct enemies *e, uint32_t i, fx was_dx, fx was_dy)
{
    const uint32_t body = e->body[i] - 1u;

    e->x[i] = shifted(e->x[body], e->dx[i]);
    e->y[i] = shifted(e->y[body], e->dy[i]);
    keep_was(e, i, shifted(e->was_x[body], was_dx), shifted(e->was_y[body], was_dy));
}

void enemies_settle(struct enemies *e, uint32_t i, struct enemies_world *w)
{
    if (e->settled[i])
        return;
    e->settled[i] = 1;
    if (is_part(e, i))
        enemies_settle(e, e->body[i] - 1u, w);
    fx *x = led_x(e, i), *y = led_y(e, i), was_x = *x, was_y = *y;
    if (!stands(e, i)) {
        if (e->lead[i] == LEAD_ORBIT)
            orbit(e, i, w, x, y);
        else if (e->over[i])
            go_on(e, i, x, y);
    }
    if (is_part(e, i))
        follow(e, i, was_x, was_y);
    else
        keep_was(e, i, was_x, was_y);
}

/* ---- the move of all enemies ---- */

static bool inside(const struct enemies *e, uint32_t i, const struct box *keep)
{
    return e->x[i] >= keep->x0 && e->x[i] <= keep->x1 && e->y[i] >= keep->y0 && e->y[i] <= keep->y1;
}

void enemies_move(struct enemies *e, const struct box *keep, struct enemies_world *w)
{
    e->leaving = 0;
    e->standing = 0;
    if (e->rate)
        begin_legs(e, w);
    EACH_LIVE (i, &e->s) {
        if (e->rate)
            enemies_settle(e, i, w);
        else
            step(e, i);
        /* a boss may enter from outside *keep, and a part may reach outside *keep */
        if (e->flags[i] & (ENEMY_UNDYING | ENEMY_DYING) || is_part(e, i) || inside(e, i, keep))
            continue;
        e->flags[i] |= ENEMY_LEAVING;
        e->leaving++;
    }
    slots_trim(&e->s);
}

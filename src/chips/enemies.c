/*
 * enemies.c - see enemies.h.
 */
#include "enemies.h"

static const struct column kind_columns[] = {
    COLUMN(enemy_kinds, sprite), COLUMN(enemy_kinds, shape), COLUMN(enemy_kinds, a),     COLUMN(enemy_kinds, b),
    COLUMN(enemy_kinds, x),      COLUMN(enemy_kinds, y),     COLUMN(enemy_kinds, hp),    COLUMN(enemy_kinds, score),
    COLUMN(enemy_kinds, bank),   COLUMN(enemy_kinds, flags), COLUMN(enemy_kinds, spark),
};

static const struct column columns[] = {
    COLUMN(enemies, x),
    COLUMN(enemies, y),
    DERIVED(enemies, was_x, "written by every move before hits read it"),
    DERIVED(enemies, was_y, "written by every move before hits read it"),
    COLUMN(enemies, hp),
    COLUMN(enemies, kind),
    COLUMN(enemies, bank),
    COLUMN(enemies, tag),
    COLUMN(enemies, safe),
    COLUMN(enemies, born),
    COLUMN(enemies, by),
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
    DERIVED_REGISTERS(enemies, value_start, "set while scripts load, as names are, and never after"),
    GROUP_COLUMN(enemies, frozen, GROUP_FROZEN),
    GROUP_COLUMN(enemies, stands, GROUP_FROZEN),
    DERIVED_REGISTER(enemies, standing, "how many enemies stood, by the column stands"),
    DERIVED_REGISTER(enemies, leaving, "rewritten by every move before hits read it"),
};

#define COUNT(table) (int)(sizeof table / sizeof *table)
const struct chip enemies_chip = { "enemies", columns, COUNT(columns), false, false };
const struct chip enemy_kinds_chip = { "enemy_kinds", kind_columns, COUNT(kind_columns), true, false };

static void park(struct enemies *e, uint32_t i)
{
    e->x[i] = e->y[i] = PARK;
    e->over[i] = 0;
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
    e->by[i] = 0;
    e->owner[i] = 0;
    e->flags[i] = 0;
    e->made[i] = 0;
    e->over[i] = 0;
    e->ease[i] = EASE_LINEAR;
    for (int k = 0; k < MAX_VALUES && enemies_value(e, k); k++)
        enemies_value(e, k)[i] = e->value_start[k];
    if (e->frozen)
        e->frozen[i] = e->stands[i] = 0;
    return i;
}

void enemies_drop(struct enemies *e, uint32_t i)
{
    slots_drop(&e->s, i);
    park(e, i);
}

void enemies_drop_of(struct enemies *e, int64_t owner)
{
    EACH_LIVE (i, &e->s)
        if (e->owner[i] == owner && !(e->flags[i] & ENEMY_DYING))
            enemies_drop(e, i);
}

void enemies_go(struct enemies *e, uint32_t i, fx x, fx y, uint32_t over, enum ease ease)
{
    e->x0[i] = e->x[i];
    e->y0[i] = e->y[i];
    e->x1[i] = x;
    e->y1[i] = y;
    e->made[i] = 0;
    e->over[i] = over;
    e->ease[i] = (uint8_t)ease;
}

static fx shifted(fx at, fx by)
{
    const fx edge = (fx)WORLD << 16;
    fx to = fx_add(at, by);

    return to > edge ? edge : to < -edge ? -edge : to;
}

void enemies_shift(struct enemies *e, uint32_t i, fx dx, fx dy)
{
    e->x[i] = shifted(e->x[i], dx);
    e->y[i] = shifted(e->y[i], dy);
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

/* Does it stand in this move? */
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

static void step(struct enemies *e, uint32_t i)
{
    fx x = e->x[i], y = e->y[i];

    if (!stands(e, i) && e->over[i]) {
        struct motion_share s = motion_eased((enum ease)e->ease[i], ++e->made[i], e->over[i]);
        e->x[i] = motion_between(e->x0[i], e->x1[i], s);
        e->y[i] = motion_between(e->y0[i], e->y1[i], s);
        if (e->made[i] == e->over[i])
            e->over[i] = 0;
    }
    bool jump = far(e->x[i], x) || far(e->y[i], y);
    e->was_x[i] = jump ? e->x[i] : x;
    e->was_y[i] = jump ? e->y[i] : y;
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

bool enemies_white(const struct enemies *e, const struct enemy_kinds *kinds, uint32_t i)
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

void enemies_move(struct enemies *e, const struct box *keep)
{
    e->leaving = 0;
    e->standing = 0;
    EACH_LIVE (i, &e->s) {
        step(e, i);
        if (e->flags[i] & (ENEMY_UNDYING | ENEMY_DYING)) /* a boss may come from further away */
            continue;
        if (e->x[i] >= keep->x0 && e->x[i] <= keep->x1 && e->y[i] >= keep->y0 && e->y[i] <= keep->y1)
            continue;
        e->flags[i] |= ENEMY_LEAVING;
        e->leaving++;
    }
    slots_trim(&e->s);
}

/*
 * enemies.c - see enemies.h. Easing is quadratic. The share of a move is a fraction of whole numbers, and a place is
 * rounded once.
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
    e->bank[i] = kinds->bank[kind];
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

/* A share of a move: part / whole, exactly; part <= whole < 2^62. */
struct share {
    uint64_t part, whole;
};

/* After k of n frames, n < 2^31. */
static struct share eased(enum ease ease, uint64_t k, uint64_t n)
{
    uint64_t rest = n - k, whole = n * n;

    switch (ease) {
    case EASE_IN:
        return (struct share){ k * k, whole };
    case EASE_OUT:
        return (struct share){ whole - rest * rest, whole };
    case EASE_BOTH:
        return (struct share){ 2 * k < n ? 2 * k * k : whole - 2 * rest * rest, whole };
    default:
        return (struct share){ k, n };
    }
}

/* d * s, cut to a whole number; *left of s.whole is over. A bit a step, where the product may be too long. */
static uint32_t share_bits(uint32_t d, struct share s, uint64_t *left)
{
    uint32_t q = 0;

    *left = 0;
    for (int bit = 31; bit >= 0; bit--) {
        *left = 2 * *left + (d >> bit & 1 ? s.part : 0); /* < 3 whole */
        q *= 2;
        for (; *left >= s.whole; *left -= s.whole)
            q++;
    }
    return q;
}

static uint32_t share_of(uint32_t d, struct share s, uint64_t *left)
{
    if (s.whole >> 32)
        return share_bits(d, s, left);
    uint64_t product = d * s.part;
    *left = product % s.whole;
    return (uint32_t)(product / s.whole);
}

/* a, and a share of the way to b: the place nearest to it, ties to the even one. */
static fx between(fx a, fx b, struct share s)
{
    uint32_t d = a < b ? (uint32_t)b - (uint32_t)a : (uint32_t)a - (uint32_t)b;
    uint64_t left;
    uint32_t q = share_of(d, s, &left);
    uint64_t to_next = s.whole - left;

    q += (left > to_next) | ((left == to_next) & ((uint32_t)a ^ q) & 1);
    return (fx)(a < b ? (uint32_t)a + q : (uint32_t)a - q);
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
        struct share s = eased((enum ease)e->ease[i], ++e->made[i], e->over[i]);
        e->x[i] = between(e->x0[i], e->x1[i], s);
        e->y[i] = between(e->y0[i], e->y1[i], s);
        if (e->made[i] == e->over[i])
            e->over[i] = 0;
    }
    bool jump = far(e->x[i], x) || far(e->y[i], y);
    e->was_x[i] = jump ? e->x[i] : x;
    e->was_y[i] = jump ? e->y[i] : y;
}

void enemies_count_down(struct enemies *e)
{
    EACH_LIVE (i, &e->s)
        if (e->safe[i] > 0)
            e->safe[i]--;
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

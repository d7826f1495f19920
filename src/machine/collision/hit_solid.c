/*
 * hit_solid.c - shots against bullets: all shots hit bullets with hp; shots that cancel also hit all clearable bullets.
 * See hit_parts.h.
 *
 * There is no grid: each shot searches the pool, a block at a time, for bullets whose final position is near the shot's
 * path, and tests these bullets. The cost is the number of shots times the number of blocks with bullets to search
 * (docs/guide/21-capacities.md); it is counted as work.
 */
#include "hit_parts.h"
#include "../../base/int.h"
#include "hit.h"

enum { WORK_PER_BLOCK = 4, WORK_PER_TEST = 4 /* work per block searched; per pair of pieces tested */ };

static bool any_kind_cancels(const struct bullet_kinds *k)
{
    for (uint32_t i = 0; i < k->s.live; i++)
        if (k->flags[i] & KIND_CANCELS)
            return true;
    return false;
}

bool hit_solid_is_possible(const struct board *b)
{
    const struct slots *s = &b->shots.s;

    return (s->live || s->held_count) && b->bullets.s.live + b->bullets.s.held_count &&
           (b->bullets.hp || any_kind_cancels(&b->shot_kinds));
}

/* Returns the farthest that a kind's shape extends from its position. */
static fx max_extent(const struct bullet_kinds *k, uint32_t kind)
{
    const struct shape_columns shapes = hit_bullet_shapes(k);
    const struct extent e = hit_extent(&shapes, kind);

    return fx_max(e.x, e.y);
}

static void add_work(struct board *b, uint64_t work)
{
    if (!board_charge_work(b, work))
        board_raise_overload(b,
                             "shots that hit bullets: too much work in one frame (%u shots, %u bullets); lower "
                             "`board.shots` or `board.bullets` in rom.lua or fire fewer shots that cancel",
                             b->shots.s.live, b->bullets.s.live);
}

static bool shot_touches(struct board *b, uint32_t i, const struct body *shot, uint32_t k, const struct body *bullet,
                         bool swept)
{
    struct body p[SHAPE_MAX_CIRCLES], q[SHAPE_MAX_CIRCLES];

    if ((shot->shape | bullet->shape) <= SHAPE_MAX_SIMPLE) {
        add_work(b, WORK_PER_TEST);
        return hit_touches(shot, bullet, swept);
    }
    const uint32_t n = hit_split_bullet(&b->shots, &b->shot_kinds, i, p),
                   m = hit_split_bullet(&b->bullets, &b->bullet_kinds, k, q);
    add_work(b, (uint64_t)WORK_PER_TEST * n * m);
    return hit_any_bodies_touch(p, n, q, m, swept);
}

bool hit_find_solids(struct board *b, struct hit_solids *f)
{
    f->any_solid = b->bullets.hp && bullets_update_solid(&b->bullets);
    f->reach = 0;
    for (uint32_t i = 0; i < b->bullet_kinds.s.live; i++)
        f->reach = int64_max(f->reach, max_extent(&b->bullet_kinds, i));
    return f->any_solid || any_kind_cancels(&b->shot_kinds);
}

/* Returns the bits of those `candidates` (bullets of a block) whose kind and state let a shot hit them. any_solid: as
 * in struct hit_solids; cancels: the shot cancels bullets. */
static uint64_t hittable_mask(const struct bullets *s, const struct bullet_kinds *k, bool any_solid, bool cancels,
                              uint32_t block, uint64_t candidates)
{
    uint64_t found = any_solid ? candidates & s->solid[block] : 0;

    for (uint64_t m = cancels ? candidates & ~found : 0; m; m &= m - 1) {
        uint32_t i = block * SLOTS_BLOCK + bits_lowest(m);
        if (!(k->flags[s->kind[i]] & KIND_FIXED) && !(s->flags[i] & BULLET_DELAYED))
            found |= m & -m;
    }
    return found;
}

int32_t hit_find_nearest_solid(struct board *b, const struct hit_solids *f, uint32_t i,
                               const struct hit_pierced_targets *pierced, uint64_t *distance_sq)
{
    const struct bullets *s = &b->bullets;
    const struct body shot = hit_bullet_body(&b->shots, &b->shot_kinds, i);
    const unsigned flags = b->shot_kinds.flags[b->shots.kind[i]];
    const int64_t reach =
        f->reach + max_extent(&b->shot_kinds, b->shots.kind[i]) + int64_max(int64_abs(shot.mx), int64_abs(shot.my));
    int32_t found = NO_SLOT;

    if (shot.shape == SHAPE_NONE || !(f->any_solid || flags & KIND_CANCELS))
        return NO_SLOT;
    add_work(b, WORK_PER_BLOCK * (uint64_t)(s->s.top / SLOTS_BLOCK));
    for (uint32_t block = 0; block < s->s.top / SLOTS_BLOCK; block++) {
        if (!(flags & KIND_CANCELS) && !s->solid[block])
            continue;
        uint64_t m = bullets_find_near(s, block, shot.x, shot.y, reach);
        for (m = hittable_mask(s, &b->bullet_kinds, f->any_solid, flags & KIND_CANCELS, block, m); m; m &= m - 1) {
            uint32_t k = block * SLOTS_BLOCK + bits_lowest(m);
            struct body body = hit_bullet_body(s, &b->bullet_kinds, k);
            int64_t dx = ((int64_t)shot.x - shot.mx) - ((int64_t)body.x - body.mx);
            int64_t dy = ((int64_t)shot.y - shot.my) - ((int64_t)body.y - body.my);
            uint64_t d = (uint64_t)dx * (uint64_t)dx + (uint64_t)dy * (uint64_t)dy;
            if (d >= *distance_sq || hit_pierced_contains(pierced, H_BULLET, k))
                continue;
            if (!shot_touches(b, i, &shot, k, &body, flags & KIND_SWEPT))
                continue;
            *distance_sq = d;
            found = (int32_t)k;
        }
    }
    return found;
}

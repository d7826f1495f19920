/*
 * hit_lasers.c - lasers against players, and players' lasers against enemies. See hit_parts.h.
 *
 * A laser hits everything within half its hitting width of its line. The hitting width is the width as drawn, times the
 * share that the laser's kind sets. During the frame, the player and both ends of each segment of the line move
 * independently (geom_swept_bar).
 */
#include "hit_parts.h"
#include "../lasers_run.h"

enum {
    WORK_PER_LASER = 2,
    WORK_PER_CORNER = 8 /* work per laser and enemy; per corner of the laser and piece of the enemy */
};

fx hit_laser_reach(const struct board *b, uint32_t i, uint32_t age)
{
    const struct lasers *l = &b->lasers;
    const fx share = b->laser_kinds.hit_share[b->laser_heads.kind[i]];
    const enum laser_state s = lasers_state_of(b, i, age);

    if (share < 0 || s == LASER_WARN || s == LASER_FADE)
        return -1;
    return fx_mul(lasers_width(l, i, age) / 2, share);
}

static int64_t reach_of(const struct board *b, uint32_t i)
{
    return hit_laser_reach(b, i, lasers_age(b, i));
}

/* Returns the box around this frame's movement of circle c, grown by `reach`: a laser line that never enters the box is
 * never within `reach` of the circle. */
static struct box swept_box(const struct body *c, int64_t reach)
{
    const int64_t margin = reach + c->a;
    const fx was_x = fx_sub(c->x, c->mx), was_y = fx_sub(c->y, c->my);

    return (struct box){ fx_sat(fx_min(c->x, was_x) - margin), fx_sat(fx_min(c->y, was_y) - margin),
                         fx_sat(fx_max(c->x, was_x) + margin), fx_sat(fx_max(c->y, was_y) + margin) };
}

struct point {
    fx x, y;
};

/* Returns whether all n points are beyond the same side of the box; then so is their convex hull. */
static bool all_beyond_side(const struct box *w, const struct point *p, int n)
{
    int left = 0, right = 0, above = 0, below = 0;

    for (int k = 0; k < n; k++) {
        left += p[k].x < w->x0;
        right += p[k].x > w->x1;
        above += p[k].y < w->y0;
        below += p[k].y > w->y1;
    }
    return left == n || right == n || above == n || below == n;
}

/* Returns whether the box around curve i's points and the previous position of its tail touches box w. */
static bool curve_is_near(const struct board *b, uint32_t i, const struct box *w)
{
    struct box box;

    lasers_get_box(&b->lasers, &b->laser_points, i, &box);
    return box.x0 <= w->x1 && box.x1 >= w->x0 && box.y0 <= w->y1 && box.y1 >= w->y0;
}

static bool segment_is_near(const struct board *b, uint32_t i, uint32_t k, const struct box *w)
{
    const uint32_t next = k + 1 < lasers_corner_count(b, i) ? k + 1 : k;
    struct point p[4];

    lasers_get_corner(b, i, k, &p[0].x, &p[0].y);
    lasers_get_corner(b, i, next, &p[1].x, &p[1].y);
    lasers_get_old_corner(b, i, next, &p[2].x, &p[2].y);
    if (b->lasers.form[i] == LASER_CURVE && !(b->lasers.flags[i] & LASER_UNSWEPT))
        return !all_beyond_side(w, p, 3); /* corner k moved here from p[1], where the next corner is now */
    lasers_get_old_corner(b, i, k, &p[3].x, &p[3].y);
    return !all_beyond_side(w, p, 4);
}

/* Returns segment k of laser i relative to the body c, both swept. */
static struct geom_bar segment_bar(const struct board *b, uint32_t i, uint32_t k, const struct body *c)
{
    const struct lasers_segment old = lasers_get_old_segment(b, i, k), now = lasers_get_segment(b, i, k);
    const int64_t x = (int64_t)c->x - c->mx, y = (int64_t)c->y - c->my;

    return (struct geom_bar){
        old.x - x,    old.y - y,    (int64_t)now.x - old.x - c->mx,       (int64_t)now.y - old.y - c->my,
        old.to_x - x, old.to_y - y, (int64_t)now.to_x - old.to_x - c->mx, (int64_t)now.to_y - old.to_y - c->my
    };
}

bool hit_laser_touches_circle(const struct board *b, uint32_t i, const struct body *c, int64_t reach)
{
    const uint32_t segments = lasers_segment_count(b, i);
    const struct box swept = swept_box(c, reach);

    if (b->lasers.form[i] == LASER_CURVE && !curve_is_near(b, i, &swept))
        return false;
    for (uint32_t k = 0; k < segments; k++) {
        if (!segment_is_near(b, i, k, &swept))
            continue;
        struct geom_bar bar = segment_bar(b, i, k, c);
        if (geom_swept_bar(&bar, reach + c->a))
            return true;
    }
    return false;
}

/* Returns whether laser i touches e, a box or capsule, both at their final positions of the frame. */
static bool touches_at_end(const struct board *b, uint32_t i, const struct body *e, int64_t reach)
{
    const uint32_t segments = lasers_segment_count(b, i);

    for (uint32_t k = 0; k < segments; k++) {
        const struct lasers_segment s = lasers_get_segment(b, i, k);
        const int64_t dx = (int64_t)s.x - e->x, dy = (int64_t)s.y - e->y, wx = (int64_t)s.to_x - s.x,
                      wy = (int64_t)s.to_y - s.y, hx = e->b, hy = e->c;
        const struct geom_bar bar = {
            dx + hx, dy + hy, -2 * hx, -2 * hy, dx + wx + hx, dy + wy + hy, -2 * hx, -2 * hy
        };
        if (e->shape == SHAPE_BOX ? geom_swept_circle_box(dx, dy, wx, wy, reach, e->a, e->b)
                                  : geom_swept_bar(&bar, reach + e->a))
            return true;
    }
    return false;
}

bool hit_laser_touches_enemy(const struct board *b, uint32_t i, uint32_t enemy)
{
    const int64_t reach = reach_of(b, i);
    struct body piece[SHAPE_MAX_CIRCLES];
    const uint32_t n = hit_split_enemy(b, enemy, piece);

    for (uint32_t k = 0; k < n && reach >= 0; k++) {
        if (piece[k].shape == SHAPE_NONE)
            continue;
        if (piece[k].shape == SHAPE_CIRCLE ? hit_laser_touches_circle(b, i, &piece[k], reach)
                                           : touches_at_end(b, i, &piece[k], reach))
            return true;
    }
    return false;
}

static void raise_overload(struct board *b, const char *pool, uint32_t n)
{
    board_raise_overload(
        b,
        "laser hits: too much work in one frame (%u lasers, %u %s); lower `board.lasers` or `board.%s` in "
        "rom.lua or make curves shorter",
        b->lasers.s.live, n, pool, pool);
}

void hit_charge_laser(struct board *b, uint32_t i, uint32_t enemy)
{
    const uint16_t kind = b->enemies.kind[enemy];
    const uint32_t pieces = b->enemy_kinds.shape[kind] & SHAPE_CIRCLES ? (uint32_t)b->enemy_kinds.b[kind] + 1 : 1;

    if (!board_charge_work(b, WORK_PER_LASER + WORK_PER_CORNER * (uint64_t)lasers_corner_count(b, i) * pieces))
        raise_overload(b, "enemies", b->enemies.s.live);
}

/* Raises the event of laser i hitting player p or, if it does not hit, of grazing the player. */
static void raise_hit(struct board *b, uint32_t p, const struct body *c, uint32_t i)
{
    const struct laser_kinds *k = &b->laser_kinds;
    const uint16_t kind = b->laser_heads.kind[i];
    const int64_t reach = reach_of(b, i), laser = board_handle(b, H_LASER, (int32_t)i);
    struct body ring = *c;

    if (reach < 0 || k->flags[kind] & LASER_HITS_ENEMIES)
        return;
    b->counts.tested++;
    if (hit_laser_touches_circle(b, i, c, reach)) {
        b->counts.hit++;
        board_raise_event(b, EV_HIT, board_handle(b, H_PLAYER, (int32_t)p), laser);
        return;
    }
    ring.a = b->player_kinds.graze_radius[b->player.kind[p]];
    if (!k->graze_interval[kind] || b->core.clock < b->lasers.rehit_clock[i * MAX_PLAYERS + p] ||
        !hit_laser_touches_circle(b, i, &ring, reach))
        return;
    b->counts.grazed++;
    board_raise_event(b, EV_GRAZE, board_handle(b, H_PLAYER, (int32_t)p), laser);
}

void hit_test_lasers(struct board *b, uint32_t p, const struct body *c)
{
    EACH_LIVE (i, &b->lasers.s)
        raise_hit(b, p, c, i);
}

static bool touches_any_enemy(struct board *b, uint32_t i)
{
    EACH_LIVE (e, &b->enemies.s) {
        if (b->enemies.flags[e] & ENEMY_DYING)
            continue;
        hit_charge_laser(b, i, e);
        if (hit_laser_touches_enemy(b, i, e))
            return true;
    }
    return false;
}

void hit_test_player_lasers(struct board *b)
{
    EACH_LIVE (i, &b->lasers.s)
        if (b->laser_kinds.flags[b->laser_heads.kind[i]] & LASER_HITS_ENEMIES &&
            b->core.clock >= b->lasers.rehit_clock[i * MAX_PLAYERS] && touches_any_enemy(b, i))
            board_raise_event(b, EV_LASER, board_handle(b, H_LASER, (int32_t)i), 0);
}

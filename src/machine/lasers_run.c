/*
 * lasers_run.c - see lasers_run.h.
 *
 * A laser and its head, a bullet, are allocated and released together, so they have the same slot and generation.
 */
#include "lasers_run.h"
#include <assert.h>
#include "../base/geom.h"
#include "../base/int.h"

static const int64_t max_move = (int64_t)MAX_SPEED << 16;

uint32_t lasers_age(const struct board *b, uint32_t i)
{
    return bullets_age(&b->laser_heads, i, b->core.clock);
}

uint32_t lasers_shown_age(const struct board *b, uint32_t i)
{
    uint32_t age = lasers_age(b, i);

    return age - (age > 0);
}

enum laser_state lasers_state_of(const struct board *b, uint32_t i, uint32_t age)
{
    if (b->laser_heads.flags[i] & BULLET_DELAYED)
        return LASER_WARN;
    return lasers_state(&b->lasers, i, age);
}

static bool is_dangerous(const struct board *b, uint32_t i, uint32_t age)
{
    enum laser_state s = lasers_state_of(b, i, age);

    return s == LASER_GROW || s == LASER_ON;
}

void lasers_update_tail(struct board *b, uint32_t i)
{
    struct lasers *l = &b->lasers;
    const struct bullets *h = &b->laser_heads;
    const bool is_beam = l->form[i] == LASER_BEAM;
    fx dx, dy;

    if (l->form[i] == LASER_CURVE)
        return;
    trig_polar(is_beam ? l->length[i] : l->grown_length[i], h->dir[i], &dx, &dy);
    l->x0[i] = is_beam ? h->x[i] + dx : h->x[i] - dx;
    l->y0[i] = is_beam ? h->y[i] + dy : h->y[i] - dy;
}

void lasers_move_to(struct board *b, uint32_t i, fx x, fx y)
{
    struct bullets *h = &b->laser_heads;

    lasers_shift(&b->lasers, &b->laser_points, i, fx_sub(x, h->x[i]), fx_sub(y, h->y[i]));
    h->x[i] = x;
    h->y[i] = y;
    lasers_update_tail(b, i);
}

int32_t lasers_fire(struct board *b, const struct bullet_spec *head, struct laser_spec *spec)
{
    struct slots *full_pool;
    int32_t i = lasers_add(&b->lasers, &b->laser_points, spec, head->x, head->y, &full_pool);

    if (i == NO_SLOT) {
        board_report_full(b, full_pool);
        return i;
    }
    int32_t slot = bullets_fire(&b->laser_heads, head, b->core.clock);
    assert(slot == i); /* invariant: the two pools have the same slots */
    (void)slot;
    lasers_update_tail(b, (uint32_t)i);
    return i;
}

void lasers_remove(struct board *b, uint32_t i)
{
    bullets_drop(&b->laser_heads, i);
    lasers_drop(&b->lasers, &b->laser_points, i);
    slots_trim(&b->laser_heads.s);
}

/* ---- moving lasers ---- */

/* Stores the present position of an entity or, with `before_move`, its position before this frame's move. Entities
 * other than lasers have already moved. For a laser both are the position before the move, so that the order of slots
 * does not matter. */
static bool get_entity_position(const struct motion_world *w, int64_t entity, uint32_t moved, bool before_move, fx *x,
                                fx *y)
{
    const struct board *b = w->context;
    const enum handle_kind kind = handle_kind(entity);
    const struct bullets *s = kind == H_SHOT ? &b->shots : &b->bullets;
    const uint32_t i = handle_slot(entity);

    (void)moved;
    if (!board_is_alive(b, entity) || !board_get_position(b, entity, x, y))
        return false;
    if (kind == H_LASER) {
        *x = b->lasers.prev_x[i];
        *y = b->lasers.prev_y[i];
    }
    if (!before_move)
        return true;
    if (kind == H_SHOT || kind == H_BULLET) {
        *x -= s->vx[i];
        *y -= s->vy[i];
    } else if (kind == H_ENEMY) {
        *x = b->enemies.prev_x[i];
        *y = b->enemies.prev_y[i];
    } else if (kind == H_PLAYER) {
        *x = b->player.prev_x[i];
        *y = b->player.prev_y[i];
    } else if (kind == H_OPTION) {
        *x = b->options.prev_x[i];
        *y = b->options.prev_y[i];
    } else if (kind == H_ITEM) {
        *x = b->items.prev_x[i];
        *y = b->items.prev_y[i];
    }
    return true;
}

static struct motion_world laser_world(const struct board *b, bool shoots)
{
    struct motion_world w = board_motion_world(b, shoots);

    w.kinds = NULL;
    w.get_position = get_entity_position;
    return w;
}

/* Stores the direction of an entity. Returns false if entities of this kind have no direction. */
static bool get_direction(const struct board *b, int64_t h, ang *dir)
{
    const uint32_t i = handle_slot(h);

    switch (handle_kind(h)) {
    case H_BULLET:
        *dir = b->bullets.dir[i];
        return true;
    case H_SHOT:
        *dir = b->shots.dir[i];
        return true;
    case H_LASER:
        *dir = b->laser_heads.dir[i];
        return true;
    default:
        return false;
    }
}

/* Moves laser i to the entity it follows. Returns false if that entity is dead. */
static bool follow_entity(struct board *b, uint32_t i)
{
    struct lasers *l = &b->lasers;
    ang dir;
    fx x, y;

    if (!board_is_alive(b, l->follow_target[i]) || !board_get_position(b, l->follow_target[i], &x, &y))
        return false;
    b->laser_heads.x[i] = motion_clamp_to_world((int64_t)x + l->dx[i]);
    b->laser_heads.y[i] = motion_clamp_to_world((int64_t)y + l->dy[i]);
    if (l->flags[i] & LASER_TURNS && get_direction(b, l->follow_target[i], &dir)) {
        if (l->flags[i] & LASER_HAS_TARGET_DIR)
            b->laser_heads.dir[i] += dir - l->target_dir[i];
        l->flags[i] |= LASER_HAS_TARGET_DIR;
        l->target_dir[i] = dir;
    }
    return true;
}

/* Returns whether the box around laser i's line is entirely outside the keep box. */
static bool is_outside(const struct board *b, uint32_t i)
{
    fx x, y, x0 = FX_MAX, y0 = FX_MAX, x1 = FX_MIN, y1 = FX_MIN;

    for (uint32_t k = 0; k < lasers_corner_count(b, i); k++) {
        lasers_get_corner(b, i, k, &x, &y);
        x0 = fx_min(x0, x);
        y0 = fx_min(y0, y);
        x1 = fx_max(x1, x);
        y1 = fx_max(y1, y);
    }
    return x1 < b->keep_box.x0 || x0 > b->keep_box.x1 || y1 < b->keep_box.y0 || y0 > b->keep_box.y1;
}

static bool is_in_keep_box(const struct board *b, fx x, fx y)
{
    return x >= b->keep_box.x0 && x <= b->keep_box.x1 && y >= b->keep_box.y0 && y <= b->keep_box.y1;
}

/* Updates a bolt after its head moved. A bolt grows from the point where it was fired until it has its full length. */
static void move_bolt(struct board *b, uint32_t i)
{
    struct lasers *l = &b->lasers;
    const struct bullets *h = &b->laser_heads;
    fx distance = fx_hypot(fx_sub(h->x[i], l->prev_x[i]), fx_sub(h->y[i], l->prev_y[i]));

    l->grown_length[i] = (fx)int64_min((int64_t)l->grown_length[i] + distance, l->length[i]);
    lasers_update_tail(b, i);
    if (is_outside(b, i))
        l->flags[i] |= LASER_DESPAWNING;
}

/* Updates a curve after its head moved. A head that has left the keep box stops; the body follows it out. */
static void move_curve(struct board *b, uint32_t i)
{
    struct lasers *l = &b->lasers;
    const struct bullets *h = &b->laser_heads;
    const int64_t dx = (int64_t)h->x[i] - l->prev_x[i], dy = (int64_t)h->y[i] - l->prev_y[i];

    if (int64_abs(dx) > max_move || int64_abs(dy) > max_move) /* the head jumped: move the body with it */
        lasers_shift(l, &b->laser_points, i, fx_sat(dx), fx_sat(dy));
    lasers_advance(l, &b->laser_points, i, h->x[i], h->y[i]);
    if (!is_in_keep_box(b, h->x[i], h->y[i]))
        l->flags[i] |= LASER_HEAD_OUTSIDE;
    if (l->flags[i] & LASER_HEAD_OUTSIDE && is_outside(b, i))
        l->flags[i] |= LASER_DESPAWNING;
}

/* Returns whether either end of laser i moved further, on an axis, than an entity can move in a frame. */
static bool has_jumped(const struct lasers *l, const struct bullets *h, uint32_t i)
{
    const int64_t distance = int64_max(
        int64_max(int64_abs((int64_t)h->x[i] - l->prev_x[i]), int64_abs((int64_t)h->y[i] - l->prev_y[i])),
        int64_max(int64_abs((int64_t)l->x0[i] - l->prev_x0[i]), int64_abs((int64_t)l->y0[i] - l->prev_y0[i])));

    return distance > max_move;
}

/* Moves laser i by its spin and its program. Returns false if the program removed the laser. */
static bool fly(struct board *b, const struct motion_world *w, uint32_t i, uint32_t age)
{
    struct lasers *l = &b->lasers;
    struct bullets *h = &b->laser_heads;

    if (l->spin[i] && age >= (uint32_t)l->warn_frames[i]) {
        h->dir[i] += l->spin[i];
        bullets_update_velocity(h, i);
    }
    if (l->form[i] == LASER_BEAM) {
        lasers_update_tail(b, i);
        return true;
    }
    if (!(l->flags[i] & LASER_HEAD_OUTSIDE) && !bullets_move_one(h, w, i))
        return false;
    if (h->flags[i] & BULLET_DELAYED)
        return true;
    if (l->form[i] == LASER_BOLT)
        move_bolt(b, i);
    else
        move_curve(b, i);
    return true;
}

/* Moves laser i by one frame. Returns false if the laser ends; lasers_move then removes it. */
static bool move_laser(struct board *b, const struct motion_world *w, uint32_t i)
{
    struct lasers *l = &b->lasers;
    struct bullets *h = &b->laser_heads;
    const bool is_frozen = h->freeze_flags && h->freeze_flags[i] & FREEZE_LAST_MOVE;
    const uint32_t age = lasers_age(b, i);

    l->flags[i] &= (uint8_t)~LASER_UNSWEPT;
    if (is_frozen)
        l->flags[i] |= LASER_UNSWEPT;
    else if (lasers_has_faded(l, i, age) || (l->follow_target[i] && !follow_entity(b, i)))
        return false;
    else if (!fly(b, w, i, age))
        return false;
    const bool was_harmless = l->form[i] == LASER_BEAM && (age == 0 || !is_dangerous(b, i, age - 1));
    if (was_harmless || has_jumped(l, h, i))
        l->flags[i] |= LASER_UNSWEPT;
    return true;
}

static void save_old_positions(struct lasers *l, const struct bullets *h)
{
    EACH_LIVE (i, &l->s) {
        l->prev_x[i] = h->x[i];
        l->prev_y[i] = h->y[i];
        l->prev_x0[i] = l->x0[i];
        l->prev_y0[i] = l->y0[i];
    }
}

void lasers_move(struct board *b)
{
    const struct motion_world w[2] = { laser_world(b, false), laser_world(b, true) };
    struct lasers *l = &b->lasers;

    bullets_begin_move(&b->laser_heads);
    save_old_positions(l, &b->laser_heads);
    for (int follows = 0; follows < 2; follows++) /* lasers that follow an entity move last */
        EACH_LIVE (i, &l->s) {
            const bool shoots = b->laser_kinds.flags[b->laser_heads.kind[i]] & LASER_HITS_ENEMIES;
            if ((l->follow_target[i] != 0) != follows || move_laser(b, &w[shoots], i))
                continue;
            if (b->laser_heads.s.live_bits[i / SLOTS_BLOCK] >> (i % SLOTS_BLOCK) & 1)
                bullets_drop(&b->laser_heads, i);
            lasers_drop(l, &b->laser_points, i);
        }
    slots_trim(&b->laser_heads.s);
}

void lasers_end_frame(struct board *b)
{
    EACH_LIVE (i, &b->lasers.s)
        if (b->lasers.flags[i] & LASER_DESPAWNING)
            lasers_remove(b, i);
}

/* ---- a laser's line: corners, and tests against shapes ---- */

uint32_t lasers_corner_count(const struct board *b, uint32_t i)
{
    return b->lasers.form[i] == LASER_CURVE ? b->lasers.n_points[i] : 2;
}

void lasers_get_corner(const struct board *b, uint32_t i, uint32_t k, fx *x, fx *y)
{
    const struct lasers *l = &b->lasers;

    if (l->form[i] == LASER_CURVE)
        lasers_get_point(l, &b->laser_points, i, k, x, y);
    else if (k == 0)
        *x = b->laser_heads.x[i], *y = b->laser_heads.y[i];
    else
        *x = l->x0[i], *y = l->y0[i];
}

void lasers_get_old_corner(const struct board *b, uint32_t i, uint32_t k, fx *x, fx *y)
{
    const struct lasers *l = &b->lasers;

    if (l->flags[i] & LASER_UNSWEPT)
        lasers_get_corner(b, i, k, x, y);
    else if (l->form[i] != LASER_CURVE && k == 0)
        *x = l->prev_x[i], *y = l->prev_y[i];
    else if (l->form[i] != LASER_CURVE)
        *x = l->prev_x0[i], *y = l->prev_y0[i];
    else if (k + 1 < l->n_points[i])
        lasers_get_point(l, &b->laser_points, i, k + 1, x, y);
    else
        *x = l->x0[i], *y = l->y0[i];
}

uint32_t lasers_segment_count(const struct board *b, uint32_t i)
{
    const uint32_t n = lasers_corner_count(b, i);

    return n > 1 ? n - 1 : 1;
}

struct lasers_segment lasers_get_segment(const struct board *b, uint32_t i, uint32_t k)
{
    struct lasers_segment s;

    lasers_get_corner(b, i, k, &s.x, &s.y);
    lasers_get_corner(b, i, k + 1 < lasers_corner_count(b, i) ? k + 1 : k, &s.to_x, &s.to_y);
    return s;
}

struct lasers_segment lasers_get_old_segment(const struct board *b, uint32_t i, uint32_t k)
{
    struct lasers_segment s;

    lasers_get_old_corner(b, i, k, &s.x, &s.y);
    lasers_get_old_corner(b, i, k + 1 < lasers_corner_count(b, i) ? k + 1 : k, &s.to_x, &s.to_y);
    return s;
}

uint32_t lasers_visit_positions(struct board *b, uint32_t i, fx spacing,
                                void (*visit)(struct board *b, fx x, fx y, void *context), void *context)
{
    const uint32_t n = lasers_corner_count(b, i);
    uint32_t position_count = 0;
    int64_t next = spacing / 2; /* fx from the last corner to the next position */
    fx x, y, to_x, to_y;

    lasers_get_corner(b, i, 0, &x, &y);
    for (uint32_t k = 1; k < n; k++, x = to_x, y = to_y) {
        lasers_get_corner(b, i, k, &to_x, &to_y);
        const int64_t dx = (int64_t)to_x - x, dy = (int64_t)to_y - y, length = fx_hypot(fx_sat(dx), fx_sat(dy));
        for (; next < length; next += spacing, position_count++)
            visit(b, (fx)(x + dx * next / length), (fx)(y + dy * next / length), context);
        next -= length;
    }
    if (position_count)
        return position_count;
    lasers_get_corner(b, i, 0, &x, &y);
    visit(b, x, y, context);
    return 1;
}

enum { FX_PER_UNIT = 256 /* number of fx in 1/256 px. In units of 1/256 px, products of distances are below 2^63 */ };

/* Returns the squared distance from (x, y) to (to_x, to_y), in 1/256 px. */
static int64_t distance_sq(fx x, fx y, fx to_x, fx to_y)
{
    const int64_t dx = ((int64_t)to_x - x) / FX_PER_UNIT, dy = ((int64_t)to_y - y) / FX_PER_UNIT;

    return dx * dx + dy * dy;
}

/* Sets (*to_x, *to_y) to the point nearest to (x, y) on the segment from (ax, ay) to (*to_x, *to_y). */
static void nearest_on_segment(fx x, fx y, fx ax, fx ay, fx *to_x, fx *to_y)
{
    const int64_t wx = ((int64_t)*to_x - ax) / FX_PER_UNIT, wy = ((int64_t)*to_y - ay) / FX_PER_UNIT;
    const int64_t dx = ((int64_t)x - ax) / FX_PER_UNIT, dy = ((int64_t)y - ay) / FX_PER_UNIT;
    const int64_t length_sq = wx * wx + wy * wy, projection = int64_clamp(dx * wx + dy * wy, 0, length_sq);

    if (projection == length_sq)
        return;
    const int64_t fraction = projection * 65536 / length_sq; /* length_sq > projection >= 0 */
    *to_x = (fx)(ax + ((int64_t)*to_x - ax) * fraction / 65536);
    *to_y = (fx)(ay + ((int64_t)*to_y - ay) * fraction / 65536);
}

void lasers_get_nearest_point(const struct board *b, uint32_t i, fx x, fx y, fx *to_x, fx *to_y)
{
    const uint32_t n = lasers_corner_count(b, i);
    fx ax, ay, px, py, bx, by;

    lasers_get_corner(b, i, 0, &ax, &ay);
    *to_x = ax;
    *to_y = ay;
    for (uint32_t k = 1; k < n; k++, ax = bx, ay = by) {
        lasers_get_corner(b, i, k, &bx, &by);
        px = bx;
        py = by;
        nearest_on_segment(x, y, ax, ay, &px, &py);
        if (distance_sq(px, py, x, y) < distance_sq(*to_x, *to_y, x, y)) {
            *to_x = px;
            *to_y = py;
        }
    }
}

/* Returns half the width of laser i as it is drawn now. */
static int64_t half_width(const struct board *b, uint32_t i)
{
    return lasers_width(&b->lasers, i, lasers_age(b, i)) / 2;
}

bool lasers_overlap_line(const struct board *b, uint32_t i, fx x, fx y, fx to_x, fx to_y, fx a)
{
    const int64_t r = half_width(b, i) + a, dx = (int64_t)x - to_x, dy = (int64_t)y - to_y;

    for (uint32_t k = 0; k < lasers_segment_count(b, i); k++) {
        const struct lasers_segment s = lasers_get_segment(b, i, k);
        const struct geom_bar bar = { (int64_t)s.x - x,    (int64_t)s.y - y,    dx, dy,
                                      (int64_t)s.to_x - x, (int64_t)s.to_y - y, dx, dy };

        if (geom_swept_bar(&bar, r))
            return true;
    }
    return false;
}

bool lasers_overlap_box(const struct board *b, uint32_t i, fx x, fx y, fx w, fx h)
{
    const int64_t r = half_width(b, i);

    for (uint32_t k = 0; k < lasers_segment_count(b, i); k++) {
        const struct lasers_segment s = lasers_get_segment(b, i, k);

        if (geom_swept_circle_box((int64_t)s.x - x, (int64_t)s.y - y, (int64_t)s.to_x - s.x, (int64_t)s.to_y - s.y, r,
                                  w, h))
            return true;
    }
    return false;
}

/*
 * hit_shots.c - shots against enemies and bullets, and bullets against enemies that block. See hit_parts.h.
 *
 * Of the enemies it touches, a shot hits the one that was nearest before both moved. The enemies are therefore sorted
 * into the cells of a grid by their positions before the move, and a shot searches the grid in rings around its own
 * cell. It stops when the enemy found is nearer than the next ring, or when the next ring is outside the search box:
 * the box around the shot's path, grown by the shot's extent and by the largest sum of extent and move of an enemy.
 */
#include "hit_parts.h"
#include <string.h>
#include "../../base/int.h"
#include "hit.h"

enum {
    MIN_GRID_SHOTS = 4, /* with fewer shots, the grid has one cell */
    NO_ENEMY = MAX_ENEMIES,
    /* work: WORK_PER_RUN per run of cells searched and per PLACES_PER_WORK places in the run, WORK_PER_TEST and
     * WORK_PER_LONG_TEST per test of shapes */
    WORK_PER_RUN = 1,
    POSITIONS_PER_WORK = 2,
    WORK_PER_TEST = 4,
    WORK_PER_LONG_TEST = 4 * SHAPE_MAX_CIRCLES * SHAPE_MAX_CIRCLES
};

/* The position of an enemy before its move, relative to the grid's top left corner. */
struct enemy_position {
    uint32_t x, y, slot;
};

/* The enemies that shots can hit, by cell, row by row. The outermost cells are empty. */
struct grid {
    uint32_t n;
    int64_t left, top;        /* the grid's top left corner */
    int64_t width, height;    /* size of the grid */
    int64_t reach_x, reach_y; /* farthest that an enemy extends from its position before the move */
    int64_t scale;            /* factor from fx to 2^-32 of a cell */
    int64_t cell_size;        /* 2^32 / scale, rounded down: the width and height of a cell */
    int64_t cols, rows;
    struct enemy_position *positions;
    uint16_t *slot, *cell; /* slots of the enemies, not sorted, and their cells */
    uint16_t *cell_start;  /* index of each cell's first place; at the end, the number of places */
};

/* A search by a shot or bullet. */
struct search {
    const struct board *b;
    const struct grid *g;
    const struct bullets *pool;
    const struct bullet_kinds *kinds;
    struct body shot;
    const struct hit_pierced_targets *pierced; /* targets to skip; NULL: none */
    uint32_t slot;                             /* of the shot or bullet that searches */
    bool swept;
    int64_t x, y;           /* position of the shot before its move, relative to the grid's corner */
    int64_t x0, y0, x1, y1; /* the search box: enemies that were outside it before the move are skipped */
    uint64_t best;          /* squared distance of the enemy found, before the move */
    uint32_t found;         /* slot of the enemy found, or NO_ENEMY */
    uint64_t work;          /* work done by the search */
};

static inline uint64_t sum_of_squares(int64_t dx, int64_t dy)
{
    return (uint64_t)dx * (uint64_t)dx + (uint64_t)dy * (uint64_t)dy;
}

/* ---- the grid ---- */

/* Returns the most cells, including the outermost. There are at most five inner cells per four enemies. */
static size_t cell_capacity(size_t enemies)
{
    return 4 * (enemies * 5 / 4 + 3);
}

size_t hit_grid_size(size_t enemies)
{
    return enemies
               ? enemies * sizeof(struct enemy_position) + (2 * enemies + cell_capacity(enemies) + 1) * sizeof(uint16_t)
               : 0;
}

static void init_grid(struct grid *g, const struct board *b)
{
    const size_t enemies = b->enemies.s.cap;

    g->n = 0;
    g->positions = b->hit_grid;
    g->slot = (uint16_t *)(g->positions + enemies);
    g->cell = g->slot + enemies;
    g->cell_start = g->cell + enemies;
}

/* Returns the column of an x, or the row of a y, relative to the grid's corner. */
static inline int64_t cell_of(const struct grid *g, int64_t v)
{
    return v * g->scale >> 32;
}

/* Converts a distance in 2^-32 of a cell to fx, rounded down. */
static inline int64_t cells_to_fx(const struct grid *g, int64_t cells)
{
    return (cells >> 16) * g->cell_size >> 16;
}

/* Lists the enemies that can be hit and whose kinds have all of `flags`. Measures the box around the enemies' positions
 * before the move, and their largest reach. */
static void list_enemies(struct grid *g, const struct board *b, uint8_t flags)
{
    const struct enemies *e = &b->enemies;
    const struct enemy_kinds *k = &b->enemy_kinds;
    fx left = FX_MAX, top = FX_MAX, right = FX_MIN, bottom = FX_MIN;
    int64_t reach_x = 0, reach_y = 0;
    uint32_t n = 0;

    for (uint32_t word = 0; word < e->s.top / 64; word++)
        for (uint64_t bits = e->s.live_bits[word]; bits; bits &= bits - 1) {
            uint32_t i = word * 64 + bits_lowest(bits);
            uint16_t kind = e->kind[i];
            fx x = e->prev_x[i], y = e->prev_y[i];
            struct extent extent = hit_enemy_extent(b, i);
            if (e->flags[i] & ENEMY_DYING || k->shape[kind] == SHAPE_NONE || flags & ~k->flags[kind])
                continue;
            g->slot[n++] = (uint16_t)i;
            left = x < left ? x : left;
            right = x > right ? x : right;
            top = y < top ? y : top;
            bottom = y > bottom ? y : bottom;
            reach_x = int64_max(reach_x, extent.x + int64_abs((int64_t)e->x[i] - x));
            reach_y = int64_max(reach_y, extent.y + int64_abs((int64_t)e->y[i] - y));
        }
    g->n = n;
    g->left = left;
    g->top = top;
    g->width = (int64_t)right - left;
    g->height = (int64_t)bottom - top;
    g->reach_x = reach_x;
    g->reach_y = reach_y;
}

/* Makes the cells as small as the maximum number of cells allows. */
static void set_cells(struct grid *g, uint32_t shots)
{
    const uint32_t cells = shots < MIN_GRID_SHOTS ? 1 : g->n * 5 / 4;

    g->scale = 2;
    for (int64_t bit = 1 << 16; bit > 1; bit >>= 1) {
        int64_t finer = g->scale | bit;
        if (((g->width * finer >> 32) + 1) * ((g->height * finer >> 32) + 1) <= cells)
            g->scale = finer;
    }
    g->cell_size = ((int64_t)1 << 32) / g->scale;
    g->left -= g->cell_size + 1;
    g->top -= g->cell_size + 1;
    g->cols = cell_of(g, g->width + g->cell_size + 1) + 2;
    g->rows = cell_of(g, g->height + g->cell_size + 1) + 2;
    g->width = g->cols * (g->cell_size + 1);
    g->height = g->rows * (g->cell_size + 1);
}

/* Sorts the enemies into the cells, with a counting sort. */
static void sort_into_cells(struct grid *g, const struct enemies *e)
{
    uint16_t *cell = g->cell, *begin = g->cell_start;
    const size_t cells = (size_t)(g->cols * g->rows), n = g->n;
    const int64_t left = g->left, top = g->top, cols = g->cols;
    const int64_t scale = g->scale;
    uint32_t sum = 0;

    memset(begin, 0, (cells + 1) * sizeof *begin);
    for (size_t i = 0; i < n; i++) {
        uint32_t slot = g->slot[i];
        cell[i] = (uint16_t)(((e->prev_y[slot] - top) * scale >> 32) * cols + ((e->prev_x[slot] - left) * scale >> 32));
        begin[cell[i]]++;
    }
    for (size_t i = 0; i <= cells; i++) {
        sum += begin[i];
        begin[i] = (uint16_t)sum; /* the cell's end; the next loop counts down to its start */
    }
    for (size_t i = n; i-- > 0;) {
        uint32_t slot = g->slot[i];
        g->positions[--begin[cell[i]]] =
            (struct enemy_position){ (uint32_t)(e->prev_x[slot] - left), (uint32_t)(e->prev_y[slot] - top), slot };
    }
}

/* ---- the ring search ---- */

/* Searches the cells from..to of a row for the nearest enemy that the shot touches; ties go to the lower slot. */
static void search_run(struct search *s, int64_t row, int64_t from, int64_t to)
{
    const uint16_t *begin = s->g->cell_start + row * s->g->cols;

    s->work += WORK_PER_RUN + (uint32_t)(begin[to + 1] - begin[from]) / POSITIONS_PER_WORK;
    for (uint32_t i = begin[from]; i < begin[to + 1]; i++) {
        const struct enemy_position *p = &s->g->positions[i];
        const int64_t x = p->x, y = p->y;
        const uint32_t slot = p->slot;
        if (x < s->x0 || x > s->x1 || y < s->y0 || y > s->y1)
            continue;
        uint64_t d = sum_of_squares(s->x - x, s->y - y);
        if (d > s->best || (d == s->best && slot > s->found) || hit_pierced_contains(s->pierced, H_ENEMY, slot))
            continue;
        struct body e = hit_enemy_body(s->b, slot);
        s->work += (s->shot.shape | e.shape) <= SHAPE_MAX_SIMPLE ? WORK_PER_TEST : WORK_PER_LONG_TEST;
        if (hit_shot_touches(s->b, s->pool, s->kinds, s->slot, &s->shot, slot, &e, s->swept)) {
            s->best = d;
            s->found = slot;
        }
    }
}

/* Sets the search box. Returns false if no enemy can be in the box. */
static bool set_bounds(struct search *s)
{
    const struct grid *g = s->g;
    const struct body *p = &s->shot;
    const struct shape_columns shapes = hit_bullet_shapes(s->kinds);
    const struct extent e = hit_extent(&shapes, s->pool->kind[s->slot]);
    int64_t x = p->x - g->left, ex = e.x + g->reach_x;
    int64_t y = p->y - g->top, ey = e.y + g->reach_y;

    s->x = x - p->mx;
    s->y = y - p->my;
    s->x0 = int64_max(int64_min(x, s->x) - ex, 0);
    s->x1 = int64_min(int64_max(x, s->x) + ex, g->width - 1);
    s->y0 = int64_max(int64_min(y, s->y) - ey, 0);
    s->y1 = int64_min(int64_max(y, s->y) + ey, g->height - 1);
    return s->x0 <= s->x1 && s->y0 <= s->y1;
}

/*
 * Searches rings of cells around the shot's cell or, if that is outside the search box, around the nearest cell of the
 * box. After each ring, computes how near an enemy in the box but outside the searched rings could be; gap_x and gap_y
 * are the distances of the shot from the box on each axis. Every distance here is below 2^32, because positions are in
 * the world and moves are at most MAX_SPEED.
 */
static void search_rings(struct search *s)
{
    const struct grid *g = s->g;
    const int64_t left = int64_max(cell_of(g, s->x0), 1), right = int64_min(cell_of(g, s->x1), g->cols - 2);
    const int64_t top = int64_max(cell_of(g, s->y0), 1), bottom = int64_min(cell_of(g, s->y1), g->rows - 2);
    const int64_t x = int64_clamp(cell_of(g, s->x), left, right), y = int64_clamp(cell_of(g, s->y), top, bottom);
    const int64_t x_q32 = s->x * g->scale, y_q32 = s->y * g->scale;
    const int64_t gap_x = int64_max(int64_max(s->x0 - s->x, s->x - s->x1), 0);
    const int64_t gap_y = int64_max(int64_max(s->y0 - s->y, s->y - s->y1), 0);
    const int64_t unbounded = INT64_MAX;

    if (left > right || top > bottom)
        return;
    for (int64_t r = 0;; r++) {
        const int64_t x0 = x - r, x1 = x + r, y0 = y - r, y1 = y + r;
        for (int64_t row = int64_max(y0, top); row <= int64_min(y1, bottom); row++) {
            if (row == y0 || row == y1) {
                search_run(s, row, int64_max(x0, left), int64_min(x1, right));
                continue;
            }
            if (x0 >= left)
                search_run(s, row, x0, x0);
            if (x1 <= right)
                search_run(s, row, x1, x1);
        }
        int64_t dx =
            int64_min(x0 > left ? x_q32 - (x0 << 32) : unbounded, x1 < right ? ((x1 + 1) << 32) - x_q32 : unbounded);
        int64_t dy =
            int64_min(y0 > top ? y_q32 - (y0 << 32) : unbounded, y1 < bottom ? ((y1 + 1) << 32) - y_q32 : unbounded);
        if ((dx == unbounded || s->best < sum_of_squares(cells_to_fx(g, dx), gap_y)) &&
            (dy == unbounded || s->best < sum_of_squares(cells_to_fx(g, dy), gap_x)))
            return;
    }
}

static void raise_overload(struct board *b, bool is_blocking)
{
    if (is_blocking)
        board_raise_overload(b,
                             "enemies that block bullets: too much work in one frame (%u enemies, %u bullets); lower "
                             "`board.enemies` or `board.bullets` in rom.lua",
                             b->enemies.s.live, b->bullets.s.live);
    board_raise_overload(b,
                         "shots that hit enemies: too much work in one frame (%u shots, %u enemies); lower "
                         "`board.shots` or `board.enemies` in rom.lua",
                         b->shots.s.live, b->enemies.s.live);
}

static uint32_t find_target(struct board *b, const struct grid *g, const struct bullets *pool,
                            const struct bullet_kinds *kinds, uint32_t i, const struct hit_pierced_targets *pierced)
{
    struct search s = { .b = b,
                        .g = g,
                        .pool = pool,
                        .kinds = kinds,
                        .pierced = pierced,
                        .slot = i,
                        .best = UINT64_MAX,
                        .found = NO_ENEMY };

    s.shot = hit_bullet_body(pool, kinds, i);
    s.swept = kinds->flags[pool->kind[i]] & KIND_SWEPT;
    if (s.shot.shape == SHAPE_NONE || !set_bounds(&s))
        return NO_ENEMY;
    search_rings(&s);
    if (!board_charge_work(b, s.work))
        raise_overload(b, pool == &b->bullets);
    return s.found;
}

/* ---- the shots ---- */

/* Inlined board_raise_event for EV_SHOT; calls board_raise_event itself only if the event list is full. */
static inline void raise_shot(struct board *b, uint32_t shot, int64_t target)
{
    int64_t shot_handle = handle_make(H_SHOT, b->shots.s.gen[shot], shot);

    if (!events_push(&b->events, EV_SHOT, shot_handle, target))
        board_raise_event(b, EV_SHOT, shot_handle, target);
}

/* Returns the bullet that shot i hits if that bullet was nearer than enemy `enemy`, otherwise NO_SLOT. enemy: NO_ENEMY
 * if the shot hits no enemy. */
static int32_t find_nearer_solid(struct board *b, const struct hit_solids *f, uint32_t i, uint32_t enemy,
                                 const struct hit_pierced_targets *pierced)
{
    const struct bullets *s = &b->shots;
    const struct enemies *e = &b->enemies;
    uint64_t distance_sq = UINT64_MAX;

    if (enemy != NO_ENEMY)
        distance_sq = sum_of_squares((int64_t)s->x[i] - s->vx[i] - e->prev_x[enemy],
                                     (int64_t)s->y[i] - s->vy[i] - e->prev_y[enemy]);
    return hit_find_nearest_solid(b, f, i, pierced, &distance_sq);
}

/* If shot i hits a bullet that was nearer than enemy `enemy` (see find_nearer_solid), raises the event and returns
 * true. */
static bool raise_solid_hit(struct board *b, const struct hit_solids *f, uint32_t i, uint32_t enemy)
{
    int32_t bullet = find_nearer_solid(b, f, i, enemy, NULL);

    if (bullet != NO_SLOT)
        raise_shot(b, i, board_handle(b, H_BULLET, bullet));
    return bullet != NO_SLOT;
}

/* ---- shots that pierce ---- */

/* Lists in *pierced the targets that shot i cannot hit again yet, and removes the others from its `pierced_targets`
 * list. */
static void find_pierced_targets(struct board *b, uint32_t i, struct hit_pierced_targets *pierced)
{
    int64_t *entity = b->shots.pierced_targets + (size_t)i * MAX_PIERCED_TARGETS;
    const uint32_t *rehit_clock = b->shots.rehit_clock + (size_t)i * MAX_PIERCED_TARGETS;

    pierced->n = 0;
    for (int k = 0; k < MAX_PIERCED_TARGETS; k++) {
        if (!entity[k])
            continue;
        if (rehit_clock[k] <= b->core.clock || !board_is_readable(b, entity[k]))
            entity[k] = 0;
        else
            pierced->entity[pierced->n++] = entity[k];
    }
}

/* Returns the handle of the nearest target that shot i hits and has not passed, or 0. */
static int64_t find_next_target(struct board *b, const struct grid *g, const struct hit_solids *solids, uint32_t i,
                                const struct hit_pierced_targets *pierced)
{
    uint32_t enemy = g->n ? find_target(b, g, &b->shots, &b->shot_kinds, i, pierced) : NO_ENEMY;
    int32_t bullet = solids ? find_nearer_solid(b, solids, i, enemy, pierced) : NO_SLOT;

    if (bullet != NO_SLOT)
        return board_handle(b, H_BULLET, bullet);
    return enemy != NO_ENEMY ? board_handle(b, H_ENEMY, (int32_t)enemy) : 0;
}

static bool stops_any_shot(const struct board *b, int64_t entity)
{
    return handle_kind(entity) == H_BULLET && b->bullets.hp && b->bullets.hp[handle_slot(entity)] == HP_FOREVER;
}

/* Raises the events of piercing shot i. Returns false if the shot hits nothing. */
static bool raise_piercing_hits(struct board *b, const struct grid *g, const struct hit_solids *solids, uint32_t i)
{
    const int32_t pierce = b->shots.pierce_left[i];
    struct hit_pierced_targets pierced;
    int n = 0;

    find_pierced_targets(b, i, &pierced);
    while (pierced.n < MAX_PIERCED_TARGETS && (pierce == PIERCE_FOREVER || n <= pierce)) {
        int64_t entity = find_next_target(b, g, solids, i, &pierced);
        if (!entity)
            break;
        raise_shot(b, i, entity);
        pierced.entity[pierced.n++] = entity;
        n++;
        if (stops_any_shot(b, entity))
            break;
    }
    return n > 0;
}

static bool can_pierce(const struct board *b, uint32_t i)
{
    return b->shot_kinds.pierce_hits && b->shot_kinds.pierce_hits[b->shots.kind[i]];
}

/* Raises the events of all shots, and releases the shots that left the field and hit nothing. solids: NULL if shots can
 * hit no bullet. */
static void raise_all_shots(struct board *b, const struct grid *g, const struct hit_solids *solids)
{
    const struct slots *s = &b->shots.s;

    for (uint32_t word = 0; word < s->top / 64; word++) {
        uint64_t missed = 0;
        for (uint64_t bits = slots_live_or_held_mask(s, word); bits; bits &= bits - 1) {
            uint32_t i = word * 64 + bits_lowest(bits);
            if (can_pierce(b, i)) {
                missed |= raise_piercing_hits(b, g, solids, i) ? 0 : bits & -bits;
                continue;
            }
            uint32_t slot = g->n ? find_target(b, g, &b->shots, &b->shot_kinds, i, NULL) : NO_ENEMY;
            if (solids && raise_solid_hit(b, solids, i, slot))
                continue;
            if (slot != NO_ENEMY)
                raise_shot(b, i, handle_make(H_ENEMY, b->enemies.s.gen[slot], slot));
            else
                missed |= bits & -bits;
        }
        for (missed &= ~s->live_bits[word]; missed; missed &= missed - 1)
            bullets_release(&b->shots, word * 64 + bits_lowest(missed));
    }
}

void hit_test_shots(struct board *b)
{
    const struct slots *s = &b->shots.s;
    struct hit_solids solids;
    struct grid g;
    bool hits_solids = hit_solid_is_possible(b) && hit_find_solids(b, &solids);

    init_grid(&g, b);
    if ((s->live || s->held_count) && b->enemies.s.live)
        list_enemies(&g, b, 0);
    if (!g.n && !hits_solids) {
        bullets_release_all(&b->shots);
        return;
    }
    if (g.n) {
        set_cells(&g, s->live + s->held_count);
        sort_into_cells(&g, &b->enemies);
    }
    raise_all_shots(b, &g, hits_solids ? &solids : NULL);
}

/* ---- enemies that block bullets ---- */

static bool any_enemy_blocks(const struct board *b)
{
    for (uint32_t i = 0; i < b->enemy_kinds.s.live; i++)
        if (b->enemy_kinds.flags[i] & ENEMY_BLOCKS_BULLETS)
            return b->bullets.s.live && b->enemies.s.live;
    return false;
}

void hit_test_blocks(struct board *b)
{
    struct grid g;

    if (!any_enemy_blocks(b))
        return;
    init_grid(&g, b);
    list_enemies(&g, b, ENEMY_BLOCKS_BULLETS);
    if (!g.n)
        return;
    set_cells(&g, b->bullets.s.live);
    sort_into_cells(&g, &b->enemies);
    EACH_LIVE (i, &b->bullets.s) {
        if (b->bullets.flags[i] & BULLET_DELAYED)
            continue;
        uint32_t enemy = find_target(b, &g, &b->bullets, &b->bullet_kinds, i, NULL);
        if (enemy != NO_ENEMY)
            board_raise_event(b, EV_BLOCK, board_handle(b, H_BULLET, (int32_t)i),
                              board_handle(b, H_ENEMY, (int32_t)enemy));
    }
}

/*
 * hit_shots.c - see hit_parts.h.
 *
 * A shot takes, of the enemies it touches, the one that was nearest to it before both moved. So the enemies' places
 * before their moves are sorted into the cells of a grid, and a shot searches it in rings of cells around its own,
 * until what it found is nearer than the next ring, or that ring is out of reach. Out of reach is what lies outside of
 * a box: the shot's way, grown by its extent and by the largest extent and move of an enemy.
 *
 * In a dense crowd that box is larger than a cell, most shots touch some enemy, and the nearest of all is nearly always
 * one of them. There the two by two cells around the shot are looked at first, without branches and without testing
 * what is touched: only whether the shot touches the nearest of them, and nothing outside of them is nearer. The ring
 * search takes what is left, so it alone says what is hit; the rest is speed.
 */
#include "hit_parts.h"
#include <assert.h>
#include <string.h>

enum {
    MANY = 4,      /* fewer shots are not worth a sort */
    A_CELL = 1,    /* enemies a cell: fewer make empty cells, more make long scans */
    SMALLEST = 16, /* cells are 2^16 wide, a pixel, at the least */
    MOST_CELLS = 3 * (MAX_ENEMIES / A_CELL + 2),
    NOBODY = MAX_ENEMIES
};

/*
 * Enemies that shots can hit, by cell, row by row. The outermost cells are empty. The grid's unit is 2^-up of an fx, so
 * that in a dense crowd the squares of distances are multiples of a number above any rank.
 */
struct crowd {
    uint32_t n;
    int64_t left, top;        /* the grid's corner, an fx */
    int64_t wide, high;       /* of the grid */
    int64_t reach_x, reach_y; /* most that an enemy extends from where it was, in fx */
    int64_t core; /* whoever was that near to an enemy touched it, in fx; negative: an enemy touches nothing */
    int up, shift_x, shift_y; /* cells are 2^shift wide */
    int64_t half_x, half_y;   /* half a cell */
    int64_t cols, rows;
    uint32_t ranks; /* all bits of ranks */
    bool dense;
    int64_t x[MAX_ENEMIES], y[MAX_ENEMIES];
    uint64_t rank[MAX_ENEMIES];
    uint16_t slot[MAX_ENEMIES];     /* by rank */
    uint16_t begin[MOST_CELLS + 1]; /* of each cell; the last: n */
    uint64_t sure[MAX_KINDS];       /* a shot of that kind touches what was less far, squared, in the grid */
};

/* A shot that searches. */
struct search {
    const struct board *b;
    const struct crowd *c;
    struct body shot;
    bool swept;
    int64_t x, y;           /* its place before its move, in the grid */
    int64_t x0, y0, x1, y1; /* the box that what it touches was in, in the grid */
    uint64_t best;          /* the square of the distance of what was found, in fx */
    uint64_t found;         /* its rank */
};

static inline int64_t least(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

static inline int64_t most(int64_t a, int64_t b)
{
    return a > b ? a : b;
}

static inline int64_t size(int64_t v)
{
    return v < 0 ? -v : v;
}

static inline uint64_t lower(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

static inline int32_t clamp(int64_t v, int32_t lo, int32_t hi)
{
    return v < lo ? lo : v > hi ? hi : (int32_t)v;
}

/* Is it, a square, less than the square of d? For 0 <= d < 2^32. */
static inline bool less_far(uint64_t best, int64_t d)
{
    return best < (uint64_t)d * (uint64_t)d;
}

static inline uint64_t squares(int64_t dx, int64_t dy)
{
    return (uint64_t)(dx * dx) + (uint64_t)(dy * dy);
}

/* v in units of the grid. */
static inline int64_t scaled(const struct crowd *c, int64_t v)
{
    return (int64_t)((uint64_t)v << c->up);
}

/* ---- the grid ---- */

/* Half the height of a kind's shape. */
static inline fx half_height(uint8_t shape, fx a, fx b)
{
    return shape == SHAPE_BOX ? b : a;
}

/* Where they were, and the size of the box around that. */
struct places {
    fx x[MAX_ENEMIES], y[MAX_ENEMIES];
    int64_t across, down;
};

/* Lists those that can be hit, and measures them. */
static void gather(struct crowd *c, const struct board *b, struct places *was)
{
    const struct enemies *e = &b->enemies;
    const struct enemy_kinds *k = &b->enemy_kinds;
    fx left = FX_MAX, top = FX_MAX, right = FX_MIN, bottom = FX_MIN;
    int64_t reach_x = 0, reach_y = 0, core = FX_MAX;
    uint32_t n = 0;

    for (uint32_t word = 0; word < e->s.top / 64; word++)
        for (uint64_t bits = e->s.used[word]; bits; bits &= bits - 1) {
            uint32_t i = word * 64 + lowest_bit(bits);
            uint16_t kind = e->kind[i];
            fx x = e->was_x[i], y = e->was_y[i], a = k->a[kind];
            fx h = half_height(k->shape[kind], a, k->b[kind]);
            if (e->flags[i] & ENEMY_DYING || k->shape[kind] == SHAPE_NONE)
                continue;
            assert(n < MAX_ENEMIES);
            c->slot[n] = (uint16_t)i;
            was->x[n] = x;
            was->y[n++] = y;
            left = x < left ? x : left;
            right = x > right ? x : right;
            top = y < top ? y : top;
            bottom = y > bottom ? y : bottom;
            core = least(core, a < h ? a : h);
            reach_x = most(reach_x, a + size((int64_t)e->x[i] - x));
            reach_y = most(reach_y, h + size((int64_t)e->y[i] - y));
        }
    c->n = n;
    c->left = left;
    c->top = top;
    c->reach_x = reach_x;
    c->reach_y = reach_y;
    c->core = core;
    was->across = (int64_t)right - left;
    was->down = (int64_t)bottom - top;
}

/* Halves the cells, the wider side first, while no more than so many are needed for a box of this size. */
static void divide(struct crowd *c, int64_t across, int64_t down, uint32_t cells)
{
    int x = 31, y = 31;

    for (bool wider = true; x > SMALLEST; wider = x >= y) {
        uint64_t cols = (uint64_t)(across >> (x - wider)) + 1, rows = (uint64_t)(down >> (y - !wider)) + 1;
        if (cols * rows > cells)
            break;
        x -= wider;
        y -= !wider;
    }
    c->cols = (across >> x) + 3;
    c->rows = (down >> y) + 3;
    c->left -= (int64_t)1 << x;
    c->top -= (int64_t)1 << y;
    c->up = 0;
    while (c->n >> 2 * c->up)
        c->up++;
    int64_t wide = c->cols << x, high = c->rows << y;
    c->dense = most(wide, high) << c->up <= (int64_t)1 << 31 && c->reach_x * 2 > (int64_t)1 << x &&
               c->reach_y * 2 > (int64_t)1 << y;
    c->up = c->dense ? c->up : 0;
    c->ranks = ((uint32_t)1 << 2 * c->up) - 1;
    c->shift_x = x + c->up;
    c->shift_y = y + c->up;
    c->half_x = (int64_t)1 << c->shift_x >> 1;
    c->half_y = (int64_t)1 << c->shift_y >> 1;
    c->wide = wide << c->up;
    c->high = high << c->up;
}

/* A counting sort. */
static void sort(struct crowd *c, const struct places *was)
{
    uint16_t cell[MAX_ENEMIES], *begin = c->begin;
    const size_t cells = (size_t)(c->cols * c->rows), n = c->n;
    const int64_t left = c->left, top = c->top, cols = c->cols;
    const int up = c->up, shift_x = c->shift_x - up, shift_y = c->shift_y - up;
    uint32_t sum = 0;

    memset(begin, 0, (cells + 1) * sizeof *begin);
    for (size_t i = 0; i < n; i++) {
        cell[i] = (uint16_t)(((was->y[i] - top) >> shift_y) * cols + ((was->x[i] - left) >> shift_x));
        begin[cell[i]]++;
    }
    for (size_t i = 0; i <= cells; i++) {
        sum += begin[i];
        begin[i] = (uint16_t)sum; /* its end; what follows counts down to its beginning */
    }
    for (size_t i = n; i-- > 0;) {
        uint32_t at = --begin[cell[i]];
        c->x[at] = (was->x[i] - left) << up;
        c->y[at] = (was->y[i] - top) << up;
        c->rank[at] = i;
    }
}

/* ---- the search by rings ---- */

/* The nearest of a run of cells that is touched; of equals, the one of the lower rank. */
static void touched(struct search *s, int32_t row, int32_t from, int32_t to)
{
    const uint16_t *begin = s->c->begin + row * s->c->cols;

    for (uint32_t i = begin[from]; i < begin[to + 1]; i++) {
        int64_t x = s->c->x[i], y = s->c->y[i];
        uint64_t rank = s->c->rank[i];
        if (x < s->x0 || x > s->x1 || y < s->y0 || y > s->y1)
            continue;
        int64_t dx = (s->x - x) >> s->c->up, dy = (s->y - y) >> s->c->up;
        uint64_t d = squares(dx, dy);
        if (d > s->best || (d == s->best && rank > s->found))
            continue;
        struct body e = enemy(s->b, s->c->slot[rank]);
        if (touch(&s->shot, &e, s->swept)) {
            s->best = d;
            s->found = rank;
        }
    }
}

/* Sets the box up; false: no enemy is in it. */
static bool reach(struct search *s)
{
    const struct crowd *c = s->c;
    const struct body *p = &s->shot;
    int64_t x = scaled(c, p->x - c->left), ex = scaled(c, p->a + c->reach_x);
    int64_t y = scaled(c, p->y - c->top), ey = scaled(c, half_height(p->shape, p->a, p->b) + c->reach_y);

    s->x = x - scaled(c, p->mx);
    s->y = y - scaled(c, p->my);
    s->x0 = most(least(x, s->x) - ex, 0);
    s->x1 = least(most(x, s->x) + ex, c->wide - 1);
    s->y0 = most(least(y, s->y) - ey, 0);
    s->y1 = least(most(y, s->y) + ey, c->high - 1);
    return s->x0 <= s->x1 && s->y0 <= s->y1;
}

/*
 * Rings of cells around the shot's, or around the cell of the box that is next to it. After each: how near could an
 * enemy be that is in the box and outside of the rings? A shot outside of the box is a gap away from all that is in it.
 * Positions in the world and ways of MAX_SPEED keep every distance here below 2^32.
 */
static void search_rings(struct search *s)
{
    const int shift_x = s->c->shift_x, shift_y = s->c->shift_y, up = s->c->up;
    const int32_t left = (int32_t)(s->x0 >> shift_x), right = (int32_t)(s->x1 >> shift_x);
    const int32_t top = (int32_t)(s->y0 >> shift_y), bottom = (int32_t)(s->y1 >> shift_y);
    const int32_t x = clamp(s->x >> shift_x, left, right), y = clamp(s->y >> shift_y, top, bottom);
    const int64_t gap_x = most(most(s->x0 - s->x, s->x - s->x1), 0) >> up;
    const int64_t gap_y = most(most(s->y0 - s->y, s->y - s->y1), 0) >> up;
    const int64_t far = INT64_MAX;

    for (int32_t r = 0;; r++) {
        int32_t x0 = x - r, x1 = x + r, y0 = y - r, y1 = y + r;
        int32_t from = x0 > left ? x0 : left, to = x1 < right ? x1 : right;
        for (int32_t row = y0 > top ? y0 : top; row <= y1 && row <= bottom; row++) {
            if (row == y0 || row == y1) {
                touched(s, row, from, to);
                continue;
            }
            if (x0 >= left)
                touched(s, row, x0, x0);
            if (x1 <= right)
                touched(s, row, x1, x1);
        }
        int64_t dx = least(x0 > left ? s->x - ((int64_t)x0 << shift_x) : far,
                           x1 < right ? ((int64_t)(x1 + 1) << shift_x) - s->x : far);
        int64_t dy = least(y0 > top ? s->y - ((int64_t)y0 << shift_y) : far,
                           y1 < bottom ? ((int64_t)(y1 + 1) << shift_y) - s->y : far);
        if ((dx == far || s->best < squares(dx >> up, gap_y)) && (dy == far || s->best < squares(dy >> up, gap_x)))
            return;
    }
}

static uint32_t target_by_rings(const struct board *b, const struct crowd *c, uint32_t i)
{
    struct search s = { .b = b, .c = c, .best = UINT64_MAX, .found = NOBODY };

    s.shot = flying(&b->shots, &b->shot_kinds, i);
    s.swept = b->shot_kinds.flags[b->shots.kind[i]] & KIND_SWEPT;
    if (s.shot.shape == SHAPE_NONE || !reach(&s))
        return NOBODY;
    search_rings(&s);
    return (uint32_t)s.found;
}

/* ---- the search of a dense crowd ---- */

/* How far enemy i was, squared, and its rank: the lowest key is the enemy to be hit if it is touched. */
static inline uint64_t key(const struct crowd *c, size_t i, int64_t x, int64_t y)
{
    int64_t dx = c->x[i] - x, dy = c->y[i] - y;

    return (uint64_t)(dx * dx + dy * dy) | c->rank[i];
}

/* The lowest key of a run of cells, or best. */
static inline uint64_t lowest(const struct crowd *c, size_t i, size_t end, int64_t x, int64_t y, uint64_t best)
{
    for (; i < end; i++)
        best = lower(best, key(c, i, x, y));
    return best;
}

/* The same for the cells that are h or less around the corner (col, row). */
static uint64_t lowest_around(const struct crowd *c, int64_t col, int64_t row, int64_t h, int64_t x, int64_t y)
{
    const int64_t from = most(col - h, 0), to = least(col + h, c->cols), end = least(row + h, c->rows);
    uint64_t best = UINT64_MAX;

    for (int64_t r = most(row - h, 0); r < end; r++)
        best = lowest(c, c->begin[r * c->cols + from], c->begin[r * c->cols + to], x, y, best);
    return best;
}

/* The rank of the enemy that the shot hits if that is the nearest of all, or NOBODY. */
static inline uint32_t target_nearest(const struct board *b, const struct crowd *c, uint32_t i)
{
    const struct bullets *s = &b->shots;
    const int64_t half_x = c->half_x, half_y = c->half_y;
    const int64_t x = scaled(c, (int64_t)s->x[i] - s->vx[i] - c->left), ahead_x = x + half_x;
    const int64_t y = scaled(c, (int64_t)s->y[i] - s->vy[i] - c->top), ahead_y = y + half_y;
    const int64_t col = ahead_x >> c->shift_x, row = ahead_y >> c->shift_y; /* of the nearest corner of four cells */

    if ((uint64_t)(col - 1) >= (uint64_t)(c->cols - 1) || (uint64_t)(row - 1) >= (uint64_t)(c->rows - 1))
        return NOBODY;
    const uint16_t *below = c->begin + row * c->cols + col, *above = below - c->cols;
    const int64_t off_x = size((ahead_x & (2 * half_x - 1)) - half_x);
    const int64_t off_y = size((ahead_y & (2 * half_y - 1)) - half_y);
    uint64_t best = lowest(c, above[-1], above[1], x, y, UINT64_MAX);
    best = lowest(c, below[-1], below[1], x, y, best);
    if (!less_far(best, least(2 * half_x - off_x, 2 * half_y - off_y))) {
        best = lowest_around(c, col, row, 2, x, y);
        if (!less_far(best, least(4 * half_x - off_x, 4 * half_y - off_y)))
            return NOBODY;
    }
    uint32_t rank = (uint32_t)best & c->ranks;
    if (best < c->sure[s->kind[i]])
        return rank;
    struct body shot = flying(s, &b->shot_kinds, i), e = enemy(b, c->slot[rank]);
    return touch(&shot, &e, b->shot_kinds.flags[s->kind[i]] & KIND_SWEPT) ? rank : NOBODY;
}

/* A circle fits into each shape; swept shots touch whom their circle touched before they moved. */
static void judge(struct crowd *c, const struct bullet_kinds *k)
{
    for (uint32_t i = 0; i < k->s.live; i++) {
        int64_t core = least(k->a[i], half_height(k->shape[i], k->a[i], k->b[i]));
        bool sure = k->shape[i] != SHAPE_NONE && k->flags[i] & KIND_SWEPT && core >= 0 && c->core >= 0;
        uint64_t r = sure ? (uint64_t)least(scaled(c, core + c->core), UINT32_MAX) : 0;
        c->sure[i] = r * r;
    }
}

/* Raises the event: board_event's way, without a call but where there is no room. */
static inline void hit(struct board *b, uint32_t shot, uint32_t foe)
{
    struct events *e = &b->events;
    int64_t who = handle_of(H_SHOT, b->shots.s.gen[shot], shot), whom = handle_of(H_ENEMY, b->enemies.s.gen[foe], foe);

    if (e->n < e->cap)
        e->list[e->n++] = (struct event){ .kind = EV_SHOT, .a = who, .b = whom };
    else
        board_event(b, EV_SHOT, who, whom);
}

void hit_shots(struct board *b)
{
    const struct slots *s = &b->shots.s;
    struct crowd c;
    struct places was;

    if (!s->live || !b->enemies.s.live)
        return;
    gather(&c, b, &was);
    if (!c.n)
        return;
    divide(&c, was.across, was.down, s->live < MANY ? 1 : c.n / A_CELL);
    sort(&c, &was);
    if (c.dense)
        judge(&c, &b->shot_kinds);
    for (uint32_t word = 0; word < s->top / 64; word++)
        for (uint64_t bits = s->used[word]; bits; bits &= bits - 1) {
            uint32_t i = word * 64 + lowest_bit(bits);
            uint32_t rank = c.dense ? target_nearest(b, &c, i) : NOBODY;
            rank = rank == NOBODY ? target_by_rings(b, &c, i) : rank;
            if (rank != NOBODY)
                hit(b, i, c.slot[rank]);
        }
}

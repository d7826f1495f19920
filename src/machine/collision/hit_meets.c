/*
 * hit_meets.c - see hit_parts.h: bullets against bullets, for the pairs of tags that a game declares.
 *
 * The bullets of a pair's second tag are sorted into the cells of a grid by their positions before the move. The
 * bullets of a cell are linked by the column `next`. A bullet of the first tag searches the cells of a box: the box
 * around its path, grown by its extent and by the largest sum of extent and move of a bullet in the grid. Bullets of
 * the second tag for which this sum exceeds FAR cells are in a separate list, which every search includes, so that a
 * few large or fast bullets do not widen every search.
 *
 * Each bullet is tested along its path of the frame or, if its kind is not swept, at its final position.
 */
#include "hit_parts.h"
#include <string.h>
#include "../../base/int.h"
#include "../machine.h"
#include "hit.h"

enum {
    SIDE = 64,  /* most columns, and most rows, of cells */
    SHIFT = 19, /* log2 of the least cell size: 2^19 is 8 px */
    FAR = 2,    /* most cells that the sum of move and extent of a bullet in the grid may span */
    LISTS = SIDE * SIDE + 1,
    A_PUT = 2, /* work per bullet added to a list, per bullet examined in a list, per pair of pieces tested */
    A_LOOK = 3,
    A_TEST = 4
};
static const uint32_t LAST = UINT32_MAX; /* the end of a list */

/* The bullets of a pair's second tag, sorted into the grid. */
struct crowd {
    struct board *b;
    const struct bullets *s;
    const struct bullet_kinds *k;
    uint16_t first, tag; /* the pair's first and second tag */
    bool alone;          /* both tags of the pair are the same */
    int64_t left, top;   /* the grid's top left corner */
    int64_t wide, high;  /* size of the box around the bullets' positions before the move */
    int shift;           /* log2 of a cell's side */
    int64_t cols, rows;
    int64_t reach_x, reach_y; /* farthest that a bullet in a cell extends from its position before the move */
    uint32_t list[LISTS];     /* first slot of each cell, row by row, or LAST; at the end, of the far bullets */
};

/* A search by a bullet of the first tag. */
struct search {
    const struct crowd *c;
    uint32_t slot; /* of the searching bullet */
    uint32_t n;    /* number of pieces */
    struct body piece[SHAPE_PARTS];
    int64_t x, y;           /* position of the searching bullet before the move */
    int64_t x0, y0, x1, y1; /* bullets that were outside this box before the move are skipped */
    uint64_t best;          /* squared distance of the bullet found, before the move */
    uint32_t found;         /* slot of the bullet found, or LAST */
    uint32_t tested;        /* number of bullets tested */
};

static inline int64_t was_x(const struct bullets *s, uint32_t i)
{
    return (int64_t)s->x[i] - s->vx[i];
}

static inline int64_t was_y(const struct bullets *s, uint32_t i)
{
    return (int64_t)s->y[i] - s->vy[i];
}

/* Returns the bullets of a block that have the tag, one bit each. */
static uint64_t tagged(const struct bullets *s, uint32_t block, uint16_t tag)
{
    const uint16_t *restrict tags = s->tag + block * SLOTS_BLOCK;
    uint8_t is[SLOTS_BLOCK];

    for (int i = 0; i < SLOTS_BLOCK; i++)
        is[i] = tags[i] == tag;
    return slots_gather(is) & slots_live_or_held(&s->s, block);
}

/* Returns the bullets of a block with the tag that can meet others: not removed yet, not delayed, and of a kind with a
 * shape. */
static uint64_t ready(const struct bullets *s, const struct bullet_kinds *k, uint32_t block, uint16_t tag)
{
    uint64_t found = tagged(s, block, tag) & ~s->taken[block];

    for (uint64_t m = found; m; m &= m - 1) {
        uint32_t i = block * SLOTS_BLOCK + bits_lowest(m);
        if (s->flags[i] & BULLET_DELAYED || k->shape[s->kind[i]] == SHAPE_NONE)
            found &= ~(m & -m);
    }
    return found;
}

static struct extent extent(const struct bullets *s, const struct bullet_kinds *k, uint32_t i)
{
    const struct shape_columns shapes = hit_bullet_shapes(k);

    return hit_extent(&shapes, s->kind[i]);
}

/* Measures the box around the bullets of the second tag. Returns false if there are none. */
static bool measure(struct crowd *c)
{
    int64_t left = INT64_MAX, top = INT64_MAX, right = INT64_MIN, bottom = INT64_MIN;

    for (uint32_t block = 0; block < c->s->s.top / SLOTS_BLOCK; block++)
        for (uint64_t m = ready(c->s, c->k, block, c->tag); m; m &= m - 1) {
            uint32_t i = block * SLOTS_BLOCK + bits_lowest(m);
            int64_t x = was_x(c->s, i), y = was_y(c->s, i);
            left = int64_min(left, x);
            right = int64_max(right, x);
            top = int64_min(top, y);
            bottom = int64_max(bottom, y);
        }
    if (left > right)
        return false;
    c->left = left;
    c->top = top;
    c->wide = right - left;
    c->high = bottom - top;
    return true;
}

/* Returns how many bullets have this tag. */
static uint32_t count_tagged(const struct bullets *s, uint16_t tag)
{
    uint32_t n = 0;

    for (uint32_t block = 0; block < s->s.top / SLOTS_BLOCK; block++)
        n += (uint32_t)bits_count(tagged(s, block, tag));
    return n;
}

static void too_much(const struct crowd *c)
{
    board_too_much(c->b,
                   "bullet.meet: too much work in one frame (%u bullets tagged \"%s\", %u tagged \"%s\"); lower "
                   "`board.bullets` in rom.lua or give fewer bullets these tags",
                   count_tagged(c->s, c->first), board_name(c->b, N_TAG, c->first), count_tagged(c->s, c->tag),
                   board_name(c->b, N_TAG, c->tag));
}

/* Adds bullet i to the list of its cell or, if its move and extent are too large, to the separate list. */
static void put(struct crowd *c, uint32_t i)
{
    const struct extent e = extent(c->s, c->k, i);
    const int64_t x = e.x + int64_abs(c->s->vx[i]), y = e.y + int64_abs(c->s->vy[i]);
    const int64_t col = (was_x(c->s, i) - c->left) >> c->shift, row = (was_y(c->s, i) - c->top) >> c->shift;
    uint32_t *list = &c->list[row * c->cols + col];

    if (int64_max(x, y) > (int64_t)FAR << c->shift)
        list = &c->list[LISTS - 1];
    else {
        c->reach_x = int64_max(c->reach_x, x);
        c->reach_y = int64_max(c->reach_y, y);
    }
    c->s->next[i] = *list;
    *list = i;
}

/* Sorts the bullets of the second tag into the grid. Returns false if there are none. */
static bool gather(struct crowd *c)
{
    uint64_t n = 0;

    if (!measure(c))
        return false;
    for (c->shift = SHIFT; int64_max(c->wide, c->high) >> c->shift >= SIDE; c->shift++)
        ;
    c->cols = (c->wide >> c->shift) + 1;
    c->rows = (c->high >> c->shift) + 1;
    c->reach_x = c->reach_y = 0;
    memset(c->list, 0xff, (size_t)(c->cols * c->rows) * sizeof *c->list);
    c->list[LISTS - 1] = LAST;
    for (uint32_t block = 0; block < c->s->s.top / SLOTS_BLOCK; block++)
        for (uint64_t m = ready(c->s, c->k, block, c->tag); m; m &= m - 1, n++)
            put(c, block * SLOTS_BLOCK + bits_lowest(m));
    if (!board_work(c->b, A_PUT * n))
        too_much(c);
    return true;
}

/* Splits bullet i into pieces, which do not move if its kind is not swept; returns the number of pieces. */
static uint32_t pieces_of(const struct crowd *c, uint32_t i, struct body piece[SHAPE_PARTS])
{
    uint32_t n = hit_bullet_pieces(c->s, c->k, i, piece);

    if (!(c->k->flags[c->s->kind[i]] & KIND_SWEPT))
        for (uint32_t p = 0; p < n; p++)
            piece[p].mx = piece[p].my = 0;
    return n;
}

static inline bool has(const uint64_t *words, uint32_t i)
{
    return words[i / SLOTS_BLOCK] >> (i % SLOTS_BLOCK) & 1;
}

static inline void add(uint64_t *words, uint32_t i)
{
    words[i / SLOTS_BLOCK] |= (uint64_t)1 << (i % SLOTS_BLOCK);
}

/* Searches the list that starts at slot i. The sum of the squares is below 2^64, because positions are in the world. */
static void search_list(struct search *q, uint32_t i)
{
    const struct crowd *c = q->c;
    struct body piece[SHAPE_PARTS];

    uint64_t looks = 0;

    for (; i != LAST; i = c->s->next[i]) {
        looks++;
        int64_t x = was_x(c->s, i), y = was_y(c->s, i), dx = x - q->x, dy = y - q->y;
        if (x < q->x0 || x > q->x1 || y < q->y0 || y > q->y1)
            continue;
        uint64_t d = (uint64_t)(dx * dx) + (uint64_t)(dy * dy);
        if (d > q->best || (d == q->best && i > q->found) || i == q->slot)
            continue;
        if (has(c->s->taken, i) || (c->alone && has(c->s->met, i)))
            continue;
        q->tested++;
        const uint32_t n = pieces_of(c, i, piece);
        if (!board_work(c->b, (uint64_t)A_TEST * q->n * n))
            too_much(c);
        if (!hit_pieces_touch(q->piece, q->n, piece, n, true))
            continue;
        q->best = d;
        q->found = i;
    }
    if (!board_work(c->b, A_LOOK * looks))
        too_much(c);
}

/* Searches the cells that q's box overlaps. */
static void search_cells(struct search *q)
{
    const struct crowd *c = q->c;
    const int64_t col = int64_max((q->x0 - c->left) >> c->shift, 0), row = int64_max((q->y0 - c->top) >> c->shift, 0);
    const int64_t cols = int64_min((q->x1 - c->left) >> c->shift, c->cols - 1);
    const int64_t rows = int64_min((q->y1 - c->top) >> c->shift, c->rows - 1);

    for (int64_t y = row; y <= rows; y++)
        for (int64_t x = col; x <= cols; x++)
            search_list(q, c->list[y * c->cols + x]);
}

/* Returns the bullet that bullet i meets, or LAST. */
static uint32_t partner(struct board *b, const struct crowd *c, uint32_t i)
{
    const struct bullets *s = c->s;
    const struct extent e = extent(s, c->k, i);
    const int64_t all = (int64_t)1 << 40; /* beyond any position */
    struct search q = { .c = c, .slot = i, .x = was_x(s, i), .y = was_y(s, i), .best = UINT64_MAX, .found = LAST };

    q.n = pieces_of(c, i, q.piece);
    q.x0 = q.y0 = -all;
    q.x1 = q.y1 = all;
    search_list(&q, c->list[LISTS - 1]);
    q.x0 = int64_min(s->x[i], q.x) - e.x - c->reach_x;
    q.x1 = int64_max(s->x[i], q.x) + e.x + c->reach_x;
    q.y0 = int64_min(s->y[i], q.y) - e.y - c->reach_y;
    q.y1 = int64_max(s->y[i], q.y) + e.y + c->reach_y;
    search_cells(&q);
    b->counts.tested += q.tested;
    return q.found;
}

/* Returns whether pair p removes bullet i; side: MEET_FIRST or MEET_SECOND. */
static bool takes(const struct crowd *c, uint32_t p, uint8_t side, uint32_t i)
{
    const uint8_t flags = c->s->meet_flags[p];

    return flags & side && (flags & MEET_ALL || !(c->k->flags[c->s->kind[i]] & KIND_FIXED));
}

/* Raises the event of two bullets that meet as pair p; records that they met and which of them the pair removes. */
static void raise_meet(struct board *b, const struct crowd *c, uint32_t p, uint32_t first, uint32_t second)
{
    const struct bullets *s = c->s;

    board_event(b, (enum event_kind)(EV_MEET + p), handle_of(H_BULLET, s->s.gen[first], first),
                handle_of(H_BULLET, s->s.gen[second], second));
    add(s->met, first);
    if (c->alone)
        add(s->met, second);
    if (takes(c, p, MEET_FIRST, first))
        add(s->taken, first);
    if (takes(c, p, MEET_SECOND, second))
        add(s->taken, second);
}

static void meet(struct board *b, struct crowd *c, uint32_t p)
{
    const struct bullets *s = c->s;

    c->first = s->meet_first[p];
    c->tag = s->meet_second[p];
    c->alone = c->first == c->tag;
    if (!gather(c))
        return;
    for (uint32_t block = 0; block < s->s.top / SLOTS_BLOCK; block++)
        for (uint64_t m = ready(s, c->k, block, s->meet_first[p]) & ~s->met[block]; m; m &= m - 1) {
            uint32_t i = block * SLOTS_BLOCK + bits_lowest(m), other;
            if (has(s->taken, i) || has(s->met, i)) /* set since the block was read */
                continue;
            other = partner(b, c, i);
            if (other != LAST)
                raise_meet(b, c, p, i, other);
        }
}

void hit_meets(struct board *b)
{
    const struct bullets *s = &b->bullets;
    struct crowd c;

    if (s->s.live + s->s.holding < 2)
        return;
    c.b = b;
    c.s = s;
    c.k = &b->bullet_kinds;
    memset(s->met, 0, s->s.top / 8);
    memset(s->taken, 0, s->s.top / 8);
    for (uint32_t p = 0; p < s->meets; p++)
        meet(b, &c, p);
}

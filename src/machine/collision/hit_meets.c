/*
 * hit_meets.c - see hit_parts.h: bullets against bullets, for the pairs of tags that a game declares.
 *
 * The bullets of a pair's second tag are sorted into the cells of a grid by their positions before the move. The
 * bullets of a cell are linked by the column `meet_next`. A bullet of the first tag searches the cells of a box: the
 * box around its path, grown by its extent and by the largest sum of extent and move of a bullet in the grid. Bullets
 * of the second tag for which this sum exceeds MAX_SPAN cells are in a separate list, which every search includes, so
 * that a few large or fast bullets do not widen every search.
 *
 * Each bullet is tested along its path of the frame or, if its kind is not swept, at its final position.
 */
#include "hit_parts.h"
#include <string.h>
#include "../../base/int.h"
#include "../machine.h"
#include "hit.h"

enum {
    MAX_SIDE = 64,  /* most columns, and most rows, of cells */
    MIN_SHIFT = 19, /* log2 of the least cell size: 2^19 is 8 px */
    MAX_SPAN = 2,   /* most cells that the sum of move and extent of a bullet in the grid may span */
    LIST_COUNT = MAX_SIDE * MAX_SIDE + 1,
    WORK_PER_INSERT = 2, /* work per bullet added to a list, per bullet examined in a list, per pair of pieces tested */
    WORK_PER_VISIT = 3,
    WORK_PER_TEST = 4
};
static const uint32_t END_OF_LIST = UINT32_MAX;

/* The bullets of a pair's second tag, sorted into the grid. */
struct grid {
    struct board *b;
    const struct bullets *s;
    const struct bullet_kinds *k;
    uint16_t first_tag, second_tag; /* the pair's first and second tag */
    bool is_same_tag;               /* both tags of the pair are the same */
    int64_t left, top;              /* the grid's top left corner */
    int64_t width, height;          /* size of the box around the bullets' positions before the move */
    int shift;                      /* log2 of a cell's side */
    int64_t cols, rows;
    int64_t reach_x, reach_y;  /* farthest that a bullet in a cell extends from its position before the move */
    uint32_t list[LIST_COUNT]; /* first slot of each cell, row by row, or END_OF_LIST; last: of the separate list */
};

/* A search by a bullet of the first tag. */
struct search {
    const struct grid *c;
    uint32_t slot; /* of the searching bullet */
    uint32_t n;    /* number of pieces */
    struct body piece[SHAPE_MAX_CIRCLES];
    int64_t x, y;           /* position of the searching bullet before the move */
    int64_t x0, y0, x1, y1; /* bullets that were outside this box before the move are skipped */
    uint64_t best;          /* squared distance of the bullet found, before the move */
    uint32_t found;         /* slot of the bullet found, or END_OF_LIST */
    uint32_t tested_count;  /* number of bullets tested */
};

static inline int64_t old_x(const struct bullets *s, uint32_t i)
{
    return (int64_t)s->x[i] - s->vx[i];
}

static inline int64_t old_y(const struct bullets *s, uint32_t i)
{
    return (int64_t)s->y[i] - s->vy[i];
}

/* Returns the bullets of a block that have the tag, one bit each. */
static uint64_t tagged_mask(const struct bullets *s, uint32_t block, uint16_t tag)
{
    const uint16_t *restrict tags = s->tag + block * SLOTS_BLOCK;
    uint8_t has_tag[SLOTS_BLOCK];

    for (int i = 0; i < SLOTS_BLOCK; i++)
        has_tag[i] = tags[i] == tag;
    return slots_pack_flags(has_tag) & slots_live_or_held_mask(&s->s, block);
}

/* Returns the bullets of a block with the tag that can meet others: not removed yet, not delayed, and of a kind with a
 * shape. */
static uint64_t ready_mask(const struct bullets *s, const struct bullet_kinds *k, uint32_t block, uint16_t tag)
{
    uint64_t found = tagged_mask(s, block, tag) & ~s->meet_removed[block];

    for (uint64_t m = found; m; m &= m - 1) {
        uint32_t i = block * SLOTS_BLOCK + bits_lowest(m);
        if (s->flags[i] & BULLET_DELAYED || k->shape[s->kind[i]] == SHAPE_NONE)
            found &= ~(m & -m);
    }
    return found;
}

static struct extent get_extent(const struct bullets *s, const struct bullet_kinds *k, uint32_t i)
{
    const struct shape_columns shapes = hit_bullet_shapes(k);

    return hit_extent(&shapes, s->kind[i]);
}

/* Measures the box around the bullets of the second tag. Returns false if there are none. */
static bool measure_bounds(struct grid *c)
{
    int64_t left = INT64_MAX, top = INT64_MAX, right = INT64_MIN, bottom = INT64_MIN;

    for (uint32_t block = 0; block < c->s->s.top / SLOTS_BLOCK; block++)
        for (uint64_t m = ready_mask(c->s, c->k, block, c->second_tag); m; m &= m - 1) {
            uint32_t i = block * SLOTS_BLOCK + bits_lowest(m);
            int64_t x = old_x(c->s, i), y = old_y(c->s, i);
            left = int64_min(left, x);
            right = int64_max(right, x);
            top = int64_min(top, y);
            bottom = int64_max(bottom, y);
        }
    if (left > right)
        return false;
    c->left = left;
    c->top = top;
    c->width = right - left;
    c->height = bottom - top;
    return true;
}

/* Returns how many bullets have this tag. */
static uint32_t count_tagged(const struct bullets *s, uint16_t tag)
{
    uint32_t n = 0;

    for (uint32_t block = 0; block < s->s.top / SLOTS_BLOCK; block++)
        n += (uint32_t)bits_count(tagged_mask(s, block, tag));
    return n;
}

static void raise_overload(const struct grid *c)
{
    board_raise_overload(c->b,
                         "bullet.meet: too much work in one frame (%u bullets tagged \"%s\", %u tagged \"%s\"); lower "
                         "`board.bullets` in rom.lua or give fewer bullets these tags",
                         count_tagged(c->s, c->first_tag), board_name(c->b, N_TAG, c->first_tag),
                         count_tagged(c->s, c->second_tag), board_name(c->b, N_TAG, c->second_tag));
}

/* Adds bullet i to the list of its cell or, if its move and extent are too large, to the separate list. */
static void insert_bullet(struct grid *c, uint32_t i)
{
    const struct extent e = get_extent(c->s, c->k, i);
    const int64_t x = e.x + int64_abs(c->s->vx[i]), y = e.y + int64_abs(c->s->vy[i]);
    const int64_t col = (old_x(c->s, i) - c->left) >> c->shift, row = (old_y(c->s, i) - c->top) >> c->shift;
    uint32_t *list = &c->list[row * c->cols + col];

    if (int64_max(x, y) > (int64_t)MAX_SPAN << c->shift)
        list = &c->list[LIST_COUNT - 1];
    else {
        c->reach_x = int64_max(c->reach_x, x);
        c->reach_y = int64_max(c->reach_y, y);
    }
    c->s->meet_next[i] = *list;
    *list = i;
}

/* Sorts the bullets of the second tag into the grid. Returns false if there are none. */
static bool fill_grid(struct grid *c)
{
    uint64_t n = 0;

    if (!measure_bounds(c))
        return false;
    for (c->shift = MIN_SHIFT; int64_max(c->width, c->height) >> c->shift >= MAX_SIDE; c->shift++)
        ;
    c->cols = (c->width >> c->shift) + 1;
    c->rows = (c->height >> c->shift) + 1;
    c->reach_x = c->reach_y = 0;
    memset(c->list, 0xff, (size_t)(c->cols * c->rows) * sizeof *c->list);
    c->list[LIST_COUNT - 1] = END_OF_LIST;
    for (uint32_t block = 0; block < c->s->s.top / SLOTS_BLOCK; block++)
        for (uint64_t m = ready_mask(c->s, c->k, block, c->second_tag); m; m &= m - 1, n++)
            insert_bullet(c, block * SLOTS_BLOCK + bits_lowest(m));
    if (!board_charge_work(c->b, WORK_PER_INSERT * n))
        raise_overload(c);
    return true;
}

/* Splits bullet i into pieces, which do not move if its kind is not swept; returns the number of pieces. */
static uint32_t split_bullet(const struct grid *c, uint32_t i, struct body piece[SHAPE_MAX_CIRCLES])
{
    uint32_t n = hit_split_bullet(c->s, c->k, i, piece);

    if (!(c->k->flags[c->s->kind[i]] & KIND_SWEPT))
        for (uint32_t p = 0; p < n; p++)
            piece[p].mx = piece[p].my = 0;
    return n;
}

static inline bool has_bit(const uint64_t *words, uint32_t i)
{
    return words[i / SLOTS_BLOCK] >> (i % SLOTS_BLOCK) & 1;
}

static inline void set_bit(uint64_t *words, uint32_t i)
{
    words[i / SLOTS_BLOCK] |= (uint64_t)1 << (i % SLOTS_BLOCK);
}

/* Searches the list that starts at slot i. The sum of the squares is below 2^64, because positions are in the world. */
static void search_list(struct search *q, uint32_t i)
{
    const struct grid *c = q->c;
    struct body piece[SHAPE_MAX_CIRCLES];

    uint64_t visited = 0;

    for (; i != END_OF_LIST; i = c->s->meet_next[i]) {
        visited++;
        int64_t x = old_x(c->s, i), y = old_y(c->s, i), dx = x - q->x, dy = y - q->y;
        if (x < q->x0 || x > q->x1 || y < q->y0 || y > q->y1)
            continue;
        uint64_t d = (uint64_t)(dx * dx) + (uint64_t)(dy * dy);
        if (d > q->best || (d == q->best && i > q->found) || i == q->slot)
            continue;
        if (has_bit(c->s->meet_removed, i) || (c->is_same_tag && has_bit(c->s->meet_collided, i)))
            continue;
        q->tested_count++;
        const uint32_t n = split_bullet(c, i, piece);
        if (!board_charge_work(c->b, (uint64_t)WORK_PER_TEST * q->n * n))
            raise_overload(c);
        if (!hit_any_bodies_touch(q->piece, q->n, piece, n, true))
            continue;
        q->best = d;
        q->found = i;
    }
    if (!board_charge_work(c->b, WORK_PER_VISIT * visited))
        raise_overload(c);
}

/* Searches the cells that q's box overlaps. */
static void search_cells(struct search *q)
{
    const struct grid *c = q->c;
    const int64_t col = int64_max((q->x0 - c->left) >> c->shift, 0), row = int64_max((q->y0 - c->top) >> c->shift, 0);
    const int64_t last_col = int64_min((q->x1 - c->left) >> c->shift, c->cols - 1);
    const int64_t last_row = int64_min((q->y1 - c->top) >> c->shift, c->rows - 1);

    for (int64_t y = row; y <= last_row; y++)
        for (int64_t x = col; x <= last_col; x++)
            search_list(q, c->list[y * c->cols + x]);
}

/* Returns the bullet that bullet i meets, or END_OF_LIST. */
static uint32_t find_partner(struct board *b, const struct grid *c, uint32_t i)
{
    const struct bullets *s = c->s;
    const struct extent e = get_extent(s, c->k, i);
    const int64_t unbounded = (int64_t)1 << 40; /* beyond any position */
    struct search q = {
        .c = c, .slot = i, .x = old_x(s, i), .y = old_y(s, i), .best = UINT64_MAX, .found = END_OF_LIST
    };

    q.n = split_bullet(c, i, q.piece);
    q.x0 = q.y0 = -unbounded;
    q.x1 = q.y1 = unbounded;
    search_list(&q, c->list[LIST_COUNT - 1]);
    q.x0 = int64_min(s->x[i], q.x) - e.x - c->reach_x;
    q.x1 = int64_max(s->x[i], q.x) + e.x + c->reach_x;
    q.y0 = int64_min(s->y[i], q.y) - e.y - c->reach_y;
    q.y1 = int64_max(s->y[i], q.y) + e.y + c->reach_y;
    search_cells(&q);
    b->counts.tested += q.tested_count;
    return q.found;
}

/* Returns whether pair p removes bullet i; side: MEET_FIRST or MEET_SECOND. */
static bool pair_removes(const struct grid *c, uint32_t p, uint8_t side, uint32_t i)
{
    const uint8_t flags = c->s->meet_flags[p];

    return flags & side && (flags & MEET_ALL || !(c->k->flags[c->s->kind[i]] & KIND_FIXED));
}

/* Raises the event of two bullets that meet as pair p; records that they met and which of them the pair removes. */
static void raise_meet(struct board *b, const struct grid *c, uint32_t p, uint32_t first, uint32_t second)
{
    const struct bullets *s = c->s;

    board_raise_event(b, events_meeting(p), handle_make(H_BULLET, s->s.gen[first], first),
                      handle_make(H_BULLET, s->s.gen[second], second));
    set_bit(s->meet_collided, first);
    if (c->is_same_tag)
        set_bit(s->meet_collided, second);
    if (pair_removes(c, p, MEET_FIRST, first))
        set_bit(s->meet_removed, first);
    if (pair_removes(c, p, MEET_SECOND, second))
        set_bit(s->meet_removed, second);
}

static void collide_pair(struct board *b, struct grid *c, uint32_t p)
{
    const struct bullets *s = c->s;

    c->first_tag = s->meet_first[p];
    c->second_tag = s->meet_second[p];
    c->is_same_tag = c->first_tag == c->second_tag;
    if (!fill_grid(c))
        return;
    for (uint32_t block = 0; block < s->s.top / SLOTS_BLOCK; block++)
        for (uint64_t m = ready_mask(s, c->k, block, s->meet_first[p]) & ~s->meet_collided[block]; m; m &= m - 1) {
            uint32_t i = block * SLOTS_BLOCK + bits_lowest(m), second;
            if (has_bit(s->meet_removed, i) || has_bit(s->meet_collided, i)) /* set since the block was read */
                continue;
            second = find_partner(b, c, i);
            if (second != END_OF_LIST)
                raise_meet(b, c, p, i, second);
        }
}

void hit_test_meets(struct board *b)
{
    const struct bullets *s = &b->bullets;
    struct grid c;

    if (s->s.live + s->s.held_count < 2)
        return;
    c.b = b;
    c.s = s;
    c.k = &b->bullet_kinds;
    memset(s->meet_collided, 0, s->s.top / 8);
    memset(s->meet_removed, 0, s->s.top / 8);
    for (uint32_t p = 0; p < s->n_meet_pairs; p++)
        collide_pair(b, &c, p);
}

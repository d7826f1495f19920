/*
 * video_bullets.c - draws bullets and shots, up to a million of them.
 *
 * A counting sort, using the chip's count of live bullets per kind, lists the bullets of each kind in slot order. A
 * bullet is listed as a destination (stamp.h), or by its slot if it overlaps the clip's edge. If all bullets of a kind
 * show the same picture, it is stamped in one batch. If they are rotated, animated or blended, their slots are listed
 * as well, and each bullet's own picture is selected, again in batches. The method is chosen once per kind, so that a
 * slow kind does not slow down the others.
 */
#include <string.h>
#include "../../../fb/stamp.h"
#include "video.h"

enum { BATCH_SIZE = 64 /* pictures per batch */ };

/* How a kind is drawn this frame. */
struct style {
    const struct sprite *pic;    /* its size and anchor are those drawn */
    const struct sprite *source; /* the sprite in the ROM; equals `pic` if the kind is not scaled */
    struct sprite scaled;        /* valid if the kind is scaled: `pic` */
    unsigned scale;
    bool has_rotations; /* each bullet shows one of several rotated copies */
    bool uses_dir;      /* the copy depends on the bullet's dir */
    ang spin;           /* rotation per frame */
    int order, area;    /* area: px of its picture */
    bool is_cloud;
    unsigned blend; /* index + 1, 0: opaque */
    enum blit_mix mix;
    bool shares_picture;      /* all bullets show the same picture, opaque or blended by a rule */
    bool is_drawn_one_by_one; /* blended through a table, or clouds whose ages are stretched */
    uint32_t n;               /* live bullets */
    uint32_t list_start;      /* index in lists.list of the kind's first entry */
    uint32_t less;            /* as in struct stamp_list */
};

struct lists {
    struct style style[MAX_KINDS];
    uint32_t next[MAX_KINDS];             /* index in `list` for the kind's next bullet */
    uint8_t is_listed_by_slot[MAX_KINDS]; /* 1: all the kind's bullets are listed by slot */
    bool any_listed_by_slot;              /* any kind has `is_listed_by_slot` set */
    bool any_varied;                      /* any kind's style has `shares_picture` unset */
    uint16_t order[MAX_KINDS];            /* kinds that have bullets, in draw order */
    uint32_t kind_count;
    uint32_t *list, *slots; /* slots: slot of each bullet in `list`; complete only if any_varied is set */
};

/* The surface on which the listed bullets will be drawn, the field's corner on that surface, and the range of field
 * pixels at which a bullet of any kind needs no clipping and so is listed as a destination. */
struct window {
    const struct fb *fb;
    int x, y;
    int x0, y0, x1, y1; /* both ends included; x0 > x1: none */
    uint32_t base;      /* added to the offset of a bullet's pixel to get its list entry */
};

static size_t max_bullets(const struct manifest *m)
{
    return (size_t)(m->bullets > m->shots ? m->bullets : m->shots);
}

size_t video_bullets_scratch_size(const struct manifest *m)
{
    return (size_t)int_align_cache_line(sizeof(struct lists)) +
           2 * (size_t)int_align_cache_line(max_bullets(m) * sizeof(uint32_t)) + 64;
}

static struct lists *init_lists(const struct draw_target *c)
{
    uint8_t *at = (uint8_t *)(uintptr_t)int_align_cache_line((uintptr_t)c->scratch);
    struct lists *l = (struct lists *)at;

    l->list = (uint32_t *)(at + (size_t)int_align_cache_line(sizeof *l));
    l->slots = (uint32_t *)((uint8_t *)l->list +
                            (size_t)int_align_cache_line(max_bullets(&c->b->cart.manifest) * sizeof *l->list));
    return l;
}

/* ---- draw order, and lists of bullets ---- */

static void find_style(const struct draw_target *c, const struct bullet_kinds *k, uint32_t kind, struct style *style)
{
    const struct sprite *pic = &c->b->sprite_images[k->sprite[kind]];
    const unsigned flags = k->flags[kind], blend = (flags & KIND_BLEND) / KIND_BLEND_ONE;
    const enum blit_mix mix = blend ? (enum blit_mix)c->palette_tables.mix[blend - 1] : BLIT_OPAQUE;
    const bool uses_dir = flags & KIND_TURNS, is_cloud = flags & KIND_IS_CLOUD_ROW;
    const ang spin = k->spin[kind];
    const bool turns = (uses_dir || spin) && pic->rotations > 1;

    slots_prefetch(pic->pix);
    style->source = pic;
    style->scale = k->scale ? k->scale[kind] : SCALE_ONE;
    if (style->scale != SCALE_ONE) {
        style->scaled = video_scale_sprite(pic, (int)style->scale);
        pic = &style->scaled;
    }
    style->pic = pic;
    style->uses_dir = uses_dir;
    style->spin = spin;
    style->has_rotations = turns;
    style->order = k->draw_order[kind];
    style->area = pic->w * pic->h;
    style->blend = blend;
    style->is_cloud = is_cloud;
    style->mix = mix;
    style->shares_picture = !turns && pic->frames == 1 && mix != BLIT_TABLE && style->pic == style->source;
    style->is_drawn_one_by_one =
        mix == BLIT_TABLE || style->pic != style->source || (is_cloud && (pic->frames > 1 || spin));
}

/* Returns whether kind a is drawn below kind b, which was declared before a: a has the lower `order` or, if they are
 * equal, the larger picture. */
static bool is_drawn_below(const struct style *a, const struct style *b)
{
    if (a->order != b->order)
        return a->order < b->order;
    return a->area > b->area;
}

static void insert_kind(struct lists *l, uint16_t kind)
{
    uint32_t at = l->kind_count++;

    for (; at > 0; at--) {
        if (!is_drawn_below(&l->style[kind], &l->style[l->order[at - 1]]))
            break;
        l->order[at] = l->order[at - 1];
    }
    l->order[at] = kind;
}

static void find_kinds(const struct draw_target *c, const struct bullet_kinds *k, struct lists *l)
{
    uint32_t list = 0;

    l->kind_count = 0;
    for (uint32_t i = 0; i < k->s.live; i++) {
        struct style *style = &l->style[i];
        style->n = k->live_count[i];
        if (!style->n)
            continue;
        find_style(c, k, i, style);
        insert_kind(l, (uint16_t)i);
        style->list_start = list;
        list += style->n;
    }
}

/* Finds the top left corner of bullet i's picture on the surface. */
static void find_corner(const struct window *t, const struct lists *l, const struct bullets *s, uint32_t i, int *x,
                        int *y)
{
    const struct sprite *pic = l->style[s->kind[i]].pic;

    *x = fx_floor(s->x[i]) + t->x - pic->ox;
    *y = fx_floor(s->y[i]) + t->y - pic->oy;
}

/* Returns the age of bullet i's picture, in frames. A cloud's age is stretched so that its animation ends with the
 * delay. */
static uint32_t picture_age(const struct style *style, const struct bullets *s, uint32_t i, uint32_t clock)
{
    const uint32_t frame_ticks = style->pic->frame_ticks ? style->pic->frame_ticks : 1,
                   duration = style->pic->frames * frame_ticks;
    uint32_t frames = bullets_frames_since_born(s, i, clock), delay = s->step_end[i] - s->born[i];

    if (!style->is_cloud)
        return bullets_age(s, i, clock);
    frames -= frames > 0; /* the clock has already advanced past the frame that is drawn */
    return (uint32_t)((uint64_t)(frames < delay ? frames : delay - 1) * duration / delay);
}

static struct image image_of(const struct draw_target *c, const struct lists *l, const struct bullets *s, uint32_t i)
{
    const struct style *style = &l->style[s->kind[i]];

    uint32_t age = picture_age(style, s, i, c->b->core.clock);

    const struct image image =
        video_image(style->source, age, style->has_rotations, (style->uses_dir ? s->dir[i] : 0) + style->spin * age);

    return style->scale == SCALE_ONE ? image : video_scaled_image(c, &image, style->scale);
}

/* The positions at which bullets with pictures of one size and anchor need no clipping. */
struct fit {
    struct stamp_unclipped_area c;

    /* From a bullet's pixel to its picture's corner, minus (c.x0, c.y0): in px (dx, dy), and as an offset in bytes
     * (offset). */
    int dx, dy, offset;
};

static struct fit fit_of(const struct fb *fb, const struct sprite *pic, int x, int y)
{
    struct fit f = { .c = stamp_find_unclipped_area(fb, pic->w, pic->h) };

    f.dx = x - pic->ox - f.c.x0;
    f.dy = y - pic->oy - f.c.y0;
    f.offset = f.dy * fb->pitch + f.dx;
    return f;
}

static bool have_same_size_and_anchor(const struct sprite *a, const struct sprite *b)
{
    return a->w == b->w && a->h == b->h && a->ox == b->ox && a->oy == b->oy;
}

/* Narrows the window to positions at which pictures of fit f need no clipping either, and raises *base to f->offset if
 * that is larger. */
static void narrow_window(struct window *t, int *base, const struct fit *f)
{
    const int x1 = (int)f->c.width - f->dx - 1, y1 = (int)f->c.height - f->dy - 1;

    t->x0 = -f->dx > t->x0 ? -f->dx : t->x0;
    t->y0 = -f->dy > t->y0 ? -f->dy : t->y0;
    t->x1 = x1 < t->x1 ? x1 : t->x1;
    t->y1 = y1 < t->y1 ? y1 : t->y1;
    *base = f->offset > *base ? f->offset : *base;
}

/* Empties the lists and returns their window, for a field whose corner is at (x, y). Consecutive kinds whose pictures
 * have the same size and anchor, as most do, share a fit. */
static struct window init_window(struct lists *l, const struct fb *fb, int x, int y)
{
    struct window t = { fb, x, y, INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX, 0 };
    const struct sprite *fit_sprite = NULL; /* sprite of fit f if f has narrowed the window, otherwise NULL */
    struct fit f = { 0 };
    int base = INT32_MIN;

    l->any_listed_by_slot = l->any_varied = false;
    for (uint32_t o = 0; o < l->kind_count; o++) {
        const uint16_t kind = l->order[o];
        struct style *style = &l->style[kind];
        const bool known = fit_sprite && have_same_size_and_anchor(fit_sprite, style->pic);
        if (!known)
            f = fit_of(fb, style->pic, x, y);
        const bool by_slot = !style->shares_picture && (!f.c.width || !f.c.height);
        l->is_listed_by_slot[kind] = by_slot;
        l->any_listed_by_slot |= by_slot;
        l->any_varied |= !style->shares_picture;
        l->next[kind] = style->list_start;
        style->less = (uint32_t)f.offset;
        fit_sprite = by_slot ? NULL : style->pic;
        if (!by_slot && !known)
            narrow_window(&t, &base, &f);
    }
    for (uint32_t o = 0; o < l->kind_count; o++)
        l->style[l->order[o]].less = (uint32_t)base - l->style[l->order[o]].less;
    t.base = (uint32_t)base;
    if (t.x0 > t.x1 || t.y0 > t.y1 || t.x0 == INT32_MIN) { /* no position is unclipped for all kinds */
        t.x0 = t.y0 = 1;
        t.x1 = t.y1 = 0;
    }
    return t;
}

static uint32_t listed_count(const struct lists *l, uint16_t kind)
{
    return l->next[kind] - l->style[kind].list_start;
}

/* Computes the list entry of each bullet in a block, without its bank. Returns whether all bullets are in the window,
 * so that none needs clipping, whatever its kind. Each axis is range-checked with one signed comparison, as in
 * bullets_move.c. */
static bool find_entries(const fx *restrict x, const fx *restrict y, uint32_t *restrict entries, const struct window *t)
{
    const uint32_t sign = (uint32_t)1 << 31, pitch = (uint32_t)t->fb->pitch, from = t->base;
    const uint32_t x0 = (uint32_t)t->x0 << 16 ^ sign, y0 = (uint32_t)t->y0 << 16 ^ sign;
    const int32_t w = (int32_t)((uint32_t)(t->x1 - t->x0 + 1) << 16 ^ sign) - 1,
                  h = (int32_t)((uint32_t)(t->y1 - t->y0 + 1) << 16 ^ sign) - 1;
    int32_t outside = 0;

    for (int i = 0; i < SLOTS_BLOCK; i++) {
        entries[i] = (uint32_t)(y[i] >> 16) * pitch + (uint32_t)(x[i] >> 16) + from;
        outside |= -((int32_t)((uint32_t)x[i] - x0) > w) | -((int32_t)((uint32_t)y[i] - y0) > h);
    }
    return !outside;
}

/* Adds the banks to the entries. This is a separate loop, because mixing bytes with wider values would split the
 * vectors. */
static void add_banks(const uint8_t *restrict bank, uint32_t *restrict entries)
{
    for (int i = 0; i < SLOTS_BLOCK; i++)
        entries[i] += (uint32_t)bank[i] << 28;
}

static bool is_unclipped(const struct window *t, fx x, fx y)
{
    int px = fx_floor(x), py = fx_floor(y);

    return px >= t->x0 && px <= t->x1 && py >= t->y0 && py <= t->y1;
}

static inline void append_bullet(struct lists *l, const struct bullets *s, uint32_t i, uint32_t dest)
{
    const uint32_t next = l->next[s->kind[i]]++;

    l->slots[next] = i;
    l->list[next] = dest;
}

/* Lists bullet i, which is outside the window: as a destination if its own picture needs no clipping; otherwise by its
 * slot, if part of its picture is inside the clip. */
static void list_edge_bullet(struct lists *l, const struct bullets *s, const struct window *t, uint32_t i)
{
    const struct style *style = &l->style[s->kind[i]];
    struct stamp_unclipped_area c = stamp_find_unclipped_area(t->fb, style->pic->w, style->pic->h);
    int x, y;

    find_corner(t, l, s, i, &x, &y);
    if ((uint32_t)(x - c.x0) < c.width && (uint32_t)(y - c.y0) < c.height)
        append_bullet(l, s, i, stamp_dest(t->fb, (uint32_t)(x - c.x0), (uint32_t)(y - c.y0), s->bank[i]) + style->less);
    else if (x < t->fb->x1 && x + style->pic->w > t->fb->x0 && y < t->fb->y1 && y + style->pic->h > t->fb->y0)
        append_bullet(l, s, i, STAMP_CALLER_ENTRY | i);
}

/* Lists the live bullets of a block one by one. */
static void list_single_bullets(struct lists *l, const struct bullets *s, const struct window *t, uint32_t block)
{
    for (uint64_t m = s->s.live_bits[block]; m; m &= m - 1) {
        uint32_t i = block * SLOTS_BLOCK + bits_lowest(m);
        if (l->is_listed_by_slot[s->kind[i]])
            append_bullet(l, s, i, STAMP_CALLER_ENTRY | i);
        else if (is_unclipped(t, s->x[i], s->y[i]))
            append_bullet(l, s, i,
                          ((uint32_t)s->bank[i] << 28) + (uint32_t)fx_floor(s->y[i]) * (uint32_t)t->fb->pitch +
                              (uint32_t)fx_floor(s->x[i]) + t->base);
        else
            list_edge_bullet(l, s, t, i);
    }
}

enum { RUN_LENGTH = 8 };

/* Returns whether RUN bullets are of one kind, as in rings. Such bullets are listed together, with one update of the
 * kind's counter, because waiting for an update per bullet is slow. */
static bool is_run(const uint16_t *kinds)
{
    uint64_t a, b;

    if (kinds[0] != kinds[RUN_LENGTH - 1]) /* the usual result when kinds are mixed */
        return false;
    memcpy(&a, kinds, sizeof a);
    memcpy(&b, kinds + 4, sizeof b);
    return a == b && a == kinds[0] * (uint64_t)0x0001000100010001;
}

static inline void list_slots(uint32_t *restrict slots, uint32_t first)
{
    for (uint32_t k = 0; k < RUN_LENGTH; k++)
        slots[k] = first + k;
}

/* Lists a block in which no bullet needs clipping. with_slots: whether to list the slots as well, a constant at each
 * call. */
__attribute__((always_inline)) static inline void list_unclipped_block(struct lists *l, const uint16_t *kinds,
                                                                       const uint32_t entries[SLOTS_BLOCK],
                                                                       uint32_t first, bool with_slots)
{
    uint32_t *list = l->list, *slots = l->slots;

    for (uint32_t k = 0; k < SLOTS_BLOCK; k += RUN_LENGTH) {
        if (is_run(kinds + k)) {
            uint32_t *next = &l->next[kinds[k]];
            memcpy(list + *next, entries + k, RUN_LENGTH * sizeof *list);
            if (with_slots)
                list_slots(slots + *next, first + k);
            *next += RUN_LENGTH;
            continue;
        }
#pragma GCC unroll 8
        for (uint32_t i = 0; i < RUN_LENGTH; i++) {
            const uint32_t next = l->next[kinds[k + i]]++;
            list[next] = entries[k + i];
            if (with_slots)
                slots[next] = first + k + i;
        }
    }
}

/* Lists a block if all its slots are live and none of its bullets needs clipping, the usual case. Otherwise lists
 * nothing and returns false. */
static bool list_block(struct lists *l, const struct bullets *s, const struct window *t, uint32_t block)
{
    const uint32_t first = block * SLOTS_BLOCK;
    uint32_t entries[SLOTS_BLOCK];

    if (l->any_listed_by_slot || ~s->s.live_bits[block] || t->x0 > t->x1 ||
        !find_entries(s->x + first, s->y + first, entries, t))
        return false;
    add_banks(s->bank + first, entries);
    if (l->any_varied)
        list_unclipped_block(l, s->kind + first, entries, first, true);
    else
        list_unclipped_block(l, s->kind + first, entries, first, false);
    return true;
}

static void list_all(struct lists *l, const struct bullets *s, const struct window *t)
{
    for (uint32_t block = 0; block < s->s.top / SLOTS_BLOCK; block++)
        if (!list_block(l, s, t, block))
            list_single_bullets(l, s, t, block);
}

/* ---- drawing the lists ---- */

static void draw_bullet(struct draw_target *c, const struct bullets *s, const struct lists *l, const struct window *t,
                        uint32_t i)
{
    struct image image = image_of(c, l, s, i);
    int x, y;

    find_corner(t, l, s, i, &x, &y);
    video_paint(c, &image, x, y, s->bank[i], 0, l->style[s->kind[i]].blend);
}

/* Selects the pictures of a rotated or animated kind, with multiplications instead of divisions. age * ticks_reciprocal
 * >> AGE_BITS is the exact quotient age / ticks_per_frame: `ticks_reciprocal` exceeds 2^AGE_BITS / ticks_per_frame by
 * at most 1, so the error is at most age / 2^AGE_BITS, which is below 1 / ticks_per_frame because age < MAX_FAST_AGE
 * and ticks_per_frame < 2^16. */
struct picker {
    uint32_t size; /* bytes of a picture */
    uint32_t rotations, copies_per_frame, frames,
        ticks_per_frame; /* copies_per_frame: copies per animation frame; ticks_per_frame: ticks per animation frame */
    uint64_t ticks_reciprocal, frames_reciprocal; /* reciprocals of `ticks_per_frame` and of `frames` */
    ang dir_mask, spin;                           /* dir_mask: mask for dir, all bits or none */
    bool uses_age;                                /* the picture depends on the bullet's age */
    unsigned shift; /* there are 2^(32 - shift) copies; 0: their number is not a power of 2 */
    ang half_turn;  /* half the angle between two copies */
};

enum { AGE_BITS = 40, MAX_FAST_AGE = 1 << 23 };

static uint64_t reciprocal(uint32_t n)
{
    return ((uint64_t)1 << AGE_BITS) / n + 1;
}

static unsigned shift_of(uint32_t rotations)
{
    unsigned shift = 31;

    while (shift && rotations != 1u << (32 - shift))
        shift--;
    return shift;
}

static struct picker picker_of(const struct style *style)
{
    const struct sprite *pic = style->pic;
    const unsigned shift = shift_of(pic->rotations);

    return (struct picker){ .size = (uint32_t)pic->pitch * (uint32_t)pic->h,
                            .rotations = style->has_rotations ? pic->rotations : 0,
                            .copies_per_frame = pic->rotations,
                            .frames = pic->frames,
                            .ticks_per_frame = pic->frame_ticks ? pic->frame_ticks : 1,
                            .ticks_reciprocal = reciprocal(pic->frame_ticks ? pic->frame_ticks : 1),
                            .frames_reciprocal = reciprocal(pic->frames),
                            .dir_mask = style->uses_dir ? UINT32_MAX : 0,
                            .spin = style->spin,
                            .uses_age = pic->frames > 1 || style->spin,
                            .shift = shift,
                            .half_turn = shift ? 1u << (shift - 1) : 0 };
}

/* Returns the offset in bytes of bullet i's picture, for a kind whose picture depends on the age. */
static inline uint32_t picture_offset(const struct picker *p, const struct bullets *s, uint32_t i, uint32_t clock)
{
    const uint32_t age = bullets_age(s, i, clock);
    const uint32_t at =
        age < MAX_FAST_AGE ? (uint32_t)(age * p->ticks_reciprocal >> AGE_BITS) : age / p->ticks_per_frame;
    const uint32_t frame =
        at < MAX_FAST_AGE ? at - (uint32_t)(at * p->frames_reciprocal >> AGE_BITS) * p->frames : at % p->frames;

    return (frame * p->copies_per_frame + stamp_turn_index((s->dir[i] & p->dir_mask) + p->spin * age, p->rotations)) *
           p->size;
}

/* Finds the offsets in bytes of the pictures of n bullets. Bullets listed by slot are included, but their offsets are
 * not used. */
static void find_picture_offsets(const struct draw_target *c, const struct bullets *s, const struct picker *picker,
                                 const uint32_t *restrict slots, uint32_t n, uint32_t *restrict offsets)
{
    const struct picker p = *picker;
    const ang *dir = s->dir;

    if (p.uses_age)
        for (uint32_t k = 0; k < n; k++)
            offsets[k] = picture_offset(&p, s, slots[k], c->b->core.clock);
    else if (p.shift)
        for (uint32_t k = 0; k < n; k++)
            offsets[k] = ((dir[slots[k]] + p.half_turn) >> p.shift) * p.size;
    else
        for (uint32_t k = 0; k < n; k++)
            offsets[k] = stamp_turn_index(dir[slots[k]], p.rotations) * p.size;
}

/* Draws a kind whose bullets show different pictures, with a selected picture for each. */
static void draw_varied(struct draw_target *c, const struct bullets *s, const struct lists *l, const struct window *t,
                        const struct style *style, uint32_t n)
{
    const uint32_t *list = l->list + style->list_start, *slots = l->slots + style->list_start;
    const struct image image = video_image(style->pic, 0, false, 0);
    const struct picker p = picker_of(style);
    uint32_t offsets[BATCH_SIZE];

    for (uint32_t k = 0, batch; k < n; k += batch) {
        batch = n - k < BATCH_SIZE ? n - k : BATCH_SIZE;
        find_picture_offsets(c, s, &p, slots + k, batch, offsets);
        for (uint32_t j = 0; j < batch; j++) {
            j += (uint32_t)stamp_draw_each(c->fb, &image, offsets + j, style->mix,
                                           &(struct stamp_list){ list + k + j, batch - j, style->less });
            if (j < batch)
                draw_bullet(c, s, l, t, list[k + j] & (STAMP_CALLER_ENTRY - 1));
        }
    }
}

static void draw_one_by_one(struct draw_target *c, const struct bullets *s, const struct lists *l,
                            const struct window *t, const struct style *style, uint32_t n)
{
    const uint32_t *list = l->list + style->list_start, *slots = l->slots + style->list_start;

    for (uint32_t k = 0; k < n; k++)
        draw_bullet(c, s, l, t, list[k] & STAMP_CALLER_ENTRY ? list[k] & (STAMP_CALLER_ENTRY - 1) : slots[k]);
}

/* Returns a sprite's first picture. */
static inline struct image first_image(const struct sprite *pic)
{
    return (struct image){ pic->pix, pic->w, pic->h, pic->pitch };
}

static void draw_same_picture(struct draw_target *c, const struct bullets *s, const struct lists *l,
                              const struct window *t, const struct style *style, uint32_t n)
{
    const struct image image = first_image(style->pic);
    const uint32_t *list = l->list + style->list_start;

    for (uint32_t k = 0; k < n; k++) {
        k += (uint32_t)stamp_draw(c->fb, &image, style->mix, &(struct stamp_list){ list + k, n - k, style->less });
        if (k < n)
            draw_bullet(c, s, l, t, list[k] & (STAMP_CALLER_ENTRY - 1));
    }
}

static void draw_kind(struct draw_target *c, const struct bullets *s, const struct lists *l, const struct window *t,
                      uint16_t kind)
{
    const struct style *style = &l->style[kind];
    const uint32_t n = listed_count(l, kind);

    if (style->shares_picture)
        draw_same_picture(c, s, l, t, style, n);
    else if (style->is_drawn_one_by_one)
        draw_one_by_one(c, s, l, t, style, n);
    else
        draw_varied(c, s, l, t, style, n);
}

void video_draw_bullets(struct draw_target *c, const struct bullets *s, const struct bullet_kinds *k)
{
    struct lists *l = init_lists(c);

    if (!s->s.live)
        return;
    find_kinds(c, k, l);
    c->drawn_count += s->s.live;
    const struct window t = init_window(l, c->fb, c->x, c->y);
    list_all(l, s, &t);
    for (uint32_t o = 0; o < l->kind_count; o++)
        draw_kind(c, s, l, &t, l->order[o]);
}

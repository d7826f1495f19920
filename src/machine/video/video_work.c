/*
 * video_work.c - estimates the work of drawing a picture (vm_state.h) without drawing it.
 *
 * Drawing happens outside the tick, so the tick counts the work of drawing its frame in advance, and ends in a fault if
 * there is too much. Nearly always an upper bound computed from the number of entities is low enough; otherwise the
 * work of each entity is counted.
 */
#include "../../base/int.h"
#include "../lasers_run.h"
#include "video.h"

/* Pixels drawn per unit of work, for opaque pictures, blended pictures, plates and lasers' lines. ROWS_PER_WORK: rows
 * per unit of work, for a segment of a laser. */
enum { SOLID_PX_PER_WORK = 64, BLEND_PX_PER_WORK = 8, PLATE_PX_PER_WORK = 16, LINE_PX_PER_WORK = 3, ROWS_PER_WORK = 2 };
enum { COPY_PX_PER_WORK = 2 /* pixels of a scaled or translucent picture's copies */ };

/* Units of work for each pixel of a laser's round end, which takes a square root; for each segment of its line; for
 * each letter. */
enum { WORK_PER_END_PX = 1, WORK_PER_SEGMENT = 20, WORK_PER_LETTER = 30 };

enum { RIM_DRAWS = 5 /* times an enemy with a white rim is drawn */ };

static uint64_t screen_px(const struct board *b)
{
    return (uint64_t)b->cart.manifest.screen_w * (uint64_t)b->cart.manifest.screen_h;
}

/* Returns the work of n pictures of one sprite, scaled and drawn with an opacity. Counts a copy for each picture,
 * although most pictures share copies. */
static uint64_t pictures_work(const struct board *b, uint64_t n, uint32_t sprite, bool blended, struct pose pose)
{
    const struct sprite s = video_scale_sprite(&b->sprite_images[sprite], pose.scale);
    const uint64_t w = (uint64_t)int_min(s.w, b->cart.manifest.screen_w),
                   h = (uint64_t)int_min(s.h, b->cart.manifest.screen_h);

    if (!video_needs_copy(&pose))
        return n * (1 + w * h / (blended ? BLEND_PX_PER_WORK : SOLID_PX_PER_WORK));
    return 2 * n * (1 + w * h / BLEND_PX_PER_WORK + (uint64_t)s.w * s.h / COPY_PX_PER_WORK);
}

static const struct pose plain_pose = { .scale = SCALE_ONE, .alpha = ALPHA_OPAQUE };

static uint64_t bullets_and_shots_work(const struct board *b)
{
    const struct bullet_kinds *const lists[] = { &b->bullet_kinds, &b->shot_kinds };
    uint64_t work = 0;

    for (size_t n = 0; n < COUNT(lists); n++) {
        const struct bullet_kinds *k = lists[n];

        for (uint32_t i = 0; i < k->s.live; i++)
            if (k->live_count[i])
                work +=
                    pictures_work(b, k->live_count[i], k->sprite[i], k->flags[i] & KIND_BLEND,
                                  (struct pose){ .scale = k->scale ? k->scale[i] : SCALE_ONE, .alpha = ALPHA_OPAQUE });
    }
    return work;
}

static uint64_t sparks_work(const struct board *b)
{
    uint64_t work = 0;

    EACH_LIVE (i, &b->sparks.s) {
        const uint16_t kind = b->sparks.kind[i], sprite = b->spark_kinds.sprite[kind];
        const bool blended = sparks_bank(&b->spark_kinds, kind, b->sparks.age[i]) & SPARK_BLEND;
        work += sprite == SPARK_DOT ? 1 : pictures_work(b, 1, sprite, blended, plain_pose);
    }
    return work;
}

static uint64_t items_work(const struct board *b)
{
    const struct item_kinds *k = &b->item_kinds;
    uint64_t work = 0;

    EACH_LIVE (i, &b->items.s)
        work += pictures_work(b, 1, k->sprite[b->items.kind[i]], k->flags[b->items.kind[i]] & ITEM_BLEND, plain_pose);
    return work;
}

static uint64_t enemies_work(const struct board *b)
{
    const struct enemies *e = &b->enemies;
    const struct enemy_kinds *k = &b->enemy_kinds;
    uint64_t work = 0;

    EACH_LIVE (i, &e->s)
        work += pictures_work(b, RIM_DRAWS, enemies_sprite(e, k, i), k->flags[e->kind[i]] & ENEMY_BLEND,
                              e->dir ? (struct pose){ 0, e->scale[i], e->alpha[i] } : plain_pose);
    return work;
}

/* Counts sprites and plates over a dimmed picture twice, because they are drawn twice. */
static uint64_t sprites_work(const struct board *b)
{
    const struct sprites *s = &b->sprites;
    uint64_t work = 0;

    EACH_LIVE (i, &s->s) {
        if (s->flags[i] & SPRITE_HIDDEN)
            continue;
        if (s->layer[i] >= LAYER_PLATE)
            work += 2 * (uint64_t)s->sprite[i] * s->born[i] / PLATE_PX_PER_WORK;
        else
            work += pictures_work(b, s->layer[i] == LAYER_OVER ? 2 : 1, s->sprite[i], s->flags[i] & SPRITE_BLEND,
                                  s->dir ? (struct pose){ 0, s->scale[i], s->alpha[i] & SPRITE_ALPHA } : plain_pose);
    }
    return work;
}

/* Returns the work of a line of text with a box and the given number of letters. */
static uint64_t text_work(const struct board *b, uint64_t letters)
{
    uint64_t side = 8;

    for (int i = 0; i < b->cart.count[CART_FACES]; i++)
        side = (uint64_t)int_max((int)side, cart_face(&b->cart, i).height);
    return 2 * (letters * (WORK_PER_LETTER + side * side / SOLID_PX_PER_WORK) + screen_px(b) / PLATE_PX_PER_WORK);
}

static uint64_t lines_work(const struct board *b)
{
    uint64_t work = 0;

    EACH_LIVE (i, &b->lines.s)
        if (!(b->lines.flags[i] & LINE_HIDDEN))
            work += text_work(b, b->lines.length[i]);
    return work;
}

/* Returns an upper bound of a laser's work, as if each of its segments crossed the screen and had two round ends. */
static uint64_t max_laser_work(const struct board *b, uint32_t i)
{
    const uint64_t w = (uint64_t)b->lasers.width[i] / FX_ONE + 2, px = screen_px(b);
    const uint64_t rows = (uint64_t)b->cart.manifest.screen_h, cols = (uint64_t)b->cart.manifest.screen_w;
    const uint64_t line = (rows + cols) * w < px ? (rows + cols) * w : px, end = w * w < px ? w * w : px;

    return lasers_corner_count(b, i) *
           (WORK_PER_SEGMENT + rows / ROWS_PER_WORK + line / LINE_PX_PER_WORK + 2 * end * WORK_PER_END_PX);
}

/* A vector from corner to corner, px. */
struct vector {
    int64_t x, y;
};

static struct vector segment_vector(const struct board *b, uint32_t i, uint32_t k)
{
    fx ax, ay, bx, by;

    lasers_get_corner(b, i, k, &ax, &ay);
    lasers_get_corner(b, i, k + 1, &bx, &by);
    return (struct vector){ ((int64_t)bx - ax) / FX_ONE, ((int64_t)by - ay) / FX_ONE };
}

/* Returns whether the line turns by 45 degrees or more from segment a to segment b, and so may have round ends there.
 * Drawing merges short segments, so the drawn line may turn less often. */
static bool is_sharp(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y <= int64_abs(a.x * b.y - a.y * b.x);
}

static uint64_t laser_work(const struct board *b, uint32_t i)
{
    const uint32_t n = lasers_corner_count(b, i);
    const uint64_t w = (uint64_t)b->lasers.width[i] / FX_ONE + 2, px = screen_px(b);
    const uint64_t end = (w * w < px ? w * w : px) * WORK_PER_END_PX;
    uint64_t work = 2 * end;
    struct vector previous = { 0 };

    for (uint32_t k = 0; k + 1 < n; k++) {
        const struct vector segment = segment_vector(b, i, k);
        const uint64_t length = (uint64_t)(int64_abs(segment.x) + int64_abs(segment.y)) + 2, line = length * w;
        work += WORK_PER_SEGMENT +
                (length + w < (uint64_t)b->cart.manifest.screen_h ? length + w : (uint64_t)b->cart.manifest.screen_h) /
                    ROWS_PER_WORK +
                (line < px ? line : px) / LINE_PX_PER_WORK;
        if (k && is_sharp(previous, segment))
            work += 2 * end;
        previous = segment;
    }
    return work;
}

static uint64_t lasers_work(const struct board *b)
{
    uint64_t work = 0;

    EACH_LIVE (i, &b->lasers.s)
        work += laser_work(b, i);
    return work;
}

/* Returns an upper bound of all work, as if each picture were as large as the screen and blended. To this, adds the
 * work of pictures that may be scaled. */
static uint64_t max_total_work(const struct board *b)
{
    const uint64_t entities = (uint64_t)b->bullets.s.live + b->shots.s.live + b->sparks.s.live + b->items.s.live +
                              (uint64_t)RIM_DRAWS * b->enemies.s.live + 2 * (uint64_t)b->sprites.s.live +
                              b->options.s.live;
    uint64_t work = entities * (1 + screen_px(b) / BLEND_PX_PER_WORK);

    if (b->cart.manifest.has_transforms)
        work += bullets_and_shots_work(b) + enemies_work(b) + sprites_work(b);
    if (b->lines.s.live)
        work += b->lines.s.live * text_work(b, LINE_MAX_TEXT);
    if (b->lasers.s.live)
        EACH_LIVE (i, &b->lasers.s)
            work += max_laser_work(b, i);
    return work;
}

bool video_fits(const struct board *b, uint64_t limit, struct video_work *out)
{
    static const struct {
        const char *name, *advice;
        uint64_t (*work)(const struct board *b);
    } parts[] = {
        { "bullets and shots", "lower `board.bullets` in rom.lua", bullets_and_shots_work },
        { "sparks", "lower `board.sparks` in rom.lua", sparks_work },
        { "items", "lower `board.items` in rom.lua", items_work },
        { "enemies", "lower `board.enemies` in rom.lua", enemies_work },
        { "sprites", "lower `board.sprites` in rom.lua", sprites_work },
        { "lines of text", "lower `board.lines` in rom.lua", lines_work },
        { "lasers", "lower `board.lasers` in rom.lua", lasers_work },
    };
    uint64_t largest = 0;

    *out = (struct video_work){ 0 };
    if (max_total_work(b) <= limit)
        return true;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        const uint64_t work = parts[i].work(b);
        out->work += work;
        if (work < largest)
            continue;
        largest = work;
        out->largest_name = parts[i].name;
        out->advice = parts[i].advice;
    }
    return out->work <= limit;
}

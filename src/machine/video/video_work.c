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

/* Pixels drawn per unit of work, for opaque pictures, blended pictures, plates and lasers' lines. ROW_PX: rows per unit
 * of work, for a segment of a laser. */
enum { SOLID_PX = 64, BLEND_PX = 8, PLATE_PX = 16, LINE_PX = 3, ROW_PX = 2 };

/* Units of work for each pixel of a laser's round end, which takes a square root; for each segment of its line; for
 * each letter. */
enum { AN_END_PX = 1, A_PIECE = 20, A_LETTER = 30 };

enum { RIM = 5 /* times an enemy with a white rim is drawn */ };

static uint64_t screen_px(const struct board *b)
{
    return (uint64_t)b->cart.m.screen_w * (uint64_t)b->cart.m.screen_h;
}

/* Returns the work of n pictures of one sprite. */
static uint64_t pictures(const struct board *b, uint64_t n, uint32_t sprite, bool blend)
{
    const struct sprite *s = &b->pictures[sprite];
    const uint64_t w = (uint64_t)int_min(s->w, b->cart.m.screen_w), h = (uint64_t)int_min(s->h, b->cart.m.screen_h);

    return n * (1 + w * h / (blend ? BLEND_PX : SOLID_PX));
}

static uint64_t bullets(const struct board *b, const struct bullet_kinds *k)
{
    uint64_t work = 0;

    for (uint32_t i = 0; i < k->s.live; i++)
        if (k->live[i])
            work += pictures(b, k->live[i], k->sprite[i], k->flags[i] & KIND_BLEND);
    return work;
}

static uint64_t sparks(const struct board *b)
{
    uint64_t work = 0;

    EACH_LIVE (i, &b->sparks.s) {
        const uint16_t kind = b->sparks.kind[i];
        work += pictures(b, 1, b->spark_kinds.sprite[kind],
                         sparks_bank(&b->spark_kinds, kind, b->sparks.age[i]) & SPARK_BLEND);
    }
    return work;
}

static uint64_t items(const struct board *b)
{
    const struct item_kinds *k = &b->item_kinds;
    uint64_t work = 0;

    EACH_LIVE (i, &b->items.s)
        work += pictures(b, 1, k->sprite[b->items.kind[i]], k->flags[b->items.kind[i]] & ITEM_BLEND);
    return work;
}

static uint64_t enemies(const struct board *b)
{
    const struct enemy_kinds *k = &b->enemy_kinds;
    uint64_t work = 0;

    EACH_LIVE (i, &b->enemies.s)
        work += pictures(b, RIM, enemies_picture(&b->enemies, k, i), k->flags[b->enemies.kind[i]] & ENEMY_BLEND);
    return work;
}

/* Counts sprites and plates over a dimmed picture twice, because they are drawn twice. */
static uint64_t sprites(const struct board *b)
{
    const struct sprites *s = &b->sprites;
    uint64_t work = 0;

    EACH_LIVE (i, &s->s) {
        if (s->flags[i] & SPRITE_HIDDEN)
            continue;
        if (s->layer[i] >= LAYER_PLATE)
            work += 2 * (uint64_t)s->sprite[i] * s->born[i] / PLATE_PX;
        else
            work += pictures(b, s->layer[i] == LAYER_OVER ? 2 : 1, s->sprite[i], s->flags[i] & SPRITE_BLEND);
    }
    return work;
}

/* Returns the work of a line of text with a box and the given number of letters. */
static uint64_t text(const struct board *b, uint64_t letters)
{
    uint64_t side = 8;

    for (int i = 0; i < b->cart.faces; i++)
        side = (uint64_t)int_max((int)side, cart_face(&b->cart, i).height);
    return 2 * (letters * (A_LETTER + side * side / SOLID_PX) + screen_px(b) / PLATE_PX);
}

static uint64_t lines(const struct board *b)
{
    uint64_t work = 0;

    EACH_LIVE (i, &b->lines.s)
        if (!(b->lines.flags[i] & LINE_HIDDEN))
            work += text(b, b->lines.length[i]);
    return work;
}

/* Returns an upper bound of a laser's work, as if each of its segments crossed the screen and had two round ends. */
static uint64_t laser_at_most(const struct board *b, uint32_t i)
{
    const uint64_t w = (uint64_t)b->lasers.width[i] / FX_ONE + 2, px = screen_px(b);
    const uint64_t rows = (uint64_t)b->cart.m.screen_h, cols = (uint64_t)b->cart.m.screen_w;
    const uint64_t line = (rows + cols) * w < px ? (rows + cols) * w : px, end = w * w < px ? w * w : px;

    return lasers_corners(b, i) * (A_PIECE + rows / ROW_PX + line / LINE_PX + 2 * end * AN_END_PX);
}

/* A vector from corner to corner, px. */
struct way {
    int64_t x, y;
};

static struct way way_at(const struct board *b, uint32_t i, uint32_t k)
{
    fx ax, ay, bx, by;

    lasers_corner(b, i, k, &ax, &ay);
    lasers_corner(b, i, k + 1, &bx, &by);
    return (struct way){ ((int64_t)bx - ax) / FX_ONE, ((int64_t)by - ay) / FX_ONE };
}

/* Returns whether the line turns by 45 degrees or more from segment a to segment b, and so may have round ends there.
 * Drawing merges short segments, so the drawn line may turn less often. */
static bool is_sharp(struct way a, struct way b)
{
    return a.x * b.x + a.y * b.y <= int64_abs(a.x * b.y - a.y * b.x);
}

static uint64_t laser(const struct board *b, uint32_t i)
{
    const uint32_t n = lasers_corners(b, i);
    const uint64_t w = (uint64_t)b->lasers.width[i] / FX_ONE + 2, px = screen_px(b);
    const uint64_t end = (w * w < px ? w * w : px) * AN_END_PX;
    uint64_t work = 2 * end;
    struct way last = { 0 };

    for (uint32_t k = 0; k + 1 < n; k++) {
        const struct way to = way_at(b, i, k);
        const uint64_t far = (uint64_t)(int64_abs(to.x) + int64_abs(to.y)) + 2, line = far * w;
        work += A_PIECE + (far + w < (uint64_t)b->cart.m.screen_h ? far + w : (uint64_t)b->cart.m.screen_h) / ROW_PX +
                (line < px ? line : px) / LINE_PX;
        if (k && is_sharp(last, to))
            work += 2 * end;
        last = to;
    }
    return work;
}

static uint64_t lasers(const struct board *b)
{
    uint64_t work = 0;

    EACH_LIVE (i, &b->lasers.s)
        work += laser(b, i);
    return work;
}

static uint64_t bullets_and_shots(const struct board *b)
{
    return bullets(b, &b->bullet_kinds) + bullets(b, &b->shot_kinds);
}

/* Returns an upper bound of all work, as if each picture were as large as the screen and blended. */
static uint64_t at_most(const struct board *b)
{
    const uint64_t entities = (uint64_t)b->bullets.s.live + b->shots.s.live + b->sparks.s.live + b->items.s.live +
                              (uint64_t)RIM * b->enemies.s.live + 2 * (uint64_t)b->sprites.s.live + b->options.s.live;
    uint64_t work = entities * (1 + screen_px(b) / BLEND_PX);

    if (b->lines.s.live)
        work += b->lines.s.live * text(b, LINE_TEXT);
    if (b->lasers.s.live)
        EACH_LIVE (i, &b->lasers.s)
            work += laser_at_most(b, i);
    return work;
}

bool video_fits(const struct board *b, uint64_t most, struct video_work *out)
{
    static const struct {
        const char *what, *instead;
        uint64_t (*work)(const struct board *b);
    } parts[] = {
        { "bullets and shots", "lower `board.bullets` in rom.lua", bullets_and_shots },
        { "sparks", "lower `board.sparks` in rom.lua", sparks },
        { "items", "lower `board.items` in rom.lua", items },
        { "enemies", "lower `board.enemies` in rom.lua", enemies },
        { "sprites", "lower `board.sprites` in rom.lua", sprites },
        { "lines of text", "lower `board.lines` in rom.lua", lines },
        { "lasers", "lower `board.lasers` in rom.lua", lasers },
    };
    uint64_t largest = 0;

    *out = (struct video_work){ 0 };
    if (at_most(b) <= most)
        return true;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        const uint64_t work = parts[i].work(b);
        out->work += work;
        if (work < largest)
            continue;
        largest = work;
        out->what = parts[i].what;
        out->instead = parts[i].instead;
    }
    return out->work <= most;
}

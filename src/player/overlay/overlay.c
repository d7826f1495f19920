/*
 * overlay.c - see overlay.h.
 *
 * A panel is lines of text, each of one colour, some with a bar after it. Panels are placed side by side from the top
 * left; the panel of the object under the mouse is placed beside it, where no other panel is.
 */
#include "overlay.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/clock.h"
#include "../../base/int.h"

enum {
    FRAME_USEC = 1000000 / 60,
    LINE = 72,    /* bytes of a panel's line */
    LINES = 48,   /* of a panel */
    BAR = 30,     /* px that a bar of a whole frame is long */
    LIMITED = 27, /* and of a level of half full scale, where the limiter begins */
    PANELS = 8,   /* most on a picture */
    EDGE = 2,     /* px round a panel's text */
    GAP = 1,      /* px between panels */
    MOUSE = 6,    /* px that a thing may be away from the mouse */
    BESIDE = 10,  /* px from the mouse to its panel */
    TASKS = 64    /* most that are listed */
};

void overlay_keys(struct overlay *o, uint32_t pressed)
{
    for (int i = 0; i < OVERLAYS; i++)
        o->on[i] ^= pressed >> (HOTKEY_SHAPES + i) & 1;
}

bool overlay_on(const struct overlay *o)
{
    for (int i = 0; i < OVERLAYS; i++)
        if (o->on[i])
            return true;
    return false;
}

/* ---- times ---- */

void overlay_lap(struct overlay *o, int part)
{
    if (!o->on[OVERLAY_SPLIT])
        return;
    o->split.now[part] += clock_lap(&o->split.last);
}

static void phase_ended(void *context, enum board_phase phase)
{
    overlay_lap(context, (int)phase);
}

static void before_tick(void *context)
{
    overlay_lap(context, SPLIT_PROGRAM);
}

void overlay_begin(struct overlay *o, struct guard *g)
{
    bool on = o->on[OVERLAY_SPLIT];
    board_set_phase_callback(g->board, on ? phase_ended : 0, o);
    g->before = on ? before_tick : 0;
    g->context = o;
    memset(o->split.now, 0, sizeof o->split.now);
    if (on)
        o->split.last = plat_usec();
}

/* What the window's frames came to is shown until the next window is full: digits that can be read. */
static void close_window(struct split *s)
{
    s->all = 0;
    for (int i = 0; i < SPLITS; i++) {
        s->mean[i] = (uint32_t)(s->sum[i] / SPLIT_WINDOW);
        s->peak[i] = (uint32_t)s->most[i];
        s->all += s->mean[i];
    }
    memset(s->sum, 0, sizeof s->sum);
    memset(s->most, 0, sizeof s->most);
    s->worst = s->slowest;
    s->slowest = 0;
    s->frames = 0;
}

void overlay_end(struct overlay *o)
{
    struct split *s = &o->split;
    uint64_t all = 0;
    if (!o->on[OVERLAY_SPLIT])
        return;
    for (int i = 0; i < SPLITS; i++) {
        s->sum[i] += s->now[i];
        s->most[i] = s->now[i] > s->most[i] ? s->now[i] : s->most[i];
        all += s->now[i];
    }
    s->slowest = all > s->slowest ? (uint32_t)all : s->slowest;
    if (++s->frames == SPLIT_WINDOW)
        close_window(s);
}

/* ---- panels ---- */

struct panel {
    char text[LINES][LINE];
    enum canvas_colour colour[LINES];
    int bar[LINES]; /* microseconds, -1: none; of a level, its share of a whole frame's */
    bool level[LINES];
    int lines, columns;
    bool bars;
};

#ifdef __GNUC__
__attribute__((format(printf, 3, 4)))
#endif
static void
add(struct panel *s, enum canvas_colour c, const char *format, ...)
{
    va_list args;
    if (s->lines == LINES)
        return;
    va_start(args, format);
    vsnprintf(s->text[s->lines], LINE, format, args);
    va_end(args);
    int columns = canvas_width(s->text[s->lines]) / CANVAS_CELL_W;
    s->columns = columns > s->columns ? columns : s->columns;
    s->bar[s->lines] = -1;
    s->level[s->lines] = false;
    s->colour[s->lines++] = c;
}

static void add_bar(struct panel *s, uint32_t usec)
{
    s->bar[s->lines - 1] = usec > INT32_MAX ? INT32_MAX : (int)usec;
    s->bars = true;
}

static int panel_w(const struct panel *s)
{
    return s->columns * CANVAS_CELL_W - 1 + 2 * EDGE + (s->bars ? EDGE + BAR : 0);
}

static int panel_h(int lines)
{
    return lines * CANVAS_CELL_H - 1 + 2 * EDGE;
}

static void draw_bar(const struct canvas *canvas, int x, int y, int usec, bool level)
{
    int w = usec >= FRAME_USEC ? BAR : usec * BAR / FRAME_USEC, high = level ? LIMITED : BAR / 2;
    canvas_rect(canvas, x, y + 4, BAR, 1, CANVAS_GREY);
    canvas_rect(canvas, x, y, usec && !w ? 1 : w, 5, w >= BAR ? CANVAS_RED : w > high ? CANVAS_YELLOW : CANVAS_GREEN);
}

static void draw_panel(const struct canvas *canvas, const struct panel *s, int x, int y, int lines)
{
    canvas_rect(canvas, x, y, panel_w(s), panel_h(lines), CANVAS_DARK);
    for (int i = 0; i < lines; i++) {
        int at = y + EDGE + i * CANVAS_CELL_H;
        bool cut = i == lines - 1 && lines < s->lines;
        canvas_text(canvas, x + EDGE, at, cut ? CANVAS_GREY : s->colour[i], cut ? "..." : s->text[i]);
        if (s->bar[i] >= 0 && !cut)
            draw_bar(canvas, x + panel_w(s) - EDGE - BAR, at, s->bar[i], s->level[i]);
    }
}

/* ---- where panels stand ---- */

struct rect {
    int x, y, w, h;
};

struct layout {
    int y0, y1, w;   /* of the picture, what is free for panels */
    int x, y, shelf; /* the next one's place; how high its row of panels is so far */
    struct rect used[PANELS];
    int n;
};

static void occupy(struct layout *l, int x, int y, int w, int h)
{
    if (l->n < PANELS)
        l->used[l->n++] = (struct rect){ x, y, w, h };
}

/* Beside the one before when the picture is wide enough, else under the row of those; as many lines of it as there is
 * room for. */
static void place(struct layout *l, const struct canvas *canvas, const struct panel *s)
{
    int lines = s->lines, w = panel_w(s);
    if (l->x > 0 && l->x + w > l->w) {
        l->x = 0;
        l->y += l->shelf + GAP;
        l->shelf = 0;
    }
    while (lines > 0 && l->y + panel_h(lines) > l->y1)
        lines--;
    if (!lines)
        return;
    draw_panel(canvas, s, l->x, l->y, lines);
    occupy(l, l->x, l->y, w, panel_h(lines));
    l->x += w + GAP;
    l->shelf = panel_h(lines) > l->shelf ? panel_h(lines) : l->shelf;
}

static bool overlaps(const struct layout *l, int x, int y, int w, int h)
{
    for (int i = 0; i < l->n; i++) {
        const struct rect *t = &l->used[i];
        if (x < t->x + t->w + GAP && t->x < x + w + GAP && y < t->y + t->h + GAP && t->y < y + h + GAP)
            return true;
    }
    return false;
}

/* If (x, y, w, h) is free and nearer to the mouse than *far, it becomes *best, and *far its distance. */
static void try_position(const struct layout *l, int x, int y, int w, int h, int mouse_x, int mouse_y,
                         struct rect *best, int *far)
{
    int dx = mouse_x < x ? x - mouse_x : mouse_x >= x + w ? mouse_x - x - w + 1 : 0;
    int dy = mouse_y < y ? y - mouse_y : mouse_y >= y + h ? mouse_y - y - h + 1 : 0;
    int away = dx > dy ? dx : dy;
    if (x < 0 || y < l->y0 || x + w > l->w || y + h > l->y1 || away < BESIDE || away >= *far || overlaps(l, x, y, w, h))
        return;
    *best = (struct rect){ x, y, w, h };
    *far = away;
}

/* Beside the mouse, and where no panel is: the nearest of many places. Where there is none, at the bottom. */
static void place_beside_mouse(struct layout *l, const struct canvas *canvas, const struct panel *s, int mouse_x,
                               int mouse_y)
{
    int w = panel_w(s), h = panel_h(s->lines), far = INT32_MAX;
    struct rect best = { l->w - w, l->y1 - h, w, h };
    try_position(l, mouse_x + BESIDE, mouse_y + BESIDE, w, h, mouse_x, mouse_y, &best, &far);
    try_position(l, mouse_x - BESIDE - w + 1, mouse_y + BESIDE, w, h, mouse_x, mouse_y, &best, &far);
    for (int y = l->y0; y + h <= l->y1; y += 4)
        for (int x = 0; x + w <= l->w; x += 4)
            try_position(l, x, y, w, h, mouse_x, mouse_y, &best, &far);
    draw_panel(canvas, s, best.x, best.y, s->lines);
    canvas_frame(canvas, best.x, best.y, w, h, CANVAS_GREY);
}

/* ---- hit shapes ---- */

static void draw_shape(const struct canvas *canvas, const struct inspect_body *s, enum canvas_colour c)
{
    if (s->shape == INSPECT_CIRCLE)
        canvas_ring(canvas, s->x, s->y, s->a, c);
    else if (s->shape == INSPECT_BOX)
        canvas_box(canvas, s->x, s->y, s->a, s->b, c);
    else if (s->shape == INSPECT_CIRCLES)
        for (int i = 0; i < s->n; i++)
            canvas_ring(canvas, s->circle[i].x, s->circle[i].y, s->circle[i].r, c);
    else if (s->shape == INSPECT_CAPSULE)
        canvas_capsule(canvas, s->x, s->y, s->b, s->c, s->a, c);
    else
        canvas_box(canvas, s->x, s->y, 0, 0, c);
}

static enum canvas_colour colour_of(const struct inspect_body *s)
{
    switch (s->kind) {
    case INSPECT_BULLET:
    case INSPECT_LASER:
        return s->shape == INSPECT_NO_SHAPE ? CANVAS_GREY : s->is_dimmed ? CANVAS_MAGENTA : CANVAS_RED;
    case INSPECT_SHOT:
        return CANVAS_CYAN;
    case INSPECT_ENEMY:
        return s->is_dimmed ? CANVAS_GREY : CANVAS_YELLOW;
    default:
        return s->is_dimmed ? CANVAS_GREY : CANVAS_GREEN;
    }
}

/* A dark rim round each, so that it stands out from whatever it lies on. */
static void draw_shade(void *context, const struct inspect_body *s)
{
    enum { WIDER = 1 << 16 };
    struct inspect_body around = *s;
    around.a += WIDER;
    around.b += s->shape == INSPECT_CAPSULE ? 0 : WIDER;
    for (int i = 0; i < s->n; i++)
        around.circle[i].r += WIDER;
    around.shape = s->shape == INSPECT_NO_SHAPE ? INSPECT_BOX : s->shape;
    draw_shape(context, &around, CANVAS_DARK);
    if (s->graze)
        canvas_ring(context, s->x, s->y, s->graze + WIDER, CANVAS_DARK);
}

static void draw_body(void *context, const struct inspect_body *s)
{
    const struct canvas *canvas = context;
    if (s->graze)
        canvas_ring(canvas, s->x, s->y, s->graze, CANVAS_WHITE);
    draw_shape(canvas, s, colour_of(s));
}

/* As the things themselves, shapes are seen on the field alone. */
static void draw_shapes(const struct canvas *canvas, int y0, int y1, const struct board *b)
{
    struct inspect_area f = inspect_field(b);
    struct canvas on_field = *canvas;
    int top = f.y > y0 ? f.y : y0, bottom = f.y + f.h < y1 ? f.y + f.h : y1;
    fb_set_clip(canvas->fb, f.x, top, f.w, bottom - top);
    inspect_bodies(b, draw_shade, &on_field);
    inspect_bodies(b, draw_body, &on_field);
    fb_reset_clip(canvas->fb);
}

/* White is the shape to the pixel; the ring and the dark round it make it read over a white ship and over bullets. */
static void draw_ship(const struct canvas *canvas, const struct inspect_body *s, enum canvas_colour ring)
{
    enum { PIXEL = 1 << 16 };

    canvas_disc(canvas, s->x, s->y, s->a + 2 * PIXEL, CANVAS_DARK);
    canvas_disc(canvas, s->x, s->y, s->a + PIXEL, ring);
    canvas_disc(canvas, s->x, s->y, s->a, CANVAS_WHITE);
}

void overlay_ships(const struct canvas *canvas, const struct board *b)
{
    static const enum canvas_colour rings[MAX_PLAYERS] = { CANVAS_RED, CANVAS_CYAN };
    const struct inspect_area f = inspect_field(b);
    struct inspect_body body;

    fb_set_clip(canvas->fb, f.x, f.y, f.w, f.h);
    for (int i = 0; i < MAX_PLAYERS; i++)
        if (inspect_ship(b, i, &body))
            draw_ship(canvas, &body, rings[i]);
    fb_reset_clip(canvas->fb);
}

/* ---- panels ---- */

static void gauge_line(struct panel *s, const char *name, uint32_t live, uint32_t top, uint32_t cap, uint32_t refused)
{
    enum canvas_colour c = refused                                   ? CANVAS_RED
                           : (uint64_t)live * 10 > (uint64_t)cap * 9 ? CANVAS_YELLOW
                                                                     : CANVAS_WHITE;
    add(s, live ? c : CANVAS_GREY, "%-12s %5u %5u %5u %7u", name, (unsigned)live, (unsigned)top, (unsigned)cap,
        (unsigned)refused);
}

static void place_gauges(struct layout *l, const struct canvas *canvas, const struct board *b)
{
    struct panel s = { .lines = 0 };
    struct inspect_gauge g[MAX_PARTS];
    size_t used, size;
    int n = inspect_gauges(b, g);
    add(&s, CANVAS_CYAN, "%-12s %5s %5s %5s %7s", "part", "live", "top", "cap", "refused");
    for (int i = 0; i < n; i++)
        if (!g[i].is_fixed)
            gauge_line(&s, g[i].name, g[i].live, g[i].top, g[i].cap, g[i].refused);
    inspect_memory(b, &used, &size);
    add(&s, used * 10 > size * 9 ? CANVAS_YELLOW : CANVAS_WHITE, "%-12s %5u %5s %5u", "Lua KiB",
        (unsigned)(used / 1024), "", (unsigned)(size / 1024));
    place(l, canvas, &s);
}

static void place_split(struct layout *l, const struct canvas *canvas, const struct split *t)
{
    static const char *const names[SPLITS] = {
        "scripts", "motion", "hits", "events", "rest", "program", "draw", "show"
    };
    struct panel s = { .lines = 0 };
    add(&s, CANVAS_CYAN, "%-7s %5s %5s", "usec", "mean", "most");
    for (int i = 0; i < SPLITS; i++) {
        add(&s, CANVAS_WHITE, "%-7s %5u %5u", names[i], (unsigned)t->mean[i], (unsigned)t->peak[i]);
        add_bar(&s, t->mean[i]);
    }
    add(&s, CANVAS_CYAN, "%-7s %5u %5u", "frame", (unsigned)t->all, (unsigned)t->worst);
    add_bar(&s, t->all);
    place(l, canvas, &s);
}

static const char *state_of(const struct inspect_task *t, char *buf, size_t size)
{
    if (t->is_stopped)
        return "ends";
    if (t->is_scope)
        return "scope";
    if (t->is_frozen)
        return "pause";
    if (!t->has_begun)
        return "new";
    if (t->waits_forever)
        return "ever";
    snprintf(buf, size, "%u", (unsigned)t->wait);
    return buf;
}

static const char *owner_of(const struct inspect_task *t, char *buf, size_t size)
{
    static const char *const names[] = { "", "bullet", "shot", "enemy", "player", "sprite", "task", "laser", "option" };
    snprintf(buf, size, t->owner == OWNER_BOARD ? "-" : "%s %u", names[t->owner], (unsigned)t->owner_number);
    return buf;
}

static void place_tasks(struct layout *l, const struct canvas *canvas, const struct board *b)
{
    struct panel s = { .lines = 0 };
    struct inspect_task t[TASKS];
    char state[16], owner[24];
    uint32_t n = inspect_tasks(b, 0, t, TASKS), listed = n < TASKS ? n : TASKS;
    add(&s, CANVAS_CYAN, "frame %u  random numbers %llu  tasks %u", (unsigned)board_frame(b),
        (unsigned long long)inspect_random_draws(b), (unsigned)n);
    add(&s, CANVAS_CYAN, "%6s %5s %-11s %s", "task", "wait", "owner", "line");
    for (uint32_t i = 0; i < listed; i++)
        add(&s, t[i].is_scope ? CANVAS_GREY : CANVAS_WHITE, "%6u %5s %-11s %s", (unsigned)t[i].serial,
            state_of(&t[i], state, sizeof state), owner_of(&t[i], owner, sizeof owner), t[i].location);
    place(l, canvas, &s);
}

/* ---- the mixer ---- */

static int fallen(int was, int is)
{
    return int_max(is, was * 7 / 8);
}

void overlay_listen(struct overlay *o, const struct board *b, const struct speaker *speaker)
{
    struct mixer *m = &o->mixer;

    m->speaker = speaker;
    if (!o->on[OVERLAY_MIXER] || !speaker->memory)
        return;
    for (int i = 0; i < VOICES; i++)
        m->voice[i] = fallen(m->voice[i], inspect_voice_peak(b, i, speaker->memory));
    for (int c = 0; c < 2; c++)
        m->out[c] = fallen(m->out[c], speaker->peak[c]);
}

static double decibels(int level)
{
    return level > 0 ? 20 * log10(level / 32768.0) : -99.9;
}

/* A bar of 60 decibels. */
static void add_level(struct panel *s, int level)
{
    const double full = 1 + decibels(level) / 60;

    add_bar(s, full <= 0 ? 0 : (uint32_t)(full * FRAME_USEC));
    s->level[s->lines - 1] = true;
}

static void add_place_of_music(struct panel *s, const struct board *b)
{
    struct inspect_music m;

    inspect_music(b, &m);
    if (!m.name[0]) {
        add(s, CANVAS_GREY, "no music");
        return;
    }
    add(s, CANVAS_WHITE, "%.20s%s%.14s", m.name, m.next[0] ? ", then " : "", m.next);
    add(s, CANVAS_WHITE, "bar %u  beat %d of %d  tempo %u.%02u  gain %d%%%s", (unsigned)m.bar, m.beat, m.beats_per_bar,
        (unsigned)m.tempo / 100, (unsigned)m.tempo % 100, m.gain, m.is_paused ? "  held" : "");
    if (m.mark[0])
        add(s, CANVAS_WHITE, "marker \"%.31s\"", m.mark);
}

static void add_speaker(struct panel *s, const struct speaker *p)
{
    if (p->muted)
        add(s, CANVAS_YELLOW, "muted");
    else if (p->state == SPEAKER_GONE)
        add(s, CANVAS_RED, "no sound device");
    else if (p->state == SPEAKER_OFF || !p->seen.looks)
        add(s, CANVAS_GREY, "no sound yet");
    else
        add(s, p->seen.dry ? CANVAS_YELLOW : CANVAS_WHITE, "volume %d%%  latency %.1f ms  gaps %u", p->volume,
            (double)p->seen.sum / (double)p->seen.looks * 1000 / SPEAKER_RATE, (unsigned)p->seen.dry);
}

static void add_voice(struct panel *s, int i, const struct board *b, int level)
{
    static const char *const notes[] = { "c", "c+", "d", "d+", "e", "f", "f+", "g", "g+", "a", "a+", "b" };
    struct inspect_voice v;

    inspect_voice(b, i, &v);
    const int semitone = (v.pitch + 32768) >> 16;
    if (v.is_busy)
        add(s, v.is_ending ? CANVAS_GREY : CANVAS_WHITE, "%c%-2d  %-16.16s %-6s o%d%-2s  %4d", v.is_music ? 'm' : 's',
            v.is_music ? i + 1 : i + 1 - VOICES_MUSIC, v.source, v.instrument_kind, semitone / 12 - 1,
            notes[semitone % 12], v.pan);
    else
        add(s, CANVAS_GREY, "%c%d", v.is_music ? 'm' : 's', v.is_music ? i + 1 : i + 1 - VOICES_MUSIC);
    add_level(s, level);
}

static void place_mixer(struct layout *l, const struct canvas *canvas, const struct mixer *m, const struct board *b)
{
    struct panel s = { .lines = 0 };

    if (!board_has_sound(b)) {
        add(&s, CANVAS_GREY, "this game has no sound");
        place(l, canvas, &s);
        return;
    }
    add_place_of_music(&s, b);
    add_speaker(&s, m->speaker);
    for (int c = 0; c < 2; c++) {
        add(&s, CANVAS_CYAN, "%s %6.1f dB", c ? "right" : "left ", decibels(m->out[c]));
        add_level(&s, m->out[c]);
    }
    add(&s, CANVAS_CYAN, "%-3s  %-16s %-6s %-4s  %4s", "", "sound", "wave", "note", "pan");
    for (int i = 0; i < VOICES; i++)
        add_voice(&s, i, b, m->voice[i]);
    place(l, canvas, &s);
}

/* ---- what is under the mouse ---- */

static void add_place(struct panel *s, const struct inspect_entity *t)
{
    add(s, CANVAS_WHITE, "at     %.2f, %.2f", t->x / 65536.0, t->y / 65536.0);
}

static void add_author(struct panel *s, const struct board *b, uint32_t by)
{
    struct inspect_task task;
    if (!by)
        return;
    if (inspect_task(b, by, &task))
        add(s, CANVAS_WHITE, "by     task %u %s", (unsigned)by, task.location);
    else
        add(s, CANVAS_WHITE, "by     task %u, ended", (unsigned)by);
}

static void add_motion(struct panel *s, const struct inspect_entity *t)
{
    char name[40];
    if (!t->has_motion)
        return;
    snprintf(name, sizeof name, t->motion ? "%s" : "number %s%u", t->motion ? t->motion : "", (unsigned)t->program);
    if (t->step > t->step_count)
        add(s, CANVAS_WHITE, "motion %s, ended", name);
    else if (t->frames_left)
        add(s, CANVAS_WHITE, "motion %s step %u/%u, %u left", name, (unsigned)t->step, (unsigned)t->step_count,
            (unsigned)t->frames_left);
    else
        add(s, CANVAS_WHITE, "motion %s step %u/%u", name, (unsigned)t->step, (unsigned)t->step_count);
}

static void add_flight(struct panel *s, const struct inspect_entity *t)
{
    add(s, CANVAS_WHITE, "age    %u", (unsigned)t->age);
    add(s, CANVAS_WHITE, "speed  %.3f dir %.2f", t->speed / 65536.0, t->dir);
    add_motion(s, t);
    if (t->player)
        add(s, CANVAS_WHITE, "by     player %d", t->player);
}

static void add_health(struct panel *s, const struct inspect_entity *t)
{
    bool enemy = t->body.kind == INSPECT_ENEMY;
    if (enemy)
        add(s, CANVAS_WHITE, "age    %u", (unsigned)t->age);
    add(s, CANVAS_WHITE, enemy ? "hp     %d" : "lives  %d", (int)(enemy ? t->hp : t->lives));
    if (t->safe_left)
        add(s, CANVAS_WHITE, t->safe_left < 0 ? "safe   always" : "safe   %d", (int)t->safe_left);
}

static void describe(struct panel *s, const struct board *b, const struct inspect_entity *t)
{
    static const char *const kinds[] = { "", "bullet", "shot", "enemy", "player", "laser" };
    add(s, CANVAS_CYAN, "%s %u", kinds[t->body.kind], (unsigned)t->body.slot + (t->body.kind == INSPECT_PLAYER));
    add(s, CANVAS_WHITE, "kind   %s", t->name ? t->name : "?");
    if (t->tag)
        add(s, CANVAS_WHITE, "tag    %s", t->tag);
    add_place(s, t);
    if (t->body.kind == INSPECT_BULLET || t->body.kind == INSPECT_SHOT || t->body.kind == INSPECT_LASER)
        add_flight(s, t);
    else
        add_health(s, t);
    add_author(s, b, t->owner_task);
}

static bool on_panel(const struct layout *l, int x, int y)
{
    return overlaps(l, x, y, 1, 1);
}

/* Where the mouse points: ports hide their own pointer in fullscreen. */
static void draw_pointer(const struct canvas *canvas, int x, int y)
{
    enum { NEAR = 4, FAR = 6 };
    canvas_line(canvas, x - FAR, y, x - NEAR, y, CANVAS_WHITE);
    canvas_line(canvas, x + NEAR, y, x + FAR, y, CANVAS_WHITE);
    canvas_line(canvas, x, y - FAR, x, y - NEAR, CANVAS_WHITE);
    canvas_line(canvas, x, y + NEAR, x, y + FAR, CANVAS_WHITE);
}

/* The panel of what is under the mouse: over the picture beside it, else with the other panels. */
static void place_thing(struct layout *l, const struct overlay_place *at, const struct board *b, int x, int y)
{
    const int y0 = at->beside ? 0 : l->y0, y1 = at->beside ? at->picture->fb->h : l->y1;
    struct panel s = { .lines = 0 };
    struct inspect_entity t;

    if (x < 0 || y < y0 || y >= y1 || (!at->beside && on_panel(l, x, y)))
        return;
    draw_pointer(at->picture, x, y);
    if (!inspect_entity_at(b, x, y, MOUSE, &t))
        return;
    draw_shape(at->picture, &t.body, CANVAS_WHITE);
    describe(&s, b, &t);
    if (at->beside)
        place(l, at->beside, &s);
    else
        place_beside_mouse(l, at->picture, &s, x, y);
}

void overlay_draw(const struct overlay *o, const struct overlay_place *at, const struct board *b, int mouse_x,
                  int mouse_y)
{
    const struct canvas *panels = at->beside ? at->beside : at->picture;
    struct layout l = { .y0 = at->y0, .y1 = at->y1, .w = panels->fb->w, .y = at->y0 };

    if (o->on[OVERLAY_SHAPES])
        draw_shapes(at->picture, at->beside ? 0 : at->y0, at->beside ? at->picture->fb->h : at->y1, b);
    if (o->on[OVERLAY_GAUGES])
        place_gauges(&l, panels, b);
    if (o->on[OVERLAY_SPLIT])
        place_split(&l, panels, &o->split);
    if (o->on[OVERLAY_TASKS])
        place_tasks(&l, panels, b);
    if (o->on[OVERLAY_MIXER])
        place_mixer(&l, panels, &o->mixer, b);
    if (overlay_on(o))
        place_thing(&l, at, b, mouse_x, mouse_y);
}

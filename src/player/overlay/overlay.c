/*
 * overlay.c - draws the overlay (overlay.h).
 *
 * A panel consists of lines of text, each in one colour, some followed by a bar. Panels are laid out in rows from the
 * top left. The panel of the entity under the mouse is placed near the mouse, where no other panel is.
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
    LINE_SIZE = 72,      /* bytes of a panel's line */
    MAX_LINES = 48,      /* of a panel */
    BAR_W = 30,          /* px, for the time of a whole frame */
    LIMITER_BAR = 27,    /* px, for half of full scale, where the limiter starts */
    MAX_PANELS = 8,      /* whose rectangles are tracked */
    PADDING = 2,         /* px around a panel's text */
    GAP = 1,             /* px between panels */
    PICK_RADIUS = 6,     /* px between the mouse and the entity that it picks */
    MOUSE_DISTANCE = 10, /* px between the mouse and its panel */
    MAX_TASKS_SHOWN = 64
};

void overlay_toggle(struct overlay *o, uint32_t pressed)
{
    for (int i = 0; i < OVERLAYS; i++)
        o->on[i] ^= pressed >> (HOTKEY_HITBOXES + i) & 1;
}

bool overlay_is_visible(const struct overlay *o)
{
    for (int i = 0; i < OVERLAYS; i++)
        if (o->on[i])
            return true;
    return false;
}

/* ---- times ---- */

void overlay_add_time(struct overlay *o, int step)
{
    if (!o->on[OVERLAY_FRAME_TIMES])
        return;
    o->frame_times.current[step] += clock_lap(&o->frame_times.last_read);
}

static void after_phase(void *context, enum board_phase phase)
{
    overlay_add_time(context, (int)phase);
}

static void before_tick(void *context)
{
    overlay_add_time(context, STEP_PROGRAM);
}

void overlay_begin_frame(struct overlay *o, struct guard *g)
{
    bool on = o->on[OVERLAY_FRAME_TIMES];
    board_set_phase_callback(g->board, on ? after_phase : 0, o);
    g->before = on ? before_tick : 0;
    g->context = o;
    memset(o->frame_times.current, 0, sizeof o->frame_times.current);
    if (on)
        o->frame_times.last_read = plat_usec();
}

/* Computes the results of a complete window and starts the next one. */
static void finish_window(struct frame_times *s)
{
    s->shown_frame_mean = 0;
    for (int i = 0; i < STEPS; i++) {
        s->shown_mean[i] = (uint32_t)(s->sum[i] / FRAME_TIMES_WINDOW);
        s->shown_max[i] = (uint32_t)s->max[i];
        s->shown_frame_mean += s->shown_mean[i];
    }
    memset(s->sum, 0, sizeof s->sum);
    memset(s->max, 0, sizeof s->max);
    s->shown_frame_max = s->max_frame;
    s->max_frame = 0;
    s->frames = 0;
}

void overlay_end_frame(struct overlay *o)
{
    struct frame_times *s = &o->frame_times;
    uint64_t all = 0;
    if (!o->on[OVERLAY_FRAME_TIMES])
        return;
    for (int i = 0; i < STEPS; i++) {
        s->sum[i] += s->current[i];
        s->max[i] = s->current[i] > s->max[i] ? s->current[i] : s->max[i];
        all += s->current[i];
    }
    s->max_frame = all > s->max_frame ? (uint32_t)all : s->max_frame;
    if (++s->frames == FRAME_TIMES_WINDOW)
        finish_window(s);
}

/* ---- panels ---- */

struct panel {
    char text[MAX_LINES][LINE_SIZE];
    enum canvas_colour colour[MAX_LINES];
    int bar[MAX_LINES]; /* microseconds, or a level scaled to those of a whole frame; -1: no bar */
    bool is_level[MAX_LINES];
    int lines, columns;
    bool has_bars;
};

#ifdef __GNUC__
__attribute__((format(printf, 3, 4)))
#endif
static void
add_line(struct panel *s, enum canvas_colour c, const char *format, ...)
{
    va_list args;
    if (s->lines == MAX_LINES)
        return;
    va_start(args, format);
    vsnprintf(s->text[s->lines], LINE_SIZE, format, args);
    va_end(args);
    int columns = canvas_text_width(s->text[s->lines]) / CANVAS_CELL_W;
    s->columns = columns > s->columns ? columns : s->columns;
    s->bar[s->lines] = -1;
    s->is_level[s->lines] = false;
    s->colour[s->lines++] = c;
}

static void add_bar(struct panel *s, uint32_t usec)
{
    s->bar[s->lines - 1] = usec > INT32_MAX ? INT32_MAX : (int)usec;
    s->has_bars = true;
}

static int panel_w(const struct panel *s)
{
    return s->columns * CANVAS_CELL_W - 1 + 2 * PADDING + (s->has_bars ? PADDING + BAR_W : 0);
}

static int panel_h(int lines)
{
    return lines * CANVAS_CELL_H - 1 + 2 * PADDING;
}

static void draw_bar(const struct canvas *canvas, int x, int y, int usec, bool level)
{
    int w = usec >= FRAME_USEC ? BAR_W : usec * BAR_W / FRAME_USEC, high = level ? LIMITER_BAR : BAR_W / 2;
    canvas_rect(canvas, x, y + 4, BAR_W, 1, CANVAS_GREY);
    canvas_rect(canvas, x, y, usec && !w ? 1 : w, 5, w >= BAR_W ? CANVAS_RED : w > high ? CANVAS_YELLOW : CANVAS_GREEN);
}

static void draw_panel(const struct canvas *canvas, const struct panel *s, int x, int y, int lines)
{
    canvas_rect(canvas, x, y, panel_w(s), panel_h(lines), CANVAS_DARK);
    for (int i = 0; i < lines; i++) {
        int at = y + PADDING + i * CANVAS_CELL_H;
        bool cut = i == lines - 1 && lines < s->lines;
        canvas_text(canvas, x + PADDING, at, cut ? CANVAS_GREY : s->colour[i], cut ? "..." : s->text[i]);
        if (s->bar[i] >= 0 && !cut)
            draw_bar(canvas, x + panel_w(s) - PADDING - BAR_W, at, s->bar[i], s->is_level[i]);
    }
}

/* ---- layout ---- */

struct rect {
    int x, y, w, h;
};

struct layout {
    int y0, y1, w;   /* the area available for panels */
    int x, y, row_h; /* the position of the next panel, and the height of its row so far */
    struct rect used[MAX_PANELS];
    int n;
};

static void mark_used(struct layout *l, int x, int y, int w, int h)
{
    if (l->n < MAX_PANELS)
        l->used[l->n++] = (struct rect){ x, y, w, h };
}

/* Draws a panel to the right of the previous one, or in a new row if it is too wide. Leaves out lines that don't fit.
 * */
static void add_panel(struct layout *l, const struct canvas *canvas, const struct panel *s)
{
    int lines = s->lines, w = panel_w(s);
    if (l->x > 0 && l->x + w > l->w) {
        l->x = 0;
        l->y += l->row_h + GAP;
        l->row_h = 0;
    }
    while (lines > 0 && l->y + panel_h(lines) > l->y1)
        lines--;
    if (!lines)
        return;
    draw_panel(canvas, s, l->x, l->y, lines);
    mark_used(l, l->x, l->y, w, panel_h(lines));
    l->x += w + GAP;
    l->row_h = panel_h(lines) > l->row_h ? panel_h(lines) : l->row_h;
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

/* If the rectangle (x, y, w, h) is free and nearer to the mouse than *nearest, stores it in *best and its distance in
 * *nearest. */
static void try_position(const struct layout *l, int x, int y, int w, int h, int mouse_x, int mouse_y,
                         struct rect *best, int *nearest)
{
    int dx = mouse_x < x ? x - mouse_x : mouse_x >= x + w ? mouse_x - x - w + 1 : 0;
    int dy = mouse_y < y ? y - mouse_y : mouse_y >= y + h ? mouse_y - y - h + 1 : 0;
    int distance = dx > dy ? dx : dy;
    if (x < 0 || y < l->y0 || x + w > l->w || y + h > l->y1 || distance < MOUSE_DISTANCE || distance >= *nearest ||
        overlaps(l, x, y, w, h))
        return;
    *best = (struct rect){ x, y, w, h };
    *nearest = distance;
}

/* Draws a panel at the free position nearest to the mouse, or at the bottom right if there is none. */
static void add_panel_near_mouse(struct layout *l, const struct canvas *canvas, const struct panel *s, int mouse_x,
                                 int mouse_y)
{
    int w = panel_w(s), h = panel_h(s->lines), nearest = INT32_MAX;
    struct rect best = { l->w - w, l->y1 - h, w, h };
    try_position(l, mouse_x + MOUSE_DISTANCE, mouse_y + MOUSE_DISTANCE, w, h, mouse_x, mouse_y, &best, &nearest);
    try_position(l, mouse_x - MOUSE_DISTANCE - w + 1, mouse_y + MOUSE_DISTANCE, w, h, mouse_x, mouse_y, &best,
                 &nearest);
    for (int y = l->y0; y + h <= l->y1; y += 4)
        for (int x = 0; x + w <= l->w; x += 4)
            try_position(l, x, y, w, h, mouse_x, mouse_y, &best, &nearest);
    draw_panel(canvas, s, best.x, best.y, s->lines);
    canvas_outline(canvas, best.x, best.y, w, h, CANVAS_GREY);
}

/* ---- hitboxes ---- */

static void draw_shape(const struct canvas *canvas, const struct inspect_body *s, enum canvas_colour c)
{
    if (s->shape == INSPECT_CIRCLE)
        canvas_circle(canvas, s->x, s->y, s->a, c);
    else if (s->shape == INSPECT_BOX)
        canvas_box(canvas, s->x, s->y, s->a, s->b, c);
    else if (s->shape == INSPECT_CIRCLES)
        for (int i = 0; i < s->n; i++)
            canvas_circle(canvas, s->circle[i].x, s->circle[i].y, s->circle[i].r, c);
    else if (s->shape == INSPECT_CAPSULE)
        canvas_capsule(canvas, s->x, s->y, s->b, s->c, s->a, c);
    else
        canvas_box(canvas, s->x, s->y, 0, 0, c);
}

static enum canvas_colour hitbox_colour(const struct inspect_body *s)
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

/* A dark outline makes a hitbox visible on any background. */
static void draw_dark_outline(void *context, const struct inspect_body *s)
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
        canvas_circle(context, s->x, s->y, s->graze + WIDER, CANVAS_DARK);
}

static void draw_hitbox(void *context, const struct inspect_body *s)
{
    const struct canvas *canvas = context;
    if (s->graze)
        canvas_circle(canvas, s->x, s->y, s->graze, CANVAS_WHITE);
    draw_shape(canvas, s, hitbox_colour(s));
}

/* Clips hitboxes to the field, like the entities. */
static void draw_hitboxes(const struct canvas *canvas, int y0, int y1, const struct board *b)
{
    struct inspect_area f = inspect_field(b);
    struct canvas on_field = *canvas;
    int top = f.y > y0 ? f.y : y0, bottom = f.y + f.h < y1 ? f.y + f.h : y1;
    fb_set_clip(canvas->fb, f.x, top, f.w, bottom - top);
    inspect_bodies(b, draw_dark_outline, &on_field);
    inspect_bodies(b, draw_hitbox, &on_field);
    fb_reset_clip(canvas->fb);
}

/* The white disc is the exact hitbox. The two rings around it make it visible on a white ship and on bullets. */
static void draw_ship_hitbox(const struct canvas *canvas, const struct inspect_body *s, enum canvas_colour ring)
{
    enum { PIXEL = 1 << 16 };

    canvas_disc(canvas, s->x, s->y, s->a + 2 * PIXEL, CANVAS_DARK);
    canvas_disc(canvas, s->x, s->y, s->a + PIXEL, ring);
    canvas_disc(canvas, s->x, s->y, s->a, CANVAS_WHITE);
}

void overlay_draw_hitboxes(const struct canvas *canvas, const struct board *b)
{
    static const enum canvas_colour rings[MAX_PLAYERS] = { CANVAS_RED, CANVAS_CYAN };
    const struct inspect_area f = inspect_field(b);
    struct inspect_body body;

    fb_set_clip(canvas->fb, f.x, f.y, f.w, f.h);
    for (int i = 0; i < MAX_PLAYERS; i++)
        if (inspect_ship(b, i, &body))
            draw_ship_hitbox(canvas, &body, rings[i]);
    fb_reset_clip(canvas->fb);
}

/* ---- panels ---- */

static void add_gauge(struct panel *s, const char *name, uint32_t live, uint32_t top, uint32_t cap, uint32_t refused)
{
    enum canvas_colour c = refused                                   ? CANVAS_RED
                           : (uint64_t)live * 10 > (uint64_t)cap * 9 ? CANVAS_YELLOW
                                                                     : CANVAS_WHITE;
    add_line(s, live ? c : CANVAS_GREY, "%-12s %5u %5u %5u %7u", name, (unsigned)live, (unsigned)top, (unsigned)cap,
             (unsigned)refused);
}

static void add_gauges_panel(struct layout *l, const struct canvas *canvas, const struct board *b)
{
    struct panel s = { .lines = 0 };
    struct inspect_gauge g[MAX_PARTS];
    size_t used, size;
    int n = inspect_gauges(b, g);
    add_line(&s, CANVAS_CYAN, "%-12s %5s %5s %5s %7s", "part", "live", "top", "cap", "refused");
    for (int i = 0; i < n; i++)
        if (!g[i].is_fixed)
            add_gauge(&s, g[i].name, g[i].live, g[i].top, g[i].cap, g[i].refused);
    inspect_memory(b, &used, &size);
    add_line(&s, used * 10 > size * 9 ? CANVAS_YELLOW : CANVAS_WHITE, "%-12s %5u %5s %5u", "Lua KiB",
             (unsigned)(used / 1024), "", (unsigned)(size / 1024));
    add_panel(l, canvas, &s);
}

static void add_frame_times_panel(struct layout *l, const struct canvas *canvas, const struct frame_times *t)
{
    static const char *const names[STEPS] = {
        "scripts", "motion", "hits", "events", "rest", "program", "draw", "show"
    };
    struct panel s = { .lines = 0 };
    add_line(&s, CANVAS_CYAN, "%-7s %5s %5s", "usec", "mean", "most");
    for (int i = 0; i < STEPS; i++) {
        add_line(&s, CANVAS_WHITE, "%-7s %5u %5u", names[i], (unsigned)t->shown_mean[i], (unsigned)t->shown_max[i]);
        add_bar(&s, t->shown_mean[i]);
    }
    add_line(&s, CANVAS_CYAN, "%-7s %5u %5u", "frame", (unsigned)t->shown_frame_mean, (unsigned)t->shown_frame_max);
    add_bar(&s, t->shown_frame_mean);
    add_panel(l, canvas, &s);
}

static const char *task_state(const struct inspect_task *t, char *buf, size_t size)
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

static const char *task_owner(const struct inspect_task *t, char *buf, size_t size)
{
    static const char *const names[] = { "", "bullet", "shot", "enemy", "player", "sprite", "task", "laser", "option" };
    snprintf(buf, size, t->owner == OWNER_BOARD ? "-" : "%s %u", names[t->owner], (unsigned)t->owner_number);
    return buf;
}

static void add_tasks_panel(struct layout *l, const struct canvas *canvas, const struct board *b)
{
    struct panel s = { .lines = 0 };
    struct inspect_task t[MAX_TASKS_SHOWN];
    char state[16], owner[24];
    uint32_t n = inspect_tasks(b, 0, t, MAX_TASKS_SHOWN), listed = n < MAX_TASKS_SHOWN ? n : MAX_TASKS_SHOWN;
    add_line(&s, CANVAS_CYAN, "frame %u  random numbers %llu  tasks %u", (unsigned)board_frame(b),
             (unsigned long long)inspect_random_draws(b), (unsigned)n);
    add_line(&s, CANVAS_CYAN, "%6s %5s %-11s %s", "task", "wait", "owner", "line");
    for (uint32_t i = 0; i < listed; i++)
        add_line(&s, t[i].is_scope ? CANVAS_GREY : CANVAS_WHITE, "%6u %5s %-11s %s", (unsigned)t[i].serial,
                 task_state(&t[i], state, sizeof state), task_owner(&t[i], owner, sizeof owner), t[i].location);
    add_panel(l, canvas, &s);
}

/* ---- the mixer ---- */

static int decay(int before, int level)
{
    return int_max(level, before * 7 / 8);
}

void overlay_update_mixer(struct overlay *o, const struct board *b, const struct speaker *speaker)
{
    struct mixer *m = &o->mixer;

    m->speaker = speaker;
    if (!o->on[OVERLAY_MIXER] || !speaker->tables)
        return;
    for (int i = 0; i < VOICES; i++)
        m->voice[i] = decay(m->voice[i], inspect_voice_peak(b, i, speaker->tables));
    for (int c = 0; c < 2; c++)
        m->out[c] = decay(m->out[c], speaker->peak[c]);
}

static double decibels(int level)
{
    return level > 0 ? 20 * log10(level / 32768.0) : -99.9;
}

/* Adds a bar that covers 60 decibels. */
static void add_level_bar(struct panel *s, int level)
{
    const double full = 1 + decibels(level) / 60;

    add_bar(s, full <= 0 ? 0 : (uint32_t)(full * FRAME_USEC));
    s->is_level[s->lines - 1] = true;
}

static void add_music_position(struct panel *s, const struct board *b)
{
    struct inspect_music m;

    inspect_music(b, &m);
    if (!m.name[0]) {
        add_line(s, CANVAS_GREY, "no music");
        return;
    }
    add_line(s, CANVAS_WHITE, "%.20s%s%.14s", m.name, m.next[0] ? ", then " : "", m.next);
    add_line(s, CANVAS_WHITE, "bar %u  beat %d of %d  tempo %u.%02u  gain %d%%%s", (unsigned)m.bar, m.beat,
             m.beats_per_bar, (unsigned)m.tempo / 100, (unsigned)m.tempo % 100, m.gain, m.is_paused ? "  held" : "");
    if (m.mark[0])
        add_line(s, CANVAS_WHITE, "marker \"%.31s\"", m.mark);
}

static void add_speaker(struct panel *s, const struct speaker *p)
{
    if (p->muted)
        add_line(s, CANVAS_YELLOW, "muted");
    else if (p->state == SPEAKER_MISSING)
        add_line(s, CANVAS_RED, "no sound device");
    else if (p->state == SPEAKER_UNUSED || !p->stats.measurements)
        add_line(s, CANVAS_GREY, "no sound yet");
    else
        add_line(s, p->stats.underruns ? CANVAS_YELLOW : CANVAS_WHITE, "volume %d%%  latency %.1f ms  gaps %u",
                 p->volume, (double)p->stats.queued_sum / (double)p->stats.measurements * 1000 / SPEAKER_RATE,
                 (unsigned)p->stats.underruns);
}

static void add_voice(struct panel *s, int i, const struct board *b, int level)
{
    static const char *const notes[] = { "c", "c+", "d", "d+", "e", "f", "f+", "g", "g+", "a", "a+", "b" };
    struct inspect_voice v;

    inspect_voice(b, i, &v);
    const int semitone = (v.pitch + 32768) >> 16;
    if (v.is_busy)
        add_line(s, v.is_ending ? CANVAS_GREY : CANVAS_WHITE, "%c%-2d  %-16.16s %-6s o%d%-2s  %4d",
                 v.is_music ? 'm' : 's', v.is_music ? i + 1 : i + 1 - VOICES_MUSIC, v.source, v.instrument_kind,
                 semitone / 12 - 1, notes[semitone % 12], v.pan);
    else
        add_line(s, CANVAS_GREY, "%c%d", v.is_music ? 'm' : 's', v.is_music ? i + 1 : i + 1 - VOICES_MUSIC);
    add_level_bar(s, level);
}

static void add_mixer_panel(struct layout *l, const struct canvas *canvas, const struct mixer *m, const struct board *b)
{
    struct panel s = { .lines = 0 };

    if (!board_has_sound(b)) {
        add_line(&s, CANVAS_GREY, "this game has no sound");
        add_panel(l, canvas, &s);
        return;
    }
    add_music_position(&s, b);
    add_speaker(&s, m->speaker);
    for (int c = 0; c < 2; c++) {
        add_line(&s, CANVAS_CYAN, "%s %6.1f dB", c ? "right" : "left ", decibels(m->out[c]));
        add_level_bar(&s, m->out[c]);
    }
    add_line(&s, CANVAS_CYAN, "%-3s  %-16s %-6s %-4s  %4s", "", "sound", "wave", "note", "pan");
    for (int i = 0; i < VOICES; i++)
        add_voice(&s, i, b, m->voice[i]);
    add_panel(l, canvas, &s);
}

/* ---- the entity under the mouse ---- */

static void add_position(struct panel *s, const struct inspect_entity *t)
{
    add_line(s, CANVAS_WHITE, "at     %.2f, %.2f", t->x / 65536.0, t->y / 65536.0);
}

static void add_owner(struct panel *s, const struct board *b, uint32_t serial)
{
    struct inspect_task task;
    if (!serial)
        return;
    if (inspect_task(b, serial, &task))
        add_line(s, CANVAS_WHITE, "by     task %u %s", (unsigned)serial, task.location);
    else
        add_line(s, CANVAS_WHITE, "by     task %u, ended", (unsigned)serial);
}

static void add_motion(struct panel *s, const struct inspect_entity *t)
{
    char name[40];
    if (!t->has_motion)
        return;
    snprintf(name, sizeof name, t->motion ? "%s" : "number %s%u", t->motion ? t->motion : "", (unsigned)t->program);
    if (t->step > t->step_count)
        add_line(s, CANVAS_WHITE, "motion %s, ended", name);
    else if (t->frames_left)
        add_line(s, CANVAS_WHITE, "motion %s step %u/%u, %u left", name, (unsigned)t->step, (unsigned)t->step_count,
                 (unsigned)t->frames_left);
    else
        add_line(s, CANVAS_WHITE, "motion %s step %u/%u", name, (unsigned)t->step, (unsigned)t->step_count);
}

static void add_flight(struct panel *s, const struct inspect_entity *t)
{
    add_line(s, CANVAS_WHITE, "age    %u", (unsigned)t->age);
    add_line(s, CANVAS_WHITE, "speed  %.3f dir %.2f", t->speed / 65536.0, t->dir);
    add_motion(s, t);
    if (t->player)
        add_line(s, CANVAS_WHITE, "by     player %d", t->player);
}

static void add_health(struct panel *s, const struct inspect_entity *t)
{
    bool enemy = t->body.kind == INSPECT_ENEMY;
    if (enemy)
        add_line(s, CANVAS_WHITE, "age    %u", (unsigned)t->age);
    add_line(s, CANVAS_WHITE, enemy ? "hp     %d" : "lives  %d", (int)(enemy ? t->hp : t->lives));
    if (t->safe_left)
        add_line(s, CANVAS_WHITE, t->safe_left < 0 ? "safe   always" : "safe   %d", (int)t->safe_left);
}

static void describe(struct panel *s, const struct board *b, const struct inspect_entity *t)
{
    static const char *const kinds[] = { "", "bullet", "shot", "enemy", "player", "laser" };
    add_line(s, CANVAS_CYAN, "%s %u", kinds[t->body.kind], (unsigned)t->body.slot + (t->body.kind == INSPECT_PLAYER));
    add_line(s, CANVAS_WHITE, "kind   %s", t->name ? t->name : "?");
    if (t->tag)
        add_line(s, CANVAS_WHITE, "tag    %s", t->tag);
    add_position(s, t);
    if (t->body.kind == INSPECT_BULLET || t->body.kind == INSPECT_SHOT || t->body.kind == INSPECT_LASER)
        add_flight(s, t);
    else
        add_health(s, t);
    add_owner(s, b, t->owner_task);
}

/* Ports hide the system's pointer in fullscreen. */
static void draw_pointer(const struct canvas *canvas, int x, int y)
{
    enum { NEAR = 4, FAR = 6 };
    canvas_line(canvas, x - FAR, y, x - NEAR, y, CANVAS_WHITE);
    canvas_line(canvas, x + NEAR, y, x + FAR, y, CANVAS_WHITE);
    canvas_line(canvas, x, y - FAR, x, y - NEAR, CANVAS_WHITE);
    canvas_line(canvas, x, y + NEAR, x, y + FAR, CANVAS_WHITE);
}

/* Draws the panel of the entity under the mouse: among the other panels at the side, or else near the mouse. */
static void add_entity_panel(struct layout *l, const struct overlay_target *target, const struct board *b, int x, int y)
{
    const int y0 = target->side ? 0 : l->y0, y1 = target->side ? target->picture->fb->h : l->y1;
    struct panel s = { .lines = 0 };
    struct inspect_entity t;

    if (x < 0 || y < y0 || y >= y1 || (!target->side && overlaps(l, x, y, 1, 1)))
        return;
    draw_pointer(target->picture, x, y);
    if (!inspect_entity_at(b, x, y, PICK_RADIUS, &t))
        return;
    draw_shape(target->picture, &t.body, CANVAS_WHITE);
    describe(&s, b, &t);
    if (target->side)
        add_panel(l, target->side, &s);
    else
        add_panel_near_mouse(l, target->picture, &s, x, y);
}

void overlay_draw(const struct overlay *o, const struct overlay_target *target, const struct board *b, int mouse_x,
                  int mouse_y)
{
    const struct canvas *panels = target->side ? target->side : target->picture;
    struct layout l = { .y0 = target->y0, .y1 = target->y1, .w = panels->fb->w, .y = target->y0 };

    if (o->on[OVERLAY_HITBOXES])
        draw_hitboxes(target->picture, target->side ? 0 : target->y0,
                      target->side ? target->picture->fb->h : target->y1, b);
    if (o->on[OVERLAY_GAUGES])
        add_gauges_panel(&l, panels, b);
    if (o->on[OVERLAY_FRAME_TIMES])
        add_frame_times_panel(&l, panels, &o->frame_times);
    if (o->on[OVERLAY_TASKS])
        add_tasks_panel(&l, panels, b);
    if (o->on[OVERLAY_MIXER])
        add_mixer_panel(&l, panels, &o->mixer, b);
    if (overlay_is_visible(o))
        add_entity_panel(&l, target, b, mouse_x, mouse_y);
}

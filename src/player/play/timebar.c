/*
 * timebar.c - draws the time bar, and finds frames and markers on it (timebar.h).
 */
#include "timebar.h"

#include <stdio.h>
#include <string.h>

enum { MARGIN = 2, BAR_H = 5, SECOND = 60, RECENT = 30 };

static const enum canvas_colour colours[MARKER_KINDS] = {
    [MARKER_STAGE] = CANVAS_WHITE, [MARKER_MARK] = CANVAS_CYAN,    [MARKER_WAVE] = CANVAS_GREY,
    [MARKER_BOSS] = CANVAS_RED,    [MARKER_PHASE] = CANVAS_YELLOW, [MARKER_DEATH] = CANVAS_MAGENTA,
    [MARKER_GAME] = CANVAS_WHITE,  [MARKER_OVER] = CANVAS_MAGENTA,
};

/* Returns the pixel of a frame on a bar of w pixels. */
static int frame_x(const struct session *s, int w, uint32_t frame)
{
    uint32_t first = session_first(s), last = session_last(s);
    uint32_t at = frame < first ? 0 : frame > last ? last - first : frame - first;

    return last > first ? (int)((uint64_t)at * (uint64_t)(w - 1) / (last - first)) : 0;
}

bool timebar_frame_at(const struct session *s, int w, int h, int x, int y, uint32_t *frame)
{
    uint32_t first = session_first(s), last = session_last(s);
    int most = w - 2 * MARGIN - 1;

    if (y < h - TIMEBAR_H || y >= h || x < 0 || x >= w || most < 1)
        return false;
    x = x < MARGIN ? 0 : x - MARGIN > most ? most : x - MARGIN;
    *frame = first + (uint32_t)((uint64_t)x * (last - first) / (uint64_t)most);
    return true;
}

/* ---- markers ---- */

/* Returns whether the keys jump to this marker. Excludes waves, ends and attempts of sections, and rows of scores. */
static bool is_target(const struct session *s, const struct demo_marker *m)
{
    enum board_marker_kind kind = m->marker.kind;
    bool section = kind <= MARKER_DEATH && kind != MARKER_WAVE;

    return (section || kind == MARKER_GAME || kind == MARKER_OVER) && m->frame >= session_first(s) &&
           m->frame <= session_last(s);
}

uint32_t timebar_previous(const struct session *s, uint32_t frame)
{
    uint32_t n, best = session_first(s);
    const struct demo_marker *m = session_markers(s, &n);

    for (uint32_t i = 0; i < n; i++)
        if (is_target(s, &m[i]) && m[i].frame + RECENT <= frame && m[i].frame > best)
            best = m[i].frame;
    return best;
}

uint32_t timebar_next(const struct session *s, uint32_t frame)
{
    uint32_t n, best = session_last(s);
    const struct demo_marker *m = session_markers(s, &n);

    for (uint32_t i = 0; i < n; i++)
        if (is_target(s, &m[i]) && m[i].frame > frame && m[i].frame < best)
            best = m[i].frame;
    return best;
}

/* Returns the last marker of a kind up to a frame, or NULL. after: only markers after this one; NULL: all. */
static const struct demo_marker *last_of(const struct session *s, uint32_t frame, enum board_marker_kind kind,
                                         const struct demo_marker *after)
{
    uint32_t n;
    const struct demo_marker *m = session_markers(s, &n), *found = NULL;

    for (uint32_t i = 0; i < n && m[i].frame <= frame; i++)
        if (m[i].marker.kind == kind && (!after || &m[i] > after))
            found = &m[i];
    return found;
}

/* Writes the position in the current game: "stage:mark boss/phase", or those parts of it that exist. */
static void position_text(const struct session *s, uint32_t frame, char *text, size_t size)
{
    const struct demo_marker *over = last_of(s, frame, MARKER_OVER, NULL);
    const struct demo_marker *stage = last_of(s, frame, MARKER_STAGE, over), *from = stage ? stage : over;
    const struct demo_marker *point = last_of(s, frame, MARKER_MARK, from);
    const struct demo_marker *boss = last_of(s, frame, MARKER_BOSS, from);
    const struct demo_marker *phase = boss ? last_of(s, frame, MARKER_PHASE, boss) : NULL;

    snprintf(text, size, "%s%s%s%s%s%s%s", stage ? stage->marker.name : "", point ? ":" : "",
             point ? point->marker.name : "", boss ? " " : "", boss ? boss->marker.name : "", phase ? "/" : "",
             phase ? phase->marker.name : "");
}

/* ---- drawing ---- */

static void draw_markers(const struct canvas *canvas, const struct session *s, int y, int w)
{
    uint32_t n;
    const struct demo_marker *m = session_markers(s, &n);

    for (int pass = 0; pass < 2; pass++) /* waves first, so that they are covered by the others */
        for (uint32_t i = 0; i < n; i++) {
            bool wave = m[i].marker.kind == MARKER_WAVE;
            if (wave == (pass == 0) && (wave || is_target(s, &m[i])))
                canvas_rect(canvas, MARGIN + frame_x(s, w, m[i].frame), y + (wave ? 2 : 0), 1, wave ? 1 : BAR_H,
                            colours[m[i].marker.kind]);
        }
}

void timebar_draw(const struct canvas *canvas, const struct session *s)
{
    int w = canvas->fb->w - 2 * MARGIN, top = canvas->fb->h - TIMEBAR_H, bar = canvas->fb->h - BAR_H - MARGIN;
    const unsigned frame = board_frame(session_board(s)), last = session_last(s), second = frame / SECOND;
    char text[160], where[128];

    if (canvas->spare) { /* for players */
        snprintf(text, sizeof text, "%u:%02u / %u:%02u", second / 60, second % 60, last / SECOND / 60,
                 last / SECOND % 60);
    } else {
        position_text(s, frame, where, sizeof where);
        snprintf(text, sizeof text, "%u/%u %u:%02u %s", frame, last, second / 60, second % 60, where);
    }
    canvas_rect(canvas, 0, top, canvas->fb->w, TIMEBAR_H, CANVAS_DARK);
    canvas_text(canvas, MARGIN, top + 1, CANVAS_WHITE, text);
    canvas_rect(canvas, MARGIN, bar + 2, w, 1, CANVAS_GREY);
    canvas_rect(canvas, MARGIN, bar + 1, frame_x(s, w, frame) + 1, 3, CANVAS_GREEN);
    if (s->differs && s->differs <= frame)
        canvas_rect(canvas, MARGIN + frame_x(s, w, s->differs), bar + 1,
                    frame_x(s, w, frame) - frame_x(s, w, s->differs) + 1, 3, CANVAS_RED);
    draw_markers(canvas, s, bar, w);
    canvas_rect(canvas, MARGIN + frame_x(s, w, frame), bar - 1, 1, BAR_H + 2, CANVAS_GREEN);
}

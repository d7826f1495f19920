/*
 * markers.c - compares markers (markers.h). Sorts both lists by kind, name and frame, and merges them, because a demo
 * may have millions of markers.
 */
#include "markers.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int by_name(const struct demo_marker *a, const struct demo_marker *b)
{
    if (a->marker.kind != b->marker.kind)
        return a->marker.kind < b->marker.kind ? -1 : 1;
    return strcmp(a->marker.name, b->marker.name);
}

/* Orders by kind and name, then by position in the demo. */
static int by_name_and_order(const void *left, const void *right)
{
    const struct demo_marker *a = *(const struct demo_marker *const *)left;
    const struct demo_marker *b = *(const struct demo_marker *const *)right;
    int order = by_name(a, b);

    return order ? order : (a > b) - (a < b);
}

/* Returns pointers to the markers of a run, sorted by kind and name, or NULL when out of memory. */
static const struct demo_marker **sorted(const struct demo *d, uint32_t *n)
{
    const struct demo_marker **list = malloc(((size_t)d->n_markers + 1) * sizeof *list);

    *n = 0;
    for (uint32_t i = 0; list && i < d->n_markers; i++)
        if (board_marks_run(d->markers[i].marker.kind))
            list[(*n)++] = &d->markers[i];
    if (list)
        qsort(list, *n, sizeof *list, by_name_and_order);
    return list;
}

static uint32_t frame_of(const struct marker_change *c)
{
    return c->was ? c->was->frame : c->is->frame;
}

static int by_frame(const void *left, const void *right)
{
    const struct marker_change *a = left, *b = right;
    uint32_t f = frame_of(a), g = frame_of(b);

    if (f != g)
        return f < g ? -1 : 1;
    int order = by_name(a->was ? a->was : a->is, b->was ? b->was : b->is);
    return order ? order : (a->was == NULL) - (b->was == NULL);
}

static void walk(struct marker_changes *c, const struct demo_marker **was, uint32_t n, const struct demo_marker **is,
                 uint32_t m)
{
    for (uint32_t i = 0, k = 0; i < n || k < m;) {
        int order = i == n ? 1 : k == m ? -1 : by_name(was[i], is[k]);
        struct marker_change change = { order <= 0 ? was[i++] : NULL, order >= 0 ? is[k++] : NULL };
        if (!change.was || !change.is || change.was->frame != change.is->frame)
            c->list[c->n++] = change;
    }
    qsort(c->list, c->n, sizeof *c->list, by_frame);
}

bool markers_compare(struct marker_changes *c, const struct demo *was, const struct demo *is)
{
    uint32_t n = 0, m = 0;
    const struct demo_marker **a = sorted(was, &n), **b = sorted(is, &m);

    c->n = 0;
    c->list = malloc(((size_t)n + m + 1) * sizeof *c->list);
    bool ok = a && b && c->list;
    if (ok)
        walk(c, a, n, b, m);
    free(a);
    free(b);
    return ok;
}

void markers_text(const struct marker_change *c, char *out, size_t size)
{
    static const char *const kinds[MARKER_KINDS] = {
        [MARKER_STAGE] = "stage",      [MARKER_MARK] = "mark",        [MARKER_WAVE] = "wave",
        [MARKER_BOSS] = "boss",        [MARKER_PHASE] = "phase",      [MARKER_DEATH] = "death of player",
        [MARKER_CLEAR] = "end of",     [MARKER_WON] = "phase beaten", [MARKER_LOST] = "phase not beaten",
        [MARKER_START] = "start",      [MARKER_GAME] = "game",        [MARKER_OVER] = "end of game:",
        [MARKER_ROW] = "row in table",
    };
    const struct board_marker *m = &(c->was ? c->was : c->is)->marker;
    char was[16] = "never", is[16] = "never";

    if (c->was)
        snprintf(was, sizeof was, "%u", (unsigned)c->was->frame);
    if (c->is)
        snprintf(is, sizeof is, "%u", (unsigned)c->is->frame);
    snprintf(out, size, "%s%s%s %s -> %s", kinds[m->kind], m->name[0] ? " " : "", m->name, was, is);
}

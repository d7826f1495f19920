/*
 * markers.c - compares markers (markers.h). Sorts both lists by kind, name and frame, and merges them, because a demo
 * may have millions of markers.
 */
#include "markers.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int compare_kind_and_name(const struct demo_marker *a, const struct demo_marker *b)
{
    if (a->marker.kind != b->marker.kind)
        return a->marker.kind < b->marker.kind ? -1 : 1;
    return strcmp(a->marker.name, b->marker.name);
}

/* Orders by kind and name, then by position in the demo. */
static int compare_kind_name_and_order(const void *left, const void *right)
{
    const struct demo_marker *a = *(const struct demo_marker *const *)left;
    const struct demo_marker *b = *(const struct demo_marker *const *)right;
    int order = compare_kind_and_name(a, b);

    return order ? order : (a > b) - (a < b);
}

/* Returns pointers to the markers of a run, sorted by kind and name, or NULL when out of memory. */
static const struct demo_marker **sort_markers(const struct demo *d, uint32_t *n)
{
    const struct demo_marker **list = malloc(((size_t)d->n_markers + 1) * sizeof *list);

    *n = 0;
    for (uint32_t i = 0; list && i < d->n_markers; i++)
        if (board_is_run_marker(d->markers[i].marker.kind))
            list[(*n)++] = &d->markers[i];
    if (list)
        qsort(list, *n, sizeof *list, compare_kind_name_and_order);
    return list;
}

static uint32_t get_change_frame(const struct marker_change *c)
{
    return c->before ? c->before->frame : c->after->frame;
}

static int compare_frames(const void *left, const void *right)
{
    const struct marker_change *a = left, *b = right;
    uint32_t f = get_change_frame(a), g = get_change_frame(b);

    if (f != g)
        return f < g ? -1 : 1;
    int order = compare_kind_and_name(a->before ? a->before : a->after, b->before ? b->before : b->after);
    return order ? order : (a->before == NULL) - (b->before == NULL);
}

static void merge_markers(struct marker_changes *c, const struct demo_marker **before, uint32_t n,
                          const struct demo_marker **after, uint32_t m)
{
    for (uint32_t i = 0, k = 0; i < n || k < m;) {
        int order = i == n ? 1 : k == m ? -1 : compare_kind_and_name(before[i], after[k]);
        struct marker_change change = { order <= 0 ? before[i++] : NULL, order >= 0 ? after[k++] : NULL };
        if (!change.before || !change.after || change.before->frame != change.after->frame)
            c->list[c->n++] = change;
    }
    qsort(c->list, c->n, sizeof *c->list, compare_frames);
}

bool markers_compare(struct marker_changes *c, const struct demo *before, const struct demo *after)
{
    uint32_t n = 0, m = 0;
    const struct demo_marker **a = sort_markers(before, &n), **b = sort_markers(after, &m);

    c->n = 0;
    c->list = malloc(((size_t)n + m + 1) * sizeof *c->list);
    bool ok = a && b && c->list;
    if (ok)
        merge_markers(c, a, n, b, m);
    free(a);
    free(b);
    return ok;
}

const char *markers_kind_name(enum board_marker_kind kind)
{
    static const char *const names[MARKER_KINDS] = {
        [MARKER_STAGE] = "stage",     [MARKER_MARK] = "mark",
        [MARKER_WAVE] = "wave",       [MARKER_BOSS] = "boss",
        [MARKER_PHASE] = "phase",     [MARKER_DEATH] = "death",
        [MARKER_CLEAR] = "clear",     [MARKER_WON] = "won",
        [MARKER_LOST] = "lost",       [MARKER_START] = "start",
        [MARKER_GAME] = "game",       [MARKER_OVER] = "over",
        [MARKER_ROW] = "row",         [MARKER_DIFFICULTY] = "difficulty",
        [MARKER_MISSION] = "mission",
    };

    return names[kind];
}

void markers_format_change(const struct marker_change *c, char *out, size_t size)
{
    static const char *const kinds[MARKER_KINDS] = {
        [MARKER_STAGE] = "stage",
        [MARKER_MARK] = "mark",
        [MARKER_WAVE] = "wave",
        [MARKER_BOSS] = "boss",
        [MARKER_PHASE] = "phase",
        [MARKER_DEATH] = "death of player",
        [MARKER_CLEAR] = "end of",
        [MARKER_WON] = "phase beaten",
        [MARKER_LOST] = "phase not beaten",
        [MARKER_START] = "start",
        [MARKER_GAME] = "game",
        [MARKER_OVER] = "end of game:",
        [MARKER_ROW] = "row in table",
        [MARKER_DIFFICULTY] = "difficulty",
        [MARKER_MISSION] = "mission",
    };
    const struct board_marker *m = &(c->before ? c->before : c->after)->marker;
    char before[16] = "never", after[16] = "never";

    if (c->before)
        snprintf(before, sizeof before, "%u", (unsigned)c->before->frame);
    if (c->after)
        snprintf(after, sizeof after, "%u", (unsigned)c->after->frame);
    snprintf(out, size, "%s%s%s %s -> %s", kinds[m->kind], m->name[0] ? " " : "", m->name, before, after);
}

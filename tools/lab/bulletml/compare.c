/*
 * compare.c - see compare.h.
 */
#include "compare.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The numbers of those that leave. */
struct leaving {
    int32_t *id;
    int32_t n, room;
};

static bool beyond(const struct side_bullet *b)
{
    /* what is no number is far away as well */
    return !(fabs(b->x) <= COMPARE_X && fabs(b->y) <= COMPARE_Y);
}

static bool add_leaving(struct leaving *l, int32_t id)
{
    if (l->n == l->room) {
        l->room = l->room ? 2 * l->room : 1024;
        l->id = realloc(l->id, (size_t)l->room * sizeof *l->id);
    }
    if (l->id)
        l->id[l->n++] = id;
    return l->id;
}

static void only_on(struct compared *out, const struct side_bullet *b, const char *side, int32_t f)
{
    out->alone = true;
    snprintf(out->what, sizeof out->what, "frame %d: only the %s run has bullet %d, at %.3f, %.3f", f, side, b->id,
             b->x, b->y);
}

static void match(struct compared *out, const struct side_bullet *a, const struct side_bullet *b, int32_t f)
{
    const double off = hypot(a->x - b->x, a->y - b->y);

    out->places++;
    if (!(off <= out->greatest)) {
        out->greatest = off;
        out->at_frame = f;
        out->at_bullet = a->id;
    }
}

/* One frame of both; false: it was the last that makes sense. */
static bool match_all(struct compared *out, const struct side_bullet *a, int32_t na, const struct side_bullet *b,
                      int32_t nb, int32_t f, struct leaving *leaving)
{
    int32_t i = 0, k = 0;

    while (i < na || k < nb) {
        const bool far = i < na && beyond(&a[i]);
        if (k < nb && (i == na || b[k].id < a[i].id)) {
            only_on(out, &b[k], "second", f);
            return false;
        }
        if (far && !add_leaving(leaving, a[i].id))
            return false;
        out->left += far;
        if (k == nb || a[i].id < b[k].id) { /* what leaves may be gone already */
            if (!far) {
                only_on(out, &a[i], "first", f);
                return false;
            }
            i++;
            continue;
        }
        if (!far)
            match(out, &a[i], &b[k], f);
        out->otherwise += far != beyond(&b[k]);
        i++;
        k++;
    }
    return true;
}

static bool both(struct side *a, struct side *b, int32_t f, struct compared *out, struct leaving *leaving)
{
    const int32_t x = side_player_x(f), y = side_player_y(f);
    const struct side_bullet *in_a, *in_b;
    const int32_t na = a->frame(a, x, y, &in_a);

    if (na < 0) {
        out->broke = true;
        snprintf(out->what, sizeof out->what, "frame %d: %s", f, a->error);
        return false;
    }
    const int32_t nb = b->frame(b, x, y, &in_b);
    if (nb < 0) {
        out->failed = true;
        snprintf(out->what, sizeof out->what, "frame %d: %s", f, b->error);
        return false;
    }
    out->frames = f + 1;
    out->most = na > out->most ? na : out->most;
    out->bullets = na && in_a[na - 1].id > out->bullets ? in_a[na - 1].id : out->bullets;
    leaving->n = 0;
    return match_all(out, in_a, na, in_b, nb, f, leaving) && a->leave(a, leaving->id, leaving->n) &&
           b->leave(b, leaving->id, leaving->n);
}

void compare_sides(struct side *a, struct side *b, int32_t frames, struct compared *out)
{
    struct leaving leaving = { 0 };

    *out = (struct compared){ 0 };
    for (int32_t f = 0; f < frames; f++)
        if (!both(a, b, f, out, &leaving))
            break;
    free(leaving.id);
    a->close(a);
    b->close(b);
}

/*
 * markers.h - the markers of two recordings of one run, compared.
 */
#ifndef DEMO_MARKERS_H
#define DEMO_MARKERS_H

#include "demo.h"

/* A marker that is in another frame, or in one of the two alone; the other is NULL. */
struct marker_change {
    const struct demo_marker *was, *is;
};

struct marker_changes {
    struct marker_change *list; /* in the order of frames: of .was, if there is one, else of .is */
    uint32_t n;
};

/* The n-th marker of a kind and name is the same thing in both. What a practice start lists and what else says nothing
 * about a run is left out. False: no memory. Good as long as both demos are; free c->list. */
bool markers_compare(struct marker_changes *c, const struct demo *was, const struct demo *is);

/* "phase held 3030 -> 3041", "death of player 1 3100 -> never". */
void markers_text(const struct marker_change *c, char *out, size_t size);

#endif

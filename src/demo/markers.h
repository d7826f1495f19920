/*
 * markers.h - compares the markers of two recordings of the same run.
 */
#ifndef DEMO_MARKERS_H
#define DEMO_MARKERS_H

#include "demo.h"

/* A marker whose frame differs, or that only one recording has; the missing one is NULL. */
struct marker_change {
    const struct demo_marker *before, *after;
};

struct marker_changes {
    struct marker_change *list; /* sorted by the frame of .before, or of .after when .before is NULL */
    uint32_t n;
};

/* Compares two demos: the n-th markers with the same kind and name correspond. Markers that do not describe the run
 * (those of PRACTICE_LIST) are left out. Returns false when out of memory. The result is valid as long as both demos
 * are; free c->list. */
bool markers_compare(struct marker_changes *c, const struct demo *before, const struct demo *after);

/* Returns the name of a kind in JSON and test scripts, such as "stage"; NULL for markers that do not describe the run.
 * */
const char *markers_kind_name(enum board_marker_kind kind);

/* Writes a change as text: "phase held 3030 -> 3041", "death of player 1 3100 -> never". */
void markers_format_change(const struct marker_change *c, char *out, size_t size);

#endif

/*
 * events.c - see events.h.
 */
#include "events.h"

bool events_push(struct events *e, enum event_kind kind, int64_t a, int64_t b)
{
    if (e->n == e->cap)
        return false;
    e->list[e->n++] = (struct event){ .kind = kind, .a = a, .b = b };
    return true;
}

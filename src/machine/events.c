/*
 * events.c - see events.h.
 */
#include "events.h"

uint64_t events_size(uint32_t cap)
{
    return (uint64_t)cap * (sizeof(int64_t) + sizeof(int64_t) + sizeof(uint8_t));
}

void events_init(struct events *e, uint32_t cap, uint8_t *memory)
{
    int64_t *a = (int64_t *)(void *)memory, *b = a + cap;

    *e = (struct events){ .cap = cap, .a = a, .b = b, .kind = (uint8_t *)(b + cap) };
}

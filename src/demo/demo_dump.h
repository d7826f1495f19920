/*
 * demo_dump.h - writes an unfinished recording as the bytes of a demo file; also usable in a crash handler.
 */
#ifndef DEMO_DEMO_DUMP_H
#define DEMO_DEMO_DUMP_H

#include "demo.h"

struct demo_dump_request {
    uint8_t *memory; /* demo_dump_size bytes, allocated in advance */
    size_t size;
    uint32_t frames;             /* the current frame; frames recorded after it are left out */
    bool ticking;                /* a tick has started at that frame and not returned; its pads are included */
    enum board_fault_kind fault; /* fault of the last frame, or of power-on */
    void (*write)(void *user, const uint8_t *bytes, size_t n);
    void *user;
};

/* Returns the bytes of memory that demo_dump needs. */
size_t demo_dump_size(const struct demo_writer *w);

/* Passes the recording to request->write, record by record. Reads w and uses request->memory only: no allocation, no
 * file. A dump that ends in a tick that has not returned, before the recording's end, or in a sparse recording's full
 * second whose row is missing, has no end mark; demo_read reads it as far as possible. */
void demo_dump(const struct demo_writer *w, const struct demo_dump_request *request);

#endif

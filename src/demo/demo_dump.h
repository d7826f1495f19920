/*
 * demo_dump.h - a recording that is not over, handed out as a demo file's bytes, also from a handler of a crash.
 */
#ifndef DEMO_DEMO_DUMP_H
#define DEMO_DEMO_DUMP_H

#include "demo.h"

struct demo_dump {
    uint8_t *memory; /* demo_dump_size bytes, taken before */
    size_t size;
    uint32_t frames;             /* the present: what is recorded behind it is left out */
    bool ticking;                /* a tick has begun there and did not come back: its pads belong to it */
    enum board_fault_kind fault; /* of the last frame, or of power-on */
    void (*out)(void *user, const uint8_t *bytes, size_t n);
    void *user;
};

/* Memory enough for any record of a recording, in bytes. */
size_t demo_dump_size(const struct demo_writer *w);

/* Hands the recording to how->out, record by record. It reads w and uses that memory, and nothing else: no allocation,
 * no file. What ends with a tick that did not come back, or before the recording's end, has no end mark, and is read as
 * far as it goes. */
void demo_dump(const struct demo_writer *w, const struct demo_dump *how);

#endif

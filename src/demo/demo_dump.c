/*
 * demo_dump.c - writes an unfinished recording as the bytes of a demo file (demo_dump.h).
 */
#include "demo_dump.h"

#include "demo_parts.h"

enum { RECORDS = 1 << 14 /* bytes: enough for any record, and for a header without its nvram */ };

struct dump {
    struct demo_sink sink;
    const struct demo_dump *how;
    uint32_t frames, told, crc; /* written so far */
};

size_t demo_dump_size(const struct demo_writer *w)
{
    size_t nvram = w->demo.start.nvram_size;

    return RECORDS + nvram + nvram / 64; /* encoding turns 128 bytes into at most 129 */
}

static void flush(struct dump *u)
{
    if (!u->sink.bad)
        u->how->out(u->how->user, u->sink.p, u->sink.n);
    u->sink.n = 0;
}

/* Writes the markers of the frames written so far. */
static void put_markers(struct dump *u, const struct demo *d)
{
    while (u->told < d->n_markers && d->markers[u->told].frame <= u->frames) {
        demo_put_markers(&u->sink, d, &u->told, d->markers[u->told].frame, &u->crc);
        flush(u);
    }
}

static void put_second(struct dump *u, const struct demo *d, uint32_t n, const uint64_t *row)
{
    demo_put_second(&u->sink, d, u->frames, n, row, &u->crc);
    u->frames += n;
    flush(u);
    put_markers(u, d);
}

void demo_dump(const struct demo_writer *w, const struct demo_dump *how)
{
    struct dump u = { .sink = { .p = how->memory, .room = how->size, .fixed = true }, .how = how };
    struct demo d = w->demo;
    bool is_complete = how->frames >= d.frames && !how->ticking;
    const bool hashed = is_complete && !how->fault && d.checksum_frames == d.frames;

    d.frames = how->frames < d.frames ? how->frames : d.frames;
    d.fault = how->fault;
    demo_put_header(&u.sink, &d, &u.crc);
    if (d.flags)
        demo_put_flags(&u.sink, d.flags, &u.crc);
    flush(&u);
    for (uint32_t i = 0; i < d.seconds && demo_row_frame(&w->demo, i) <= d.frames; i++)
        put_second(&u, &d, demo_row_frame(&w->demo, i) - u.frames, demo_row(&w->demo, i));
    d.frames += how->ticking;
    if (d.seconds && d.frames > u.frames)
        put_second(&u, &d, d.frames - u.frames, hashed ? w->hashes : NULL);
    if (!is_complete || (!hashed && !how->fault))
        return;
    demo_put_end(&u.sink, &d, &u.crc);
    flush(&u);
}

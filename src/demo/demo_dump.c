/*
 * demo_dump.c - writes an unfinished recording as the bytes of a demo file (demo_dump.h).
 */
#include "demo_dump.h"

#include "demo_parts.h"

enum { MAX_RECORD = 1 << 14 /* bytes: enough for any record, and for a header without its nvram */ };

struct dump {
    struct demo_sink sink;
    const struct demo_dump_request *request;
    uint32_t frames_written, markers_written, crc; /* written so far */
};

size_t demo_dump_size(const struct demo_writer *w)
{
    size_t nvram = w->demo.start.nvram_size;

    return MAX_RECORD + nvram + nvram / 64; /* encoding turns 128 bytes into at most 129 */
}

static void flush(struct dump *u)
{
    if (!u->sink.failed)
        u->request->write(u->request->user, u->sink.p, u->sink.n);
    u->sink.n = 0;
}

/* Writes the markers of the frames written so far. */
static void put_markers(struct dump *u, const struct demo *d)
{
    while (u->markers_written < d->n_markers && d->markers[u->markers_written].frame <= u->frames_written) {
        demo_put_markers(&u->sink, d, &u->markers_written, d->markers[u->markers_written].frame, &u->crc);
        flush(u);
    }
}

static void put_second(struct dump *u, const struct demo *d, uint32_t n, const uint64_t *row)
{
    demo_put_second(&u->sink, d, u->frames_written, n, row, &u->crc);
    u->frames_written += n;
    flush(u);
    put_markers(u, d);
}

void demo_dump(const struct demo_writer *w, const struct demo_dump_request *request)
{
    struct dump u = { .sink = { .p = request->memory, .cap = request->size, .fixed = true }, .request = request };
    struct demo d = w->demo;
    bool is_complete = request->frames >= d.frames && !request->ticking;
    const bool hashed = is_complete && !request->fault && d.checksum_frames == d.frames;

    d.frames = request->frames < d.frames ? request->frames : d.frames;
    d.fault = request->fault;
    demo_put_header(&u.sink, &d, &u.crc);
    if (d.flags)
        demo_put_flags(&u.sink, d.flags, &u.crc);
    flush(&u);
    for (uint32_t i = 0; i < d.n_rows && demo_row_frame(&w->demo, i) <= d.frames; i++)
        put_second(&u, &d, demo_row_frame(&w->demo, i) - u.frames_written, demo_row(&w->demo, i));
    d.frames += request->ticking;
    if (d.n_rows && d.frames > u.frames_written)
        put_second(&u, &d, d.frames - u.frames_written, hashed ? w->hashes : NULL);
    if (!is_complete || (!hashed && !request->fault))
        return;
    demo_put_end(&u.sink, &d, &u.crc);
    flush(&u);
}

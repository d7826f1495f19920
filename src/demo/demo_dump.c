/*
 * demo_dump.c - writes an unfinished recording as the bytes of a demo file (demo_dump.h).
 */
#include "demo_dump.h"

#include "demo_parts.h"

enum { MAX_RECORD = 1 << 14 /* bytes: enough for any record, and for a header without its nvram */ };

size_t demo_dump_size(const struct demo_writer *w)
{
    size_t nvram = w->demo.start.nvram_size;

    return MAX_RECORD + nvram + nvram / 64; /* encoding turns 128 bytes into at most 129 */
}

void demo_dump(const struct demo_writer *w, const struct demo_dump_request *request)
{
    struct demo_sink s = { .p = request->memory, .cap = request->size, .write = request->write, .user = request->user };
    struct demo d = w->demo;
    const bool is_complete = request->frames >= d.frames && !request->ticking;
    /* Recording can run out of memory between a second's last frame and its row. A sparse demo has checksums only in
     * rows. */
    const bool lacks_row = d.sparse && d.frames == d.n_rows * DEMO_SECOND_FRAMES;
    const bool hashed = is_complete && !request->fault && !lacks_row && d.checksum_frames == d.frames;
    uint32_t frames, n_markers, crc;

    d.frames = request->frames < d.frames ? request->frames : d.frames;
    d.fault = request->fault;
    while (d.n_rows && demo_row_frame(&w->demo, d.n_rows - 1) > d.frames)
        d.n_rows--;
    demo_put_until_last_row(&s, &d, &frames, &n_markers, &crc);
    d.frames += request->ticking;
    if (d.n_rows && d.frames > frames) {
        demo_put_second(&s, &d, frames, d.frames - frames, hashed ? w->hashes : NULL, &crc);
        demo_put_markers(&s, &d, &n_markers, d.frames, &crc);
    }
    if (is_complete && (hashed || request->fault))
        demo_put_end(&s, &d, &crc);
}

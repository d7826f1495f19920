/*
 * fuzz_demo.c - libFuzzer: any bytes as a demo. Odd inputs go in as they are; for even ones the records' CRCs are made
 * good first, and the format is 2 to 5, by the next bits. What is read must hang together, and must not be much larger
 * than the file.
 */
#include "../../src/demo/demo.h"
#include "../repair.h"
#include "fuzz.h"

static void repair(uint8_t *p, size_t n, uint32_t format)
{
    memcpy(p, "CDEM", 4);
    bytes_put32(p + 4, format);
    repair_demo(p, n);
}

static void check(const struct demo *d, size_t file_size)
{
    uint16_t pads[MAX_PLAYERS];
    uint64_t h = 0, hashes[MAX_PARTS] = { 0 };

    need(d->n_parts >= 1 && d->n_parts <= MAX_PARTS && d->start.nvram_size <= (d->format > 3 ? MAX_NVRAM : 32768));
    need(memchr(d->start.practice.section, 0, sizeof d->start.practice.section) != NULL &&
         memchr(d->id, 0, sizeof d->id) != NULL);
    need(d->frames <= (d->sparse ? 3 : 1) * file_size && d->n_rows <= file_size);
    need(d->checksum_parts != 0 && (d->checksum_frames == d->frames || d->checksum_frames + 1 == d->frames));
    need(!d->complete || d->fault || d->n_rows == 1 + (d->frames + DEMO_SECOND_FRAMES - 1) / DEMO_SECOND_FRAMES);
    need(d->start.practice.register_count >= 0 && d->start.practice.register_count <= PRACTICE_MAX_REGISTERS);
    for (int i = 0; i < d->start.practice.register_count; i++)
        need(memchr(d->start.practice.reg[i].name, 0, sizeof d->start.practice.reg[i].name) != NULL);
    need(!d->sparse || d->format > 4);
    need((d->format > 2 && d->checksum_parts == UINT64_MAX) || (d->format == 2 && d->n_markers == 0));
    need(memchr(d->start.lang, 0, sizeof d->start.lang) != NULL && (d->format > 3 || !d->start.lang[0]));
    need(d->n_parts <= (d->format > 3 ? 64 : 32));
    for (uint32_t f = 0; f <= d->frames; f++) {
        need((demo_checksums(d, f) != NULL) == (f > 0 && f <= d->checksum_frames && !d->sparse));
        demo_pads(d, f, pads);
        need(pad_is_valid(pads[0]) && pad_is_valid(pads[1]));
        h += demo_differing_parts(d, f, hashes);
    }
    for (uint32_t i = 0; i < d->n_rows * (uint32_t)d->n_parts; i++)
        h += d->rows[i];
    for (uint32_t i = 0; i < d->n_markers; i++) {
        need(d->markers[i].frame <= d->frames && (i == 0 || d->markers[i].frame >= d->markers[i - 1].frame));
        need(memchr(d->markers[i].marker.name, 0, sizeof d->markers[i].marker.name) != NULL);
        need(d->format > 3 || (d->markers[i].marker.kind <= MARKER_LISTED && !d->markers[i].marker.value));
    }
    for (uint32_t i = 0; i < d->n_rows; i++)
        need(demo_row_frame(d, i) <= d->frames);
    h += hash_bytes(0, d->start.nvram, d->start.nvram_size);
    need(h != 1); /* uses it */
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct demo d; /* large for a stack */
    size_t n = size > 0 ? size - 1 : 0;
    uint8_t *copy = fuzz_copy(data + 1, n);
    char err[256] = "";

    if (n >= 8 && data[0] % 2 == 0)
        repair(copy, n, 2 + (data[0] >> 1 & 3));
    if (demo_read(&d, copy, n, err, sizeof err))
        check(&d, n);
    else
        need(err[0] != '\0' && d.pads == NULL && d.checksums == NULL && d.markers == NULL && d.rows == NULL);
    demo_free(&d);
    free(copy);
    return 0;
}

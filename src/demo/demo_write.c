/*
 * demo_write.c - writes a whole demo to memory or to its file (demo.h). demo_record.c writes a demo while it is being
 * recorded; demo_put.c writes the records.
 */
#include <stdlib.h>
#include "../base/err.h"
#include "demo_parts.h"
#include "../common/files.h"

uint8_t *demo_encode(const struct demo *d, size_t *size)
{
    struct demo_sink s = { 0 };
    uint32_t frames, n_markers, crc;

    demo_put_until_last_row(&s, d, &frames, &n_markers, &crc);
    if (d->complete && d->frames > frames) { /* a frame that faulted has no row */
        demo_put_second(&s, d, frames, d->frames - frames, NULL, &crc);
        demo_put_markers(&s, d, &n_markers, d->frames, &crc);
    }
    if (d->complete)
        demo_put_end(&s, d, &crc);
    *size = s.n;
    if (!s.failed)
        return s.p;
    free(s.p);
    return NULL;
}

bool demo_save(const struct demo *d, const char *path, char *err, size_t err_size)
{
    size_t size;

    if (d->checksum_parts != UINT64_MAX)
        return err_set(err, err_size, "%s: the demo has no per-part checksums to write", path);
    uint8_t *bytes = demo_encode(d, &size);
    if (!bytes)
        return err_set(err, err_size, "%s: out of memory", path);
    const bool ok = files_save(path, bytes, size, err, err_size);
    free(bytes);
    return ok;
}

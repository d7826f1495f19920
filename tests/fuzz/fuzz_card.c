/*
 * fuzz_card.c - libFuzzer: any bytes as a replay's card; for even ones the CRCs are made good first. What is read is
 * within its bounds, and written it reads as the same.
 */
#include "../../src/base/bytes.h"
#include "../../src/base/hash.h"
#include "../../src/player/replays/replay_meta.h"
#include "fuzz.h"

/* The head's CRC, and behind it the picture's, as far as they are there. */
static void repair(uint8_t *p, size_t n)
{
    if (n < 16)
        return;
    memcpy(p, "CCRD\1\0\0\0", 8);
    const size_t at = 12 + (size_t)bytes_get32(p + 8);
    if (at > n - 4)
        return;
    bytes_put32(p + at, hash_crc32(p, at));
    if (n >= at + 10)
        bytes_put32(p + n - 4, hash_crc32(p + at + 4, n - at - 8));
}

static void round_trip(const struct replay_meta *c, const struct thumb *t)
{
    uint8_t bytes[REPLAY_META_BYTES], again[REPLAY_META_BYTES];
    struct replay_meta back;
    struct thumb seen;

    const size_t n = replay_meta_write(c, t, bytes);
    need(replay_meta_read(&back, bytes, n) && replay_meta_read_thumb(&seen, bytes, n) == (t->w * t->h > 0));
    need(replay_meta_write(&back, &seen, again) == n && memcmp(bytes, again, n) == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct thumb t;
    const size_t n = size > 0 ? size - 1 : 0;
    uint8_t *copy = fuzz_copy(data + 1, n);
    struct replay_meta c;

    if (n && data[0] % 2 == 0)
        repair(copy, n);
    if (!replay_meta_read_thumb(&t, copy, n))
        need(t.w == 0 && t.h == 0);
    need(t.w <= THUMB_SIDE && t.h <= THUMB_SIDE);
    if (replay_meta_read(&c, copy, n)) {
        need(c.rows >= 0 && c.rows <= REPLAY_MAX_ROWS && c.end < REPLAY_ENDS && c.first <= c.last);
        need(memchr(c.name, 0, sizeof c.name) && memchr(c.ship, 0, sizeof c.ship) && memchr(c.id, 0, sizeof c.id));
        round_trip(&c, &t);
    } else {
        need(c.rows == 0 && c.name[0] == 0);
    }
    free(copy);
    return 0;
}

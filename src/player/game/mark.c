/*
 * mark.c - the mark of the embedded game (mark.h). Little-endian: 32 letters that occur nowhere else in a program, u32
 * version, u32 flags, u64 at, u64 size, u32 CRC, u32 core version.
 *
 * The mark is volatile because `export` changes it after compilation.
 */
#include "mark.h"

#include <string.h>
#include "../../base/bytes.h"
#include "../../board/board.h"

enum { LETTERS = 32, VERSION = 1 };

static const volatile struct {
    char letters[LETTERS];
    uint8_t version[4], where[24], core[4];
} own = { "<a game may stand behind curtain", { VERSION }, { 0 }, { CORE_VERSION } };

_Static_assert(sizeof own == MARK_BYTES && CORE_VERSION < 256, "letters and numbers, nothing between");

static void copy_own(uint8_t out[MARK_BYTES])
{
    const volatile uint8_t *from = (const volatile uint8_t *)&own;

    for (int i = 0; i < MARK_BYTES; i++)
        out[i] = from[i];
}

void mark_read(const uint8_t at[MARK_BYTES], struct mark *m)
{
    m->flags = bytes_get32(at + LETTERS + 4);
    m->at = bytes_get64(at + LETTERS + 8);
    m->size = bytes_get64(at + LETTERS + 16);
    m->crc = bytes_get32(at + LETTERS + 24);
    m->core = bytes_get32(at + LETTERS + 28);
}

struct mark mark_own(void)
{
    uint8_t bytes[MARK_BYTES];
    struct mark m;

    copy_own(bytes);
    mark_read(bytes, &m);
    return m;
}

bool mark_find(const uint8_t *file, size_t size, size_t *at)
{
    uint8_t letters[MARK_BYTES];
    int found = 0;

    copy_own(letters);
    for (size_t i = 0; i + MARK_BYTES <= size; i++) {
        const uint8_t *next = memchr(file + i, letters[0], size - MARK_BYTES + 1 - i);
        if (!next)
            break;
        i = (size_t)(next - file);
        if (memcmp(next, letters, LETTERS) != 0)
            continue;
        *at = i;
        found++;
    }
    return found == 1 && bytes_get32(file + *at + LETTERS) == VERSION;
}

void mark_put(uint8_t at[MARK_BYTES], const struct mark *m)
{
    bytes_put32(at + LETTERS + 4, m->flags);
    bytes_put64(at + LETTERS + 8, m->at);
    bytes_put64(at + LETTERS + 16, m->size);
    bytes_put32(at + LETTERS + 24, m->crc);
}

/*
 * rom.c - see rom.h. rom_open makes all checks; the other functions read without checking. rom_open accepts layouts in
 * which names ascend, all data follows the names, and data ascends without overlap; gaps are allowed.
 */
#include "rom.h"

#include <assert.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "../base/bytes.h"
#include "../base/err.h"
#include "../base/hash.h"

static const uint8_t magic[8] = { 'C', 'U', 'R', 'T', 'A', 'I', 'N', 0x1a };

/* The offset of the first byte that the header's checksum covers. */
enum { CRC_START = 16 };

static const uint8_t *entry(const struct rom *rom, uint32_t i)
{
    return rom->data + ROM_HEADER_SIZE + (size_t)i * ROM_ENTRY_SIZE;
}

static const char *name_of(const struct rom *rom, uint32_t i)
{
    return (const char *)rom->data + bytes_get32(entry(rom, i));
}

bool rom_name_ok(const char *name)
{
    size_t n = strlen(name);

    for (size_t i = 0; i < n; i++)
        if (name[i] < 32 || name[i] > 126)
            return false;
    return n > 0 && n < ROM_MAX_NAME;
}

static bool check_header(const uint8_t *p, size_t size, char *err, size_t err_size)
{
    if (size < ROM_HEADER_SIZE)
        return err_set(err, err_size, "too short for a ROM (%zu bytes)", size);
    if (memcmp(p, magic, sizeof magic) != 0)
        return err_set(err, err_size, "not a Curtain ROM");
    if (bytes_get32(p + 8) != ROM_VERSION)
        return err_set(err, err_size, "unknown ROM format %" PRIu32 " (this program reads format %d)",
                       bytes_get32(p + 8), ROM_VERSION);
    if (bytes_get32(p + 20) != size)
        return err_set(err, err_size, "%zu bytes long, but its header says %" PRIu32, size, bytes_get32(p + 20));
    if (bytes_get32(p + 12) != hash_crc32(p + CRC_START, size - CRC_START))
        return err_set(err, err_size, "damaged: the checksum does not match");
    if (bytes_get64(p + 24) != 0)
        return err_set(err, err_size, "reserved header bytes are not zero");
    if (bytes_get32(p + 16) > (size - ROM_HEADER_SIZE) / ROM_ENTRY_SIZE)
        return err_set(err, err_size, "the directory of %" PRIu32 " lumps runs past the end", bytes_get32(p + 16));
    return true;
}

static bool check_name(const struct rom *rom, uint32_t i, char *err, size_t err_size)
{
    size_t at = bytes_get32(entry(rom, i)), names_start = ROM_HEADER_SIZE + (size_t)rom->count * ROM_ENTRY_SIZE;

    if (at < names_start || at >= rom->size || memchr(rom->data + at, 0, rom->size - at) == NULL)
        return err_set(err, err_size, "lump %" PRIu32 ": its name is outside the file", i);
    if (!rom_name_ok(name_of(rom, i)))
        return err_set(err, err_size, "lump %" PRIu32 ": its name is empty, too long or not plain ASCII", i);
    if (i > 0 && strcmp(name_of(rom, i - 1), name_of(rom, i)) >= 0)
        return err_set(err, err_size, "lump %" PRIu32 " \"%s\" is out of order (lumps are sorted by name)", i,
                       name_of(rom, i));
    return true;
}

/* Checks the data of lump i. *end: the end of the previous lump; set to the end of this one. */
static bool check_data(const struct rom *rom, uint32_t i, size_t *end, char *err, size_t err_size)
{
    const uint8_t *e = entry(rom, i);
    size_t at = bytes_get32(e + 4), size = bytes_get32(e + 8);
    const char *name = name_of(rom, i);

    if (at % ROM_ALIGN != 0)
        return err_set(err, err_size, "lump %" PRIu32 " \"%s\" is not aligned to %d bytes", i, name, ROM_ALIGN);
    if (at > rom->size || size > rom->size - at)
        return err_set(err, err_size, "lump %" PRIu32 " \"%s\" runs past the end", i, name);
    if (at < *end)
        return err_set(err, err_size, "lump %" PRIu32 " \"%s\" overlaps the lump before it", i, name);
    if (hash_crc32(rom->data + at, size) != bytes_get32(e + 12))
        return err_set(err, err_size, "lump %" PRIu32 " \"%s\" is damaged: its checksum does not match", i, name);
    *end = at + size;
    return true;
}

bool rom_open(struct rom *rom, const void *data, size_t size, char *err, size_t err_size)
{
    const uint8_t *p = data;

    if (!check_header(p, size, err, err_size))
        return false;
    struct rom r = { p, size, bytes_get32(p + 16), bytes_get32(p + 12) };
    size_t end = ROM_HEADER_SIZE + (size_t)r.count * ROM_ENTRY_SIZE;
    for (uint32_t i = 0; i < r.count; i++) {
        size_t name_end;
        if (!check_name(&r, i, err, err_size))
            return false;
        name_end = bytes_get32(entry(&r, i)) + strlen(name_of(&r, i)) + 1;
        end = name_end > end ? name_end : end;
    }
    for (uint32_t i = 0; i < r.count; i++)
        if (!check_data(&r, i, &end, err, err_size))
            return false;
    *rom = r;
    return true;
}

int rom_find_first(const struct rom *rom, const char *prefix)
{
    uint32_t lo = 0, hi = rom->count;

    while (lo < hi) {
        uint32_t mid = lo + (hi - lo) / 2;
        if (strcmp(name_of(rom, mid), prefix) < 0)
            lo = mid + 1;
        else
            hi = mid;
    }
    return (int)lo;
}

int rom_find(const struct rom *rom, const char *name)
{
    int i = rom_find_first(rom, name);

    return (uint32_t)i < rom->count && strcmp(name_of(rom, (uint32_t)i), name) == 0 ? i : -1;
}

void rom_lump(const struct rom *rom, int i, struct lump *out)
{
    assert(i >= 0 && (uint32_t)i < rom->count);
    const uint8_t *e = entry(rom, (uint32_t)i);

    *out = (struct lump){ name_of(rom, (uint32_t)i), rom->data + bytes_get32(e + 4), bytes_get32(e + 8) };
}

static bool is_read_by_ticks(const char *name)
{
    return strcmp(name, "manifest") == 0 || strncmp(name, "script/", 7) == 0 || strncmp(name, "data/", 5) == 0 ||
           strncmp(name, "lang/", 5) == 0 || strncmp(name, "tune/", 5) == 0 || strncmp(name, "hit/", 4) == 0;
}

static uint64_t hash_lumps(const struct rom *rom, bool all)
{
    uint64_t h = HASH_START;
    struct lump l;

    for (uint32_t i = 0; i < rom->count; i++) {
        rom_lump(rom, (int)i, &l);
        if (all || is_read_by_ticks(l.name)) {
            h = hash_bytes(h, l.name, strlen(l.name));
            h = hash_bytes(h, l.data, l.size);
        }
    }
    return h;
}

uint64_t rom_hash(const struct rom *rom)
{
    return hash_lumps(rom, true);
}

uint64_t rom_game_hash(const struct rom *rom)
{
    return hash_lumps(rom, false);
}

static uint64_t align_up(uint64_t n)
{
    return (n + ROM_ALIGN - 1) / ROM_ALIGN * ROM_ALIGN;
}

/* Returns the offset of the first lump's data in a ROM of n lumps. */
static uint64_t data_start(const struct lump *lumps, int n)
{
    uint64_t at = ROM_HEADER_SIZE + (uint64_t)n * ROM_ENTRY_SIZE;

    for (int i = 0; i < n; i++)
        at += strlen(lumps[i].name) + 1;
    return align_up(at);
}

size_t rom_write_size(const struct lump *lumps, int n)
{
    uint64_t at = data_start(lumps, n);

    for (int i = 0; i < n; i++)
        at = align_up(at) + lumps[i].size;
    return at <= UINT32_MAX ? (size_t)at : 0;
}

void rom_write(void *out, const struct lump *lumps, int n)
{
    uint8_t *p = out;
    size_t size = rom_write_size(lumps, n), name_at = ROM_HEADER_SIZE + (size_t)n * ROM_ENTRY_SIZE;
    size_t at = (size_t)data_start(lumps, n);

    memset(p, 0, size);
    for (int i = 0; i < n; i++) {
        const struct lump *l = &lumps[i];
        uint8_t *e = p + ROM_HEADER_SIZE + (size_t)i * ROM_ENTRY_SIZE;
        assert(rom_name_ok(l->name) && (i == 0 || strcmp(lumps[i - 1].name, l->name) < 0));
        at = (size_t)align_up(at);
        bytes_put32(e, (uint32_t)name_at);
        bytes_put32(e + 4, (uint32_t)at);
        bytes_put32(e + 8, l->size);
        bytes_put32(e + 12, hash_crc32(l->data, l->size));
        memcpy(p + name_at, l->name, strlen(l->name));
        if (l->size > 0)
            memcpy(p + at, l->data, l->size);
        name_at += strlen(l->name) + 1;
        at += l->size;
    }
    memcpy(p, magic, sizeof magic);
    bytes_put32(p + 8, ROM_VERSION);
    bytes_put32(p + 16, (uint32_t)n);
    bytes_put32(p + 20, (uint32_t)size);
    bytes_put32(p + 12, hash_crc32(p + CRC_START, size - CRC_START));
}

/*
 * zip.c - see zip.h. Every file has the date 1980-01-01 00:00, the earliest of the format. The archive's comment
 * identifies it as an export.
 */
#include "zip.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/hash.h"
#include "../../player/picture/png.h"

enum {
    UTF8_NAMES = 1 << 11,
    STORED = 0,
    DEFLATED = 8,
    VERSION = 20, /* 2.0, the first with DEFLATED */
    UNIX = 3 << 8,
    EARLIEST_DATE = 1 << 5 | 1,
    HEADER = 30, /* bytes */
    ENTRY = 46,
    END = 22
};

static const char comment[] = "made with Curtain";

/* Writes the 26 bytes that are equal in a file's header and in its directory entry. */
static void put_common(uint8_t *p, int method, uint32_t crc, size_t packed, size_t size, size_t name)
{
    bytes_put16(p, VERSION);
    bytes_put16(p + 2, UTF8_NAMES);
    bytes_put16(p + 4, (uint16_t)method);
    bytes_put16(p + 6, 0); /* time */
    bytes_put16(p + 8, EARLIEST_DATE);
    bytes_put32(p + 10, crc);
    bytes_put32(p + 14, (uint32_t)packed);
    bytes_put32(p + 18, (uint32_t)size);
    bytes_put16(p + 22, (uint16_t)name);
    bytes_put16(p + 24, 0); /* bytes of extra fields */
}

void zip_add(struct zip *z, const char *name, const void *data, size_t size, bool runs)
{
    const size_t at = z->bytes.n, length = strlen(name);
    uint8_t *zlib, *header, *entry;
    size_t zlib_size;

    if (!png_deflate((uint8_t *)data, size, &zlib, &zlib_size)) {
        z->bytes.failed = true;
        return;
    }
    const bool smaller = zlib_size - 6 < size; /* between zlib's header, 2 bytes, and its checksum, 4 */
    const size_t packed = smaller ? zlib_size - 6 : size;
    header = byte_buffer_take(&z->bytes, HEADER);
    entry = byte_buffer_take(&z->directory, ENTRY);
    if (header && entry) {
        memcpy(header, "PK\3\4", 4);
        put_common(header + 4, smaller ? DEFLATED : STORED, hash_crc32(data, size), packed, size, length);
        memset(entry, 0, ENTRY);
        memcpy(entry, "PK\1\2", 4);
        bytes_put16(entry + 4, UNIX | VERSION);
        memcpy(entry + 6, header + 4, 26);
        bytes_put32(entry + 38, (runs ? 0100755u : 0100644u) << 16); /* a Unix mode */
        bytes_put32(entry + 42, (uint32_t)at);
    }
    byte_buffer_put(&z->bytes, name, length);
    byte_buffer_put(&z->directory, name, length);
    byte_buffer_put(&z->bytes, smaller ? zlib + 2 : data, packed);
    free(zlib);
    z->n++;
}

bool zip_finish(struct zip *z)
{
    const size_t at = z->bytes.n;

    byte_buffer_put(&z->bytes, z->directory.bytes, z->directory.n);
    uint8_t *end = byte_buffer_take(&z->bytes, END);
    if (end) {
        memset(end, 0, END);
        memcpy(end, "PK\5\6", 4);
        bytes_put16(end + 8, (uint16_t)z->n);
        bytes_put16(end + 10, (uint16_t)z->n);
        bytes_put32(end + 12, (uint32_t)z->directory.n);
        bytes_put32(end + 16, (uint32_t)at);
        bytes_put16(end + 20, sizeof comment - 1);
    }
    byte_buffer_put(&z->bytes, comment, sizeof comment - 1);
    const bool good = !z->bytes.failed && !z->directory.failed;
    byte_buffer_close(&z->directory);
    return good;
}

void zip_free(struct zip *z)
{
    byte_buffer_close(&z->bytes);
    byte_buffer_close(&z->directory);
}

bool zip_is_ours(const uint8_t *file, size_t size)
{
    const size_t n = sizeof comment - 1;

    return size > END + n && memcmp(file, "PK\3\4", 4) == 0 && memcmp(file + size - n - END, "PK\5\6", 4) == 0 &&
           memcmp(file + size - n, comment, n) == 0;
}

/*
 * tags.c - see tags.h. An OGG file consists of pages: a header, the lengths of up to 255 segments, the segments. A
 * segment of less than 255 bytes ends a packet. The second packet contains the comments, as does block 4 of FLAC: u32
 * length and vendor, u32 count, then for each comment u32 length and "NAME=value". (RFC 3533, RFC 7845, RFC 9639,
 * Vorbis I.)
 */
#include "tags.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/err.h"

enum {
    PAGE_HEADER = 27 /* bytes of its header */,
    LAST_PAGE = 4 /* of its flags */,
    MAX_COMMENTS = 1 << 24,
    DIGITS = 12
};

static char upper(char c)
{
    return (char)(c >= 'a' && c <= 'z' ? c - 32 : c);
}

/* Returns the value of a comment if it has the name, in upper or lower case; otherwise NULL. */
static const char *comment_value(const char *comment, size_t n, const char *name)
{
    const size_t length = strlen(name);

    if (n <= length || comment[length] != '=')
        return NULL;
    for (size_t i = 0; i < length; i++)
        if (upper(comment[i]) != name[i])
            return NULL;
    return comment + length + 1;
}

static bool parse_number(const char *text, const char *end, int64_t *out)
{
    *out = 0;
    if (text == end || end - text > DIGITS)
        return false;
    for (; text < end; text++) {
        if (*text < '0' || *text > '9')
            return false;
        *out = *out * 10 + (*text - '0');
    }
    return true;
}

static bool read_comment(const char *comment, size_t n, struct tags *out, char *err, size_t err_size)
{
    static const char *const names[] = { "LOOPSTART", "LOOPLENGTH", "LOOPEND" };
    int64_t *const to[] = { &out->start, &out->length, &out->end };

    for (int i = 0; i < 3; i++) {
        const char *text = comment_value(comment, n, names[i]);
        if (text && !parse_number(text, comment + n, to[i]))
            return err_set(err, err_size, "tag %s: expected a whole number of frames, got \"%.*s\"", names[i],
                           (int)(comment + n - text > 40 ? 40 : comment + n - text), text);
    }
    return true;
}

static bool read_comments(const uint8_t *p, size_t n, struct tags *out, char *err, size_t err_size)
{
    size_t position = 4;
    uint32_t count = 0;

    if (n >= 8 && bytes_get32(p) <= n - 8) {
        position += bytes_get32(p);
        count = bytes_get32(p + position);
        position += 4;
    } else if (n > 0) {
        return err_set(err, err_size, "its tags are longer than the file");
    }
    for (; count > 0; count--) {
        if (n - position < 4 || bytes_get32(p + position) > n - position - 4)
            return err_set(err, err_size, "its tags are longer than the file");
        const size_t size = bytes_get32(p + position);
        if (!read_comment((const char *)p + position + 4, size, out, err, err_size))
            return false;
        position += 4 + size;
    }
    return true;
}

/* ---- FLAC ---- */

enum { STREAMINFO_BYTES = 34, MAX_FRAME = 1 << 20 /* bytes; 65535 samples of two channels have half as many */ };

/* Returns whether STREAMINFO contains the number of samples (36 bits, 0: unknown). RFC 9639, section 8.2. */
static bool has_length(const uint8_t *p)
{
    return (p[13] & 15) != 0 || bytes_get32(p + 14) != 0;
}

/* Returns the CRC-16, which is 0 for a frame that includes its checksum. RFC 9639, section 9.3. */
static uint16_t crc16(const uint8_t *p, size_t n)
{
    uint32_t crc = 0;

    for (size_t i = 0; i < n; i++) {
        crc ^= (uint32_t)p[i] << 8;
        for (int k = 0; k < 8; k++)
            crc = crc << 1 ^ (crc & 0x8000 ? 0x8005u : 0);
    }
    return (uint16_t)crc;
}

/* Returns whether the file ends with a complete frame. If the length is unknown, only this shows a truncated file. */
static bool ends_in_frame(const uint8_t *data, size_t from, size_t n)
{
    const size_t first = n - from > MAX_FRAME ? n - MAX_FRAME : from;

    for (size_t at = n; at-- > first;)
        if (n - at > 2 && data[at] == 0xff && (data[at + 1] & 0xfe) == 0xf8 && crc16(data + at, n - at) == 0)
            return true;
    return false;
}

bool tags_flac(const uint8_t *data, size_t n, struct tags *out, char *err, size_t err_size)
{
    bool last = false, unknown_length = false;
    size_t at = 4;

    *out = (struct tags){ "FLAC", -1, -1, -1 };
    if (n < 4 || memcmp(data, "fLaC", 4) != 0)
        return err_set(err, err_size, "expected a FLAC file (fLaC)");
    while (!last) {
        if (n - at < 4)
            return err_set(err, err_size, "truncated before its samples");
        const size_t size = (size_t)data[at + 1] << 16 | (size_t)data[at + 2] << 8 | data[at + 3];
        const int kind = data[at] & 127;
        last = data[at] >> 7;
        if (size > n - at - 4)
            return err_set(err, err_size, "block %d (%zu bytes, at byte %zu) is longer than the file", kind, size, at);
        if (kind == 0 && size == STREAMINFO_BYTES)
            unknown_length = !has_length(data + at + 4);
        if (kind == 4 && !read_comments(data + at + 4, size, out, err, err_size))
            return false;
        at += 4 + size;
    }
    if (unknown_length && !ends_in_frame(data, at, n))
        return err_set(err, err_size, "truncated inside a frame");
    return true;
}

/* ---- OGG ---- */

static uint32_t page_crc(const uint8_t *page, size_t n)
{
    uint32_t crc = 0;

    for (size_t i = 0; i < n; i++) {
        crc ^= (uint32_t)(i >= 22 && i < 26 ? 0 : page[i]) << 24;
        for (int k = 0; k < 8; k++)
            crc = crc << 1 ^ (crc >> 31 ? 0x04c11db7u : 0);
    }
    return crc;
}

/* Returns the size of the page; 0: the page is damaged. */
static size_t page_size(const uint8_t *data, size_t n, size_t at, char *err, size_t err_size)
{
    const uint8_t *p = data + at;
    size_t size = PAGE_HEADER;

    if (n - at < PAGE_HEADER || memcmp(p, "OggS", 4) != 0 || p[4] != 0) {
        err_set(err, err_size, "expected a page (OggS) at byte %zu", at);
        return 0;
    }
    for (size_t i = 0; i < p[26] && PAGE_HEADER + i < n - at; i++)
        size += 1u + p[PAGE_HEADER + i];
    if (size > n - at)
        err_set(err, err_size, "the page at byte %zu is longer than the file", at);
    else if (page_crc(p, size) != bytes_get32(p + 22))
        err_set(err, err_size, "damaged page at byte %zu: wrong checksum", at);
    else if (bytes_get32(p + 14) != bytes_get32(data + 14))
        err_set(err, err_size, "expected a single stream; another starts at byte %zu", at);
    else
        return size;
    return 0;
}

/* The first two packets, before the audio; `current` is the one being read. */
struct packets {
    uint8_t *bytes; /* malloc */
    size_t n, end[2];
    int current;
};

/* Appends a page's segments. */
static bool add_page(struct packets *k, const uint8_t *page, char *err, size_t err_size)
{
    const uint8_t *segment = page + PAGE_HEADER + page[26];

    for (int i = 0; i < page[26] && k->current < 2; i++) {
        const size_t size = page[PAGE_HEADER + i];
        uint8_t *more = realloc(k->bytes, k->n + size + 1);
        if (more == NULL || k->n > MAX_COMMENTS) {
            k->bytes = more ? more : k->bytes;
            return err_set(err, err_size, "its tags are longer than %d bytes", MAX_COMMENTS);
        }
        k->bytes = more;
        memcpy(k->bytes + k->n, segment, size);
        k->n += size;
        segment += size;
        if (size < 255)
            k->end[k->current++] = k->n;
    }
    return true;
}

static bool read_packets(const struct packets *k, struct tags *out, char *err, size_t err_size)
{
    const size_t id = k->end[0], n = k->end[1] - id;
    const uint8_t *second = k->bytes + id;

    if (k->current < 2)
        return err_set(err, err_size, "truncated before its tags");
    if (id >= 7 && memcmp(k->bytes, "\1vorbis", 7) == 0 && n >= 7 && memcmp(second, "\3vorbis", 7) == 0) {
        out->codec = "Vorbis";
        return read_comments(second + 7, n - 7, out, err, err_size);
    }
    if (id >= 8 && memcmp(k->bytes, "OpusHead", 8) == 0 && n >= 8 && memcmp(second, "OpusTags", 8) == 0) {
        out->codec = "Opus";
        return read_comments(second + 8, n - 8, out, err, err_size);
    }
    return err_set(err, err_size, "expected Vorbis or Opus data");
}

bool tags_ogg(const uint8_t *data, size_t n, struct tags *out, char *err, size_t err_size)
{
    struct packets k = { 0 };
    bool good = true, ended = false;

    *out = (struct tags){ "", -1, -1, -1 };
    if (n < PAGE_HEADER || memcmp(data, "OggS", 4) != 0)
        return err_set(err, err_size, "expected an OGG or FLAC file (starting with OggS or fLaC)");
    for (size_t at = 0, size; good && at < n; at += size) {
        size = page_size(data, n, at, err, err_size);
        good = size > 0 && add_page(&k, data + at, err, err_size);
        ended = good && data[at + 5] & LAST_PAGE;
    }
    if (good && !ended)
        good = err_set(err, err_size, "truncated before its last page");
    good = good && read_packets(&k, out, err, err_size);
    free(k.bytes);
    return good;
}

/*
 * image.c - see image.h. The system loads a program by its program headers; only linkers and debuggers read the section
 * table.
 */
#include "image.h"

#include <stdbool.h>
#include <string.h>

/* Offsets of the fields, from the System V ABI, "Object Files". */
static const struct layout {
    int word;                                  /* bytes of an offset */
    int phoff, shoff, phentsize, phnum, shnum; /* of the file's header; shstrndx is behind shnum */
    int segment, offset, filesz;               /* of a program header: its bytes, and fields */
} layouts[] = { { 4, 28, 32, 42, 44, 48, 32, 4, 16 }, { 8, 32, 40, 54, 56, 60, 56, 8, 32 } };

static uint64_t read_uint(const uint8_t *p, int n, bool big_endian)
{
    uint64_t v = 0;

    for (int i = 0; i < n; i++)
        v |= (uint64_t)p[i] << 8 * (big_endian ? n - 1 - i : i);
    return v;
}

size_t image_trim(uint8_t *file, size_t size)
{
    enum { CLASS = 4, ORDER = 5 }; /* 1: 32 bits, 2: 64 bits; 1: little-endian, 2: big-endian */

    if (size < 64 || memcmp(file, "\177ELF", 4) != 0 || (file[CLASS] - 1) >> 1 || (file[ORDER] - 1) >> 1)
        return size;
    const struct layout *l = &layouts[file[CLASS] - 1];
    const bool big = file[ORDER] == 2;
    const uint64_t at = read_uint(file + l->phoff, l->word, big), n = read_uint(file + l->phnum, 2, big);
    if (read_uint(file + l->phentsize, 2, big) != (uint64_t)l->segment || at > size ||
        n * (uint64_t)l->segment > size - at)
        return size;
    uint64_t end = at + n * (uint64_t)l->segment;
    for (const uint8_t *p = file + at; p < file + at + n * (uint64_t)l->segment; p += l->segment) {
        const uint64_t from = read_uint(p + l->offset, l->word, big), bytes = read_uint(p + l->filesz, l->word, big);
        if (from > size || bytes > size - from)
            return size;
        end = from + bytes > end ? from + bytes : end;
    }
    memset(file + l->shoff, 0, (size_t)l->word);
    memset(file + l->shnum, 0, 4);
    return (size_t)end;
}

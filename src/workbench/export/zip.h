/*
 * zip.h - writes zip archives whose bytes depend on nothing but the files: APPNOTE.TXT 6.3, without ZIP64.
 */
#ifndef WORKBENCH_ZIP_H
#define WORKBENCH_ZIP_H

#include "../../common/byte_buffer.h"

/* Zeroes are an empty one. */
struct zip {
    struct byte_buffer bytes, directory;
    unsigned n;
};

/* Adds a file, name in UTF-8. runs: it is a program, which Unix may run after it is unpacked. */
void zip_add(struct zip *z, const char *name, const void *data, size_t size, bool runs);

/* Completes the archive, which is z->bytes. False: out of memory. Frees the rest; zip_free frees all. */
bool zip_finish(struct zip *z);
void zip_free(struct zip *z);

/* Was the archive written here? */
bool zip_is_ours(const uint8_t *file, size_t size);

#endif

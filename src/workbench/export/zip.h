/*
 * zip.h - writes zip archives whose bytes depend only on the files: APPNOTE.TXT 6.3, without ZIP64.
 */
#ifndef WORKBENCH_ZIP_H
#define WORKBENCH_ZIP_H

#include "../../common/byte_buffer.h"

/* All zeroes: an empty archive. */
struct zip {
    struct byte_buffer bytes, directory;
    unsigned n;
};

/* Adds a file; its name is UTF-8. runs: the file is a program, executable on Unix after unpacking. */
void zip_add(struct zip *z, const char *name, const void *data, size_t size, bool runs);

/* Completes the archive in z->bytes. Free it with zip_free. False: out of memory. */
bool zip_finish(struct zip *z);
void zip_free(struct zip *z);

/* Returns whether this program wrote the archive. */
bool zip_is_ours(const uint8_t *file, size_t size);

#endif

/*
 * tags.h - checks that OGG and FLAC files are complete, and reads their loop tags.
 */
#ifndef WORKBENCH_TAGS_H
#define WORKBENCH_TAGS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct tags {
    const char *codec;          /* "Vorbis", "Opus", "FLAC" */
    int64_t start, length, end; /* LOOPSTART, LOOPLENGTH, LOOPEND, frames; -1: none */
};

/* Check a file. Errors don't name the file. */
bool tags_ogg(const uint8_t *data, size_t n, struct tags *out, char *err, size_t err_size);
bool tags_flac(const uint8_t *data, size_t n, struct tags *out, char *err, size_t err_size);

#endif

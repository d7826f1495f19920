/*
 * common.h - what the programs of library.sh share: files, chance, TAP.
 */
#ifndef TESTS_MACHINE_LIBRARY_COMMON_H
#define TESTS_MACHINE_LIBRARY_COMMON_H

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../src/lib/curtain.h"

static char err[512];
static uint64_t stream = 1;

static inline uint32_t chance(uint32_t below)
{
    stream = stream * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)((stream >> 33) * (uint64_t)below >> 31);
}

static inline void *read_file(const char *name, size_t *size)
{
    FILE *f = fopen(name, "rb");
    void *bytes = NULL;

    if (!f || fseek(f, 0, SEEK_END) || !(bytes = malloc((*size = (size_t)ftell(f)) + 1)))
        abort();
    rewind(f);
    if (fread(bytes, 1, *size, f) != *size)
        abort();
    fclose(f);
    return bytes;
}

/* The memory is malloc's; free_board frees it. On failure err has the reason. */
static inline struct curtain *open_board(const struct curtain_config *config, void **memory)
{
    size_t size = curtain_memory(config, err, sizeof err);

    *memory = malloc(size);
    return size ? curtain_open(config, *memory, size, err, sizeof err) : NULL;
}

static inline void free_board(struct curtain *c, void *memory)
{
    curtain_close(c);
    free(memory);
}

/* Frames without buttons; returns the last one's events. */
static inline unsigned run_frames(struct curtain *c, int frames)
{
    const uint16_t none[CURTAIN_PADS] = { 0, 0 };
    unsigned events = 0;

    for (int f = 0; f < frames; f++)
        events = curtain_frame(c, none);
    return events;
}

/* The hash after so many frames of a separate run. */
static inline uint64_t hash_alone(const struct curtain_config *config, int frames)
{
    void *memory;
    struct curtain *c = open_board(config, &memory);

    run_frames(c, frames);
    const uint64_t hash = curtain_hash(c);
    free_board(c, memory);
    return hash;
}

/* Any buttons, held for some frames. */
static inline void any_pads(uint16_t pads[CURTAIN_PADS])
{
    if (chance(5) == 0)
        for (int i = 0; i < CURTAIN_PADS; i++)
            pads[i] = (uint16_t)(chance(128) | (chance(60) == 0 ? CURTAIN_START : 0));
}

static inline int check(const char *what, bool good)
{
    printf("%s - %s\n", good ? "ok" : "not ok", what);
    return good ? 0 : 1;
}

#endif

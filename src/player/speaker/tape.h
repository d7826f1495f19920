/*
 * tape.h - records sound: a WAV file in memory.
 */
#ifndef PLAYER_TAPE_H
#define PLAYER_TAPE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../common/byte_buffer.h"

struct board;

struct tape {
    void *tables; /* of board_mix_sound; malloc */
    struct byte_buffer file;
    uint32_t frames; /* stereo frames */
};

/* Starts an empty recording. Returns false when out of memory. Close it either way. */
bool tape_open(struct tape *t);
void tape_close(struct tape *t);

/* Adds the sound of the frame that the board has just ticked. */
void tape_add(struct tape *t, const struct board *b);

/* Completes t->file. Returns false if it ran out of memory. */
bool tape_end(struct tape *t);

/* Calls tape_end and saves the file. On failure, returns false and sets err. */
bool tape_save(struct tape *t, const char *path, char *err, size_t err_size);

#endif

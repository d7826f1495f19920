/*
 * tape.h - sound that is written down: a WAV file in memory.
 */
#ifndef PLAYER_TAPE_H
#define PLAYER_TAPE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct board;

struct tape {
    void *tables;   /* of board_mix_sound; malloc */
    uint8_t *bytes; /* the file; malloc */
    size_t n, room;
    uint32_t frames; /* stereo frames */
    bool failed;     /* out of memory */
};

/* False: out of memory. Close it either way. */
bool tape_open(struct tape *t);
void tape_close(struct tape *t);

/* Adds the sound of the frame that the board has just ticked. */
void tape_add(struct tape *t, const struct board *b);

/* Makes the file whole: its n bytes. False: out of memory. */
bool tape_end(struct tape *t);

/* The same, and writes it. False and one sentence. */
bool tape_save(struct tape *t, const char *path, char *err, size_t err_size);

#endif

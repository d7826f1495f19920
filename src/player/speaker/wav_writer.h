/*
 * wav_writer.h - records a board's sound as a WAV file in memory.
 */
#ifndef PLAYER_WAV_WRITER_H
#define PLAYER_WAV_WRITER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../common/byte_buffer.h"

struct board;

struct wav_writer {
    void *tables; /* of board_mix_sound; malloc */
    struct byte_buffer file;
    uint32_t frames; /* stereo frames */
};

/* Starts an empty recording. Returns false when out of memory. Close it either way. */
bool wav_writer_open(struct wav_writer *t);
void wav_writer_close(struct wav_writer *t);

/* Adds the sound of the frame that the board has just ticked. */
void wav_writer_add(struct wav_writer *t, const struct board *b);

/* Completes t->file. Returns false if it ran out of memory. */
bool wav_writer_end(struct wav_writer *t);

/* Calls wav_writer_end and saves the file. On failure, returns false and sets err. */
bool wav_writer_save(struct wav_writer *t, const char *path, char *err, size_t err_size);

#endif

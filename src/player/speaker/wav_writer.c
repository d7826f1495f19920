/*
 * wav_writer.c - records sound (wav_writer.h).
 */
#include "wav_writer.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../common/result.h"
#include "../../board/board.h"
#include "../../common/files.h"

enum { WAVE_HEADER = 44, WAVE_RATE = 48000 };

bool wav_writer_open(struct wav_writer *t)
{
    *t = (struct wav_writer){ .tables = malloc(board_sound_tables_size()) };
    if (!t->tables || !byte_buffer_take(&t->file, WAVE_HEADER))
        return false;
    board_sound_init_tables(t->tables);
    return true;
}

void wav_writer_close(struct wav_writer *t)
{
    free(t->tables);
    byte_buffer_close(&t->file);
    *t = (struct wav_writer){ 0 };
}

void wav_writer_add(struct wav_writer *t, const struct board *b)
{
    int16_t sound[2 * BOARD_SOUND_FRAMES];
    uint8_t *out = byte_buffer_take(&t->file, sizeof sound);

    if (!out)
        return;
    board_mix_sound(b, t->tables, sound);
    for (int i = 0; i < 2 * BOARD_SOUND_FRAMES; i++, out += 2)
        bytes_put16(out, (uint16_t)sound[i]);
    t->frames += BOARD_SOUND_FRAMES;
}

/* Writes the header of a file with two channels of 16 bits. */
static void wave_header(uint8_t out[WAVE_HEADER], uint32_t frames)
{
    memcpy(out, "RIFF....WAVEfmt ", 16);
    bytes_put32(out + 4, 36 + 4 * frames);
    bytes_put32(out + 16, 16);
    bytes_put16(out + 20, 1);
    bytes_put16(out + 22, 2);
    bytes_put32(out + 24, WAVE_RATE);
    bytes_put32(out + 28, 4 * WAVE_RATE);
    bytes_put16(out + 32, 4);
    bytes_put16(out + 34, 16);
    memcpy(out + 36, "data", 4);
    bytes_put32(out + 40, 4 * frames);
}

bool wav_writer_end(struct wav_writer *t)
{
    if (!t->file.failed)
        wave_header(t->file.bytes, t->frames);
    return !t->file.failed;
}

bool wav_writer_save(struct wav_writer *t, const char *path, char *err, size_t err_size)
{
    if (!wav_writer_end(t))
        return result_set_host_error(err, err_size, "%s: out of memory", path);
    return files_save(path, t->file.bytes, t->file.n, err, err_size);
}

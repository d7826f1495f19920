/*
 * wav.c - see wav.h. A file is chunks: four letters, a length, that many bytes, one more if the length is odd.
 */
#include "wav.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/err.h"
#include "../../snd/adpcm.h"
#include "../../snd/pitch.h"

struct wav {
    const uint8_t *samples;
    uint32_t bytes, rate;
    int channels, bits;
    int64_t loop, loop_end; /* -1: none */
};

/* WAVE_FORMAT_EXTENSIBLE says the format again, at the beginning of a GUID. */
static bool read_format(struct wav *w, const uint8_t *p, uint32_t n, char *err, size_t err_size)
{
    const int format = n >= 16 ? bytes_get16(p) : 0, real = format == 0xfffe && n >= 26 ? bytes_get16(p + 24) : format;

    if (real != 1)
        return err_set(err, err_size, "expected PCM samples (format 1), got format %d", real);
    w->channels = bytes_get16(p + 2);
    w->rate = bytes_get32(p + 4);
    w->bits = bytes_get16(p + 14);
    if (w->channels < 1 || w->channels > 2)
        return err_set(err, err_size, "expected one channel or two, got %d", w->channels);
    if (w->bits != 8 && w->bits != 16 && w->bits != 24 && w->bits != 32)
        return err_set(err, err_size, "expected samples of 8, 16, 24 or 32 bits, got %d", w->bits);
    if (w->rate < SAMPLE_RATE || w->rate > SND_RATE)
        return err_set(err, err_size, "expected %d to %d frames a second, got %" PRIu32 " (save it with %d)",
                       (int)SAMPLE_RATE, (int)SND_RATE, w->rate, (int)SND_RATE);
    return true;
}

/* The first loop of the chunk "smpl". */
static void read_loop(struct wav *w, const uint8_t *p, uint32_t n)
{
    if (n < 36 + 24 || bytes_get32(p + 28) == 0)
        return;
    w->loop = bytes_get32(p + 36 + 8);
    w->loop_end = bytes_get32(p + 36 + 12);
}

static bool read_chunk(struct wav *w, const uint8_t *p, uint32_t n, char *err, size_t err_size)
{
    const uint8_t *body = p + 8;

    if (memcmp(p, "fmt ", 4) == 0)
        return read_format(w, body, n, err, err_size);
    if (memcmp(p, "smpl", 4) == 0)
        read_loop(w, body, n);
    if (memcmp(p, "data", 4) == 0) {
        w->samples = body;
        w->bytes = n;
    }
    return true;
}

static bool read_chunks(struct wav *w, const uint8_t *data, size_t n, char *err, size_t err_size)
{
    *w = (struct wav){ .loop = -1 };
    if (n < 12 || memcmp(data, "RIFF", 4) != 0 || memcmp(data + 8, "WAVE", 4) != 0)
        return err_set(err, err_size, "expected a WAV file (RIFF, WAVE)");
    for (size_t at = 12; at + 8 <= n;) {
        const uint32_t size = bytes_get32(data + at + 4);
        if (size > n - at - 8)
            return err_set(err, err_size, "chunk \"%.4s\" of %" PRIu32 " bytes runs past the end of the file",
                           (const char *)data + at, size);
        if (!read_chunk(w, data + at, size, err, err_size))
            return false;
        at += 8 + (size_t)size + (size & 1);
    }
    if (w->bits == 0)
        return err_set(err, err_size, "it has no chunk \"fmt \"");
    if (w->samples == NULL)
        return err_set(err, err_size, "it has no chunk \"data\"");
    return true;
}

/* One channel of one frame, in 32 bits. */
static int32_t sample_at(const uint8_t *p, int bits)
{
    switch (bits) {
    case 8:
        return (int32_t)((uint32_t)(p[0] ^ 128) << 24);
    case 16:
        return (int32_t)((uint32_t)bytes_get16(p) << 16);
    case 24:
        return (int32_t)((uint32_t)bytes_get16(p) << 8 | (uint32_t)p[2] << 24);
    default:
        return (int32_t)bytes_get32(p);
    }
}

/* A frame as 16 bits, rounded; two channels are their mean. */
static int16_t frame_at(const struct wav *w, size_t i)
{
    const size_t one = (size_t)w->bits / 8;
    const uint8_t *p = w->samples + i * one * (size_t)w->channels;
    const int64_t left = sample_at(p, w->bits), right = w->channels == 2 ? sample_at(p + one, w->bits) : left;
    const int64_t v = (left + right + 0x10000) >> 17;

    return (int16_t)(v > 32767 ? 32767 : v);
}

bool wav_read(const uint8_t *data, size_t n, uint8_t **out, size_t *size, char *err, size_t err_size)
{
    struct wav w;

    if (!read_chunks(&w, data, n, err, err_size))
        return false;
    size_t frames = w.bytes / ((size_t)w.bits / 8 * (size_t)w.channels);
    if (w.loop >= 0 && (w.loop_end < w.loop || (uint64_t)w.loop_end >= frames))
        return err_set(err, err_size, "its loop, %" PRId64 " to %" PRId64 ", is not within its %zu frames", w.loop,
                       w.loop_end, frames);
    if (w.loop >= 0)
        frames = (size_t)w.loop_end + 1;
    if (frames < 1 || frames > SAMPLE_MOST)
        return err_set(err, err_size, "expected 1 to %d frames, got %zu", (int)SAMPLE_MOST, frames);
    int16_t *in = malloc(frames * sizeof *in);
    *size = sample_size((uint32_t)frames);
    *out = malloc(*size);
    for (size_t i = 0; in && *out && i < frames; i++)
        in[i] = frame_at(&w, i);
    if (in && *out)
        sample_write(*out, in, (uint32_t)frames, w.rate, w.loop >= 0 ? (uint32_t)w.loop : SAMPLE_ENDS);
    else
        free(*out);
    const bool good = in && *out;
    free(in);
    return good ? true : err_set(err, err_size, "out of memory");
}

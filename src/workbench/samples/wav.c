/*
 * wav.c - see pcm.h. A file consists of chunks: four letters, a length, that many bytes, and a padding byte if the
 * length is odd. The total length in the header is ignored, as players do, because many programs write a wrong one. The
 * last chunk shows whether a file is truncated.
 */
#include "pcm.h"

#include <inttypes.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/err.h"
#include "../../sound/adpcm.h"

enum { INTEGERS = 1, FLOATS = 3 };
#define UNFINISHED 0x7ffff000u /* programs that write to a pipe use such lengths, or 0 */

struct wav {
    const uint8_t *samples;
    uint32_t bytes, rate;
    int format, channels, bits;
    int64_t loop, loop_end; /* -1: none; its last frame */
};

/* WAVE_FORMAT_EXTENSIBLE repeats the format at the start of a GUID. */
static bool read_format(struct wav *w, const uint8_t *p, uint32_t n, char *err, size_t err_size)
{
    const int format = n >= 16 ? bytes_get16(p) : 0,
              format_tag = format == 0xfffe && n >= 26 ? bytes_get16(p + 24) : format;

    if (format_tag != INTEGERS && format_tag != FLOATS)
        return err_set(err, err_size, "expected PCM samples (format 1: integers, or format 3: floats), got format %d",
                       format_tag);
    w->format = format_tag;
    w->channels = bytes_get16(p + 2);
    w->rate = bytes_get32(p + 4);
    w->bits = bytes_get16(p + 14);
    if (w->channels < 1 || w->channels > 2)
        return err_set(err, err_size, "expected one or two channels, got %d", w->channels);
    if (format_tag == FLOATS && w->bits != 32)
        return err_set(err, err_size, "expected 32-bit floats, got %d bits", w->bits);
    if (w->bits != 8 && w->bits != 16 && w->bits != 24 && w->bits != 32)
        return err_set(err, err_size, "expected samples of 8, 16, 24 or 32 bits, got %d", w->bits);
    if (w->rate < SAMPLE_MIN_RATE || w->rate > PCM_RATE)
        return err_set(err, err_size, "expected a sample rate of %d to %d Hz, got %" PRIu32, (int)SAMPLE_MIN_RATE,
                       (int)PCM_RATE, w->rate);
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
    const uint32_t riff = bytes_get32(data + 4);
    const bool unfinished = riff == 0 || riff >= UNFINISHED;
    size_t at = 12;
    while (at + 8 <= n) {
        const size_t left = n - at - 8;
        uint32_t size = bytes_get32(data + at + 4);
        if (unfinished && memcmp(data + at, "data", 4) == 0 && (size == 0 || size >= UNFINISHED))
            size = (uint32_t)left;
        if (size > left && w->samples && at >= 8 + (size_t)riff)
            break; /* after the RIFF chunk */
        if (size > left)
            return err_set(err, err_size, "chunk \"%.4s\" of %" PRIu32 " bytes is longer than the file",
                           (const char *)data + at, size);
        if (!read_chunk(w, data + at, size, err, err_size))
            return false;
        at += 8 + (size_t)size + (size & 1);
    }
    if (at < n && at < 8 + (size_t)riff && !unfinished)
        return err_set(err, err_size, "truncated inside a chunk");
    if (w->bits == 0)
        return err_set(err, err_size, "no chunk \"fmt \"");
    if (w->samples == NULL)
        return err_set(err, err_size, "no chunk \"data\"");
    return true;
}

/* Returns a sample; full scale is -1 to 1. */
static float sample_at(const struct wav *w, const uint8_t *p)
{
    const uint32_t word = w->bits == 32 ? bytes_get32(p) : 0;
    float v;

    if (w->format == FLOATS) {
        memcpy(&v, &word, sizeof v);
        return v;
    }
    switch (w->bits) {
    case 8:
        return (float)(p[0] - 128) / 128;
    case 16:
        return (float)(int16_t)bytes_get16(p) / 32768;
    case 24:
        return (float)((int32_t)((uint32_t)bytes_get16(p) << 8 | (uint32_t)p[2] << 24) >> 8) / 8388608;
    default:
        return (float)((double)(int32_t)word / 2147483648.0);
    }
}

enum { BLOCK = 1024 /* frames at a time */ };

static bool read_frames(const struct wav *w, struct pcm *out)
{
    const size_t sample_bytes = (size_t)w->bits / 8, frame_bytes = sample_bytes * (size_t)w->channels,
                 frames = w->bytes / frame_bytes;
    float block[BLOCK * PCM_CHANNELS] = { 0 };

    for (size_t at = 0, n; at < frames; at += n) {
        n = frames - at < BLOCK ? frames - at : BLOCK;
        for (size_t i = 0; i < n * (size_t)w->channels; i++)
            block[i] = sample_at(w, w->samples + at * frame_bytes + i * sample_bytes);
        if (!pcm_add(out, block, n))
            return false;
    }
    return true;
}

bool pcm_read_wav(const uint8_t *data, size_t n, struct pcm *out, char *err, size_t err_size)
{
    struct wav w;

    *out = (struct pcm){ .loop = -1, .loop_end = -1 };
    if (!read_chunks(&w, data, n, err, err_size))
        return false;
    out->rate = w.rate;
    out->channels = w.channels;
    out->loop = w.loop;
    out->loop_end = w.loop < 0 ? -1 : w.loop_end + 1;
    if (read_frames(&w, out))
        return true;
    pcm_free(out);
    return err_set(err, err_size, "too long: more than %d frames", (int)SAMPLE_MAX_LENGTH);
}

/*
 * sndfile.c - see pcm.h. libsndfile reads damaged data as silence or as the end, and reads dozens of formats, so
 * tags.c checks files first. The library is opened when a file needs it (library.h). The declarations are those of
 * sndfile.h, version 1.
 */
#include "pcm.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "../../base/err.h"
#include "../../sound/adpcm.h"
#include "../../common/library.h"
#include "tags.h"

/* ---- libsndfile ---- */

typedef struct sndfile SNDFILE;
typedef int64_t sf_count_t;

typedef struct {
    sf_count_t frames;
    int samplerate, channels, format, sections, seekable;
} SF_INFO;

typedef struct {
    sf_count_t (*size)(void *user);
    sf_count_t (*seek)(sf_count_t by, int whence, void *user);
    sf_count_t (*read)(void *to, sf_count_t n, void *user);
    sf_count_t (*write)(const void *from, sf_count_t n, void *user);
    sf_count_t (*tell)(void *user);
} SF_VIRTUAL_IO;

enum { SFM_READ = 0x10 };

struct functions {
    SNDFILE *(*open)(SF_VIRTUAL_IO *io, int mode, SF_INFO *info, void *user);
    int (*close)(SNDFILE *file);
    sf_count_t (*read)(SNDFILE *file, float *to, sf_count_t frames);
    int (*error)(SNDFILE *file);
    const char *(*error_text)(SNDFILE *file);
};

static bool load_functions(struct functions *f)
{
    const struct library_function list[] = { { "sf_open_virtual", &f->open },
                                             { "sf_close", &f->close },
                                             { "sf_readf_float", &f->read },
                                             { "sf_error", &f->error },
                                             { "sf_strerror", &f->error_text } };

    return library_open(LIBRARY_SNDFILE, list, sizeof list / sizeof *list);
}

/* ---- a file in memory ---- */

struct memory {
    const uint8_t *data;
    sf_count_t n, position;
};

static sf_count_t memory_size(void *user)
{
    return ((struct memory *)user)->n;
}

static sf_count_t memory_seek(sf_count_t by, int whence, void *user)
{
    struct memory *m = user;
    const sf_count_t to = by + (whence == SEEK_SET ? 0 : whence == SEEK_CUR ? m->position : m->n);

    m->position = to < 0 ? 0 : to > m->n ? m->n : to;
    return m->position;
}

static sf_count_t memory_read(void *to, sf_count_t n, void *user)
{
    struct memory *m = user;

    if (n > m->n - m->position)
        n = m->n - m->position;
    if (n <= 0)
        return 0;
    memcpy(to, m->data + m->position, (size_t)n);
    m->position += n;
    return n;
}

static sf_count_t memory_write(const void *from, sf_count_t n, void *user)
{
    (void)from, (void)n, (void)user;
    return 0;
}

static sf_count_t memory_tell(void *user)
{
    return ((struct memory *)user)->position;
}

/* ---- a recording ---- */

enum { BLOCK = 1024 /* frames at a time */ };
#define LENGTH_UNKNOWN INT64_MAX /* of a FLAC file that was written to a pipe */

static bool read_frames(const struct functions *f, SNDFILE *file, sf_count_t promised, struct pcm *out, char *err,
                        size_t err_size)
{
    float block[BLOCK * PCM_CHANNELS] = { 0 };

    for (sf_count_t n; (n = f->read(file, block, BLOCK)) > 0;)
        if (!pcm_add(out, block, (size_t)n))
            return err_set(err, err_size, "too long: more than %d frames", (int)SAMPLE_MAX_LENGTH);
    if (f->error(file) != 0)
        return err_set(err, err_size, "damaged after frame %" PRIu32 " (%s)", out->n, f->error_text(file));
    if (promised != LENGTH_UNKNOWN && out->n != promised)
        return err_set(err, err_size, "its header says %" PRId64 " frames, but the file has %" PRIu32,
                       (int64_t)promised, out->n);
    return true;
}

static bool check_info(const SF_INFO *info, char *err, size_t err_size)
{
    if (info->channels < 1 || info->channels > PCM_CHANNELS)
        return err_set(err, err_size, "expected one or two channels, got %d", info->channels);
    if (info->samplerate < SAMPLE_MIN_RATE || info->samplerate > PCM_RATE)
        return err_set(err, err_size, "expected a sample rate of %d to %d Hz, got %d", (int)SAMPLE_MIN_RATE,
                       (int)PCM_RATE, info->samplerate);
    return true;
}

static bool decode(const struct functions *f, const uint8_t *data, size_t n, struct pcm *out, char *err,
                   size_t err_size)
{
    SF_VIRTUAL_IO io = { memory_size, memory_seek, memory_read, memory_write, memory_tell };
    struct memory memory = { data, (sf_count_t)n, 0 };
    SF_INFO info = { 0 };
    SNDFILE *file = f->open(&io, SFM_READ, &info, &memory);

    if (!file)
        return err_set(err, err_size, "cannot be read (%s)", f->error_text(NULL));
    bool good = check_info(&info, err, err_size);
    if (good) {
        out->channels = info.channels;
        out->rate = (uint32_t)info.samplerate;
        good = read_frames(f, file, info.frames, out, err, err_size);
    }
    f->close(file);
    return good;
}

/* Sets the loop from the tags. */
static void set_loop(const struct tags *t, struct pcm *out)
{
    const int64_t divisor = strcmp(t->codec, "Opus") == 0 ? 48000 / (int64_t)out->rate : 1;

    if (t->start < 0 && t->length < 0 && t->end < 0)
        return;
    out->loop = (t->start < 0 ? 0 : t->start) / divisor;
    out->loop_end = t->length >= 0 ? out->loop + t->length / divisor : t->end >= 0 ? t->end / divisor : -1;
}

bool pcm_read_sndfile(const uint8_t *data, size_t n, struct pcm *out, char *err, size_t err_size)
{
    struct functions f;
    struct tags t;

    *out = (struct pcm){ .loop = -1, .loop_end = -1 };
    if (!(n > 4 && memcmp(data, "fLaC", 4) == 0 ? tags_flac : tags_ogg)(data, n, &t, err, err_size))
        return false;
    if (!load_functions(&f))
        return library_missing(LIBRARY_SNDFILE, err, err_size);
    if (!decode(&f, data, n, out, err, err_size)) {
        pcm_free(out);
        return false;
    }
    set_loop(&t, out);
    return true;
}

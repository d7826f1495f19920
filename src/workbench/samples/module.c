/*
 * module.c - see pcm.h. The first pass starts in silence. The second pass also contains notes that ring on from the
 * first pass, so usually the third pass equals the second to the last bit, and this pass is the loop. A loop that
 * equals the end of the samples before it is not stored twice. If no pass equals the previous one, or the next one is
 * too long to store, the last pass is the loop.
 */
#include "pcm.h"

#include <string.h>
#include "../../base/err.h"
#include "../../sound/adpcm.h"
#include "../../sound/pitch.h"
#include "../../common/library.h"

/* ---- libopenmpt, as its version 0 declares it in libopenmpt.h ---- */

typedef struct openmpt_module openmpt_module;
typedef void (*openmpt_log_func)(const char *message, void *user);
typedef int (*openmpt_error_func)(int error, void *user);

typedef struct {
    const char *ctl, *value;
} openmpt_module_initial_ctl;

enum { OPENMPT_ERROR_FUNC_RESULT_NONE = 0 };

struct functions {
    openmpt_module *(*open)(const void *data, size_t n, openmpt_log_func log, void *log_user, openmpt_error_func fail,
                            void *fail_user, int *error, const char **message, const openmpt_module_initial_ctl *ctls);
    void (*close)(openmpt_module *module);
    size_t (*read)(openmpt_module *module, int32_t rate, size_t frames, float *to);
    double (*duration)(openmpt_module *module);
    double (*tempo)(openmpt_module *module);
};

static bool load_functions(struct functions *f)
{
    const struct library_function list[] = { { "openmpt_module_create_from_memory2", &f->open },
                                             { "openmpt_module_destroy", &f->close },
                                             { "openmpt_module_read_interleaved_float_stereo", &f->read },
                                             { "openmpt_module_get_duration_seconds", &f->duration },
                                             { "openmpt_module_get_current_estimated_bpm", &f->tempo } };

    return library_open(LIBRARY_OPENMPT, list, sizeof list / sizeof *list);
}

/* Errors are also return values. */
static int ignore(int error, void *user)
{
    (void)error, (void)user;
    return OPENMPT_ERROR_FUNC_RESULT_NONE;
}

enum { BLOCK = 1024 /* frames at a time */, PASSES = 4 /* at most, until one equals the previous one */ };

/* Renders from the module's current position to its end. */
static bool read_pass(const struct functions *f, openmpt_module *module, struct pcm *pass, char *err, size_t err_size)
{
    float block[BLOCK * PCM_CHANNELS] = { 0 };

    *pass = (struct pcm){ .rate = SND_RATE, .channels = PCM_CHANNELS, .loop = -1, .loop_end = -1 };
    for (size_t n; (n = f->read(module, SND_RATE, BLOCK, block)) > 0;)
        if (!pcm_add(pass, block, n))
            return err_set(err, err_size, "too long: more than %d frames", (int)SAMPLE_MAX_LENGTH);
    return pass->n > 0 ? true : err_set(err, err_size, "it contains no music");
}

/* Returns whether p ends with the same frames. */
static bool ends_with(const struct pcm *p, const struct pcm *pass)
{
    const size_t frame = PCM_CHANNELS * sizeof *p->frames;

    return p->n >= pass->n &&
           memcmp(p->frames + (size_t)(p->n - pass->n) * PCM_CHANNELS, pass->frames, pass->n * frame) == 0;
}

/* Adds passes until one equals the previous one, which becomes the loop. */
static bool read_loop(const struct functions *f, openmpt_module *module, struct pcm *out, char *err, size_t err_size)
{
    bool good = true, more = true;

    out->loop = 0;
    for (int i = 1; good && more && i < PASSES; i++) {
        struct pcm pass;
        good = read_pass(f, module, &pass, err, err_size);
        if (good && ends_with(out, &pass)) {
            out->loop = (int64_t)out->n - pass.n;
            more = false;
        } else if (good) {
            const uint32_t start = out->n;
            more = pcm_join(out, &pass);
            if (more)
                out->loop = start;
        }
        pcm_free(&pass);
    }
    return good;
}

static bool decode(const struct functions *f, openmpt_module *module, bool loops, struct pcm *out, char *err,
                   size_t err_size)
{
    const double seconds = f->duration(module), max = (double)SAMPLE_MAX_LENGTH / SND_RATE;

    if (!(seconds > 0 && seconds <= max))
        return err_set(err, err_size, "expected music of at most %.0f s, got %.1f", max, seconds);
    const double tempo = f->tempo(module); /* of its start */
    if (!read_pass(f, module, out, err, err_size))
        return false;
    out->tempo = tempo;
    return !loops || read_loop(f, module, out, err, err_size);
}

bool pcm_read_module(const uint8_t *data, size_t n, bool loops, struct pcm *out, char *err, size_t err_size)
{
    static const openmpt_module_initial_ctl ctls[] = { { "play.at_end", "continue" }, { NULL, NULL } };
    struct functions f;

    *out = (struct pcm){ .loop = -1, .loop_end = -1 };
    if (!load_functions(&f))
        return library_missing(LIBRARY_OPENMPT, err, err_size);
    openmpt_module *module = f.open(data, n, NULL, NULL, ignore, NULL, NULL, NULL, ctls);
    if (!module)
        return err_set(err, err_size, "libopenmpt does not recognise this file, or the file is damaged");
    const bool good = decode(&f, module, loops, out, err, err_size);
    f.close(module);
    if (!good)
        pcm_free(out);
    return good;
}

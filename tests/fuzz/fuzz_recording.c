/*
 * fuzz_recording.c - libFuzzer: any bytes as a recording, of whichever kind they say they are. What is read becomes a
 * sound and a piece of music that the board takes; what is refused says why. Modules take libopenmpt the most time, and
 * are small here.
 */
#include "../../src/workbench/samples/recording.h"
#include "../../src/sound/adpcm.h"
#include "../../src/sound/tune.h"
#include "fuzz.h"

static const char *name_of(const uint8_t *data, size_t size)
{
    if (size >= 4 && memcmp(data, "RIFF", 4) == 0)
        return "x.wav";
    if (size >= 4 && memcmp(data, "OggS", 4) == 0)
        return "x.ogg";
    return size >= 4 && memcmp(data, "fLaC", 4) == 0 ? "x.flac" : "x.xm";
}

static void make(const struct pcm *pcm)
{
    static const struct art_marker marker = { "start", 0 };
    const struct art_sound about = { .volume = 255,
                                     .priority = 4,
                                     .limit = 2,
                                     .beats_per_bar = 4,
                                     .stereo = true,
                                     .exact = pcm->n > 2000,
                                     .n_markers = 1 };
    struct recording_bytes tune, wave;
    char err[256] = "";

    need(recording_sound(pcm, &about, &tune, err, sizeof err));
    need(tune_validate(tune.data, tune.n, err, sizeof err));
    free(tune.data);
    need(recording_music(pcm, &about, &marker, &tune, &wave, err, sizeof err));
    need(tune_validate(tune.data, tune.n, err, sizeof err));
    need(samples_are_valid(wave.data, wave.n, tune_of(tune.data).channels));
    free(tune.data);
    free(wave.data);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const struct art_loop own = { 0 };
    const char *name = name_of(data, size);
    uint8_t *copy = fuzz_copy(data, size);
    char err[256] = "";
    struct pcm pcm;

    if (!copy || (strcmp(name, "x.xm") == 0 && size > 4096)) {
        free(copy);
        return 0;
    }
    if (recording_read(name, copy, size, &own, &pcm, err, sizeof err)) {
        if (recording_prepare(&pcm, &own, err, sizeof err))
            make(&pcm);
        else
            need(err[0]);
        pcm_free(&pcm);
    } else {
        need(err[0]);
    }
    free(copy);
    return 0;
}

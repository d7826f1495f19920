/*
 * fuzz_sound.c - libFuzzer: any bytes as MML, and as a tune of a ROM. What is read is a tune that the board takes; what
 * is refused says why, of MML with file, line and column. A tune that is taken is played, its instruments are heard.
 */
#include "../../src/workbench/mml/mml.h"
#include "../../src/sound/pitch.h"
#include "../../src/sound/tune.h"
#include "../voiced.h"
#include "fuzz.h"

static void play(const uint8_t *bytes)
{
    static struct snd_tables tables;
    const struct tune t = tune_of(bytes);

    if (tables.music_volume == 0)
        snd_tables_make(&tables);
    voiced(&t, &tables);
    for (int k = -1; k < t.n_tracks; k++) {
        struct track_cursor c = tune_track_start(&t, k);
        for (int f = 0; f < 20; f++) {
            struct tune_run run = { &t, k, c, t.tempo, 0, SND_FRAME, 0 };
            struct tune_played_event e;
            while (tune_next_event(&run, &e))
                need(e.event < TUNE_EVENTS && e.sample >= 0 && e.sample < SND_FRAME);
            c = run.cursor;
        }
    }
}

static void as_mml(const uint8_t *data, size_t size)
{
    const struct mml_settings settings = { .volume = 255, .priority = 4, .limit = 2, .title = "" };
    uint8_t *out;
    char err[256] = "";
    size_t n;

    if (!mml_compile((const char *)data, size, "x.mml", &settings, &out, &n, err, sizeof err)) {
        need(strncmp(err, "x.mml:", 6) == 0 && strlen(err) > 9);
        return;
    }
    need(tune_validate(out, n, err, sizeof err));
    play(out);
    free(out);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    uint8_t *copy = fuzz_copy(data, size);
    char err[256] = "";

    as_mml(copy, size);
    if (tune_validate(copy, size, err, sizeof err))
        play(copy);
    else
        need(err[0]);
    free(copy);
    return 0;
}

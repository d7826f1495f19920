/*
 * check_recordings.c - samples that cannot be read, clip, have a DC offset, or have a loop that clicks or is not a
 * whole number of beats long.
 */
#include "check_parts.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include "../samples/flaws.h"
#include "../samples/recording.h"

static const double mean_most = 0.02, beats_most = 0.01;

static void report_flaws(struct check *c, const char *file, uint32_t rate, const struct flaws *f)
{
    if (f->clipped)
        diagnostics_add(&c->found, file, 0,
                        "%" PRIu32 " samples clip, the first at %.3f s: the recording itself is too loud", f->clipped,
                        (double)f->first_clipped / rate);
    if (fabs(f->dc_offset) > mean_most)
        diagnostics_add(&c->found, file, 0,
                        "its mean is %.1f %% of full scale (DC offset), so it clicks at its start and end",
                        f->dc_offset * 100);
}

static void report_loop(struct check *c, const struct art_sound *s, const struct pcm *p, const struct flaws *f)
{
    if (f->clicks)
        diagnostics_add(&c->found, s->file, 0,
                        "its loop clicks: from the loop's end (%.3f s) to its start (%.3f s), the signal jumps by "
                        "%.1f %% of full scale; elsewhere, it jumps by at most %.1f %%",
                        (double)p->n / p->rate, (double)p->loop / p->rate, f->jump * 100, f->nearby * 100);
    if (p->loop < 0 || s->tempo == 0)
        return;
    const double beats = (double)(p->n - p->loop) / p->rate * s->tempo / 6000;
    if (fabs(beats - round(beats)) > beats_most)
        diagnostics_add(&c->found, s->file, 0,
                        "its loop is %.2f beats long at tempo %g, so music.beat drifts away from the sound", beats,
                        s->tempo / 100.0);
}

/* The packer reports missing files. */
static void check_recording(struct check *c, const struct art_sound *s)
{
    struct pcm p;
    struct flaws f;
    char why[256];
    uint8_t *data;
    size_t n;

    if (!art_is_recording(s->file) || !tree_has(&c->files, s->file) || !check_load(c, s->file, TREE_FILE, &data, &n))
        return;
    bool good = recording_read(s->file, data, n, &s->loop, &p, why, sizeof why);
    free(data);
    if (good) {
        flaws_measure_frames(&p, &f);
        report_flaws(c, s->file, p.rate, &f);
        good = recording_prepare(&p, &s->loop, why, sizeof why);
        if (good) {
            flaws_measure_loop(&p, &f);
            report_loop(c, s, &p, &f);
        }
        pcm_free(&p);
    }
    if (!good) {
        diagnostics_add(&c->found, s->file, 0, "%s", why);
        c->broken = true;
    }
}

void check_recordings(struct check *c)
{
    if (!c->manifest)
        return;
    for (int i = 0; i < c->art.n_sounds; i++)
        check_recording(c, &c->art.sounds[i]);
    for (int i = 0; i < c->art.n_tunes; i++)
        check_recording(c, &c->art.tunes[i]);
}

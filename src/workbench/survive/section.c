/*
 * section.c - see section.h.
 */
#include "section.h"

#include "../../base/err.h"
#include "../../common/result.h"

enum { AFTER = 30 /* frames that the course goes on where no way was found */ };

static uint16_t held(const struct section_run *s, uint32_t f)
{
    if (f < s->seek.frames)
        return s->seek.pads[f];
    return trial_steers(&s->trial) ? PAD_FIRE : trial_press(&s->trial);
}

/* Runs it once more, and writes down what happens while it is steered. */
static bool run_again(struct section_run *s, struct trial_mark *start)
{
    struct trial *t = &s->trial;
    const uint32_t more = section_survived(s) ? 0 : AFTER, lived = s->seek.frames;
    const uint32_t want = s->seek.last > lived ? s->seek.last : lived;
    enum trial_end end = TRIAL_ON;

    if (!trial_again(t, s->err, sizeof s->err))
        return false;
    for (uint32_t f = 0; f < want + more && end == TRIAL_ON; f++) {
        const uint16_t pads[MAX_PLAYERS] = { held(s, f), 0 };
        if (f == s->seek.begin) {
            if (!trial_save(t, start))
                return result_set_host_error(s->err, sizeof s->err, "out of memory");
            s->x = start->ship.path.x;
            s->y = start->ship.path.y;
            forecast_clear(&s->course, f);
            t->into = &s->course;
        }
        if (f >= lived)
            danger_set_invincible(t->b, true);
        end = trial_tick(t, pads);
    }
    t->into = NULL;
    return true;
}

bool section_look(struct section_run *s, const struct rom *rom, const struct board_start *start, bool measured,
                  bool *host)
{
    struct trial_mark mark = { 0 };

    *host = false;
    if (!trial_open(&s->trial, rom, start, s->err, sizeof s->err))
        return false;
    s->seek.t = &s->trial;
    seek_run(&s->seek);
    *host = s->seek.verdict == SEEK_NO_MEMORY;
    if (*host)
        return result_set_host_error(s->err, sizeof s->err, "out of memory");
    if (s->seek.verdict == SEEK_FAULT || s->seek.verdict == SEEK_NO_SHIP)
        return true;
    bool good = run_again(s, &mark);
    if (good && measured) {
        if (section_survived(s))
            measure_run(&s->measure, &s->course, s->x, s->y);
        *host = !mark.at || !bots_play(&s->trial, &mark, s->seek.limit, &s->measure.bots);
        good = !*host || result_set_host_error(s->err, sizeof s->err, "out of memory");
    }
    trial_mark_free(&mark);
    return good;
}

bool section_fly(struct section_run *s, const struct rom *rom, const struct board_start *start, int bots, bool *host)
{
    struct trial_mark mark = { 0 };

    *host = false;
    if (!trial_open(&s->trial, rom, start, s->err, sizeof s->err))
        return false;
    s->trial.parts = true;
    s->seek.t = &s->trial;
    if (!seek_begin(&s->seek)) {
        *host = s->seek.verdict == SEEK_NO_MEMORY;
        return !*host || result_set_host_error(s->err, sizeof s->err, "out of memory");
    }
    s->seek.verdict = SEEK_BOTS;
    *host = !trial_save(&s->trial, &mark) || !bots_play_on(&s->trial, &mark, s->seek.limit, bots, &s->measure.bots);
    if (s->measure.bots.fault)
        s->seek.verdict = SEEK_FAULT;
    trial_mark_free(&mark);
    return !*host || result_set_host_error(s->err, sizeof s->err, "out of memory");
}

void section_close(struct section_run *s)
{
    seek_close(&s->seek);
    forecast_close(&s->course);
    trial_close(&s->trial);
}

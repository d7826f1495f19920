/*
 * section.c - see section.h.
 */
#include "section.h"

#include "../../base/err.h"
#include "../../common/result.h"

enum { FRAMES_AFTER_HIT = 30 /* frames that the forecast continues after the hit */ };

static uint16_t choose_pads(const struct section_run *s, uint32_t f)
{
    if (f < s->search.frames)
        return s->search.pads[f];
    return simulation_can_steer(&s->simulation) ? PAD_FIRE : simulation_menu_pads(&s->simulation);
}

/* Repeats the longest run and records its forecast. */
static bool replay_run(struct section_run *s, struct simulation_state *start)
{
    struct simulation *t = &s->simulation;
    const uint32_t more = section_survived(s) ? 0 : FRAMES_AFTER_HIT, lived = s->search.frames;
    const uint32_t want = s->search.last > lived ? s->search.last : lived;
    enum simulation_end end = SIMULATION_RUNNING;

    if (!simulation_restart(t, s->err, sizeof s->err))
        return false;
    for (uint32_t f = 0; f < want + more && end == SIMULATION_RUNNING; f++) {
        const uint16_t pads[MAX_PLAYERS] = { choose_pads(s, f), 0 };
        if (f == s->search.begin) {
            if (!simulation_save(t, start))
                return result_set_host_error(s->err, sizeof s->err, "out of memory");
            s->x = start->ship.path.x;
            s->y = start->ship.path.y;
            forecast_clear(&s->forecast, f);
            t->recording = &s->forecast;
        }
        if (f >= lived)
            danger_set_invincible(t->b, true);
        end = simulation_tick(t, pads);
    }
    t->recording = NULL;
    return true;
}

bool section_search(struct section_run *s, const struct rom *rom, const struct board_start *start, bool *host)
{
    struct simulation_state mark = { 0 };

    *host = false;
    if (!simulation_open(&s->simulation, rom, start, s->err, sizeof s->err))
        return false;
    s->search.t = &s->simulation;
    search_run(&s->search);
    *host = s->search.verdict == SEARCH_NO_MEMORY;
    if (*host)
        return result_set_host_error(s->err, sizeof s->err, "out of memory");
    if (s->search.verdict == SEARCH_FAULT || s->search.verdict == SEARCH_NO_SHIP)
        return true;
    bool good = replay_run(s, &mark);
    if (good) {
        if (section_survived(s))
            measure_run(&s->measure, &s->forecast, s->x, s->y);
        *host = !mark.snapshot || !bots_play(&s->simulation, &mark, s->search.limit, &s->measure.bots);
        good = !*host || result_set_host_error(s->err, sizeof s->err, "out of memory");
    }
    simulation_state_free(&mark);
    return good;
}

bool section_play_bots(struct section_run *s, const struct rom *rom, const struct board_start *start, int bots,
                       bool *host)
{
    struct simulation_state mark = { 0 };

    *host = false;
    if (!simulation_open(&s->simulation, rom, start, s->err, sizeof s->err))
        return false;
    s->simulation.stop_at_marks = true;
    s->search.t = &s->simulation;
    if (!search_begin(&s->search)) {
        *host = s->search.verdict == SEARCH_NO_MEMORY;
        return !*host || result_set_host_error(s->err, sizeof s->err, "out of memory");
    }
    s->search.verdict = SEARCH_BOTS;
    *host = !simulation_save(&s->simulation, &mark) ||
            !bots_play_invincible(&s->simulation, &mark, s->search.limit, bots, &s->measure.bots);
    if (s->measure.bots.fault)
        s->search.verdict = SEARCH_FAULT;
    simulation_state_free(&mark);
    return !*host || result_set_host_error(s->err, sizeof s->err, "out of memory");
}

void section_close(struct section_run *s)
{
    search_close(&s->search);
    forecast_close(&s->forecast);
    simulation_close(&s->simulation);
}

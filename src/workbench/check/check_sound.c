/*
 * check_sound.c - sounds and music: unknown names in scripts; and in a run, frames whose mix is too loud, and sounds
 * that are cut off because other sounds take their voice.
 */
#include "check_parts.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/edit.h"
#include "../../board/board.h"

/* ---- names ---- */

/* Functions whose first argument is the name of a sound or a piece of music. */
static const struct {
    const char *space, *name;
    bool music;
} namers[] = { { "sound", "play", false }, { "sound", "stop", false }, { "music", "play", true } };

static void look_up(struct check *c, const char *path, const struct symbol_call *call, bool music)
{
    const struct art_sound *list = music ? c->art.tunes : c->art.sounds;
    const int n = music ? c->art.n_tunes : c->art.n_sounds;
    const char *name = call->arg[0];
    struct edit_nearest near = { .word = name };

    for (int i = 0; i < n; i++) {
        if (strcmp(name, list[i].name) == 0)
            return;
        edit_consider(&near, list[i].name);
    }
    diagnostics_add(&c->found, path, call->line, "%s.%s: unknown %s \"%s\"%s%s%s", call->space, call->name,
                    music ? "music" : "sound", name, near.found ? " (did you mean \"" : "",
                    near.found ? near.found : "", near.found ? "\"?)" : "");
}

void check_sounds(struct check *c)
{
    if (!c->manifest || !c->m.has_sound)
        return;
    for (int i = 0; i < c->n_scripts; i++)
        for (int k = 0; k < c->scripts[i].symbols.n_calls; k++) {
            const struct symbol_call *call = &c->scripts[i].symbols.calls[k];
            for (size_t n = 0; n < sizeof namers / sizeof *namers && call->arg[0]; n++)
                if (symbol_call_is(call, namers[n].space, namers[n].name))
                    look_up(c, c->scripts[i].path, call, namers[n].music);
        }
}

/* ---- a run ---- */

enum {
    SLOTS = 32,
    FULL = 27913, /* the output of the limiter for a mix at full scale (wave.h) */
    RARELY = 100, /* one frame in 100 may be above */
    FEW = 10,     /* starts of a sound that are too few to report */
    TENTH = 10    /* one in 10 may be cut off */
};

struct heard_sound {
    char name[64];
    uint32_t began, lost, first;
};

struct check_heard {
    void *tables;
    uint32_t frames, over, first;
    int n;
    struct heard_sound sound[256];
    int slot[SLOTS]; /* the sound of each voice, or -1 */
};

static void restart(struct check_heard *h)
{
    void *tables = h->tables;

    memset(h, 0, sizeof *h);
    h->tables = tables;
    for (int i = 0; i < SLOTS; i++)
        h->slot[i] = -1;
}

struct check_heard *check_heard_open(void)
{
    struct check_heard *h = calloc(1, sizeof *h);

    if (h == NULL)
        return NULL;
    h->tables = malloc(board_sound_tables_size());
    if (h->tables == NULL) {
        free(h);
        return NULL;
    }
    board_sound_init_tables(h->tables);
    restart(h);
    return h;
}

static int index_of(struct check_heard *h, const char *name)
{
    int i = 0;

    while (i < h->n && strcmp(h->sound[i].name, name) != 0)
        i++;
    if (i == (int)(sizeof h->sound / sizeof *h->sound) || strlen(name) >= sizeof h->sound[i].name)
        return -1;
    if (i == h->n)
        strcpy(h->sound[h->n++].name, name);
    return i;
}

static void lose(struct check_heard *h, int i, uint32_t frame)
{
    if (i >= 0 && h->sound[i].lost++ == 0)
        h->sound[i].first = frame;
}

/* Returns whether a sound of the same name started in the frame. */
static bool restarted(const struct check_heard *h, const struct board_cue *cues, int n, int of, uint32_t frame)
{
    for (int i = 0; i < n; i++)
        if (cues[i].name && cues[i].start_frame == frame && strcmp(cues[i].name, h->sound[of].name) == 0)
            return true;
    return false;
}

/* Counts voices that another sound took before their end. A sound of the same name takes it because of its limit. */
static void note_slots(struct check_heard *h, const struct board_cue *cues, int n, uint32_t frame)
{
    for (int i = 0; i < n; i++) {
        const int was = h->slot[i];
        const bool begins = cues[i].name && cues[i].start_frame == frame;
        const int is = cues[i].name ? index_of(h, cues[i].name) : -1;
        h->slot[i] = cues[i].ends_next_frame ? -1 : is; /* losing the last frame does not count */
        if (begins && was >= 0 && !restarted(h, cues, n, was, frame))
            lose(h, was, frame);
        if (begins && cues[i].is_first_track && is >= 0)
            h->sound[is].began++;
    }
}

void check_heard_frame(struct check_heard *h, const struct board *b)
{
    int16_t sound[2 * BOARD_SOUND_FRAMES];
    struct board_cue cues[SLOTS];
    bool over = false;
    int n = 0;

    if (!board_has_sound(b))
        return;
    while (n < SLOTS && board_get_cue(b, n, &cues[n]))
        n++;
    note_slots(h, cues, n, board_frame(b) - 1);
    board_mix_sound(b, h->tables, sound);
    for (int i = 0; i < 2 * BOARD_SOUND_FRAMES; i++)
        over = over || sound[i] > FULL || sound[i] < -FULL;
    if (over && h->over++ == 0)
        h->first = board_frame(b) - 1;
    h->frames++;
}

void check_heard_judge(struct check *c, struct check_heard *h, const char *what)
{
    if (h->over > h->frames / RARELY)
        diagnostics_add(&c->found, what, 0,
                        "the mix exceeds full scale in %" PRIu32 " of %" PRIu32 " frames, first in frame %" PRIu32
                        ": too loud",
                        h->over, h->frames, h->first);
    for (int i = 0; i < h->n; i++) {
        const struct heard_sound *s = &h->sound[i];
        if (s->began >= FEW && s->lost > s->began / TENTH)
            diagnostics_add(&c->found, what, 0,
                            "sound \"%s\" is cut off %" PRIu32 " of %" PRIu32 " times, first in frame %" PRIu32
                            ": other sounds take its voice",
                            s->name, s->lost, s->began, s->first);
    }
    restart(h);
}

void check_heard_close(struct check_heard *h)
{
    if (h != NULL)
        free(h->tables);
    free(h);
}

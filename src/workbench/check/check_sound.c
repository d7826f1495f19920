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

/* Functions whose first argument is the name of a sound or of music. */
static const struct {
    const char *space, *name;
    bool music;
} sound_functions[] = { { "sound", "play", false }, { "sound", "stop", false }, { "music", "play", true } };

static void check_name(struct check *c, const char *path, const struct symbol_call *call, bool music)
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
            for (size_t n = 0; n < sizeof sound_functions / sizeof *sound_functions && call->arg[0]; n++)
                if (symbol_call_is(call, sound_functions[n].space, sound_functions[n].name))
                    check_name(c, c->scripts[i].path, call, sound_functions[n].music);
        }
}

/* ---- a run ---- */

enum {
    SLOTS = 32,
    FULL_SCALE = 27913, /* the output of the limiter for a mix at full scale (wave.h) */
    LOUD_RATIO = 100,   /* one frame in 100 may exceed full scale */
    MIN_STARTS = 10,    /* a sound with fewer starts is not reported */
    CUT_OFF_RATIO = 10  /* one start in 10 may be cut off */
};

struct played_sound {
    char name[64];
    uint32_t starts, cut_off, first;
};

struct check_audio {
    void *tables;
    uint32_t frames, over, first_clipped;
    int n;
    struct played_sound sound[256];
    int slot[SLOTS]; /* the sound of each voice, or -1 */
};

static void reset(struct check_audio *h)
{
    void *tables = h->tables;

    memset(h, 0, sizeof *h);
    h->tables = tables;
    for (int i = 0; i < SLOTS; i++)
        h->slot[i] = -1;
}

struct check_audio *check_audio_open(void)
{
    struct check_audio *h = calloc(1, sizeof *h);

    if (h == NULL)
        return NULL;
    h->tables = malloc(board_sound_tables_size());
    if (h->tables == NULL) {
        free(h);
        return NULL;
    }
    board_sound_init_tables(h->tables);
    reset(h);
    return h;
}

static int find_or_add(struct check_audio *h, const char *name)
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

static void note_cut_off(struct check_audio *h, int i, uint32_t frame)
{
    if (i >= 0 && h->sound[i].cut_off++ == 0)
        h->sound[i].first = frame;
}

/* Returns whether a sound of the same name started in the frame. */
static bool same_sound_started(const struct check_audio *h, const struct board_cue *cues, int n, int of, uint32_t frame)
{
    for (int i = 0; i < n; i++)
        if (cues[i].name && cues[i].start_frame == frame && strcmp(cues[i].name, h->sound[of].name) == 0)
            return true;
    return false;
}

/* Counts sounds whose voice another sound took before their end. A sound with the same name is ignored: it takes the
 * voice because of its limit. */
static void update_voices(struct check_audio *h, const struct board_cue *cues, int n, uint32_t frame)
{
    for (int i = 0; i < n; i++) {
        const int was = h->slot[i];
        const bool begins = cues[i].name && cues[i].start_frame == frame;
        const int is = cues[i].name ? find_or_add(h, cues[i].name) : -1;
        h->slot[i] = cues[i].ends_next_frame ? -1 : is; /* losing only the last frame doesn't count */
        if (begins && was >= 0 && !same_sound_started(h, cues, n, was, frame))
            note_cut_off(h, was, frame);
        if (begins && cues[i].is_first_track && is >= 0)
            h->sound[is].starts++;
    }
}

void check_audio_frame(struct check_audio *h, const struct board *b)
{
    int16_t sound[2 * BOARD_SOUND_FRAMES];
    struct board_cue cues[SLOTS];
    bool over = false;
    int n = 0;

    if (!board_has_sound(b))
        return;
    while (n < SLOTS && board_get_cue(b, n, &cues[n]))
        n++;
    update_voices(h, cues, n, board_frame(b) - 1);
    board_mix_sound(b, h->tables, sound);
    for (int i = 0; i < 2 * BOARD_SOUND_FRAMES; i++)
        over = over || sound[i] > FULL_SCALE || sound[i] < -FULL_SCALE;
    if (over && h->over++ == 0)
        h->first_clipped = board_frame(b) - 1;
    h->frames++;
}

void check_audio_report(struct check *c, struct check_audio *h, const char *what)
{
    if (h->over > h->frames / LOUD_RATIO)
        diagnostics_add(&c->found, what, 0,
                        "the mix exceeds full scale in %" PRIu32 " of %" PRIu32 " frames, first in frame %" PRIu32
                        ": too loud",
                        h->over, h->frames, h->first_clipped);
    for (int i = 0; i < h->n; i++) {
        const struct played_sound *s = &h->sound[i];
        if (s->starts >= MIN_STARTS && s->cut_off > s->starts / CUT_OFF_RATIO)
            diagnostics_add(&c->found, what, 0,
                            "sound \"%s\" is cut off %" PRIu32 " of %" PRIu32 " times, first in frame %" PRIu32
                            ": other sounds take its voice",
                            s->name, s->cut_off, s->starts, s->first);
    }
    reset(h);
}

void check_audio_close(struct check_audio *h)
{
    if (h != NULL)
        free(h->tables);
    free(h);
}

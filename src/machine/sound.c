/*
 * sound.c - see sound.h. Applies the sequencers' events to the voices, with the instruments of the ROM.
 */
#include "sound.h"
#include "window.h"

#include <string.h>

static const uint8_t *tune_data(const struct board *b)
{
    return b->cart.tune_data;
}

/* Returns a voice's volume. volume: 0 to TUNE_MAX_VOLUME, which is a third of full scale, so that a few voices together
 * stay below the limiter; factor: a factor, 256: 1; tune_volume: 0 to 255. */
static uint16_t voice_volume(int volume, int factor, int tune_volume)
{
    const int64_t third = VOICE_FULL_VOLUME / 3;

    return (uint16_t)(third * volume * volume / (TUNE_MAX_VOLUME * TUNE_MAX_VOLUME) * factor / 256 * tune_volume / 255);
}

/* The voice to which a sequencer event of the music or of a sound is applied, and the state of its track. */
struct voice_target {
    struct board *b;
    uint32_t tune; /* offset in the ROM's tune data */
    int voice;
    uint16_t vol;
    uint8_t pan, inst;
    int32_t transpose; /* added to the pitch of every note */
    uint32_t tempo;
};

static void begin_note(const struct voice_target *g, int32_t pitch, int sample)
{
    const struct tune t = tune_of(tune_data(g->b) + g->tune);

    if (g->inst >= t.n_insts)
        return;
    const uint8_t *inst = tune_inst(&t, g->inst);
    const struct voice_note n = { (uint32_t)(inst - tune_data(g->b)), cart_recording_offset(&g->b->cart, g->tune, inst),
                                  pitch, g->vol, g->pan };
    voices_start_note(&g->b->voices, tune_data(g->b), g->voice, &n, sample);
}

static void apply_event(const struct voice_target *g, const struct tune_played_event *p)
{
    struct voices *v = &g->b->voices;
    const int32_t pitch = p->value * (PITCH_ONE / 256) + g->transpose;

    switch (p->event) {
    case TUNE_NOTE:
        begin_note(g, pitch, p->sample);
        break;
    case TUNE_SLUR:
        voices_slur(v, tune_data(g->b), g->voice, pitch);
        break;
    case TUNE_GLIDE:
        voices_glide(v, g->voice, pitch, (int32_t)((int64_t)p->value2 * TUNE_TICK / ((int64_t)SND_FRAME * g->tempo)));
        break;
    case TUNE_OFF:
    case TUNE_END:
        voices_release(v, g->voice, p->sample);
        break;
    case TUNE_VOLUME:
    case TUNE_PANNING:
        voices_set_volume_and_pan(v, g->voice, g->vol, g->pan);
        break;
    default:
        break;
    }
}

static struct voice_target music_target(struct board *b, int track)
{
    const struct seq *s = &b->music;
    const uint32_t at = cart_tune_offset(&b->cart, CART_TUNES, s->tune - 1);

    return (struct voice_target){ b,
                                  at,
                                  track,
                                  voice_volume(s->volume[track + 1], 256, tune_of(tune_data(b) + at).volume),
                                  s->pan[track + 1],
                                  s->inst[track + 1],
                                  0,
                                  s->tempo };
}

static uint8_t clamp_pan(int pan)
{
    return (uint8_t)(pan < 0 ? 0 : pan > 2 * TUNE_PAN_CENTRE ? 2 * TUNE_PAN_CENTRE : pan);
}

static struct voice_target cue_target(struct board *b, int slot)
{
    const struct cues *c = &b->cues;
    const struct tune t = tune_of(tune_data(b) + c->tune[slot]);

    return (struct voice_target){ b,
                                  c->tune[slot],
                                  VOICES_MUSIC + slot,
                                  voice_volume(c->volume[slot], c->cue_volume[slot], t.volume),
                                  clamp_pan(c->pan[slot] + c->pan_offset[slot]),
                                  c->inst[slot],
                                  c->pitch[slot],
                                  t.tempo };
}

static void cut_music(struct board *b, int sample)
{
    for (int i = 0; i < VOICES_MUSIC; i++)
        voices_fade_out(&b->voices, i, sample);
}

static void start_music(struct board *b, uint16_t index)
{
    struct tune t = { 0 };

    if (index)
        t = tune_of(tune_data(b) + cart_tune_offset(&b->cart, CART_TUNES, index - 1));
    if (index > 0 && index <= SEQ_MAX_PIECES)
        b->music.started_tunes[(index - 1) / 64] |= (uint64_t)1 << (index - 1) % 64;
    seq_start(&b->music, index, &t);
}

/* Removes the music's voices after a fade to silence, and sets the gain at once to that of the next piece. */
static void silence_music(struct board *b)
{
    for (int i = 0; i < VOICE_SLOTS; i++)
        if (i % VOICES < VOICES_MUSIC)
            b->voices.inst[i] = 0;
    b->voices.gain0 = (uint16_t)((int32_t)b->music.level * (VOICE_FULL_GAIN - b->voices.duck_depth) / VOICE_FULL_GAIN);
}

_Static_assert((int)VOICE_MAX_SUSPENDED == (int)SEQ_MAX_SUSPENDED,
               "each piece of music that can be set aside needs storage for its voices");

static void suspend_music(struct board *b)
{
    struct seq *s = &b->music;

    if (s->tune && s->suspended_count < SEQ_MAX_SUSPENDED)
        voices_save_music(&b->voices, s->suspended_count);
    seq_suspend(s);
}

static void resume_music(struct board *b)
{
    voices_restore_music(&b->voices, b->music.suspended_count - 1);
    seq_resume(&b->music);
}

/* Changes to the requested piece, which starts or resumes at this sample of the frame. */
static void change_music(struct board *b, int sample)
{
    struct seq *s = &b->music;
    const int suspended = s->next_tune && !s->next_suspends ? seq_find_suspended(s, s->next_tune) : -1;

    if (s->next_suspends)
        suspend_music(b);
    else
        seq_drop_suspended_from(s, suspended + 1);
    if (b->voices.gain0 == 0 && sample == 0)
        silence_music(b);
    cut_music(b, sample);
    if (suspended >= 0)
        resume_music(b);
    else
        start_music(b, s->next_tune);
}

/* Ducks the music within a few frames while a sound requires it; afterwards, its volume rises again slowly. */
static void step_duck(struct board *b)
{
    struct voices *v = &b->voices;
    int32_t max_duck = 0;

    for (int i = 0; i < CUE_SLOTS; i++)
        if (b->cues.tune[i]) {
            const int32_t duck = tune_of(tune_data(b) + b->cues.tune[i]).duck * VOICE_FULL_GAIN / 255;
            max_duck = duck > max_duck ? duck : max_duck;
        }
    if (max_duck > v->duck_depth)
        v->duck_depth = (uint16_t)(v->duck_depth + (max_duck - v->duck_depth + 3) / 4);
    else
        v->duck_depth = (uint16_t)(v->duck_depth - (v->duck_depth - max_duck + 15) / 16);
}

/* Returns the music's gain at the end of this frame. */
static uint16_t music_gain(const struct board *b)
{
    const struct seq *s = &b->music;
    const int32_t fade_gain =
        s->fade_length ? VOICE_FULL_GAIN * (int32_t)s->fade_frames_left / s->fade_length : VOICE_FULL_GAIN;

    if (b->voices.music_paused)
        return 0;
    return (uint16_t)(fade_gain * s->level / SEQ_FULL_VOLUME * (VOICE_FULL_GAIN - b->voices.duck_depth) /
                      VOICE_FULL_GAIN);
}

/* Returns whether the current piece is about to end, for another one or for silence. */
static bool is_ending(const struct seq *s)
{
    return s->fade_length || s->next_is_scheduled;
}

/* Ends the current piece, letting its last notes ring out, and resumes the piece set aside last, if any. */
static void end_piece(struct board *b)
{
    if (b->music.suspended_count)
        resume_music(b);
    else
        seq_start(&b->music, 0, NULL);
}

static void step_level(struct seq *s)
{
    if (!s->level_frames)
        return;
    s->level = (uint16_t)(s->level + (s->level_target - s->level) / s->level_frames);
    s->level_frames--;
}

/* Plays one frame of the music, unless the game is paused. */
static void step_music(struct board *b)
{
    struct seq *s = &b->music;

    b->voices.music_paused = b->core.frozen > 0;
    if (b->voices.music_paused)
        return;
    step_level(s);
    if (s->fade_length && s->fade_frames_left == 0)
        change_music(b, 0);
    else if (s->tune && !is_ending(s) && seq_has_ended(s))
        end_piece(b);
    if (s->fade_frames_left)
        s->fade_frames_left--;
    for (int first = 0; s->tune && first < SND_FRAME;) {
        const struct tune t = tune_of(tune_data(b) + cart_tune_offset(&b->cart, CART_TUNES, s->tune - 1));
        struct seq_run run = { .s = s, .t = &t, .first = first };
        struct tune_played_event e;
        while (seq_next_event(&run, &e)) {
            const struct voice_target target = music_target(b, run.slot - 1);
            apply_event(&target, &e);
        }
        first = run.first;
        if (first < SND_FRAME)
            change_music(b, first);
    }
}

void sound_begin_tick(struct board *b)
{
    voices_step(&b->voices, tune_data(b));
}

/* Plays one frame of all sounds. */
static void step_cues(struct board *b)
{
    struct cues_run run = { 0 };
    struct tune_played_event e;

    while (cues_next_event(&b->cues, tune_data(b), &run, &e)) {
        const struct voice_target target = cue_target(b, run.slot);
        apply_event(&target, &e);
    }
}

void sound_end_tick(struct board *b)
{
    step_music(b);
    step_cues(b);
    step_duck(b);
    b->voices.gain1 = music_gain(b);
}

/* ---- requests for sounds ---- */

static uint32_t ringing_mask(const struct board *b)
{
    uint32_t busy = 0;

    for (int i = 0; i < CUE_SLOTS; i++)
        busy |= (uint32_t)voices_is_busy(&b->voices, VOICES_MUSIC + i) << i;
    return busy;
}

/* Fades out the voices of the sounds in these slots. */
static void fade_out_cues(struct board *b, uint32_t slots)
{
    for (int i = 0; i < CUE_SLOTS; i++)
        if (slots >> i & 1)
            voices_fade_out(&b->voices, VOICES_MUSIC + i, 0);
}

void sound_play(struct board *b, const struct cue *cue)
{
    fade_out_cues(b, cues_start(&b->cues, tune_data(b), cue, b->core.frame, ringing_mask(b)));
}

void sound_stop(struct board *b, uint32_t tune)
{
    fade_out_cues(b, cues_stop(&b->cues, tune));
}

int16_t sound_pan_at(const struct board *b, fx x)
{
    const int64_t half = (int64_t)manifest_view_w(&b->cart.manifest) << 15;
    const int64_t middle = half + fx_int(window_of(b).left);

    return (int16_t)int64_clamp((x - middle) * TUNE_PAN_CENTRE * 2 / (3 * half), -TUNE_PAN_CENTRE, TUNE_PAN_CENTRE);
}

/* Least frames from one cue of a kind to the next, because many in quick succession sound like noise. */
static const uint8_t min_interval[CART_CUES] = { [CUE_GRAZE] = 4, [CUE_ITEM] = 3 };

void sound_start_cue(struct board *b, enum cart_cue cue, fx x)
{
    const uint32_t next = b->core.frame + 1, since = next - b->cues.last_played[cue];

    if (b->cues.last_played[cue] && since > 0 && since < min_interval[cue])
        return;
    b->cues.last_played[cue] = next;
    sound_play(b, &(struct cue){ b->cart.cue_offset[cue], 256, sound_pan_at(b, x), 0 });
}

/* ---- music ---- */

/* Fades out the current piece; then the requested one starts. A fade already in progress continues from its current
 * level, shortened to `fade` frames if it is longer. */
static void begin_fade(struct board *b, int32_t fade)
{
    struct seq *s = &b->music;

    if (s->fade_length && s->fade_frames_left <= fade)
        return;
    const int64_t full_length = s->fade_length ? (int64_t)s->fade_length * fade / s->fade_frames_left : fade;
    s->fade_length = (uint16_t)(full_length > fade ? full_length : fade);
    s->fade_frames_left = (uint16_t)fade;
}

/* Requests a piece, or silence if index is 0, which starts now, at a beat or bar, or after a fade. */
static void request_music(struct board *b, uint16_t index, const struct music_options *options)
{
    struct seq *s = &b->music;

    s->next_suspends = options->suspend_current &&
                       !(s->fade_length && !s->next_tune); /* a piece that is fading to silence is not set aside */
    s->next_tune = index;
    s->next_is_scheduled = 0;
    s->next_start = 0;
    if (s->tune && options->start_at) {
        const struct tune t = tune_of(tune_data(b) + cart_tune_offset(&b->cart, CART_TUNES, s->tune - 1));
        s->fade_frames_left = s->fade_length = 0;
        seq_schedule_next(s, options->start_at == MUSIC_AT_BAR ? t.beats_per_bar : 1);
    } else if (s->tune && options->fade > 0)
        begin_fade(b, options->fade);
    else
        change_music(b, 0);
}

bool sound_start_music(struct board *b, int tune, const struct music_options *options)
{
    struct seq *s = &b->music;
    const uint16_t index = (uint16_t)(tune + 1);

    if (options->restart && !options->suspend_current && seq_find_suspended(s, index) >= 0)
        seq_drop_suspended_from(s, 0);
    if (!options->restart && is_ending(s) && s->next_tune == index && s->next_suspends == options->suspend_current)
        return false;
    if (!options->restart && s->tune == index &&
        (!is_ending(s) || s->next_is_scheduled || s->fade_frames_left == s->fade_length)) {
        seq_cancel_next(s);
        return false;
    }
    request_music(b, index, options);
    return true;
}

void sound_stop_music(struct board *b, int32_t fade)
{
    struct seq *s = &b->music;

    if (fade == 0 || !s->tune) {
        seq_drop_suspended_from(s, 0);
        seq_cancel_next(s);
    }
    if (s->tune)
        request_music(b, 0, &(struct music_options){ .fade = fade });
}

static void drop_suspended(struct board *b, int i)
{
    for (int k = i; k + 1 < b->music.suspended_count; k++)
        voices_move_saved_music(&b->voices, k, k + 1);
    seq_drop_suspended(&b->music, i);
}

void sound_end_music(struct board *b, int tune, int32_t fade)
{
    struct seq *s = &b->music;
    const uint16_t index = (uint16_t)(tune + 1);
    const int suspended = seq_find_suspended(s, index);

    if (is_ending(s) && s->next_tune == index && s->next_suspends)
        seq_cancel_next(s);
    else if (is_ending(s) && s->next_tune == index && suspended >= 0) { /* the piece was about to resume */
        drop_suspended(b, suspended);
        s->next_tune = s->suspended_count ? s->suspended_tune[s->suspended_count - 1] : 0;
    } else if (s->tune == index && is_ending(s) && s->next_suspends) /* end this piece instead of setting it aside */
        s->next_suspends = 0;
    else if (s->tune == index && !is_ending(s))
        request_music(b, s->suspended_count ? s->suspended_tune[s->suspended_count - 1] : 0,
                      &(struct music_options){ .fade = fade });
    else if (suspended >= 0)
        drop_suspended(b, suspended);
}

void sound_set_volume(struct board *b, uint16_t level, int32_t frames)
{
    struct seq *s = &b->music;

    s->level_target = level;
    s->level_frames = (uint16_t)frames;
    if (frames == 0)
        s->level = level;
}

void sound_reset(struct board *b)
{
    b->music.level = b->music.level_target = SEQ_FULL_VOLUME;
    b->voices.gain0 = b->voices.gain1 = VOICE_FULL_GAIN;
}

void sound_start_game(struct board *b)
{
    struct seq *s = &b->music;

    memset(s->started_tunes, 0, sizeof s->started_tunes);
    sound_set_skipping(b, false);
    s->level = s->level_target = SEQ_FULL_VOLUME;
    s->level_frames = 0;
    sound_stop_music(b, 0);
}

/* ---- skipping to a mark ---- */

enum {
    WORK_PER_FRAME = 64,           /* work per frame of music */
    MAX_SKIP_FRAMES = 60 * 60 * 60 /* most frames in total while skipping: an hour */
};

/* Advances only the music, by n frames, each from the end of a tick to the start of the next. Returns the work done. */
static uint64_t skip_frames(struct board *b, int64_t n)
{
    struct seq *s = &b->music;
    int64_t i = 0;

    for (; i < n && s->frames_skipped < MAX_SKIP_FRAMES && s->tune; i++, s->frames_skipped++) {
        step_music(b);
        b->voices.gain1 = music_gain(b);
        voices_step(&b->voices, tune_data(b));
    }
    return (uint64_t)i * WORK_PER_FRAME;
}

uint64_t sound_skip_wait(struct board *b, int64_t n)
{
    struct seq *s = &b->music;
    const int64_t ahead = n < INT32_MAX ? s->frames_ahead + n : INT32_MAX;

    s->frames_ahead = (uint32_t)(ahead < INT32_MAX ? ahead : INT32_MAX);
    return skip_frames(b, n);
}

uint64_t sound_skip_clock(struct board *b, int64_t n)
{
    struct seq *s = &b->music;
    const int64_t unreported = n - s->frames_ahead;

    s->frames_ahead = unreported < 0 ? (uint32_t)-unreported : 0;
    return skip_frames(b, unreported);
}

uint64_t sound_skip_fight(struct board *b)
{
    uint64_t work = 0, step_work = 1;

    while (is_ending(&b->music) && step_work > 0)
        work += step_work = skip_frames(b, 1);
    return work;
}

void sound_set_skipping(struct board *b, bool on)
{
    b->music.is_skipping = on;
    b->music.frames_ahead = b->music.frames_skipped = 0;
}

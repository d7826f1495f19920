/*
 * sound.c - see sound.h. Applies the sequencers' events to the voices, with the instruments of the ROM.
 */
#include "sound.h"

#include <string.h>

static const uint8_t *rom(const struct board *b)
{
    return b->cart.tune_data;
}

/* Returns a voice's volume. volume: 0 to TUNE_LOUD, which is a third of full scale, so that a few voices together stay
 * below the limiter; of: a factor, 256: 1; tune_volume: 0 to 255. */
static uint16_t loud(int volume, int of, int tune_volume)
{
    const int64_t third = VOICE_LOUD / 3;

    return (uint16_t)(third * volume * volume / (TUNE_LOUD * TUNE_LOUD) * of / 256 * tune_volume / 255);
}

/* The voice to which a sequencer event of the music or of a sound is applied, and the state of its track. */
struct part_played {
    struct board *b;
    uint32_t tune; /* offset in the ROM's tune data */
    int voice;
    uint16_t vol;
    uint8_t pan, inst;
    int32_t pitch; /* added to the pitch of every note */
    uint32_t tempo;
};

static void begin_note(const struct part_played *g, int32_t pitch, int sample)
{
    const struct tune t = tune_of(rom(g->b) + g->tune);

    if (g->inst >= t.insts)
        return;
    const uint8_t *inst = tune_inst(&t, g->inst);
    const struct voice_note n = { (uint32_t)(inst - rom(g->b)), cart_recording(&g->b->cart, g->tune, inst), pitch,
                                  g->vol, g->pan };
    voices_note(&g->b->voices, rom(g->b), g->voice, &n, sample);
}

static void play_part(const struct part_played *g, const struct tune_played *p)
{
    struct voices *v = &g->b->voices;
    const int32_t pitch = p->value * (PITCH_ONE / 256) + g->pitch;

    switch (p->event) {
    case TUNE_NOTE:
        begin_note(g, pitch, p->sample);
        break;
    case TUNE_SLUR:
        voices_slur(v, rom(g->b), g->voice, pitch);
        break;
    case TUNE_GLIDE:
        voices_glide(v, g->voice, pitch, (int32_t)((int64_t)p->more * TUNE_TICK / ((int64_t)SND_FRAME * g->tempo)));
        break;
    case TUNE_OFF:
    case TUNE_END:
        voices_off(v, g->voice, p->sample);
        break;
    case TUNE_VOLUME:
    case TUNE_PLACE:
        voices_set(v, g->voice, g->vol, g->pan);
        break;
    default:
        break;
    }
}

static struct part_played music_part(struct board *b, int track)
{
    const struct seq *s = &b->music;
    const uint32_t at = cart_tune(&b->cart, s->tune - 1);

    return (struct part_played){ b,
                                 at,
                                 track,
                                 loud(s->volume[track + 1], 256, tune_of(rom(b) + at).volume),
                                 s->pan[track + 1],
                                 s->inst[track + 1],
                                 0,
                                 s->tempo };
}

static uint8_t side(int pan)
{
    return (uint8_t)(pan < 0 ? 0 : pan > 2 * TUNE_PAN ? 2 * TUNE_PAN : pan);
}

static struct part_played cue_part(struct board *b, int slot)
{
    const struct cues *c = &b->cues;
    const struct tune t = tune_of(rom(b) + c->tune[slot]);

    return (struct part_played){ b,
                                 c->tune[slot],
                                 VOICES_MUSIC + slot,
                                 loud(c->volume[slot], c->loud[slot], t.volume),
                                 side(c->pan[slot] + c->place[slot]),
                                 c->inst[slot],
                                 c->pitch[slot],
                                 t.tempo };
}

static void cut_music(struct board *b, int sample)
{
    for (int i = 0; i < VOICES_MUSIC; i++)
        voices_cut(&b->voices, i, sample);
}

static void start_music(struct board *b, uint16_t index)
{
    struct tune t = { 0 };

    if (index)
        t = tune_of(rom(b) + cart_tune(&b->cart, index - 1));
    if (index > 0 && index <= SEQ_HEARD)
        b->music.heard[(index - 1) / 64] |= (uint64_t)1 << (index - 1) % 64;
    seq_start(&b->music, index, &t);
}

/* Removes the music's voices after a fade to silence, and sets the gain at once to that of the next piece. */
static void silence_music(struct board *b)
{
    for (int i = 0; i < VOICE_SLOTS; i++)
        if (i % VOICES < VOICES_MUSIC)
            b->voices.inst[i] = 0;
    b->voices.gain0 = (uint16_t)((int32_t)b->music.level * (VOICE_GAIN - b->voices.ducked) / VOICE_GAIN);
}

_Static_assert((int)VOICE_PLACES == (int)SEQ_ASIDE,
               "each piece of music that can be set aside needs storage for its voices");

static void keep_music(struct board *b)
{
    struct seq *s = &b->music;

    if (s->tune && s->aside < SEQ_ASIDE)
        voices_keep(&b->voices, s->aside);
    seq_keep(s);
}

static void bring_back(struct board *b)
{
    voices_bring(&b->voices, b->music.aside - 1);
    seq_back(&b->music);
}

/* Changes to the requested piece, which starts or resumes at this sample of the frame. */
static void change_music(struct board *b, int sample)
{
    struct seq *s = &b->music;
    const int kept = s->next && !s->next_back ? seq_kept(s, s->next) : -1;

    if (s->next_back)
        keep_music(b);
    else
        seq_forget(s, kept + 1);
    if (b->voices.gain0 == 0 && sample == 0)
        silence_music(b);
    cut_music(b, sample);
    if (kept >= 0)
        bring_back(b);
    else
        start_music(b, s->next);
}

/* Ducks the music within a few frames while a sound requires it; afterwards, its volume rises again slowly. */
static void step_duck(struct board *b)
{
    struct voices *v = &b->voices;
    int32_t most = 0;

    for (int i = 0; i < CUES; i++)
        if (b->cues.tune[i]) {
            const int32_t duck = tune_of(rom(b) + b->cues.tune[i]).duck * VOICE_GAIN / 255;
            most = duck > most ? duck : most;
        }
    if (most > v->ducked)
        v->ducked = (uint16_t)(v->ducked + (most - v->ducked + 3) / 4);
    else
        v->ducked = (uint16_t)(v->ducked - (v->ducked - most + 15) / 16);
}

/* Returns the music's gain at the end of this frame. */
static uint16_t gain(const struct board *b)
{
    const struct seq *s = &b->music;
    const int32_t left = s->fade_over ? VOICE_GAIN * (int32_t)s->fade / s->fade_over : VOICE_GAIN;

    if (b->voices.held)
        return 0;
    return (uint16_t)(left * s->level / SEQ_FULL * (VOICE_GAIN - b->voices.ducked) / VOICE_GAIN);
}

/* Returns whether the current piece is about to end, for another one or for silence. */
static bool goes(const struct seq *s)
{
    return s->fade_over || s->next_is_scheduled;
}

/* Ends the current piece, letting its last notes ring out, and resumes the piece set aside last, if any. */
static void end_piece(struct board *b)
{
    if (b->music.aside)
        bring_back(b);
    else
        seq_start(&b->music, 0, NULL);
}

static void step_level(struct seq *s)
{
    if (!s->level_over)
        return;
    s->level = (uint16_t)(s->level + (s->level_to - s->level) / s->level_over);
    s->level_over--;
}

/* Plays one frame of the music, unless the game is paused. */
static void step_music(struct board *b)
{
    struct seq *s = &b->music;

    b->voices.held = b->core.frozen > 0;
    if (b->voices.held)
        return;
    step_level(s);
    if (s->fade_over && s->fade == 0)
        change_music(b, 0);
    else if (s->tune && !goes(s) && seq_over(s))
        end_piece(b);
    if (s->fade)
        s->fade--;
    for (int first = 0; s->tune && first < SND_FRAME;) {
        const struct tune t = tune_of(rom(b) + cart_tune(&b->cart, s->tune - 1));
        struct seq_run run = { .s = s, .t = &t, .first = first };
        struct tune_played e;
        while (seq_next(&run, &e)) {
            const struct part_played part = music_part(b, run.slot - 1);
            play_part(&part, &e);
        }
        first = run.first;
        if (first < SND_FRAME)
            change_music(b, first);
    }
}

void sound_begin(struct board *b)
{
    voices_step(&b->voices, rom(b));
}

/* Plays one frame of all sounds. */
static void step_cues(struct board *b)
{
    struct cues_run run = { 0 };
    struct tune_played e;

    while (cues_next(&b->cues, rom(b), &run, &e)) {
        const struct part_played part = cue_part(b, run.slot);
        play_part(&part, &e);
    }
}

void sound_end(struct board *b)
{
    step_music(b);
    step_cues(b);
    step_duck(b);
    b->voices.gain1 = gain(b);
}

/* ---- requests for sounds ---- */

static uint32_t ringing(const struct board *b)
{
    uint32_t rings = 0;

    for (int i = 0; i < CUES; i++)
        rings |= (uint32_t)voices_busy(&b->voices, VOICES_MUSIC + i) << i;
    return rings;
}

void sound_play(struct board *b, const struct cue *cue)
{
    const uint32_t ended = cues_start(&b->cues, rom(b), cue, b->core.frame, ringing(b));

    for (int i = 0; i < CUES; i++)
        if (ended >> i & 1)
            voices_cut(&b->voices, VOICES_MUSIC + i, 0);
}

void sound_stop(struct board *b, uint32_t tune)
{
    const uint32_t ended = cues_stop(&b->cues, tune);

    for (int i = 0; i < CUES; i++)
        if (ended >> i & 1)
            voices_cut(&b->voices, VOICES_MUSIC + i, 0);
}

int16_t sound_place(const struct board *b, fx x)
{
    const int64_t half = (int64_t)b->cart.m.field_w << 15;
    int64_t place = (x - half) * TUNE_PAN * 2 / (3 * half);

    place = place > TUNE_PAN ? TUNE_PAN : place < -TUNE_PAN ? -TUNE_PAN : place;
    return (int16_t)place;
}

/* Least frames from one cue of a kind to the next, because many in quick succession sound like noise. */
static const uint8_t apart[CART_CUES] = { [CUE_GRAZE] = 4, [CUE_ITEM] = 3 };

void sound_cue_at(struct board *b, enum cart_cue cue, fx x)
{
    const uint32_t next = b->core.frame + 1, since = next - b->cues.last[cue];

    if (b->cues.last[cue] && since > 0 && since < apart[cue])
        return;
    b->cues.last[cue] = next;
    sound_play(b, &(struct cue){ b->cart.cue[cue], 256, sound_place(b, x), 0 });
}

/* ---- music ---- */

/* Fades out the current piece; then the requested one starts. A fade already in progress continues from its current
 * level, shortened to `fade` frames if it is longer. */
static void begin_fade(struct board *b, int32_t fade)
{
    struct seq *s = &b->music;

    if (s->fade_over && s->fade <= fade)
        return;
    const int64_t over = s->fade_over ? (int64_t)s->fade_over * fade / s->fade : fade;
    s->fade_over = (uint16_t)(over > fade ? over : fade);
    s->fade = (uint16_t)fade;
}

/* Requests a piece, or silence if index is 0, which starts now, at a beat or bar, or after a fade. */
static void ask_music(struct board *b, uint16_t index, const struct music_options *how)
{
    struct seq *s = &b->music;

    s->next_back =
        how->suspend_current && !(s->fade_over && !s->next); /* a piece that is fading to silence is not set aside */
    s->next = index;
    s->next_is_scheduled = 0;
    s->when = 0;
    if (s->tune && how->at) {
        const struct tune t = tune_of(rom(b) + cart_tune(&b->cart, s->tune - 1));
        s->fade = s->fade_over = 0;
        seq_wait(s, how->at == MUSIC_AT_BAR ? t.bar : 1);
    } else if (s->tune && how->fade > 0)
        begin_fade(b, how->fade);
    else
        change_music(b, 0);
}

/* Cancels the requested piece; the current one continues. */
static void forget_next(struct seq *s)
{
    s->next = s->fade = s->fade_over = 0;
    s->next_back = s->next_is_scheduled = 0;
    s->when = 0;
}

bool sound_music(struct board *b, int tune, const struct music_options *how)
{
    struct seq *s = &b->music;
    const uint16_t index = (uint16_t)(tune + 1);

    if (how->again && !how->suspend_current && seq_kept(s, index) >= 0)
        seq_forget(s, 0);
    if (!how->again && goes(s) && s->next == index && s->next_back == how->suspend_current)
        return false;
    if (!how->again && s->tune == index && (!goes(s) || s->next_is_scheduled || s->fade == s->fade_over)) {
        forget_next(s);
        return false;
    }
    ask_music(b, index, how);
    return true;
}

void sound_music_stop(struct board *b, int32_t fade)
{
    struct seq *s = &b->music;

    if (fade == 0 || !s->tune) {
        seq_forget(s, 0);
        forget_next(s);
    }
    if (s->tune)
        ask_music(b, 0, &(struct music_options){ .fade = fade });
}

static void drop_kept(struct board *b, int i)
{
    for (int k = i; k + 1 < b->music.aside; k++)
        voices_shift(&b->voices, k, k + 1);
    seq_drop(&b->music, i);
}

void sound_music_back(struct board *b, int tune, int32_t fade)
{
    struct seq *s = &b->music;
    const uint16_t index = (uint16_t)(tune + 1);
    const int kept = seq_kept(s, index);

    if (goes(s) && s->next == index && s->next_back)
        forget_next(s);
    else if (goes(s) && s->next == index && kept >= 0) { /* the piece was about to resume */
        drop_kept(b, kept);
        s->next = s->aside ? s->kept[s->aside - 1] : 0;
    } else if (s->tune == index && goes(s) && s->next_back) /* end this piece instead of setting it aside */
        s->next_back = 0;
    else if (s->tune == index && !goes(s))
        ask_music(b, s->aside ? s->kept[s->aside - 1] : 0, &(struct music_options){ .fade = fade });
    else if (kept >= 0)
        drop_kept(b, kept);
}

void sound_volume(struct board *b, uint16_t level, int32_t over)
{
    struct seq *s = &b->music;

    s->level_to = level;
    s->level_over = (uint16_t)over;
    if (over == 0)
        s->level = level;
}

void sound_power(struct board *b)
{
    b->music.level = b->music.level_to = SEQ_FULL;
    b->voices.gain0 = b->voices.gain1 = VOICE_GAIN;
}

void sound_game(struct board *b)
{
    struct seq *s = &b->music;

    memset(s->heard, 0, sizeof s->heard);
    sound_skip(b, false);
    s->level = s->level_to = SEQ_FULL;
    s->level_over = 0;
    sound_music_stop(b, 0);
}

/* ---- skipping to a mark ---- */

enum {
    PASS_WORK = 64,             /* work per frame of music */
    LONGEST_PASS = 60 * 60 * 60 /* most frames in total while skipping: an hour */
};

/* Advances only the music, by n frames, each from the end of a tick to the start of the next. Returns the work done. */
static uint64_t pass(struct board *b, int64_t n)
{
    struct seq *s = &b->music;
    int64_t i = 0;

    for (; i < n && s->passed < LONGEST_PASS && s->tune; i++, s->passed++) {
        step_music(b);
        b->voices.gain1 = gain(b);
        voices_step(&b->voices, rom(b));
    }
    return (uint64_t)i * PASS_WORK;
}

uint64_t sound_pass_wait(struct board *b, int64_t n)
{
    struct seq *s = &b->music;
    const int64_t ahead = n < INT32_MAX ? s->ahead + n : INT32_MAX;

    s->ahead = (uint32_t)(ahead < INT32_MAX ? ahead : INT32_MAX);
    return pass(b, n);
}

uint64_t sound_pass_clock(struct board *b, int64_t n)
{
    struct seq *s = &b->music;
    const int64_t left = n - s->ahead;

    s->ahead = left < 0 ? (uint32_t)-left : 0;
    return pass(b, left);
}

uint64_t sound_pass_fight(struct board *b)
{
    uint64_t work = 0, more = 1;

    while (goes(&b->music) && more > 0)
        work += more = pass(b, 1);
    return work;
}

void sound_skip(struct board *b, bool on)
{
    b->music.passes = on;
    b->music.ahead = b->music.passed = 0;
}

/*
 * api_sound.c - the Lua tables sound and music.
 */
#include <string.h>
#include "../../machine/sound.h"
#include "api_parts.h"

/* Parameter indices. */
enum { P_NAME, P_VOLUME, P_PAN, P_FROM, P_PITCH };
enum { M_NAME, M_FADE, M_RESTART, M_SUSPEND_CURRENT, M_AT };
enum { VOL_SHARE, VOL_OVER };
enum { ARG_NAME = 0, ARG_FADE = 0, ARG_BEATS = 0, ARG_N = 0 };

enum { MAX_FADE = 3600, DEFAULT_TEMPO = 12000 /* hundredths of beats per minute, used while nothing plays */ };

static const struct api_param sound_play_params[] = {
    REQUIRED("name", A_SOUND, "sound from rom.lua"),
    PARAM("volume", A_NUM, OPT, 0, 1, NULL, "1", "fraction of the sound's volume in rom.lua"),
    PARAM("pan", A_NUM, OPT, -1, 1, NULL, "0", "stereo position: -1 is left, 1 is right; give `pan` or `from`"),
    THING("from", OPT, POSITION_HANDLE_KINDS,
          "thing whose position in the field sets the stereo position; if the thing is dead, nothing plays"),
    PARAM("pitch", A_NUM, OPT, -48, 48, "semitones", "0", "pitch shift"),
};
static const struct api_param sound_stop_params[] = { OPTIONAL("name", A_SOUND,
                                                               "sound from rom.lua to stop; all sounds if omitted") };
static const struct api_param music_play_params[] = {
    REQUIRED("name", A_TUNE, "piece of music from rom.lua"),
    PARAM("fade", A_INT, OPT, 0, MAX_FADE, "frames", "0",
          "frames the current music takes to fade out first; cannot be combined with `at`"),
    DEFAULT("again", A_BOOL, "false", "restart the piece if it is already playing; if false, the piece continues"),
    DEFAULT("back", A_BOOL, "false",
            "set the current piece aside; it resumes when the new piece ends, or when you pass it to music.play; up to "
            "three pieces can be set aside"),
    PARAM("at", A_STR, OPT, 0, 31, "\"beat\" or \"bar\"", NULL,
          "start on the next \"beat\" or \"bar\" of the current music; if omitted, start immediately; cannot be "
          "combined with `fade`"),
};
static const struct api_param music_volume_params[] = {
    PARAM("share", A_NUM, OPT, 0, 1, NULL, NULL, "new volume; if omitted, the volume doesn't change"),
    PARAM("over", A_INT, OPT, 0, MAX_FADE, "frames", "0", "frames the change takes")
};
static const struct api_param music_stop_params[] = { PARAM("fade", A_INT, OPT, 0, MAX_FADE, "frames", "0",
                                                            "frames the music takes to fade out") };
static const struct api_param beats_params[] = { PARAM("beats", A_NUM, REQ, 0, 65536, NULL, NULL,
                                                       "number of beats (quarter notes)") };
static const struct api_param music_wait_params[] = { PARAM(
    "n", A_ANY, OPT, 0, 0, "whole number, or a marker", "1",
    "number of beats to wait for, or the name of a marker of the current piece") };

/* Returns whether the running task is fast-forwarding to a practice mark, when nothing is heard. */
static bool is_skipping(const struct board *b)
{
    return b->tasks.current != NO_SLOT && b->tasks.flags[b->tasks.current] & TASK_SKIPS;
}

static int play_sound(lua_State *L, struct board *b, struct api_value *v)
{
    fx x, y;

    if (v[P_PAN].given && v[P_FROM].given)
        return api_error(L, "sound.play", "expected either `pan` or `from`, got both");
    struct cue cue = { cart_tune_offset(&b->cart, CART_SOUNDS, (int)v[P_NAME].i - 1),
                       (uint16_t)(v[P_VOLUME].n * 256 + 0.5), (int16_t)(v[P_PAN].n * TUNE_PAN_CENTRE),
                       (int32_t)(v[P_PITCH].n * PITCH_ONE) };
    if (v[P_FROM].given) {
        if (!board_get_position(b, v[P_FROM].i, &x, &y))
            return 0;
        cue.pan_offset = sound_pan_at(b, x);
    }
    if (!is_skipping(b))
        sound_play(b, &cue);
    return 0;
}

static int stop_sound(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    sound_stop(b, v[ARG_NAME].given ? cart_tune_offset(&b->cart, CART_SOUNDS, (int)v[ARG_NAME].i - 1) : 0);
    return 0;
}

static int music_play(lua_State *L, struct board *b, struct api_value *v)
{
    static const char *const boundaries[] = { "beat", "bar" };
    struct music_options options = { (int32_t)v[M_FADE].i, MUSIC_AT_ONCE, v[M_RESTART].i != 0,
                                     v[M_SUSPEND_CURRENT].i != 0 };
    const char *at = v[M_AT].given ? lua_tostring(L, v[M_AT].at) : NULL;

    if (at && v[M_FADE].i)
        return api_error(L, "music.play", "expected either `at` or `fade`, got both");
    for (int i = 0; at && i < 2; i++)
        if (!strcmp(at, boundaries[i]))
            options.start_at = i ? MUSIC_AT_BAR : MUSIC_AT_BEAT;
    if (at && !options.start_at)
        return api_error(L, "music.play", "at: expected \"beat\" or \"bar\", got \"%s\"", at);
    sound_start_music(b, (int)v[M_NAME].i - 1, &options);
    return 0;
}

static int music_volume(lua_State *L, struct board *b, struct api_value *v)
{
    const double old_volume = (double)b->music.level / SEQ_FULL_VOLUME;

    if (v[VOL_SHARE].given)
        sound_set_volume(b, (uint16_t)(v[VOL_SHARE].n * SEQ_FULL_VOLUME + 0.5), (int32_t)v[VOL_OVER].i);
    lua_pushnumber(L, old_volume);
    return 1;
}

static int music_stop(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    sound_stop_music(b, (int32_t)v[ARG_FADE].i);
    return 0;
}

/* Reads the current piece into t; returns false if none plays. */
static bool get_playing_tune(const struct board *b, struct tune *t)
{
    if (!b->music.tune)
        return false;
    *t = tune_of(b->cart.tune_data + cart_tune_offset(&b->cart, CART_TUNES, b->music.tune - 1));
    return true;
}

static int music_name(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushstring(L, b->music.tune ? cart_name(&b->cart, CART_TUNES, b->music.tune - 1) : NULL); /* NULL becomes nil */
    return 1;
}

static int music_beat(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, (lua_Integer)seq_beats(&b->music));
    return 1;
}

static int music_bar(lua_State *L, struct board *b, struct api_value *v)
{
    struct tune t;

    (void)v;
    lua_pushinteger(L, get_playing_tune(b, &t) ? (lua_Integer)(seq_beats(&b->music) / (uint64_t)t.beats_per_bar) : 0);
    return 1;
}

static int music_marker(lua_State *L, struct board *b, struct api_value *v)
{
    struct tune t;

    (void)v;
    const bool has_marker = get_playing_tune(b, &t) && b->music.marker;
    lua_pushstring(L, has_marker ? tune_marker_name(&t, b->music.marker - 1) : NULL);
    return 1;
}

enum { BEAT_FRAMES = 360000 /* frames per beat at tempo 1, which is 0.01 beats per minute, at 60 frames a second */ };

static int music_frames(lua_State *L, struct board *b, struct api_value *v)
{
    const double tempo = b->music.tune ? b->music.tempo : DEFAULT_TEMPO;

    lua_pushinteger(L, (lua_Integer)(v[ARG_BEATS].n * BEAT_FRAMES / tempo + 0.5));
    return 1;
}

/* ---- music.wait ---- */

/* Stack indices of the values of a waiting task. */
enum { W_TUNE = 1, W_BEAT, W_MARKER, W_MARKERS_PASSED, W_FRAMES_LEFT };

/* Returns whether the wait is over. Counts beats while the piece that played at the start still plays, otherwise
 * frames. */
static bool wait_done(lua_State *L, struct board *b)
{
    const struct seq *s = &b->music;

    if (s->tune && s->tune == lua_tointeger(L, W_TUNE)) {
        if (lua_tointeger(L, W_MARKER))
            return s->markers_passed != (uint32_t)lua_tointeger(L, W_MARKERS_PASSED) &&
                   s->marker == lua_tointeger(L, W_MARKER);
        return (int64_t)seq_beats(s) >= lua_tointeger(L, W_BEAT);
    }
    lua_pushinteger(L, lua_tointeger(L, W_FRAMES_LEFT) - 1);
    lua_replace(L, W_FRAMES_LEFT);
    return lua_tointeger(L, W_MARKER) || lua_tointeger(L, W_FRAMES_LEFT) < 0;
}

static int continue_wait(lua_State *L, int status, lua_KContext context)
{
    struct board *b = vm_board(L);

    (void)status, (void)context;
    if (wait_done(L, b)) {
        lua_pushinteger(L, (lua_Integer)seq_beats(&b->music));
        return 1;
    }
    b->tasks.wait[b->tasks.current] = 1;
    return lua_yieldk(L, 0, 0, continue_wait);
}

/* Completes a music.wait at once while fast-forwarding to a practice mark. */
static int skip_wait(lua_State *L, struct board *b)
{
    uint64_t work = 1;

    if (!b->music.tune)
        vm_charge(L, sound_skip_wait(b, lua_tointeger(L, W_FRAMES_LEFT)));
    while (b->music.is_skipping && b->music.tune && work > 0 && !wait_done(L, b)) {
        work = sound_skip_wait(b, 1);
        vm_charge(L, work);
    }
    lua_pushinteger(L, (lua_Integer)seq_beats(&b->music));
    return 1;
}

/* Returns the number of the marker in the current piece, or 0 if no piece plays; raises an error if the piece has no
 * such marker. */
static int find_marker(lua_State *L, struct board *b, const char *name)
{
    struct api_suggestion s = { .word = name };
    struct tune t;

    if (!get_playing_tune(b, &t))
        return 0;
    for (int i = 0; i < t.n_markers; i++) {
        if (!strcmp(tune_marker_name(&t, i), name))
            return i + 1;
        api_consider(&s, tune_marker_name(&t, i));
    }
    const char *tune = cart_name(&b->cart, CART_TUNES, b->music.tune - 1);
    return api_error(L, "music.wait", "\"%s\" has no marker \"%s\"%s", tune, name, api_push_did_you_mean(L, &s, ""));
}

/* Returns whether the marker is still ahead. A marker before the start of the loop is passed only once; after the end
 * of the piece, no marker is ahead. */
static bool is_marker_ahead(lua_State *L, struct board *b, int marker)
{
    struct tune t;
    uint32_t work = 0;
    const bool is_ahead = get_playing_tune(b, &t) && seq_has_marker_ahead(&b->music, &t, marker - 1, &work);

    vm_charge(L, work);
    return is_ahead;
}

static int music_wait(lua_State *L, struct board *b, struct api_value *v)
{
    static const struct api_param count_param = PARAM("n", A_INT, REQ, 1, 65536, "beats", NULL, NULL);
    struct api_value n = { .i = 1 };
    int marker = 0;

    if (v[ARG_N].given && lua_type(L, v[ARG_N].at) == LUA_TSTRING) {
        marker = find_marker(L, b, lua_tostring(L, v[ARG_N].at));
        n.i = marker; /* 0 while nothing plays: no wait */
    } else if (v[ARG_N].given)
        api_check(L, "music.wait", &count_param, v[ARG_N].at, &n);
    if (b->tasks.current == NO_SLOT || !lua_isyieldable(L))
        return api_error(L, "music.wait", "only a task can wait; start one with task.go");
    if (marker && !is_marker_ahead(L, b, marker))
        return music_beat(L, b, v);
    const bool skipped = is_skipping(b);
    const int yields = skipped ? api_count_skipped_wait(L, b) : 0;
    if (yields)
        return yields;
    lua_settop(L, 0);
    lua_pushinteger(L, b->music.tune);
    lua_pushinteger(L, (lua_Integer)seq_beats(&b->music) + n.i);
    lua_pushinteger(L, marker);
    lua_pushinteger(L, b->music.markers_passed);
    lua_pushinteger(L, n.i * (BEAT_FRAMES / DEFAULT_TEMPO));
    return skipped ? skip_wait(L, b) : continue_wait(L, LUA_OK, 0);
}

static const struct api_entry entries[] = {
    { "sound.play", play_sound, PARAMS(sound_play_params), 1, API_CHANGES, NULL,
      HELP("plays a sound from rom.lua; plays nothing while a stage skips ahead to a practice mark") },
    { "sound.stop", stop_sound, PARAMS(sound_stop_params), 1, API_CHANGES, NULL, HELP("stops a sound, or all sounds") },
    { "music.play", music_play, PARAMS(music_play_params), 1, API_CHANGES, NULL,
      HELP("plays a piece of music from rom.lua instead of the current one") },
    { "music.stop", music_stop, PARAMS(music_stop_params), 0, API_CHANGES, NULL,
      HELP("stops the music, including pieces that were set aside") },
    { "music.volume", music_volume, PARAMS(music_volume_params), 2, API_CHANGES, "number",
      HELP("changes the volume of all music and returns the previous one; each new game starts at 1") },
    { "music.name", music_name, NO_PARAMS, 0, 0, "name or nil", HELP("returns the name of the piece that is playing") },
    { "music.beat", music_beat, NO_PARAMS, 0, 0, "integer",
      HELP("returns the number of beats (quarter notes) since the piece started; 0 during the first beat") },
    { "music.bar", music_bar, NO_PARAMS, 0, 0, "integer",
      HELP("returns the number of bars since the piece started; 0 during the first bar") },
    { "music.marker", music_marker, NO_PARAMS, 0, 0, "name or nil",
      HELP("returns the name of the last marker the piece has passed") },
    { "music.frames", music_frames, PARAMS(beats_params), 1, 0, "frames",
      HELP("converts beats to frames at the current tempo, or at 120 beats per minute if nothing is playing") },
    { "music.wait", music_wait, PARAMS(music_wait_params), 1, API_CHANGES, "integer",
      HELP("waits for a beat or a marker and returns the number of the beat; doesn't wait for a marker that won't come "
           "again, or for any marker if nothing is playing") },
};
const struct api_module api_sound = { entries, sizeof entries / sizeof *entries };

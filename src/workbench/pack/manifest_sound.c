/*
 * manifest_sound.c - the entries of sounds and music in rom.lua: MML, or a sample file with its loop and beat.
 */
#include <string.h>
#include "manifest_parts.h"
#include "../../common/files.h"

enum {
    MAX_MARKERS = 64,       /* of a sample */
    MAX_LOOP_TIME = 1 << 30 /* sample frames or seconds */
};

static void read_loop_table(const struct manifest_value *table, struct art_loop *loop)
{
    static const struct manifest_field fields[] = {
        REAL("start", art_loop, start, 0, MAX_LOOP_TIME),
        REAL("length", art_loop, length, 0, MAX_LOOP_TIME),
    };
    static const char *const others[] = { "unit", NULL };
    struct manifest_value v;
    char unit[16] = "frames";

    READ_TABLE(table, fields, others, loop);
    loop->kind = LOOP_RANGE;
    if (value_get(table, "unit", &v))
        value_to_text(&v, "a word", unit, sizeof unit);
    loop->in_seconds = strcmp(unit, "seconds") == 0;
    if (!loop->in_seconds && strcmp(unit, "frames") != 0)
        value_fail(table, "unit: expected \"frames\" or \"seconds\", got \"%s\"", unit);
    if (!loop->in_seconds && (loop->start != (int32_t)loop->start || loop->length != (int32_t)loop->length))
        value_fail(table, "expected whole numbers of frames (or unit=\"seconds\")");
}

static void read_markers(const struct manifest_value *tune, struct art_sound *s, struct art *art)
{
    struct art_marker *markers = art->markers + art->n_markers;
    const int unused = MAX_ART_MARKERS - art->n_markers;
    struct manifest_value table, beat;

    if (!value_get_table(tune, "markers", &table))
        return;
    s->first_marker = art->n_markers;
    s->n_markers = value_to_names(&table, markers, unused < MAX_MARKERS ? unused : MAX_MARKERS, sizeof *markers,
                                  sizeof markers->name);
    for (int i = 0; i < s->n_markers; i++) {
        value_get(&table, markers[i].name, &beat);
        markers[i].beat = value_to_real(&beat, 0, 1 << 20);
    }
    art->n_markers += s->n_markers;
}

bool art_is_recording(const char *file)
{
    static const char *const suffixes[] = {
        ".wav", ".ogg", ".oga", ".opus", ".flac", ".xm", ".it", ".s3m", ".mod", NULL
    };

    for (int i = 0; suffixes[i]; i++)
        if (files_has_suffix(file, suffixes[i]))
            return true;
    return false;
}

/* Reads `loop`: true for the whole sample, false for none, or a range. The keys of samples are errors for MML. */
static void read_loop(const struct manifest_value *sound, struct art_sound *s)
{
    static const char *const names[] = { "exact", "stereo", "loop", "tempo", "bar", "offset", "markers", NULL };
    struct manifest_value v;

    for (int i = 0; !art_is_recording(s->file) && names[i]; i++)
        if (value_get(sound, names[i], &v))
            value_fail(sound, "%s: only for samples (.wav, .ogg, .flac); MML has its own commands for it", names[i]);
    if (!value_get(sound, "loop", &v))
        return;
    if (lua_isboolean(v.lua, v.index))
        s->loop.kind = lua_toboolean(v.lua, v.index) ? LOOP_WHOLE : LOOP_NONE;
    else
        read_loop_table(&v, &s->loop);
}

static void set_defaults(struct art_sound *s)
{
    s->priority = 4;
    s->limit = 2;
    s->volume = 255;
    s->beats_per_bar = 4;
}

void manifest_read_sound(const struct manifest_value *v, void *sound, struct art *art)
{
    static const struct manifest_field fields[] = {
        FILE_PATH("file", art_sound, file),
        TEXT("mml", art_sound, mml, "MML"),
        SHARE("volume", art_sound, volume),
        SHARE("duck", art_sound, duck),
        WHOLE("priority", art_sound, priority, 0, 7),
        WHOLE("limit", art_sound, limit, 1, 8),
        FLAG("exact", art_sound, exact),
        FLAG("stereo", art_sound, stereo),
    };
    static const char *const others[] = { "loop", NULL };
    struct art_sound *s = sound;
    struct manifest_value mml;

    (void)art;
    set_defaults(s);
    READ_TABLE(v, fields, others, s);
    const bool is_file = s->file[0] != '\0';
    if (is_file == value_get(v, "mml", &mml) ||
        (is_file && !art_is_recording(s->file) && !files_has_suffix(s->file, ".mml")))
        value_fail(v, "expected either file=\"sfx/NAME.wav\" (or .ogg, .flac, .mml) or mml=\"...\"");
    read_loop(v, s);
}

void manifest_read_tune(const struct manifest_value *v, void *sound, struct art *art)
{
    static const struct manifest_field fields[] = {
        FILE_PATH("file", art_sound, file),
        SHARE("volume", art_sound, volume),
        TEXT("title", art_sound, title, "a line"),
        FLAG("exact", art_sound, exact),
        FLAG("stereo", art_sound, stereo),
        REAL("offset", art_sound, offset, 0, 300),
        WHOLE("bar", art_sound, beats_per_bar, 1, 64),
    };
    static const char *const others[] = { "tempo", "loop", "markers", NULL };
    struct art_sound *s = sound;
    struct manifest_value tempo;

    set_defaults(s);
    s->stereo = true;
    READ_TABLE(v, fields, others, s);
    if (!art_is_recording(s->file) && !files_has_suffix(s->file, ".mml"))
        value_fail(v, "expected file=\"music/NAME.mml\" (or .ogg, .flac, .wav)");
    read_loop(v, s);
    if (value_get(v, "tempo", &tempo))
        s->tempo = (int32_t)(value_to_real(&tempo, 10, 600) * 100 + 0.5);
    read_markers(v, s, art);
}

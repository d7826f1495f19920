/*
 * capture.c - see capture.h.
 *
 * A run is played once, or twice for a video with sound, because ffmpeg needs the sound first. Both runs are identical.
 */
#include "capture.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../player/clip/gif.h"
#include "y4m.h"
#include "../../common/files.h"
#include "../../common/progress.h"
#include "../../common/report.h"
#include "../../player/settings/views.h"
#include "../../player/picture/png.h"
#include "../../common/output_paths.h"
#include "../../player/picture/shade.h"
#include "../../player/speaker/wav_writer.h"
#include "../render/headless_run.h"

enum format { GIF, Y4M, WAV, MP4, WEBM, FORMATS };

enum { CAPTURE_FRAMES = 600 /* without a demo or --frames */ };

struct capture {
    const struct args *a;
    enum format format;
    bool to_stdout;
    uint32_t first, last;
    struct headless_run run;
    struct wav_writer wav;
    struct fb fb;
    struct view view;
    struct shade_cache shades;
    void *memory, *scratch;
    uint8_t *pix; /* the scaled picture */
    int w, h;     /* of the scaled picture, px */
    uint32_t rgb[256];
    uint32_t pictures; /* written so far */
    struct gif gif;
    FILE *stream; /* y4m output, to a file or another program */
};

static const struct {
    const char *name, *ending;
} formats[FORMATS] = {
    { "gif", ".gif" }, { "y4m", ".y4m" }, { "wav", ".wav" }, { "mp4", ".mp4" }, { "webm", ".webm" }
};

/* ---- the command line ---- */

static bool has_suffix(const char *path, const char *ending)
{
    const size_t n = strlen(path), m = strlen(ending);

    return n >= m && strcmp(path + n - m, ending) == 0;
}

static enum format find_format(const struct args *a)
{
    for (int i = 0; i < FORMATS; i++)
        if (a->format ? strcmp(a->format, formats[i].name) == 0 : has_suffix(a->out, formats[i].ending))
            return (enum format)i;
    return FORMATS;
}

static bool uses_ffmpeg(const struct capture *c)
{
    return c->format == MP4 || c->format == WEBM;
}

static enum result report_bad_format(const char *got)
{
    const char *words[FORMATS + 1] = { NULL };
    char list[128];

    for (int i = 0; i < FORMATS; i++)
        words[i] = formats[i].name;
    views_list(words, list, sizeof list);
    return report_line(RESULT_REFUSED, "--format: expected %s, got \"%s\"", list, got);
}

static enum result check_format(struct capture *c)
{
    const struct args *a = c->a;

    if (!a->out)
        return report_line(RESULT_REFUSED, "capture needs -o (see curtain help capture)");
    c->to_stdout = strcmp(a->out, "-") == 0;
    c->format = find_format(a);
    if (c->format == FORMATS && a->format)
        return report_bad_format(a->format);
    if (c->format == FORMATS && c->to_stdout)
        return report_line(RESULT_REFUSED, "-o - needs --format: standard output has no file extension");
    if (c->format == FORMATS)
        return report_line(RESULT_REFUSED,
                           "-o: expected a name that ends in .gif, .y4m, .wav, .mp4 or .webm, got \"%s\" "
                           "(or use --format)",
                           a->out);
    if (uses_ffmpeg(c) && c->to_stdout)
        return report_line(RESULT_REFUSED, "-o - cannot be combined with %s, which is written to a file",
                           formats[c->format].name);
    if (c->format == WAV && (a->scale || a->faster))
        return report_line(RESULT_REFUSED, "%s cannot be combined with WAV, which has no picture",
                           a->scale ? "--scale" : "--speed");
    if (uses_ffmpeg(c) && !plat_has_command("ffmpeg"))
        return report_line(RESULT_HOST_FAILED,
                           "%s needs ffmpeg, which is not installed; install it, or write a .gif, .png or .y4m",
                           formats[c->format].name);
    return RESULT_DONE;
}

static enum result check_frames(const struct args *a)
{
    if (a->n_spans > 1 || (a->n_spans == 1 && a->spans[0].step != 1))
        return report_line(RESULT_REFUSED,
                           "--frames: capture takes one range, as in 60:600 (use --speed to change the speed)");
    return RESULT_DONE;
}

/* ---- a run ---- */

static enum result pictures_open(struct capture *c)
{
    const struct board *b = c->run.guard.board;
    const int scale = c->a->scale ? c->a->scale : 1;
    int w, h;

    board_screen_size(b, &w, &h);
    c->w = w * scale;
    c->h = h * scale;
    c->memory = malloc(fb_size(w, h));
    c->scratch = malloc(board_scratch_size(b) + 1);
    c->pix = malloc((size_t)c->w * (size_t)c->h);
    if (!c->memory || !c->scratch || !c->pix)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    fb_init(&c->fb, c->memory, w, h);
    c->view = (struct view){ .dim = (enum view_dim)c->a->dim,
                             .softens_flashes = c->a->flashes,
                             .colour_blind_mode = (enum colour_blind_mode)c->a->colours,
                             .shades = shade_get_tables(&c->shades, &c->run.game.cart) };
    return RESULT_DONE;
}

static void run_close(struct capture *c)
{
    free(c->memory);
    free(c->scratch);
    free(c->pix);
    c->memory = c->scratch = c->pix = NULL;
    c->pictures = 0;
}

static void scale_picture(const struct capture *c)
{
    const int scale = c->w / c->fb.w;
    uint8_t *to = c->pix;

    for (int y = 0; y < c->h; y++) {
        const uint8_t *from = c->fb.pix + (ptrdiff_t)(y / scale) * c->fb.pitch;
        if (y % scale) {
            memcpy(to, to - c->w, (size_t)c->w);
            to += c->w;
            continue;
        }
        for (int x = 0; x < c->fb.w; x++, to += scale)
            memset(to, from[x], (size_t)scale);
    }
}

/* Returns the frame that picture k shows, counted from the first captured frame. */
static uint64_t picture_frame(const struct capture *c, uint32_t k)
{
    const uint64_t rate = c->format == GIF ? GIF_MAX_FPS : 60;
    const uint64_t faster = c->a->faster ? (uint64_t)c->a->faster : 1,
                   slower = c->a->slower ? (uint64_t)c->a->slower : 1;

    return k * 60 * faster / (rate * slower);
}

static uint32_t picture_time(const struct capture *c, uint32_t k)
{
    return c->format == GIF ? k * (GIF_UNITS_PER_SECOND / GIF_MAX_FPS) : k;
}

static void add_picture(struct capture *c)
{
    const uint32_t at = picture_time(c, c->pictures);

    if (c->format == GIF)
        gif_add(&c->gif, c->pix, c->rgb, at);
    else
        y4m_write_picture(c->stream, c->pix, c->rgb, c->w, c->h);
    c->pictures++;
}

/* Adds all pictures of the current frame. */
static void add_frame(struct capture *c, uint32_t frame)
{
    const uint64_t from_first = frame - c->first;
    bool drawn = false;

    for (; picture_frame(c, c->pictures) == from_first; add_picture(c)) {
        if (drawn)
            continue;
        board_draw(c->run.guard.board, &c->view, &c->fb, c->rgb, c->scratch);
        scale_picture(c);
        drawn = true;
    }
}

static bool failed(const struct capture *c)
{
    return c->gif.out.failed || c->wav.file.failed || (c->stream && ferror(c->stream));
}

/* Plays the run from power-on to the last frame. */
static enum result play(struct capture *c, bool sound)
{
    enum result result = RESULT_DONE;

    progress_begin();
    for (uint32_t f = 0;; f++) {
        if (f >= c->first && !sound)
            add_frame(c, f);
        else if (f >= c->first && (f > 0 || uses_ffmpeg(c)))
            wav_writer_add(&c->wav, c->run.guard.board);
        if (f == c->last || result != RESULT_DONE || failed(c))
            break;
        progress_update(f + 1, (uint64_t)c->last + 1, "frame %u of %u", (unsigned)f, (unsigned)c->last);
        result = headless_run_tick(&c->run);
        if (result != RESULT_DONE)
            break;
    }
    progress_end();
    return result;
}

/* ---- output ---- */

static enum result write_output(const struct capture *c, const uint8_t *bytes, size_t n)
{
    char err[FILES_ERR_SIZE];

    if (!c->to_stdout)
        return files_save(c->a->out, bytes, n, err, sizeof err) ? RESULT_DONE
                                                                : report_line(RESULT_HOST_FAILED, "%s", err);
    fwrite(bytes, 1, n, stdout);
    return report_stdout(RESULT_DONE);
}

static enum result report_no_memory(const struct capture *c)
{
    return report_line(RESULT_HOST_FAILED, "%s: out of memory, or larger than 1 GiB", c->a->out);
}

/* Returns the first of two results that is an error. */
static enum result first_error(enum result run, enum result rest)
{
    return run == RESULT_DONE ? rest : run;
}

static enum result restart(struct capture *c)
{
    run_close(c);
    headless_run_close(&c->run, RESULT_DONE);
    enum result result = headless_run_repeat(&c->run, c->a);
    return result == RESULT_DONE ? pictures_open(c) : result;
}

static enum result capture_gif(struct capture *c)
{
    if (!gif_open(&c->gif, c->w, c->h))
        return report_no_memory(c);
    enum result result = play(c, false);
    if (c->pictures == 0)
        return result;
    if (!gif_end(&c->gif, picture_time(c, c->pictures)))
        return report_no_memory(c);
    return first_error(result, write_output(c, c->gif.out.bytes, c->gif.out.n));
}

static enum result capture_wav(struct capture *c)
{
    if (!wav_writer_open(&c->wav))
        return report_no_memory(c);
    enum result result = play(c, true);
    if (!wav_writer_end(&c->wav))
        return report_no_memory(c);
    return first_error(result, write_output(c, c->wav.file.bytes, c->wav.file.n));
}

/* If the disk is full, the partial file remains, because players can show it. */
static enum result capture_y4m(struct capture *c)
{
    c->stream = c->to_stdout ? stdout : plat_open_stream(c->a->out, true);
    if (!c->stream)
        return report_line(RESULT_HOST_FAILED, "%s: cannot be written (%s)", c->a->out, strerror(errno));
    y4m_write_header(c->stream, c->w, c->h);
    enum result result = play(c, false);
    if (c->to_stdout)
        return report_stdout(result);
    bool good = fflush(c->stream) == 0 && !ferror(c->stream);
    const int why = errno;
    good = fclose(c->stream) == 0 && good;
    c->stream = NULL;
    return good ? result : report_line(RESULT_HOST_FAILED, "%s: cannot be written (%s)", c->a->out, strerror(why));
}

/* ---- ffmpeg ---- */

/* The command that converts y4m and, for sound, a WAV file to a video. Width and height are made even for 4:2:0. */
struct ffmpeg {
    const char *words[48];
    int n;
    char sound[FILES_PATH_SIZE + 8], video[FILES_PATH_SIZE + 8];
};

static void add_words(struct ffmpeg *f, const char *const words[])
{
    for (; *words; words++)
        f->words[f->n++] = *words;
}

/* Adds a file name with the prefix file:, so that ffmpeg accepts any name. */
static bool add_file(struct ffmpeg *f, char *to, size_t size, const char *name)
{
    f->words[f->n++] = to;
    return snprintf(to, size, "file:%s", name) < (int)size;
}

static bool ffmpeg_words(struct ffmpeg *f, const struct capture *c, const char *sound, const char *video)
{
    static const char *const in[] = { "ffmpeg", "-hide_banner", "-loglevel",    "error", "-xerror", "-nostdin",
                                      "-y",     "-f",           "yuv4mpegpipe", "-i",    "pipe:0",  NULL };
    static const char *const even[] = { "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", NULL };
    static const char *const mp4[] = { "-c:v", "libx264", "-crf",      "16",         "-preset", "slow", "-c:a", "aac",
                                       "-b:a", "192k",    "-movflags", "+faststart", "-f",      "mp4",  NULL };
    static const char *const webm[] = { "-c:v", "libvpx-vp9", "-crf", "20",   "-b:v", "0",    "-row-mt", "1",
                                        "-c:a", "libopus",    "-b:a", "160k", "-f",   "webm", NULL };

    f->n = 0;
    add_words(f, in);
    if (sound) {
        f->words[f->n++] = "-i";
        if (!add_file(f, f->sound, sizeof f->sound, sound))
            return false;
    }
    add_words(f, even);
    add_words(f, c->format == MP4 ? mp4 : webm);
    const bool good = add_file(f, f->video, sizeof f->video, video);
    f->words[f->n] = NULL;
    return good;
}

/* Copies the video with files_save, so that links and devices are preserved. */
static enum result move_video(const struct capture *c, const char *part)
{
    char err[FILES_ERR_SIZE];
    uint8_t *video;
    size_t size;

    bool good = files_read(part, part, SIZE_MAX, &video, &size, err, sizeof err);
    good = good && files_save(c->a->out, video, size, err, sizeof err);
    free(video);
    plat_remove(part);
    return good ? RESULT_DONE : report_line(RESULT_HOST_FAILED, "%s", err);
}

static enum result run_ffmpeg(struct capture *c, const char *sound, const char *part)
{
    struct ffmpeg ffmpeg;
    char err[FILES_ERR_SIZE];

    if (!ffmpeg_words(&ffmpeg, c, sound, part))
        return report_line(RESULT_REFUSED, "-o: path too long");
    if (!files_save(part, "", 0, err, sizeof err)) /* finds errors before the encoding */
        return report_line(RESULT_HOST_FAILED, "%s", err);
    fflush(stdout);
    c->stream = plat_command_open(ffmpeg.words);
    if (!c->stream)
        return report_line(RESULT_HOST_FAILED, "cannot run ffmpeg (%s)", strerror(errno));
    y4m_write_header(c->stream, c->w, c->h);
    enum result result = play(c, false);
    const bool good = plat_command_close(c->stream);
    c->stream = NULL;
    if (good)
        return first_error(result, move_video(c, part));
    plat_remove(part);
    return report_line(RESULT_HOST_FAILED, "%s: ffmpeg failed", c->a->out);
}

/* Captures with ffmpeg. Videos at another speed have no sound. */
static enum result capture_video(struct capture *c)
{
    char part[FILES_PATH_SIZE], sound[FILES_PATH_SIZE], err[FILES_ERR_SIZE];
    const bool with_sound = board_has_sound(c->run.guard.board) && c->a->faster <= 1 && c->a->slower <= 1;

    if (!output_path_temporary(c->a->out, ".part", part, sizeof part) ||
        !output_path_temporary(c->a->out, ".part.wav", sound, sizeof sound))
        return report_line(RESULT_REFUSED, "-o: path too long");
    if (!with_sound)
        return run_ffmpeg(c, NULL, part);
    if (!wav_writer_open(&c->wav))
        return report_no_memory(c);
    enum result result = play(c, true);
    if (!wav_writer_end(&c->wav))
        return report_no_memory(c);
    if (!files_save(sound, c->wav.file.bytes, c->wav.file.n, err, sizeof err))
        return report_line(RESULT_HOST_FAILED, "%s", err);
    wav_writer_close(&c->wav);
    enum result second = restart(c);
    second = second == RESULT_DONE ? run_ffmpeg(c, sound, part) : second;
    plat_remove(sound);
    return first_error(result, second);
}

/* ---- all formats ---- */

static enum result capture(struct capture *c)
{
    static enum result (*const captures[FORMATS])(struct capture *) = {
        [GIF] = capture_gif, [Y4M] = capture_y4m, [WAV] = capture_wav, [MP4] = capture_video, [WEBM] = capture_video,
    };
    const struct args *a = c->a;

    c->first = a->n_spans ? a->spans[0].first : 0;
    c->last = a->n_spans ? a->spans[0].last : c->run.game.has_demo ? c->run.game.demo.frames : CAPTURE_FRAMES;
    enum result result = pictures_open(c);
    if (result == RESULT_DONE && c->format != WAV &&
        (c->w > PNG_MAX_SIDE || c->h > PNG_MAX_SIDE || c->w > PNG_MAX_PIXELS / c->h))
        return report_line(RESULT_REFUSED, "--scale: frames of %d x %d pixels are too large", c->w, c->h);
    return result == RESULT_DONE ? captures[c->format](c) : result;
}

enum result capture_run(const struct args *a)
{
    struct capture *c = calloc(1, sizeof *c);

    if (!c)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    c->a = a;
    enum result result = check_format(c);
    result = result == RESULT_DONE ? check_frames(a) : result;
    if (result == RESULT_DONE) {
        result = headless_run_open(&c->run, a);
        if (result == RESULT_DONE)
            result = capture(c);
        result = headless_run_close(&c->run, result);
    }
    run_close(c);
    gif_close(&c->gif);
    wav_writer_close(&c->wav);
    free(c);
    return result;
}

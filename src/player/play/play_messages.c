/*
 * play_messages.c - the line over the picture, the log, and the present game, board and fault.
 */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/clean.h"
#include "../../common/files.h"
#include "play_state.h"

/* ---- the game ---- */

const char *play_game_name(const struct play *play)
{
    return play->options.path ? play->options.path : play->options.cart->manifest.id;
}

const struct cart *play_cart(const struct play *play)
{
    return play->session.now ? play->session.now->cart : play->options.cart;
}

struct board *play_board(const struct play *play)
{
    return session_board(&play->session);
}

const struct board_fault *play_fault(const struct play *play)
{
    return board_last_output(play_board(play))->fault;
}

struct board *play_shown_board(const struct play *play)
{
    return play->attract.on ? play->attract.guard.board : play_board(play);
}

void play_unused_name(struct play *play, char name[PLAY_NAME_SIZE], const char *where, const char *type)
{
    size_t size;
    int i = 1;
    do
        snprintf(name, PLAY_NAME_SIZE, "%s%s-%d.%s", where, play_cart(play)->manifest.id, i++, type);
    while (plat_file_size(name) >= 0 || unsaved_bytes(play->unsaved.files, name, &size));
}

void attract_end(struct attract *a)
{
    guard_close(&a->guard);
    demo_free(&a->demo);
    a->on = false;
}

/* ---- messages ---- */

void play_log_add(struct play *play, enum log_kind kind, const char *line)
{
    const struct board *b = play->session.now ? play_board(play) : NULL;

    log_add(&play->log, kind, b ? board_frame(b) : 0, line);
}

static void log_line_of(struct play *play, enum log_kind kind, char *line)
{
    clean_line(line);
    plat_log(line);
    play_log_add(play, kind, line);
}

void play_log(struct play *play, const char *format, ...)
{
    char line[2 * FILES_PATH_SIZE + 256];
    va_list args;

    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    log_line_of(play, LOG_PROGRAM, line);
}

void play_log_output(struct play *play)
{
    const struct board_out *out = board_last_output(play_board(play));
    char line[4097];

    for (size_t i = 0; i < out->log_size;) {
        const char *end = memchr(out->log + i, '\n', out->log_size - i);
        size_t n = end ? (size_t)(end - (out->log + i)) : out->log_size - i;
        snprintf(line, sizeof line, "%.*s", (int)n, out->log + i);
        log_line_of(play, LOG_SCRIPT, line);
        i += n + 1;
    }
}

static void set_message(struct play *play, int frames, const char *format, va_list args)
{
    play_translate_screens(play);
    screens_format_list(&play->screens, play->message.text, sizeof play->message.text, format, args);
    play->message.frames = frames;
}

void play_show_message(struct play *play, int frames, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    set_message(play, frames, format, args);
    va_end(args);
}

void play_warn(struct play *play, const char *format, ...)
{
    char line[sizeof play->message.text];
    va_list args;

    va_start(args, format);
    set_message(play, MESSAGE_FRAMES, format, args);
    va_end(args);
    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    play_log(play, "curtain: %s", line);
}

void play_report_difference(struct play *play)
{
    const uint32_t frame = play->session.differs;

    if (!frame || play->seek.reported_difference == frame)
        return;
    play->seek.reported_difference = frame;
    play_show_message(play, MESSAGE_FRAMES, "Playback diverged from the recording at frame %d", (int)frame);
    play_log(play, "curtain: %s: Playback diverged from the recording at frame %u", play_game_name(play),
             (unsigned)frame);
}

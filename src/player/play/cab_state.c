/*
 * cab_state.c - what the other files of the cabinet ask about it: the game, its board and its fault; messages; the end
 * of the attract demo.
 */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/clean.h"
#include "../../common/files.h"
#include "cab_parts.h"

void cab_note(struct cab *cab, enum log_kind kind, const char *line)
{
    const struct board *b = cab->session.now ? cab_live(cab) : NULL;

    log_add(&cab->log, kind, b ? board_frame(b) : 0, line);
}

void cab_say(struct cab *cab, const char *format, ...)
{
    char line[2 * FILES_PATH_SIZE + 256];
    va_list args;

    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    clean_line(line);
    plat_log(line);
    cab_note(cab, LOG_TOLD, line);
}

const char *cab_game(const struct cab *cab)
{
    return cab->options.path ? cab->options.path : cab->options.cart->manifest.id;
}

const struct cart *cab_cart(const struct cab *cab)
{
    return cab->session.now ? cab->session.now->cart : cab->options.cart;
}

struct board *cab_live(const struct cab *cab)
{
    return session_board(&cab->session);
}

const struct board_fault *cab_fault(const struct cab *cab)
{
    return board_last_output(cab_live(cab))->fault;
}

void cab_notice(struct cab *cab, int frames, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    vsnprintf(cab->notice, sizeof cab->notice, format, args);
    va_end(args);
    cab->notice_left = frames;
}

void cab_free_name(struct cab *cab, char name[CAB_NAME], const char *where, const char *what)
{
    size_t size;
    int i = 1;
    do
        snprintf(name, CAB_NAME, "%s%s-%d.%s", where, cab_cart(cab)->manifest.id, i++, what);
    while (plat_file_size(name) >= 0 || unsaved_bytes(cab->unsaved.files, name, &size));
}

void cab_attract_end(struct cab *cab)
{
    guard_close(&cab->attract_guard);
    demo_free(&cab->attract);
    cab->attracting = false;
}

void cab_hear_once(struct cab *cab, enum speaker_way way)
{
    speaker_hear(&cab->speaker, cab->attracting ? cab->attract_guard.board : cab_live(cab), way, 1);
}

void cab_log_lines(struct cab *cab, const struct board_out *out)
{
    char line[4097];
    for (size_t i = 0; i < out->log_size;) {
        const char *end = memchr(out->log + i, '\n', out->log_size - i);
        size_t n = end ? (size_t)(end - (out->log + i)) : out->log_size - i;
        snprintf(line, sizeof line, "%.*s", (int)n, out->log + i);
        clean_line(line);
        plat_log(line);
        cab_note(cab, LOG_PRINTED, line);
        i += n + 1;
    }
}

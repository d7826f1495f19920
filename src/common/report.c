/*
 * report.c - prints errors, faults and script output (report.h).
 */
#include "report.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"
#include "clean.h"
#include "files.h"
#include "progress.h"

enum { LINE = 2048, LOG_LINE = 512, PRINT = 8192 };

static void log_clean(char *s)
{
    clean_line(s);
    fflush(stdout); /* keeps the order if both streams go to the same file */
    progress_clear();
    plat_log(s);
}

static char last[LINE];

const char *report_last(void)
{
    return last;
}

enum result report_line(enum result result, const char *format, ...)
{
    char line[LINE] = "curtain: ";
    size_t n = strlen(line);
    va_list args;

    va_start(args, format);
    vsnprintf(line + n, sizeof line - n, format, args);
    va_end(args);
    log_clean(line);
    if (result != RESULT_DONE)
        snprintf(last, sizeof last, "%s", line + n);
    return result;
}

void report_print(const char *format, ...)
{
    char text[PRINT];
    va_list args;

    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    clean_lines(text);
    fputs(text, stdout);
}

enum result report_error(const char *err)
{
    return report_line(result_take_cause(), "%s", err);
}

static void log_lines(const char *text)
{
    char line[LINE];

    while (*text) {
        size_t n = strcspn(text, "\n");
        snprintf(line, sizeof line, "%.*s", (int)(n < sizeof line ? n : sizeof line - 1), text);
        log_clean(line);
        text += n + (text[n] == '\n');
    }
}

enum result report_fault(const struct board_fault *fault, bool trace)
{
    char line[sizeof fault->message];

    snprintf(line, sizeof line, "%s", fault->message);
    log_clean(line);
    snprintf(last, sizeof last, "%s", line);
    if (trace)
        log_lines(fault->trace);
    return RESULT_REFUSED;
}

void report_log(const struct board_out *out, const char *prefix)
{
    char line[LOG_LINE];

    if (out->log_size)
        progress_clear();
    for (size_t i = 0; i < out->log_size;) {
        const char *from = out->log + i, *end = memchr(from, '\n', out->log_size - i);
        size_t n = end ? (size_t)(end - from) : out->log_size - i;
        snprintf(line, sizeof line, "%s%.*s", prefix, (int)(n < sizeof line ? n : sizeof line - 1), from);
        clean_line(line);
        plat_log(line);
        i += n + 1;
    }
}

enum result report_save_png(const char *path, uint8_t *png, size_t size)
{
    char err[FILES_ERR_SIZE];

    if (!png)
        return report_line(RESULT_HOST_FAILED, "%s: out of memory", path);
    const bool saved = files_save(path, png, size, err, sizeof err);
    free(png);
    return saved ? RESULT_DONE : report_line(RESULT_HOST_FAILED, "%s", err);
}

enum result report_stdout(enum result result)
{
    if (fflush(stdout) == 0 && !ferror(stdout))
        return result;
    return report_line(RESULT_HOST_FAILED, "cannot write to standard output");
}

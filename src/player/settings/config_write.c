/*
 * config_write.c - saves settings (config.h). The file is edited line by line, so that the user's own lines and
 * comments are preserved.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../common/result.h"
#include "config.h"
#include "../../common/files.h"

/* A text that grows. */
struct text {
    char *at; /* malloc; NULL: out of memory */
    size_t n;
};

/* Replaces `removed` bytes at `at` with s. */
static void splice(struct text *t, size_t at, size_t removed, const char *s)
{
    const size_t n = strlen(s);
    char *larger = t->at ? realloc(t->at, t->n + n + 1) : NULL;

    if (!larger) {
        free(t->at);
        t->at = NULL;
        return;
    }
    t->at = larger;
    memmove(larger + at + n, larger + at + removed, t->n - at - removed + 1);
    memcpy(larger + at, s, n);
    t->n = t->n + n - removed;
}

/* Returns whether a line of n bytes sets that name; its value is then from *from to *to. */
static bool is_line_of(const char *line, size_t n, const char *name, size_t *from, size_t *to)
{
    const char *hash = memchr(line, '#', n), *equals;
    const size_t end = hash ? (size_t)(hash - line) : n, len = strlen(name);
    size_t at = 0;

    while (at < end && strchr(" \t\r", line[at]))
        at++;
    if (end - at < len || memcmp(line + at, name, len) != 0)
        return false;
    at += len;
    equals = memchr(line + at, '=', end - at);
    if (!equals || strspn(line + at, " \t\r") < (size_t)(equals - line) - at)
        return false;
    *from = (size_t)(equals - line) + 1;
    *to = end;
    while (*to > *from && strchr(" \t\r", line[*to - 1]))
        --*to;
    return true;
}

/* Sets a value in the name's last line, or in a new line if there is none or it would become too long. */
static void set_line(struct text *t, const char *name, const char *value)
{
    char words[CONFIG_LINE];
    size_t from = 0, to = 0, at = 0;
    bool found = false;

    for (size_t i = 0; t->at && i < t->n;) {
        const char *end = memchr(t->at + i, '\n', t->n - i);
        const size_t n = end ? (size_t)(end - (t->at + i)) : t->n - i;
        size_t a, b;
        if (is_line_of(t->at + i, n, name, &a, &b)) {
            found = n - (b - a) + 1 + strlen(value) < CONFIG_LINE;
            at = i;
            from = a;
            to = b;
        }
        i += n + 1;
    }
    if (found) {
        snprintf(words, sizeof words, "%s%s", value[0] ? " " : "", value);
        splice(t, at + from, to - from, words);
        return;
    }
    snprintf(words, sizeof words, "%s%s = %s\n", t->at && t->n > 0 && t->at[t->n - 1] != '\n' ? "\n" : "", name, value);
    splice(t, t->n, 0, words);
}

static void set_line_of_dip(struct text *t, const struct config *was, const struct config_dip *dip)
{
    for (int i = 0; i < was->n_dips; i++)
        if (strcmp(was->dips[i].name, dip->name) == 0 && strcmp(was->dips[i].value, dip->value) == 0)
            return;
    set_line(t, dip->name, dip->value);
}

char *config_edit(const struct config *c, const char *text, size_t size, char *err, size_t err_size)
{
    struct text t = { malloc(size + 1), size };
    struct config was;
    char value[CONFIG_LINE], shown[FILES_PATH_SIZE];
    const struct config_setting *s;

    config_defaults(&was);
    if (!config_read(&was, files_display_name(CONFIG_FILE, shown), text, size, err, err_size)) {
        free(t.at);
        return NULL;
    }
    if (t.at) {
        memcpy(t.at, text, size);
        t.at[size] = 0;
    }
    for (int i = 0; (s = config_setting(i)) != NULL; i++) {
        config_text(c, s, value, sizeof value);
        if (config_value(c, s) != config_value(&was, s))
            set_line(&t, s->name, value);
    }
    if (strcmp(c->lang, was.lang) != 0)
        set_line(&t, "lang", c->lang);
    for (int i = 0; i < c->n_dips; i++)
        set_line_of_dip(&t, &was, &c->dips[i]);
    for (int i = 0; i < KEYS_ACTIONS; i++)
        if (memcmp(c->keys.code[i], was.keys.code[i], sizeof c->keys.code[i]) != 0) {
            keys_write_list(&c->keys, keys_action_name(i), value, sizeof value);
            set_line(&t, keys_action_name(i), value);
        }
    if (t.at && t.n <= CONFIG_BYTES)
        return t.at;
    files_display_name(CONFIG_FILE, shown);
    if (t.at)
        err_set(err, err_size, "%s: the file would be larger than %d bytes", shown, CONFIG_BYTES);
    else
        result_set_host_error(err, err_size, "%s: out of memory", shown);
    free(t.at);
    return NULL;
}

bool config_save(const struct config *c, char *err, size_t err_size)
{
    char shown[FILES_PATH_SIZE];
    uint8_t *text = NULL;
    size_t size = 0;

    if (files_size(CONFIG_FILE) >= 0 && !files_read_text(CONFIG_FILE, files_display_name(CONFIG_FILE, shown),
                                                         CONFIG_BYTES, &text, &size, err, err_size))
        return false;
    char *now = config_edit(c, text ? (const char *)text : "", size, err, err_size);
    const bool same = now && strlen(now) == size && (size == 0 || memcmp(now, text, size) == 0);
    const bool good = now && (same || files_save(CONFIG_FILE, now, strlen(now), err, err_size));
    free(text);
    free(now);
    return good;
}

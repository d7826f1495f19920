/*
 * args_value.c - parses and stores the values of options (args.h, args_parts.h).
 */
#include "args_parts.h"

#include <stdio.h>
#include <string.h>
#include "../../base/err.h"
#include "../settings/views.h"

/* Parses the text up to `end` as a decimal number, or as 0x and a hexadecimal number, of at most `most`. */
static bool number(const char *text, const char *end, uint64_t most, uint64_t *out)
{
    bool hex = text[0] == '0' && (text[1] == 'x' || text[1] == 'X') && end - text > 2;
    uint64_t base = hex ? 16 : 10, v = 0;
    const char *p = hex ? text + 2 : text;

    if (p == end)
        return false;
    for (; p < end; p++) {
        static const char digits[] = "0123456789abcdef0123456789ABCDEF";
        const char *at = *p ? strchr(digits, *p) : NULL;
        uint64_t digit = at ? (uint64_t)(at - digits) % 16 : 16;
        if (digit >= base || v > (most - digit) / base)
            return false;
        v = v * base + digit;
    }
    *out = v;
    return true;
}

static bool read_span(struct span *s, const char *p, const char *end)
{
    uint64_t v[3];
    int n = 0;

    for (bool more = true; more; n++) {
        const char *stop = memchr(p, ':', (size_t)(end - p));
        if (!stop && n == 0) /* as FIRST-END_OF_LIST */
            stop = memchr(p, '-', (size_t)(end - p));
        more = stop != NULL;
        if (n == 3 || !number(p, more ? stop : end, ARGS_MAX_FRAME, &v[n]))
            return false;
        p = more ? stop + 1 : end;
    }
    s->first = (uint32_t)v[0];
    s->last = (uint32_t)v[n > 1 ? 1 : 0];
    s->step = n > 2 ? (uint32_t)v[2] : 1;
    return s->step > 0;
}

bool args_frames(struct args *a, const char *text, char *err, size_t err_size)
{
    const char *p = text;

    a->n_spans = 0;
    for (bool more = true; more;) {
        size_t n = strcspn(p, ",");
        struct span s;
        if (!read_span(&s, p, p + n))
            return err_set(err, err_size,
                           "--frames: expected frames from 0 to %d, as in 600 or 1,60,600 or 0:600:60, got \"%s\"",
                           ARGS_MAX_FRAME, text);
        if (s.last < s.first)
            return err_set(err, err_size, "--frames: %u:%u ends before it starts", (unsigned)s.first, (unsigned)s.last);
        if (a->n_spans == ARGS_MAX_SPANS)
            return err_set(err, err_size, "--frames: expected at most %d ranges", ARGS_MAX_SPANS);
        a->spans[a->n_spans++] = s;
        more = p[n] == ',';
        p += n + 1;
    }
    return true;
}

static bool in_span(const struct span *s, uint32_t frame)
{
    return frame >= s->first && frame <= s->last && (frame - s->first) % s->step == 0;
}

static const char *const buttons[PAD_BUTTON_COUNT] = PAD_BUTTON_NAMES;

/* Parses BUTTON or BUTTON@FRAMES; for player 2, 2.BUTTON. */
static bool read_press(struct press *out, const char *p, const char *end)
{
    const bool second = end - p > 2 && p[0] == '2' && p[1] == '.';

    p += second ? 2 : 0;
    const char *at = memchr(p, '@', (size_t)(end - p));
    const size_t n = (size_t)((at ? at : end) - p);
    *out = (struct press){ .player = second, .when = { 0, ARGS_MAX_FRAME, 1 } };
    for (int i = 0; i < PAD_BUTTON_COUNT; i++)
        if (strlen(buttons[i]) == n && memcmp(buttons[i], p, n) == 0)
            out->pad = (uint16_t)(1 << i);
    return out->pad && (!at || read_span(&out->when, at + 1, end));
}

bool args_presses(struct args *a, const char *text, char *err, size_t err_size)
{
    const char *p = text;

    for (bool more = true; more;) {
        const size_t n = strcspn(p, ",");
        if (a->n_presses == ARGS_MAX_PRESSES)
            return err_set(err, err_size, "--press: expected at most %d entries", ARGS_MAX_PRESSES);
        if (!read_press(&a->presses[a->n_presses++], p, p + n))
            return err_set(err, err_size,
                           "--press: expected buttons, as in fire or fire,focus or bomb@200 or left@60:90, got \"%s\" "
                           "(buttons: up down left right fire bomb focus special start select)",
                           text);
        more = p[n] == ',';
        p += n + 1;
    }
    return true;
}

bool args_speed(struct args *a, const char *text, char *err, size_t err_size)
{
    const bool slower = strncmp(text, "1/", 2) == 0;
    const char *n = text + (slower ? 2 : 0);
    uint64_t v;

    if (!number(n, n + strlen(n), ARGS_MAX_SPEED, &v) || v == 0)
        return err_set(err, err_size, "--speed: expected a whole number from 1 to %d, or 1/2 to 1/%d, got \"%s\"",
                       ARGS_MAX_SPEED, ARGS_MAX_SPEED, text);
    a->faster = slower ? 1 : (int)v;
    a->slower = slower ? (int)v : 1;
    return true;
}

void args_held_pads(const struct args *a, uint32_t frame, uint16_t pads[MAX_PLAYERS])
{
    memset(pads, 0, MAX_PLAYERS * sizeof *pads);
    for (int i = 0; i < a->n_presses; i++)
        if (in_span(&a->presses[i].when, frame))
            pads[a->presses[i].player] |= a->presses[i].pad;
}

bool args_has_frame(const struct args *a, uint32_t frame)
{
    for (int i = 0; i < a->n_spans; i++)
        if (in_span(&a->spans[i], frame))
            return true;
    return false;
}

uint32_t args_last_frame(const struct args *a)
{
    uint32_t last = 0;

    for (int i = 0; i < a->n_spans; i++) {
        const struct span *s = &a->spans[i];
        uint32_t end = s->last - (s->last - s->first) % s->step;
        last = end > last ? end : last;
    }
    return last;
}

/* ---- storing values ---- */

static bool store_text(const char **to, enum option o, const char *value, char *err, size_t err_size)
{
    if (!value[0])
        return err_set(err, err_size, "%s: expected %s, got nothing", args_options[o].name, args_options[o].value);
    *to = value;
    return true;
}

static bool store_word(int *to, enum option o, const char *value, char *err, size_t err_size)
{
    const char *const *words = args_options[o].store.words;
    char list[128];

    *to = views_find(words, value);
    if (*to >= 0)
        return true;
    views_list(words, list, sizeof list);
    return err_set(err, err_size, "%s: expected %s, got \"%s\"", args_options[o].name, list, value);
}

static bool store_number(void *to, enum option o, const char *value, char *err, size_t err_size)
{
    const struct store_rule *k = &args_options[o].store;
    uint64_t v;

    if (!number(value, value + strlen(value), k->max, &v) || v < k->min)
        return err_set(err, err_size, "%s: expected a whole number from %llu to %llu, got \"%s\"", args_options[o].name,
                       (unsigned long long)k->min, (unsigned long long)k->max, value);
    if (k->size == sizeof(uint64_t))
        *(uint64_t *)to = v;
    else
        *(uint32_t *)to = (uint32_t)v; /* also for an int, because `most` fits */
    return true;
}

static bool add_to_list(const char **list, int *n, enum option o, const char *value, char *err, size_t err_size)
{
    const struct store_rule *k = &args_options[o].store;
    const char *equals = strchr(value, '=');

    if (k->kind == STORE_SETTING && (!equals || equals == value || !equals[1]))
        return err_set(err, err_size, "%s: expected NAME=VALUE, got \"%s\"", args_options[o].name, value);
    if (*n == (int)k->max)
        return err_set(err, err_size, "%s: given more than %d times", args_options[o].name, (int)k->max);
    list[(*n)++] = value;
    return true;
}

bool args_repeats(enum option o)
{
    return args_options[o].store.kind == STORE_SETTING || args_options[o].store.kind == STORE_NAME;
}

bool args_store(struct args *a, enum option o, const char *value, char *err, size_t err_size)
{
    const struct store_rule *k = &args_options[o].store;
    void *to = (char *)a + k->at;

    switch (k->kind) {
    case STORE_NOTHING:
        return true;
    case STORE_SWITCH:
        *(bool *)to = true;
        return true;
    case STORE_CHOICE:
        *(int *)to = (int)args_options[o].store.min;
        return true;
    case STORE_TEXT:
        return store_text(to, o, value, err, err_size);
    case STORE_WORD:
        return store_word(to, o, value, err, err_size);
    case STORE_NUMBER:
        return store_number(to, o, value, err, err_size);
    case STORE_SETTING:
    case STORE_NAME:
        return add_to_list(to, (int *)(void *)((char *)a + k->count), o, value, err, err_size);
    case STORE_READ:
        return k->read(a, value, err, err_size);
    }
    return false;
}

/*
 * manifest.c - see manifest.h: defaults, ranges and the binary form. manifest_text.c reads the text form. One walk over
 * the struct serves for both reading and writing the binary form, so reader and writer cannot disagree.
 */
#include "manifest.h"

#include <assert.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "../../fb/utf8.h"
#include "../base/bytes.h"
#include "../base/err.h"
#include "../entities/enemies.h"
#include "../entities/fix.h"
#include "../entities/lasers.h"
#include "../entities/motion.h"
#include "../entities/options.h"
#include "../entities/registers.h"

/* The lump's first word is its format. numbers_in_format: how many fields of manifest_numbers each format contains.
 * Core versions up to 4 wrote format 1, core version 5 format 2, core version 6 format 3. The current version writes
 * the lowest format from 4 on that has all the fields that differ from their defaults. */
enum { FORMAT = 7, LOWEST_FORMAT = 4, FORMAT_1_NUMBERS = 17 };
static const int numbers_in_format[FORMAT + 1] = { 0, FORMAT_1_NUMBERS, 24, 31, 36, 37, 41, MANIFEST_NUMBERS };

static const int64_t max_extend = (int64_t)1 << 53;

#define NUMBER(name, field, lo, hi, default_value)                                                                     \
    {                                                                                                                  \
        name, offsetof(struct manifest, field), lo, hi, default_value, false                                           \
    }
#define FLAG(name, field)                                                                                              \
    {                                                                                                                  \
        name, offsetof(struct manifest, field), 0, 1, 0, true                                                          \
    }

const struct manifest_number manifest_numbers[MANIFEST_NUMBERS] = {
    NUMBER("version", version, 0, 1000000000, 1),
    NUMBER("screen.w", screen_w, 64, 1024, 240),
    NUMBER("screen.h", screen_h, 64, 1024, 320),
    NUMBER("field.x", field_x, 0, 1008, 0),
    NUMBER("field.y", field_y, 0, 1008, 0),
    NUMBER("field.w", field_w, 16, 1024, 240),
    NUMBER("field.h", field_h, 16, 1024, 320),
    NUMBER("field.margin", margin, 0, 1024, 64),
    NUMBER("board.bullets", bullets, 0, 1 << 22, 8192),
    NUMBER("board.shots", shots, 0, 1 << 16, 512),
    NUMBER("board.enemies", enemies, 0, MAX_ENEMIES, 256),
    NUMBER("board.sparks", sparks, 0, 1 << 22, 2048),
    NUMBER("board.sprites", sprites, 0, 1 << 16, 256),
    NUMBER("board.motions", motions, 0, 4095, 256),
    NUMBER("board.tasks", tasks, 1, 1 << 16, 1024),
    NUMBER("board.lua_kib", lua_kib, 256, 262144, 1024),
    NUMBER("players", players, 1, 2, 1),
    NUMBER("board.values.bullet", bullet_values, 0, MAX_VALUES, 0),
    NUMBER("board.values.shot", shot_values, 0, MAX_VALUES, 0),
    NUMBER("board.values.enemy", enemy_values, 0, MAX_VALUES, 0),
    FLAG("board.hp", has_hp),
    FLAG("board.around", has_orbit),
    FLAG("board.frozen", has_freeze),
    NUMBER("board.nvram", nvram_kib, 1, NV_MAX_KIB, NV_DEFAULT_KIB),
    FLAG("board.meet", bullets_can_meet),
    NUMBER("board.items", items, 0, 1 << 16, 0),
    NUMBER("board.lines", lines, 0, 4096, 0),
    FLAG("board.wide", has_wide_text),
    FLAG("board.bg", has_backgrounds),
    NUMBER("board.lasers", lasers, 0, MAX_LASERS, 0),
    NUMBER("board.curve_points", curve_points, 0, 1 << 20, 0),
    NUMBER("board.registers", registers, 0, MAX_REGISTERS, DEFAULT_REGISTER_CAPACITY),
    NUMBER("board.options", options, 0, MAX_OPTIONS, 0),
    FLAG("board.bodies", has_bodies),
    FLAG("board.pierce", has_pierce),
    FLAG("board.sound", has_sound),
    NUMBER("board.bulletml", bulletml_runners, 0, 1 << 16, 0),
    NUMBER("field.view.w", view_w, 0, 1024, 0),
    NUMBER("field.view.h", view_h, 0, 1024, 0),
    NUMBER("screen.zoom", zoom, 1, 4, 1),
    FLAG("board.transforms", has_transforms),
    NUMBER("screen.full_width", full_width, FIX_CELL_SIZE, 2 * FIX_CELL_SIZE, FIX_CELL_SIZE),
};

static int32_t *get_number(struct manifest *m, int i)
{
    return (int32_t *)(void *)((char *)m + manifest_numbers[i].offset);
}

void manifest_set_defaults(struct manifest *m)
{
    memset(m, 0, sizeof *m);
    strcpy(m->id, "game");
    strcpy(m->title, "Untitled");
    strcpy(m->entry, "main");
    for (int i = 0; i < MANIFEST_NUMBERS; i++)
        *get_number(m, i) = manifest_numbers[i].default_value;
    strcpy(m->difficulties[0], "normal");
    m->n_difficulties = 1;
}

static bool is_letter_or_digit(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool manifest_setting_name_ok(const char *s)
{
    size_t n = strlen(s);

    for (size_t i = 0; i < n; i++)
        if (!is_letter_or_digit(s[i]) && s[i] != '_' && s[i] != '-')
            return false;
    return n > 0 && n < MAX_SETTING_NAME;
}

bool manifest_path_ok(const char *s)
{
    char previous = '/';

    for (; *s != '\0'; previous = *s++) {
        if (*s == '/' ? previous == '/' : !is_letter_or_digit(*s) && strchr("_.-", *s) == NULL)
            return false;
        if (*s == '.' && previous == '/')
            return false;
    }
    return previous != '/';
}

static bool all_zero(const void *p, size_t n)
{
    const uint8_t *b = p;

    while (n > 0 && *b == 0)
        b++, n--;
    return n == 0;
}

/* Returns whether s ends inside its array, has only zeros after its end, and contains only printable characters. */
static bool text_ok(const char *s, size_t n)
{
    const char *p = s, *end = memchr(s, '\0', n);

    while (end != NULL && p < end)
        if (!utf8_may_show(utf8_next(&p, end)))
            return false;
    return end != NULL && all_zero(end, n - (size_t)(end - s));
}

static bool check_strings(const struct manifest *m, char *err, size_t err_size)
{
    if (!text_ok(m->id, sizeof m->id) || m->id[0] == '\0' ||
        m->id[strspn(m->id, "abcdefghijklmnopqrstuvwxyz0123456789_")] != '\0')
        return err_set(err, err_size, "id: expected 1 to %zu of the characters a-z 0-9 _", sizeof m->id - 1);
    if (!text_ok(m->title, sizeof m->title) || m->title[0] == '\0')
        return err_set(err, err_size, "title: expected a line of 1 to %zu bytes", sizeof m->title - 1);
    if (!text_ok(m->author, sizeof m->author))
        return err_set(err, err_size, "author: expected a line of at most %zu bytes", sizeof m->author - 1);
    if (!text_ok(m->entry, sizeof m->entry) || !manifest_path_ok(m->entry))
        return err_set(err, err_size, "entry: expected a script's path without .lua, at most %zu bytes",
                       sizeof m->entry - 1);
    return true;
}

static bool check_view(const struct manifest *m, char *err, size_t err_size)
{
    const int32_t w = manifest_view_w(m) * m->zoom, h = manifest_view_h(m) * m->zoom;
    const char *name = m->view_w ? "field.view" : "field";

    if (!m->view_w != !m->view_h || (m->view_w && (m->view_w < MIN_VIEW || m->view_h < MIN_VIEW)))
        return err_set(err, err_size, "field.view: expected a width and a height of at least %d px", MIN_VIEW);
    if (m->view_w > m->field_w || m->view_h > m->field_h)
        return err_set(err, err_size,
                       "field.view: %" PRId32 "x%" PRId32 " is larger than the %" PRId32 "x%" PRId32 " field",
                       m->view_w, m->view_h, m->field_w, m->field_h);
    if (m->view_w == m->field_w && m->view_h == m->field_h)
        return err_set(err, err_size, "field.view: the whole field is stored as 0x0");
    if (m->field_x + w > m->screen_w || m->field_y + h > m->screen_h)
        return err_set(err, err_size,
                       "%s: %" PRId32 "x%" PRId32 " at %" PRId32 ",%" PRId32 " is not inside the %" PRId32 "x%" PRId32
                       " screen%s",
                       name, w, h, m->field_x, m->field_y, m->screen_w, m->screen_h,
                       m->view_w ? "" : "; to show a part of it, add view = { w = .., h = .. } to field");
    return true;
}

static bool check_numbers(const struct manifest *m, char *err, size_t err_size)
{
    for (int i = 0; i < MANIFEST_NUMBERS; i++) {
        const struct manifest_number *f = &manifest_numbers[i];
        int32_t v;
        memcpy(&v, (const char *)m + f->offset, sizeof v);
        if (v < f->lo || v > f->hi)
            return err_set(err, err_size, "%s: expected a whole number from %" PRId32 " to %" PRId32 ", got %" PRId32,
                           f->name, f->lo, f->hi, v);
    }
    if (m->screen_w % 8 != 0)
        return err_set(err, err_size, "screen.w: expected a multiple of 8, got %" PRId32, m->screen_w);
    return check_view(m, err, err_size);
}

static bool check_extends(const struct manifest *m, char *err, size_t err_size)
{
    int n = m->n_extends;

    if (n < 0 || n > MAX_EXTENDS || !all_zero(m->extends + n, (size_t)(MAX_EXTENDS - n) * sizeof m->extends[0]))
        return err_set(err, err_size, "extends: expected at most %d scores", MAX_EXTENDS);
    for (int i = 0; i < n; i++)
        if (m->extends[i] < (i > 0 ? m->extends[i - 1] + 1 : 1) || m->extends[i] > max_extend)
            return err_set(err, err_size, "extends: expected ascending scores from 1 to %" PRId64 ", got %" PRId64,
                           max_extend, m->extends[i]);
    return true;
}

/* Returns whether the first n of `max` names are valid and distinct, and the rest are zero. */
static bool setting_names_ok(const char names[][MAX_SETTING_NAME], int n, int max)
{
    for (int i = 0; i < n; i++) {
        if (!text_ok(names[i], MAX_SETTING_NAME) || !manifest_setting_name_ok(names[i]))
            return false;
        for (int j = 0; j < i; j++)
            if (strcmp(names[i], names[j]) == 0)
                return false;
    }
    return all_zero(names + n, (size_t)(max - n) * MAX_SETTING_NAME);
}

static bool check_difficulties(const struct manifest *m, char *err, size_t err_size)
{
    int n = m->n_difficulties;

    if (n < 1 || n > MAX_DIFFICULTIES || !setting_names_ok(m->difficulties, n, MAX_DIFFICULTIES))
        return err_set(err, err_size, "difficulties: expected 1 to %d different words of at most %d letters",
                       MAX_DIFFICULTIES, MAX_SETTING_NAME - 1);
    if (m->difficulty < 0 || m->difficulty >= n)
        return err_set(err, err_size, "difficulty: not listed in difficulties");
    return true;
}

static bool check_dip(const struct dip *d, char *err, size_t err_size)
{
    if (!text_ok(d->name, sizeof d->name) || !manifest_setting_name_ok(d->name))
        return err_set(err, err_size, "dip: expected names of 1 to %d letters, digits, _ or -", MAX_SETTING_NAME - 1);
    if (d->n_values < 0 || d->n_values > MAX_DIP_VALUES ||
        !setting_names_ok(d->value_name, d->n_values, MAX_DIP_VALUES))
        return err_set(err, err_size, "dip.%s: expected 1 to %d different words of at most %d letters", d->name,
                       MAX_DIP_VALUES, MAX_SETTING_NAME - 1);
    if (d->is_number ? d->n_values != 0 : d->n_values == 0 || d->lo != 0 || d->hi != d->n_values - 1)
        return err_set(err, err_size, "dip.%s: expected either a range or 1 to %d values", d->name, MAX_DIP_VALUES);
    if (d->lo > d->hi || d->default_value < d->lo || d->default_value > d->hi)
        return err_set(err, err_size, "dip.%s: expected min <= default <= max, got %" PRId32 ", %" PRId32 ", %" PRId32,
                       d->name, d->lo, d->default_value, d->hi);
    if ((int64_t)d->hi - d->lo >= MAX_DIP_RANGE)
        return err_set(err, err_size,
                       "dip.%s: expected at most %d numbers from min to max, got %" PRId32 " to %" PRId32, d->name,
                       MAX_DIP_RANGE, d->lo, d->hi);
    return true;
}

static bool check_dips(const struct manifest *m, char *err, size_t err_size)
{
    int n = m->n_dips;

    if (n < 0 || n > MAX_DIPS)
        return err_set(err, err_size, "dip: expected at most %d switches", MAX_DIPS);
    for (int i = 0; i < n; i++) {
        if (!check_dip(&m->dips[i], err, err_size))
            return false;
        if (i > 0 && strcmp(m->dips[i - 1].name, m->dips[i].name) >= 0)
            return err_set(err, err_size, "dip.%s: not in alphabetical order", m->dips[i].name);
    }
    return true;
}

bool manifest_check(const struct manifest *m, char *err, size_t err_size)
{
    return check_strings(m, err, err_size) && check_numbers(m, err, err_size) && check_extends(m, err, err_size) &&
           check_difficulties(m, err, err_size) && check_dips(m, err, err_size);
}

/* A walk over the struct that writes or reads the bytes of the lump. */
struct walk {
    uint8_t *out;      /* NULL: reading */
    const uint8_t *in; /* NULL: writing */
    bool is_valid;
};

static void walk_bytes(struct walk *w, void *bytes, size_t n)
{
    if (w->out != NULL) {
        memcpy(w->out, bytes, n);
        w->out += n;
    } else {
        memcpy(bytes, w->in, n);
        w->in += n;
    }
}

static void walk_32(struct walk *w, int32_t *v)
{
    uint8_t bytes[4];

    bytes_put32(bytes, (uint32_t)*v);
    walk_bytes(w, bytes, sizeof bytes);
    *v = (int32_t)bytes_get32(bytes);
}

static void walk_64(struct walk *w, int64_t *v)
{
    uint8_t bytes[8];

    bytes_put64(bytes, (uint64_t)*v);
    walk_bytes(w, bytes, sizeof bytes);
    *v = (int64_t)bytes_get64(bytes);
}

static void walk_dip(struct walk *w, struct dip *d)
{
    int32_t number = d->is_number;

    walk_bytes(w, d->name, sizeof d->name);
    walk_32(w, &number);
    walk_32(w, &d->lo);
    walk_32(w, &d->hi);
    walk_32(w, &d->default_value);
    walk_32(w, &d->n_values);
    walk_bytes(w, d->value_name[0], sizeof d->value_name);
    d->is_number = number != 0;
    w->is_valid = w->is_valid && (number == 0 || number == 1);
}

static void walk_numbers(struct walk *w, struct manifest *m, int from, int to)
{
    for (int i = from; i < to; i++)
        walk_32(w, get_number(m, i));
}

static void walk_manifest(struct walk *w, struct manifest *m, int32_t expected)
{
    int32_t format = expected;

    walk_32(w, &format);
    w->is_valid = format == expected;
    walk_bytes(w, m->id, sizeof m->id);
    walk_bytes(w, m->title, sizeof m->title);
    walk_bytes(w, m->author, sizeof m->author);
    walk_bytes(w, m->entry, sizeof m->entry);
    walk_numbers(w, m, 0, FORMAT_1_NUMBERS);
    for (int i = 0; i < MAX_EXTENDS; i++)
        walk_64(w, &m->extends[i]);
    walk_32(w, &m->n_extends);
    walk_bytes(w, m->difficulties[0], sizeof m->difficulties);
    walk_32(w, &m->n_difficulties);
    walk_32(w, &m->difficulty);
    for (int i = 0; i < MAX_DIPS; i++)
        walk_dip(w, &m->dips[i]);
    walk_32(w, &m->n_dips);
    walk_numbers(w, m, FORMAT_1_NUMBERS, numbers_in_format[expected]);
}

static size_t format_size(int format)
{
    return MANIFEST_BYTES - 4 * (size_t)(MANIFEST_NUMBERS - numbers_in_format[format]);
}

/* Returns the lowest format that has all the fields that differ from their defaults. */
static int needed_format(struct manifest *m)
{
    int i = MANIFEST_NUMBERS, format = LOWEST_FORMAT;

    while (i > 0 && *get_number(m, i - 1) == manifest_numbers[i - 1].default_value)
        i--;
    while (numbers_in_format[format] < i)
        format++;
    return format;
}

uint32_t manifest_pack(const struct manifest *m, uint8_t out[MANIFEST_BYTES])
{
    struct manifest copy = *m;
    const int format = needed_format(&copy);
    struct walk w = { out, NULL, true };

    memset(out, 0, MANIFEST_BYTES);
    walk_manifest(&w, &copy, format);
    assert(w.out == out + format_size(format));
    return (uint32_t)format_size(format);
}

static bool unused_dips_zero(const struct manifest *m)
{
    for (int i = m->n_dips; i < MAX_DIPS; i++) {
        const struct dip *d = &m->dips[i];
        if (d->is_number || d->lo != 0 || d->hi != 0 || d->default_value != 0 || d->n_values != 0 ||
            !all_zero(d->name, sizeof d->name) || !all_zero(d->value_name, sizeof d->value_name))
            return false;
    }
    return true;
}

bool manifest_unpack(const uint8_t *data, size_t size, struct manifest *m, char *err, size_t err_size)
{
    struct walk w = { NULL, data, true };
    int format = FORMAT;

    while (format > 0 && size != format_size(format))
        format--;
    if (!format)
        return err_set(err, err_size, "%zu bytes long, expected %d", size, MANIFEST_BYTES);
    memset(m, 0, sizeof *m);
    m->nvram_kib = NV_DEFAULT_KIB; /* format 1 has no nvram_kib */
    m->registers = MAX_REGISTERS;  /* formats 1 to 3 have no registers field; ships could have this many */
    m->zoom = 1;                   /* formats 1 to 5 have no zoom */
    m->full_width = FIX_CELL_SIZE; /* only format 7 has a full_width */
    walk_manifest(&w, m, format);
    if (!w.is_valid)
        return err_set(err, err_size, "unknown format");
    if (format > needed_format(m) && format > LOWEST_FORMAT)
        return err_set(err, err_size, "of format %d, though format %d has all of its fields", format, needed_format(m));
    if (!manifest_check(m, err, err_size))
        return false;
    return unused_dips_zero(m) ? true : err_set(err, err_size, "dip: unused switches are not zero");
}

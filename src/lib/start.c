/*
 * start.c - how a run starts: read from a host's configuration, a demo or a state, and written to a state.
 */
#include <string.h>
#include "../base/bytes.h"
#include "../base/err.h"
#include "../base/hash.h"
#include "lib.h"

enum { SETTING_SIZE = 64 /* capacity in bytes of a NAME=VALUE word of config.switches, including the NUL */ };

static bool is_printable(const char *text)
{
    for (; *text; text++)
        if (*text < 32 || *text > 126)
            return false;
    return true;
}

/* Copies a string from the host. Does not change *out if text is NULL. name: the string's name in errors, such as
 * "section". */
static bool copy_host_string(char *out, size_t size, const char *text, const char *name, char *err, size_t err_size)
{
    if (!text)
        return true;
    if (!is_printable(text))
        return err_set(err, err_size, "%s: expected printable ASCII", name);
    if (strlen(text) >= size)
        return err_set(err, err_size, "%s: expected at most %zu characters, got %zu", name, size - 1, strlen(text));
    memcpy(out, text, strlen(text) + 1);
    return true;
}

static bool set_difficulty(struct board_start *start, const struct manifest *m, const char *name, char *err,
                           size_t err_size)
{
    if (!name)
        return true;
    for (int i = 0; i < m->n_difficulties; i++)
        if (strcmp(m->difficulties[i], name) == 0) {
            start->difficulty = i;
            return true;
        }
    return err_set(err, err_size, "unknown difficulty \"%.32s\"", name);
}

/* Parses an integer; returns false when the whole string is not a valid number. */
static bool parse_int(const char *text, int32_t *out)
{
    const bool negative = *text == '-';
    int64_t n = 0;

    for (text += negative; *text >= '0' && *text <= '9' && n <= INT32_MAX; text++)
        n = n * 10 + (*text - '0');
    *out = (int32_t)(negative ? -n : n);
    return *text == 0 && n <= INT32_MAX && (text[-1] >= '0' && text[-1] <= '9');
}

static bool parse_switch_value(const struct dip *dip, const char *text, int32_t *out, char *err, size_t err_size)
{
    int32_t n;

    for (int i = 0; !dip->is_number && i < dip->n_values; i++)
        if (strcmp(dip->value_name[i], text) == 0) {
            *out = i;
            return true;
        }
    if (!dip->is_number || *text == 0 || !parse_int(text, &n) || n < dip->lo || n > dip->hi)
        return err_set(err, err_size, "switches: %s: invalid value \"%.32s\"", dip->name, text);
    *out = n;
    return true;
}

/* Sets the DIP switch that `setting`, "NAME=VALUE", names. Overwrites the '=' in it with a NUL. */
static bool set_switch(struct board_start *start, const struct manifest *m, char *setting, char *err, size_t err_size)
{
    char *equals = strchr(setting, '=');

    if (!equals)
        return err_set(err, err_size, "switches: expected NAME=VALUE, got \"%s\"", setting);
    *equals = 0;
    for (int i = 0; i < m->n_dips; i++)
        if (strcmp(m->dips[i].name, setting) == 0)
            return parse_switch_value(&m->dips[i], equals + 1, &start->dip[i], err, err_size);
    return err_set(err, err_size, "switches: unknown switch \"%s\"", setting);
}

/* Sets all DIP switches to their defaults, then to the values in text: "coins=one pace=3"; NULL: none. */
static bool set_switches(struct board_start *start, const struct manifest *m, const char *text, char *err,
                         size_t err_size)
{
    char setting[SETTING_SIZE];

    for (int i = 0; i < m->n_dips; i++)
        start->dip[i] = m->dips[i].default_value;
    for (size_t n = 0; text && *(text += strspn(text, " ")); text += n) {
        n = strcspn(text, " ");
        if (n >= sizeof setting)
            return err_set(err, err_size, "switches: \"%.32s...\" is too long", text);
        memcpy(setting, text, n);
        setting[n] = 0;
        if (!set_switch(start, m, setting, err, err_size))
            return false;
    }
    return true;
}

static bool copy_nvram(struct lib_start *out, const void *nvram, size_t size, char *err, size_t err_size)
{
    if (!nvram)
        return true;
    if (size > MAX_NVRAM)
        return err_set(err, err_size, "nvram: expected at most %d bytes, got %zu", MAX_NVRAM, size);
    size = size < out->nvram_cap ? size : out->nvram_cap; /* ignore bytes beyond the game's capacity */
    memcpy(out->nvram, nvram, size);
    out->start.nvram = out->nvram;
    out->start.nvram_size = size;
    return true;
}

static void set_hash(struct lib_start *s)
{
    uint8_t encoded[1024];
    size_t n = lib_start_serialize(&(struct lib_start){ .start = s->start, .nvram_cap = 0 }, encoded);

    s->hash = hash_bytes(hash_bytes(HASH_START, encoded, n), s->nvram, s->start.nvram_size);
}

/* Copies the start recorded in a demo. */
static bool copy_demo_start(struct lib_start *out, const struct demo *demo, const struct cart *cart, char *err,
                            size_t err_size)
{
    if (!demo_check_cart(demo, cart, err, err_size))
        return false;
    out->start = demo->start;
    out->start.nvram = NULL;
    out->start.nvram_size = 0;
    return copy_nvram(out, demo->start.nvram, demo->start.nvram_size, err, err_size);
}

bool lib_start_init(struct lib_start *out, const struct cart *cart, const struct curtain_config *config,
                    const struct demo *demo, char *err, size_t err_size)
{
    struct board_start *start = &out->start;

    if (demo) {
        if (!copy_demo_start(out, demo, cart, err, err_size))
            return false;
        set_hash(out);
        return true;
    }

    *start = (struct board_start){ .seed = config->seed, .difficulty = -1 };
    start->practice.lives = config->lives;
    start->practice.invincible = config->invincible;
    if (!copy_host_string(start->lang, sizeof start->lang, config->lang, "lang", err, err_size) ||
        !copy_host_string(start->practice.section, sizeof start->practice.section, config->section, "section", err,
                          err_size) ||
        !set_difficulty(start, &cart->manifest, config->difficulty, err, err_size) ||
        !set_switches(start, &cart->manifest, config->switches, err, err_size) ||
        !copy_nvram(out, config->nvram, config->nvram_size, err, err_size))
        return false;
    set_hash(out);
    return true;
}

/* ---- serialized form ----
 *
 * u64 seed, i32 difficulty, 16 i32 switches, 16 bytes language, 64 bytes section, i32 lives, u8 flags, u8 number of
 * registers, 16 registers (32 bytes name, i32 value), u32 size of nvram, and its bytes. Strings are padded
 * with zeroes.
 */
enum { FLAG_INVINCIBLE = 1, FLAG_LARGE_HUD = 2, FLAG_AT_TITLE = 4 };
enum {
    N_DIPS = sizeof((struct board_start *)0)->dip / sizeof(int32_t),
    LANG_SIZE = sizeof((struct board_start *)0)->lang,
    SECTION_SIZE = sizeof((struct practice *)0)->section,
    NAME_SIZE = sizeof((struct practice *)0)->reg[0].name,
    HEAD_SIZE = 8 + 4 + 4 * N_DIPS + LANG_SIZE + SECTION_SIZE + 4 + 1 + 1 + (NAME_SIZE + 4) * PRACTICE_MAX_REGISTERS + 4
};

static void put_text(uint8_t *at, const char *text, size_t size)
{
    memset(at, 0, size);
    memcpy(at, text, strlen(text));
}

/* Returns false unless the bytes are printable ASCII padded with zeroes. */
static bool get_text(char *text, const uint8_t *at, size_t size)
{
    memcpy(text, at, size);
    for (size_t n = strnlen(text, size); n < size; n++)
        if (at[n] != 0)
            return false;
    return at[size - 1] == 0 && is_printable(text);
}

size_t lib_start_max_size(const struct lib_start *s)
{
    return HEAD_SIZE + s->nvram_cap;
}

size_t lib_start_serialize(const struct lib_start *s, uint8_t *out)
{
    const struct board_start *start = &s->start;
    const struct practice *p = &start->practice;
    const size_t nvram = s->nvram_cap > 0 ? start->nvram_size : 0;
    uint8_t *at = out;

    bytes_put64(at, start->seed);
    bytes_put32(at + 8, (uint32_t)start->difficulty);
    at += 12;
    for (size_t i = 0; i < N_DIPS; i++, at += 4)
        bytes_put32(at, (uint32_t)start->dip[i]);
    put_text(at, start->lang, LANG_SIZE);
    put_text(at + LANG_SIZE, p->section, SECTION_SIZE);
    at += LANG_SIZE + SECTION_SIZE;
    bytes_put32(at, (uint32_t)p->lives);
    at[4] = (uint8_t)((p->invincible ? FLAG_INVINCIBLE : 0) | (start->large_hud ? FLAG_LARGE_HUD : 0) |
                      (start->at_title ? FLAG_AT_TITLE : 0));
    at[5] = (uint8_t)p->register_count;
    at += 6;
    for (int i = 0; i < PRACTICE_MAX_REGISTERS; i++, at += NAME_SIZE + 4) {
        put_text(at, p->reg[i].name, NAME_SIZE);
        bytes_put32(at + NAME_SIZE, (uint32_t)p->reg[i].value);
    }
    bytes_put32(at, (uint32_t)nvram);
    if (nvram > 0)
        memcpy(at + 4, start->nvram, nvram);
    return HEAD_SIZE + nvram;
}

static bool read_practice(struct practice *p, const uint8_t *at)
{
    bool good = at[SECTION_SIZE + 4] <= (FLAG_INVINCIBLE | FLAG_LARGE_HUD | FLAG_AT_TITLE) &&
                at[SECTION_SIZE + 5] <= PRACTICE_MAX_REGISTERS && get_text(p->section, at, SECTION_SIZE);

    p->lives = (int32_t)bytes_get32(at + SECTION_SIZE);
    p->invincible = at[SECTION_SIZE + 4] & FLAG_INVINCIBLE;
    p->register_count = at[SECTION_SIZE + 5];
    at += SECTION_SIZE + 6;
    for (int i = 0; good && i < PRACTICE_MAX_REGISTERS; i++, at += NAME_SIZE + 4) {
        good = get_text(p->reg[i].name, at, NAME_SIZE);
        p->reg[i].value = (int32_t)bytes_get32(at + NAME_SIZE);
    }
    return good && strcmp(p->section, PRACTICE_LIST) != 0;
}

bool lib_start_read(struct lib_start *out, const uint8_t *bytes, size_t size)
{
    struct board_start *start = &out->start;
    const uint8_t *at = bytes + 12;

    if (size < HEAD_SIZE)
        return false;
    *start = (struct board_start){ .seed = bytes_get64(bytes), .difficulty = (int32_t)bytes_get32(bytes + 8) };
    for (size_t i = 0; i < N_DIPS; i++, at += 4)
        start->dip[i] = (int32_t)bytes_get32(at);
    const size_t nvram = bytes_get32(bytes + HEAD_SIZE - 4);
    if (start->difficulty < -1 || nvram != size - HEAD_SIZE || nvram > out->nvram_cap ||
        !get_text(start->lang, at, LANG_SIZE) || !read_practice(&start->practice, at + LANG_SIZE))
        return false;
    start->large_hud = at[LANG_SIZE + SECTION_SIZE + 4] & FLAG_LARGE_HUD;
    start->at_title = at[LANG_SIZE + SECTION_SIZE + 4] & FLAG_AT_TITLE;
    memcpy(out->nvram, bytes + HEAD_SIZE, nvram);
    start->nvram = nvram > 0 ? out->nvram : NULL;
    start->nvram_size = nvram;
    set_hash(out);
    return true;
}

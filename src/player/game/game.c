/*
 * game.c - loads a game and sets its start (game.h).
 */
#include "game.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../common/report.h"
#include "embedded_rom.h"
#include "workbench.h"

/* ---- loading ---- */

static bool load_builtin(struct game *g, char *err, size_t err_size)
{
    const struct embedded_rom *own = embedded_rom_game();
    const uint8_t *rom = own->rom ? own->rom : builtin_rom;
    const size_t size = own->rom ? own->size : builtin_rom_size;
    char why[512];

    if (size == 0)
        return err_set(err, err_size, "no built-in game; name a ROM (see curtain help)");
    if (rom_open(&g->rom, rom, size, why, sizeof why) && cart_open(&g->cart, &g->rom, why, sizeof why))
        return true;
    return err_set(err, err_size, "built-in game: %s", why);
}

static bool load(struct game *g, const struct args *a, char *err, size_t err_size)
{
    char why[512];

    if (!g->path)
        return load_builtin(g, err, err_size);
    if (!workbench_loader(a->workbench)(g->path, a->nearest, &g->image, err, err_size))
        return false;
    g->rom = g->image.rom;
    if (cart_open(&g->cart, &g->rom, why, sizeof why))
        return true;
    return err_set(err, err_size, "%s: %s", g->path, why);
}

/* ---- the start ---- */

/* "a, b or c" */
static void join(char *out, size_t size, const char *const *words, int n)
{
    size_t at = 0;

    out[0] = 0;
    for (int i = 0; i < n && at < size; i++) {
        const char *between = i == 0 ? "" : i == n - 1 ? " or " : ", ";
        at += (size_t)snprintf(out + at, size - at, "%s%s", between, words[i]);
    }
}

static bool unknown(const char *option, const char *what, const char *word, const char *const *words, int n, char *err,
                    size_t err_size)
{
    char all[512];
    const char *meant = args_near(word, words, n);

    if (n == 0)
        return err_set(err, err_size, "%s: this game has no %s", option, what);
    join(all, sizeof all, words, n);
    if (meant)
        return err_set(err, err_size, "%s: unknown %s \"%s\" (did you mean \"%s\"?)", option, what, word, meant);
    return err_set(err, err_size, "%s: unknown %s \"%s\" (expected %s)", option, what, word, all);
}

static int index_of(const char *word, const char *const *words, int n)
{
    for (int i = 0; i < n; i++) {
        if (strcmp(word, words[i]) == 0)
            return i;
    }
    return -1;
}

static bool set_difficulty(struct game *g, const char *name, char *err, size_t err_size)
{
    const struct manifest *m = &g->cart.manifest;
    const char *names[MAX_DIFFICULTIES];

    for (int i = 0; i < m->n_difficulties; i++)
        names[i] = m->difficulties[i];
    g->start.difficulty = index_of(name, names, m->n_difficulties);
    if (g->start.difficulty >= 0)
        return true;
    return unknown("--difficulty", "difficulty", name, names, m->n_difficulties, err, err_size);
}

static bool set_lang(struct game *g, const char *name, char *err, size_t err_size)
{
    enum { MAX_NAMES = 64 };
    const char *names[MAX_NAMES];
    int n = g->cart.count[CART_LANGS] < MAX_NAMES ? g->cart.count[CART_LANGS] : MAX_NAMES;
    struct words words;

    for (int i = 0; i < n; i++)
        names[i] = cart_name(&g->cart, CART_LANGS, i);
    if (!cart_open_lang(&g->cart, name, &words))
        return unknown("--lang", "language", name, names, n, err, err_size);
    snprintf(g->start.lang, sizeof g->start.lang, "%s", name);
    return true;
}

/* Parses a whole number in range. strtoll alone would accept leading blanks and "". */
static bool whole_number(const char *text, int64_t lo, int64_t hi, int32_t *out)
{
    bool sign = text[0] == '-' || text[0] == '+';
    char *end;

    if (text[sign] < '0' || text[sign] > '9')
        return false;
    long long v = strtoll(text, &end, 10);
    if (*end || v < lo || v > hi)
        return false;
    *out = (int32_t)v;
    return true;
}

static bool number_value(const struct dip *dip, const char *text, int32_t *out, char *err, size_t err_size)
{
    if (whole_number(text, dip->lo, dip->hi, out))
        return true;
    return err_set(err, err_size, "--dip: %s: expected a whole number from %d to %d, got \"%s\"", dip->name, dip->lo,
                   dip->hi, text);
}

static bool dip_value(const struct dip *dip, const char *text, int32_t *out, char *err, size_t err_size)
{
    const char *names[MAX_DIP_VALUES];
    char option[32];

    if (dip->is_number)
        return number_value(dip, text, out, err, err_size);
    for (int i = 0; i < dip->n_values; i++)
        names[i] = dip->value_name[i];
    *out = index_of(text, names, dip->n_values);
    if (*out >= 0)
        return true;
    snprintf(option, sizeof option, "--dip: %s", dip->name);
    return unknown(option, "value", text, names, dip->n_values, err, err_size);
}

static bool set_dip(struct game *g, const char *setting, char *err, size_t err_size)
{
    const struct manifest *m = &g->cart.manifest;
    const char *names[MAX_DIPS], *equals = strchr(setting, '=');
    char name[64];

    for (int i = 0; i < m->n_dips; i++)
        names[i] = m->dips[i].name;
    snprintf(name, sizeof name, "%.*s", (int)(equals - setting), setting);
    int i = index_of(name, names, m->n_dips);
    if (i < 0)
        return unknown("--dip", "DIP switch", name, names, m->n_dips, err, err_size);
    return dip_value(&m->dips[i], equals + 1, &g->start.dip[i], err, err_size);
}

static bool set_stage(struct game *g, const char *stage, char *err, size_t err_size)
{
    size_t n = strlen(stage);

    for (size_t i = 0; i < n; i++) {
        if (stage[i] < 32 || stage[i] > 126)
            return err_set(err, err_size, "--stage: expected NAME, NAME:MARK or BOSS/PHASE in ASCII");
    }
    if (n >= sizeof g->start.practice.section)
        return err_set(err, err_size, "--stage: longer than %zu characters", sizeof g->start.practice.section - 1);
    if (strcmp(stage, PRACTICE_LIST) == 0)
        return err_set(err, err_size, "--stage: expected NAME, NAME:MARK or BOSS/PHASE, got \"%s\"", stage);
    memcpy(g->start.practice.section, stage, n + 1);
    return true;
}

/* NAME=VALUE of --register. The board checks whether the ship has the register. */
static bool set_register(struct practice *p, const char *setting, char *err, size_t err_size)
{
    const char *equals = strchr(setting, '=');
    size_t n = (size_t)(equals - setting);

    if (n >= sizeof p->reg[0].name)
        return err_set(err, err_size, "--register: name longer than %zu characters", sizeof p->reg[0].name - 1);
    char *name = p->reg[p->register_count].name;
    snprintf(name, sizeof p->reg[0].name, "%.*s", (int)n, setting);
    for (int i = 0; i < p->register_count; i++) {
        if (strcmp(p->reg[i].name, name) == 0)
            return err_set(err, err_size, "--register: %s is given twice", name);
    }
    if (!whole_number(equals + 1, -INT32_MAX, INT32_MAX, &p->reg[p->register_count].value))
        return err_set(err, err_size, "--register: %s: expected a whole number from %d to %d, got \"%s\"", name,
                       -INT32_MAX, INT32_MAX, equals + 1);
    p->register_count++;
    return true;
}

static bool set_practice(struct game *g, const struct args *a, char *err, size_t err_size)
{
    struct practice *p = &g->start.practice;

    p->lives = a->lives;
    p->invincible = a->invincible;
    for (int i = 0; i < a->n_registers; i++) {
        if (!set_register(p, a->registers[i], err, err_size))
            return false;
    }
    return !a->stage || set_stage(g, a->stage, err, err_size);
}

bool game_start(struct game *g, const struct args *a, char *err, size_t err_size)
{
    const struct manifest *m = &g->cart.manifest;

    g->start = (struct board_start){ .seed = a->seed, .difficulty = -1, .large_hud = a->large_hud };
    for (int i = 0; i < m->n_dips; i++)
        g->start.dip[i] = m->dips[i].default_value;
    for (int i = 0; i < a->n_dips; i++) {
        if (!set_dip(g, a->dips[i], err, err_size))
            return false;
    }
    if (a->difficulty && !set_difficulty(g, a->difficulty, err, err_size))
        return false;
    if (a->lang && !set_lang(g, a->lang, err, err_size))
        return false;
    return set_practice(g, a, err, err_size);
}

static bool start_of_demo(struct game *g, const char *path, char *err, size_t err_size)
{
    char why[256], buf[128];

    if (!demo_load(&g->demo, path, err, err_size))
        return false;
    if (!demo_check_cart(&g->demo, &g->cart, why, sizeof why))
        return err_set(err, err_size, "%s: %s", path, why);
    g->has_demo = true;
    g->start = g->demo.start;
    const char *doubt = demo_replay_warning(&g->demo, &g->cart, buf, sizeof buf);
    if (doubt)
        report_line(RESULT_DONE, "%s: %s; playback may diverge", path, doubt);
    if (!g->demo.complete)
        report_line(RESULT_DONE, "%s: truncated (no end mark); playing the first %u frames", path,
                    (unsigned)g->demo.frames);
    return true;
}

enum game_opened game_try(struct game *g, const char *path, const struct args *a, char *err, size_t err_size)
{
    bool loaded;

    memset(g, 0, sizeof *g);
    g->path = path;
    loaded = load(g, a, err, err_size);
    if (loaded && (a->demo ? start_of_demo(g, a->demo, err, err_size) : game_start(g, a, err, err_size)))
        return GAME_OPENED;
    game_close(g);
    return loaded ? GAME_BAD_ARGUMENTS : GAME_BAD_FILES;
}

bool game_open(struct game *g, const char *path, const struct args *a, char *err, size_t err_size)
{
    return game_try(g, path, a, err, err_size) == GAME_OPENED;
}

void game_close(struct game *g)
{
    demo_free(&g->demo);
    rom_image_free(&g->image);
    memset(g, 0, sizeof *g);
}

/*
 * fuzz_game.c - libFuzzer: any words, each up to a NUL byte, as what --dip, --register, --stage, --difficulty and
 * --lives are given: a word's first letter, d r s h or l, names its option. What is taken is what the words say, in the
 * game's ranges; what is refused says which option and why, in one sentence.
 */
#include "../../src/player/game/game.h"
#include "fuzz.h"

enum { WORDS = 64 };

/* A game with a switch of names, one of numbers, and one of every number there is. */
static void make(struct manifest *m)
{
    static const struct dip dips[] = {
        { .name = "coins", .n_values = 3, .value_name = { "free", "one", "two" } },
        { .name = "ships", .is_number = true, .lo = 1, .hi = 9, .default_value = 3 },
        { .name = "any", .is_number = true, .lo = INT32_MIN, .hi = INT32_MAX },
    };

    m->n_dips = sizeof dips / sizeof *dips;
    memcpy(m->dips, dips, sizeof dips);
    m->n_difficulties = 2;
    strcpy(m->difficulties[0], "easy");
    strcpy(m->difficulties[1], "hard");
    m->difficulty = 1;
}

/* The value of the last of n NAME=VALUE for this name; NULL: none. */
static const char *given(const char *const *words, int n, const char *name)
{
    size_t size = strlen(name);

    while (n-- > 0)
        if (strncmp(words[n], name, size) == 0 && words[n][size] == '=')
            return words[n] + size + 1;
    return NULL;
}

/* Is it a whole number, and this one? */
static bool reads(const char *s, int64_t v)
{
    int64_t sum = 0;
    bool below = *s == '-';

    s += below || *s == '+';
    need(*s != 0);
    for (; *s; s++) {
        need(*s >= '0' && *s <= '9' && sum <= INT32_MAX);
        sum = sum * 10 + (*s - '0');
    }
    return (below ? -sum : sum) == v;
}

static void taken(const struct game *g, const struct args *a)
{
    const struct manifest *m = &g->cart.manifest;
    const struct practice *p = &g->start.practice;
    const char *text;

    for (int i = 0; i < m->n_dips; i++) {
        const struct dip *dip = &m->dips[i];
        int32_t v = g->start.dip[i];
        text = given(a->dips, a->n_dips, dip->name);
        need(dip->is_number ? v >= dip->lo && v <= dip->hi : v >= 0 && v < dip->n_values);
        if (!text)
            need(v == dip->default_value);
        else
            need(dip->is_number ? reads(text, v) : strcmp(text, dip->value_name[v]) == 0);
    }
    need(g->start.difficulty >= -1 && g->start.difficulty < m->n_difficulties);
    need(!a->difficulty || strcmp(m->difficulties[g->start.difficulty], a->difficulty) == 0);
    need(strcmp(p->section, a->stage ? a->stage : "") == 0 && p->register_count == a->n_registers &&
         p->lives == a->lives);
    for (int i = 0; i < p->register_count; i++) {
        need((text = given(a->registers, a->n_registers, p->reg[i].name)) && reads(text, p->reg[i].value));
        for (int k = 0; k < i; k++)
            need(strcmp(p->reg[k].name, p->reg[i].name) != 0);
    }
}

/* Cuts text up to `end` into argv, and returns how many there are then. */
static int cut(char *text, const char *end, char *argv[WORDS + 1], int argc)
{
    static const char letters[] = "drslh";
    static char options[][16] = { "--dip", "--register", "--stage", "--lives", "--difficulty" };

    for (; text < end && argc + 1 < WORDS; text += strlen(text) + 1) {
        const char *letter = *text ? strchr(letters, *text) : NULL;
        if (!letter)
            continue;
        argv[argc++] = options[letter - letters];
        argv[argc++] = text + 1;
    }
    return argc;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static char program[] = "curtain", command[] = "hash", rom[] = "a.rom";
    char *argv[WORDS + 1] = { program, command, rom }, err[1024] = "";
    char *copy = fuzz_text(data, size);
    struct game *g = calloc(1, sizeof *g);
    struct args a = { 0 };
    int argc = 3;

    argc = cut(copy, copy + size, argv, argc);
    if (g && args_parse(&a, argc, argv, err, sizeof err)) {
        make(&g->cart.manifest);
        if (game_start(g, &a, err, sizeof err))
            taken(g, &a);
        else
            need(memchr(err, 0, sizeof err) && strncmp(err, "--", 2) == 0 && strstr(err, ": "));
    }
    free(g);
    free(copy);
    return 0;
}

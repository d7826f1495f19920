/*
 * args.c - parses the command line (args.h) with the tables in args_table.c.
 *
 * An option has the same form with every command, so options may precede the command. args_check.c checks afterwards
 * which options belong to it.
 */
#include "args_parts.h"

#include <stdio.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"

/* Returns the option whose name is the n bytes at name, or OPTIONS. */
static enum option find_option(const char *name, size_t n)
{
    static const struct {
        const char *name;
        enum option is;
    } shorts[] = { { "-h", OPTION_HELP },
                   { "-v", OPTION_VERBOSE },
                   { "--traceback", OPTION_VERBOSE },
                   { "-0", OPTION_NULL },
                   { "--out", OPTION_OUT } };

    for (int i = 0; i < OPTIONS; i++) {
        if (strlen(args_options[i].name) == n && memcmp(args_options[i].name, name, n) == 0)
            return (enum option)i;
    }
    for (size_t i = 0; i < sizeof shorts / sizeof shorts[0]; i++) {
        if (strlen(shorts[i].name) == n && memcmp(shorts[i].name, name, n) == 0)
            return shorts[i].is;
    }
    return OPTIONS;
}

static bool unknown_option(const char *word, size_t n, char *err, size_t err_size)
{
    const char *names[OPTIONS];
    char name[64];

    for (int i = 0; i < OPTIONS; i++)
        names[i] = args_options[i].name;
    snprintf(name, sizeof name, "%.*s", (int)(n < sizeof name ? n : sizeof name - 1), word);
    const char *meant = n < sizeof name ? args_near(name, names, OPTIONS) : NULL;
    if (meant)
        return err_set(err, err_size, "unknown option %s (did you mean %s?)", name, meant);
    return err_set(err, err_size, "unknown option %s (see curtain help)", name);
}

/* Parses the option argv[*i] and its value, if it takes one, and marks it in seen. */
static bool read_option(struct args *a, int argc, char **argv, int *i, bool seen[OPTIONS], char *err, size_t err_size)
{
    const char *word = argv[*i], *equals = strchr(word, '='), *value = NULL;
    size_t n = equals ? (size_t)(equals - word) : strlen(word);
    enum option o = find_option(word, n);

    if (o == OPTIONS)
        return unknown_option(word, n, err, err_size);
    if (!args_options[o].value && equals)
        return err_set(err, err_size, "%s takes no value, got \"%s\"", args_options[o].name, equals + 1);
    if (args_options[o].value) {
        if (!equals && *i + 1 >= argc)
            return err_set(err, err_size, "%s: expected %s, got nothing", args_options[o].name, args_options[o].value);
        value = equals ? equals + 1 : argv[++*i];
    }
    if (seen[o] && !args_repeats(o))
        return err_set(err, err_size, "%s is given twice", args_options[o].name);
    seen[o] = true;
    return args_store(a, o, value, err, err_size);
}

/* --help and --version override everything else. */
static bool take_over(struct args *a, enum command command)
{
    if (command == COMMAND_HELP) {
        bool named = a->n_words > 0 && args_command(a->words[0]) >= 0;
        a->n_words = named ? 1 : 0;
    } else {
        a->n_words = 0;
    }
    a->command = command;
    return true;
}

/* Longer arguments would leave no space for the reason in error messages. */
static bool check_lengths(int argc, char **argv, char *err, size_t err_size)
{
    for (int i = 1; i < argc; i++)
        if (strlen(argv[i]) > ARGS_MAX_WORD)
            return err_set(err, err_size, "argument longer than %d characters: \"%.32s...\"", ARGS_MAX_WORD, argv[i]);
    return true;
}

bool args_parse(struct args *a, int argc, char **argv, char *err, size_t err_size)
{
    bool seen[OPTIONS] = { false };
    bool only_words = false;

    *a = (struct args){ .words = argv, .every = 1, .bank = -1, .machine = 1 };
    if (!check_lengths(argc, argv, err, err_size))
        return false;
    for (int i = 1; i < argc; i++) /* only paths contain backslashes */
        plat_normalize_slashes(argv[i]);
    for (int i = 1; i < argc; i++) {
        if (!only_words && strcmp(argv[i], "--") == 0)
            only_words = true;
        else if (only_words || argv[i][0] != '-' || !argv[i][1])
            argv[a->n_words++] = argv[i];
        else if (!read_option(a, argc, argv, &i, seen, err, err_size))
            return false;
    }
    a->seeded = seen[OPTION_SEED];
    if (seen[OPTION_VERSION])
        return take_over(a, COMMAND_VERSION);
    if (seen[OPTION_HELP])
        return take_over(a, COMMAND_HELP);
    int command = a->n_words ? args_command(a->words[0]) : -1;
    if (command >= 0) {
        a->command = (enum command)command;
        a->words++;
        a->n_words--;
    } else if (a->n_words && !args_check_first(a, seen, err, err_size)) {
        return false;
    }
    return args_check(a, seen, err, err_size);
}

/*
 * args_check.c - checks which words and options belong together (args_parts.h).
 */
#include "args_parts.h"

#include <stdio.h>
#include <string.h>
#include "../../base/err.h"

static void list_commands(unsigned set_of, char *out, size_t size)
{
    size_t n = 0;

    out[0] = 0;
    for (int i = 0; i < COMMANDS && n < size; i++) {
        if (set_of >> i & 1)
            n += (size_t)snprintf(out + n, size - n, "%s%s", n ? ", " : "", args_commands[i].name);
    }
}

/* At most one option of each list may be given. */
static bool check_exclusive(const bool seen[OPTIONS], char *err, size_t err_size)
{
    static const struct {
        int n;
        enum option list[5];
    } sets[] = {
        { 4, { OPTION_BISECT, OPTION_RESTAMP, OPTION_RERECORD, OPTION_JSON } },
        { 2, { OPTION_ANNOTATIONS, OPTION_LUACHECK } },
        { 5, { OPTION_ALL, OPTION_LINUX, OPTION_WINDOWS, OPTION_WEB, OPTION_LIBRETRO } },
        { 4, { OPTION_ALL, OPTION_WEB, OPTION_LIBRETRO, OPTION_KEYS } },
        { 5, { OPTION_ALL, OPTION_WINDOWS, OPTION_WEB, OPTION_LIBRETRO, OPTION_DESKTOP } },
    };

    for (size_t s = 0; s < sizeof sets / sizeof *sets; s++) {
        const char *first = NULL;
        for (int i = 0; i < sets[s].n; i++) {
            const char *name = args_options[sets[s].list[i]].name;
            if (!seen[sets[s].list[i]])
                continue;
            if (first)
                return err_set(err, err_size, "%s cannot be combined with %s", name, first);
            first = name;
        }
    }
    return true;
}

/* --resume continues a run with its original start. */
static bool check_pairs(const struct args *a, const bool seen[OPTIONS], char *err, size_t err_size)
{
    static const enum option others[] = { OPTION_NO_RESUME, OPTION_DEMO,       OPTION_SEED, OPTION_DIP,
                                          OPTION_STAGE,     OPTION_DIFFICULTY, OPTION_LANG, OPTION_LARGE_HUD };

    for (size_t i = 0; a->resume && i < sizeof others / sizeof others[0]; i++)
        if (seen[others[i]])
            return err_set(err, err_size, "--resume cannot be combined with %s", args_options[others[i]].name);
    if (a->command == COMMAND_SURVIVE && a->all && a->map)
        return err_set(err, err_size, "--all cannot be combined with --map, which needs a single section");
    if (a->bots && (a->map || a->out || a->effort))
        return err_set(err, err_size, "--bots cannot be combined with %s: bots do not search",
                       a->map   ? "--map"
                       : a->out ? "-o"
                                : "--effort");
    if (a->command == COMMAND_LIST && a->json && !a->replays)
        return err_set(err, err_size, "list: --json needs --replays");
    return true;
}

/* --out, --wav, --play and --notes need the name of a sound, and exclude each other. */
static bool check_sound(const struct args *a, char *err, size_t err_size)
{
    const char *first = a->out ? "-o" : a->wav ? "--wav" : a->play ? "--play" : "--notes";

    if (a->command != COMMAND_SOUND || !(a->out || a->wav || a->play || a->notes))
        return true;
    if (a->n_words < 2)
        return err_set(err, err_size, "%s needs the name of a sound or a piece of music (see curtain help sound)",
                       first);
    if (a->wav && a->out)
        return err_set(err, err_size, "--wav cannot be combined with -o: both name the output file");
    if (a->play && (a->out || a->wav))
        return err_set(err, err_size, "--play cannot be combined with %s", first);
    if (a->notes && (a->out || a->wav || a->play))
        return err_set(err, err_size, "--notes cannot be combined with %s", first);
    return true;
}

/* --annotations and --luacheck print the whole API; --annotations also prints the API of test scripts. */
static bool check_help(const struct args *a, char *err, size_t err_size)
{
    const char *option = a->annotations ? "--annotations" : "--luacheck";

    if (!a->annotations && !a->luacheck)
        return true;
    if (a->n_words == 1 && a->annotations && strcmp(a->words[0], "test") == 0)
        return true;
    if (a->n_words != 1 || strcmp(a->words[0], "lua") != 0)
        return err_set(err, err_size, "%s works only with curtain help lua %s", option, option);
    return true;
}

static bool is_among(enum option o, const enum option *list, size_t n)
{
    while (n > 0 && list[n - 1] != o)
        n--;
    return n > 0;
}

static bool check_options(const struct args *a, const bool seen[OPTIONS], char *err, size_t err_size)
{
    char with[160];
    static const enum option fixed[] = { OPTION_LIVES, OPTION_REGISTER,   OPTION_INVINCIBLE, /* for practice starts */
                                         OPTION_SEED,  OPTION_DIP,        OPTION_STAGE,
                                         OPTION_LANG,  OPTION_DIFFICULTY, OPTION_PRESS };

    for (enum option o = 0; o < OPTIONS; o++) {
        if (!seen[o])
            continue;
        if (!(args_options[o].commands >> a->command & 1)) {
            list_commands(args_options[o].commands, with, sizeof with);
            return err_set(err, err_size, "%s does not work with %s (only with %s)", args_options[o].name,
                           args_commands[a->command].name, with);
        }
        if (a->demo && is_among(o, fixed, sizeof fixed / sizeof *fixed))
            return err_set(err, err_size, "%s cannot be combined with --demo: the demo sets it", args_options[o].name);
        if (!a->stage && is_among(o, fixed, 3))
            return err_set(err, err_size, "%s needs --stage: it applies only to practice starts", args_options[o].name);
    }
    return check_exclusive(seen, err, err_size) && check_pairs(a, seen, err, err_size);
}

/* A first word that is not a command is a ROM for `play`, unless the other words and options don't fit `play`. */
bool args_check_first(const struct args *a, const bool seen[OPTIONS], char *err, size_t err_size)
{
    const char *word = a->words[0], *meant = args_near_command(word);
    bool fits = a->n_words == 1;

    for (int o = 0; o < OPTIONS; o++)
        fits = fits && (!seen[o] || args_options[o].commands & FOR_PLAY);
    if (fits || (!meant && a->n_words == 1))
        return true;
    if (meant)
        return err_set(err, err_size, "unknown command \"%s\" (did you mean %s?)", word, meant);
    return err_set(err, err_size, "unknown command \"%s\" (see curtain help)", word);
}

static bool check_words(const struct args *a, char *err, size_t err_size)
{
    const char *name = args_commands[a->command].name;

    if (a->n_words < args_commands[a->command].min)
        return err_set(err, err_size, "%s: expected %s (see curtain help %s)", name, args_commands[a->command].words,
                       name);
    if (a->n_words && !a->words[0][0] && FOR_GAMES >> a->command & 1)
        return err_set(err, err_size, "%s: expected %s, got \"\" (see curtain help %s)", name,
                       args_commands[a->command].words, name);
    if (a->n_words > args_commands[a->command].max)
        return err_set(err, err_size, "%s: unexpected argument \"%s\" (see curtain help %s)", name,
                       a->words[args_commands[a->command].max], name);
    return true;
}

bool args_check(const struct args *a, const bool seen[OPTIONS], char *err, size_t err_size)
{
    return check_options(a, seen, err, err_size) && check_words(a, err, err_size) && check_sound(a, err, err_size) &&
           check_help(a, err, err_size);
}

/*
 * command_help.c - see command.h: help and version.
 */
#include "command.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "help/help_lua.h"
#include "../board/board.h"
#include "trial/trial.h"
#include "../../platform/platform.h"
#include "editor/annotations.h"
#include "editor/lua_example.h"
#include "editor/luacheck.h"
#include "host/config.h"
#include "host/keys.h"
#include "host/library.h"
#include "host/report.h"
#include "host/version.h"
#include "share/own.h"
#include "testing/testing.h"

#ifndef CURTAIN_CFLAGS
#define CURTAIN_CFLAGS "unknown"
#endif

#ifdef __clang__
#define COMPILER __VERSION__ /* names itself */
#elif defined(__GNUC__)
#define COMPILER "gcc " __VERSION__
#else
#define COMPILER "unknown"
#endif

static void say(const char *line)
{
    puts(line);
}

static void print_prose(void (*write)(struct prose *))
{
    struct prose text = { 0 };

    write(&text);
    fwrite(text.bytes, 1, text.n, stdout);
    free(text.bytes);
}

/* Words that authors look for, and the API's names for them. The help of a single name follows. */
static const char *const synonyms[][2] = {
    { "homing", "home" },
    { "seek", "home" },
    { "split", "emit" },
    { "figure", "pattern.polygon pattern.star pattern.rose" },
    { "triangle", "pattern.polygon" },
    { "square", "pattern.polygon" },
    { "pentagon", "pattern.polygon" },
    { "hexagon", "pattern.polygon" },
};

/* Prints "homing: see home"; returns the name to explain: word itself if it has no synonym, or several. */
static const char *print_synonym(const char *word)
{
    for (size_t i = 0; i < sizeof synonyms / sizeof *synonyms; i++) {
        const char *names = synonyms[i][1];
        if (strcmp(word, synonyms[i][0]) == 0) {
            printf("%s: see %s\n", word, names);
            return strchr(names, ' ') ? word : names;
        }
    }
    return word;
}

/* "test", "test.run", "run:step": only test scripts can call these. */
static bool is_of_tests(const char *name)
{
    struct trial_entry e;

    for (int i = 0; trial_entry(i, &e); i++)
        if (strcmp(e.name, name) == 0)
            return true;
    return strcmp(name, "test") == 0;
}

static enum result help_lua(const char *name)
{
    if (name && is_of_tests(name)) {
        printf("%s: only for test scripts (docs/guide/27-testing.md; curtain help test lists their functions)\n", name);
        return report_stdout(RESULT_DONE);
    }
    if (name)
        name = print_synonym(name);
    if (help_write(name, say)) {
        if (name)
            lua_example_print(name);
        return report_stdout(RESULT_DONE);
    }
    if (help_nearest(name))
        return report_line(RESULT_REFUSED, "help lua: no entry for \"%s\" (did you mean %s?)", name,
                           help_nearest(name));
    return report_line(RESULT_REFUSED, "help lua: no entry for \"%s\" (curtain help lua lists all names)", name);
}

/* Of the help of play the options. */
static void say_option(const char *line)
{
    if (strncmp(line, "  -", 3) == 0)
        say(line);
}

static void help_own(void)
{
    own_help(say);
    args_help(COMMAND_PLAY, say_option);
}

static enum result help_lua_files(const struct args *a)
{
    if (strcmp(a->words[0], "test") == 0)
        print_prose(annotations_test_write);
    else if (a->annotations)
        print_prose(annotations_write);
    else
        luacheck_print();
    return report_stdout(RESULT_DONE);
}

static enum result help_unknown(const char *topic)
{
    const char *meant = args_near_command(topic);

    if (meant)
        return report_line(RESULT_REFUSED, "help: unknown command \"%s\" (did you mean %s?)", topic, meant);
    return report_line(RESULT_REFUSED, "help: unknown command \"%s\" (see curtain help)", topic);
}

static void help_controls(void)
{
    say("");
    say("Keys and buttons, by the names to use in key bindings:");
    keys_help(own_sealed() ? KEYS_INSIDE : 0, say);
    say("");
    say("Controllers: player 1 gets the first one used; press START on another one to join as player 2.");
    say("pad. is the player's own controller; pad1. to pad4. are specific controllers.");
    say("south is the bottom face button and east is the right one, whatever is printed on them.");
    say("");
    say("Settings:");
    config_help(say);
}

/* command: -1 for all of them. */
static enum result help_command(int command)
{
    if (own_sealed())
        help_own();
    else
        args_help(command, say);
    if (command == COMMAND_TEST) {
        say("");
        testing_help(say);
    }
    if (command == COMMAND_PLAY || own_sealed())
        help_controls();
    return report_stdout(RESULT_DONE);
}

enum result command_help(const struct args *a)
{
    const char *topic = a->n_words ? a->words[0] : NULL;
    const int command = topic ? args_command(topic) : -1;
    const bool config = topic && strcmp(topic, "config") == 0;

    if (a->annotations || a->luacheck)
        return help_lua_files(a);
    if (topic && strcmp(topic, "lua") == 0)
        return help_lua(a->n_words > 1 ? a->words[1] : NULL);
    if (topic && command < 0 && !config)
        return help_unknown(topic);
    if (a->n_words > 1)
        return report_line(RESULT_REFUSED, "help: unexpected argument \"%s\"", a->words[1]);
    if (!config)
        return help_command(command);
    config_guide(say);
    return report_stdout(RESULT_DONE);
}

static const char *byte_order(void)
{
    const uint16_t one = 1;

    return *(const uint8_t *)&one ? "little" : "big";
}

/* The window's library, and those that packing opens: an exported game packs nothing. */
static void version_of_libraries(void)
{
    char text[192];

    plat_describe_build(text, sizeof text);
    text[strcspn(text, ",")] = '\0';
    printf("platform %s\n", text);
    for (enum library l = 0; l < LIBRARIES && !own_sealed(); l++) {
        library_about(l, text, sizeof text);
        puts(text);
    }
}

enum result command_version(void)
{
    if (own_game()->rom)
        report_print("%s %d (%s)\n", own_game()->m.title, (int)own_game()->m.version, own_game()->m.id);
    report_print("curtain %s (core %d, Lua %s)\n", CURTAIN_VERSION, CORE_VERSION, board_lua_release());
    report_print("compiler %s\n", COMPILER);
    report_print("flags %s\n", CURTAIN_CFLAGS);
    report_print("machine %d-bit %s-endian\n", (int)sizeof(void *) * 8, byte_order());
    version_of_libraries();
    return report_stdout(RESULT_DONE);
}

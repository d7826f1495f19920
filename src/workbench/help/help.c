/*
 * help.c - see help.h.
 */
#include "help.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../common/byte_buffer.h"
#include "../../common/report.h"
#include "../../player/command.h"
#include "../check/program_text.h"
#include "../test/test_script.h"
#include "annotations.h"
#include "help_lua.h"
#include "lua_example.h"
#include "luacheck.h"

static void print_line(const char *line)
{
    puts(line);
}

static void print_text(void (*write)(struct byte_buffer *))
{
    struct byte_buffer text = { 0 };

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

/* Returns whether only test scripts can use the name: "test", "test.run", "run:step". */
static bool is_test_name(const char *name)
{
    struct test_script_entry e;

    for (int i = 0; test_script_entry(i, &e); i++)
        if (strcmp(e.name, name) == 0)
            return true;
    return strcmp(name, "test") == 0;
}

static enum result help_lua(const char *name)
{
    if (name && is_test_name(name)) {
        printf("%s: only for test scripts (docs/guide/27-testing.md; curtain help test lists their functions)\n", name);
        return report_stdout(RESULT_DONE);
    }
    if (name)
        name = print_synonym(name);
    if (help_write(name, print_line)) {
        if (name)
            lua_example_print(name);
        return report_stdout(RESULT_DONE);
    }
    if (help_nearest(name))
        return report_line(RESULT_REFUSED, "help lua: no entry for \"%s\" (did you mean %s?)", name,
                           help_nearest(name));
    return report_line(RESULT_REFUSED, "help lua: no entry for \"%s\" (curtain help lua lists all names)", name);
}

static enum result help_lua_files(const struct args *a)
{
    if (strcmp(a->words[0], "test") == 0)
        print_text(annotations_test_write);
    else if (a->annotations)
        print_text(annotations_write);
    else
        luacheck_print();
    return report_stdout(RESULT_DONE);
}

enum result help_command(const struct args *a)
{
    const char *topic = a->n_words ? a->words[0] : "";

    if (a->annotations || a->luacheck)
        return help_lua_files(a);
    if (strcmp(topic, "lua") == 0)
        return help_lua(a->n_words > 1 ? a->words[1] : NULL);
    if (strcmp(topic, "lang") == 0 && a->n_words == 1) {
        program_text_print(print_line);
        return report_stdout(RESULT_DONE);
    }
    const enum result result = command_help(a);
    if (result != RESULT_DONE || a->n_words != 1 || args_command(topic) != COMMAND_TEST)
        return result;
    print_line("");
    print_line("Test scripts, tests/*.lua, are Lua scripts that can also use these names (docs/guide/27-testing.md):");
    test_script_help(print_line);
    return report_stdout(RESULT_DONE);
}

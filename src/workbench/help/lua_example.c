/*
 * lua_example.c - see lua_example.h. In the files, an entry's part is
 *
 *     ## NAME
 *
 *     Guide: docs/guide/PAGE.md
 *
 *     ```lua task
 *     CODE
 *     ```
 */
#include "lua_example.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include "../pack/pack.h"

extern const struct embedded help_files[];
extern const int help_file_count;

/* Returns the text below the heading of that name, or NULL. */
static const char *find_part(const char *text, const char *name)
{
    const size_t n = strlen(name);

    for (const char *at = strstr(text, "\n## "); at; at = strstr(at + 1, "\n## "))
        if (strncmp(at + 4, name, n) == 0 && at[4 + n] == '\n')
            return at + 4 + n;
    return NULL;
}

static int line_length(const char *line)
{
    return (int)strcspn(line, "\n");
}

static void print_part(const char *part)
{
    const char *guide = strstr(part, "\nGuide: "), *code = strstr(part, "\n```");

    if (guide == NULL || code == NULL || guide > code)
        return;
    puts("\n  Example:");
    code += 1 + line_length(code + 1);
    for (code++; strncmp(code, "```", 3) != 0 && *code; code += line_length(code) + 1)
        printf("%s%.*s\n", *code == '\n' ? "" : "    ", line_length(code), code);
    printf("\n  %.*s\n", line_length(guide + 1), guide + 1);
}

void lua_example_print(const char *name)
{
    for (int i = 0; i < help_file_count; i++) {
        const char *part = find_part((const char *)help_files[i].data, name); /* the data ends with a 0 */
        if (part) {
            print_part(part);
            return;
        }
    }
}

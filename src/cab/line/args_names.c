/*
 * args_names.c - see args.h: commands by their names, and what was meant by a name that there is not.
 */
#include "args_parts.h"

#include <string.h>
#include "../../base/int.h"

enum { NEAR_MOST = 31 };

/* Edits (a letter more, less or another, or two swapped) from a to b. */
static int edits(const char *a, const char *b)
{
    int d[NEAR_MOST + 1][NEAR_MOST + 1];
    int n = (int)strlen(a), m = (int)strlen(b);

    if (n > NEAR_MOST || m > NEAR_MOST)
        return NEAR_MOST;
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= m; j++) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            d[i][j] = int_min(d[i - 1][j - 1] + (a[i - 1] != b[j - 1]), int_min(d[i - 1][j], d[i][j - 1]) + 1);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = int_min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[n][m];
}

const char *args_near(const char *word, const char *const *list, int n)
{
    const char *best = NULL;
    int limit = strlen(word) < 3 ? -1 : 1 + (int)strlen(word) / 4;

    for (int i = 0; i < n; i++) {
        int e = edits(word, list[i]);
        if (e > limit || e >= (int)strlen(list[i]))
            continue;
        best = list[i];
        limit = e - 1; /* only a nearer one is better */
    }
    return best;
}

const char *args_near_command(const char *word)
{
    const char *names[COMMANDS];

    for (int i = 0; i < COMMANDS; i++)
        names[i] = args_commands[i].name;
    return args_near(word, names, COMMANDS);
}

int args_command(const char *name)
{
    for (int i = 0; i < COMMANDS; i++) {
        if (strcmp(name, args_commands[i].name) == 0)
            return i;
    }
    return -1;
}

const char *args_name(enum command command)
{
    return args_commands[command].name;
}

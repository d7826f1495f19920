/*
 * process.c - see process.h.
 */
#include "process.h"

#include <stdlib.h>
#include <string.h>
#if defined(__unix__) || defined(__APPLE__) || defined(__HAIKU__)
#include <signal.h>
#include <unistd.h>
#define PROCESSES 1
#endif

#ifdef PROCESSES
bool process_is_there(const char *name)
{
    char command[128];

    return snprintf(command, sizeof command, "command -v %s >/dev/null 2>&1", name) < (int)sizeof command &&
           system(command) == 0;
}

FILE *process_open(const char *command)
{
    signal(SIGPIPE, SIG_IGN);
    return popen(command, "w");
}

bool process_close(FILE *f)
{
    const bool good = fflush(f) == 0 && !ferror(f);

    return pclose(f) == 0 && good;
}

bool process_terminal(void)
{
    return isatty(2);
}
#else
bool process_is_there(const char *name)
{
    (void)name;
    return false;
}

FILE *process_open(const char *command)
{
    (void)command;
    return NULL;
}

bool process_close(FILE *f)
{
    (void)f;
    return false;
}

bool process_terminal(void)
{
    return false;
}
#endif

bool process_word(char *out, size_t size, const char *word)
{
    static const char quote[] = "'\\''";
    size_t n = 0;

    if (size < 3)
        return false;
    out[n++] = '\'';
    for (; *word; word++) {
        const bool is_quote = *word == '\'';
        const size_t more = is_quote ? sizeof quote - 1 : 1;
        if (n + more + 2 > size)
            return false;
        memcpy(out + n, is_quote ? quote : word, more);
        n += more;
    }
    memcpy(out + n, "'", 2);
    return true;
}

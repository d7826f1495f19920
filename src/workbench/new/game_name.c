/*
 * game_name.c - see game_name.h.
 */
#include "game_name.h"

#include <stdio.h>
#include <string.h>
#include "../../base/hash.h"
#include "../../common/clean.h"
#include "../../common/tree.h"

enum { NO_CHARACTER = 0xfffd };

bool game_name_of_folder(const char *dir, char name[GAME_TITLE_SIZE])
{
    size_t at = 0;
    uint32_t c;

    tree_id(dir, name);
    while (name[at] != '\0') {
        int n = clean_decode_character(name + at, &c);
        if (c == NO_CHARACTER && n == 1 && strlen(name + at) < 4 && strlen(name) > GAME_TITLE_SIZE - 5)
            name[at] = '\0'; /* a truncated character */
        else
            at += (size_t)n;
    }
    return name[0] != '\0';
}

static bool is_id_character(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

void game_name_id(const char *name, char id[GAME_ID_SIZE])
{
    const uint32_t digits = hash_crc32(name, strlen(name));
    size_t n = 0;

    for (; *name != '\0' && n < GAME_ID_SIZE - 1; name++) {
        char c = *name >= 'A' && *name <= 'Z' ? (char)(*name - 'A' + 'a') : *name;
        if (is_id_character(c))
            id[n++] = c;
        else if (n > 0 && id[n - 1] != '_')
            id[n++] = '_';
    }
    while (n > 0 && id[n - 1] == '_')
        n--;
    id[n] = '\0';
    if (n == 0)
        snprintf(id, GAME_ID_SIZE, "game_%08x", (unsigned)digits);
}

bool game_name_has_glyphs(const char *name)
{
    uint32_t c;

    while (*name != '\0') {
        name += clean_decode_character(name, &c);
        if (c < 0x20 || (c > 0x7e && c < 0xa1) || c > 0xff)
            return false;
    }
    return true;
}

/*
 * web.c - see web.h. The player's placeholders are @TITLE@, any number of times, and @ROM@, once, which becomes the ROM
 * in base64. Its line "generator" has the core version.
 */
#include "web.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../board/board.h"
#include "../../rom/manifest.h"
#include "../../common/clean.h"

static const char title_placeholder[] = "@TITLE@", rom_placeholder[] = "@ROM@";
static const char generator[] = "<meta name=\"generator\" content=\"Curtain, core ";

/* Returns the first occurrence of a text from `at`, or NULL. */
static const uint8_t *find(const uint8_t *file, size_t size, const uint8_t *at, const char *text)
{
    const size_t n = strlen(text);
    const uint8_t *end = file + size;

    for (; (size_t)(end - at) >= n; at++) {
        at = memchr(at, text[0], (size_t)(end - at) - n + 1);
        if (!at || memcmp(at, text, n) == 0)
            return at;
    }
    return NULL;
}

static int count(const uint8_t *file, size_t size, const char *text)
{
    int n = 0;

    for (const uint8_t *p = file; (p = find(file, size, p, text)) != NULL; p++)
        n++;
    return n;
}

/* Returns the core version in a page; 0: it is not a page of Curtain. */
static unsigned read_core_version(const uint8_t *file, size_t size)
{
    const uint8_t *p = find(file, size, file, generator);
    char digits[8] = "";

    if (!p)
        return 0;
    p += sizeof generator - 1;
    for (size_t i = 0; i + 1 < sizeof digits && p + i < file + size && p[i] >= '0' && p[i] <= '9'; i++)
        digits[i] = (char)p[i];
    return (unsigned)strtoul(digits, NULL, 10);
}

bool web_is_page(const uint8_t *file, size_t size)
{
    return read_core_version(file, size) > 0 && count(file, size, rom_placeholder) == 0;
}

/* ---- the ROM ---- */

static size_t base64_size(size_t n)
{
    return (n + 2) / 3 * 4;
}

static uint8_t *append_base64(uint8_t *out, const uint8_t *bytes, size_t n)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    for (size_t i = 0; i < n; i += 3) {
        const size_t left = n - i < 3 ? n - i : 3;
        const uint32_t v =
            (uint32_t)bytes[i] << 16 | (left > 1 ? (uint32_t)bytes[i + 1] << 8 : 0) | (left > 2 ? bytes[i + 2] : 0);
        for (size_t k = 0; k < 4; k++)
            *out++ = k <= left ? (uint8_t)digits[v >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

/* ---- the page ---- */

/* Escapes a title for HTML, and @, with which placeholders start. */
static void escape_title(const char *title, char *out, size_t size)
{
    size_t n = 0;

    while (*title && n + CLEAN_MARKUP_SIZE < size) {
        title += clean_escape_character(title, out + n);
        if (strcmp(out + n, "@") == 0)
            strcpy(out + n, "&#64;");
        n += strlen(out + n);
    }
    out[n] = '\0';
}

static bool check_player(const uint8_t *player, size_t size, const char *name, char *err, size_t err_size)
{
    const unsigned core = read_core_version(player, size);

    if (core == 0 || count(player, size, rom_placeholder) != 1 || count(player, size, title_placeholder) < 1)
        return err_set(err, err_size, "%s: not a valid player; rebuild it with `make players`", name);
    if (core != CORE_VERSION)
        return err_set(err, err_size, "%s: expected core version %d, got %u; rebuild it with `make players`", name,
                       CORE_VERSION, core);
    return true;
}

static uint8_t *append(uint8_t *out, const void *bytes, size_t n)
{
    memcpy(out, bytes, n);
    return out + n;
}

/* Copies the player with its placeholders replaced. */
static uint8_t *fill_placeholders(uint8_t *out, const uint8_t *player, size_t size, const char *title,
                                  const uint8_t *rom, size_t rom_size)
{
    const uint8_t *from = player, *const end = player + size, *rom_at = find(player, size, player, rom_placeholder);

    for (;;) {
        const uint8_t *next = find(player, size, from, title_placeholder);
        const bool is_rom = rom_at >= from && (!next || rom_at < next);
        if (is_rom)
            next = rom_at;
        if (!next)
            return append(out, from, (size_t)(end - from));
        out = append(out, from, (size_t)(next - from));
        out = is_rom ? append_base64(out, rom, rom_size) : append(out, title, strlen(title));
        from = next + (is_rom ? sizeof rom_placeholder : sizeof title_placeholder) - 1;
    }
}

bool web_make(const struct web_game *game, const uint8_t *player, size_t player_size, const char *name, uint8_t **out,
              size_t *size, char *err, size_t err_size)
{
    char title[6 * sizeof((struct manifest *)0)->title + 8];

    *out = NULL;
    if (!check_player(player, player_size, name, err, err_size))
        return false;
    escape_title(game->title, title, sizeof title);
    const size_t titles = (size_t)count(player, player_size, title_placeholder) * strlen(title);
    *out = malloc(player_size + titles + base64_size(game->size));
    if (!*out)
        return result_set_host_error(err, err_size, "out of memory");
    *size = (size_t)(fill_placeholders(*out, player, player_size, title, game->rom, game->size) - *out);
    return true;
}

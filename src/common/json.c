/*
 * json.c - writes JSON (json.h).
 */
#include "json.h"

#include <inttypes.h>
#include "clean.h"

static void put_string(FILE *out, const char *text)
{
    fputc('"', out);
    while (*text) {
        uint32_t c;
        text += clean_decode_character(text, &c);
        if (c == '"' || c == '\\')
            fprintf(out, "\\%c", (int)c);
        else if (c >= 32 && c < 127)
            fputc((int)c, out);
        else if (c < 0x10000)
            fprintf(out, "\\u%04x", (unsigned)c);
        else
            fprintf(out, "\\u%04x\\u%04x", (unsigned)(0xd7c0 + (c >> 10)), (unsigned)(0xdc00 + (c & 0x3ff)));
    }
    fputc('"', out);
}

/* Writes a comma if needed, and the key. */
static void begin(struct json *j, const char *key)
{
    if (j->more)
        fputc(',', j->out);
    j->more = true;
    if (!key)
        return;
    put_string(j->out, key);
    fputc(':', j->out);
}

void json_open(struct json *j, const char *key, char bracket)
{
    begin(j, key);
    fputc(bracket, j->out);
    j->more = false;
}

void json_close(struct json *j, char bracket)
{
    fputc(bracket, j->out);
    j->more = true;
}

void json_text(struct json *j, const char *key, const char *text)
{
    begin(j, key);
    if (text)
        put_string(j->out, text);
    else
        fputs("null", j->out);
}

void json_number(struct json *j, const char *key, int64_t value)
{
    begin(j, key);
    fprintf(j->out, "%" PRId64, value);
}

void json_seconds(struct json *j, const char *key, uint32_t frames)
{
    uint32_t thousandths = (uint32_t)(((uint64_t)frames * 1000 + 30) / 60);

    begin(j, key);
    fprintf(j->out, "%u.%03u", (unsigned)(thousandths / 1000), (unsigned)(thousandths % 1000));
}

void json_digits(struct json *j, const char *key, uint64_t value)
{
    begin(j, key);
    fprintf(j->out, "\"%" PRIu64 "\"", value);
}

void json_hex(struct json *j, const char *key, uint64_t value)
{
    begin(j, key);
    fprintf(j->out, "\"%016" PRIx64 "\"", value);
}

void json_bool(struct json *j, const char *key, bool value)
{
    begin(j, key);
    fputs(value ? "true" : "false", j->out);
}

void json_names(struct json *j, const char *key, uint32_t bits, const char *(*name_of)(int bit))
{
    json_open(j, key, '[');
    for (int i = 0; name_of(i); i++)
        if (bits >> i & 1)
            json_text(j, NULL, name_of(i));
    json_close(j, ']');
}

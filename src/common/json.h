/*
 * json.h - writes a JSON object (RFC 8259) on one line, with keys and values in the order of the calls.
 *
 * The output is ASCII: other characters are written as \u escapes, and invalid UTF-8 as U+FFFD. A 64-bit number that a
 * reader might round to a double is written as a string of digits.
 */
#ifndef COMMON_JSON_H
#define COMMON_JSON_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

struct json {
    FILE *out;
    bool more; /* this object or list has a value already, so the next one needs a comma */
};

/* Write { and }, or [ and ]. key is NULL in a list and for the outermost object. */
void json_open(struct json *j, const char *key, char bracket);
void json_close(struct json *j, char bracket);

/* Write a value; key is NULL in a list. json_text writes null for NULL. json_number is for numbers that fit in a
 * double, json_digits for other numbers, json_hex for hashes (16 digits), json_seconds for frames. */
void json_text(struct json *j, const char *key, const char *text);
void json_number(struct json *j, const char *key, int64_t value);
void json_seconds(struct json *j, const char *key, uint32_t frames);
void json_digits(struct json *j, const char *key, uint64_t value);
void json_hex(struct json *j, const char *key, uint64_t value);
void json_bool(struct json *j, const char *key, bool value);

/* Writes the names of the set bits as a list. name_of returns NULL after the last named bit. */
void json_names(struct json *j, const char *key, uint32_t bits, const char *(*name_of)(int bit));

#endif

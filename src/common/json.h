/*
 * json.h - one JSON object on one line, RFC 8259: keys and values in the order of the calls.
 *
 * All text is ASCII: what is none is written as \u escapes, a byte that belongs to no UTF-8 character as U+FFFD. A
 * number of 64 bits that others would read as a double and round is written as a text of digits.
 */
#ifndef COMMON_JSON_H
#define COMMON_JSON_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

struct json {
    FILE *out;
    bool more; /* something stands before in this object or list: a comma comes first */
};

/* { and }, [ and ]; key NULL: in a list, or the object that is all of the line. */
void json_open(struct json *j, const char *key, char bracket);
void json_close(struct json *j, char bracket);

/* A value; key NULL: in a list. text NULL: null. json_number is for what a double holds, json_hex for hashes, 16
 * digits. */
void json_text(struct json *j, const char *key, const char *text);
void json_number(struct json *j, const char *key, int64_t value);
void json_seconds(struct json *j, const char *key, uint32_t frames);
void json_digits(struct json *j, const char *key, uint64_t value);
void json_hex(struct json *j, const char *key, uint64_t value);
void json_bool(struct json *j, const char *key, bool value);

/* A list of the names of the bits that are set; name_of returns NULL after the last bit that has a name. */
void json_names(struct json *j, const char *key, uint32_t bits, const char *(*name_of)(int bit));

#endif

/*
 * value.h - reads the values of rom.lua. Each function raises a Lua error for a value that it does not accept.
 */
#ifndef WORKBENCH_VALUE_H
#define WORKBENCH_VALUE_H

#include <lua.h>
#include "../../rom/manifest.h"

enum { MAX_PATH = 128 /* "sprites.orb.origin" */ };

/* A value on the Lua stack. The slot above a table holds one of its values: value_get and value_get_item replace the
 * previous one, and nothing is popped. */
struct manifest_value {
    lua_State *lua;
    int index;
    char path[MAX_PATH]; /* its name in messages; "": the whole manifest */
};

/* Raises "PATH: message". */
_Noreturn void value_fail(const struct manifest_value *v, const char *format, ...);

/* Describes the value: nil, 2.5, "text", a table. */
const char *value_describe(const struct manifest_value *v);

/* Pushes a value of a table, or of a list whose first index is 1. value_get returns whether it is not nil.
 * value_get_table raises an error if it is neither nil nor a table. */
bool value_get(const struct manifest_value *table, const char *key, struct manifest_value *v);
bool value_get_table(const struct manifest_value *table, const char *key, struct manifest_value *v);
void value_get_item(const struct manifest_value *list, int i, struct manifest_value *v);
void value_check_table(const struct manifest_value *v);

/* Convert a value. value_get_whole gets the value first; it must not be nil. noun: "a line", for messages.
 * value_to_text fills the rest of `out` with zeros. A file is a path in the game's folder. value_to_choice returns the
 * index in `words`; `form` lists the words for messages. */
int64_t value_to_whole(const struct manifest_value *v, int64_t lo, int64_t hi);
int32_t value_get_whole(const struct manifest_value *table, const char *key, int32_t lo, int32_t hi);
double value_to_real(const struct manifest_value *v, double lo, double hi);
void value_to_text(const struct manifest_value *v, const char *noun, char *out, size_t size);
void value_to_file(const struct manifest_value *v, char out[ART_FILE_SIZE]);
int value_to_choice(const struct manifest_value *v, const char *const *words, int n, const char *form);

/* Returns the length of a list, at most max. value_to_words also reads its words, which must differ. */
int value_to_length(const struct manifest_value *list, int max);
int value_to_words(const struct manifest_value *list, char out[][MAX_SETTING_NAME], int max);

/* Reads the keys of a table into the names at the start of an array of structs, in alphabetical order. Returns their
 * number. */
int value_to_names(const struct manifest_value *table, void *out, int max, size_t stride, size_t name_size);

/* A key of a table, and the member of a struct that receives its value. The member doesn't change if the value is
 * nil. */
struct manifest_field {
    const char *key;
    enum {
        FIELD_WHOLE, /* int32_t from lo to hi */
        FIELD_REAL,  /* double from lo to hi */
        FIELD_SHARE, /* int32_t: a number from 0 to 1, scaled to 255 */
        FIELD_FLAG,  /* bool or int32_t */
        FIELD_TEXT,  /* char[size]; noun: what it is */
        FIELD_FILE,  /* char[ART_FILE_SIZE] */
        FIELD_PAIR,  /* int32_t[2] or two such members; noun: its form */
        FIELD_MATCH  /* bool: "index", otherwise "colour" */
    } type;
    size_t offset, size;
    double lo, hi;
    const char *noun;
};
#define FIELD(key, type, owner, member, lo, hi, noun)                                                                  \
    {                                                                                                                  \
        key, type, offsetof(struct owner, member), sizeof((struct owner *)NULL)->member, lo, hi, noun                  \
    }
#define WHOLE(key, owner, member, lo, hi)     FIELD(key, FIELD_WHOLE, owner, member, lo, hi, NULL)
#define REAL(key, owner, member, lo, hi)      FIELD(key, FIELD_REAL, owner, member, lo, hi, NULL)
#define SHARE(key, owner, member)             FIELD(key, FIELD_SHARE, owner, member, 0, 1, NULL)
#define FLAG(key, owner, member)              FIELD(key, FIELD_FLAG, owner, member, 0, 1, NULL)
#define TEXT(key, owner, member, noun)        FIELD(key, FIELD_TEXT, owner, member, 0, 0, noun)
#define FILE_PATH(key, owner, member)         FIELD(key, FIELD_FILE, owner, member, 0, 0, NULL)
#define PAIR(key, owner, first, lo, hi, form) FIELD(key, FIELD_PAIR, owner, first, lo, hi, form)
#define MATCH(key, owner, member)             FIELD(key, FIELD_MATCH, owner, member, 0, 1, NULL)

/* value_read_fields reads the fields of a table into *out. value_check_keys raises an error if the value is not a
 * table, or has a key that is neither a field nor one of `others`, a list that ends with NULL. READ_TABLE does both. */
void value_check_keys(const struct manifest_value *table, const struct manifest_field *fields, size_t n,
                      const char *const *others);
void value_read_fields(const struct manifest_value *table, const struct manifest_field *fields, size_t n, void *out);
#define READ_TABLE(table, fields, others, out)                                                                         \
    (value_check_keys(table, fields, sizeof fields / sizeof *fields, others),                                          \
     value_read_fields(table, fields, sizeof fields / sizeof *fields, out))

#endif

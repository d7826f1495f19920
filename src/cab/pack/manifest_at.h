/*
 * manifest_at.h - how rom.lua's tables are read: each function raises the Lua error for what it does not take.
 */
#ifndef CAB_MANIFEST_AT_H
#define CAB_MANIFEST_AT_H

#include <lua.h>
#include "../../rom/manifest.h"

enum { MAX_PATH = 128 /* "sprites.orb.origin" */ };

/* A table on the Lua stack and how messages call it. */
struct at {
    lua_State *lua;
    int index;
    char path[MAX_PATH]; /* "": the whole manifest */
};

/* Raises "PATH: message". */
_Noreturn void at_bad(lua_State *lua, const char *path, const char *format, ...);

/* The path of a field: "sprites.orb"; and of a[i], which it pushes, i from 1: "extends[2]". */
void at_path(const struct at *a, const char *key, char out[MAX_PATH]);
void at_item(const struct at *a, int i, char path[MAX_PATH]);

/* Describes the value on top of the stack: nil, 2.5, "text", a table. */
const char *at_got(lua_State *lua);

/* Pushes a[key]; false, and nothing pushed, when it is nil. at_table: as a table. */
bool at_get(const struct at *a, const char *key);
bool at_table(const struct at *a, const char *key, struct at *out);

/* The value on top as a whole number, or as the path of a file in the game's folder; popped. */
int64_t at_to_whole(lua_State *lua, const char *path, int64_t lo, int64_t hi);
void at_to_file(lua_State *lua, const char *path, char out[ART_FILE_SIZE]);

/* a[key] into what is passed, which stays when it is nil. what: "a file", "a word". */
void at_whole(const struct at *a, const char *key, int32_t lo, int32_t hi, int32_t *v);
void at_need_whole(const struct at *a, const char *key, int32_t lo, int32_t hi, int32_t *v);
bool at_text(const struct at *a, const char *key, const char *what, char *out, size_t size);
bool at_file(const struct at *a, const char *key, char out[ART_FILE_SIZE]);
bool at_real(const struct at *a, const char *key, double lo, double hi, double *v);
bool at_flag(const struct at *a, const char *key);

/* A share from 0 to 1, of 255. */
int32_t at_share(const struct at *a, const char *key, int32_t usual);

/* Every key of a is one of names. */
void at_only(const struct at *a, const char *const *names);

/* a is a list and nothing else; returns its length, at most max. at_words: into words. */
int at_list(const struct at *a, int max);
int at_words(const struct at *a, char out[][MAX_SETTING_NAME], int max);

/* The keys of a, sorted, into the first bytes (a name) of an array of structs; returns how many. */
int at_keys(const struct at *a, void *out, int max, size_t stride, size_t name_size);

/* The pictures of rom.lua: palettes, blends, fonts, sheets, sprites, icon, maps. */
void manifest_read_art(const struct at *root, struct manifest *m, struct art *art);

#endif

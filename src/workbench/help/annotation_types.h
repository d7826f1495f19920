/*
 * annotation_types.h - what the API table's types are called in LuaLS's annotations.
 */
#ifndef WORKBENCH_ANNOTATION_TYPES_H
#define WORKBENCH_ANNOTATION_TYPES_H

#include <stddef.h>
#include "../../script/api/api_table.h"
#include "../../common/byte_buffer.h"

/* Adds the aliases that the types below name: words, and names that a game declares. */
void annotation_aliases(struct byte_buffer *to);

/* The type of a parameter of e, as it stands behind ---@param or ---@field: "integer", "bullet|enemy". */
void annotation_type(const struct api_entry *e, const struct api_param *p, char *out, size_t size);

/* The type of a property as it is read. */
void annotation_property(const struct api_param *p, char *out, size_t size);

/* What a function returns, `words` being what the table says: adds a line ---@return for each value. */
void annotation_returns(struct byte_buffer *to, const char *words);

/* The type of a plain name ("rom.title"), or of an argument of a function without checks ("row"); NULL: none known. */
const char *annotation_plain(const char *name);

#endif

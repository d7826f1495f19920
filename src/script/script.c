/*
 * script.c - see script.h. Scans the Lua tokens that matter here: comments, strings with their escapes, and names. The
 * value of a string is decoded, so that "\95_gc" is found too; only enough of it is stored to recognize the forbidden
 * names.
 */
#include "script.h"

#include <lauxlib.h>
#include <lua.h>
#include <stdio.h>
#include <string.h>
#include "../base/cursor.h"
#include "../base/err.h"
#include "../base/heap.h"
#include "../base/host.h"

static const char power_message[] =
    "operator ^ is not available (results differ between machines); use x*x or math.sqrt";
static const char gc_message[] = "__gc is not available (finalizers run at different times on different machines)";
static const char mode_message[] = "__mode is not available (weak tables hold different entries on different machines)";

struct scan {
    struct cursor cursor;
    char word[8]; /* the first bytes of the last name or string */
    size_t size;  /* bytes in the whole name or string */
};

static void append_byte(struct scan *s, unsigned c)
{
    if (s->size < sizeof s->word)
        s->word[s->size] = (char)c;
    s->size++;
}

/* Scans a long bracket to its end. A newline right after the opening bracket is not part of the string. */
static void scan_long_string(struct scan *s, int level)
{
    s->cursor.p += level + 2;
    s->size = 0;
    if (cursor_peek(&s->cursor, 0) == '\n' || cursor_peek(&s->cursor, 0) == '\r')
        cursor_step(&s->cursor);
    while (s->cursor.p < s->cursor.end && !cursor_is_at_long_close(&s->cursor, level)) {
        append_byte(s, (unsigned char)*s->cursor.p);
        cursor_step(&s->cursor);
    }
    if (s->cursor.p < s->cursor.end)
        s->cursor.p += level + 2;
}

static void scan_comment(struct scan *s)
{
    s->cursor.p += 2;
    int level = cursor_peek(&s->cursor, 0) == '[' ? cursor_long_level(&s->cursor) : -1;

    if (level >= 0) {
        scan_long_string(s, level);
        return;
    }
    while (s->cursor.p < s->cursor.end && *s->cursor.p != '\n' && *s->cursor.p != '\r')
        s->cursor.p++;
}

/* \u{XXX}: the forbidden names are ASCII, so any other character counts as one byte, 255. */
static void scan_unicode_escape(struct scan *s)
{
    unsigned v = 0;

    s->cursor.p++;
    if (cursor_peek(&s->cursor, 0) == '{')
        s->cursor.p++;
    for (; cursor_hex_value(cursor_peek(&s->cursor, 0)) >= 0; s->cursor.p++)
        v = v > 255 ? v : v * 16 + (unsigned)cursor_hex_value(*s->cursor.p);
    if (cursor_peek(&s->cursor, 0) == '}')
        s->cursor.p++;
    append_byte(s, v > 127 ? 255 : v);
}

static void scan_number_escape(struct scan *s, int max_digits, int base)
{
    int v = 0;

    for (int i = 0; i < max_digits; i++) {
        const int digit = cursor_hex_value(cursor_peek(&s->cursor, 0));
        if (digit < 0 || digit >= base)
            break;
        v = v * base + digit;
        s->cursor.p++;
    }
    append_byte(s, (unsigned)v);
}

/* Scans an escape sequence in quotes, after its backslash. */
static void scan_escape(struct scan *s)
{
    char c = cursor_peek(&s->cursor, 0);

    if (cursor_is_digit(c)) {
        scan_number_escape(s, 3, 10);
    } else if (c == 'x') {
        s->cursor.p++;
        scan_number_escape(s, 2, 16);
    } else if (c == 'u') {
        scan_unicode_escape(s);
    } else if (c == 'z') {
        for (s->cursor.p++;
             s->cursor.p < s->cursor.end && strchr(" \t\n\v\f\r", *s->cursor.p) != NULL && *s->cursor.p != '\0';)
            cursor_step(&s->cursor);
    } else if (s->cursor.p < s->cursor.end) {
        append_byte(s, '\n'); /* a letter or a line end: recorded as \n, since no forbidden name contains its value */
        cursor_step(&s->cursor);
    }
}

static void scan_quoted_string(struct scan *s)
{
    char quote = *s->cursor.p++;

    s->size = 0;
    while (s->cursor.p < s->cursor.end && *s->cursor.p != quote && *s->cursor.p != '\n' && *s->cursor.p != '\r') {
        if (*s->cursor.p == '\\') {
            s->cursor.p++;
            scan_escape(s);
        } else {
            append_byte(s, (unsigned char)*s->cursor.p++);
        }
    }
    if (s->cursor.p < s->cursor.end && *s->cursor.p == quote)
        s->cursor.p++;
}

static void scan_name(struct scan *s)
{
    s->size = 0;
    while (cursor_is_letter(cursor_peek(&s->cursor, 0)) || cursor_is_digit(cursor_peek(&s->cursor, 0)))
        append_byte(s, (unsigned char)*s->cursor.p++);
}

/* Scans one token. Returns what is wrong with it, or NULL. */
static const char *scan_token(struct scan *s)
{
    char c = *s->cursor.p;

    if (c == '-' && cursor_peek(&s->cursor, 1) == '-') {
        scan_comment(s);
        return NULL;
    }
    if (c == '^') {
        s->cursor.p++;
        return power_message;
    }
    if (cursor_is_letter(c))
        scan_name(s);
    else if (c == '"' || c == '\'')
        scan_quoted_string(s);
    else if (c == '[' && cursor_long_level(&s->cursor) >= 0)
        scan_long_string(s, cursor_long_level(&s->cursor));
    else {
        cursor_step(&s->cursor);
        return NULL;
    }
    if (s->size == 4 && memcmp(s->word, "__gc", 4) == 0)
        return gc_message;
    return s->size == 6 && memcmp(s->word, "__mode", 6) == 0 ? mode_message : NULL;
}

bool script_scan_from(const char *text, size_t n, struct script_position *position, int *line, const char **message)
{
    struct scan s = { .cursor = { text + position->at, text + n, position->line } };

    while (s.cursor.p < s.cursor.end) {
        *line = s.cursor.line;
        *message = scan_token(&s);
        if (*message == NULL)
            continue;
        *position = (struct script_position){ (size_t)(s.cursor.p - text), s.cursor.line };
        return false;
    }
    return true;
}

bool script_scan(const char *text, size_t n, int *line, const char **message)
{
    struct script_position start = { 0, 1 };

    return script_scan_from(text, n, &start, line, message);
}

/* Skips a numeral, which may end in a dot: "3. x" has no field x. */
static void skip_numeral(struct cursor *at)
{
    bool is_hex = *at->p == '0' && (cursor_peek(at, 1) == 'x' || cursor_peek(at, 1) == 'X');
    const char *exponent = is_hex ? "pP" : "eE";

    for (at->p += is_hex ? 2 : 0; at->p < at->end && *at->p != '\0'; at->p++) {
        if (strchr(exponent, *at->p) != NULL)
            at->p += cursor_peek(at, 1) == '+' || cursor_peek(at, 1) == '-';
        else if (cursor_hex_value(*at->p) < 0 && *at->p != '.')
            return;
    }
}

static bool skip_space(struct scan *s)
{
    if (cursor_is_blank(*s->cursor.p))
        cursor_step(&s->cursor);
    else if (*s->cursor.p == '-' && cursor_peek(&s->cursor, 1) == '-')
        scan_comment(s);
    else
        return false;
    return true;
}

/* Returns whether a single = follows. */
static bool is_assigned(struct scan s)
{
    while (s.cursor.p < s.cursor.end && skip_space(&s))
        continue;
    return cursor_peek(&s.cursor, 0) == '=' && cursor_peek(&s.cursor, 1) != '=';
}

bool script_next_global(const char *text, size_t n, size_t *at, const char **name, size_t *size)
{
    struct scan s = { .cursor = { text + *at, text + n, 1 } };
    int dots = 0; /* dots or colons directly before; exactly one means a field follows */

    while (s.cursor.p < s.cursor.end) {
        char c = *s.cursor.p;
        if (skip_space(&s))
            continue;
        if (cursor_is_letter(c)) {
            *name = s.cursor.p;
            scan_name(&s);
            *at = (size_t)(s.cursor.p - text);
            *size = s.size;
            if (dots != 1 && !is_assigned(s))
                return true;
            dots = 0;
        } else if (cursor_is_digit(c) || (c == '.' && cursor_is_digit(cursor_peek(&s.cursor, 1)))) {
            skip_numeral(&s.cursor);
            dots = 0;
        } else if (c == '.' || c == ':') {
            for (dots = 0; cursor_peek(&s.cursor, 0) == c; dots++)
                s.cursor.p++;
        } else {
            scan_token(&s);
            dots = 0;
        }
    }
    return false;
}

const char *script_find_field(const char *text, size_t n, size_t at, size_t *size)
{
    struct scan s = { .cursor = { text + at, text + n, 1 } };

    while (s.cursor.p < s.cursor.end && skip_space(&s))
        continue;
    if (cursor_peek(&s.cursor, 0) != '.' || cursor_peek(&s.cursor, 1) == '.')
        return NULL;
    s.cursor.p++;
    while (s.cursor.p < s.cursor.end && skip_space(&s))
        continue;
    if (!cursor_is_letter(cursor_peek(&s.cursor, 0)))
        return NULL;
    const char *first = s.cursor.p;
    scan_name(&s);
    *size = s.size;
    return first;
}

/* ---- explaining a missing `end` ---- */

enum { MAX_BLOCKS = 256 };

struct block {
    char word[9]; /* "if", "function"; "": a bracket */
    int line;
    int indent;     /* blanks at the start of that line */
    bool awaits_do; /* a for or while whose do has not been seen yet */
};

struct blocks {
    struct scan s;
    const char *text;
    struct block stack[MAX_BLOCKS];
    int n;
};

/* Returns the number of blanks at the start of p's line. Sets *is_first to whether p directly follows the blanks. */
static int indent_of(const char *text, const char *p, bool *is_first)
{
    const char *line = p;
    int n = 0;

    while (line > text && line[-1] != '\n' && line[-1] != '\r')
        line--;
    while (line + n < p && (line[n] == ' ' || line[n] == '\t'))
        n++;
    *is_first = line + n == p;
    return n;
}

static bool open_block(struct blocks *b, const char *word, int line, int indent)
{
    if (b->n == MAX_BLOCKS)
        return false;
    struct block *opened = &b->stack[b->n++];
    *opened = (struct block){ .line = line,
                              .indent = indent,
                              .awaits_do = strcmp(word, "for") == 0 || strcmp(word, "while") == 0 };
    snprintf(opened->word, sizeof opened->word, "%s", word);
    return true;
}

/* Scans the name at the current position and opens or closes a block. Returns false when the search is over; *unclosed
 * is then the block that lacks its end, or NULL. */
static bool scan_block_word(struct blocks *b, const struct block **unclosed)
{
    const char *at = b->s.cursor.p;
    struct block *top = b->n > 0 ? &b->stack[b->n - 1] : NULL;
    char word[9] = "";
    bool is_first;
    int line = b->s.cursor.line, indent = indent_of(b->text, at, &is_first);

    scan_name(&b->s);
    if (b->s.size >= sizeof word)
        return true;
    memcpy(word, at, b->s.size);
    if (strcmp(word, "do") == 0 && top != NULL && top->awaits_do) {
        top->awaits_do = false;
        return true;
    }
    if (strcmp(word, "end") == 0 || strcmp(word, "until") == 0) {
        bool is_outdented = top != NULL && top->word[0] != '\0' && is_first && line > top->line && indent < top->indent;
        *unclosed = is_outdented ? top : NULL;
        b->n -= top != NULL;
        return !is_outdented && top != NULL && top->word[0] != '\0';
    }
    static const char *const openers[] = { "do", "for", "function", "if", "repeat", "while" };
    for (size_t i = 0; i < sizeof openers / sizeof *openers; i++)
        if (strcmp(word, openers[i]) == 0)
            return open_block(b, word, line, indent);
    return true;
}

/* Like scan_block_word, for any other token. A bracket that closes while a block inside it is open shows that this
 * block lacks its end. */
static bool scan_block_token(struct blocks *b, const struct block **unclosed)
{
    const char c = *b->s.cursor.p;
    bool opening = c == '(' || c == '{' || (c == '[' && cursor_long_level(&b->s.cursor) < 0);

    if (opening && !open_block(b, "", b->s.cursor.line, 0))
        return false;
    if (c == ')' || c == '}' || c == ']') {
        if (b->n == 0)
            return false;
        if (b->stack[--b->n].word[0] != '\0') {
            *unclosed = &b->stack[b->n];
            return false;
        }
    }
    scan_token(&b->s);
    return true;
}

/* Returns the block that probably lacks its `end`: the first one whose `end` is indented less than the block and so
 * probably belongs to an enclosing block; or else a block still open at a closing bracket or at the end of the text.
 * Returns NULL if there is none. */
static const struct block *find_unclosed_block(struct blocks *b, const char *text, size_t n)
{
    const struct block *unclosed = NULL;

    b->s = (struct scan){ .cursor = { text, text + n, 1 } };
    b->text = text;
    b->n = 0;
    while (b->s.cursor.p < b->s.cursor.end)
        if (!(cursor_is_letter(*b->s.cursor.p) ? scan_block_word(b, &unclosed) : scan_block_token(b, &unclosed)))
            return unclosed;
    return b->n > 0 && b->stack[b->n - 1].word[0] != '\0' ? &b->stack[b->n - 1] : NULL;
}

/* Parses Lua's message: 'end' expected (to close 'function' at line 3) near <eof>. The parenthesized part is absent
 * if the block starts on the same line. */
static void parse_end_message(const char *at, char word[16], int *line, char near_token[64])
{
    const char *opener = strstr(at, "to close '"), *number = strstr(at, "' at line "), *near_text = strstr(at, "near ");

    if (opener != NULL && number != NULL && number > opener) {
        opener += strlen("to close '");
        snprintf(word, 16, "%.*s", (int)(number - opener), opener);
        for (number += strlen("' at line "); cursor_is_digit(*number); number++)
            *line = *line * 10 + (*number - '0');
    }
    if (near_text != NULL)
        snprintf(near_token, 64, "%s",
                 strcmp(near_text, "near <eof>") == 0 ? "the end of the file" : near_text + strlen("near "));
}

/* Returns the part of Lua's message that indicates a missing end: "'end' expected", or a closing bracket or a comma
 * where a statement could start. Returns NULL if there is none. */
static char *find_missing_end(char *err)
{
    char *at = strstr(err, "'end' expected"), *symbol = strstr(err, "unexpected symbol near '");

    if (at != NULL)
        return at;
    return symbol != NULL && strchr(")}],", symbol[strlen("unexpected symbol near '")]) != NULL ? symbol : NULL;
}

/* Rewrites Lua's message about a missing end and adds a hint from the indentation, because Lua often names the outer
 * block instead. */
static void explain_end(const char *text, size_t n, char *err, size_t err_size)
{
    char *at = find_missing_end(err), word[16] = "", hint[80] = "", near_token[64] = "";
    struct blocks b;
    int line = 0;

    if (at == NULL)
        return;
    const struct block *unclosed = find_unclosed_block(&b, text, n);
    parse_end_message(at, word, &line, near_token);
    if (line == 0 && unclosed != NULL) {
        snprintf(word, sizeof word, "%s", unclosed->word);
        line = unclosed->line;
    }
    if (line == 0)
        return;
    if (unclosed != NULL && unclosed->line != line)
        snprintf(hint, sizeof hint, "; the indentation suggests `%s` at line %d", unclosed->word, unclosed->line);
    snprintf(at, err_size - (size_t)(at - err), "expected `end` to close `%s` at line %d, got %s%s", word, line,
             near_token, hint);
}

static void *allocate(void *heap, void *p, size_t old, size_t size)
{
    return heap_realloc(heap, p, p == NULL ? 0 : old, size);
}

bool script_compile(const char *text, size_t n, const char *chunk, void *scratch, size_t scratch_size, char *err,
                    size_t err_size)
{
    struct host host;

    if (n > 0 && text[0] == LUA_SIGNATURE[0])
        return err_set(err, err_size, "%s:1: expected Lua source, got compiled Lua", chunk + 1);
    host_enter(&host);
    lua_State *lua = lua_newstate(allocate, heap_init(scratch, scratch_size));
    const bool ok = lua != NULL && luaL_loadbufferx(lua, text, n, chunk, "t") == LUA_OK;
    if (lua == NULL)
        err_set(err, err_size, "%s: out of memory", chunk + 1);
    else if (!ok) {
        err_set(err, err_size, "%s", lua_tostring(lua, -1));
        explain_end(text, n, err, err_size);
    }
    /* Keep the message on one line, even if it quotes control characters. */
    for (char *c = err; !ok && *c != '\0'; c++)
        if ((unsigned char)*c < 32 || *c == 127)
            *c = ' ';
    if (lua != NULL)
        lua_close(lua);
    host_leave(&host);
    return ok;
}

bool script_check(const char *text, size_t n, const char *chunk, void *scratch, size_t scratch_size, char *err,
                  size_t err_size)
{
    const char *message;
    int line;

    return script_scan(text, n, &line, &message) ? script_compile(text, n, chunk, scratch, scratch_size, err, err_size)
                                                 : err_set(err, err_size, "%s:%d: %s", chunk + 1, line, message);
}

bool script_list_has(const char *list, const char *word, size_t n)
{
    for (const char *p = list, *end; *p != '\0'; p = *end == ' ' ? end + 1 : end) {
        end = p + strcspn(p, " ");
        if ((size_t)(end - p) == n && memcmp(p, word, n) == 0)
            return true;
    }
    return false;
}

bool script_normalize_name(const char *name, char out[SCRIPT_NAME_BYTES])
{
    const char *from = name + (strncmp(name, "./", 2) == 0 ? 2 : 0);
    size_t n = strlen(from);

    if (n >= SCRIPT_NAME_BYTES)
        return false;
    n -= n > 4 && strcmp(from + n - 4, ".lua") == 0 ? 4 : 0;
    for (size_t i = 0; i < n; i++)
        out[i] = from[i] == '.' || from[i] == '\\' ? '/' : from[i];
    out[n] = '\0';
    return strcmp(out, name) != 0;
}

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
#include "../base/heap.h"
#include "../base/host.h"

static const char no_power[] = "operator ^ is not available (results differ between machines); use x*x or math.sqrt";
static const char no_gc[] = "__gc is not available (finalizers run at different times on different machines)";
static const char no_mode[] = "__mode is not available (weak tables hold different entries on different machines)";

struct scan {
    struct cursor at;
    char word[8]; /* the first bytes of the last name or string */
    size_t size;  /* bytes in the whole name or string */
};

static void keep(struct scan *s, unsigned c)
{
    if (s->size < sizeof s->word)
        s->word[s->size] = (char)c;
    s->size++;
}

static const char *refused(const struct scan *s)
{
    if (s->size == 4 && memcmp(s->word, "__gc", 4) == 0)
        return no_gc;
    return s->size == 6 && memcmp(s->word, "__mode", 6) == 0 ? no_mode : NULL;
}

/* Scans a long bracket to its end. A newline right after the opening bracket is not part of the string. */
static void long_string(struct scan *s, int level)
{
    s->at.p += level + 2;
    s->size = 0;
    if (cursor_peek(&s->at, 0) == '\n' || cursor_peek(&s->at, 0) == '\r')
        cursor_step(&s->at);
    while (s->at.p < s->at.end && !cursor_closes(&s->at, level)) {
        keep(s, (unsigned char)*s->at.p);
        cursor_step(&s->at);
    }
    if (s->at.p < s->at.end)
        s->at.p += level + 2;
}

static void comment(struct scan *s)
{
    s->at.p += 2;
    int level = cursor_peek(&s->at, 0) == '[' ? cursor_long_level(&s->at) : -1;

    if (level >= 0) {
        long_string(s, level);
        return;
    }
    while (s->at.p < s->at.end && *s->at.p != '\n' && *s->at.p != '\r')
        s->at.p++;
}

/* \u{XXX}: the forbidden names are ASCII, so any other character counts as one byte, 255. */
static void escape_unicode(struct scan *s)
{
    unsigned v = 0;

    s->at.p++;
    if (cursor_peek(&s->at, 0) == '{')
        s->at.p++;
    for (; cursor_hex(cursor_peek(&s->at, 0)) >= 0; s->at.p++)
        v = v > 255 ? v : v * 16 + (unsigned)cursor_hex(*s->at.p);
    if (cursor_peek(&s->at, 0) == '}')
        s->at.p++;
    keep(s, v > 127 ? 255 : v);
}

static void escape_decimal(struct scan *s)
{
    unsigned v = 0;

    for (int i = 0; i < 3 && cursor_digit(cursor_peek(&s->at, 0)); i++)
        v = v * 10 + (unsigned)(*s->at.p++ - '0');
    keep(s, v);
}

static void escape_hex(struct scan *s)
{
    unsigned v = 0;

    s->at.p++;
    for (int i = 0; i < 2 && cursor_hex(cursor_peek(&s->at, 0)) >= 0; i++)
        v = v * 16 + (unsigned)cursor_hex(*s->at.p++);
    keep(s, v);
}

/* Scans an escape sequence in quotes, after its backslash. */
static void escape(struct scan *s)
{
    char c = cursor_peek(&s->at, 0);

    if (cursor_digit(c)) {
        escape_decimal(s);
    } else if (c == 'x') {
        escape_hex(s);
    } else if (c == 'u') {
        escape_unicode(s);
    } else if (c == 'z') {
        for (s->at.p++; s->at.p < s->at.end && strchr(" \t\n\v\f\r", *s->at.p) != NULL && *s->at.p != '\0';)
            cursor_step(&s->at);
    } else if (s->at.p < s->at.end) {
        keep(s, '\n'); /* a letter or a line end: recorded as \n, since no forbidden name contains its value */
        cursor_step(&s->at);
    }
}

static void quoted(struct scan *s)
{
    char quote = *s->at.p++;

    s->size = 0;
    while (s->at.p < s->at.end && *s->at.p != quote && *s->at.p != '\n' && *s->at.p != '\r') {
        if (*s->at.p == '\\') {
            s->at.p++;
            escape(s);
        } else {
            keep(s, (unsigned char)*s->at.p++);
        }
    }
    if (s->at.p < s->at.end && *s->at.p == quote)
        s->at.p++;
}

static void name(struct scan *s)
{
    s->size = 0;
    while (cursor_letter(cursor_peek(&s->at, 0)) || cursor_digit(cursor_peek(&s->at, 0)))
        keep(s, (unsigned char)*s->at.p++);
}

/* Scans one token. Returns what is wrong with it, or NULL. */
static const char *token(struct scan *s)
{
    char c = *s->at.p;

    if (c == '-' && cursor_peek(&s->at, 1) == '-') {
        comment(s);
        return NULL;
    }
    if (c == '^') {
        s->at.p++;
        return no_power;
    }
    if (cursor_letter(c))
        name(s);
    else if (c == '"' || c == '\'')
        quoted(s);
    else if (c == '[' && cursor_long_level(&s->at) >= 0)
        long_string(s, cursor_long_level(&s->at));
    else {
        cursor_step(&s->at);
        return NULL;
    }
    return refused(s);
}

bool script_scan_on(const char *text, size_t n, struct script_place *place, int *line, const char **what)
{
    struct scan s = { .at = { text + place->at, text + n, place->line } };

    while (s.at.p < s.at.end) {
        *line = s.at.line;
        *what = token(&s);
        if (*what == NULL)
            continue;
        *place = (struct script_place){ (size_t)(s.at.p - text), s.at.line };
        return false;
    }
    return true;
}

bool script_scan(const char *text, size_t n, int *line, const char **what)
{
    struct script_place start = { 0, 1 };

    return script_scan_on(text, n, &start, line, what);
}

/* Skips a numeral, which may end in a dot: "3. x" has no field x. */
static void numeral(struct cursor *at)
{
    bool hex = *at->p == '0' && (cursor_peek(at, 1) == 'x' || cursor_peek(at, 1) == 'X');
    const char *exponent = hex ? "pP" : "eE";

    for (at->p += hex ? 2 : 0; at->p < at->end && *at->p != '\0'; at->p++) {
        if (strchr(exponent, *at->p) != NULL)
            at->p += cursor_peek(at, 1) == '+' || cursor_peek(at, 1) == '-';
        else if (cursor_hex(*at->p) < 0 && *at->p != '.')
            return;
    }
}

static bool skips_space(struct scan *s)
{
    if (cursor_blank(*s->at.p))
        cursor_step(&s->at);
    else if (*s->at.p == '-' && cursor_peek(&s->at, 1) == '-')
        comment(s);
    else
        return false;
    return true;
}

/* Returns whether a single = follows. */
static bool is_assigned(struct scan s)
{
    while (s.at.p < s.at.end && skips_space(&s))
        continue;
    return cursor_peek(&s.at, 0) == '=' && cursor_peek(&s.at, 1) != '=';
}

bool script_next_read(const char *text, size_t n, size_t *at, const char **first, size_t *size)
{
    struct scan s = { .at = { text + *at, text + n, 1 } };
    int points = 0; /* dots or colons directly before; exactly one means a field follows */

    while (s.at.p < s.at.end) {
        char c = *s.at.p;
        if (skips_space(&s))
            continue;
        if (cursor_letter(c)) {
            *first = s.at.p;
            name(&s);
            *at = (size_t)(s.at.p - text);
            *size = s.size;
            if (points != 1 && !is_assigned(s))
                return true;
            points = 0;
        } else if (cursor_digit(c) || (c == '.' && cursor_digit(cursor_peek(&s.at, 1)))) {
            numeral(&s.at);
            points = 0;
        } else if (c == '.' || c == ':') {
            for (points = 0; cursor_peek(&s.at, 0) == c; points++)
                s.at.p++;
        } else {
            token(&s);
            points = 0;
        }
    }
    return false;
}

const char *script_field(const char *text, size_t n, size_t at, size_t *size)
{
    struct scan s = { .at = { text + at, text + n, 1 } };

    while (s.at.p < s.at.end && skips_space(&s))
        continue;
    if (cursor_peek(&s.at, 0) != '.' || cursor_peek(&s.at, 1) == '.')
        return NULL;
    s.at.p++;
    while (s.at.p < s.at.end && skips_space(&s))
        continue;
    if (!cursor_letter(cursor_peek(&s.at, 0)))
        return NULL;
    const char *first = s.at.p;
    name(&s);
    *size = s.size;
    return first;
}

/* ---- explaining a missing `end` ---- */

enum { MAX_BLOCKS = 256 };

struct block {
    char word[9]; /* "if", "function"; "": a bracket */
    int line;
    int indent; /* blanks at the start of that line */
    bool waits; /* a for or while whose do has not been seen yet */
};

struct blocks {
    struct scan s;
    const char *text;
    struct block open[MAX_BLOCKS];
    int n;
};

/* Returns the number of blanks at the start of p's line. Sets *first to whether p directly follows the blanks. */
static int indent_of(const char *text, const char *p, bool *first)
{
    const char *line = p;
    int n = 0;

    while (line > text && line[-1] != '\n' && line[-1] != '\r')
        line--;
    while (line + n < p && (line[n] == ' ' || line[n] == '\t'))
        n++;
    *first = line + n == p;
    return n;
}

static bool opens(struct blocks *b, const char *word, int line, int indent)
{
    if (b->n == MAX_BLOCKS)
        return false;
    struct block *one = &b->open[b->n++];
    *one = (struct block){ .line = line,
                           .indent = indent,
                           .waits = strcmp(word, "for") == 0 || strcmp(word, "while") == 0 };
    snprintf(one->word, sizeof one->word, "%s", word);
    return true;
}

/* Scans the name at the current position and opens or closes a block. Returns false when the search is over; *lacks
 * is then the block that lacks its end, or NULL. */
static bool block_word(struct blocks *b, const struct block **lacks)
{
    const char *at = b->s.at.p;
    struct block *top = b->n > 0 ? &b->open[b->n - 1] : NULL;
    char word[9] = "";
    bool first;
    int line = b->s.at.line, indent = indent_of(b->text, at, &first);

    name(&b->s);
    if (b->s.size >= sizeof word)
        return true;
    memcpy(word, at, b->s.size);
    if (strcmp(word, "do") == 0 && top != NULL && top->waits) {
        top->waits = false;
        return true;
    }
    if (strcmp(word, "end") == 0 || strcmp(word, "until") == 0) {
        bool outside = top != NULL && top->word[0] != '\0' && first && line > top->line && indent < top->indent;
        *lacks = outside ? top : NULL;
        b->n -= top != NULL;
        return !outside && top != NULL && top->word[0] != '\0';
    }
    static const char *const openers[] = { "do", "for", "function", "if", "repeat", "while" };
    for (size_t i = 0; i < sizeof openers / sizeof *openers; i++)
        if (strcmp(word, openers[i]) == 0)
            return opens(b, word, line, indent);
    return true;
}

/* Like block_word, for any other token. A bracket that closes while a block inside it is open shows that this block
 * lacks its end. */
static bool block_bracket(struct blocks *b, const struct block **lacks)
{
    const char c = *b->s.at.p;
    bool opening = c == '(' || c == '{' || (c == '[' && cursor_long_level(&b->s.at) < 0);

    if (opening && !opens(b, "", b->s.at.line, 0))
        return false;
    if (c == ')' || c == '}' || c == ']') {
        if (b->n == 0)
            return false;
        if (b->open[--b->n].word[0] != '\0') {
            *lacks = &b->open[b->n];
            return false;
        }
    }
    token(&b->s);
    return true;
}

/* Returns the block that probably lacks its `end`: the first one whose `end` is indented less than the block and so
 * probably belongs to an enclosing block; or else a block still open at a closing bracket or at the end of the text.
 * Returns NULL if there is none. */
static const struct block *block_lacking(struct blocks *b, const char *text, size_t n)
{
    const struct block *lacks = NULL;

    b->s = (struct scan){ .at = { text, text + n, 1 } };
    b->text = text;
    b->n = 0;
    while (b->s.at.p < b->s.at.end)
        if (!(cursor_letter(*b->s.at.p) ? block_word(b, &lacks) : block_bracket(b, &lacks)))
            return lacks;
    return b->n > 0 && b->open[b->n - 1].word[0] != '\0' ? &b->open[b->n - 1] : NULL;
}

/* Parses Lua's message: 'end' expected (to close 'function' at line 3) near <eof>. The parenthesized part is absent
 * if the block starts on the same line. */
static void read_expected(const char *at, char word[16], int *line, char near[64])
{
    const char *close = strstr(at, "to close '"), *number = strstr(at, "' at line "), *behind = strstr(at, "near ");

    if (close != NULL && number != NULL && number > close) {
        close += strlen("to close '");
        snprintf(word, 16, "%.*s", (int)(number - close), close);
        for (number += strlen("' at line "); cursor_digit(*number); number++)
            *line = *line * 10 + (*number - '0');
    }
    if (behind != NULL)
        snprintf(near, 64, "%s", strcmp(behind, "near <eof>") == 0 ? "the end of the file" : behind + strlen("near "));
}

/* Returns the part of Lua's message that indicates a missing end: "'end' expected", or a closing bracket or a comma
 * where a statement could start. Returns NULL if there is none. */
static char *end_missing(char *err)
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
    char *at = end_missing(err), word[16] = "", hint[80] = "", near[64] = "";
    struct blocks b;
    int line = 0;

    if (at == NULL)
        return;
    const struct block *lacks = block_lacking(&b, text, n);
    read_expected(at, word, &line, near);
    if (line == 0 && lacks != NULL) {
        snprintf(word, sizeof word, "%s", lacks->word);
        line = lacks->line;
    }
    if (line == 0)
        return;
    if (lacks != NULL && lacks->line != line)
        snprintf(hint, sizeof hint, "; the indentation suggests `%s` at line %d", lacks->word, lacks->line);
    snprintf(at, err_size - (size_t)(at - err), "expected `end` to close `%s` at line %d, got %s%s", word, line, near,
             hint);
}

static void *allocate(void *heap, void *p, size_t old, size_t size)
{
    return heap_realloc(heap, p, p == NULL ? 0 : old, size);
}

static bool compile(const char *text, size_t n, const char *chunk, void *work, size_t work_size, char *err,
                    size_t err_size)
{
    lua_State *lua = lua_newstate(allocate, heap_init(work, work_size));
    bool good;

    if (lua == NULL) {
        snprintf(err, err_size, "%s: out of memory", chunk + 1);
        return false;
    }
    good = luaL_loadbufferx(lua, text, n, chunk, "t") == LUA_OK;
    if (!good) {
        snprintf(err, err_size, "%s", lua_tostring(lua, -1));
        explain_end(text, n, err, err_size);
    }
    /* Keep the message on one line, even if it quotes control characters. */
    for (char *c = err; !good && *c != '\0'; c++)
        if ((unsigned char)*c < 32 || *c == 127)
            *c = ' ';
    lua_close(lua);
    return good;
}

bool script_compile(const char *text, size_t n, const char *chunk, void *work, size_t work_size, char *err,
                    size_t err_size)
{
    struct host host;

    if (n > 0 && text[0] == LUA_SIGNATURE[0]) {
        snprintf(err, err_size, "%s:1: expected Lua source, got compiled Lua", chunk + 1);
        return false;
    }
    host_enter(&host);
    bool good = compile(text, n, chunk, work, work_size, err, err_size);
    host_leave(&host);
    return good;
}

bool script_check(const char *text, size_t n, const char *chunk, void *work, size_t work_size, char *err,
                  size_t err_size)
{
    const char *what;
    int line;

    if (script_scan(text, n, &line, &what))
        return script_compile(text, n, chunk, work, work_size, err, err_size);
    snprintf(err, err_size, "%s:%d: %s", chunk + 1, line, what);
    return false;
}

bool script_name(const char *name, char out[SCRIPT_NAME])
{
    const char *from = name + (strncmp(name, "./", 2) == 0 ? 2 : 0);
    size_t n = strlen(from);

    if (n >= SCRIPT_NAME)
        return false;
    n -= n > 4 && strcmp(from + n - 4, ".lua") == 0 ? 4 : 0;
    for (size_t i = 0; i < n; i++)
        out[i] = from[i] == '.' || from[i] == '\\' ? '/' : from[i];
    out[n] = '\0';
    return strcmp(out, name) != 0;
}

/*
 * check_text.c - characters of the game's texts that none of its fonts has: on the screen each is a box.
 *
 * A literal that text.put writes is judged whole. Of others only what is not ASCII is looked at, for a text beyond
 * that is hardly a name; those that print, error and assert are given are none that is shown.
 */
#include "check_parts.h"

#include <stdio.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "../../board/rom/cart.h"

/* The first character that has no glyph, of those from `from` on; 0: all have one. *n: how many have none. */
static uint32_t first_missing(const struct cart *cart, const char *s, uint32_t from, int *n)
{
    const char *end = s + strlen(s);
    uint32_t first = 0;

    for (*n = 0; s < end;) {
        uint32_t code = utf8_next(&s, end);
        if (code < from || cart_has_glyph(cart, code))
            continue;
        first = first ? first : code;
        ++*n;
    }
    return first;
}

static void judge(struct check *c, const struct cart *cart, const char *path, int line, const char *s, uint32_t from)
{
    char bytes[UTF8_BYTES + 1] = "", more[48] = "";
    int n;
    uint32_t code = first_missing(cart, s, from, &n);

    if (code == 0)
        return;
    if (code > 32 && (code < 127 || code > 160))
        bytes[utf8_put(bytes, code)] = '\0';
    if (n > 1)
        snprintf(more, sizeof more, ", nor for %d more of this text", n - 1);
    diagnostics_add(&c->found, path, line, "no font of the game has a glyph for %s%s%sU+%04X%s: a box is shown",
                    bytes[0] != '\0' ? "\"" : "", bytes, bytes[0] != '\0' ? "\", " : "", (unsigned)code, more);
}

static bool is(const char *a, const char *b)
{
    return a != NULL && strcmp(a, b) == 0;
}

/* Is it one that print, error or assert is given in that line? */
static bool is_for_log(const struct symbols *f, int line)
{
    for (int i = 0; i < f->n_calls; i++)
        if (f->calls[i].line == line && f->calls[i].space == NULL &&
            (is(f->calls[i].name, "print") || is(f->calls[i].name, "error") || is(f->calls[i].name, "assert")))
            return true;
    return false;
}

static void judge_script(struct check *c, const struct cart *cart, const struct check_script *s)
{
    const struct symbols *f = &s->symbols;

    for (int i = 0; i < f->n_keys; i++) {
        const struct symbol_table *t = &f->tables[f->keys[i].table];
        if (t->key < 0 && is(t->space, "text") && is(t->name, "put") && is(f->keys[i].name, "text") &&
            f->keys[i].value != NULL)
            judge(c, cart, s->path, f->keys[i].line, f->keys[i].value, 1);
    }
    for (int i = 0; i < f->n_texts; i++)
        if (!(f->texts[i].how & SYMBOL_KEY) && !diagnostics_at(&c->found, s->path, f->texts[i].line) &&
            !is_for_log(f, f->texts[i].line))
            judge(c, cart, s->path, f->texts[i].line, f->texts[i].s, 128);
}

void check_text(struct check *c, const struct cart *cart)
{
    for (int i = 0; i < c->n_scripts; i++)
        judge_script(c, cart, &c->scripts[i]);
}

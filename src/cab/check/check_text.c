/*
 * check_text.c - characters of the game's texts that none of its fonts has, on the screen each is a box; and what its
 * languages lack.
 *
 * A literal that text.put writes is judged whole. Of others only what is not ASCII is looked at, for a text beyond
 * that is hardly a name; those that print, error and assert are given are none that is shown.
 */
#include "check_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "../../board/rom/cart.h"
#include "../pack/lang.h"
#include "../host/files.h"
#include "../pack/pack.h"

/* Where a text is shown: codes below `from` are not judged, those over `most` cannot be shown. */
struct place {
    uint32_t from, most;
};

/* The first character that has no glyph; 0: all have one. *n: how many have none. */
static uint32_t first_missing(const struct cart *cart, const char *s, struct place place, int *n)
{
    const char *end = s + strlen(s);
    uint32_t first = 0;

    for (*n = 0; s < end;) {
        uint32_t code = utf8_next(&s, end);
        if (code < place.from || (code <= place.most && cart_has_glyph(cart, code)))
            continue;
        first = first ? first : code;
        ++*n;
    }
    return first;
}

static void judge(struct check *c, const struct cart *cart, const char *path, int line, const char *s,
                  struct place place)
{
    char bytes[UTF8_BYTES + 1] = "", more[48] = "";
    int n;
    uint32_t code = first_missing(cart, s, place, &n);

    if (code == 0)
        return;
    if (code > 32 && (code < 127 || code > 160))
        bytes[utf8_put(bytes, code)] = '\0';
    if (n > 1)
        snprintf(more, sizeof more, ", nor for %d more of this text", n - 1);
    if (cart_has_glyph(cart, code)) {
        diagnostics_add(&c->found, path, line,
                        "a cell has no room for %s%s%sU+%04X%s: a box is shown (board = { wide = true } in rom.lua)",
                        bytes[0] != '\0' ? "\"" : "", bytes, bytes[0] != '\0' ? "\", " : "", (unsigned)code, more);
        return;
    }
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

/* Is it a title of a boss, or the name of a spell; or the name of who talks, or the title of a choice? */
static bool is_asked(const struct symbols *f, const struct symbol_key *k)
{
    const struct symbol_table *table = &f->tables[k->table];

    if (k->value == NULL || k->value[0] == '\0')
        return false;
    if (is(table->space, "boss") && is(table->name, "def"))
        return is(k->name, "title") || is(k->name, "spell");
    if (is(table->space, "talk") && is(table->name, "def"))
        return is(k->name, "name");
    return table->space == NULL && is(table->name, "choose") && is(k->name, "title");
}

static struct place cells(const struct check *c, uint32_t from)
{
    return (struct place){ from, c->m.wide ? UTF8_MAX : 255 };
}

static void judge_script(struct check *c, const struct cart *cart, const struct check_script *s)
{
    const struct symbols *f = &s->symbols;

    for (int i = 0; i < f->n_keys; i++) {
        const struct symbol_table *t = &f->tables[f->keys[i].table];
        if (t->key < 0 && is(t->space, "text") && is(t->name, "put") && is(f->keys[i].name, "text") &&
            f->keys[i].value != NULL)
            judge(c, cart, s->path, f->keys[i].line, f->keys[i].value, cells(c, 1));
        else if (!tree_has(&c->files, "std/hud.lua") && is_asked(f, &f->keys[i]))
            judge(c, cart, s->path, f->keys[i].line, f->keys[i].value, cells(c, 128));
    }
    for (int i = 0; i < f->n_texts; i++)
        if (!(f->texts[i].how & SYMBOL_KEY) && !diagnostics_at(&c->found, s->path, f->texts[i].line) &&
            !is_for_log(f, f->texts[i].line))
            judge(c, cart, s->path, f->texts[i].line, f->texts[i].s, (struct place){ 128, UTF8_MAX });
}

/* ---- languages ---- */

struct tongue {
    const char *path; /* "lang/de.txt" */
    struct lang lang;
};

enum { MOST_TONGUES = 64 };

struct tongues {
    struct tongue list[MOST_TONGUES];
    int n;
};

static void read_tongues(struct check *c, struct tongues *t)
{
    char err[512];
    uint8_t *text;
    size_t size;

    for (int i = 0; i < c->files.n && t->n < MOST_TONGUES; i++) {
        struct tongue *one = &t->list[t->n];
        one->path = c->files.name[i];
        if (!pack_is_lang(one->path) || !check_load(c, one->path, LANG_FILE, &text, &size))
            continue;
        files_drop_mark(text, &size);
        t->n++;
        if (!lang_read(&one->lang, (const char *)text, size, one->path, err, sizeof err)) {
            diagnostics_add_sentence(&c->found, one->path, err);
            c->broken = true;
        }
        free(text);
    }
}

static bool knows(const struct lang *l, const char *text)
{
    for (int i = 0; i < l->n; i++)
        if (strcmp(l->list[i].text, text) == 0)
            return true;
    return false;
}

/* A text that is shown in the language of the run. */
static void judge_words(struct check *c, const struct tongues *t, const char *path, int line, const char *text)
{
    char lacking[256] = "";
    size_t at = 0;

    for (int i = 0; i < t->n && at < sizeof lacking; i++)
        if (!knows(&t->list[i].lang, text))
            at += (size_t)snprintf(lacking + at, sizeof lacking - at, "%s%s", at > 0 ? ", " : "", t->list[i].path);
    if (at > 0)
        diagnostics_add(&c->found, path, line, "no words for \"%.80s\" in %s", text, lacking);
}

/* What a call shows in the language of the run: text.lang, say; or NULL. */
static const char *asked_by(const struct symbol_call *call)
{
    if (is(call->space, "text") && is(call->name, "lang"))
        return call->arg[0];
    return call->space == NULL && is(call->name, "say") ? call->arg[1] : NULL;
}

/* The titles of bosses, the names of their spells and of those who talk, and what is said and asked for in so many
 * words. */
static void judge_asked(struct check *c, const struct tongues *t, const struct check_script *s)
{
    const struct symbols *f = &s->symbols;

    for (int i = 0; i < f->n_calls; i++)
        if (asked_by(&f->calls[i]) != NULL)
            judge_words(c, t, s->path, f->calls[i].line, asked_by(&f->calls[i]));
    for (int i = 0; i < f->n_keys; i++) {
        const struct symbol_key *k = &f->keys[i];
        if (is_asked(f, k))
            judge_words(c, t, s->path, k->line, k->value);
    }
}

void check_langs(struct check *c)
{
    struct tongues *t = calloc(1, sizeof *t);

    c->found.failed = c->found.failed || t == NULL;
    if (t == NULL)
        return;
    read_tongues(c, t);
    for (int i = 0; i < c->n_scripts; i++)
        judge_asked(c, t, &c->scripts[i]);
    for (int i = 0; i < t->n; i++)
        lang_close(&t->list[i].lang);
    free(t);
}

/* The words that a language has for a text that the hud writes into cells; NULL: those it has for any. */
static void judge_tongue(struct check *c, const struct cart *cart, const struct tongue *t, const char *text)
{
    for (int k = 0; k < t->lang.n; k++) {
        const struct lang_line *one = &t->lang.list[k];
        if (text == NULL && !diagnostics_at(&c->found, t->path, one->line))
            judge(c, cart, t->path, one->line, one->words, (struct place){ 33, UTF8_MAX });
        else if (text != NULL && is(text, one->text))
            judge(c, cart, t->path, one->line, one->words, cells(c, 128));
    }
}

static void judge_titles(struct check *c, const struct cart *cart, const struct tongue *t)
{
    if (tree_has(&c->files, "std/hud.lua"))
        return;
    for (int i = 0; i < c->n_scripts; i++) {
        const struct symbols *f = &c->scripts[i].symbols;
        for (int k = 0; k < f->n_keys; k++)
            if (is_asked(f, &f->keys[k]))
                judge_tongue(c, cart, t, f->keys[k].value);
    }
}

void check_text(struct check *c, const struct cart *cart)
{
    struct tongues *t = calloc(1, sizeof *t);

    for (int i = 0; i < c->n_scripts; i++)
        judge_script(c, cart, &c->scripts[i]);
    c->found.failed = c->found.failed || t == NULL;
    if (t == NULL)
        return;
    read_tongues(c, t);
    for (int i = 0; i < t->n; i++) {
        judge_titles(c, cart, &t->list[i]);
        judge_tongue(c, cart, &t->list[i], NULL);
    }
    for (int i = 0; i < t->n; i++)
        lang_close(&t->list[i].lang);
    free(t);
}

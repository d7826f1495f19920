/*
 * check_text.c - finds characters without a glyph in any font of the game, which are drawn as boxes, and missing
 * translations.
 *
 * Literals that are certainly shown are checked completely: those in text.put, text.line, say, titles and names of
 * spells. Any other literal may be for a file, a log or a comparison. In these, only characters outside ASCII are
 * checked; such a character is a problem if a run showed it, and otherwise a note.
 */
#include "check_parts.h"
#include "program_text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "../../entities/fix.h"
#include "../../rom/cart.h"
#include "../pack/lang.h"
#include "../../common/files.h"
#include "../pack/pack.h"

/* How a text is shown: codes below `first` are not checked, and codes above `last` cannot be displayed. */
struct display {
    uint32_t first, last;
    bool certain; /* the text is certainly shown */
};

void check_note_shown(struct check *c, uint32_t code)
{
    if (code <= UTF8_MAX_CODE)
        c->shown[code / 8] |= (uint8_t)(1 << code % 8);
}

/* Returns whether a run may have showed the character. A text cell shows FIX_UNKNOWN for every code that doesn't
 * fit. */
static bool was_shown(const struct check *c, uint32_t code)
{
    const bool other = !c->m.has_wide_text && code > 255 && c->shown[FIX_UNKNOWN / 8] >> FIX_UNKNOWN % 8 & 1;

    return other || c->shown[code / 8] >> code % 8 & 1;
}

/* Returns the first character without a glyph, or 0. *n: number of characters without a glyph. */
static uint32_t first_missing(const struct cart *cart, const char *s, struct display display, int *n)
{
    const char *end = s + strlen(s);
    uint32_t first = 0;

    for (*n = 0; s < end;) {
        uint32_t code = utf8_next(&s, end);
        if (code < display.first || (code <= display.last && cart_has_glyph(cart, code)))
            continue;
        first = first ? first : code;
        ++*n;
    }
    return first;
}

static bool any_was_shown(const struct check *c, const struct cart *cart, const char *s, struct display display)
{
    const char *end = s + strlen(s);

    while (s < end) {
        uint32_t code = utf8_next(&s, end);
        if (code >= display.first && (code > display.last || !cart_has_glyph(cart, code)) && was_shown(c, code))
            return true;
    }
    return false;
}

static void check_glyphs(struct check *c, const struct cart *cart, const char *path, int line, const char *s,
                         struct display display)
{
    char bytes[UTF8_MAX_BYTES + 1] = "", more[48] = "", what[200];
    int n;
    uint32_t code = first_missing(cart, s, display, &n);

    if (code == 0)
        return;
    if (code > 32 && (code < 127 || code > 160))
        bytes[utf8_put(bytes, code)] = '\0';
    if (n > 1)
        snprintf(more, sizeof more, " and %d more character%s", n - 1, n == 2 ? "" : "s");
    snprintf(what, sizeof what, "%s %s%s%sU+%04X%s",
             cart_has_glyph(cart, code) ? "text cells cannot hold" : "no font in the game has a glyph for",
             bytes[0] != '\0' ? "\"" : "", bytes, bytes[0] != '\0' ? "\", " : "", (unsigned)code, more);
    if (!display.certain && !any_was_shown(c, cart, s, display))
        diagnostics_note(&c->found, path, line, "%s; no run shows this text", what);
    else
        diagnostics_add(&c->found, path, line, "%s: a box is drawn instead%s", what,
                        cart_has_glyph(cart, code) ? " (add wide = true to board in rom.lua)" : "");
}

/* Returns whether print, error or assert is called in the line. */
static bool is_for_log(const struct symbols *f, int line)
{
    for (int i = 0; i < f->n_calls; i++)
        if (f->calls[i].line == line && f->calls[i].space == NULL &&
            (symbols_same(f->calls[i].name, "print") || symbols_same(f->calls[i].name, "error") ||
             symbols_same(f->calls[i].name, "assert")))
            return true;
    return false;
}

/* Returns whether the key is the title of a boss, the name of a spell or of a speaker, or the title of a choice. */
static bool is_translated_key(const struct symbols *f, const struct symbol_key *k)
{
    const struct symbol_table *table = &f->tables[k->table];

    if (k->value == NULL || k->value[0] == '\0')
        return false;
    if (symbols_same(table->space, "boss") && symbols_same(table->name, "def"))
        return symbols_same(k->name, "title") || symbols_same(k->name, "spell");
    if (symbols_same(table->space, "talk") && symbols_same(table->name, "def"))
        return symbols_same(k->name, "name");
    return table->space == NULL && symbols_same(table->name, "choose") && symbols_same(k->name, "title");
}

/* Returns whether the key is the text of text.put or text.line. */
static bool is_text_key(const struct symbols *f, const struct symbol_key *k)
{
    const struct symbol_table *t = &f->tables[k->table];

    return k->value != NULL && t->key < 0 && symbols_same(k->name, "text") && symbols_same(t->space, "text") &&
           (symbols_same(t->name, "put") || symbols_same(t->name, "line"));
}

/* Returns whether the HUD writes the key's value into text cells. */
static bool is_in_cells(const struct check *c, const struct symbols *f, const struct symbol_key *k)
{
    return !tree_has(&c->files, "std/hud.lua") && is_translated_key(f, k);
}

static struct display cell_display(const struct check *c, uint32_t from)
{
    return (struct display){ from, c->m.has_wide_text ? UTF8_MAX_CODE : 255, true };
}

static struct display font_display(bool sure)
{
    return (struct display){ 128, UTF8_MAX_CODE, sure };
}

/* Returns the text that a call shows in the language of the run (text.lang, say), or NULL. */
static const char *translated_argument(const struct symbol_call *call)
{
    if (symbols_same(call->space, "text") && symbols_same(call->name, "lang"))
        return call->arg[0];
    return call->space == NULL && symbols_same(call->name, "say") ? call->arg[1] : NULL;
}

/* Returns whether the text is checked as an argument or a key. */
static bool is_checked_elsewhere(const struct check *c, const struct symbols *f, const struct symbol_text *t)
{
    for (int i = 0; i < f->n_keys; i++)
        if (f->keys[i].value != NULL && f->keys[i].line == t->line && strcmp(f->keys[i].value, t->s) == 0 &&
            (is_text_key(f, &f->keys[i]) || is_in_cells(c, f, &f->keys[i])))
            return true;
    for (int i = 0; i < f->n_calls; i++)
        if (f->calls[i].line == t->line && symbols_same(translated_argument(&f->calls[i]), t->s))
            return true;
    return false;
}

static void check_key(struct check *c, const struct cart *cart, const struct check_script *s,
                      const struct symbol_key *k)
{
    const struct symbols *f = &s->symbols;

    if (is_text_key(f, k))
        check_glyphs(c, cart, s->path, k->line, k->value,
                     symbols_same(f->tables[k->table].name, "put") ? cell_display(c, 1) : font_display(true));
    else if (is_in_cells(c, f, k))
        check_glyphs(c, cart, s->path, k->line, k->value, cell_display(c, 128));
}

static void check_script(struct check *c, const struct cart *cart, const struct check_script *s)
{
    const struct symbols *f = &s->symbols;

    for (int i = 0; i < f->n_keys; i++)
        check_key(c, cart, s, &f->keys[i]);
    for (int i = 0; i < f->n_calls; i++)
        if (translated_argument(&f->calls[i]) != NULL)
            check_glyphs(c, cart, s->path, f->calls[i].line, translated_argument(&f->calls[i]), font_display(true));
    for (int i = 0; i < f->n_texts; i++)
        if (!(f->texts[i].how & SYMBOL_KEY) && !is_checked_elsewhere(c, f, &f->texts[i]) &&
            !is_for_log(f, f->texts[i].line))
            check_glyphs(c, cart, s->path, f->texts[i].line, f->texts[i].s, font_display(false));
}

/* ---- languages ---- */

struct language {
    const char *path; /* "lang/de.txt" */
    struct lang lang;
};

enum { MAX_LANGUAGES = 64 };

struct languages {
    struct language list[MAX_LANGUAGES];
    int n;
};

static void read_languages(struct check *c, struct languages *t)
{
    char err[512];
    uint8_t *text;
    size_t size;

    for (int i = 0; i < c->files.n && t->n < MAX_LANGUAGES; i++) {
        struct language *one = &t->list[t->n];
        one->path = c->files.name[i];
        if (!pack_is_lang(one->path) || !check_load(c, one->path, LANG_MAX_FILE, &text, &size))
            continue;
        files_strip_bom(text, &size);
        t->n++;
        if (!lang_read(&one->lang, (const char *)text, size, one->path, err, sizeof err)) {
            diagnostics_add_sentence(&c->found, one->path, err);
            c->broken = true;
        }
        free(text);
    }
}

static bool has_translation(const struct lang *l, const char *text)
{
    for (int i = 0; i < l->n; i++)
        if (strcmp(l->list[i].text, text) == 0)
            return true;
    return false;
}

/* A file that has only the line `name = ...` names the language of the scripts. */
static bool has_only_name(const struct lang *l)
{
    return l->n == 1 && has_translation(l, "name");
}

/* Reports languages that have no translation of a text. */
static void check_translation(struct check *c, const struct languages *t, const char *path, int line, const char *text)
{
    char missing[256] = "";
    size_t at = 0;

    for (int i = 0; i < t->n && at < sizeof missing; i++)
        if (!has_translation(&t->list[i].lang, text) && !has_only_name(&t->list[i].lang))
            at += (size_t)snprintf(missing + at, sizeof missing - at, "%s%s", at > 0 ? ", " : "", t->list[i].path);
    if (at > 0)
        diagnostics_add(&c->found, path, line, "no translation for \"%.80s\" in %s", text, missing);
}

/* Checks the translations of titles, names and literals that are shown in the language of the run. */
static void check_translations(struct check *c, const struct languages *t, const struct check_script *s)
{
    const struct symbols *f = &s->symbols;

    for (int i = 0; i < f->n_calls; i++)
        if (translated_argument(&f->calls[i]) != NULL)
            check_translation(c, t, s->path, f->calls[i].line, translated_argument(&f->calls[i]));
    for (int i = 0; i < f->n_keys; i++) {
        const struct symbol_key *k = &f->keys[i];
        if (is_translated_key(f, k))
            check_translation(c, t, s->path, k->line, k->value);
    }
}

/* Notes how much of the program's screens a language doesn't translate. */
static void check_program_text(struct check *c, const struct language *one)
{
    int n = 0;

    for (int i = 0; program_text(i) != NULL; i++)
        n += !has_translation(&one->lang, program_text(i));
    if (n > 0 && !has_only_name(&one->lang))
        diagnostics_note(&c->found, one->path, 0,
                         "%d string%s of the program's screens %s not translated (curtain help lang prints all)", n,
                         n == 1 ? "" : "s", n == 1 ? "is" : "are");
}

void check_langs(struct check *c)
{
    struct languages *t = calloc(1, sizeof *t);

    c->found.failed = c->found.failed || t == NULL;
    if (t == NULL)
        return;
    read_languages(c, t);
    for (int i = 0; i < c->n_scripts; i++)
        check_translations(c, t, &c->scripts[i]);
    for (int i = 0; i < t->n; i++) {
        check_program_text(c, &t->list[i]);
        lang_free(&t->list[i].lang);
    }
    free(t);
}

/* Returns whether a script shows the text in the language of the run. */
static bool is_shown(const struct check *c, const char *text)
{
    for (int i = 0; i < c->n_scripts; i++) {
        const struct symbols *f = &c->scripts[i].symbols;
        for (int k = 0; k < f->n_calls; k++)
            if (symbols_same(translated_argument(&f->calls[k]), text))
                return true;
        for (int k = 0; k < f->n_keys; k++)
            if (is_translated_key(f, &f->keys[k]) && symbols_same(f->keys[k].value, text))
                return true;
    }
    return false;
}

/* Checks the translation of a text that the HUD writes into cells; NULL: all translations. */
static void check_language(struct check *c, const struct cart *cart, const struct language *t, const char *text)
{
    for (int k = 0; k < t->lang.n; k++) {
        const struct lang_line *one = &t->lang.list[k];
        if (text == NULL)
            check_glyphs(c, cart, t->path, one->line, one->words,
                         (struct display){ 33, UTF8_MAX_CODE, is_shown(c, one->text) });
        else if (symbols_same(text, one->text))
            check_glyphs(c, cart, t->path, one->line, one->words, cell_display(c, 128));
    }
}

static void check_titles(struct check *c, const struct cart *cart, const struct language *t)
{
    if (tree_has(&c->files, "std/hud.lua"))
        return;
    for (int i = 0; i < c->n_scripts; i++) {
        const struct symbols *f = &c->scripts[i].symbols;
        for (int k = 0; k < f->n_keys; k++)
            if (is_translated_key(f, &f->keys[k]))
                check_language(c, cart, t, f->keys[k].value);
    }
}

void check_text(struct check *c, const struct cart *cart)
{
    struct languages *t = calloc(1, sizeof *t);

    for (int i = 0; i < c->n_scripts; i++)
        check_script(c, cart, &c->scripts[i]);
    c->found.failed = c->found.failed || t == NULL;
    if (t == NULL)
        return;
    read_languages(c, t);
    for (int i = 0; i < t->n; i++) {
        check_titles(c, cart, &t->list[i]);
        check_language(c, cart, &t->list[i], NULL);
    }
    for (int i = 0; i < t->n; i++)
        lang_free(&t->list[i].lang);
    free(t);
}

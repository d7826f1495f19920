/*
 * check_spells.c - spells of bosses whose bonus stays what it is, in a game where that of others falls: there it was
 * hardly meant. One that is to be survived is left out, for nobody can be quick.
 */
#include "check_parts.h"

#include <string.h>

/* The key of table t by that name, or NULL. */
static const struct symbol_key *key_of(const struct symbols *f, int t, const char *name)
{
    for (int i = 0; i < f->n_keys; i++)
        if (f->keys[i].table == t && strcmp(f->keys[i].name, name) == 0)
            return &f->keys[i];
    return NULL;
}

/* The spell of table t, if that is a phase with a bonus; or NULL. */
static const struct symbol_key *spell_of(const struct symbols *f, int t)
{
    const struct symbol_table *table = &f->tables[t];
    const bool phase = table->space != NULL && table->name != NULL && strcmp(table->space, "boss") == 0 &&
                       strcmp(table->name, "def") == 0 && table->key >= 0;

    return phase && key_of(f, t, "bonus") != NULL ? key_of(f, t, "spell") : NULL;
}

static bool any_falls(const struct check *c)
{
    for (int i = 0; i < c->n_scripts; i++)
        for (int t = 0; t < c->scripts[i].symbols.n_tables; t++)
            if (spell_of(&c->scripts[i].symbols, t) != NULL && key_of(&c->scripts[i].symbols, t, "bonus_to") != NULL)
                return true;
    return false;
}

static void judge_spells(struct check *c, const struct check_script *s)
{
    const struct symbols *f = &s->symbols;

    for (int t = 0; t < f->n_tables; t++) {
        const struct symbol_key *spell = spell_of(f, t);
        if (spell != NULL && key_of(f, t, "bonus_to") == NULL && key_of(f, t, "survive") == NULL)
            diagnostics_add(
                &c->found, s->path, spell->line,
                "spell \"%s\": its bonus does not decrease, unlike the bonus of other spells (set bonus_to)",
                spell->value != NULL ? spell->value : "?");
    }
}

void check_spells(struct check *c)
{
    if (!any_falls(c))
        return;
    for (int i = 0; i < c->n_scripts; i++)
        judge_spells(c, &c->scripts[i]);
}

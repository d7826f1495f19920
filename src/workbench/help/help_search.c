/*
 * help_search.c - `curtain help lua WORD`, if WORD is neither an entry nor a table: everything with the word in its
 * name or text, the best match first; and the functions by task, at the start of `curtain help lua`.
 *
 * A name matches anywhere ("turn" in bullet:turn). A text matches at the start of its words ("turn" in "turns", not in
 * "returns"). Each entry is printed once, where it matches best.
 */
#include <stdio.h>
#include <string.h>
#include "help_lua.h"

enum rank { RANK_NAME, RANK_PART, RANK_TEXT, RANKS };

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static bool is_letter(char c)
{
    return (lower(c) >= 'a' && lower(c) <= 'z') || (c >= '0' && c <= '9');
}

static bool begins(const char *text, const char *word)
{
    while (*word && lower(*text) == lower(*word)) {
        text++;
        word++;
    }
    return !*word;
}

static bool same(const char *text, const char *word)
{
    return strlen(text) == strlen(word) && begins(text, word);
}

static bool has(const char *text, const char *word, bool at_words)
{
    for (const char *at = text; *at; at++)
        if (begins(at, word) && !(at_words && at > text && is_letter(at[-1])))
            return true;
    return false;
}

/* Rates a match by the last word of the name ("turn" of "bullet:turn"), the name and the text; RANKS: no match. */
static enum rank rank_of(const char *name, const char *text, const char *word)
{
    const char *last, *arguments = strchr(name, '(');
    char plain[64];

    snprintf(plain, sizeof plain, "%.*s", (int)(arguments ? (size_t)(arguments - name) : strlen(name)), name);
    last = strpbrk(plain, ".:");
    if (same(last ? last + 1 : plain, word) || same(plain, word))
        return RANK_NAME;
    if (has(plain, word, false))
        return RANK_PART;
    return has(text, word, true) ? RANK_TEXT : RANKS;
}

static bool has_argument(const struct api_entry *e, const char *word)
{
    for (int i = e->flags & API_METHOD ? 1 : 0; i < e->count; i++)
        if (same(e->params[i].name, word))
            return true;
    return false;
}

/* An argument's name counts as a word of the text. */
static enum rank rank_entry(const struct api_entry *e, const char *word)
{
    enum rank r = rank_of(e->name, e->help, word);

    return r == RANKS && has_argument(e, word) ? RANK_TEXT : r;
}

/* Searches a table inside arguments: a step of motion.def, a phase of boss.def. */
static bool search_part(const struct api_entry *e, const char *word, enum rank rank, void (*line)(const char *))
{
    const char *part = strchr(e->name, ' ');
    char text[400];
    bool any = false;

    for (int i = 0; i < e->count; i++)
        if (rank_of(e->params[i].name, "", word) == rank) {
            snprintf(text, sizeof text, "in each%s of %.*s:", part, (int)(part - e->name), e->name);
            line(text);
            help_param(&e->params[i], line);
            any = true;
        }
    return any;
}

static bool search_entries(const char *word, enum rank rank, void (*line)(const char *))
{
    bool any = false;

    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const struct api_entry *e = api_get_entry(&api_table, i);
        if (strchr(e->name, ' '))
            any |= search_part(e, word, rank, line);
        else if (!(e->flags & API_SYS) && rank_entry(e, word) == rank) {
            help_entry(e, false, line);
            any = true;
        }
    }
    return any;
}

static bool search_plain(const char *word, enum rank rank, void (*line)(const char *))
{
    char text[400];
    bool any = false;

    for (int i = 0; i < api_table.doc_name_count; i++) {
        const struct api_doc_name *p = &api_table.doc_names[i];
        if (rank_of(p->name, p->help, word) == rank) {
            snprintf(text, sizeof text, "%-46s %s", p->name, p->help);
            help_wrapped(text, 47, line);
            any = true;
        }
    }
    return any;
}

static bool search_properties(const char *word, enum rank rank, void (*line)(const char *))
{
    char text[400];
    bool any = false;

    for (int kind = 1; kind < HANDLE_KINDS; kind++)
        for (int i = 0; i < api_table.things[kind]->n; i++) {
            const struct api_param *p = &api_table.things[kind]->props[i];
            if (rank_of(p->name, p->help, word) != rank)
                continue;
            if (rank == RANK_NAME)
                snprintf(text, sizeof text, "property of %s: %s", api_thing_names[kind], p->help);
            else
                snprintf(text, sizeof text, "property %s of %s: %s", p->name, api_thing_names[kind], p->help);
            help_wrapped(text, 4, line);
            any = true;
        }
    return any;
}

bool help_search(const char *word, void (*line)(const char *))
{
    bool any = false;

    for (enum rank rank = RANK_NAME; word[0] && rank < RANKS; rank++) {
        any |= search_entries(word, rank, line);
        any |= search_plain(word, rank, line);
        any |= search_properties(word, rank, line);
    }
    return any;
}

/* The most common tasks, in the order of making a game. `curtain help lua NAME` explains each name. */
static const char *const tasks[][2] = {
    { "declare bullets", "bullet.def" },
    { "fire bullets", "bullet.fire pattern.ring pattern.fan pattern.spiral pattern.aimed" },
    { "move bullets", "motion.def bullet:aim bullet:turn bullet.group" },
    { "clear bullets", "bullet.clear bullet.sweep bullet:clear" },
    { "lasers", "laser.def laser.beam laser.bolt laser.curve" },
    { "enemies", "enemy.def enemy.spawn enemy:move path.def path.run" },
    { "ships and shots", "player.def shot.def shot.fire bomb.def option.def" },
    { "buttons", "pad.down pad.pressed" },
    { "wait, run tasks", "wait wait_until wait_for task.go task.own" },
    { "stages and bosses", "stage.def stage.wave stage.clear boss.def boss.fight" },
    { "when something happens", "on.hit on.kill on.graze on.take" },
    { "items and score", "item.def item.drop score.add score.rule" },
    { "show text", "text.put text.line say choose hud.banner" },
    { "show pictures", "sprite.put spark.burst bg.def bg.show screen.shake screen.flash" },
    { "sound and music", "sound.play music.play" },
    { "random numbers, angles", "rng.int rng.chance angle.to query.near" },
    { "start the game", "boot.run" },
};

void help_tasks(void (*line)(const char *))
{
    char text[160];

    line("  By task (curtain help lua NAME explains an entry, curtain help lua WORD searches names and texts):");
    for (size_t i = 0; i < sizeof tasks / sizeof *tasks; i++) {
        snprintf(text, sizeof text, "    %-24s %s", tasks[i][0], tasks[i][1]);
        line(text);
    }
    line("");
    line("  All entries:");
}

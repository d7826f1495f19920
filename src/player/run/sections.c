/*
 * sections.c - lists sections (sections.h). The game reports all stages and bosses first, so that they are known even
 * if running through a stage fails. Marks follow and are inserted after their stages.
 */
#include "sections.h"

#include <stdio.h>
#include <string.h>
#include "../../common/report.h"
#include "guard.h"

enum { MAX_FRAMES = 10000 /* frames */ };

/* Inserts an empty section at index i. Returns NULL if the list is full. */
static struct section *insert(struct sections *p, int i)
{
    if (p->n == MAX_SECTIONS)
        return NULL;
    memmove(&p->section[i + 1], &p->section[i], (size_t)(p->n - i) * sizeof p->section[0]);
    p->n++;
    p->section[i] = (struct section){ 0 };
    return &p->section[i];
}

/* Returns the index for a new child of a parent, after its other children; -1 if there is no such parent. */
static int place_of(const struct sections *p, enum section_kind parent, const char *name)
{
    for (int i = 0; i < p->n; i++) {
        if (p->section[i].kind != parent || strcmp(p->section[i].name, name) != 0)
            continue;
        for (i++; i < p->n && (p->section[i].kind == SECTION_MARK || p->section[i].kind == SECTION_PHASE);)
            i++;
        return i;
    }
    return -1;
}

static bool has(const struct sections *p, enum section_kind kind, const char *id)
{
    for (int i = 0; i < p->n; i++)
        if (p->section[i].kind == kind && strcmp(p->section[i].id, id) == 0)
            return true;
    return false;
}

void sections_id_of_marker(const struct board_marker *m, char id[64])
{
    const bool child = m->kind == MARKER_MARK || m->kind == MARKER_PHASE;

    id[0] = 0;
    if (child)
        snprintf(id, 64, "%s%c%s", m->parent, m->kind == MARKER_MARK ? ':' : '/', m->name);
    else if (m->kind == MARKER_STAGE || m->kind == MARKER_BOSS)
        snprintf(id, 64, "%s", m->name);
}

static void add(struct sections *p, enum section_kind kind, const struct board_marker *m)
{
    bool child = kind == SECTION_MARK || kind == SECTION_PHASE;
    char id[sizeof p->section[0].id];

    sections_id_of_marker(m, id);
    if (has(p, kind, id)) /* a task of the game may play a section meanwhile */
        return;
    int i = child ? place_of(p, kind == SECTION_MARK ? SECTION_STAGE : SECTION_BOSS, m->parent) : p->n;
    struct section *at = i < 0 ? NULL : insert(p, i);
    if (!at)
        return;
    at->kind = kind;
    memcpy(at->id, id, sizeof at->id);
    memcpy(at->name, m->name, sizeof at->name);
    memcpy(at->title, m->title, sizeof at->title);
    if (kind == SECTION_BOSS)
        memcpy(at->portrait, m->parent, sizeof at->portrait);
}

/* A ship's registers follow it. */
static void add_register(struct sections *p, const struct board_marker *m)
{
    if (p->registers == MAX_SHIP_REGISTERS || p->ships == 0 || strcmp(p->ship[p->ships - 1].name, m->parent) != 0)
        return;
    memcpy(p->reg[p->registers].name, m->name, sizeof m->name);
    memcpy(p->reg[p->registers].title, m->title, sizeof m->title);
    p->reg[p->registers].value = m->value;
    p->reg[p->registers++].ship = p->ships - 1;
}

static void add_ship(struct sections *p, const struct board_marker *m)
{
    if (p->ships == MAX_SHIPS)
        return;
    memcpy(p->ship[p->ships].name, m->name, sizeof m->name);
    memcpy(p->ship[p->ships].title, m->title, sizeof m->title);
    memcpy(p->ship[p->ships].sprite, m->parent, sizeof m->parent);
    p->ship[p->ships++].lives = m->value;
}

static void add_title(struct sections *p, const struct board_marker *m)
{
    if (p->titles == MAX_TITLES)
        return;
    p->title[p->titles].kind = m->kind;
    memcpy(p->title[p->titles].name, m->name, sizeof m->name);
    memcpy(p->title[p->titles++].title, m->title, sizeof m->title);
}

/* Adds what a marker reports. Returns true at the end of the list. */
static bool read_marker(struct sections *p, const struct board_marker *m)
{
    switch (m->kind) {
    case MARKER_STAGE:
        add(p, SECTION_STAGE, m);
        break;
    case MARKER_MARK:
        add(p, SECTION_MARK, m);
        break;
    case MARKER_BOSS:
        add(p, SECTION_BOSS, m);
        break;
    case MARKER_PHASE:
        add(p, SECTION_PHASE, m);
        break;
    case MARKER_SHIP:
        add_ship(p, m);
        break;
    case MARKER_REGISTER:
        add_register(p, m);
        break;
    case MARKER_DIFFICULTY:
    case MARKER_MISSION:
        add_title(p, m);
        break;
    default:
        return m->kind == MARKER_LISTED;
    }
    return false;
}

/* Ticks until the list is complete. */
static void read_sections(struct sections *p, struct guard *g, bool log)
{
    const uint16_t none[MAX_PLAYERS] = { 0 };
    const struct board_out *out = board_last_output(g->board);
    bool done = false;

    for (int f = 0; !out->fault && !done && f < MAX_FRAMES; f++) {
        out = guard_tick(g, none);
        for (int i = 0; i < out->marker_count; i++)
            done |= read_marker(p, &out->marker[i]);
        if (log)
            report_log(out, "curtain: ");
    }
    if (out->fault)
        snprintf(p->why, sizeof p->why, "%s", out->fault->message);
    else if (!done)
        snprintf(p->why, sizeof p->why, "the game does not list its sections");
}

void sections_list(struct sections *p, const struct rom *rom, const struct board_start *start, bool log)
{
    struct board_start ask = *start;
    struct guard g;

    memset(p, 0, sizeof *p);
    memset(&ask.practice, 0, sizeof ask.practice);
    snprintf(ask.practice.section, sizeof ask.practice.section, "%s", PRACTICE_LIST);
    if (!guard_power(&g, rom, &ask, p->why, sizeof p->why))
        return;
    read_sections(p, &g, log);
    guard_close(&g);
}

const char *sections_title(const struct sections *p, enum board_marker_kind kind, const char *name)
{
    for (int i = 0; kind == MARKER_STAGE && i < p->n; i++)
        if (p->section[i].kind == SECTION_STAGE && strcmp(p->section[i].name, name) == 0)
            return p->section[i].title;
    for (int i = 0; kind == MARKER_SHIP && i < p->ships; i++)
        if (strcmp(p->ship[i].name, name) == 0)
            return p->ship[i].title;
    for (int i = 0; i < p->titles; i++)
        if (p->title[i].kind == kind && strcmp(p->title[i].name, name) == 0)
            return p->title[i].title;
    return name;
}

bool sections_need_reaching(const struct rom *rom, bool is_folder)
{
    const int i = rom_find(rom, PRACTICE_LUMP);
    struct lump word = { 0 };

    if (i < 0)
        return !is_folder;
    rom_lump(rom, i, &word);
    return word.size != strlen("all") || memcmp(word.data, "all", word.size) != 0;
}

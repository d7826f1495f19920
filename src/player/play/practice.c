/*
 * practice.c - the practice menu (practice.h), one list of rows: the game's title, the settings, the sections.
 */
#include "practice.h"

#include <stdio.h>
#include <string.h>
#include "../../base/int.h"

/* ---- rows ---- */

enum row_kind {
    ROW_TITLE,
    ROW_DIFFICULTY,
    ROW_LIVES,
    ROW_REGISTER,
    ROW_INVINCIBLE,
    ROW_HITBOX,
    ROW_SPEED,
    ROW_BLANK,
    ROW_SECTION
};

struct row {
    enum row_kind kind;
    int i; /* of a register or section */
};

static int rows(const struct practice_menu *m)
{
    return m->sections.n ? 7 + m->sections.registers + m->sections.n : 1;
}

static struct row row_at(const struct practice_menu *m, int at)
{
    static const enum row_kind after[] = { ROW_INVINCIBLE, ROW_HITBOX, ROW_SPEED, ROW_BLANK };
    int n = m->sections.registers;

    if (at < 3) /* the title alone when there are no sections */
        return (struct row){ (enum row_kind)(ROW_TITLE + at), 0 };
    if (at < 3 + n)
        return (struct row){ ROW_REGISTER, at - 3 };
    if (at < 7 + n)
        return (struct row){ after[at - 3 - n], 0 };
    return (struct row){ ROW_SECTION, at - 7 - n };
}

/* Returns whether a row can't be chosen: the blank line, and the bosses' headings. */
static bool is_heading(const struct practice_menu *m, struct row r)
{
    return r.kind == ROW_BLANK || (r.kind == ROW_SECTION && m->sections.section[r.i].kind == SECTION_BOSS);
}

/* Returns the row of a section, or if there is none with that id, that of the first section or the title. */
static int row_of(const struct practice_menu *m, const char *id)
{
    int first = 0;

    for (int at = rows(m) - 1; at > 0; at--) {
        struct row r = row_at(m, at);
        if (r.kind != ROW_SECTION || is_heading(m, r))
            continue;
        if (strcmp(m->sections.section[r.i].id, id) == 0)
            return at;
        first = at;
    }
    return first;
}

/* ---- counting ---- */

static int difficulty_of(const struct practice_menu *m, const struct board_start *start)
{
    return start->difficulty < 0 ? m->cart->manifest.difficulty : start->difficulty;
}

void practice_init(struct practice_menu *m, const struct cart *cart, const struct board_start *start)
{
    *m = (struct practice_menu){ .cart = cart, .home = *start, .start = *start, .speed = 100 };
    memset(&m->home.practice, 0, sizeof m->home.practice);
    records_load(&m->records, cart->manifest.id);
}

void practice_start_run(struct practice_menu *m, const struct board_start *start)
{
    m->start = *start;
    m->counts = start->practice.section[0] && !start->practice.invincible;
    m->attempting = false;
}

void practice_stop_counting(struct practice_menu *m)
{
    m->counts = m->attempting = false;
}

void practice_reloaded(struct practice_menu *m, const struct cart *cart)
{
    m->cart = cart;
    m->listed = false;
    practice_stop_counting(m);
}

/* Returns whether the marker completes the section, ignoring its ship, "@NAME". */
static bool completes(const char *section, const struct board_marker *marker)
{
    char name[80];

    if (marker->kind == MARKER_WON) {
        const size_t n = (size_t)snprintf(name, sizeof name, "%s/%s", marker->parent, marker->name);
        return strncmp(section, name, n) == 0 && (section[n] == '\0' || section[n] == '@');
    }
    if (marker->kind != MARKER_CLEAR || strchr(section, '/'))
        return false;
    size_t n = strcspn(section, ":@");
    return n == strlen(marker->name) && memcmp(section, marker->name, n) == 0;
}

static void count_marker(struct practice_menu *m, const struct board_marker *marker)
{
    const char *section = m->start.practice.section,
               *difficulty = m->cart->manifest.difficulties[difficulty_of(m, &m->start)];

    if (marker->kind == MARKER_START) {
        records_attempt(&m->records, section, difficulty);
        m->attempting = true;
    } else if (marker->kind == MARKER_DEATH) {
        m->attempting = false;
    } else if (m->attempting && completes(section, marker)) {
        records_capture(&m->records, section, difficulty);
        m->attempting = false;
    }
}

void practice_after_tick(struct practice_menu *m, const struct board_out *out)
{
    for (int i = 0; m->counts && i < out->marker_count; i++)
        count_marker(m, &out->marker[i]);
}

void practice_close(struct practice_menu *m)
{
    records_free(&m->records);
}

/* ---- opening and choosing ---- */

static void list(struct practice_menu *m)
{
    sections_list(&m->sections, m->cart->rom, &m->start, true);
    m->listed = true;
    for (int i = 0; i < m->sections.registers; i++)
        m->value[i] = m->sections.reg[i].value;
}

/* Copies the settings of the present run. */
static void take_settings(struct practice_menu *m)
{
    const struct practice *p = &m->start.practice;

    m->difficulty = difficulty_of(m, &m->start);
    if (!p->section[0])
        return;
    snprintf(m->section, sizeof m->section, "%s", p->section);
    m->lives = p->lives;
    m->invincible = p->invincible;
    for (int i = 0; i < m->sections.registers; i++)
        for (int k = 0; k < p->register_count; k++)
            if (strcmp(m->sections.reg[i].name, p->reg[k].name) == 0)
                m->value[i] = p->reg[k].value;
}

void practice_chosen(const struct practice_menu *m, struct board_start *out)
{
    struct practice *p = &out->practice;

    *out = m->section[0] ? m->start : m->home;
    memset(p, 0, sizeof *p);
    if (!m->section[0])
        return;
    out->difficulty = m->difficulty;
    memcpy(p->section, m->section, sizeof p->section);
    p->lives = m->lives;
    p->invincible = m->invincible;
    for (int i = 0; i < m->sections.registers; i++) {
        if (m->value[i] == m->sections.reg[i].value)
            continue;
        memcpy(p->reg[p->register_count].name, m->sections.reg[i].name, sizeof p->reg[0].name);
        p->reg[p->register_count++].value = m->value[i];
    }
}

static int wrap(int v, int lo, int hi)
{
    return v < lo ? hi : v > hi ? lo : v;
}

/* A register stops at 0. */
static int32_t add_within(int32_t v, int by)
{
    int64_t sum = (int64_t)v + by;

    return (int32_t)(sum < 0 ? 0 : sum > INT32_MAX ? INT32_MAX : sum);
}

/* by: -1 or 1; -10 or 10 for numbers. */
static void change(void *context, int at, int by)
{
    struct practice_menu *m = context;
    const struct row r = row_at(m, at);
    const int direction = by < 0 ? -1 : 1;

    switch (r.kind) {
    case ROW_DIFFICULTY:
        m->difficulty = wrap(m->difficulty + direction, 0, m->cart->manifest.n_difficulties - 1);
        break;
    case ROW_LIVES:
        m->lives = wrap(m->lives + by, 0, PRACTICE_MAX_LIVES);
        break;
    case ROW_REGISTER:
        m->value[r.i] = add_within(m->value[r.i], by);
        break;
    case ROW_INVINCIBLE:
        m->invincible = !m->invincible;
        break;
    case ROW_HITBOX:
        m->hitbox = !m->hitbox;
        break;
    case ROW_SPEED:
        m->speed = int_max(25, int_min(m->speed + 5 * direction, 100));
        break;
    default:
        break;
    }
}

static void accept(void *context, int at)
{
    struct practice_menu *m = context;
    const struct row r = row_at(m, at);

    if (r.kind == ROW_TITLE)
        m->section[0] = 0;
    else
        memcpy(m->section, m->sections.section[r.i].id, sizeof m->section);
    m->start_chosen = true;
    screens_close_all(m->screens);
}

/* ---- rows as they are shown ---- */

static int count(void *context)
{
    return rows(context);
}

static const struct record *record_of(const struct practice_menu *m, const struct section *section)
{
    return records_find(&m->records, section->id, m->cart->manifest.difficulties[m->difficulty]);
}

/* Grey: never tried; yellow: never captured. */
static enum canvas_colour colour_of(const struct record *r)
{
    return !r || !r->attempts ? CANVAS_GREY : r->captures ? CANVAS_GREEN : CANVAS_YELLOW;
}

/* A boss has its title as label and its name as value; other sections have both as label. */
static void describe_section(const struct practice_menu *m, const struct section *section, struct screen_row *row)
{
    const struct record *r = record_of(m, section);
    const bool stage = section->kind == SECTION_STAGE, titled = section->title[0];

    if (section->kind == SECTION_BOSS) {
        snprintf(row->label, sizeof row->label, "%s", titled ? section->title : section->name);
        snprintf(row->value, sizeof row->value, "%s", titled ? section->name : "");
        row->value_colour = CANVAS_GREY;
        return;
    }
    snprintf(row->label, sizeof row->label, "%s%s%s%s", stage ? "Stage " : "  ", section->name, titled ? "  " : "",
             section->title);
    snprintf(row->value, sizeof row->value, "%d/%d", r ? (int)r->captures : 0, r ? (int)r->attempts : 0);
    if (m->records.damaged)
        snprintf(row->help, sizeof row->help, "Attempts are not counted: the practice file is damaged.");
    else if (r && r->attempts)
        snprintf(row->help, sizeof row->help, "Cleared in %d of %d attempts.", (int)r->captures, (int)r->attempts);
    else
        snprintf(row->help, sizeof row->help, "No attempts yet.");
    row->colour = stage ? CANVAS_CYAN : CANVAS_WHITE;
    row->value_colour = colour_of(r);
}

static void describe_setting(const struct practice_menu *m, struct row r, struct screen_row *row)
{
    static const char *const names[] = { "", "Difficulty", "Lives", "", "Invincible", "Show Hitboxes", "Speed" };

    snprintf(row->label, sizeof row->label, "%s", r.kind == ROW_REGISTER ? m->sections.reg[r.i].name : names[r.kind]);
    row->changes = true;
    switch (r.kind) {
    case ROW_DIFFICULTY:
        snprintf(row->value, sizeof row->value, "%s", m->cart->manifest.difficulties[m->difficulty]);
        break;
    case ROW_LIVES:
        snprintf(row->value, sizeof row->value, m->lives ? "%d" : "Default: %d",
                 m->lives ? m->lives : (int)m->sections.lives);
        break;
    case ROW_REGISTER:
        snprintf(row->value, sizeof row->value, "%d", (int)m->value[r.i]);
        break;
    case ROW_INVINCIBLE:
        snprintf(row->value, sizeof row->value, "%s", m->invincible ? "On" : "Off");
        break;
    case ROW_HITBOX:
        snprintf(row->value, sizeof row->value, "%s", m->hitbox ? "On" : "Off");
        break;
    default:
        snprintf(row->value, sizeof row->value, "%d%%", m->speed);
    }
}

static void describe(void *context, int at, struct screen_row *row)
{
    const struct practice_menu *m = context;
    const struct row r = row_at(m, at);

    row->heading = is_heading(m, r);
    if (r.kind == ROW_SECTION)
        describe_section(m, &m->sections.section[r.i], row);
    else if (r.kind == ROW_TITLE)
        snprintf(row->label, sizeof row->label, "Start from Title");
    else if (r.kind != ROW_BLANK)
        describe_setting(m, r, row);
}

static const char *text(void *context)
{
    return ((const struct practice_menu *)context)->sections.why;
}

const struct screen_def practice_screen = {
    .title = "Practice", .text = text, .rows = count, .row = describe, .change = change, .accept = accept
};

void practice_open(struct practice_menu *m, struct screens *screens, int speed)
{
    if (!m->listed)
        list(m);
    take_settings(m);
    m->screens = screens;
    m->start_chosen = false;
    m->speed = speed;
    screens_open(screens, &practice_screen, m);
    screens_choose(screens, row_of(m, m->section));
}

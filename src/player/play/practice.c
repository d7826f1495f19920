/*
 * practice.c - the practice menu (practice.h): a page with the section, the ship, the difficulty and the loadout, and
 * the list of sections to choose from. A choice that the game doesn't offer has no row.
 */
#include "practice.h"

#include <stdio.h>
#include <string.h>
#include "../../base/int.h"
#include "../screens/screen_picture.h"

/* ---- rows ---- */

enum row_kind {
    ROW_START,
    ROW_SECTION,
    ROW_SHIP,
    ROW_DIFFICULTY,
    ROW_LOADOUT, /* a heading */
    ROW_LIVES,
    ROW_REGISTER,
    ROW_INVINCIBLE,
    ROW_HITBOX,
    ROW_SPEED,
    ROW_KINDS,
    MAX_ROWS = ROW_KINDS + MAX_SHIP_REGISTERS
};

struct row {
    enum row_kind kind;
    int i; /* of a register */
};

/* Lists the rows; none in a game without sections. Returns their number. */
static int list_rows(const struct practice_menu *m, struct row out[MAX_ROWS])
{
    const struct sections *s = &m->sections;
    int n = 0;

    for (int kind = ROW_START; kind < ROW_KINDS && s->n > 0; kind++) {
        if ((kind == ROW_SHIP && s->ships < 2) || (kind == ROW_DIFFICULTY && m->cart->manifest.n_difficulties < 2))
            continue;
        for (int i = 0; kind == ROW_REGISTER && i < s->registers; i++)
            if (s->reg[i].ship == m->ship)
                out[n++] = (struct row){ ROW_REGISTER, i };
        if (kind != ROW_REGISTER)
            out[n++] = (struct row){ (enum row_kind)kind, 0 };
    }
    return n;
}

static struct row row_at(const struct practice_menu *m, int at)
{
    struct row rows[MAX_ROWS];

    list_rows(m, rows);
    return rows[at];
}

/* ---- sections ---- */

/* A boss is locked until one of its phases was reached. Every game reaches its first stage. */
static bool is_locked(const struct practice_menu *m, int section)
{
    const struct section *s = &m->sections.section[section];

    if (!m->locks || (section == 0 && s->kind == SECTION_STAGE))
        return false;
    if (s->kind != SECTION_BOSS)
        return !records_reached(&m->records, s->id);
    for (int i = section + 1; i < m->sections.n && m->sections.section[i].kind == SECTION_PHASE; i++)
        if (!is_locked(m, i))
            return false;
    return true;
}

/* Returns the index of a section, or if there is none with that id, that of the first open one. */
static int find_section(const struct practice_menu *m, const char *id)
{
    int first = 0;

    for (int i = m->sections.n - 1; i >= 0; i--) {
        if (m->sections.section[i].kind == SECTION_BOSS || is_locked(m, i))
            continue;
        if (strcmp(m->sections.section[i].id, id) == 0)
            return i;
        first = i;
    }
    return first;
}

/* ---- counting ---- */

static int difficulty_of(const struct practice_menu *m, const struct board_start *start)
{
    return start->difficulty < 0 ? m->cart->manifest.difficulty : start->difficulty;
}

void practice_init(struct practice_menu *m, const struct cart *cart, const struct board_start *start, bool is_folder)
{
    *m = (struct practice_menu){ .cart = cart, .home = *start, .start = *start, .speed = 100 };
    m->locks = sections_need_reaching(cart->rom, is_folder);
    memset(&m->home.practice, 0, sizeof m->home.practice);
    records_load(&m->records, cart->manifest.id);
}

void practice_start_run(struct practice_menu *m, const struct board_start *start)
{
    m->listed = m->listed && strcmp(m->start.lang, start->lang) == 0;
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

void practice_reach(struct practice_menu *m, const struct board_marker *marker)
{
    char id[64];

    sections_id_of_marker(marker, id);
    if (marker->kind != MARKER_BOSS)
        records_reach(&m->records, id);
}

void practice_close(struct practice_menu *m)
{
    records_free(&m->records);
}

/* ---- opening and choosing ---- */

const struct sections *practice_sections(struct practice_menu *m)
{
    if (m->listed)
        return &m->sections;
    sections_list(&m->sections, m->cart->rom, &m->start, true);
    m->listed = true;
    m->ship = 0;
    for (int i = 0; i < m->sections.registers; i++)
        m->value[i] = m->sections.reg[i].value;
    return &m->sections;
}

/* Splits the id of a practice start into section and ship. */
static void take_section(struct practice_menu *m, const char *id)
{
    const char *ship = strchr(id, '@');

    snprintf(m->section, sizeof m->section, "%.*s", ship ? (int)(ship - id) : (int)strlen(id), id);
    m->ship = 0;
    for (int i = 0; ship && i < m->sections.ships; i++)
        if (strcmp(m->sections.ship[i].name, ship + 1) == 0)
            m->ship = i;
}

/* Writes the id of a practice start: the section, and its ship unless it is the first. Returns false if it is too
 * long. */
static bool section_id(const struct practice_menu *m, const char *section, char id[64])
{
    if (m->ship == 0)
        return snprintf(id, 64, "%s", section) < 64;
    return snprintf(id, 64, "%s@%s", section, m->sections.ship[m->ship].name) < 64;
}

/* Copies the settings of the present run. */
static void take_settings(struct practice_menu *m)
{
    const struct practice *p = &m->start.practice;

    m->difficulty = difficulty_of(m, &m->start);
    if (!p->section[0])
        return;
    take_section(m, p->section);
    m->lives = p->lives;
    m->invincible = p->invincible;
    for (int i = 0; i < m->sections.registers; i++)
        for (int k = 0; k < p->register_count; k++)
            if (m->sections.reg[i].ship == m->ship && strcmp(m->sections.reg[i].name, p->reg[k].name) == 0)
                m->value[i] = p->reg[k].value;
}

void practice_chosen(const struct practice_menu *m, struct board_start *out)
{
    struct practice *p = &out->practice;

    *out = m->start;
    memset(p, 0, sizeof *p);
    out->difficulty = m->difficulty;
    section_id(m, m->section, p->section);
    p->lives = m->lives;
    p->invincible = m->invincible;
    for (int i = 0; i < m->sections.registers && p->register_count < PRACTICE_MAX_REGISTERS; i++) {
        if (m->sections.reg[i].ship != m->ship || m->value[i] == m->sections.reg[i].value)
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

/* Returns whether there is more than one section to choose from. */
static bool has_choice(const struct practice_menu *m)
{
    int open = 0;

    for (int i = 0; i < m->sections.n; i++)
        open += m->sections.section[i].kind != SECTION_BOSS && !is_locked(m, i);
    return open > 1;
}

/* Chooses the next section that can be practised, with wrap-around. */
static void step_section(struct practice_menu *m, int direction)
{
    const int n = m->sections.n;

    for (int i = 0; i < n; i++) {
        m->chosen = (m->chosen + direction + n) % n;
        if (m->sections.section[m->chosen].kind != SECTION_BOSS && !is_locked(m, m->chosen))
            return;
    }
}

/* by: -1 or 1; -10 or 10 for numbers. */
static void change(void *context, int at, int by)
{
    struct practice_menu *m = context;
    const struct row r = row_at(m, at);
    const int direction = by < 0 ? -1 : 1;

    switch (r.kind) {
    case ROW_SECTION:
        step_section(m, direction);
        break;
    case ROW_SHIP:
        m->ship = wrap(m->ship + direction, 0, m->sections.ships - 1);
        break;
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

/* ---- the list of sections ---- */

/* Titles of locked sections are hidden, except those of stages. */
static const char *section_title(const struct practice_menu *m, int i)
{
    const struct section *s = &m->sections.section[i];

    return s->kind != SECTION_STAGE && is_locked(m, i) ? "? ? ?" : s->title;
}

static const struct record *record_of(const struct practice_menu *m, int i)
{
    char id[64];

    section_id(m, m->sections.section[i].id, id);
    return records_find(&m->records, id, m->cart->manifest.difficulties[m->difficulty]);
}

/* Writes the captures and attempts of a section. */
static void describe_record(const struct practice_menu *m, int i, char *out, size_t size)
{
    const struct record *r = record_of(m, i);

    if (r && r->attempts)
        snprintf(out, size, "Won %d of %d attempts.", (int)r->captures, (int)r->attempts);
    else
        snprintf(out, size, "No attempts yet.");
}

/* Writes why a section can't be started or isn't counted; "": nothing is wrong. Returns whether it can be started. */
static bool can_start(const struct practice_menu *m, int i, char *why, size_t size)
{
    char id[64];
    const bool locked = is_locked(m, i), fits = section_id(m, m->sections.section[i].id, id);

    snprintf(why, size, "%s",
             locked               ? "Not reached yet. Reach it in a game to practise it."
             : !fits              ? "This ship's name is too long for practice here."
             : m->records.damaged ? "Attempts are not counted: the practice file is damaged."
                                  : "");
    return !locked && fits;
}

/* The first row is the heading of the columns. */
static int section_rows(void *context)
{
    return 1 + ((const struct practice_menu *)context)->sections.n;
}

static void describe_section(void *context, int at, struct screen_row *row)
{
    const struct practice_menu *m = context;
    const int i = at - 1;

    row->heading = i < 0 || m->sections.section[i].kind == SECTION_BOSS;
    if (i < 0) {
        snprintf(row->value, sizeof row->value, "Won/Tried");
        row->value_colour = CANVAS_GREY;
        return;
    }
    const bool stage = m->sections.section[i].kind == SECTION_STAGE;
    snprintf(row->label, sizeof row->label, "%s%s", stage || row->heading ? "" : "  ", section_title(m, i));
    if (row->heading)
        return;
    const struct record *r = record_of(m, i);
    const int captures = r ? (int)r->captures : 0, attempts = r ? (int)r->attempts : 0;
    row->colour = stage ? CANVAS_CYAN : CANVAS_WHITE;
    row->disabled = !can_start(m, i, row->help, sizeof row->help);
    if (row->disabled)
        return;
    row->value_colour = attempts ? CANVAS_WHITE : CANVAS_GREY;
    snprintf(row->value, sizeof row->value, "%d/%d", captures, attempts);
    if (!row->help[0])
        snprintf(row->help, sizeof row->help, "Practise this section.");
}

static void choose_section(void *context, int at)
{
    struct practice_menu *m = context;

    m->chosen = at - 1;
    screens_close(m->screens);
    screens_choose(m->screens, ROW_START);
}

/* ---- the picture: the boss of the chosen section, or the ship ---- */

enum { PICTURE_HEIGHT = 56, MIN_ROWS_HEIGHT = 60 /* px, below the picture */ };

static int height(void *context, int w, int h)
{
    const struct practice_menu *m = context;

    (void)w;
    return h - PICTURE_HEIGHT >= MIN_ROWS_HEIGHT && m->sections.n > 0 && m->sections.ships > 0 ? PICTURE_HEIGHT : 0;
}

/* Returns the boss of a section, which a mark can be named after; NULL: none, or it is locked. */
static const struct section *boss_of(const struct practice_menu *m, int section)
{
    const struct section *s = m->sections.section, *found = NULL;

    for (int i = 0; i < m->sections.n; i++) {
        if (s[i].kind != SECTION_BOSS || is_locked(m, i))
            continue;
        if (s[section].kind == SECTION_PHASE ? i < section : strcmp(s[i].name, s[section].name) == 0)
            found = &s[i];
    }
    return is_locked(m, section) ? NULL : found;
}

/* Writes the title of a section below that of its stage or boss, and its record. */
static void describe_place(const struct practice_menu *m, int i, char *out, size_t size)
{
    char record[64], words[64];
    int parent = i;

    while (parent > 0 && m->sections.section[parent].kind != SECTION_STAGE &&
           m->sections.section[parent].kind != SECTION_BOSS)
        parent--;
    describe_record(m, i, record, sizeof record);
    screen_translate(&m->screens->words, record, words, sizeof words);
    snprintf(out, size, "%s%s%s\n%s", section_title(m, parent), parent == i ? "" : "\n",
             parent == i ? "" : section_title(m, i), words);
}

static void draw_section(const struct practice_menu *m, int i, const struct canvas *canvas, struct screen_area to)
{
    const struct section *boss = boss_of(m, i);
    const struct screen_area inside = { to.x + 5, to.y, to.w / 2 - 5, to.h - 8 };
    struct screen_picture picture;
    char words[256];
    int w = 0;

    describe_place(m, i, words, sizeof words);
    if (screen_picture_of_sprite(&picture, m->cart, boss ? boss->portrait : m->sections.ship[m->ship].sprite))
        w = screen_picture_draw(&picture, canvas, inside);
    const int x = inside.x + w + 8, text_w = screen_balanced_width(canvas, words, to.x + to.w - 5 - x);
    const int h = canvas_large_text_lines(canvas, words, text_w) * canvas_line_height(canvas);
    canvas_large_text_wrapped(canvas, x, to.y + int_max(0, inside.h - h) / 2 + canvas->ascent, text_w, CANVAS_WHITE,
                              words);
}

static void draw_listed(void *context, int at, const struct canvas *canvas, struct screen_area to)
{
    draw_section(context, int_max(at - 1, 0), canvas, to);
}

static const struct screen_def sections_screen = { .title = "Sections",
                                                   .rows = section_rows,
                                                   .row = describe_section,
                                                   .accept = choose_section,
                                                   .height = height,
                                                   .draw = draw_listed };

/* ---- the page ---- */

static int count(void *context)
{
    struct row rows[MAX_ROWS];

    return list_rows(context, rows);
}

static const char *difficulty_title(const struct practice_menu *m)
{
    return sections_title(&m->sections, MARKER_DIFFICULTY, m->cart->manifest.difficulties[m->difficulty]);
}

static void describe_value(const struct practice_menu *m, struct row r, char *out, size_t size)
{
    const int lives = m->sections.ships ? (int)m->sections.ship[m->ship].lives : 0;

    switch (r.kind) {
    case ROW_SECTION:
        snprintf(out, size, "%s", section_title(m, m->chosen));
        break;
    case ROW_SHIP:
        snprintf(out, size, "%s", m->sections.ship[m->ship].title);
        break;
    case ROW_DIFFICULTY:
        snprintf(out, size, "%s", difficulty_title(m));
        break;
    case ROW_LIVES:
        snprintf(out, size, "%d", m->lives ? m->lives : lives);
        break;
    case ROW_REGISTER:
        snprintf(out, size, "%d", (int)m->value[r.i]);
        break;
    case ROW_INVINCIBLE:
        snprintf(out, size, "%s", m->invincible ? "On" : "Off");
        break;
    case ROW_HITBOX:
        snprintf(out, size, "%s", m->hitbox ? "On" : "Off");
        break;
    case ROW_SPEED:
        snprintf(out, size, "%d%%", m->speed);
        break;
    default:
        break;
    }
}

static void describe(void *context, int at, struct screen_row *row)
{
    static const struct {
        const char *label, *help;
    } rows[ROW_KINDS] = {
        [ROW_START] = { "Start", "Practise the section with this ship and loadout." },
        [ROW_SECTION] = { "Section", "A stage, a part of it, or an attack of a boss." },
        [ROW_SHIP] = { "Ship", "The ship to fly." },
        [ROW_DIFFICULTY] = { "Difficulty", "Attempts are counted for each difficulty." },
        [ROW_LOADOUT] = { "Loadout", "" },
        [ROW_REGISTER] = { "", "Start with this value. Hold Focus: steps of 10." },
        [ROW_LIVES] = { "Lives", "The number of lives at the start." },
        [ROW_INVINCIBLE] = { "Invincible", "Hits do no harm, and attempts are not counted." },
        [ROW_HITBOX] = { "Show Hitbox", "Show the hitboxes of everything." },
        [ROW_SPEED] = { "Game Speed", "Slow the game down." },
    };
    const struct practice_menu *m = context;
    const struct row r = row_at(m, at);
    const enum row_kind kind = r.kind;

    snprintf(row->label, sizeof row->label, "%s", kind == ROW_REGISTER ? m->sections.reg[r.i].title : rows[kind].label);
    row->heading = kind == ROW_LOADOUT;
    row->action = kind == ROW_START ? "Start" : kind == ROW_SECTION ? "Show List" : NULL;
    row->changes = kind == ROW_SECTION ? has_choice(m) : kind != ROW_START && kind != ROW_LOADOUT;
    row->disabled = kind == ROW_START && !can_start(m, m->chosen, row->help, sizeof row->help);
    if (!row->help[0])
        snprintf(row->help, sizeof row->help, "%s", rows[kind].help);
    describe_value(m, r, row->value, sizeof row->value);
}

static void accept(void *context, int at)
{
    struct practice_menu *m = context;

    if (row_at(m, at).kind == ROW_SECTION) {
        screens_open(m->screens, &sections_screen, m);
        screens_choose(m->screens, m->chosen + 1);
        return;
    }
    memcpy(m->section, m->sections.section[m->chosen].id, sizeof m->section);
    m->start_chosen = true;
    screens_close_all(m->screens);
}

static const char *text(void *context)
{
    return ((const struct practice_menu *)context)->sections.why;
}

static void draw(void *context, int at, const struct canvas *canvas, struct screen_area to)
{
    const struct practice_menu *m = context;

    (void)at;
    draw_section(m, m->chosen, canvas, to);
}

const struct screen_def practice_screen = { .title = "Practice",
                                            .text = text,
                                            .rows = count,
                                            .row = describe,
                                            .change = change,
                                            .accept = accept,
                                            .height = height,
                                            .draw = draw };

void practice_open(struct practice_menu *m, struct screens *screens, int speed)
{
    practice_sections(m);
    take_settings(m);
    m->screens = screens;
    m->start_chosen = false;
    m->speed = speed;
    m->chosen = find_section(m, m->section);
    screens_open(screens, &practice_screen, m);
}

/*
 * practice.c - see practice.h. The menu is one list of rows: the game's title, the settings, the sections. It scrolls,
 * so it fits every screen; names are cut before they reach the column of numbers.
 */
#include "practice.h"

#include <stdio.h>
#include <string.h>

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

/* Where nothing can be chosen: the line between, and the bosses' headings. */
static bool passed_over(const struct practice_menu *m, int at)
{
    struct row r = row_at(m, at);

    return r.kind == ROW_BLANK || (r.kind == ROW_SECTION && m->sections.section[r.i].kind == SECTION_BOSS);
}

/* The next row that can be chosen, round the list's ends. */
static int step(const struct practice_menu *m, int at, int way)
{
    do
        at = (at + way + rows(m)) % rows(m);
    while (passed_over(m, at));
    return at;
}

/* The row of a section; the first section's, or the title's, where there is none of that id. */
static int row_of(const struct practice_menu *m, const char *id)
{
    int first = 0;

    for (int at = rows(m) - 1; at > 0; at--) {
        struct row r = row_at(m, at);
        if (r.kind != ROW_SECTION || passed_over(m, at))
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
    return start->difficulty < 0 ? m->cart->m.difficulty : start->difficulty;
}

void practice_init(struct practice_menu *m, const struct cart *cart, const struct board_start *start)
{
    *m = (struct practice_menu){ .cart = cart, .home = *start, .start = *start, .slow = 1 };
    memset(&m->home.practice, 0, sizeof m->home.practice);
    records_load(&m->records, cart->m.id);
}

void practice_began(struct practice_menu *m, const struct board_start *start)
{
    m->start = *start;
    m->counts = start->practice.section[0] && !start->practice.invincible;
    m->trying = false;
}

void practice_void(struct practice_menu *m)
{
    m->counts = m->trying = false;
}

void practice_reloaded(struct practice_menu *m, const struct cart *cart)
{
    m->cart = cart;
    m->listed = false;
    practice_void(m);
}

/* Does the marker tell that the section ended well? */
static bool ends_well(const char *section, const struct board_marker *marker)
{
    char name[80];

    if (marker->kind == MARKER_WON) {
        snprintf(name, sizeof name, "%s/%s", marker->of, marker->name);
        return strcmp(section, name) == 0;
    }
    if (marker->kind != MARKER_CLEAR || strchr(section, '/'))
        return false;
    size_t n = strcspn(section, ":");
    return n == strlen(marker->name) && memcmp(section, marker->name, n) == 0;
}

static void hear(struct practice_menu *m, const struct board_marker *marker)
{
    const char *section = m->start.practice.section, *difficulty = m->cart->m.difficulties[difficulty_of(m, &m->start)];

    if (marker->kind == MARKER_START) {
        records_attempt(&m->records, section, difficulty);
        m->trying = true;
    } else if (marker->kind == MARKER_DEATH) {
        m->trying = false;
    } else if (m->trying && ends_well(section, marker)) {
        records_capture(&m->records, section, difficulty);
        m->trying = false;
    }
}

void practice_hear(struct practice_menu *m, const struct board_out *out)
{
    for (int i = 0; m->counts && i < out->markers; i++)
        hear(m, &out->marker[i]);
}

void practice_close(struct practice_menu *m)
{
    records_save(&m->records);
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

/* The settings of the run as it is. */
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
        for (int k = 0; k < p->registers; k++)
            if (strcmp(m->sections.reg[i].name, p->reg[k].name) == 0)
                m->value[i] = p->reg[k].value;
}

void practice_open(struct practice_menu *m, int slow)
{
    if (!m->listed)
        list(m);
    take_settings(m);
    m->slow = slow;
    m->row = row_of(m, m->section);
    m->top = 0;
    m->held = PAD_ALL;
    m->held_for = 0;
    m->open = true;
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
        memcpy(p->reg[p->registers].name, m->sections.reg[i].name, sizeof p->reg[0].name);
        p->reg[p->registers++].value = m->value[i];
    }
}

static int round_to(int v, int lo, int hi)
{
    return v < lo ? hi : v > hi ? lo : v;
}

/* A register stops at 0. */
static int32_t add_within(int32_t v, int by)
{
    int64_t sum = (int64_t)v + by;

    return (int32_t)(sum < 0 ? 0 : sum > INT32_MAX ? INT32_MAX : sum);
}

static void change(struct practice_menu *m, int way, int times)
{
    struct row r = row_at(m, m->row);

    switch (r.kind) {
    case ROW_DIFFICULTY:
        m->difficulty = round_to(m->difficulty + way, 0, m->cart->m.n_difficulties - 1);
        break;
    case ROW_LIVES:
        m->lives = round_to(m->lives + way * times, 0, PRACTICE_LIVES);
        break;
    case ROW_REGISTER:
        m->value[r.i] = add_within(m->value[r.i], way * times);
        break;
    case ROW_INVINCIBLE:
        m->invincible = !m->invincible;
        break;
    case ROW_HITBOX:
        m->hitbox = !m->hitbox;
        break;
    case ROW_SPEED:
        m->slow = way > 0 ? (m->slow == 4 ? 1 : m->slow * 2) : (m->slow == 1 ? 4 : m->slow / 2);
        break;
    default:
        break;
    }
}

static enum practice_choice accept(struct practice_menu *m)
{
    struct row r = row_at(m, m->row);

    if (r.kind == ROW_TITLE)
        m->section[0] = 0;
    else if (r.kind == ROW_SECTION)
        memcpy(m->section, m->sections.section[r.i].id, sizeof m->section);
    else {
        change(m, 1, 1);
        return PRACTICE_STAYS;
    }
    m->open = false;
    return PRACTICE_START;
}

/* Buttons that go down, or do so again because they are held. */
static uint16_t pressed(struct practice_menu *m, uint16_t pad)
{
    enum { WAIT = 20, AGAIN = 3 };
    const uint16_t ways = PAD_UP | PAD_DOWN | PAD_LEFT | PAD_RIGHT;
    uint16_t fresh = (uint16_t)(pad & ~m->held);

    m->held_for = pad & ways && !(fresh & ways) ? m->held_for + 1 : 0;
    m->held = pad;
    if (m->held_for >= WAIT && (m->held_for - WAIT) % AGAIN == 0)
        fresh |= (uint16_t)(pad & ways);
    return fresh;
}

enum practice_choice practice_poll(struct practice_menu *m, uint16_t pad)
{
    uint16_t fresh = pressed(m, pad);
    int times = pad & PAD_FOCUS ? 10 : 1;

    if (fresh & PAD_UP)
        m->row = step(m, m->row, -1);
    if (fresh & PAD_DOWN)
        m->row = step(m, m->row, 1);
    if (fresh & PAD_LEFT)
        change(m, -1, times);
    if (fresh & PAD_RIGHT)
        change(m, 1, times);
    if (fresh & PAD_FIRE)
        return accept(m);
    m->open = !(fresh & PAD_BOMB);
    return m->open ? PRACTICE_STAYS : PRACTICE_BACK;
}

/* ---- drawing ---- */

enum { ROW_H = INK_CELL_H + 1, EDGE = 2, FOOT_FROM = 160 /* px of height with room for a line of help */ };

/* Where the menu stands, in pixels; the rows and the numbers' column end at right. */
struct page {
    const struct ink *ink;
    int x, y, w, h;
};

/* Text cut to w pixels, with two dots where it is cut. */
static void put(const struct page *p, int x, int y, int w, enum ink_colour c, const char *text)
{
    int room = w / INK_CELL_W, n = (int)strlen(text);

    if (n <= room) {
        ink_text(p->ink, x, y, c, text);
        return;
    }
    int kept = room > 2 ? room - 2 : 0;
    x = ink_bytes(p->ink, x, y, c, text, kept);
    ink_bytes(p->ink, x, y, c, "..", room - kept);
}

/* A row's left part, and its right one against the edge, which is never cut. */
static void line(const struct page *p, int y, int indent, enum ink_colour c, const char *left, enum ink_colour rc,
                 const char *right)
{
    int x = p->x + EDGE + indent * INK_CELL_W, end = p->x + p->w - EDGE, w = ink_width(right);

    put(p, x, y, end - x - (w ? w + INK_CELL_W : 0), c, left);
    ink_text(p->ink, end - w, y, rc, right);
}

static const struct record *record_of(const struct practice_menu *m, const struct section *section)
{
    return records_find(&m->records, section->id, m->cart->m.difficulties[m->difficulty]);
}

/* Grey: never tried; yellow: never captured. */
static enum ink_colour colour_of(const struct record *r)
{
    return !r || !r->attempts ? INK_GREY : r->captures ? INK_GREEN : INK_YELLOW;
}

/* A boss by its title, with its name where numbers stand; all else by its name, and what follows that. */
static void draw_section(const struct practice_menu *m, const struct page *p, int y, const struct section *section,
                         bool chosen)
{
    const struct record *r = record_of(m, section);
    bool stage = section->kind == SECTION_STAGE;
    char left[96], right[32];

    if (section->kind == SECTION_BOSS) {
        line(p, y, 0, INK_CYAN, section->title[0] ? section->title : section->name, INK_GREY,
             section->title[0] ? section->name : "");
        return;
    }
    snprintf(left, sizeof left, "%s%s%s%s", stage ? "stage " : "", section->name, section->title[0] ? "  " : "",
             section->title);
    snprintf(right, sizeof right, "%d/%d", r ? (int)r->captures : 0, r ? (int)r->attempts : 0);
    line(p, y, stage ? 0 : 2,
         chosen  ? INK_PAPER
         : stage ? INK_CYAN
                 : INK_WHITE,
         left, chosen ? INK_PAPER : colour_of(r), right);
}

/* The words of a setting. */
static void setting(const struct practice_menu *m, struct row r, char left[64], char right[32])
{
    static const char *const speeds[] = { "", "1", "1/2", "", "1/4" };
    static const char *const names[] = { "", "difficulty", "lives", "", "invincible", "hitbox", "speed" };

    snprintf(left, 64, "%s", r.kind == ROW_REGISTER ? m->sections.reg[r.i].name : names[r.kind]);
    switch (r.kind) {
    case ROW_DIFFICULTY:
        snprintf(right, 32, "%s", m->cart->m.difficulties[m->difficulty]);
        break;
    case ROW_LIVES:
        snprintf(right, 32, m->lives ? "%d" : "ship: %d", m->lives ? m->lives : (int)m->sections.lives);
        break;
    case ROW_REGISTER:
        snprintf(right, 32, "%d", (int)m->value[r.i]);
        break;
    case ROW_INVINCIBLE:
        snprintf(right, 32, "%s", m->invincible ? "yes" : "no");
        break;
    case ROW_HITBOX:
        snprintf(right, 32, "%s", m->hitbox ? "shown" : "no");
        break;
    default:
        snprintf(right, 32, "%s", speeds[m->slow]);
    }
}

static void draw_row(const struct practice_menu *m, const struct page *p, int y, int at)
{
    struct row r = row_at(m, at);
    bool chosen = at == m->row;
    char left[64], right[32], both[40];

    if (chosen)
        ink_rect(p->ink, p->x, y - 1, p->w, ROW_H, INK_WHITE);
    if (r.kind == ROW_SECTION)
        draw_section(m, p, y, &m->sections.section[r.i], chosen);
    else if (r.kind == ROW_TITLE)
        line(p, y, 0, chosen ? INK_PAPER : INK_WHITE, "the game from its title", INK_PAPER, "");
    else if (r.kind != ROW_BLANK) {
        setting(m, r, left, right);
        snprintf(both, sizeof both, chosen ? "< %s >" : "%s", right);
        line(p, y, 0, chosen ? INK_PAPER : INK_WHITE, left, chosen ? INK_PAPER : INK_YELLOW, both);
    }
}

/* How many bytes of s stand on one line; breaks at blanks where there are some. */
static int words(const char *s, int room)
{
    int n = (int)strlen(s), at = room;

    if (n <= room)
        return n;
    while (at > room / 2 && s[at] != ' ')
        at--;
    return s[at] == ' ' ? at : room;
}

/* A sentence in lines from y on; returns the y after it. */
static int sentence(const struct page *p, int y, const char *s)
{
    int room = (p->w - 2 * EDGE) / INK_CELL_W;

    while (*s && room > 0 && y + INK_CELL_H <= p->y + p->h / 2) {
        int n = words(s, room);
        ink_bytes(p->ink, p->x + EDGE, y, INK_RED, s, n);
        s += n;
        s += strspn(s, " ");
        y += ROW_H;
    }
    return y;
}

/* The first row shown so that the chosen one is, and the row before a section's first too: it is a heading. */
static int scrolled(const struct practice_menu *m, int shown)
{
    int top = m->top, most = rows(m) - shown;

    if (m->row < top + 1)
        top = m->row - 1;
    if (m->row > top + shown - 2)
        top = m->row - shown + 2;
    if (top > most)
        top = most;
    return top < 0 ? 0 : top;
}

static struct page page_of(const struct ink *ink)
{
    int w = ink->fb->w, h = ink->fb->h, margin = w >= 160 && h >= 160 ? 8 : 0;

    return (struct page){ ink, margin, margin, w - 2 * margin, h - 2 * margin };
}

static void draw_bar(const struct practice_menu *m, const struct page *p, int y)
{
    int n = rows(m), h = m->shown * ROW_H;

    if (n > m->shown)
        ink_rect(p->ink, p->x + p->w - 1, y + h * m->top / n, 1, h * m->shown / n, INK_GREY);
}

void practice_draw(struct practice_menu *m, const struct ink *ink)
{
    struct page p = page_of(ink);
    int y = p.y + EDGE;

    ink_rect(ink, p.x, p.y, p.w, p.h, INK_PAPER);
    ink_frame(ink, p.x - 1, p.y - 1, p.w + 2, p.h + 2, INK_GREY);
    line(&p, y, 0, INK_GREY, "practice", INK_GREY, m->records.damaged ? "not counted" : "won/tried");
    y += ROW_H;
    if (m->sections.why[0])
        y = sentence(&p, y, m->sections.why);
    bool foot = p.h >= FOOT_FROM;
    m->shown = (p.y + p.h - y) / ROW_H - foot;
    if (foot)
        line(&p, p.y + p.h - ROW_H, 0, INK_GREY, "fire: start   bomb: back   left, right: change", INK_GREY, "");
    m->top = scrolled(m, m->shown);
    for (int i = 0; i < m->shown && m->top + i < rows(m); i++)
        draw_row(m, &p, y + 1 + i * ROW_H, m->top + i);
    draw_bar(m, &p, y);
}

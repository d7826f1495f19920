/*
 * sections.h - lists the sections of a game for practice: its stages with their marks, its bosses with their phases;
 * and the titles that the game's menus show for these, for ships, difficulties and missions.
 *
 * The list is made by a second board (PRACTICE_LIST, board.h), so games built on @std don't declare their sections.
 */
#ifndef PLAYER_SECTIONS_H
#define PLAYER_SECTIONS_H

#include "../../board/board.h"

/* A lump with the word that rom.lua has for `practice`: "all", or "reached". Not part of the game hash. */
#define PRACTICE_LUMP "practice"

enum { MAX_SECTIONS = 512, MAX_SHIPS = 32, MAX_SHIP_REGISTERS = 256, MAX_TITLES = 128 }; /* more are not listed */

enum section_kind {
    SECTION_STAGE,
    SECTION_MARK, /* a mark of the stage before it */
    SECTION_BOSS, /* a heading, not a start */
    SECTION_PHASE /* of the boss before it */
};

struct section {
    enum section_kind kind;
    char id[64];       /* of the practice start, without a ship; for a boss its name */
    char name[32];     /* without its parent's */
    char title[48];    /* as the game's menus and banners show it */
    char portrait[32]; /* sprite of a boss; "": none */
};

struct sections {
    int n;
    struct section section[MAX_SECTIONS];
    int ships;
    struct {
        char name[32], title[48], sprite[32];
        int32_t lives; /* in all */
    } ship[MAX_SHIPS]; /* practice uses the first one by default */
    int registers;
    struct {
        char name[32], title[48];
        int32_t value;
        int ship; /* index of its ship */
    } reg[MAX_SHIP_REGISTERS];
    int titles;
    struct {
        enum board_marker_kind kind; /* MARKER_DIFFICULTY or MARKER_MISSION */
        char name[32], title[48];
    } title[MAX_TITLES];
    char why[512]; /* why the list is incomplete; "": it is complete */
};

/* Lists the sections of a game with this start, ignoring start->practice. Takes the time of a few frames, and meanwhile
 * the memory of a board. log: prints the board's script output with plat_log. */
void sections_list(struct sections *p, const struct rom *rom, const struct board_start *start, bool log);

/* Returns whether practice opens only sections that were reached in a game. If rom.lua doesn't say so, that is the case
 * except for a game that is played from its folder. */
bool sections_need_reaching(const struct rom *rom, bool is_folder);

/* Writes the practice start, without a ship, of the section that a marker of a run starts; "" for other markers. */
void sections_id_of_marker(const struct board_marker *m, char id[64]);

/* Returns the title of a stage, ship, difficulty or mission (MARKER_STAGE, _SHIP, _DIFFICULTY, _MISSION); the name
 * itself if it is not listed. */
const char *sections_title(const struct sections *p, enum board_marker_kind kind, const char *name);

#endif

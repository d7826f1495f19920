/*
 * board_types.h - the inputs a host passes to a board and the output a board returns.
 */
#ifndef MACHINE_BOARD_TYPES_H
#define MACHINE_BOARD_TYPES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    MAX_PARTS = 64,      /* most parts of a board or demo; a uint64_t holds a set of parts: 1 << part */
    MAX_NVRAM = 1 << 20, /* bytes, the largest NVRAM image (nvram.h); a game's own limit is board.nvram */
    MAX_TEXT = 65536     /* most bytes in a script string; a longer string raises FAULT_MEMORY */
};

enum board_fault_kind {
    FAULT_NONE,
    FAULT_SCRIPT, /* an uncaught error, or one that pcall must not catch */
    FAULT_MEMORY, /* out of Lua RAM */
    FAULT_STACK,  /* call depth exceeded */
    FAULT_LOOP,   /* over 2 * 10^8 VM instructions, or equivalent work in C, in one tick */
};

struct board_fault {
    enum board_fault_kind kind;
    char message[512]; /* "stages/one.lua:42: what" */
    char trace[2048];  /* Lua traceback, lines separated by \n */
};

/* A practice start: @std/boot plays one section of the game repeatedly. All zero: the game starts at its title.
 * If the section is PRACTICE_LIST, nothing is played: starting at the first tick, the board lists every section as
 * markers, followed by MARKER_LISTED. The other fields need a section. */
enum { PRACTICE_MAX_REGISTERS = 16, PRACTICE_MAX_LIVES = 99 };
#define PRACTICE_LIST "?"
struct practice {
    char section[64]; /* "", "one", "one:mark", "queen/bloom", PRACTICE_LIST */
    int32_t lives;    /* total lives, 1 to PRACTICE_MAX_LIVES, counted as in player.def; 0: the ship kind's default */
    bool invincible;  /* players cannot be hit: bullets pass through them; grazes still count */
    int32_t register_count;
    struct {
        char name[32];
        int32_t value;
    } reg[PRACTICE_MAX_REGISTERS]; /* starting values of the ship's registers; the first `registers` entries are used */
};

/* Every input of a board other than ROM and pads; the demo header stores all fields. Zero is a good default for every
 * field except difficulty. */
struct board_start {
    uint64_t seed;
    int32_t dip[16];    /* one value per DIP switch, in the manifest's order */
    int32_t difficulty; /* index into the manifest's list; -1: the manifest's default */
    struct practice practice;
    char lang[16];        /* language of the game's text, printable ASCII; "": the game's original language */
    bool large_hud;       /* the HUD shows its most important rows in larger letters */
    bool at_title;        /* begins with the title's menu, without the opening */
    const uint8_t *nvram; /* NULL: blank */
    size_t nvram_size;    /* at most MAX_NVRAM */
};

enum board_request { REQUEST_NONE, REQUEST_ATTRACT, REQUEST_QUIT, REQUEST_HOST_SCREEN };

/* Host screens that a script can request. */
enum board_host_screen {
    HOST_SCREEN_SETTINGS,
    HOST_SCREEN_REPLAYS,
    HOST_SCREEN_PRACTICE,
    HOST_SCREEN_KEYS,
    HOST_SCREEN_QUIT, /* not a screen: the player wants to quit the program */
    HOST_SCREENS
};

/* Markers that help a player navigate a run, and the entries that PRACTICE_LIST reports. Adding a marker changes no
 * RAM. */
enum board_marker_kind {
    MARKER_STAGE, /* a stage starts; name: the stage */
    MARKER_MARK,  /* stage.mark; name: the mark, parent: the stage */
    MARKER_WAVE,  /* a wave starts (stage.wave); name: the kind of the wave's enemies */
    MARKER_BOSS,  /* a boss flies in; name: the boss, title: the boss's title */
    MARKER_PHASE, /* a boss phase starts; name: the phase's id, parent: the boss, title: the phase's spell */
    MARKER_DEATH, /* a player dies; name: "1" or "2" */
    MARKER_CLEAR, /* a stage was completed; name: the stage */
    MARKER_WON,   /* a phase was beaten; name: the phase's id, parent: the boss */
    MARKER_LOST,  /* a phase ended without being beaten; name: the phase's id, parent: the boss */
    MARKER_START, /* the section of a practice start begins or restarts */

    /* only in the output of PRACTICE_LIST. It also reports stages, marks, bosses, phases, difficulties and missions.
     * `title` is what the game's menus show, in the board's language, and the `parent` of a boss is the sprite of its
     * portrait */
    MARKER_SHIP,     /* a ship; name: its kind, parent: its sprite, value: total lives. Practice uses the first one */
    MARKER_REGISTER, /* a register; parent: the kind of its ship, name and value: those of the register */
    MARKER_LISTED,   /* the list is complete */

    /* markers of a run, continued */
    MARKER_GAME, /* a game starts; name: the kind of the first player's ship, value: number of players */
    MARKER_OVER, /* a game ends; name: "clear" (all stages), "over" (no lives) or "quit", value: stages cleared */
    MARKER_ROW,  /* a score is entered; name: the table, parent: the ship, value: row in the ship's table, 1: best */
    MARKER_DIFFICULTY, /* the game that has just started; name: its difficulty */
    MARKER_MISSION,    /* the game that has just started; name: its mission */
    MARKER_KINDS
};

/* Returns whether markers of this kind describe a run; the others belong to PRACTICE_LIST. */
static inline bool board_is_run_marker(enum board_marker_kind kind)
{
    return kind < MARKER_SHIP || kind > MARKER_LISTED;
}

enum { MAX_TICK_MARKERS = 16 /* most markers per tick; further ones are dropped */ };
struct board_marker {
    enum board_marker_kind kind;
    int32_t value;
    char name[32], parent[32]; /* printable ASCII, cut to fit; "": none */
    char title[48];            /* UTF-8 without control characters, cut to whole characters; "": none */
};

/* What a button does on the page that is shown. meaning: in the board's language; text as in a marker's title. */
enum { MAX_KEY_HINTS = 8 /* per tick; further ones are dropped */ };
struct board_key_hint {
    int player;      /* who presses it, from 0 on */
    uint32_t button; /* in the order of PAD_BUTTON_NAMES */
    char meaning[32];
};

/* A pool that refused an entity for the first time in this run. line: the log line, starting with the "FILE:LINE: " of
 * the script. */
enum { MAX_FULL_POOLS = 13 /* most full pools reported in a tick */, LOG_BYTES = 4096 };
struct board_full_pool {
    const char *part; /* "bullets" */
    char line[256];
};

/* The output of a tick for the program, valid until the next tick. Never hashed. */
struct board_out {
    enum board_request request;
    char attract[64];                   /* name of the demo lump, with REQUEST_ATTRACT */
    enum board_host_screen host_screen; /* with REQUEST_HOST_SCREEN */
    const char
        *log; /* output of print in this tick, cut off after LOG_BYTES, then a line for each entry of `full_pool`;
                             lines end in \n */
    size_t log_size;
    struct board_marker marker[MAX_TICK_MARKERS];
    int marker_count;
    struct board_full_pool full_pool[MAX_FULL_POOLS];
    int full_pool_count;
    struct board_key_hint key_hint[MAX_KEY_HINTS]; /* for the host to show, with the player's own keys */
    int key_hint_count;                            /* over 0: a page is shown, or a dialogue in a run */
    uint16_t back;                   /* the PAD_ bit of the button that leads back from the page; 0: none does */
    uint8_t typing;                  /* bit p: player p enters a name, and takes the codes of characters */
    const struct board_fault *fault; /* NULL: none. A fault ends the run. */
};

/* The phases of a tick. The host measures them, because the board cannot read a clock: a board_phase_done callback runs
 * at the end of each phase, in this order (without PHASE_MOTION while the game is frozen), before the tick restores the
 * host thread's settings (board.h). The callback must not touch the board. NULL, the value after power-on and after a
 * restore, means no callback. */
enum board_phase {
    PHASE_SCRIPTS, /* reading the input, and running the tasks */
    PHASE_MOTION,  /* moving all entities; those that leave the keep box are held, marked or removed */
    PHASE_HITS,    /* collision detection, which raises events */
    PHASE_EVENTS,  /* applying the effects of events, and running script event handlers */
    PHASE_CLEANUP, /* updating the palette, collecting Lua garbage */
    PHASES
};
typedef void board_phase_done(void *context, enum board_phase phase);

/* Work counters for benchmarks: entities moved, tested, hit and grazed in the last frame. Derived, never hashed. */
struct board_counts {
    uint64_t moved, tested, hit, grazed;
};

#endif

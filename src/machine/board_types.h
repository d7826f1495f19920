/*
 * board_types.h - what a host gives a board, and what a board hands out.
 */
#ifndef MACHINE_BOARD_TYPES_H
#define MACHINE_BOARD_TYPES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    MAX_PARTS = 64,       /* state hashes in a track: one a part; a set of parts is a uint64_t, 1 << part */
    NVRAM_MOST = 1 << 20, /* bytes of an image of score tables and saves (nvram.h); board.nvram says what fits */
    MAX_TEXT = 65536      /* bytes of a text in a script; a longer one is FAULT_MEMORY */
};

enum board_fault_kind {
    FAULT_NONE,
    FAULT_SCRIPT, /* an error no pcall may catch, or an uncaught one */
    FAULT_MEMORY, /* out of Lua RAM */
    FAULT_STACK,  /* call depth */
    FAULT_LOOP,   /* over 2 * 10^8 VM instructions, or work in C worth as many, in one tick */
};

struct board_fault {
    enum board_fault_kind kind;
    char message[512]; /* "stages/one.lua:42: what" */
    char trace[2048];  /* Lua traceback, lines separated by \n */
};

/* A practice start: one section of the game, again and again, as @std/boot plays it. Zero: the game from its title.
 * With PRACTICE_LIST as its section nothing is played: from the first tick on the board tells every section there is,
 * as markers, and then MARKER_LISTED. The other fields need a section. */
enum { PRACTICE_REGISTERS = 16, PRACTICE_LIVES = 99 };
#define PRACTICE_LIST "?"
struct practice {
    char section[64]; /* "", "one", "one:mark", "queen/bloom", PRACTICE_LIST */
    int32_t lives;    /* so many in all, 1 to PRACTICE_LIVES, as player.def counts them; 0: as the ship's kind says */
    bool invincible;  /* nothing hits a player; bullets pass through, and grazes count */
    int32_t registers;
    struct {
        char name[32];
        int32_t value;
    } reg[PRACTICE_REGISTERS]; /* so many registers of the ship start with these values */
};

/* All that reaches a board besides ROM and pads; every field is in the demo header. Zero is a fine default but for
 * difficulty. */
struct board_start {
    uint64_t seed;
    int32_t dip[16];    /* a value for each DIP of the manifest, in its order */
    int32_t difficulty; /* index into the manifest's list; -1: the manifest's default */
    struct practice practice;
    char lang[16];        /* the language of texts, printable ASCII; "": none, as the game is written */
    const uint8_t *nvram; /* NULL: blank */
    size_t nvram_size;    /* at most NVRAM_MOST */
};

enum board_request { REQUEST_NONE, REQUEST_ATTRACT, REQUEST_QUIT, REQUEST_ASK };

/* Screens of the host that a script can ask for. */
enum board_ask { ASK_SETTINGS, ASK_REPLAYS, ASK_PRACTICE, ASK_KEYS, ASKS };

/* Markers by which a player finds their way in a run; and what PRACTICE_LIST tells. Telling one changes no RAM. */
enum board_marker_kind {
    MARKER_STAGE, /* a stage starts; its name */
    MARKER_MARK,  /* stage.mark; its name, of the stage */
    MARKER_WAVE,  /* stage.wave; the kind of its enemies */
    MARKER_BOSS,  /* a boss flies in; its name and title */
    MARKER_PHASE, /* one of its phases starts; the phase's id, of the boss, and its spell */
    MARKER_DEATH, /* a player dies; "1" or "2" */
    MARKER_CLEAR, /* a stage has come to its end; its name */
    MARKER_WON,   /* a phase was beaten; its id, of the boss */
    MARKER_LOST,  /* a phase is over and was not beaten; its id, of the boss */
    MARKER_START, /* a practice start's section begins, for the first time or anew */

    /* of PRACTICE_LIST, which tells stages, marks, bosses and phases too */
    MARKER_SHIP,     /* a ship; its kind, and its lives in all. The first is the one practice is played with */
    MARKER_REGISTER, /* a register of the first; name and value */
    MARKER_LISTED,   /* the list is complete */

    /* of a run again */
    MARKER_GAME, /* a game starts; the kind of the first player's ship, value: players */
    MARKER_OVER, /* it is over; "clear" (all stages), "over" (no lives) or "quit", value: stages that were cleared */
    MARKER_ROW,  /* a score is entered; the table's name, of the ship, value: the row in its table, 1 the best */
    MARKER_KINDS
};

/* Does a marker of that kind say something about a run? Else it is of PRACTICE_LIST. */
static inline bool board_marks_run(enum board_marker_kind kind)
{
    return kind < MARKER_SHIP || kind > MARKER_LISTED;
}

enum { BOARD_MARKERS = 16 /* of a tick; what is more is not told */ };
struct board_marker {
    enum board_marker_kind kind;
    int32_t value;
    char name[32], of[32], title[48]; /* printable ASCII, cut to fit; "": none */
};

/* A pool had no room, for the first time in this run. line: the log's, with "FILE:LINE: " of the script before it. */
enum { FULLS = 13 /* pools that can be full */, LOG_BYTES = 4096 };
struct board_full {
    const char *part; /* "bullets" */
    char line[256];
};

/* What a tick hands the cabinet; good until the next tick. Never hashed. */
struct board_out {
    enum board_request request;
    char attract[64];   /* the demo lump's name, with REQUEST_ATTRACT */
    enum board_ask ask; /* with REQUEST_ASK */
    const char *log;    /* what print wrote in this tick, cut after LOG_BYTES, and a line for each pool that was full;
                             lines end in \n */
    size_t log_size;
    struct board_marker marker[BOARD_MARKERS];
    int markers;
    struct board_full full[FULLS];
    int fulls;
    bool menu;                       /* a menu before a game stands: who has just come needs to know the keys */
    const struct board_fault *fault; /* NULL: none. With a fault the run is over. */
};

/* The phases of a tick, so that the host can measure them: the board cannot read a clock. `done` is called at the end
 * of each phase, in this order (while the game is frozen, without motion), with the host's settings put aside. It must
 * not touch the board. NULL, as after power-on and after a restore: nothing is called. */
enum board_phase {
    PHASE_SCRIPTS, /* input, and the tasks' turns */
    PHASE_MOTION,  /* everything moves; what leaves the keep box is dropped */
    PHASE_HITS,    /* collisions, and their events */
    PHASE_EVENTS,  /* the effects of the events, and the scripts' handlers */
    PHASE_REST,    /* palette, the Lua collector */
    PHASES
};
typedef void board_phase_done(void *context, enum board_phase phase);

/* Work counters for benches: what the last frame moved, tested, hit and grazed. Derived, never hashed. */
struct board_counts {
    uint64_t moved, tested, hit, grazed;
};

#endif

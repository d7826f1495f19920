/*
 * machine.h - the board's insides: every part, in the order of RAM and of the hash track.
 *
 * Three words:
 *   chip  a struct of columns with the code that works on them, most in src/entities. struct chip describes its
 *         columns (slots.h). A chip may be there twice: bullets and shots are both of struct bullets.
 *   slot  a numbered row of a chip: the i-th value of each column. A handle names a slot and its generation.
 *   part  what the board lists, hashes, saves and names: a chip. Two chips are registers alone, without slots:
 *         script and core, which is named "board".
 *         machine_parts[] is all of them, PART_LIST in parts.c their order.
 */
#ifndef MACHINE_H
#define MACHINE_H

#include "../base/rng.h"
#include "../entities/bg.h"
#include "../entities/bulletml.h"
#include "../entities/bullets.h"
#include "../entities/enemies.h"
#include "events.h"
#include "../entities/fix.h"
#include "input.h"
#include "../entities/items.h"
#include "../entities/lasers.h"
#include "../entities/lines.h"
#include "../entities/motion.h"
#include "nvram.h"
#include "../entities/options.h"
#include "video/pal.h"
#include "../entities/player.h"
#include "../entities/registers.h"
#include "video/screen.h"
#include "../entities/sparks.h"
#include "../entities/sprites.h"
#include "../sound/seq.h"
#include "../sound/voices.h"
#include "board_types.h"
#include "emit.h"
#include "handle.h"
#include "names.h"
#include "../rom/cart.h"
#include "task_table.h"
#include "video/view.h"
#include "vm_state.h"

/* The registers of the part that is named "board". */
struct core {
    struct slots s;
    uint32_t frame; /* ticks since power-on */
    uint32_t clock; /* ticks of game time: stands still while frozen */
    uint32_t difficulty;
    uint64_t random[4];      /* the game's stream */
    int64_t frozen;          /* scope whose tasks alone get turns, 0: none; below 0: a hit-stop, counted up */
    uint64_t notes;          /* what board.note folded in */
    uint32_t extended[PADS]; /* extends each player has had */
    uint32_t over;           /* 1: EV_GAME_OVER was raised */
    uint32_t since;          /* clock when the game began */
    uint8_t continues[PADS]; /* how often each player can go on after its last life */
    uint8_t continued[PADS]; /* how often it did */
    uint64_t drawn;          /* numbers taken from the stream since it began */
};

/* A running digest of what scripts do: it differs from the frame on in which the scripts of two runs act differently.
 */
struct script {
    struct slots s;
    uint64_t digest;
    uint64_t calls;
};

/* What a tick hands out; outside the snapshot. */
struct output {
    struct board_out out;
    struct board_fault fault;
    size_t log_size;
    char log[LOG_BYTES + FULLS * sizeof(((struct board_full *)0)->line)]; /* print's, and a line for each full pool */
    char shortage[VM_PLACE]; /* "FILE:LINE: " of the last allocation that failed */
    size_t long_text;        /* bytes of a text that was too long, 0: none */
    char dead_field[32];     /* the last property that was read of a thing that had despawned, and where */
    char dead_place[VM_PLACE];
    bool deep;                 /* that allocation was in many nested calls */
    const struct force *force; /* that force_run runs */
    const char *line;          /* that board_eval runs */
    struct values *values;     /* where board_eval_values puts its values */
    struct emissions emissions;
    board_phase_done *phase_done; /* set by board_on_phase; may be NULL */
    void *phase_context;
};

struct board {
    struct cart cart;
    struct board_start start;
    uint8_t *ram;
    size_t ram_size;
    bool reset;              /* board.reset was called this frame */
    struct box keep, area;   /* where things live; where players may go */
    struct sprite *pictures; /* of the ROM, by index */
    struct words words;      /* of the language that the start asks for */
    struct output *output;
    struct vm vm;
    const struct vm_calls *calls;
    struct name_list names[NAME_LISTS];
    struct option_plan **option_plans; /* by kind of ship, in the Lua heap; NULL: no ship has options */
    struct events events;
    struct ml_fresh ml_fresh;
    struct board_counts counts;

    /* parts, in the order of machine_parts[] */
    struct script script;
    struct core core;
    struct input input;
    struct tasks tasks;
    struct bullets bullets;
    struct bullet_kinds bullet_kinds;
    struct bullets shots;
    struct bullet_kinds shot_kinds;
    struct enemies enemies;
    struct enemy_kinds enemy_kinds;
    struct player player;
    struct player_kinds player_kinds;
    struct motions motions;
    struct steps steps;
    struct sprites sprites;
    struct fix fix; /* the text layer: a grid of characters */
    struct pal pal;
    struct nvram nvram;
    struct sparks sparks;
    struct spark_kinds spark_kinds;
    struct items items;
    struct item_kinds item_kinds;
    struct lines lines;
    struct bg bg;
    struct bg_lines bg_lines;
    struct bg_shades bg_shades;
    struct screen screen;
    struct lasers lasers;
    struct bullets laser_heads;
    struct laser_kinds laser_kinds;
    struct laser_points laser_points;
    struct registers registers;
    struct options options;
    struct option_kinds option_kinds;
    struct option_ways option_ways;
    struct seq music;
    struct cues cues;
    struct voices voices;
    struct ml_roots ml_roots;
    struct ml_runners ml_runners;
    struct ml_frames ml_frames;
    struct ml_params ml_params;
};

/* A part: its chip's description, and where the chip's struct stands. */
struct part {
    const struct chip *chip;
    size_t at, size; /* of the struct, in struct board */
};
enum {
    PARTS = 42,
    PARTS_ALWAYS = 20 /* those after the first so many have no hash where they have no room */
};
extern const struct part machine_parts[PARTS];

/* The slots and the groups of columns of each part. */
struct part_room {
    uint32_t slots[PARTS], groups[PARTS];
};
struct part_room parts_room(const struct manifest *m);

/* Where part i's struct stands. */
static inline void *part_of(const struct board *b, int i)
{
    return (uint8_t *)(uintptr_t)b + machine_parts[i].at;
}

/* The slots of the part of that name ("bullets"); NULL: there is none. */
const struct slots *part_named(const struct board *b, const char *name);

enum { MOTION_WORK = 8 /* the work of a motion step */ };

/* The pools that motion programs read. shots: with the enemies as targets; else with the players. */
struct motion_world board_world(const struct board *b, bool shots);
struct targets board_players(const struct board *b);

/* Moves everything. What leaves the field is held or marked, so that hit_run still tests it. */
void board_move(struct board *b);

/* A number of the game's stream below that; below 0: of all 64 bits. */
uint64_t board_chance(void *board, uint64_t below);

/* Adds work in C to that of the tick, which vm_charge counts too: a unit is at most about 10 ns. False: that is more
 * than a tick may do, and the caller raises board_too_much. For vm_call. */
static inline bool board_work(struct board *b, uint64_t work)
{
    b->vm.work += work;
    return b->vm.work <= b->vm.limit;
}

/* Raises a fault no pcall catches. For vm_call. */
void board_fault(struct board *b, enum board_fault_kind kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Raises the fault that a frame has too much to do. The text says what there is too much of, with counts, and what to
 * change. */
void board_too_much(struct board *b, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* What the picture of the board as it is will take to draw, as work; over the limit that is a fault. For vm_call. */
void board_charge_picture(struct board *b);

/* Raises an event, or the fault that there is no room for it. */
void board_event(struct board *b, enum event_kind kind, int64_t a, int64_t b2);

/* Tells the cabinet of a marker. */
void board_add_marker(struct board *b, enum board_marker_kind kind, const char *name, const char *of, const char *title,
                      int32_t value);

/* Was this board powered only to list what can be practised (PRACTICE_LIST)? */
bool board_lists(const struct board *b);

/* Which presses pad.take sees now: the game's, or those for the screen that freezes it. */
static inline enum press_side board_presses(const struct board *b)
{
    return b->core.frozen > 0 ? PRESS_PAUSE : PRESS_GAME;
}

/* The buttons of player p that scripts and ships do not see now (PAD_ bits). What freezes the board sees all. */
static inline unsigned board_withheld(const struct board *b, uint32_t p)
{
    return b->core.frozen ? 0 : player_withheld(&b->player, p);
}

/* sparks_burst, and board_full when there is no room. */
void board_sparks(struct board *b, const struct spark_burst *burst);

/* What an item is made from, and how it sets out. */
struct item_drop {
    fx x, y;
    ang dir;
    uint64_t spread; /* 2^32: all round */
    fx speed;
    uint16_t tag;
};

/* Makes n[k] items of each of `kinds` kinds, all of them laid out evenly, in this order; board_full when there is no
 * room. */
void board_drop(struct board *b, const struct item_drop *d, const uint16_t *kind, const uint16_t *n, int kinds);

/* An item at rest, in the place of something. */
void board_turn_into(struct board *b, uint16_t kind, fx x, fx y);

/* What each player attracts. */
void board_pulls(const struct board *b, struct item_pull pull[PADS]);

/* The row of register reg of player p's ship; its value; and a write, which stops at what it may be. */
static inline uint32_t board_register_row(const struct board *b, uint32_t p, uint32_t reg)
{
    return b->player_kinds.first[b->player.kind[p]] + reg;
}

static inline int32_t board_register(const struct board *b, uint32_t p, uint32_t reg)
{
    return registers_get(&b->registers, board_register_row(b, p, reg), p);
}

static inline void board_set_register(struct board *b, uint32_t p, uint32_t reg, int64_t v)
{
    registers_set(&b->registers, board_register_row(b, p, reg), p, v);
}

/* The same of the run's. */
static inline int32_t board_run_register(const struct board *b, uint32_t reg)
{
    return registers_get(&b->registers, b->registers.first + reg, 0);
}

static inline bool board_run_full(const struct board *b, uint32_t reg)
{
    return registers_full(&b->registers, b->registers.first + reg, 0);
}

static inline void board_set_run_register(struct board *b, uint32_t reg, int64_t v)
{
    registers_set(&b->registers, b->registers.first + reg, 0, v);
}

/* The spark that bullet i's kind leaves when the bullet is cleared. */
void board_vanish(struct board *b, uint32_t i);

/* To be called after a pool refused something; a run's first refusal is logged. */
void board_full(struct board *b, const struct slots *s);

/* Takes back what board_full reported in this frame: an endless loop filled the pools, and its fault says so. */
void board_full_forget(struct board *b);

/* Player i's score goes up, or down; it stops at 0 and at 999,999,999,999. Lives come at the manifest's extends. */
void board_score(struct board *b, uint32_t i, int64_t points);

/* The name of an index, the last of several; NULL: it has none. Good until the next tick. */
static inline const char *board_name(const struct board *b, enum name_kind kind, int index)
{
    const struct name_list *t = &b->names[kind];

    return index >= 0 && (uint32_t)index < t->n ? t->at[index] : NULL;
}

/* Folds v into the script digest. */
static inline void script_fold(struct board *b, uint64_t v)
{
    b->script.digest = (b->script.digest ^ v) * 0x9e3779b97f4a7c15u;
    b->script.digest ^= b->script.digest >> 29;
}

/* The handle of a live slot of that kind, or a dead one for NO_SLOT. */
int64_t board_handle(const struct board *b, enum handle_kind kind, int32_t slot);

/* Is what the handle names alive? A group (of all bullets with a tag) and a motion program always are. */
bool board_alive(const struct board *b, int64_t h);

/* Can it still be read? An enemy that died or left, and a bullet or shot that left and touched something on the way,
 * can until the frame's handlers have run. */
bool board_there(const struct board *b, int64_t h);

/* What sprite i follows, or 0. */
int64_t board_followed(const struct board *b, uint32_t i);

/* Whose it is: of a player's or an option's handle the player, 1 or 2; else, or if it is dead, 0. */
uint8_t board_player_of(const struct board *b, int64_t h);

/* Where a thing is; false: dead, or not a thing that is anywhere. */
bool board_where(const struct board *b, int64_t h, fx *x, fx *y);

/* Which palette of the ROM is loaded: the one most like the colours in RAM (pal_likeness); of equals main, then the
 * first by name. */
int board_palette(const struct board *b);

#endif

/*
 * machine.h - the internals of the board: every part, in the order of RAM and of a demo's hashes.
 *
 * Three terms:
 *   chip  a struct of columns with the code that works on them, mostly in src/entities. A struct chip describes the
 *         columns (slots.h). Several parts may have the same struct type: bullets and shots are both struct bullets.
 *   slot  a numbered row of a chip: the i-th value of each column. A handle names a slot and its generation.
 *   part  a chip as the board lists, hashes, saves and names it. Two parts have registers but no slots: script, and
 *         core, which is named "board". machine_parts[] lists all parts; PART_LIST in parts.c defines their order.
 */
#ifndef MACHINE_H
#define MACHINE_H

#include "../base/rng.h"
#include "../entities/bg.h"
#include "../entities/bulletml.h"
#include "../entities/camera.h"
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
#include "channel.h"
#include "emit.h"
#include "handle.h"
#include "names.h"
#include "../rom/cart.h"
#include "task_table.h"
#include "video/view.h"
#include "vm_state.h"

/* The registers of the part named "board". */
struct core {
    struct slots s;
    uint32_t frame; /* ticks since power-on */
    uint32_t clock; /* ticks of game time; stopped while frozen */
    uint32_t difficulty;
    uint64_t random[4];   /* state of the game's random number generator */
    int64_t frozen;       /* 0: no; above 0: handle of the only scope that runs; below 0: hit-stop, counts up */
    uint64_t note_digest; /* digest of the values passed to board.note */
    uint32_t extends_received[MAX_PLAYERS]; /* extends each player has received */
    uint32_t game_over;                     /* 1: EV_GAME_OVER has been raised */
    uint32_t game_start;                    /* value of `clock` when the game began */
    uint8_t continues_left[MAX_PLAYERS];    /* continues each player has left */
    uint8_t continues_used[MAX_PLAYERS];    /* continues each player has used */
    uint64_t drawn;                         /* numbers drawn from the generator since it was seeded */
};

/* A running digest of the actions of scripts. The digests of two runs differ from the first frame in which the scripts
 * act differently. */
struct script {
    struct slots s;
    uint64_t digest;
    uint64_t calls;
};

/* The output of a tick, not part of snapshots. */
struct output {
    struct board_out out;
    struct board_fault fault;
    size_t log_size;
    /* output of print, then a line per full pool */
    char log[LOG_BYTES + MAX_FULL_POOLS * sizeof(((struct board_full_pool *)0)->line)];
    char shortage_location[VM_LOCATION_SIZE]; /* "FILE:LINE: " of the last failed allocation */
    size_t too_long_size;                     /* size in bytes of a string that was too long, 0: none */
    char dead_field[32]; /* last property read from a despawned entity; dead_location: where it was read */
    char dead_location[VM_LOCATION_SIZE];
    bool in_deep_calls;        /* the last failed allocation happened in deeply nested calls */
    const struct force *force; /* event that force_run is forcing now */
    const char *eval_line;     /* the line that board_eval is running now */
    struct values *values;     /* output of board_eval_values */
    struct emissions emissions;
    board_phase_done *phase_done; /* set by board_set_phase_callback; may be NULL */
    void *phase_context;
};

struct board {
    struct cart cart;
    struct board_start start;
    uint8_t *ram;
    size_t ram_size;
    bool reset_requested;             /* board.reset was called in this frame */
    struct box keep_box, player_area; /* entities outside `keep_box` despawn; players stay inside `player_area` */
    struct sprite *sprite_images;     /* the ROM's sprite images, by index */
    struct words words;               /* text in the language of start.lang */
    struct output *output;
    struct vm vm;
    const struct vm_calls *calls;
    struct name_list names[NAME_LISTS];
    struct option_plan **option_plans; /* by ship kind, in the Lua heap; NULL: no ship has options */
    struct events events;
    void *hit_grid; /* hit_grid_size bytes, used within hit_run */
    struct ml_fired_list ml_fired;
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
    struct option_paths option_paths;
    struct seq music;
    struct cues cues;
    struct voices voices;
    struct ml_roots ml_roots;
    struct ml_runners ml_runners;
    struct ml_frames ml_frames;
    struct ml_params ml_params;
    struct channel channel;
    struct camera camera;
};

/* A part: its chip, and the location of the chip's struct in struct board. */
struct part {
    const struct chip *chip;
    size_t offset, size; /* offset and size, in bytes */
    bool grows;          /* a list that scripts add to: its columns are in the Lua heap (vm_reserve) */
};
enum {
    PART_COUNT = 44,
    FIRST_OPTIONAL_PART = 20 /* the first parts always have a hash; the others, only in games that use them */
};
extern const struct part machine_parts[PART_COUNT];

/* The number of slots and the column groups of each part. */
struct part_capacities {
    uint32_t slots[PART_COUNT], groups[PART_COUNT];
};
struct part_capacities parts_capacities(const struct manifest *m);

/* Returns the struct of part i. */
static inline void *part_of(const struct board *b, int i)
{
    return (uint8_t *)(uintptr_t)b + machine_parts[i].offset;
}

/* Returns the slots of the part with this name ("bullets"), or NULL if there is none. */
const struct slots *part_find(const struct board *b, const char *name);

enum { MOTION_WORK = 8 /* work per motion step */ };

/* Returns the targets of shots, the enemies, or of bullets, the players. */
static inline struct targets board_targets(const struct board *b, bool for_shots)
{
    if (for_shots)
        return (struct targets){ &b->enemies.s, b->enemies.x, b->enemies.y, NULL };
    return (struct targets){ &b->player.s, b->player.x, b->player.y, b->player.in_game };
}

/* Returns the state that motion programs read. */
struct motion_world board_motion_world(const struct board *b, bool for_shots);

/* Moves all entities. Entities that leave the field but may still touch something are held or marked, so that hit_run
 * tests them. */
void board_move_entities(struct board *b);

/* Returns the next number of the game's random number generator: a number in [0, below) or, if `below` is 0, any 64-bit
 * number. board: a struct board. */
uint64_t board_random(void *board, uint64_t below);

/* Adds work done in C to the tick's total, to which vm_charge also adds; a unit takes at most about 10 ns. Returns
 * false if the total exceeds the tick's limit; then the caller must call board_raise_overload. Call only inside
 * vm_call. */
static inline bool board_charge_work(struct board *b, uint64_t work)
{
    b->vm.work += work;
    return b->vm.work <= b->vm.limit;
}

/* Raises a fault that pcall does not catch. Call only inside vm_call. */
void board_raise_fault(struct board *b, enum board_fault_kind kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Raises FAULT_LOOP: too much work in one frame. The message says which work is excessive, with counts, and what to
 * change. */
#define board_raise_overload(b, ...) board_raise_fault(b, FAULT_LOOP, __VA_ARGS__)

/* Adds the work of drawing the board in its present state to the tick's total; raises a fault if the total would exceed
 * the limit. Call only inside vm_call. */
void board_charge_picture(struct board *b);

/* Raises an event with the operands a and b2 (events.h), or a fault if the event list is full. */
void board_raise_event(struct board *b, enum event_kind kind, int64_t a, int64_t b2);

/* Adds a marker to the tick's output, unless the output already has MAX_TICK_MARKERS markers. */
void board_add_marker(struct board *b, enum board_marker_kind kind, const char *name, const char *parent,
                      const char *title, int32_t value);

/* Tells the program what a button does on the page that is shown. Changes no RAM. */
void board_add_key_hint(struct board *b, int player, uint32_t button, const char *meaning);

/* Returns whether this board was started only to list the sections for practice (PRACTICE_LIST). */
bool board_is_listing(const struct board *b);

/* Returns whether this board may run through stages that never end: it lists sections, or searches the stage that has
 * the fight of a practice start "boss/phase". */
bool board_runs_through_stages(const struct board *b);

/* Returns which presses pad.take reads now: PRESS_GAME or, while a screen freezes the game, PRESS_PAUSE. */
static inline enum press_side board_press_side(const struct board *b)
{
    return b->core.frozen > 0 ? PRESS_PAUSE : PRESS_GAME;
}

/* Returns the buttons (PAD_ bits) of player p that are currently hidden from scripts and ships; none while the board is
 * frozen. */
static inline unsigned board_ignored_buttons(const struct board *b, uint32_t p)
{
    return b->core.frozen ? 0 : player_ignored_buttons(&b->player, p);
}

/* Calls sparks_burst, then board_report_full if the pool refused a spark. */
void board_burst_sparks(struct board *b, const struct spark_burst *burst);

/* Position and initial motion of dropped items. */
struct item_drop {
    fx x, y;
    ang dir;
    uint64_t spread; /* 2^32: a full circle */
    fx speed;
    uint16_t tag;
};

/* Spawns n[k] items of kind[k], for k from 0 to kinds - 1. The directions of all these items together are spread
 * evenly over d->spread. Calls board_report_full for each item that does not fit in the pool. */
void board_drop_items(struct board *b, const struct item_drop *d, const uint16_t *kind, const uint16_t *n, int kinds);

/* Spawns an item at rest at (x, y), in place of another entity. */
void board_replace_with_item(struct board *b, uint16_t kind, fx x, fx y);

/* Stores how each player attracts items. */
void board_get_pulls(const struct board *b, struct item_pull pull[MAX_PLAYERS]);

/* board_register_row returns the row of register `reg` of player p's ship, and board_get_register its value.
 * board_set_register sets the value, clamped to the register's range. */
static inline uint32_t board_register_row(const struct board *b, uint32_t p, uint32_t reg)
{
    return b->player_kinds.first_register[b->player.kind[p]] + reg;
}

static inline int32_t board_get_register(const struct board *b, uint32_t p, uint32_t reg)
{
    return registers_get(&b->registers, board_register_row(b, p, reg), p);
}

static inline void board_set_register(struct board *b, uint32_t p, uint32_t reg, int64_t v)
{
    registers_set(&b->registers, board_register_row(b, p, reg), p, v);
}

/* board_get_run_register returns the value of the run's register `reg`, board_run_register_is_full whether the value is
 * at its maximum. board_set_run_register sets the value, clamped to the register's range. */
static inline int32_t board_get_run_register(const struct board *b, uint32_t reg)
{
    return registers_get(&b->registers, b->registers.first_run_row + reg, 0);
}

static inline bool board_run_register_is_full(const struct board *b, uint32_t reg)
{
    return registers_is_full(&b->registers, b->registers.first_run_row + reg, 0);
}

static inline void board_set_run_register(struct board *b, uint32_t reg, int64_t v)
{
    registers_set(&b->registers, b->registers.first_run_row + reg, 0, v);
}

/* Spawns the spark, if any, that bullet i's kind leaves behind when a bullet is cleared. */
void board_spawn_vanish_spark(struct board *b, uint32_t i);

/* Logs that the pool s is full, once in a run: at its first refusal. Call after s refused an entity. */
void board_report_full(struct board *b, const struct slots *s);

/* Takes a slot of a pool. Returns NO_SLOT, and reports the pool, if it is full. */
int32_t board_take_slot(struct board *b, struct slots *s);

/* Withdraws this frame's reports by board_report_full. Used when an endless loop has filled the pools, so that only the
 * fault of the loop is reported. */
void board_withdraw_full_reports(struct board *b);

/* Adds points (may be negative) to player i's score, clamped to 0..999,999,999,999, and awards a life at each of the
 * manifest's extends. */
void board_add_score(struct board *b, uint32_t i, int64_t points);

/* Returns the name declared for this index (the last one, if there are several), or NULL. Valid until the next tick. */
static inline const char *board_name(const struct board *b, enum name_kind kind, int index)
{
    const struct name_list *t = &b->names[kind];

    return index >= 0 && (uint32_t)index < t->n ? t->name[index] : NULL;
}

/* Folds v into the script digest. */
static inline void script_update_digest(struct board *b, uint64_t v)
{
    b->script.digest = (b->script.digest ^ v) * 0x9e3779b97f4a7c15u;
    b->script.digest ^= b->script.digest >> 29;
}

/* Returns the handle of a live slot of this kind, or a dead handle for NO_SLOT. */
int64_t board_handle(const struct board *b, enum handle_kind kind, int32_t slot);

/* Returns whether the entity of handle h is alive. Groups and motion programs always are. */
bool board_is_alive(const struct board *b, int64_t h);

/* Returns whether the entity of handle h can still be read. That includes, until the frame's handlers have run,
 * enemies that died or left, and bullets, shots and items that left the field and are still held. */
bool board_is_readable(const struct board *b, int64_t h);

/* Returns the handle of the entity that sprite i follows, or 0. */
int64_t board_sprite_follow_target(const struct board *b, uint32_t i);

/* Returns the player number, 1 or 2, for a live player or option handle; otherwise 0. */
uint8_t board_player_of(const struct board *b, int64_t h);

/* Stores the position of the entity of handle h. Returns false if the entity cannot be read (board_is_readable) or has
 * no position. */
bool board_get_position(const struct board *b, int64_t h, fx *x, fx *y);

/* Returns the index of the ROM palette that is most similar to the colours in RAM (pal_likeness), which is taken to be
 * the loaded one. Ties go to the palette named main, then to the first by name. */
int board_loaded_palette(const struct board *b);

#endif

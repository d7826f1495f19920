/*
 * inspect.h - a board's state for the overlay and the console: hitboxes, gauges, tasks, and the entity under a point.
 *
 * Call these functions only between frames. None of them changes a byte of RAM, so they call no Lua function that
 * pushes a value. Strings are returned as pointers that are valid until the next tick or restore. Positions on the
 * screen are in Q15.16 px: where the window (window.h) shows them, without a shake.
 */
#ifndef BOARD_INSPECT_H
#define BOARD_INSPECT_H

#include "board.h"
#include "../entities/motion.h"
#include "../sound/voices.h"

enum inspect_kind { INSPECT_NOTHING, INSPECT_BULLET, INSPECT_SHOT, INSPECT_ENEMY, INSPECT_PLAYER, INSPECT_LASER };
enum inspect_shape { INSPECT_NO_SHAPE, INSPECT_CIRCLE, INSPECT_BOX, INSPECT_CAPSULE, INSPECT_CIRCLES };

/* The hitbox of an entity, as collision tests use it. */
struct inspect_body {
    enum inspect_kind kind;
    uint32_t slot;
    enum inspect_shape shape;
    int32_t x, y; /* centre, on the screen */
    int32_t a, b; /* circle: a is the radius; box: half the width and height */
    int32_t c;    /* capsule: all points within a of the bar from (x - b, y - c) to (x + b, y + c) */
    int32_t n;    /* circles: number of circles; a, b: half the width and height of a box around (x, y) that contains
                     them all */
    struct {
        int32_t x, y, r;
    } circle[SHAPE_MAX_CIRCLES];
    int32_t graze; /* player: radius of the graze ring; otherwise 0 */
    /* Drawn in the dim colour. Bullet or laser: no player can graze it now; enemy: dying, or harmless to touch; player:
     * invulnerable. */
    bool is_dimmed;
};

/* Calls `visit` for every body: enemies, shots, bullets, lasers, then players, each group in slot order. A laser has
 * one body per segment of its line. */
void inspect_bodies(const struct board *b, void (*visit)(void *context, const struct inspect_body *body),
                    void *context);

/* Sets *out to the body of a player (0 or 1) at the position where the ship is drawn, which includes a screen shake.
 * Returns false if no ship is drawn: the player is not in the game, or is hidden. */
bool inspect_ship(const struct board *b, int player, struct inspect_body *out);

/* The hitbox and the sprite of one kind of bullet, shot, enemy or player. */
struct inspect_kind_shape {
    const char *entity, *name; /* type of entity, "bullet"; name of the kind, "orb" */
    enum inspect_shape shape;  /* not INSPECT_NO_SHAPE */
    int32_t r, bar_x, bar_y;   /* circle: r is the radius; capsule: all points within r of the bar from (-bar_x, -bar_y)
                                 to (bar_x, bar_y), relative to the entity's position */
    int n;                     /* number of circles */
    struct {
        int32_t x, y, r;
    } circle[SHAPE_MAX_CIRCLES];
    int32_t x0, y0, x1, y1; /* bounding box of the hitbox, relative to the entity's position, unrotated */
    bool is_rotated;        /* the sprite rotates; a box hitbox does not rotate with it */
    const char *sprite;
    int scale; /* of the sprite as it is drawn with this hitbox, in eighths */
    int bank;
    const char *ramp; /* name of the kind's blend if that is a ramp blend; otherwise NULL */
};
void inspect_kinds(const struct board *b, void (*visit)(void *context, const struct inspect_kind_shape *kind),
                   void *context);

/* Returns whether a player's buttons currently steer the ship and fire its shots, as opposed to controlling a menu or a
 * dialogue. player: from 0. */
struct inspect_controls {
    bool can_steer, can_fire;
};
struct inspect_controls inspect_player_controls(const struct board *b, int player);

/* What the pause menu offers: nothing unless the game is listening, that is, a run of boot.run is in progress. */
struct inspect_pause {
    bool is_listening;         /* the game obeys CODE_RESTART and CODE_QUIT (pads.h) */
    bool in_play[MAX_PLAYERS]; /* the player's ship is in the game, or about to come back */
    int entry_count;
    const char *entries[PAUSE_ENTRIES]; /* labels of the game's own entries, UTF-8 */
};
struct inspect_pause inspect_pause(const struct board *b);

/* Calls `visit` with the code point of every character on the screen, in cells and in visible lines of text. The order
 * is unspecified, and code points may repeat. FIX_UNKNOWN (fix.h) stands for a character that its cell cannot store. */
void inspect_codes(const struct board *b, void (*visit)(void *context, uint32_t code), void *context);

/* The rectangle of the screen that shows the field or a part of it, and what it shows. */
struct inspect_area {
    int x, y, w, h;       /* px of the screen */
    int left, top, zoom;  /* the field's pixel in its top left corner; px of the screen per px of the field */
    int field_w, field_h; /* px of the field */
};
struct inspect_area inspect_field(const struct board *b);

/* Changes a position on the screen, Q15.16 px, to the position in the field that is shown there. */
void inspect_to_field(const struct board *b, int32_t *x, int32_t *y);

/* How full a part is, in slots. inspect_gauges describes all parts and returns their number. */
struct inspect_gauge {
    const char *name;
    uint32_t live, top, high, cap; /* top: upper bound of the live slots; high: slots ever used */
    uint32_t refused;
    bool is_fixed; /* the part has a fixed size or no slots, so is not worth a gauge */
};
int inspect_gauges(const struct board *b, struct inspect_gauge out[MAX_PARTS]);

/* Sets *used to the bytes of Lua memory in use and *size to the bytes available in total. */
void inspect_memory(const struct board *b, size_t *used, size_t *size);

/* Returns how many numbers the game has drawn from its random stream since power-on or the last board.reset. */
uint64_t inspect_random_draws(const struct board *b);

enum { INSPECT_LOCATION_SIZE = 80 };

enum inspect_owner {
    OWNER_BOARD,
    OWNER_BULLET,
    OWNER_SHOT,
    OWNER_ENEMY,
    OWNER_PLAYER,
    OWNER_SPRITE,
    OWNER_TASK,
    OWNER_LASER,
    OWNER_OPTION
};

struct inspect_task {
    uint32_t serial;
    uint32_t age;       /* frames of game time */
    int64_t wait;       /* frames until the task resumes; 1: it resumes in the next frame */
    bool waits_forever; /* `wait` is then meaningless */
    bool is_scope;      /* the task only owns other tasks */
    bool has_begun;     /* the task has run at least once */
    bool is_stopped;    /* will be closed instead of resumed: the task was stopped, or its owner is no longer alive */
    bool is_frozen;     /* the task does not run now, because the game is paused */
    enum inspect_owner owner;
    uint32_t owner_number; /* serial of an owner task; 1 or 2 for a player; slot of any other owner */
    char location
        [INSPECT_LOCATION_SIZE]; /* "stages/one.lua:42": the line where the task waits (vm_get_location); "": none */
};

/* Describes up to n live tasks in order of serial, skipping the first `first` (the oldest) of them. Returns the number
 * of live tasks. */
uint32_t inspect_tasks(const struct board *b, uint32_t first, struct inspect_task *out, uint32_t n);

/* Describes the live task whose serial is `serial`. Returns false if there is none. */
bool inspect_task(const struct board *b, uint32_t serial, struct inspect_task *out);

struct inspect_entity {
    struct inspect_body body;
    const char *name;          /* name of the entity's kind */
    const char *tag;           /* NULL: none */
    uint32_t age;              /* frames of game time; player: 0 */
    int32_t x, y;              /* on the field, Q15.16 px */
    int32_t speed;             /* Q15.16 px/frame; speed and dir: bullets, shots and lasers only */
    double dir;                /* degrees */
    bool has_motion;           /* a motion program drives the entity */
    const char *motion;        /* name of the motion program; NULL: unnamed */
    uint32_t program;          /* index of the motion program */
    uint32_t step, step_count; /* current step, from 1, and number of steps; step = steps + 1: past the last step */
    uint32_t frames_left;      /* frames left in the current step; 0: the step has not begun or takes no time */
    uint32_t owner_task;       /* serial of the task that fired or spawned it; 0: none */
    int player;                /* shot or laser: the player who owns it, 1 or 2; 0: none */
    int32_t hp,
        safe_left; /* hp: enemies only; safe_left: enemies and players, frames of invulnerability left, -1: forever */
    int32_t lives; /* players only */
};

/* Finds the entity whose hitbox contains the screen pixel (x, y) or is nearest to it, at most `radius` px away. Ties go
 * to the smallest hitbox, then to the hitbox with the nearest centre, then to the first in the order of inspect_bodies.
 * Returns false if no entity is near enough. */
bool inspect_entity_at(const struct board *b, int x, int y, int radius, struct inspect_entity *out);

/* State of voice i, 0 to VOICES - 1; music voices come first. On a board without sound no voice is busy. */
struct inspect_voice {
    bool is_music, is_busy;
    bool is_ending;              /* the note was released, or only the tail of the voice still sounds */
    const char *source;          /* name of the sound or music that the voice plays */
    const char *instrument_kind; /* kind of instrument: "fm" */
    int32_t pitch;               /* 65536ths of a semitone; semitone 69 is A at 440 Hz */
    int pan;                     /* -64 left to 64 right */
};
void inspect_voice(const struct board *b, int i, struct inspect_voice *out);

/* Returns the peak level, out of 32768, of this voice alone in the frame just ticked. tables: as for
 * board_mix_sound. */
int inspect_voice_peak(const struct board *b, int i, const void *tables);

/* The music's current position. name "": no music is playing. */
struct inspect_music {
    const char *name, *title;
    const char *mark, *next; /* last marker passed; music that starts after this has faded out; "": none */
    uint64_t bar;            /* current bar, from 0 */
    int beat, beats_per_bar; /* beat in the bar, from 0; beats per bar */
    uint32_t tempo;          /* hundredths of a quarter note per minute */
    int gain;                /* percent */
    bool is_paused;          /* stopped by the game's pause */
};
void inspect_music(const struct board *b, struct inspect_music *out);

#endif

/*
 * inspect.h - a board's state for the overlay and the console: hit shapes, gauges, tasks, and the thing under a point.
 *
 * Only between frames. Nothing here changes a byte of RAM: no Lua function that pushes anything is called. Texts that
 * are handed out as pointers are good until the next tick or restore. Places on the screen are Q15.16 px, the field's
 * corner added.
 */
#ifndef BOARD_INSPECT_H
#define BOARD_INSPECT_H

#include "board.h"
#include "../entities/motion.h"
#include "../sound/voices.h"

enum inspect_kind { INSPECT_NOTHING, INSPECT_BULLET, INSPECT_SHOT, INSPECT_ENEMY, INSPECT_PLAYER, INSPECT_LASER };
enum inspect_shape { INSPECT_NONE, INSPECT_CIRCLE, INSPECT_BOX, INSPECT_CAPSULE, INSPECT_CIRCLES };

/* A thing as the hit tests see it. */
struct inspect_body {
    enum inspect_kind kind;
    uint32_t slot;
    enum inspect_shape shape;
    int32_t x, y; /* its middle, on the screen */
    int32_t a, b; /* a circle: a is the radius; a box: half its width and height */
    int32_t c;    /* a capsule: all within a of a bar from (x - b, y - c) to (x + b, y + c) */
    int32_t n;    /* several circles; a, b: half the width and height of the box round (x, y) that they lie in */
    struct {
        int32_t x, y, r;
    } circle[SHAPE_PARTS];
    int32_t graze; /* radius of a player's graze ring; else 0 */
    bool spent;    /* a bullet or laser that no player can graze (any more), an enemy whose touch is harmless or that
                      is dying, a player that is safe */
};

/* Calls each for all bodies, in the order enemies, shots, bullets, lasers, players; each by slot. A laser has a body
 * for each piece of its line. */
void inspect_bodies(const struct board *b, void (*each)(void *context, const struct inspect_body *body), void *context);

/* The body of player `player` (0 or 1) where the picture shows the ship: a shake moves it. False: no ship is seen; it
 * is not in the game, or hidden. */
bool inspect_ship(const struct board *b, int player, struct inspect_body *out);

/* What a kind of bullets, shots, enemies or players touches with, and the picture that it shows. */
struct inspect_shape_of {
    const char *of, *name;    /* "bullet", "orb" */
    enum inspect_shape shape; /* not INSPECT_NONE */
    int32_t r, bar_x, bar_y;  /* a circle's radius; a capsule: all within r of a bar from its place by (-bar_x, -bar_y)
                                 to (bar_x, bar_y) */
    int n;                    /* circles */
    struct {
        int32_t x, y, r;
    } circle[SHAPE_PARTS];
    int32_t x0, y0, x1, y1; /* the box round it, from its place; as the picture is drawn, not turned */
    bool turns;             /* the picture turns; a box does not turn with it */
    const char *sprite;
    int bank;
    const char *ramp; /* the blend it is drawn with, if that is one of ramps; else NULL */
};
void inspect_kinds(const struct board *b, void (*each)(void *context, const struct inspect_shape_of *kind),
                   void *context);

/* Which of a player's buttons are its ship's: those that steer it, and those it fires with? Not those that a menu or a
 * talk has. player: from 0. */
struct inspect_ship_has {
    bool steers, fires;
};
struct inspect_ship_has inspect_plays(const struct board *b, int player);

/* The characters on the screen, in cells and lines of text that are not hidden: code points, several times or in any
 * order. FIX_OTHER (fix.h): one that a cell has no room for. */
void inspect_codes(const struct board *b, void (*each)(void *context, uint32_t code), void *context);

/* The field on the screen, px. */
struct inspect_area {
    int x, y, w, h;
};
struct inspect_area inspect_field(const struct board *b);

/* How full a part is. */
struct inspect_gauge {
    const char *name;
    uint32_t live, top, high, cap; /* top: every live slot is below; high: slots ever used */
    uint32_t refused;
    bool fixed; /* always full, or without slots: not worth a gauge */
};
int inspect_gauges(const struct board *b, struct inspect_gauge out[MAX_PARTS]);

/* Lua's memory, bytes. */
void inspect_memory(const struct board *b, size_t *used, size_t *size);

/* Numbers drawn from the game's random stream since it began: at power-on, or with board.reset. */
uint64_t inspect_drawn(const struct board *b);

enum { INSPECT_PLACE = 80 };

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
    uint32_t age; /* frames of game time */
    int64_t wait; /* frames until its turn, at least 1: the next frame */
    bool forever; /* it waits for ever */
    bool scope;   /* it only owns others */
    bool begun;   /* else its first turn is to come */
    bool stopped; /* to be closed at its turn: it was stopped, or its owner is gone */
    bool frozen;  /* gets no turns: the game is paused */
    enum inspect_owner owner;
    uint32_t owner_number;  /* of a task its serial, of a player 1 or 2, else its slot */
    char at[INSPECT_PLACE]; /* "stages/one.lua:42": the line it waits in, the nearest outside @std; "": none */
};

/* Tasks by serial, up to n of them from number `first` on (0: the oldest). Returns how many there are in all. */
uint32_t inspect_tasks(const struct board *b, uint32_t first, struct inspect_task *out, uint32_t n);

/* The live task with that serial; false: it is over. */
bool inspect_task(const struct board *b, uint32_t serial, struct inspect_task *out);

struct inspect_thing {
    struct inspect_body body;
    const char *name;     /* of its kind */
    const char *tag;      /* NULL: none */
    uint32_t age;         /* frames of game time; of a player 0 */
    int32_t x, y;         /* on the field, Q15.16 px */
    int32_t speed;        /* Q15.16 px/frame; of bullets, shots and lasers, as dir */
    double dir;           /* degrees */
    bool moves;           /* a motion program drives it */
    const char *motion;   /* its name; NULL: it has none */
    uint32_t program;     /* its number */
    uint32_t step, steps; /* the one it is in, from 1; steps + 1: past the last */
    uint32_t left;        /* frames this step takes on, 0: it has not begun or takes no time */
    uint32_t by;          /* serial of the task that fired or spawned it, 0: none */
    int player;           /* of a shot or laser: 1 or 2, 0: nobody's */
    int32_t hp, safe;     /* of an enemy; safe: frames it takes no damage, -1 for ever; of a player too */
    int32_t lives;        /* of a player */
};

/* The thing whose shape holds the screen pixel (x, y) or comes nearest to it, at most `within` px away; of several the
 * smallest, then the one whose middle is nearest, then the first in the order of inspect_bodies. False: none. */
bool inspect_at(const struct board *b, int x, int y, int within, struct inspect_thing *out);

/* A voice of VOICES, those of music first. Of a board without sound none is busy. */
struct inspect_voice {
    bool music, busy;
    bool ends;        /* let go, or only a tail */
    const char *of;   /* the piece or the sound */
    const char *wave; /* "fm" */
    int32_t pitch;    /* 65536ths of a semitone; 69 are the a of 440 Hz */
    int pan;          /* -64 left to 64 right */
};
void inspect_voice(const struct board *b, int i, struct inspect_voice *out);

/* The largest sample, of 32768, that this voice alone makes in the frame just ticked. tables: of board_sound. */
int inspect_voice_peak(const struct board *b, int i, const void *tables);

/* Where the music is. name "": none plays. */
struct inspect_music {
    const char *name, *title;
    const char *mark, *next; /* the last marker; what comes when this has faded; "": none */
    uint64_t bar;            /* from 0 on, as beat */
    int beat, beats;         /* of the bar */
    uint32_t tempo;          /* hundredths of a quarter note a minute */
    int gain;                /* percent */
    bool held;               /* by the game's pause */
};
void inspect_music(const struct board *b, struct inspect_music *out);

#endif

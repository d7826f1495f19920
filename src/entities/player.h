/*
 * player.h - the two players: ship, lives, score.
 */
#ifndef ENTITIES_PLAYER_H
#define ENTITIES_PLAYER_H

#include "../base/fx.h"
#include "../base/pads.h"
#include "motion.h"
#include "../base/slots.h"

enum { PLAYER_DIAGONAL_FACTOR = 46341 }; /* 1/sqrt(2) in Q15.16, so that ships fly equally fast in every direction */

enum {
    PLAYER_IN_GAME = 1 << 0, /* in the game */
    PLAYER_NO_FIRE = 1 << 1, /* the game ignores fire, bomb and special */
    PLAYER_NO_MOVE = 1 << 2, /* the game ignores movement and focus */

    PLAYER_MAX_REGISTERS = 16,        /* maximum number of registers of a kind, and of the run */
    PLAYER_RUN_REGISTER_OFFSET = 128, /* in column `full_register`: offset for registers of the run */
    MAX_LIVES = 99,
    PICTURE_ROW_RADIUS =
        -1, /* `radius` of a row that is not a kind but holds a picture of the kind declared after it */

    PLAYER_FOCUS = 1 << 0, /* moving slowly */
    PLAYER_FLIP = 1 << 1,  /* drawn mirrored left to right */
    PLAYER_HIDDEN = 1 << 2,
    PLAYER_PICTURE_LOCKED = 1 << 3, /* a script has chosen the picture; otherwise the movement does */
    PLAYER_PICTURE = 15 << 4,       /* picture number in units of PLAYER_PICTURE_ONE, like ENEMY_PICTURE */
    PLAYER_PICTURE_ONE = 1 << 4,
    PLAYER_MAX_PICTURES = 15,
    PLAYER_MAX_SCALE = 4,
    PICTURE_LEFT = 1, /* every kind that has pictures has these two */
    PICTURE_RIGHT = 2
};

/* Declared by player.def. */
struct player_kinds {
    struct slots s;
    uint16_t *sprite;
    fx *radius;       /* hit circle, px; or PICTURE_ROW_RADIUS */
    fx *graze_radius; /* graze circle, px */
    fx *speed, *focus_speed;
    int32_t *lives;
    uint32_t *safe_frames;      /* frames of invulnerability after a death, and after joining */
    uint16_t *first_register;   /* first row of its registers (registers.h) */
    uint8_t *n_registers;       /* number of its registers */
    uint16_t *deathbomb_frames; /* frames after a hit in which a bomb saves the player */
    uint8_t *bomb, *bomb_focus; /* bomb + 1, unfocused and focused, defined by the board; 0: none */
    fx *magnet_radius;          /* px: items within this distance are attracted; NULL, like the next three columns: the
                                 * game has no items */
    fx *collect_line;           /* y in px at or above which all items are attracted; FX_MIN: none */
    fx *pull_speed;             /* px/frame at which attracted items fly */
    uint8_t *full_register; /* register + 1, or PLAYER_RUN_REGISTER_OFFSET + a register of the run: at its maximum, all
                                 * items are attracted */
};

struct player {
    struct slots s;
    uint8_t *in_game; /* PLAYER_IN_GAME, PLAYER_NO_FIRE and PLAYER_NO_MOVE; 0: not in the game */
    uint32_t *gen;    /* incremented when the player leaves, to invalidate handles from earlier games; at most
                    * RETIRED_GENERATION */
    uint16_t *kind;
    fx *x, *y;
    fx *prev_x, *prev_y; /* before this frame's move; hit tests sweep from there */
    int32_t *lives;      /* lives left, not counting the one in play */
    uint32_t *safe_left; /* frames of invulnerability left */
    uint32_t *grazes;
    int64_t *score;
    uint8_t *flags;           /* PLAYER_ */
    uint16_t *deathbomb_left; /* frames left in which a bomb saves the player from a hit; 0: not hit */
    uint32_t *bomb_left;      /* frames left of the player's bomb */
    int64_t *bomb_scope;      /* the scope of that bomb, defined by the board */
    fx *push_x, *push_y;      /* px added to the next move */
    fx *speed_scale;          /* factor of the speed, 0 to PLAYER_MAX_SCALE */
    uint8_t *focus_forced;    /* enum player_focus */
    /* Serial of the task that set the column, which is reset when the task ends; 0: none. */
    uint32_t *scale_task, *focus_task;
};

enum player_focus { FOCUS_BY_BUTTON, FOCUS_OFF, FOCUS_ON };

extern const struct chip player_chip, player_kinds_chip;

/* Returns whether player i has been in 2^30 - 2 games. Such a player must not join again, because a handle from an
 * earlier game could then refer to the new player. */
bool player_is_retired(const struct player *p, uint32_t i);

/* Adds player i (0 or 1) to the game with a ship of this kind at (x, y), and with the lives and score of a new game. */
void player_join(struct player *p, const struct player_kinds *kinds, uint32_t i, uint16_t kind, fx x, fx y);
void player_leave(struct player *p, uint32_t i);

/* Returns the buttons the game ignores (PAD_ bits). */
unsigned player_ignored_buttons(const struct player *p, uint32_t i);

/* Moves a player to (x, y) without sweeping the path. */
void player_set_position(struct player *p, uint32_t i, fx x, fx y);

/* Moves a player by (dx, dy) without sweeping the path, inside area. */
void player_shift(struct player *p, uint32_t i, fx dx, fx dy, const struct box *area);

/* Adds (vx, vy) to a player's next move. */
void player_push(struct player *p, uint32_t i, fx vx, fx vy);

/* Set what columns of the same names describe; task: the serial of the task that sets it, 0: none. */
void player_scale_speed(struct player *p, uint32_t i, fx scale, uint32_t task);
void player_force_focus(struct player *p, uint32_t i, enum player_focus focus, uint32_t task);

/* Resets what the task that ends has set. */
void player_end_task(struct player *p, uint32_t task);

/* Returns the sprite that player i shows. */
uint16_t player_sprite(const struct player *p, const struct player_kinds *kinds, uint32_t i);

/* Counts down the invulnerability frames. Called at the start of a frame, so `safe = n` lasts n frames, including the
 * present one. */
void player_step_invulnerability(struct player *p);

/* Moves both players by their held buttons (PAD_ bits) and by what pushes them, inside area. A player that was hit does
 * not move. */
void player_move(struct player *p, const struct player_kinds *kinds, const uint16_t held[MAX_PLAYERS],
                 const struct box *area);

#endif

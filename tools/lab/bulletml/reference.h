/*
 * reference.h - a BulletML document run by libbulletml, as Debian has it: what Curtain's own is compared with.
 *
 * A world has its origin in the middle, x to the right and y down; directions are in degrees, 0 is up, clockwise; a
 * speed of 1 is 1 px a frame. It begins with the root, number 0, at (0, REFERENCE_ROOT_Y), direction 180, speed 0.
 *
 * A frame: each bullet that was there before it, oldest first, runs its document, if it has one, and then moves; one
 * that has vanished is gone without moving. A new bullet appears at its shooter's place before the shooter's move, and
 * neither runs nor moves in that frame. Who goes too far may be the caller's to say.
 *
 * A document can crash libbulletml, or keep it forever: run each in a process of its own (apart.h).
 */
#ifndef BULLETML_REFERENCE_H
#define BULLETML_REFERENCE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { REFERENCE_ROOT_Y = -100 };

/* Where $rand comes from: a number in [0, 1), of 32 bits or less, so that each side has exactly the same one. */
struct reference_random {
    double (*next)(void *context);
    void *context;
};

struct reference_setup {
    const char *file;
    double rank;
    struct reference_random random;
    bool loop;    /* a root that has come to its end starts anew */
    int32_t most; /* bullets alive; a further one is not made */
    double root_x, root_y;
    double box_x, box_y; /* beyond them a bullet leaves */
    bool plain;          /* sine and cosine of every bullet in each frame; else when direction or speed change */
};

struct reference_bullet {
    int32_t id; /* numbered by creation; a world's root is 0 */
    double x, y, dir, speed;
};

/* What a run was made of, so far. */
struct reference_counts {
    int64_t made, dropped;      /* bullets; those that had no room */
    int64_t draws, expressions; /* of $rand; numbers that were worked out */
    int64_t moved, ran;         /* bullets moved, one a frame; of these, with a document to run */
};

struct reference;

/* NULL and one sentence: the document cannot be read. */
struct reference *reference_open(const struct reference_setup *setup, char *err, size_t err_size);
void reference_close(struct reference *r);

/* One frame with the player there. False and one sentence: the document went wrong, or has asked for too much. */
bool reference_frame(struct reference *r, double player_x, double player_y, char *err, size_t err_size);

/* All that are alive, by number, the root with them; good until the next frame. */
int32_t reference_bullets(struct reference *r, const struct reference_bullet **out);

/* Takes a bullet away between two frames; nothing if it is gone. */
void reference_remove(struct reference *r, int32_t id);

void reference_count(const struct reference *r, struct reference_counts *out);

/* For taking times: another root of the same document, numbered as any bullet. Before the first frame. */
void reference_root(struct reference *r, double x, double y);

#ifdef __cplusplus
}
#endif

#endif

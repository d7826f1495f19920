/*
 * camera.h - which part of a field that is larger than its view is shown. Only drawing and sound use it: positions,
 * hits and scripts stay in field coordinates.
 */
#ifndef ENTITIES_CAMERA_H
#define ENTITIES_CAMERA_H

#include "../base/fx.h"
#include "../base/slots.h"

/* A list of one entry; empty if the view shows the whole field. */
struct camera {
    struct slots s;
    fx *x, *y;              /* px of the field: the view's top left corner */
    fx *follow;             /* share, 0 to 1, of the way to the players that the camera moves each frame */
    fx *left, *top, *w, *h; /* px of the field: the limits, which the view does not leave while it follows */
};

extern const struct chip camera_chip;

/* Places the view (view_w x view_h px) at the middle of the field's lower edge, with the field as its limits. */
void camera_reset(struct camera *c, int field_w, int field_h, int view_w, int view_h);

/* Store the position nearest to v at which the view is inside the limits. */
void camera_set_x(struct camera *c, fx v, int view_w);
void camera_set_y(struct camera *c, fx v, int view_h);

/* Moves the camera by its share of the way to the position at which (x, y) is the middle of the view, or to the nearest
 * position inside the limits. */
void camera_follow(struct camera *c, fx x, fx y, int view_w, int view_h);

#endif

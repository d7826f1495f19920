/*
 * api_camera.c - the Lua value camera: which part of a field that is larger than its view is shown.
 */
#include <stddef.h>
#include "api_parts.h"

enum { C_X, C_Y, C_W, C_H, C_FOLLOW, C_LIMITS };

static const struct api_param props[] = {
    COORDINATE("x", A_FX, REQ,
               "left edge of the view in the field; written, it is kept inside `limits`; can only be written while "
               "`follow` is 0",
               SETTER),
    COORDINATE("y", A_FX, REQ,
               "top edge of the view in the field; written, it is kept inside `limits`; can only be written while "
               "`follow` is 0",
               SETTER),
    REQUIRED("w", A_INT, "width of the view in px of the field"),
    REQUIRED("h", A_INT, "height of the view in px of the field"),
    PARAM("follow", A_FX, REQ, 0, 1, NULL, NULL,
          "share of the way to the middle of the players that the camera goes each frame; 1 at the start; 0: scripts "
          "move it",
          STORED(camera.follow), WRITABLE),
    OPTIONAL("limits", A_TABLE,
             "{ x = px, y = px, w = px, h = px }: part of the field that the view does not leave; nil for the whole "
             "field",
             SETTER),
};

enum { LIMITS_X, LIMITS_Y, LIMITS_W, LIMITS_H, LIMITS_COUNT };

static const struct api_param limits_params[LIMITS_COUNT] = {
    PARAM("x", A_FX, REQ, 0, 1024, "px", NULL, ""),
    PARAM("y", A_FX, REQ, 0, 1024, "px", NULL, ""),
    PARAM("w", A_FX, REQ, MIN_VIEW, 1024, "px", NULL, ""),
    PARAM("h", A_FX, REQ, MIN_VIEW, 1024, "px", NULL, ""),
};

static void get_camera(lua_State *L, struct board *b, uint32_t i, int p)
{
    const struct camera *c = &b->camera;
    const fx limits[LIMITS_COUNT] = { c->left[i], c->top[i], c->w[i], c->h[i] };

    switch (p) {
    case C_X:
    case C_Y:
        lua_pushnumber(L, fx_to_double(p == C_X ? c->x[i] : c->y[i]));
        break;
    case C_W:
        lua_pushinteger(L, b->cart.manifest.view_w);
        break;
    case C_H:
        lua_pushinteger(L, b->cart.manifest.view_h);
        break;
    default: /* C_LIMITS */
        lua_createtable(L, 0, LIMITS_COUNT);
        for (int k = 0; k < LIMITS_COUNT; k++) {
            lua_pushnumber(L, fx_to_double(limits[k]));
            lua_setfield(L, -2, limits_params[k].name);
        }
    }
}

static void set_limits(lua_State *L, struct board *b, const struct api_value *v)
{
    const struct manifest *m = &b->cart.manifest;
    struct camera *c = &b->camera;
    struct api_value f[LIMITS_COUNT] = { [LIMITS_W].f = fx_int(m->field_w), [LIMITS_H].f = fx_int(m->field_h) };

    if (v->given)
        api_read_fields(L, "camera: limits", NULL, &(struct api_fields){ limits_params, LIMITS_COUNT, NAME_LISTS },
                        v->at, f);
    if ((int64_t)f[LIMITS_X].f + f[LIMITS_W].f > fx_int(m->field_w) ||
        (int64_t)f[LIMITS_Y].f + f[LIMITS_H].f > fx_int(m->field_h) || f[LIMITS_W].f < fx_int(m->view_w) ||
        f[LIMITS_H].f < fx_int(m->view_h))
        api_error(L, "camera", "limits: expected a part of the %dx%d field that holds the %dx%d view", (int)m->field_w,
                  (int)m->field_h, (int)m->view_w, (int)m->view_h);
    c->left[0] = f[LIMITS_X].f;
    c->top[0] = f[LIMITS_Y].f;
    c->w[0] = f[LIMITS_W].f;
    c->h[0] = f[LIMITS_H].f;
}

static void set_camera(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    if (p == C_LIMITS) {
        set_limits(L, b, v);
        return;
    }
    if (b->camera.follow[i])
        api_error(L, "camera", "%s: the camera follows the players; set camera.follow = 0 first", props[p].name);
    if (p == C_X)
        camera_set_x(&b->camera, v->f, b->cart.manifest.view_w);
    else
        camera_set_y(&b->camera, v->f, b->cart.manifest.view_h);
}

const struct api_thing api_camera_thing = { "camera", PARAMS(props), .get = get_camera, .set = set_camera };

/*
 * bulletml.c - the pools of the BulletML interpreter (bulletml.h).
 */
#include "bulletml.h"

static const struct column root_columns[] = {
    COLUMN(ml_roots, owner),
    COLUMN(ml_roots, follow),
    COLUMN(ml_roots, dx),
    COLUMN(ml_roots, dy),
    COLUMN(ml_roots, x),
    COLUMN(ml_roots, y),
    COLUMN(ml_roots, x_more),
    COLUMN(ml_roots, y_more),
    COLUMN(ml_roots, program),
    COLUMN(ml_roots, body),
    COLUMN(ml_roots, kind),
    COLUMN(ml_roots, tag),
    COLUMNS(ml_roots, kinds, ML_KINDS),
    COLUMN(ml_roots, bank),
    COLUMN(ml_roots, flags),
    COLUMN(ml_roots, runners),
    COLUMN(ml_roots, by),
    COLUMN(ml_roots, stream),
    COLUMN(ml_roots, given),
    COLUMN(ml_roots, rank),
    COLUMN(ml_roots, pace),
    COLUMN(ml_roots, turned),
};

static const struct column runner_columns[] = {
    COLUMN(ml_runners, bullet),
    COLUMN(ml_runners, serial),
    COLUMN(ml_runners, root),
    COLUMN(ml_runners, body),
    DERIVED_COLUMNS(ml_runners, order, 2, "lists the live runners by serial number"),
    COLUMN(ml_runners, at),
    COLUMN(ml_runners, wake),
    COLUMN(ml_runners, frame),
    COLUMN(ml_runners, given),
    COLUMN(ml_runners, depth),
    COLUMN(ml_runners, flags),
    COLUMN(ml_runners, last_direction),
    COLUMN(ml_runners, last_speed),
    COLUMN(ml_runners, direction),
    COLUMN(ml_runners, speed),
    COLUMN(ml_runners, vx),
    COLUMN(ml_runners, vy),
    COLUMNS(ml_runners, from, CHANGES),
    COLUMNS(ml_runners, to, CHANGES),
    COLUMNS(ml_runners, step, CHANGES),
    COLUMNS(ml_runners, begun, CHANGES),
    COLUMNS(ml_runners, over, CHANGES),
    DERIVED(ml_runners, cosine, "computed from written_dir"),
    DERIVED(ml_runners, sine, "computed from written_dir"),
    COLUMN(ml_runners, written_dir),
    COLUMN(ml_runners, written_speed),
    COLUMN(ml_runners, written_vx),
    COLUMN(ml_runners, written_vy),
    REGISTER(ml_runners, serials),
    DERIVED_REGISTER(ml_runners, n, "the number of live runners in `order`"),
    DERIVED_REGISTER(ml_runners, ran, "a counter for the work limit, rewritten in every frame before it is read"),
};

static const struct column frame_columns[] = {
    COLUMN(ml_frames, up),
    COLUMN(ml_frames, back),
    COLUMN(ml_frames, given),
    COLUMN(ml_frames, left),
};

static const struct column param_columns[] = {
    COLUMN(ml_params, users),
    COLUMN(ml_params, n),
    COLUMNS(ml_params, value, ML_VALUES),
};

#define COUNT(table) (int)(sizeof table / sizeof *table)
const struct chip ml_roots_chip = { "bulletml", root_columns, COUNT(root_columns), false, false };
const struct chip ml_runners_chip = { "ml_runners", runner_columns, COUNT(runner_columns), false, false };
const struct chip ml_frames_chip = { "ml_frames", frame_columns, COUNT(frame_columns), false, false };
const struct chip ml_params_chip = { "ml_params", param_columns, COUNT(param_columns), false, false };

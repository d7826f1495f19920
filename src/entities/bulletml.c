/*
 * bulletml.c - the pools of the BulletML interpreter (bulletml.h).
 */
#include "bulletml.h"

static const struct column root_columns[] = {
    COLUMN(ml_roots, owner),
    COLUMN(ml_roots, follow_target),
    COLUMN(ml_roots, dx),
    COLUMN(ml_roots, dy),
    COLUMN(ml_roots, x),
    COLUMN(ml_roots, y),
    COLUMN(ml_roots, x_low),
    COLUMN(ml_roots, y_low),
    COLUMN(ml_roots, program),
    COLUMN(ml_roots, body_runner),
    COLUMN(ml_roots, kind),
    COLUMN(ml_roots, tag),
    COLUMNS(ml_roots, label_kind, ML_MAX_KINDS),
    COLUMN(ml_roots, bank),
    COLUMN(ml_roots, flags),
    COLUMN(ml_roots, n_runners),
    COLUMN(ml_roots, owner_task),
    COLUMN(ml_roots, stream),
    COLUMN(ml_roots, params),
    COLUMN(ml_roots, rank),
    COLUMN(ml_roots, speed_scale),
    COLUMN(ml_roots, up_dir),
};

static const struct column runner_columns[] = {
    COLUMN(ml_runners, bullet),
    COLUMN(ml_runners, serial),
    COLUMN(ml_runners, root),
    COLUMN(ml_runners, body_runner),
    DERIVED_COLUMNS(ml_runners, order, 2, "lists the live runners by serial number"),
    COLUMN(ml_runners, pc),
    COLUMN(ml_runners, wake_clock),
    COLUMN(ml_runners, frame),
    COLUMN(ml_runners, params),
    COLUMN(ml_runners, depth),
    COLUMN(ml_runners, flags),
    COLUMN(ml_runners, last_direction),
    COLUMN(ml_runners, last_speed),
    COLUMN(ml_runners, direction),
    COLUMN(ml_runners, speed),
    COLUMN(ml_runners, vx),
    COLUMN(ml_runners, vy),
    COLUMNS(ml_runners, change_from, CHANGE_COUNT),
    COLUMNS(ml_runners, change_to, CHANGE_COUNT),
    COLUMNS(ml_runners, change_step, CHANGE_COUNT),
    COLUMNS(ml_runners, change_start, CHANGE_COUNT),
    COLUMNS(ml_runners, change_end, CHANGE_COUNT),
    DERIVED_COLUMN(ml_runners, cosine, "computed from written_dir"),
    DERIVED_COLUMN(ml_runners, sine, "computed from written_dir"),
    COLUMN(ml_runners, written_dir),
    COLUMN(ml_runners, written_speed),
    COLUMN(ml_runners, written_vx),
    COLUMN(ml_runners, written_vy),
    REGISTER(ml_runners, last_serial),
    DERIVED_REGISTER(ml_runners, n, "the number of live runners in `order`"),
    DERIVED_REGISTER(ml_runners, work_done, "a counter for the work limit, rewritten in every frame before it is read"),
};

static const struct column frame_columns[] = {
    COLUMN(ml_frames, parent),
    COLUMN(ml_frames, return_pc),
    COLUMN(ml_frames, params),
    COLUMN(ml_frames, rounds_left),
};

static const struct column param_columns[] = {
    COLUMN(ml_params, refs),
    COLUMN(ml_params, n),
    COLUMNS(ml_params, value, ML_MAX_VALUES),
};

const struct chip ml_roots_chip = { .name = "bulletml", CHIP_COLUMNS(root_columns) };
const struct chip ml_runners_chip = { .name = "ml_runners", CHIP_COLUMNS(runner_columns) };
const struct chip ml_frames_chip = { .name = "ml_frames", CHIP_COLUMNS(frame_columns) };
const struct chip ml_params_chip = { .name = "ml_params", CHIP_COLUMNS(param_columns) };

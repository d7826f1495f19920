/*
 * parts.c - the parts of the board, in order, with their capacities.
 */
#include "machine.h"

#include <string.h>

static const struct column core_columns[] = {
    REGISTER(core, frame),
    REGISTER(core, clock),
    REGISTER(core, difficulty),
    REGISTERS(core, random),
    REGISTER(core, frozen),
    REGISTER(core, note_digest),
    REGISTERS(core, extends_received),
    REGISTER(core, game_over),
    REGISTER(core, game_start),
    REGISTERS(core, continues_left),
    REGISTERS(core, continues_used),
    DERIVED_REGISTER(core, drawn, "the number of random values drawn since the seed"),
};
static const struct column script_columns[] = { REGISTER(script, digest), REGISTER(script, calls) };

static const struct chip core_chip = { .name = "board", CHIP_COLUMNS(core_columns), .is_list = true };
static const struct chip script_chip = { .name = "script", CHIP_COLUMNS(script_columns), .is_list = true };

enum { MAX_PLAYER_KINDS = 128, MAX_ITEM_KINDS = 256, MAX_OPTION_KINDS = 64 };

static uint32_t transform_group(const struct manifest *m)
{
    return m->has_transforms ? SLOTS_GROUP(GROUP_TRANSFORMS) : 0;
}

/* Returns the column groups of the first n values. */
static uint32_t value_groups(int32_t n)
{
    return SLOTS_GROUP(GROUP_VALUE + n) - SLOTS_GROUP(GROUP_VALUE);
}

/* These functions return the column groups that manifest m requires in each pool. */
static uint32_t bullet_groups(const struct manifest *m)
{
    return value_groups(m->bullet_values) | (m->has_hp ? SLOTS_GROUP(GROUP_HP) : 0) |
           (m->has_orbit ? SLOTS_GROUP(GROUP_ORBIT) : 0) | (m->has_freeze ? SLOTS_GROUP(GROUP_FROZEN) : 0) |
           (m->bullets_can_meet ? SLOTS_GROUP(GROUP_MEET) : 0) | transform_group(m);
}

static uint32_t shot_groups(const struct manifest *m)
{
    return value_groups(m->shot_values) | (m->has_orbit ? SLOTS_GROUP(GROUP_ORBIT) : 0) |
           (m->has_freeze ? SLOTS_GROUP(GROUP_FROZEN) : 0) | (m->has_pierce ? SLOTS_GROUP(GROUP_PIERCE) : 0) |
           transform_group(m);
}

static uint32_t enemy_groups(const struct manifest *m)
{
    return value_groups(m->enemy_values) | (m->has_freeze ? SLOTS_GROUP(GROUP_FROZEN) : 0) |
           (m->has_bodies ? SLOTS_GROUP(GROUP_BODIES) : 0) | transform_group(m);
}

static uint32_t laser_groups(const struct manifest *m)
{
    return (m->has_orbit ? SLOTS_GROUP(GROUP_ORBIT) : 0) | (m->has_freeze ? SLOTS_GROUP(GROUP_FROZEN) : 0);
}

/* The parts, in the order of struct board, RAM, hashes and demos. Each line gives the chip, the member of struct board,
 * the number of slots and the column groups, computed from the manifest `m`. GROWS: a list that grows up to that
 * number. */
#define PART_LIST(PART, GROWS, m)                                                                                      \
    PART(script_chip, script, 0, 0)                                                                                    \
    PART(core_chip, core, 0, 0)                                                                                        \
    PART(input_chip, input, MAX_PLAYERS, 0)                                                                            \
    PART(tasks_chip, tasks, m->tasks, 0)                                                                               \
    PART(bullets_chip, bullets, m->bullets, bullet_groups(m))                                                          \
    GROWS(bullet_kinds_chip, bullet_kinds, m->bullets ? MAX_KINDS : 0, bullet_groups(m))                               \
    PART(shots_chip, shots, m->shots, shot_groups(m))                                                                  \
    GROWS(shot_kinds_chip, shot_kinds, m->shots ? MAX_KINDS : 0, shot_groups(m))                                       \
    PART(enemies_chip, enemies, m->enemies, enemy_groups(m))                                                           \
    GROWS(enemy_kinds_chip, enemy_kinds, m->enemies ? MAX_KINDS : 0, enemy_groups(m))                                  \
    PART(player_chip, player, MAX_PLAYERS, 0)                                                                          \
    GROWS(player_kinds_chip, player_kinds, MAX_PLAYER_KINDS, m->items ? SLOTS_GROUP(GROUP_ITEMS) : 0)                  \
    GROWS(motions_chip, motions, m->motions, 0)                                                                        \
    GROWS(steps_chip, steps, MOTION_STEPS_PER_PROGRAM * m->motions, 0)                                                 \
    PART(sprites_chip, sprites, m->sprites, transform_group(m))                                                        \
    PART(fix_chip, fix, m->screen_w / FIX_CELL_SIZE * (m->screen_h / FIX_CELL_SIZE),                                   \
         m->has_wide_text ? SLOTS_GROUP(FIX_GROUP_WIDE) : 0)                                                           \
    PART(pal_chip, pal, COLOURS, 0)                                                                                    \
    PART(nvram_chip, nvram, m->nvram_kib * 1024, 0)                                                                    \
    PART(sparks_chip, sparks, m->sparks, 0)                                                                            \
    GROWS(spark_kinds_chip, spark_kinds, m->sparks ? MAX_KINDS : 0, 0)                                                 \
    PART(items_chip, items, m->items, m->has_freeze ? SLOTS_GROUP(GROUP_FROZEN) : 0)                                   \
    GROWS(item_kinds_chip, item_kinds, m->items ? MAX_ITEM_KINDS : 0, 0)                                               \
    PART(lines_chip, lines, m->lines, 0)                                                                               \
    PART(bg_chip, bg, m->has_backgrounds ? BG_SLOTS : 0, m->view_w ? SLOTS_GROUP(BG_GROUP_CAMERA) : 0)                 \
    PART(bg_lines_chip, bg_lines, m->has_backgrounds ? BG_LAYERS * m->field_h : 0, 0)                                  \
    PART(bg_shades_chip, bg_shades, m->has_backgrounds ? BG_TABLES_SIZE : 0, 0)                                        \
    PART(screen_chip, screen, 0, 0)                                                                                    \
    PART(lasers_chip, lasers, m->lasers, 0)                                                                            \
    PART(laser_heads_chip, laser_heads, m->lasers, laser_groups(m))                                                    \
    GROWS(laser_kinds_chip, laser_kinds, m->lasers ? MAX_LASER_KINDS : 0, 0)                                           \
    PART(laser_points_chip, laser_points,                                                                              \
         m->lasers ? (m->curve_points + LASER_CHUNK_POINTS - 1) / LASER_CHUNK_POINTS : 0, 0)                           \
    PART(registers_chip, registers, m->registers, 0)                                                                   \
    PART(options_chip, options, m->options, transform_group(m))                                                        \
    GROWS(option_kinds_chip, option_kinds, m->options ? MAX_OPTION_KINDS : 0, 0)                                       \
    PART(option_paths_chip, option_paths, m->options ? MAX_PLAYERS : 0, 0)                                             \
    PART(seq_chip, music, m->has_sound ? SEQ_SLOTS : 0, 0)                                                             \
    PART(cues_chip, cues, m->has_sound ? CUE_SLOTS : 0, 0)                                                             \
    PART(voices_chip, voices, m->has_sound ? VOICE_CAPACITY : 0, 0)                                                    \
    PART(ml_roots_chip, ml_roots, int_min(m->bulletml_runners, ML_MAX_ROOTS), 0)                                       \
    PART(ml_runners_chip, ml_runners, m->bulletml_runners, 0)                                                          \
    PART(ml_frames_chip, ml_frames, ML_FRAMES_PER_RUNNER * m->bulletml_runners, 0)                                     \
    PART(ml_params_chip, ml_params, m->bulletml_runners, 0)                                                            \
    PART(channel_chip, channel, 0, 0)                                                                                  \
    PART(camera_chip, camera, m->view_w ? 1 : 0, 0)

#define AS_PART(chip, name, slots, groups) { &chip, offsetof(struct board, name), sizeof((struct board *)0)->name, 0 },
#define AS_GROWING(chip, name, slots, groups)                                                                          \
    { &chip, offsetof(struct board, name), sizeof((struct board *)0)->name, 1 },
#define AS_CAPACITY(chip, name, slots, groups) (uint32_t)(slots),
#define AS_GROUPS(chip, name, slots, groups)   (uint32_t)(groups),
#define AS_ONE(chip, name, slots, groups)      +1

const struct part machine_parts[PART_COUNT] = { PART_LIST(AS_PART, AS_GROWING, ) };
_Static_assert(PART_LIST(AS_ONE, AS_ONE, ) == PART_COUNT, "PART_LIST must have PART_COUNT lines");

struct part_capacities parts_capacities(const struct manifest *m)
{
    return (struct part_capacities){ { PART_LIST(AS_CAPACITY, AS_CAPACITY, m) },
                                     { PART_LIST(AS_GROUPS, AS_GROUPS, m) } };
}

const struct slots *part_find(const struct board *b, const char *name)
{
    for (int i = 0; i < PART_COUNT; i++)
        if (!strcmp(machine_parts[i].chip->name, name))
            return part_of(b, i);
    return NULL;
}

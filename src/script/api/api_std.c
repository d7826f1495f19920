/*
 * api_std.c - arguments and help of the entries written in Lua (scripts/), and the list of all modules.
 */
#include "api_parts.h"

#define BULLET_COUNT_PARAM       PARAM("n", A_INT, REQ, 0, 65535, "bullets", NULL, "number of bullets to fire")
#define REPEAT_COUNT_PARAM(help) PARAM("n", A_COUNT, REQ, 0, 65535, "times", NULL, help)
#define EVERY_PARAM(help)        PARAM("every", A_INT, REQ, 0, 65535, "frames", NULL, help)
#define SPEED_TO_PARAM(help)     PARAM("speed_to", A_NUM, REQ, -MAX_SPEED, MAX_SPEED, "px/frame", NULL, help)
#define TURNS_PARAM                                                                                                    \
    PARAM("turns", A_BOOL, OPT, 0, 0, NULL, "false",                                                                   \
          "rotate the figure so that its right side faces the direction of flight")
/* Parameters of every pattern. */
#define PATTERN_PARAMS                                                                                                 \
    PARAM("skip", A_SPAN, OPT, -65535, 65535, NULL, NULL, "range of bullets to skip; the first bullet is number 1"),   \
        PARAM("fire", A_FIRE, OPT, 0, 0, NULL, "bullet", "what to fire"),                                              \
        PARAM("each", A_FUNC, OPT, 0, 0, NULL, NULL,                                                                   \
              "each(args, i): called instead of firing bullet i, with the bullet's arguments")
#define NAME_PARAM(help)  PARAM("name", A_STR, REQ, 1, 31, NULL, NULL, help)
#define NEEDS_PARAM(help) PARAM("needs", A_STR, OPT, 1, 31, NULL, NULL, help)
#define LIMIT_PARAM(help) PARAM("limit", A_COUNT, OPT, 0, INT32_MAX, "frames", NULL, help)

#define MIRROR_PARAM PARAM("mirror", A_BOOL, OPT, 0, 0, NULL, "false", "mirror the route left to right in the field")

static const struct api_param trail_params[] = {
    PARAM("kind", A_SPARK_KIND, REQ, 0, 0, NULL, NULL, "declared kind of the sparks"),
    PARAM("follow", A_THING, REQ, POSITION_HANDLE_KINDS, 0, NULL, NULL, "thing that leaves the sparks"),
    PARAM("every", A_INT, OPT, 1, 65535, "frames", "4", "frames from one spark to the next"),
    PARAM("over", A_COUNT, OPT, 1, INT32_MAX, "frames", "forever",
          "frames the trail lasts; it ends sooner if the thing despawns"),
    PARAM("dx", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", "0", "horizontal distance from the thing"),
    PARAM("dy", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", "0", "vertical distance from the thing"),
};
static const struct api_param wait_until_params[] = {
    PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, "f(): called immediately, then once per frame until it returns true"),
    LIMIT_PARAM("maximum number of frames to wait; no limit if omitted")
};
static const struct api_param ring_params[] = { BULLET_COUNT_PARAM, PATTERN_PARAMS };
static const struct api_param fan_params[] = { BULLET_COUNT_PARAM,
                                               PARAM("spread", A_NUM, REQ, -32767, 32767, "degrees", NULL,
                                                     "angle between the first and the last bullet"),
                                               PATTERN_PARAMS };
static const struct api_param arc_params[] = { BULLET_COUNT_PARAM,
                                               PARAM("sweep", A_NUM, REQ, -32767, 32767, "degrees", NULL,
                                                     "angle from the first to the last bullet, clockwise"),
                                               PATTERN_PARAMS };
static const struct api_param stack_params[] = { BULLET_COUNT_PARAM,
                                                 SPEED_TO_PARAM("speed of the last bullet; the first flies at `speed`"),
                                                 PATTERN_PARAMS };
static const struct api_param line_params[] = { BULLET_COUNT_PARAM,
                                                PARAM("width", A_NUM, REQ, -WORLD_EDGE, WORLD_EDGE, "px", NULL,
                                                      "distance between the first and the last bullet"),
                                                PATTERN_PARAMS };
static const struct api_param polygon_params[] = { BULLET_COUNT_PARAM,
                                                   PARAM("sides", A_INT, REQ, 3, 65535, NULL, NULL,
                                                         "number of sides; `n` must be a multiple of this number"),
                                                   PATTERN_PARAMS };
static const struct api_param star_params[] = {
    BULLET_COUNT_PARAM,
    PARAM("points", A_INT, REQ, 2, 32767, NULL, NULL, "number of tips; `n` must be a multiple of twice this number"),
    PARAM("inner", A_NUM, OPT, 0, 1, NULL, "0.5", "speed of the inner corners, as a fraction of the tips' speed"),
    PATTERN_PARAMS
};
static const struct api_param ellipse_params[] = {
    BULLET_COUNT_PARAM, SPEED_TO_PARAM("speed of bullets that fly across the axis"),
    PARAM("tilt", A_NUM, OPT, -32767, 32767, "degrees", "0",
          "angle from `dir` to the axis along which bullets fly at `speed`"),
    PATTERN_PARAMS
};
static const struct api_param rose_params[] = {
    BULLET_COUNT_PARAM,
    PARAM("petals", A_INT, REQ, 1, 65535, NULL, NULL, "number of petals; the first points along `dir`"),
    SPEED_TO_PARAM("speed of the bullets between petals; the tips of the petals fly at `speed`"), PATTERN_PARAMS
};
static const struct api_param whip_params[] = {
    BULLET_COUNT_PARAM, SPEED_TO_PARAM("speed of the last bullet; the first flies at `speed`"),
    PARAM("bend", A_NUM, REQ, -32767, 32767, "degrees", NULL,
          "angle from the direction of the first bullet to the direction of the last"),
    PATTERN_PARAMS
};
static const struct api_param scatter_params[] = {
    BULLET_COUNT_PARAM,
    PARAM("spread", A_NUM, REQ, -32767, 32767, "degrees", NULL,
          "angle of the cone of random directions, centred on `dir`"),
    SPEED_TO_PARAM("other end of the range of random speeds, which starts at `speed`"), PATTERN_PARAMS
};
static const struct api_param pattern_points_params[] = {
    PARAM("list", A_TABLE, REQ, 0, 0, NULL, NULL,
          "list of points { x, y }, one for each bullet, in px relative to the position"),
    PARAM("scale", A_NUM, OPT, -WORLD_EDGE, WORLD_EDGE, NULL, "1", "factor for all coordinates in the list"),
    TURNS_PARAM, PATTERN_PARAMS
};
static const struct api_param picture_params[] = {
    PARAM("dots", A_STR, REQ, 1, 4096, NULL, NULL,
          "rows of characters, one per line; a dot or a space leaves a gap, and any other character is a bullet"),
    PARAM("gap", A_NUM, OPT, 0, WORLD_EDGE, "px", "8", "distance between neighbouring bullets"), TURNS_PARAM,
    PATTERN_PARAMS
};
static const struct api_param spiral_params[] = {
    REPEAT_COUNT_PARAM("number of volleys"),
    PARAM("step", A_NUM, REQ, -32767, 32767, "degrees", NULL, "angle added to `dir` after each volley"),
    EVERY_PARAM("frames from one volley to the next"),
    PARAM("arms", A_INT, OPT, 1, 65535, "bullets", "1", "bullets in a volley, evenly spaced around the circle"),
    PATTERN_PARAMS
};
static const struct api_param aimed_params[] = {
    REPEAT_COUNT_PARAM("number of bullets to fire"), EVERY_PARAM("frames from one bullet to the next"),
    PARAM("lock", A_BOOL, OPT, 0, 0, NULL, "false", "aim only once, for the first bullet, instead of for each bullet"),
    PATTERN_PARAMS
};
static const struct api_param path_def_params[] = { PARAM("list", A_TABLE, REQ, 0, 0, NULL, NULL,
                                                          "list of points and waits, from the start to the end") };
static const struct api_param path_point_params[] = {
    PARAM("x", A_NUM, OPT, -WORLD_EDGE, WORLD_EDGE, "px", NULL,
          "horizontal position in the field; every point needs `x` and `y`"),
    PARAM("y", A_NUM, OPT, -WORLD_EDGE, WORLD_EDGE, "px", NULL, "vertical position in the field"),
    PARAM("over", A_INT, OPT, 1, 65535, "frames", NULL,
          "frames to get to the point; required for every point after the first"),
    PARAM("ease", A_EASE, OPT, 0, 0, NULL, "linear", "easing of the movement to the point"),
    PARAM("wait", A_INT, OPT, 0, 65535, "frames", NULL,
          "frames to stay at the previous point; needs its own entry, which cannot be the first")
};
static const struct api_param path_run_params[] = {
    PARAM("e", A_THING, REQ, 1 << H_ENEMY, 0, NULL, NULL, "enemy to move"),
    PARAM("route", A_ROUTE, REQ, 0, 0, NULL, NULL, "result of path.def"), MIRROR_PARAM
};
static const struct api_param bg_def_params[] = {
    NAME_PARAM("name for bg.show and for bosses"),
    PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL,
          "f(): task that sets the background up; it stops when another background is shown")
};
static const struct api_param stage_def_params[] = {
    NAME_PARAM("name for boot.run and --stage"),
    PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, "f(): task of the stage; the stage ends when f returns"),
    NEEDS_PARAM("unlock that opens the stage; until then, boot.run skips the stage"),
    PARAM("music", A_TUNE, OPT, 0, 0, NULL, NULL, "piece of music that starts with the stage")
};
static const struct api_param stage_at_params[] = { PARAM(
    "n", A_INT, REQ, 0, INT32_MAX, "frames", NULL,
    "frame of the stage's clock; raises an error if the clock has passed it") };
static const struct api_param wave_params[] = {
    PARAM("n", A_INT, REQ, 0, 4096, "enemies", NULL, "number of enemies to spawn"),
    EVERY_PARAM("frames from one enemy to the next; 0 spawns all at once"),
    PARAM("kind", A_ENEMY_KIND, REQ, 0, 0, NULL, NULL, "declared kind to spawn"),
    PARAM("path", A_ROUTE, REQ, 0, 0, NULL, NULL,
          "route that each enemy follows; the enemy is removed at the end of the route"),
    MIRROR_PARAM,
    PARAM("dx", A_NUM, OPT, -WORLD_EDGE, WORLD_EDGE, "px", "0",
          "horizontal distance from each enemy's route to the next enemy's"),
    PARAM("dy", A_NUM, OPT, -WORLD_EDGE, WORLD_EDGE, "px", "0",
          "vertical distance from each enemy's route to the next enemy's"),
    PARAM("run", A_FUNC, OPT, 0, 0, NULL, NULL, "run(e): task of each enemy; overrides the kind's"),
    PARAM("stay", A_BOOL, OPT, 0, 0, NULL, "false", "keep the enemies when the boss phase that spawned them ends"),
    PARAM("hp", A_INT, OPT, 1, INT32_MAX, NULL, NULL, "hit points of each enemy; overrides the kind's"),
    PARAM("bank", A_INT, OPT, 0, 15, NULL, NULL,
          "number added to the palette bank of the sprite; overrides the kind's"),
    PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "name of a group to put the enemies in"),
    PARAM("on_death", A_FUNC, OPT, 0, 0, NULL, NULL,
          "on_death(e, p): called when an enemy dies, with the player who gets its score; p may be nil; overrides the "
          "kind's"),
    PARAM("drops", A_TABLE, OPT, 0, 0, NULL, NULL,
          "items that each enemy drops, { NAME = count }; overrides the kind's"),
    PARAM("formation", A_ANY, OPT, 0, 0, "v, line, column, circle, or a list of { x, y }", NULL,
          "arrangement of the enemies; a list gives each enemy's distance from the route"),
    PARAM("gap", A_NUM, OPT, 0, WORLD_EDGE, "px", "24", "distance between neighbouring enemies in a named formation")
};
static const struct api_param stage_clear_params[] = { LIMIT_PARAM(
    "maximum number of frames to wait; no limit if omitted") };
static const struct api_param stage_mark_params[] = { NAME_PARAM("name of the mark") };
static const struct api_param boss_def_params[] = {
    NAME_PARAM("name for boss.fight and --stage"),
    PARAM("title", A_STR, REQ, 0, 63, NULL, NULL, "name shown on the screen"),
    PARAM("kind", A_ENEMY_KIND, OPT, 0, 0, NULL, NULL,
          "declared kind of the boss's enemy; give `kind` with `x` and `y`, or give `cast`"),
    PARAM("x", A_NUM, OPT, -WORLD_EDGE, WORLD_EDGE, "px", NULL,
          "horizontal position where the boss fights and rests; needs `y`"),
    PARAM("y", A_NUM, OPT, -WORLD_EDGE, WORLD_EDGE, "px", NULL,
          "vertical position where the boss fights and rests; needs `x`"),
    PARAM("phases", A_TABLE, REQ, 0, 0, NULL, NULL, "list of phases, in order; an entry { talk = f } is a dialogue"),
    PARAM("cast", A_TABLE, OPT, 0, 0, NULL, NULL,
          "list of two or more enemies that fight together; use it instead of `kind`, `x` and `y`"),
    PARAM("portrait", A_SPRITE, OPT, 0, 0, NULL, NULL, "sprite that crosses the field when a spell starts"),
    PARAM("portrait_left", A_BOOL, OPT, 0, 0, NULL, "false", "bring the portrait in from the left, mirrored"),
    PARAM("warning", A_INT, OPT, 0, 65535, "frames", "0",
          "duration of the warning before the boss flies in; 0 shows no warning"),
    PARAM("epithet", A_STR, OPT, 1, 63, NULL, NULL, "line above the title in the warning"),
    PARAM("entrance", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark that the boss leaves behind as it flies in"),
    PARAM("bg", A_STR, OPT, 0, 0, NULL, NULL, "background, declared with bg.def, shown when the fight starts"),
    PARAM("music", A_TUNE, OPT, 0, 0, NULL, NULL, "piece of music during the fight")
};
static const struct api_param boss_cast_params[] = {
    NAME_PARAM("name used in the `hp` and `run` tables of a phase"),
    PARAM("title", A_STR, REQ, 0, 63, NULL, NULL, "name shown with the member's bar"),
    PARAM("kind", A_ENEMY_KIND, REQ, 0, 0, NULL, NULL, "declared kind of the member's enemy"),
    PARAM("x", A_NUM, REQ, -WORLD_EDGE, WORLD_EDGE, "px", NULL,
          "horizontal position where the member fights and rests"),
    PARAM("y", A_NUM, REQ, -WORLD_EDGE, WORLD_EDGE, "px", NULL, "vertical position where the member fights and rests"),
    PARAM("portrait", A_SPRITE, OPT, 0, 0, NULL, NULL,
          "portrait in the phases that the member leads; overrides the boss's"),
    PARAM("portrait_left", A_BOOL, OPT, 0, 0, NULL, NULL,
          "bring the member's portrait in from the left; overrides the boss's setting")
};
static const struct api_param boss_talk_params[] = { PARAM(
    "talk", A_FUNC, REQ, 0, 0, NULL, NULL,
    "talk(e): called with the boss, or with all of the cast; it can call `say` and `choose`") };
static const struct api_param boss_fight_params[] = { NAME_PARAM("name of the boss"),
                                                      PARAM("clock", A_BOOL, OPT, 0, 0, NULL, "false",
                                                            "keep the stage's clock running during the fight") };
static const struct api_param boss_history_params[] = {
    NAME_PARAM("name of the boss"), PARAM("id", A_STR, REQ, 1, 31, NULL, NULL, "id of the phase"),
    PARAM("difficulty", A_STR, OPT, 0, 0, NULL, NULL,
          "difficulty whose tries are counted; defaults to the current one"),
    PARAM("ship", A_PLAYER_KIND, OPT, 0, 0, NULL, NULL, "ship whose tries are counted; all ships if omitted")
};
static const struct api_param phase_params[] = {
    PARAM("id", A_STR, REQ, 1, 31, NULL, NULL, "permanent name, used by saves, practice and --stage NAME/ID"),
    PARAM("hp", A_ANY, OPT, 0, 0, "whole number, or { NAME = n }", NULL,
          "hit points; a table gives each member of the cast its own bar; optional with `survive`"),
    PARAM("time", A_INT, REQ, 1, INT32_MAX, "frames", NULL,
          "time limit; without `survive`, a phase that runs out of time isn't beaten"),
    PARAM("run", A_ANY, OPT, 0, 0, "function, or { NAME = function }", NULL,
          "run(e): task of the phase, called with the boss or the cast; a table gives each member its own task; "
          "required"),
    PARAM("spell", A_STR, OPT, 0, 127, NULL, NULL,
          "name of the spell card, shown on the screen; boss.history counts its tries and captures"),
    PARAM("bonus", A_INT, OPT, 0, INT32_MAX, "points", "0",
          "points for each player if the phase is captured: beaten without a death or a bomb"),
    PARAM("bonus_to", A_INT, OPT, 0, INT32_MAX, "points", NULL,
          "value that the bonus falls to by the end of `time`; if omitted, the bonus doesn't fall"),
    PARAM("survive", A_BOOL, OPT, 0, 0, NULL, "false",
          "make the boss invulnerable; the phase is beaten when time runs out"),
    PARAM("last", A_BOOL, OPT, 0, 0, NULL, "false",
          "play this phase only if all earlier phases were beaten; a hit on a player ends the phase but costs no life"),
    PARAM("safe", A_INT, OPT, 0, 65535, "frames", "0", "frames at the start during which the boss takes no damage"),
    PARAM("armour", A_INT, OPT, 0, 65535, "frames", "0",
          "frames after `safe` in which the boss takes less damage; needs `board = { bodies = true }`"),
    PARAM("rate", A_NUM, OPT, 0, 1, NULL, "0.25", "fraction of the damage that the boss takes during `armour`"),
    PARAM("down", A_BARS_DOWN, OPT, 0, 0, NULL, "all",
          "if each member has a bar, which bars must be empty to beat the phase: all of them, or any one"),
    PARAM("cut_in", A_BOOL, OPT, 0, 0, NULL, NULL,
          "show the portrait when the spell starts; defaults to true if there is both a portrait and a spell"),
    PARAM("portrait", A_SPRITE, OPT, 0, 0, NULL, NULL,
          "portrait in this phase; overrides the portraits of the leading member and of the boss"),
    PARAM("portrait_left", A_BOOL, OPT, 0, 0, NULL, NULL,
          "bring the portrait in from the left; overrides the settings of the leading member and of the boss"),
    PARAM("rest", A_INT, OPT, 0, 65535, "frames", "60",
          "frames the boss takes to fly back before the next phase; 0 skips the flight"),
    PARAM("clear", A_TABLE, OPT, 0, 0, NULL, NULL,
          "what each bullet leaves behind when the bullets are cleared at the end of the phase"),
    PARAM("drops", A_TABLE, OPT, 0, 0, NULL, NULL, "items dropped when the phase is beaten, { NAME = count }"),
    PARAM("bg", A_STR, OPT, 0, 0, NULL, NULL, "background, declared with bg.def, during the phase"),
    PARAM("music", A_TUNE, OPT, 0, 0, NULL, NULL, "piece of music during the phase")
};
static const struct api_param phase_clear_params[] = {
    PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL,
          "kind of item that replaces each bullet if the phase was beaten"),
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark that each bullet leaves")
};
static const struct api_param bg_show_params[] = {
    PARAM("name", A_STR, OPT, 0, 0, NULL, NULL, "background to show; nil shows none"),
    PARAM("over", A_INT, OPT, 0, 65535, "frames", "30",
          "length of the fade, which is black in the middle; 0 changes the background immediately")
};
static const struct api_param score_rule_params[] = {
    PARAM("on", A_STR, OPT, 1, 31, NULL, NULL,
          "event that earns the points: kill, graze, take, death or bomb; give `on` or `name`"),
    PARAM("name", A_STR, OPT, 1, 31, NULL, NULL, "name of a custom event that score.count reports"),
    PARAM("kind", A_STR, OPT, 1, 31, NULL, NULL,
          "count only events with this kind of enemy (kill), bullet (graze) or item (take)"),
    PARAM("points", A_ANY, OPT, 0, 0, "whole number, register or function", NULL,
          "points for the player, or a function f(p, thing) that returns them"),
    PARAM("times", A_ANY, OPT, 0, 0, "whole number, register or function", NULL,
          "factor for `points` or, without `points`, for the score of the enemy or item; can be a function f(p, thing) "
          "that returns the factor"),
    PARAM("gain", A_TABLE, OPT, 0, 0, NULL, NULL,
          "numbers to add to registers, { NAME = n }, before the points are counted"),
    PARAM("most", A_TABLE, OPT, 0, 0, NULL, NULL,
          "registers to raise, { NAME = OTHER }: NAME gets the value of OTHER if that is higher"),
    PARAM("set", A_TABLE, OPT, 0, 0, NULL, NULL,
          "values to set registers to, { NAME = n }, after the points are counted")
};
static const struct api_param score_count_params[] = {
    NAME_PARAM("name of the event in score.rule"),
    PARAM("n", A_INT, REQ, 0, INT32_MAX, NULL, NULL, "number of times the event happened"),
    PARAM("p", A_PLAYER, OPT, 0, 0, NULL, "1", "player who caused the event")
};
static const struct api_param tally_params[] = { PARAM("list", A_TABLE, REQ, 0, 0, NULL, NULL,
                                                       "list of lines, from top to bottom") };
static const struct api_param tally_line_params[] = {
    PARAM("label", A_STR, REQ, 1, 31, NULL, NULL, "word at the left of the line"),
    PARAM("value", A_ANY, REQ, 0, 0, "property, register or function", NULL,
          "what to count, or a function f(p) that returns a number, true (counts as 1) or false (hides the line)"),
    PARAM("points", A_INT, REQ, 0, 1e12, "points", NULL, "points for each unit counted"),
    PARAM("stage", A_BOOL, OPT, 0, 0, NULL, "false", "count only what was added in this stage"),
    PARAM("last", A_BOOL, OPT, 0, 0, NULL, "false", "show the line only after the last stage")
};
#define UNLOCK_NAME_PARAM(help)                                                                                        \
    PARAM("name", A_STR, REQ, 1, NV_MAX_KEY - 7, NULL, NULL /* saved as "unlock/NAME" */, help)
static const struct api_param unlock_def_params[] = {
    UNLOCK_NAME_PARAM("name for unlock.has and `needs`; saved as unlock/NAME"),
    PARAM("when", A_ANY, REQ, 0, 0, "conditions, or a function", NULL,
          "conditions that a run must meet, or a function when(run) that is called at the end of each run and returns "
          "true to earn the unlock"),
    PARAM("title", A_STR, OPT, 1, 63, NULL, NULL, "text shown once the unlock is earned; defaults to the name"),
    PARAM("hint", A_STR, OPT, 1, 127, NULL, NULL, "text shown until the unlock is earned")
};
static const struct api_param unlock_when_params[] = {
    PARAM("clear", A_ANY, OPT, 0, 0, "true, or a stage", NULL, "stage to clear; true for all stages"),
    PARAM("mode", A_STR, OPT, 1, 31, NULL, NULL, "mode of boot.run to play"),
    PARAM("difficulty", A_STR, OPT, 1, 31, NULL, NULL, "lowest difficulty to play"),
    PARAM("ship", A_STR, OPT, 1, 31, NULL, NULL, "ship to play"),
    PARAM("continues", A_INT, OPT, 0, INT32_MAX, NULL, NULL, "maximum number of continues used"),
    PARAM("score", A_INT, OPT, 1, 1e12, "points", NULL,
          "score to reach; with `ship`, it must be reached with that ship"),
    PARAM("spell", A_STR, OPT, 1, 63, NULL, NULL, "spell to capture, \"boss/id\", at the difficulty being played"),
    PARAM("heard", A_TUNE, OPT, 0, 0, NULL, NULL, "piece of music to hear during a game")
};
static const struct api_param unlock_has_params[] = { UNLOCK_NAME_PARAM("name given to unlock.def") };
#define MISSION_NAME_PARAM(help)                                                                                       \
    PARAM("name", A_STR, REQ, 1, NV_MAX_KEY - 8, NULL, NULL /* saved as "mission/NAME" */, help)
static const struct api_param mission_def_params[] = {
    MISSION_NAME_PARAM("name for mission.best; saved as mission/NAME"),
    PARAM("title", A_STR, REQ, 1, 63, NULL, NULL, "name shown in the list of missions"),
    PARAM("text", A_STR, OPT, 0, 127, NULL, NULL, "line that tells the player what to do"),
    PARAM("stage", A_STR, OPT, 1, 31, NULL, NULL, "stage that contains the part to play; give `stage` or `boss`"),
    PARAM("mark", A_STR, OPT, 1, 31, NULL, NULL,
          "name of the mark where the part starts; defaults to the start of the stage; needs `stage`"),
    PARAM("to", A_STR, OPT, 1, 31, NULL, NULL,
          "mark where the part ends; defaults to the end of the stage; needs `stage`"),
    PARAM("boss", A_STR, OPT, 1, 31, NULL, NULL, "boss to fight"),
    PARAM("phase", A_STR, OPT, 1, 31, NULL, NULL, "id of the only phase to fight; all phases if omitted; needs `boss`"),
    PARAM("ship", A_STR, OPT, 1, 31, NULL, NULL, "ship to play; if omitted, the player chooses"),
    PARAM("difficulty", A_STR, OPT, 1, 31, NULL, NULL, "difficulty to play; if omitted, the player chooses"),
    PARAM("lives", A_INT, OPT, 1, 99, NULL, "1", "lives to start with, including the one in play"),
    PARAM("registers", A_TABLE, OPT, 0, 0, NULL, NULL, "starting values of registers, { NAME = n }"),
    PARAM("goal", A_ANY, OPT, 0, 0, "{ NAME = n, .. }, or a function", NULL,
          "counts to reach (score, grazes, kills, frames, lives or a register), or a function goal(p) that returns "
          "true once the goal is reached"),
    PARAM("clear", A_BOOL, OPT, 0, 0, NULL, "false",
          "require playing to the end and, with `boss`, winning the fight; `goal` is then optional"),
    PARAM("limit", A_INT, OPT, 1, INT32_MAX, "frames", NULL, "time limit; no limit if omitted"),
    PARAM("bombs", A_INT, OPT, 0, 99, NULL, NULL, "number of bombs allowed; no limit if omitted"),
    PARAM("by", A_STR, OPT, 1, 31, NULL, "time",
          "what the stars measure: time (less is better) or a count in `goal` (more is better)"),
    PARAM("medals", A_TABLE, OPT, 0, 0, NULL, NULL, "values of `by` that earn two and three stars, { a, b }"),
    NEEDS_PARAM("unlock that opens the mission")
};
static const struct api_param mission_best_params[] = { MISSION_NAME_PARAM("name given to mission.def") };
static const struct api_param boot_run_params[] = {
    PARAM("stages", A_TABLE, OPT, 0, 0, NULL, NULL, "names of the stages, in order; give `stages` or `modes`"),
    PARAM("players", A_TABLE, REQ, 0, 0, NULL, NULL, "list of player kinds to choose from"),
    PARAM("demo", A_STR, OPT, 1, 63, NULL, NULL,
          "demo (demos/NAME.demo) that the title screen shows after ten seconds"),
    PARAM("demos", A_TABLE, OPT, 0, 0, NULL, NULL, "list of demos to show in turn, instead of `demo`"),
    PARAM("modes", A_TABLE, OPT, 0, 0, NULL, NULL, "list of modes to choose from, instead of `stages`"),
    PARAM("difficulties", A_TABLE, OPT, 0, 0, NULL, NULL, "texts for the difficulties in rom.lua, { NAME = text }"),
    PARAM("ships", A_TABLE, OPT, 0, 0, NULL, NULL, "what the ship menu shows for each ship, by player kind"),
    PARAM("ending", A_ANY, OPT, 0, 0, "function, or a list of { when, show, music }", NULL,
          "ending(run): called after the last stage; in a list, the first ending whose `when` holds is shown"),
    PARAM("opening", A_FUNC, OPT, 0, 0, NULL, NULL,
          "opening(): shown before the title, and again when nobody starts a game; START ends it"),
    PARAM("staff", A_TABLE, OPT, 0, 0, NULL, NULL, "list of credits, shown after the ending"),
    PARAM("music", A_TABLE, OPT, 0, 0, NULL, NULL,
          "pieces of music by screen, { SCREEN = piece }; `room = true`, or a list of pieces, adds a music room"),
    PARAM("continues", A_INT, OPT, 1, 99, NULL, NULL, "continues for each player; none if omitted"),
    PARAM("pages", A_TABLE, OPT, 0, 0, NULL, NULL, "list of custom pages in the title menu"),
    PARAM("grades", A_FUNC, OPT, 0, 0, NULL, NULL,
          "grades(stage, p): returns the text to show in the stage results, such as S"),
    PARAM("screens", A_TABLE, OPT, 0, 0, NULL, NULL, "functions that replace the library's screens, by name")
};
static const struct api_param boot_music_params[] = {
    PARAM("name", A_TUNE, REQ, 0, 0, NULL, NULL, "piece to play"),
    PARAM("title", A_STR, OPT, 0, 63, NULL, NULL, "title in the list; defaults to the title in rom.lua"),
    PARAM("text", A_STR, OPT, 0, 127, NULL, NULL, "text below the list"), NEEDS_PARAM("unlock that opens the piece")
};
#ifndef WITHOUT_HELP /* scripts/boot/check.lua checks these arguments */
static const struct api_param boot_mode_params[] = {
    NAME_PARAM("name of the mode, which game.mode returns"),
    PARAM("stages", A_TABLE, REQ, 0, 0, NULL, NULL, "names of the stages, in order"),
    PARAM("text", A_STR, OPT, 0, 0, NULL, NULL, "text below the name in the list"),
    PARAM("needs", A_STR, OPT, 0, 0, NULL, NULL, "unlock that opens the mode")
};
#define BOOT_SHIP_PARAMS(of)                                                                                           \
    PARAM("title", A_STR, OPT, 0, 0, NULL, NULL, "name shown; defaults to " of),                                       \
        PARAM("text", A_STR, OPT, 0, 0, NULL, NULL, "description shown in the ship menu"),                             \
        PARAM("figures", A_TABLE, OPT, 0, 0, NULL, NULL,                                                               \
              "list of { word, n }, where n is 0 to 5 stars; defaults to speed, lives and registers")
static const struct api_param boot_ship_params[] = { BOOT_SHIP_PARAMS("the name of its kind"),
                                                     PARAM("forms", A_TABLE, OPT, 0, 0, NULL, NULL,
                                                           "list of forms to choose from after choosing the ship") };
static const struct api_param boot_form_params[] = { PARAM("kind", A_PLAYER_KIND, REQ, 0, 0, NULL, NULL,
                                                           "player kind that the form uses"),
                                                     BOOT_SHIP_PARAMS("the title of the ship") };
#define BOOT_WHEN_PARAM                                                                                                \
    PARAM("when", A_ANY, OPT, 0, 0, "conditions, or a function", NULL,                                                 \
          "conditions that the run must meet (mode, difficulty, ship, players or continues), or a function when(run) " \
          "that returns true if the run meets them")
static const struct api_param boot_ending_params[] = {
    BOOT_WHEN_PARAM,
    PARAM("show", A_FUNC, REQ, 0, 0, NULL, NULL, "show(run): shows the ending; return false to skip the credits"),
    PARAM("music", A_TUNE, OPT, 0, 0, NULL, NULL, "piece of music during the ending")
};
static const struct api_param boot_staff_params[] = { BOOT_WHEN_PARAM };
static const struct api_param boot_page_params[] = {
    PARAM("name", A_STR, REQ, 0, 0, NULL, NULL, "name in the title menu, and the heading of the page"),
    PARAM("show", A_FUNC, REQ, 0, 0, NULL, NULL, "show(row, rows): draws the page into `rows` rows, starting at `row`")
};
#define SCREEN_PARAM(name, help) PARAM(name, A_FUNC, OPT, 0, 0, NULL, NULL, help)
static const struct api_param boot_screens_params[] = {
    SCREEN_PARAM("title",
                 "title(limit, places, from): returns one of `places` and, for \"start\", the number of players; "
                 "nil if no button was pressed"),
    SCREEN_PARAM("mode",
                 "mode(modes): returns the name of one of `modes`, a list of { name, text, closed }; nil goes back"),
    SCREEN_PARAM("difficulty", "difficulty(names, present, texts): returns one of `names`; nil goes back"),
    SCREEN_PARAM("ship", "ship(kinds, players, about): returns a list with the kind of each player; nil goes back"),
    SCREEN_PARAM("pause", "pause(index, items, chosen): returns the number of an item; 1 resumes the game"),
    SCREEN_PARAM("continue",
                 "continue(index, left): returns true to continue; `left` is the number of remaining continues"),
    SCREEN_PARAM("results", "results(title, players, stopped, lines, new, grades): ends once stopped() is true"),
    SCREEN_PARAM("name", "name(entries): returns a list with a name for each entry { p, points, rank }"),
    SCREEN_PARAM("ending", "ending(run): shown when all stages are cleared, unless boot.run has `ending`"),
    SCREEN_PARAM("staff", "staff(parts): shows the credits of this run"),
    SCREEN_PARAM("scores", "scores(difficulty, limit, row, ship): returns true if START was pressed"),
    SCREEN_PARAM("history", "history(difficulty): shows how often spells were captured"),
    SCREEN_PARAM("music", "music(list): shows the music room"),
    SCREEN_PARAM("unlocks", "unlocks(): shows the titles of the unlocks earned, and hints for the others"),
    SCREEN_PARAM("missions", "missions(last): returns the name of a mission; nil goes back"),
    SCREEN_PARAM("mission", "mission(result): shows the result of a mission; returns \"again\" or \"list\""),
    SCREEN_PARAM("page", "page(page): shows one of `pages`, given as { name, show }"),
};
#endif
static const struct api_param game_def_params[] = { PARAM(
    "registers", A_TABLE, REQ, 0, 0, NULL, NULL,
    "registers of the run, { NAME = start or settings }, as in player.def") };
static const struct api_param talk_def_params[] = {
    PARAM("who", A_STR, REQ, 1, 31, NULL, NULL, "name of the speaker in `say`"),
    PARAM("name", A_STR, REQ, 0, 63, NULL, NULL, "name shown on the box"),
    PARAM("faces", A_TABLE, OPT, 0, 0, NULL, NULL,
          "sprites of the portrait, { FACE = name }, drawn facing right; no portrait if omitted"),
    PARAM("side", A_STR, OPT, 0, 0, NULL, "left", "side of the portrait, left or right"),
    PARAM("bank", A_INT, OPT, 0, 15, NULL, "0", "number added to the palette bank of the portrait"),
    PARAM("voice", A_SOUND, OPT, 0, 0, NULL, NULL, "sound played with the letters")
};
static const struct api_param talk_face_params[] = { PARAM("face", A_SPRITE, REQ, 0, 0, NULL, NULL,
                                                           "sprite of the portrait") };
static const struct api_param talk_run_params[] = {
    PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, "f(): calls `say` and `choose`"),
    PARAM("hold", A_STR, OPT, 0, 0, NULL, "fire",
          "what players can't do: fire (shoot or bomb), all (shoot, bomb or move) or none (no restriction)"),
    PARAM("clear", A_BOOL, OPT, 0, 0, NULL, "true", "remove all bullets and lasers at the start"),
    PARAM("skip", A_BOOL, OPT, 0, 0, NULL, "true", "let players skip the dialogue by holding the special button"),
    PARAM("clock", A_BOOL, OPT, 0, 0, NULL, "false", "keep the stage's clock running during the dialogue")
};
static const struct api_param say_params[] = {
    PARAM("who", A_STR, OPT, 0, 0, NULL, NULL, "speaker from talk.def; nil for no speaker"),
    PARAM("text", A_STR, REQ, 0, 4096, NULL, NULL, "text, shown in pages of three rows; \\n starts a new row"),
    PARAM("face", A_STR, OPT, 0, 0, NULL, NULL,
          "one of the speaker's faces; defaults to the face used last, or to `calm` if there was none"),
    PARAM("side", A_STR, OPT, 0, 0, NULL, NULL, "side of the portrait, left or right; overrides the speaker's"),
    PARAM("letter", A_INT, OPT, 0, 600, "frames", "2",
          "frames from one letter to the next; 0 shows all letters immediately"),
    LIMIT_PARAM("frames until a complete page turns automatically; if omitted, the page waits for the fire button"),
    PARAM("voice", A_SOUND, OPT, 0, 0, NULL, NULL, "sound for this line, played once; overrides the speaker's voice"),
};
static const struct api_param choose_params[] = {
    PARAM("list", A_TABLE, REQ, 0, 0, NULL, NULL, "list of texts to choose from"),
    PARAM("title", A_STR, OPT, 0, 0, NULL, NULL, "text above the list"),
    PARAM("chosen", A_INT, OPT, 1, 99, NULL, "1", "item selected at first; also the result if the talk is skipped"),
    PARAM("p", A_PLAYER, OPT, 0, 0, NULL, NULL, "player whose buttons count; both players if omitted"),
    LIMIT_PARAM("frames until the selected item is chosen automatically; no limit if omitted"),
    PARAM("back", A_INT, OPT, 1, 99, NULL, NULL,
          "result when the bomb button is pressed; if omitted, the bomb button does nothing")
};
static const struct api_param values_params[] = { PARAM(
    "values", A_TABLE, REQ, 0, 0, NULL, NULL,
    "values by difficulty, { NAME = value }, or a list that starts with the easiest") };

#define LUA_ENTRY(name, params, plain, flags, returns, help)                                                           \
    {                                                                                                                  \
        name, NULL, PARAMS(params), plain, API_LUA | (flags), returns, HELP(help)                                      \
    }
static const struct api_entry entries[] = {
    LUA_ENTRY("wait_until", wait_until_params, 2, API_GLOBAL, "boolean",
              "waits until f() returns true; returns false if `limit` runs out first"),
    { "wait_for", NULL, NULL, 0, 0, API_LUA | API_GLOBAL | API_VARARGS, NULL,
      HELP("waits until every given task has ended and every given thing is dead") },
    LUA_ENTRY(
        "by_difficulty", values_params, 1, API_GLOBAL, "value",
        "returns the value for the current difficulty; if there is none, the value for the nearest easier difficulty, "
        "or else the value for the easiest difficulty given"),
    LUA_ENTRY("pattern.ring", ring_params, 0, API_PATTERN, NULL,
              "fires `n` bullets in all directions, evenly spaced, the first bullet along `dir`"),
    LUA_ENTRY("pattern.fan", fan_params, 0, API_PATTERN, NULL, "fires `n` bullets in a fan, centred on `dir`"),
    LUA_ENTRY("pattern.arc", arc_params, 0, API_PATTERN, NULL, "fires `n` bullets over an arc that starts at `dir`"),
    LUA_ENTRY("pattern.stack", stack_params, 0, API_PATTERN, NULL,
              "fires `n` bullets in one direction, at speeds from `speed` to `speed_to`"),
    LUA_ENTRY("pattern.line", line_params, 0, API_PATTERN, NULL,
              "fires `n` bullets side by side, in a line across `dir`"),
    LUA_ENTRY("pattern.polygon", polygon_params, 0, API_PATTERN, NULL,
              "fires `n` bullets as a growing polygon; its corners fly at `speed`, the first corner along `dir`"),
    LUA_ENTRY("pattern.star", star_params, 0, API_PATTERN, NULL,
              "fires `n` bullets as a growing star; its tips fly at `speed`, the first tip along `dir`"),
    LUA_ENTRY(
        "pattern.ellipse", ellipse_params, 0, API_PATTERN, NULL,
        "fires `n` bullets as a growing ellipse, the first bullet along `dir`; bullets along its axis fly at `speed`"),
    LUA_ENTRY("pattern.rose", rose_params, 0, API_PATTERN, NULL,
              "fires `n` bullets in all directions as a growing flower; the tip of the first petal flies along `dir`"),
    LUA_ENTRY("pattern.whip", whip_params, 0, API_PATTERN, NULL,
              "fires `n` bullets as a bent stack: speed and direction change from the first bullet to the last"),
    LUA_ENTRY("pattern.scatter", scatter_params, 0, API_PATTERN, NULL,
              "fires `n` bullets in random directions at random speeds; draws two random numbers for each bullet"),
    LUA_ENTRY("pattern.points", pattern_points_params, 0, API_PATTERN, NULL,
              "fires a bullet from each point of a list; all bullets fly in the same direction"),
    LUA_ENTRY("pattern.picture", picture_params, 0, API_PATTERN, NULL,
              "fires a bullet for each character of a picture made of text, centred on the position"),
    LUA_ENTRY("pattern.spiral", spiral_params, 0, API_PATTERN, NULL,
              "fires one volley after another, each turned by `step`; the pattern takes time, so call it in a task"),
    LUA_ENTRY(
        "pattern.aimed", aimed_params, 0, API_PATTERN, NULL,
        "fires `n` bullets one after another at the nearest player, or shots at the nearest enemy; the pattern takes "
        "time, so call it in a task"),
    LUA_ENTRY("path.def", path_def_params, 1, API_LOAD_ONLY, "route",
              "creates a route for enemies and bullets from a list of points"),
    LUA_ENTRY("path.def point", path_point_params, 0, API_SYS, NULL,
              "one entry of the list: first { x, y }, then { x, y, over } or { wait }"),
    LUA_ENTRY("path.run", path_run_params, 3, 0, NULL,
              "moves an enemy along a route; returns when it arrives at the end"),
    LUA_ENTRY("spark.trail", trail_params, 0, 0, "task",
              "leaves a trail of sparks behind a thing, until the thing despawns or the task's owner ends"),
    LUA_ENTRY("stage.def", stage_def_params, 2, API_LOAD_ONLY, NULL,
              "declares a stage: one task that runs its waves and boss fights in order"),
    LUA_ENTRY("stage.at", stage_at_params, 1, 0, NULL,
              "waits for frame `n` of the stage's clock, which stops during boss.fight"),
    LUA_ENTRY("stage.wave", wave_params, 0, 0, NULL,
              "spawns `n` enemies that follow a route, one by one or in a formation, and returns immediately"),
    LUA_ENTRY("stage.clear", stage_clear_params, 1, 0, "boolean",
              "waits until all waves are spawned and no enemy is left; returns false if `limit` runs out first"),
    LUA_ENTRY("stage.mark", stage_mark_params, 1, 0, NULL,
              "marks a moment in the stage at which practice and --stage NAME:MARK can start"),
    { "stage.skipping", NULL, NULL, 0, 0, API_LUA, "boolean",
      HELP("returns true while the stage skips ahead to the mark where play starts") },
    LUA_ENTRY("boss.def", boss_def_params, 1, API_LOAD_ONLY, NULL,
              "declares a boss: one enemy, or a cast of several, that fights in phases"),
    LUA_ENTRY(
        "boss.def phase", phase_params, 0, API_SYS, NULL,
        "one phase of the fight; when `hp` or `time` runs out, the phase ends, and everything that its `run` spawned "
        "is removed"),
    LUA_ENTRY("boss.def cast", boss_cast_params, 0, API_SYS, NULL, "one member of the cast"),
    LUA_ENTRY("boss.def talk", boss_talk_params, 0, API_SYS, NULL,
              "a dialogue before or after a phase; the boss is safe during it"),
    LUA_ENTRY("boss.def clear", phase_clear_params, 0, API_SYS, NULL,
              "what each bullet leaves behind when the phase ends"),
    LUA_ENTRY("boss.fight", boss_fight_params, 1, 0, "boolean",
              "brings the boss in and fights all its phases; returns true if every phase was beaten"),
    { "boss.now", NULL, NULL, 0, 0, API_LUA, "boss, id, frames",
      HELP("returns the name of the boss, the id of its phase and the frames since the phase started; nil if there is "
           "no fight") },
    LUA_ENTRY("boss.history", boss_history_params, 2, 0, "tries, captures",
              "returns how often a spell has been tried and captured in all runs; practice doesn't count"),
    LUA_ENTRY(
        "bg.def", bg_def_params, 2, API_LOAD_ONLY, NULL,
        "declares a background: a task that sets up bg.layer and bg.plane; all layers and the plane are off when the "
        "task starts"),
    LUA_ENTRY("bg.show", bg_show_params, 1, 0, NULL,
              "fades through black to a background declared with bg.def, whose task starts in the middle of the fade"),
    LUA_ENTRY(
        "score.rule", score_rule_params, 0, API_LOAD_ONLY, NULL,
        "declares how many points an event earns and which registers it changes, for chains, multipliers and gauges"),
    LUA_ENTRY("score.count", score_count_params, 3, 0, NULL, "reports that a custom event happened `n` times"),
    LUA_ENTRY("score.tally", tally_params, 1, API_LOAD_ONLY, NULL,
              "declares the bonus lines in the results of a stage"),
    LUA_ENTRY("score.tally line", tally_line_params, 0, API_SYS, NULL, "one line of the results"),
    LUA_ENTRY("unlock.def", unlock_def_params, 1, API_LOAD_ONLY, NULL,
              "declares an unlock: a permanent reward for a run that meets its conditions"),
    LUA_ENTRY("unlock.def when", unlock_when_params, 0, API_SYS, NULL, "conditions, all of which must hold"),
    LUA_ENTRY("unlock.has", unlock_has_params, 1, 0, "boolean", "returns true if an unlock has been earned"),
    LUA_ENTRY("mission.def", mission_def_params, 1, API_LOAD_ONLY, NULL,
              "declares a mission: a part of a stage, or a boss fight, with a goal and up to three stars"),
    LUA_ENTRY("mission.best", mission_best_params, 1, 0, "value, stars, ship",
              "returns a mission's best result, its stars and its ship; nil and 0 if the mission was never completed"),
    { "mission.stars", NULL, NULL, 0, 0, API_LUA, "got, most",
      HELP("returns the number of stars earned in all missions, and the number that can be earned") },
    LUA_ENTRY("game.def", game_def_params, 0, API_LOAD_ONLY, NULL,
              "declares the registers of a run, such as rank; read and write them as game.NAME"),
    LUA_ENTRY("talk.def", talk_def_params, 1, API_LOAD_ONLY, NULL,
              "declares a speaker for `say`, with a name, a portrait and a voice"),
    LUA_ENTRY("talk.def face", talk_face_params, 1, API_SYS, NULL,
              "one face of the portrait; its key is the name of the face"),
    LUA_ENTRY(
        "talk.run", talk_run_params, 1, 0, NULL,
        "runs f(), whose calls to `say` and `choose` share one box; while f runs, the stage's clock is stopped and "
        "players can't fire"),
    LUA_ENTRY(
        "say", say_params, 2, API_GLOBAL, NULL,
        "shows a line of dialogue and waits for the fire button; a press before the line is complete shows the rest of "
        "it"),
    LUA_ENTRY("choose", choose_params, 1, API_GLOBAL, "number",
              "shows a list, lets the player choose an item with up, down and fire, and returns the item's number"),
    LUA_ENTRY("boot.run", boot_run_params, 0, 0, NULL,
              "runs the game from title to score table; call it on the last line of main.lua"),
#ifndef WITHOUT_HELP
    LUA_ENTRY("boot.run mode", boot_mode_params, 0, API_SYS, NULL, "one mode in the menu"),
    LUA_ENTRY("boot.run ship", boot_ship_params, 0, API_SYS, NULL,
              "the menu entry of one ship; its key is the name of the player kind"),
    LUA_ENTRY("boot.run form", boot_form_params, 0, API_SYS, NULL,
              "one form of a ship: another player kind in the same menu entry"),
    LUA_ENTRY("boot.run ending", boot_ending_params, 0, API_SYS, NULL, "one ending"),
    LUA_ENTRY("boot.run staff", boot_staff_params, 0, API_SYS, NULL,
              "one section of the credits: a list of strings, with the heading first"),
    LUA_ENTRY("boot.run page", boot_page_params, 0, API_SYS, NULL, "one custom page"),
    LUA_ENTRY("boot.run screens", boot_screens_params, 0, API_SYS, NULL,
              "functions that replace screens; each runs in a task, draws its screen and returns the player's choice"),
#endif
    LUA_ENTRY("boot.run music", boot_music_params, 0, API_SYS, NULL, "one piece of music in the music room"),
};
static const struct api_module api_std = { entries, sizeof entries / sizeof *entries };

extern const struct api_module api_time, api_bullet, api_motion, api_value, api_enemy, api_body, api_item, api_player,
    api_screen, api_rng, api_query, api_save, api_board, api_sys, api_sys_text, api_line, api_bg, api_laser, api_bomb,
    api_option, api_boss, api_sound, api_bulletml;
static const struct api_module *const modules[] = { &api_time,   &api_bullet, &api_motion, &api_value,    &api_enemy,
                                                    &api_body,   &api_player, &api_screen, &api_rng,      &api_query,
                                                    &api_save,   &api_board,  &api_sys,    &api_sys_text, &api_std,
                                                    &api_item,   &api_line,   &api_bg,     &api_laser,    &api_bomb,
                                                    &api_option, &api_boss,   &api_sound,  &api_bulletml };

extern const struct api_thing api_bullet_thing, api_shot_thing, api_enemy_thing, api_player_thing, api_sprite_thing,
    api_task_thing, api_motion_thing, api_group_thing, api_shots_thing, api_enemies_thing, api_item_thing,
    api_items_thing, api_line_thing, api_layer_thing, api_plane_thing, api_laser_thing, api_lasers_thing,
    api_option_thing, api_bulletml_thing;
static const struct api_thing *const things[HANDLE_KINDS] = { NULL,
                                                              &api_bullet_thing,
                                                              &api_shot_thing,
                                                              &api_enemy_thing,
                                                              &api_player_thing,
                                                              &api_sprite_thing,
                                                              &api_task_thing,
                                                              &api_motion_thing,
                                                              &api_group_thing,
                                                              &api_shots_thing,
                                                              &api_enemies_thing,
                                                              &api_item_thing,
                                                              &api_items_thing,
                                                              &api_line_thing,
                                                              &api_layer_thing,
                                                              &api_plane_thing,
                                                              &api_laser_thing,
                                                              &api_lasers_thing,
                                                              &api_option_thing,
                                                              &api_bulletml_thing };

/* Documented names that are not API functions. */
static const struct api_doc_name doc_names[] = {
    { "forever", HELP("means \"without end\" where a number of frames or times is expected") },
    { "print(...)", HELP("writes its arguments to the log") },
    { "require(name)", HELP("runs a script of the game once and returns its result, as in require \"stages/one\"; only "
                            "while scripts load") },
    { "game.stage", HELP("name of the current stage, or nil") },
    { "game.mode", HELP("name of the current mode of boot.run, or nil") },
    { "game.continues", HELP("number of continues used in this game, by all players") },
    { "game.frames", HELP("frames since the game started") },
    { "hud.banks",
      HELP("palette banks of text in the HUD, menus and dialogue: plain, bright, faint, alarm; set them in main.lua") },
    { "hud.low",
      HELP("rows left free below the registers at the lower edge of the field; set it in main.lua; initially 1") },
    { "hud.shy", HELP("distance in px within which a ship hides the registers at the lower edge of the field; set it "
                      "in main.lua; initially 0") },
    { "hud.gone", HELP("list with an entry for each player: true while the player's registers at the lower edge of the "
                       "field are hidden; use it to hide the game's own displays, too") },
    { "hud.graze", HELP("word before the graze count; set it in main.lua; false shows a star") },
    { "hud.cols", HELP("width of the screen in cells of 8 px") },
    { "hud.rows", HELP("height of the screen in cells of 8 px") },
    { "hud.banner(lines?, frames?)",
      HELP("shows a banner, a list of texts in the middle of the field; without `lines`, removes the banner") },
    { "hud.centre(row, text, bank?, first?, cols?)",
      HELP("translates a text and centres it on the screen, or in `cols` cells from column `first`; wraps a text that "
           "is too long; returns the row below the text") },
    { "talk.look", HELP("look of dialogue: dim, bank, font; set them in main.lua") },
    { "rom.title", HELP("title of the game") },
    { "rom.field", HELP("playfield: x, y, w, h in px; x and y are its position on the screen") },
    { "rom.screen", HELP("screen: w, h in px") },
};

static const struct api_entry *const fire_entries[FIRE_ENTRY_COUNT] = { &api_bullet_fire_entry, &api_shot_fire_entry,
                                                                        &api_bolt_entry, &api_curve_entry,
                                                                        &api_beam_entry };

const struct api_table api_table = { modules,   sizeof modules / sizeof *modules,    things, fire_entries,
                                     doc_names, sizeof doc_names / sizeof *doc_names };

/*
 * api_std.c - the entries written in Lua (scripts/): their arguments and help; and the list of all modules.
 */
#include "../api.h"

#define N              PARAM("n", A_INT, REQ, 0, 65535, "bullets", NULL, "number to fire")
#define NF(help)       PARAM("n", A_COUNT, REQ, 0, 65535, "times", NULL, help)
#define EVERY(help)    PARAM("every", A_INT, REQ, 0, 65535, "frames", NULL, help)
#define SPEED_TO(help) PARAM("speed_to", A_NUM, REQ, -MAX_SPEED, MAX_SPEED, "px/frame", NULL, help)
#define TURNS          PARAM("turns", A_BOOL, OPT, 0, 0, NULL, "false", "turn the shape: its right side flies ahead")
/* What every pattern has. */
#define PATTERN                                                                                                        \
    PARAM("skip", A_SPAN, OPT, -65535, 65535, NULL, NULL, "numbers of the first and the last bullet to leave out"),    \
        PARAM("fire", A_FIRE, OPT, 0, 0, NULL, "bullet", "what to fire"),                                              \
        PARAM("each", A_FUNC, OPT, 0, 0, NULL, NULL,                                                                   \
              "each(args, i): called for bullet i instead of firing it, with its arguments")
#define NAME(help)  PARAM("name", A_STR, REQ, 1, 31, NULL, NULL, help)
#define NEEDS(help) PARAM("needs", A_STR, OPT, 1, 31, NULL, NULL, help)
#define LIMIT(help) PARAM("limit", A_COUNT, OPT, 0, INT32_MAX, "frames", NULL, help)
#define MIRROR      PARAM("mirror", A_BOOL, OPT, 0, 0, NULL, "false", "swap left and right of the field")

static const struct api_param trail[] = {
    PARAM("kind", A_SPARK_KIND, REQ, 0, 0, NULL, NULL, "declared kind of the sparks"),
    PARAM("follow", A_THING, REQ, PLACES, 0, NULL, NULL, "thing that leaves them"),
    PARAM("every", A_INT, OPT, 1, 65535, "frames", "4", "frames from one spark to the next"),
    PARAM("over", A_COUNT, OPT, 1, INT32_MAX, "frames", "forever", "frames the trail lasts; it ends with the thing"),
    PARAM("dx", A_FX, OPT, -WORLD, WORLD, "px", "0", "horizontal distance from the thing"),
    PARAM("dy", A_FX, OPT, -WORLD, WORLD, "px", "0", "vertical distance from the thing"),
};
static const struct api_param wait_until[] = { PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL,
                                                     "f(): called once a frame, first at once, until it returns true"),
                                               LIMIT("frames to wait at most; no limit if left out") };
static const struct api_param ring[] = { N, PATTERN };
static const struct api_param fan[] = {
    N, PARAM("spread", A_NUM, REQ, -32767, 32767, "degrees", NULL, "angle between the first and the last"), PATTERN
};
static const struct api_param arc[] = {
    N, PARAM("sweep", A_NUM, REQ, -32767, 32767, "degrees", NULL, "angle from the first to the last, clockwise"),
    PATTERN
};
static const struct api_param stack[] = { N, SPEED_TO("speed of the last bullet; the first has speed"), PATTERN };
static const struct api_param line[] = {
    N, PARAM("width", A_NUM, REQ, -WORLD, WORLD, "px", NULL, "distance between the first and the last"), PATTERN
};
static const struct api_param polygon[] = {
    N, PARAM("sides", A_INT, REQ, 3, 65535, NULL, NULL, "number of sides; n must be a multiple of it"), PATTERN
};
static const struct api_param star[] = {
    N, PARAM("points", A_INT, REQ, 2, 32767, NULL, NULL, "number of tips; n must be a multiple of twice as many"),
    PARAM("inner", A_NUM, OPT, 0, 1, "of speed", "0.5", "speed of the inner corners, as a fraction of the tips' speed"),
    PATTERN
};
static const struct api_param ellipse[] = { N, SPEED_TO("speed across the axis"),
                                            PARAM("tilt", A_NUM, OPT, -32767, 32767, "degrees", "0",
                                                  "angle from dir to the axis along which bullets have speed"),
                                            PATTERN };
static const struct api_param rose[] = {
    N, PARAM("petals", A_INT, REQ, 1, 65535, NULL, NULL, "number of petals, the first at dir"),
    SPEED_TO("speed between two petals; their tips have speed"), PATTERN
};
static const struct api_param whip[] = { N, SPEED_TO("speed of the last bullet; the first has speed"),
                                         PARAM("bend", A_NUM, REQ, -32767, 32767, "degrees", NULL,
                                               "angle from the direction of the first to that of the last"),
                                         PATTERN };
static const struct api_param scatter[] = {
    N,
    PARAM("spread", A_NUM, REQ, -32767, 32767, "degrees", NULL,
          "angle of the cone, centred on dir, that the directions are drawn from"),
    SPEED_TO("other end of the range of speeds that starts at speed"), PATTERN
};
static const struct api_param figure[] = {
    PARAM("list", A_TABLE, REQ, 0, 0, NULL, NULL, "list of { x, y }, in px from the position; one bullet each"),
    PARAM("scale", A_NUM, OPT, -WORLD, WORLD, NULL, "1", "factor for all coordinates of the list"), TURNS, PATTERN
};
static const struct api_param picture[] = {
    PARAM("dots", A_STR, REQ, 1, 4096, NULL, NULL,
          "rows of characters, one a line; a dot or a blank leaves a gap, all others are bullets"),
    PARAM("gap", A_NUM, OPT, 0, WORLD, "px", "8", "distance between neighbours"), TURNS, PATTERN
};
static const struct api_param spiral[] = {
    NF("number of volleys"),
    PARAM("step", A_NUM, REQ, -32767, 32767, "degrees", NULL, "angle added to dir after each volley"),
    EVERY("frames from one volley to the next"),
    PARAM("arms", A_INT, OPT, 1, 65535, "bullets", "1", "bullets in a volley, evenly around the circle"), PATTERN
};
static const struct api_param aimed[] = {
    NF("number to fire"), EVERY("frames from one bullet to the next"),
    PARAM("lock", A_BOOL, OPT, 0, 0, NULL, "false", "aim once, at the first bullet, instead of at each"), PATTERN
};
static const struct api_param points[] = { PARAM("list", A_TABLE, REQ, 0, 0, NULL, NULL,
                                                 "list of points and waits, from the start to the end") };
static const struct api_param point[] = {
    PARAM("x", A_NUM, OPT, -WORLD, WORLD, "px", NULL, "horizontal position in the field; every point needs x and y"),
    PARAM("y", A_NUM, OPT, -WORLD, WORLD, "px", NULL, "vertical position in the field"),
    PARAM("over", A_INT, OPT, 1, 65535, "frames", NULL, "frames to get there; every point but the first needs it"),
    PARAM("ease", A_EASE, OPT, 0, 0, NULL, "linear", "easing of the movement to the point"),
    PARAM("wait", A_INT, OPT, 0, 65535, "frames", NULL, "frames to stay, in an entry of its own; not the first")
};
static const struct api_param path_run[] = { PARAM("e", A_THING, REQ, 1 << H_ENEMY, 0, NULL, NULL, "enemy to move"),
                                             PARAM("route", A_ROUTE, REQ, 0, 0, NULL, NULL, "result of path.def"),
                                             MIRROR };
static const struct api_param bg_def[] = {
    NAME("name for bg.show and for bosses"),
    PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL,
          "f(): task that sets the background up; it stops when another one is shown")
};
static const struct api_param stage_def[] = {
    NAME("name for boot.run and --stage"),
    PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, "f(): task of the stage, which is over when f returns"),
    NEEDS("unlock that opens the stage; boot.run skips it until then"),
    PARAM("music", A_TUNE, OPT, 0, 0, NULL, NULL, "piece that starts with the stage")
};
static const struct api_param stage_at[] = { PARAM("n", A_INT, REQ, 0, INT32_MAX, "frames", NULL,
                                                   "frame of the stage's clock; an error if it has passed") };
static const struct api_param wave[] = {
    PARAM("n", A_INT, REQ, 0, 4096, "enemies", NULL, "number to spawn"),
    EVERY("frames from one enemy to the next; 0 spawns all at once"),
    PARAM("kind", A_ENEMY_KIND, REQ, 0, 0, NULL, NULL, "declared kind to spawn"),
    PARAM("path", A_ROUTE, REQ, 0, 0, NULL, NULL, "route that each enemy follows; it despawns at the end"),
    MIRROR,
    PARAM("dx", A_NUM, OPT, -WORLD, WORLD, "px", "0", "horizontal distance of each route from the one before"),
    PARAM("dy", A_NUM, OPT, -WORLD, WORLD, "px", "0", "vertical distance of each route from the one before"),
    PARAM("run", A_FUNC, OPT, 0, 0, NULL, NULL, "run(e): task of each enemy; the kind's if left out"),
    PARAM("stay", A_BOOL, OPT, 0, 0, NULL, "false",
          "leave them in the field when the boss phase that spawned them ends"),
    PARAM("hp", A_INT, OPT, 1, INT32_MAX, NULL, NULL, "hit points of each; the kind's if left out"),
    PARAM("bank", A_INT, OPT, 0, 15, NULL, NULL,
          "number added to the palette bank of the sprite; the kind's if left out"),
    PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "name of a group to put them in; the kind's if left out"),
    PARAM("on_death", A_FUNC, OPT, 0, 0, NULL, NULL,
          "on_death(e, p): called when p kills one; p may be nil; overrides the kind's"),
    PARAM("drops", A_TABLE, OPT, 0, 0, NULL, NULL, "items that each drops, { NAME = count }; the kind's if left out"),
    PARAM("formation", A_ANY, OPT, 0, 0, "v, line, column, circle, or a list of { x, y }", NULL,
          "places of the enemies; a list gives the distance of each from the route"),
    PARAM("gap", A_NUM, OPT, 0, WORLD, "px", "24", "distance between neighbours in a formation by name")
};
static const struct api_param limit_only[] = { LIMIT("frames to wait at most; no limit if left out") };
static const struct api_param name_only[] = { NAME("name of the mark") };
static const struct api_param boss_def[] = {
    NAME("name for boss.fight and --stage"),
    PARAM("title", A_STR, REQ, 0, 63, NULL, NULL, "name shown on the screen"),
    PARAM("kind", A_ENEMY_KIND, OPT, 0, 0, NULL, NULL, "declared kind of its enemy; give kind, x and y, or cast"),
    PARAM("x", A_NUM, OPT, -WORLD, WORLD, "px", NULL, "horizontal position where it fights and rests; needs y"),
    PARAM("y", A_NUM, OPT, -WORLD, WORLD, "px", NULL, "vertical position where it fights and rests; needs x"),
    PARAM("phases", A_TABLE, REQ, 0, 0, NULL, NULL, "list of phases, in order; { talk = f } among them is dialogue"),
    PARAM("cast", A_TABLE, OPT, 0, 0, NULL, NULL, "list of two or more who fight together, instead of kind, x and y"),
    PARAM("portrait", A_SPRITE, OPT, 0, 0, NULL, NULL, "sprite that crosses the field as a spell is declared"),
    PARAM("portrait_left", A_BOOL, OPT, 0, 0, NULL, "false", "let the portrait come from the left, mirrored"),
    PARAM("warning", A_INT, OPT, 0, 65535, "frames", "0",
          "length of the WARNING before the boss flies in; 0 shows none"),
    PARAM("epithet", A_STR, OPT, 1, 63, NULL, NULL, "line above the title in the warning"),
    PARAM("entrance", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "spark kind that it leaves behind as it flies in"),
    PARAM("bg", A_STR, OPT, 0, 0, NULL, NULL, "background declared with bg.def, shown when the fight starts"),
    PARAM("music", A_TUNE, OPT, 0, 0, NULL, NULL, "piece during the fight")
};
static const struct api_param boss_cast[] = {
    NAME("name that hp and run of a phase use"),
    PARAM("title", A_STR, REQ, 0, 63, NULL, NULL, "name shown with its bar"),
    PARAM("kind", A_ENEMY_KIND, REQ, 0, 0, NULL, NULL, "declared kind of its enemy"),
    PARAM("x", A_NUM, REQ, -WORLD, WORLD, "px", NULL, "horizontal position where it fights and rests"),
    PARAM("y", A_NUM, REQ, -WORLD, WORLD, "px", NULL, "vertical position where it fights and rests"),
    PARAM("portrait", A_SPRITE, OPT, 0, 0, NULL, NULL, "portrait of the phases it leads; the boss's if left out"),
    PARAM("portrait_left", A_BOOL, OPT, 0, 0, NULL, NULL, "side its portrait comes from; the boss's if left out")
};
static const struct api_param boss_talk[] = { PARAM(
    "talk", A_FUNC, REQ, 0, 0, NULL, NULL,
    "talk(e): called with the boss, or with all of the cast; it can say and choose") };
static const struct api_param boss_fight[] = { NAME("name of the boss"),
                                               PARAM("clock", A_BOOL, OPT, 0, 0, NULL, "false",
                                                     "let the stage's clock run during the fight") };
static const struct api_param boss_history[] = {
    NAME("name of the boss"), PARAM("id", A_STR, REQ, 1, 31, NULL, NULL, "id of the phase"),
    PARAM("difficulty", A_STR, OPT, 0, 0, NULL, NULL, "difficulty to count; the one being played if left out"),
    PARAM("ship", A_PLAYER_KIND, OPT, 0, 0, NULL, NULL, "ship to count; all ships if left out")
};
static const struct api_param phase[] = {
    PARAM("id", A_STR, REQ, 1, 31, NULL, NULL, "lasting name, for saves, practice and --stage NAME/ID"),
    PARAM("hp", A_ANY, OPT, 0, 0, "whole number, or { NAME = n }", NULL,
          "hit points; a table by name of the cast has a bar each; optional with survive"),
    PARAM("time", A_INT, REQ, 1, INT32_MAX, "frames", NULL,
          "time limit; running out beats the phase only with survive"),
    PARAM("run", A_ANY, OPT, 0, 0, "function, or { NAME = function }", NULL,
          "required: run(e), its task, gets the boss or the cast; a table has a task each"),
    PARAM("spell", A_STR, OPT, 0, 127, NULL, NULL,
          "name of the spell card, declared on the screen; boss.history counts it"),
    PARAM("bonus", A_INT, OPT, 0, INT32_MAX, "points", "0",
          "points for each player if the phase is captured: beaten with no death or bomb"),
    PARAM("bonus_to", A_INT, OPT, 0, INT32_MAX, "points", NULL,
          "value that the bonus falls to over time; it stays the same if left out"),
    PARAM("survive", A_BOOL, OPT, 0, 0, NULL, "false",
          "make the boss invulnerable; the phase is beaten when time runs out"),
    PARAM("last", A_BOOL, OPT, 0, 0, NULL, "false",
          "run only if all phases before it were beaten; a hit ends it and costs no life"),
    PARAM("safe", A_INT, OPT, 0, 65535, "frames", "0", "frames at the start in which it takes no damage"),
    PARAM("armour", A_INT, OPT, 0, 65535, "frames", "0",
          "frames after safe in which it takes less damage; needs board = { bodies = true }"),
    PARAM("rate", A_NUM, OPT, 0, 1, NULL, "0.25", "fraction of damage it takes during armour"),
    PARAM("down", A_DOWN, OPT, 0, 0, NULL, "all", "with a bar each, whether all or any must be empty"),
    PARAM("cut_in", A_BOOL, OPT, 0, 0, NULL, NULL,
          "show the portrait with the spell; true if left out and there are both"),
    PARAM("portrait", A_SPRITE, OPT, 0, 0, NULL, NULL, "portrait of this phase; its leader's or boss's if left out"),
    PARAM("portrait_left", A_BOOL, OPT, 0, 0, NULL, NULL,
          "side the portrait comes from; its leader's or boss's if left out"),
    PARAM("rest", A_INT, OPT, 0, 65535, "frames", "60",
          "frames to fly back to its place before the next phase; 0 skips that"),
    PARAM("clear", A_TABLE, OPT, 0, 0, NULL, NULL, "what the bullets turn into when the phase ends and clears them"),
    PARAM("drops", A_TABLE, OPT, 0, 0, NULL, NULL, "items dropped when it is beaten, { NAME = count }"),
    PARAM("bg", A_STR, OPT, 0, 0, NULL, NULL, "background declared with bg.def during the phase"),
    PARAM("music", A_TUNE, OPT, 0, 0, NULL, NULL, "piece during the phase")
};
static const struct api_param phase_clear[] = {
    PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "item kind for each bullet, if the phase is beaten"),
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "spark kind for each bullet")
};
static const struct api_param bg_show[] = {
    PARAM("name", A_STR, OPT, 0, 0, NULL, NULL, "background to show; nil shows none"),
    PARAM("over", A_INT, OPT, 0, 65535, "frames", "30", "length of the fade, black in the middle; 0 changes at once")
};
static const struct api_param rule[] = {
    PARAM("on", A_STR, OPT, 1, 31, NULL, NULL,
          "event that earns it: kill, graze, take, death or bomb; give on or name"),
    PARAM("name", A_STR, OPT, 1, 31, NULL, NULL, "event of the game's own, counted by score.count"),
    PARAM("kind", A_STR, OPT, 1, 31, NULL, NULL, "kind of enemy, bullet or item to limit kill, graze or take to"),
    PARAM("points", A_ANY, OPT, 0, 0, "whole number, or a register", NULL,
          "points for the player, or f(p, thing) that returns them"),
    PARAM("times", A_ANY, OPT, 0, 0, "whole number, or a register", NULL,
          "factor for points, or for the thing's own score; or f(p, thing) that returns it"),
    PARAM("gain", A_TABLE, OPT, 0, 0, NULL, NULL,
          "numbers to add to registers, { NAME = n }, before the points are counted"),
    PARAM("most", A_TABLE, OPT, 0, 0, NULL, NULL,
          "registers to raise to another one's value, { NAME = OTHER }, if that is more"),
    PARAM("set", A_TABLE, OPT, 0, 0, NULL, NULL,
          "values to set registers to, { NAME = n }, after the points are counted")
};
static const struct api_param count[] = {
    NAME("name of a score.rule"), PARAM("n", A_INT, REQ, 0, INT32_MAX, NULL, NULL, "how many times it happened"),
    PARAM("p", A_PAD, OPT, 0, 0, NULL, "1", "player who did it")
};
static const struct api_param tally[] = { PARAM("list", A_TABLE, REQ, 0, 0, NULL, NULL,
                                                "list of lines, from top to bottom") };
static const struct api_param tally_line[] = {
    PARAM("label", A_STR, REQ, 1, 31, NULL, NULL, "word at the left of the line"),
    PARAM("value", A_ANY, REQ, 0, 0, "property, register or function", NULL,
          "what to count; f(p) returns a number, or true for 1, or false for no line"),
    PARAM("points", A_INT, REQ, 0, 1e12, "points", NULL, "points for each one counted"),
    PARAM("stage", A_BOOL, OPT, 0, 0, NULL, "false", "count only what was added in this stage"),
    PARAM("last", A_BOOL, OPT, 0, 0, NULL, "false", "show the line after the last stage only")
};
#define UNLOCK_NAME(help) PARAM("name", A_STR, REQ, 1, NV_KEY - 7, NULL, NULL /* kept under "unlock/NAME" */, help)
static const struct api_param unlock_def[] = {
    UNLOCK_NAME("name for unlock.has and needs; saved as unlock/NAME"),
    PARAM("when", A_ANY, REQ, 0, 0, "conditions, or a function", NULL,
          "what a run must achieve; when(run) is called at its end and returns true"),
    PARAM("title", A_STR, OPT, 1, 63, NULL, NULL, "text shown once it is unlocked; the name if left out"),
    PARAM("hint", A_STR, OPT, 1, 127, NULL, NULL, "text shown until it is unlocked")
};
static const struct api_param unlock_when[] = {
    PARAM("clear", A_ANY, OPT, 0, 0, "true, or a stage", NULL, "stage to clear; true: all stages"),
    PARAM("mode", A_STR, OPT, 1, 31, NULL, NULL, "mode of boot.run to play"),
    PARAM("difficulty", A_STR, OPT, 1, 31, NULL, NULL, "difficulty to play; this one or any harder one counts"),
    PARAM("ship", A_STR, OPT, 1, 31, NULL, NULL, "ship to play"),
    PARAM("continues", A_INT, OPT, 0, INT32_MAX, NULL, NULL, "continues that may be used at most"),
    PARAM("score", A_INT, OPT, 1, 1e12, "points", NULL, "score to reach, with that ship"),
    PARAM("spell", A_STR, OPT, 1, 63, NULL, NULL, "spell to capture, \"boss/id\", at the difficulty being played"),
    PARAM("heard", A_TUNE, OPT, 0, 0, NULL, NULL, "piece of music to hear in a game")
};
static const struct api_param unlock_has[] = { UNLOCK_NAME("name of an unlock.def") };
#define MISSION_NAME(help) PARAM("name", A_STR, REQ, 1, NV_KEY - 8, NULL, NULL /* kept under "mission/NAME" */, help)
static const struct api_param mission_def[] = {
    MISSION_NAME("name for mission.best; saved as mission/NAME"),
    PARAM("title", A_STR, REQ, 1, 63, NULL, NULL, "name shown in the list of missions"),
    PARAM("text", A_STR, OPT, 0, 127, NULL, NULL, "line that says what to do"),
    PARAM("stage", A_STR, OPT, 1, 31, NULL, NULL, "stage to play a part of; give stage or boss"),
    PARAM("mark", A_STR, OPT, 1, 31, NULL, NULL, "mark the part starts at; the stage's start if left out; needs stage"),
    PARAM("to", A_STR, OPT, 1, 31, NULL, NULL, "mark the part ends at; the stage's end if left out; needs stage"),
    PARAM("boss", A_STR, OPT, 1, 31, NULL, NULL, "boss to fight"),
    PARAM("phase", A_STR, OPT, 1, 31, NULL, NULL, "id of the only phase to fight; all if left out; needs boss"),
    PARAM("ship", A_STR, OPT, 1, 31, NULL, NULL, "ship to play; the player chooses if left out"),
    PARAM("difficulty", A_STR, OPT, 1, 31, NULL, NULL, "difficulty to play; the player chooses if left out"),
    PARAM("lives", A_INT, OPT, 1, 99, NULL, "1", "lives to start with, the one in play included"),
    PARAM("registers", A_TABLE, OPT, 0, 0, NULL, NULL, "values to start registers with, { NAME = n }"),
    PARAM("goal", A_ANY, OPT, 0, 0, "{ NAME = n, .. }, or a function", NULL,
          "counts to reach: score grazes kills frames lives or a register; or goal(p)"),
    PARAM("clear", A_BOOL, OPT, 0, 0, NULL, "false",
          "play to the end, and beat the boss, to succeed; true needs no goal"),
    PARAM("limit", A_INT, OPT, 1, INT32_MAX, "frames", NULL, "frames to finish in; no limit if left out"),
    PARAM("bombs", A_INT, OPT, 0, 99, NULL, NULL, "bombs that may be used; no limit if left out"),
    PARAM("by", A_STR, OPT, 1, 31, NULL, "time",
          "what is measured: time, less is better; or a count of goal, more is better"),
    PARAM("medals", A_TABLE, OPT, 0, 0, NULL, NULL, "values of by for two and for three stars, { a, b }"),
    NEEDS("unlock that opens the mission")
};
static const struct api_param mission_best[] = { MISSION_NAME("name of a mission.def") };
static const struct api_param boot_run[] = {
    PARAM("stages", A_TABLE, OPT, 0, 0, NULL, NULL, "names of the stages, in order; give stages or modes"),
    PARAM("players", A_TABLE, REQ, 0, 0, NULL, NULL, "list of player kinds to choose from"),
    PARAM("demo", A_STR, OPT, 1, 63, NULL, NULL, "demo that the title shows after ten seconds, demos/NAME.demo"),
    PARAM("demos", A_TABLE, OPT, 0, 0, NULL, NULL, "list of demos to show in turn, instead of demo"),
    PARAM("modes", A_TABLE, OPT, 0, 0, NULL, NULL, "list of modes to choose from, instead of stages"),
    PARAM("difficulties", A_TABLE, OPT, 0, 0, NULL, NULL, "texts for difficulties from rom.lua, { NAME = text }"),
    PARAM("ships", A_TABLE, OPT, 0, 0, NULL, NULL, "what the choice of ship shows, by player kind"),
    PARAM("ending", A_ANY, OPT, 0, 0, "function, or a list of { when, show, music }", NULL,
          "ending(run), called after the last stage; of a list, the first whose when holds"),
    PARAM("opening", A_FUNC, OPT, 0, 0, NULL, NULL,
          "opening(): shown before the title, and again when nobody comes; START ends it"),
    PARAM("staff", A_TABLE, OPT, 0, 0, NULL, NULL, "list of credits, shown after the ending"),
    PARAM("music", A_TABLE, OPT, 0, 0, NULL, NULL,
          "{ SCREEN = piece }; room = true, or pieces as a list, make a music room"),
    PARAM("continues", A_INT, OPT, 1, 99, NULL, NULL, "continues for each player; none if left out"),
    PARAM("pages", A_TABLE, OPT, 0, 0, NULL, NULL, "list of the game's own pages in the title's menu"),
    PARAM("grades", A_FUNC, OPT, 0, 0, NULL, NULL,
          "grades(stage, p): returns a text that the results of the stage show, such as S"),
    PARAM("screens", A_TABLE, OPT, 0, 0, NULL, NULL, "functions that replace the library's screens, by name")
};
static const struct api_param boot_music[] = {
    PARAM("name", A_TUNE, REQ, 0, 0, NULL, NULL, "piece to play"),
    PARAM("title", A_STR, OPT, 0, 63, NULL, NULL, "title in the list; rom.lua's title if left out"),
    PARAM("text", A_STR, OPT, 0, 127, NULL, NULL, "text below the list"), NEEDS("unlock that opens the piece")
};
#ifndef WITHOUT_HELP /* scripts/boot/check.lua checks these */
static const struct api_param boot_mode[] = {
    NAME("name of the mode; game.mode has it"),
    PARAM("stages", A_TABLE, REQ, 0, 0, NULL, NULL, "names of the stages, in order"),
    PARAM("text", A_STR, OPT, 0, 0, NULL, NULL, "text below the name in the list"),
    PARAM("needs", A_STR, OPT, 0, 0, NULL, NULL, "unlock that opens the mode")
};
#define BOOT_SHIP(of)                                                                                                  \
    PARAM("title", A_STR, OPT, 0, 0, NULL, NULL, "name shown; " of " if left out"),                                    \
        PARAM("text", A_STR, OPT, 0, 0, NULL, NULL, "text about it"),                                                  \
        PARAM("figures", A_TABLE, OPT, 0, 0, NULL, NULL,                                                               \
              "list of { word, n }: n of 0 to 5 stars; speed, lives and registers if left out")
static const struct api_param boot_ship[] = { BOOT_SHIP("its kind"),
                                              PARAM("forms", A_TABLE, OPT, 0, 0, NULL, NULL,
                                                    "list of forms to choose from, after the ship") };
static const struct api_param boot_form[] = {
    PARAM("kind", A_PLAYER_KIND, REQ, 0, 0, NULL, NULL, "player kind that the form uses"), BOOT_SHIP("the ship's")
};
#define BOOT_WHEN                                                                                                      \
    PARAM("when", A_ANY, OPT, 0, 0, "conditions, or a function", NULL,                                                 \
          "mode, difficulty, ship, players or continues of the run; or when(run) returns true")
static const struct api_param boot_ending[] = {
    BOOT_WHEN,
    PARAM("show", A_FUNC, REQ, 0, 0, NULL, NULL, "show(run): shows the ending; returning false leaves out the credits"),
    PARAM("music", A_TUNE, OPT, 0, 0, NULL, NULL, "piece during the ending")
};
static const struct api_param boot_staff[] = { BOOT_WHEN };
static const struct api_param boot_page[] = {
    PARAM("name", A_STR, REQ, 0, 0, NULL, NULL, "name in the title's menu, and the heading of the page"),
    PARAM("show", A_FUNC, REQ, 0, 0, NULL, NULL, "show(row, rows): draws the page, in that many rows from that row on")
};
#define SCREEN(name, help) PARAM(name, A_FUNC, OPT, 0, 0, NULL, NULL, help)
static const struct api_param boot_screens[] = {
    SCREEN("title", "title(limit, places, from): returns a place, and for start how many play; or nil"),
    SCREEN("mode", "mode(modes): returns the name of one of these { name, text, closed }; nil: back"),
    SCREEN("difficulty", "difficulty(names, present, texts): returns one of names; nil: back"),
    SCREEN("ship", "ship(kinds, players, about): returns the kind of each player, as a list; nil: back"),
    SCREEN("pause", "pause(index, items, chosen): returns the number of an item; 1 resumes the game"),
    SCREEN("continue", "continue(index, left): returns true for yes; left counts the continues"),
    SCREEN("results", "results(title, players, stopped, lines, new, grades): ends once stopped() is true"),
    SCREEN("name", "name(entries): returns a name for each { p, points, rank }, as a list"),
    SCREEN("ending", "ending(run): shown when all stages are cleared, if the game has no ending"),
    SCREEN("staff", "staff(parts): the credits of this run"),
    SCREEN("scores", "scores(difficulty, limit, row, ship): returns true if START was pressed"),
    SCREEN("history", "history(difficulty): how often spells were captured"),
    SCREEN("music", "music(list): the music room"),
    SCREEN("unlocks", "unlocks(): titles of what is unlocked, and hints for the rest"),
    SCREEN("missions", "missions(last): returns the name of a mission; nil: back"),
    SCREEN("mission", "mission(result): the result of a mission; returns again or list"),
    SCREEN("page", "page(page): shows one of pages, as { name, show }"),
};
#endif
static const struct api_param game_def[] = { PARAM(
    "registers", A_TABLE, REQ, 0, 0, NULL, NULL,
    "registers of the run, { NAME = start or settings }, as in player.def") };
static const struct api_param talk_def[] = {
    PARAM("who", A_STR, REQ, 1, 31, NULL, NULL, "name for say"),
    PARAM("name", A_STR, REQ, 0, 63, NULL, NULL, "name shown on the box"),
    PARAM("faces", A_TABLE, OPT, 0, 0, NULL, NULL,
          "sprites of the portrait, { FACE = name }, drawn facing right; words alone if left out"),
    PARAM("side", A_STR, OPT, 0, 0, NULL, "left", "side of the portrait, left or right"),
    PARAM("bank", A_INT, OPT, 0, 15, NULL, "0", "number added to the palette bank of the portrait"),
    PARAM("voice", A_SOUND, OPT, 0, 0, NULL, NULL, "sound played with the letters")
};
static const struct api_param talk_face[] = { PARAM("face", A_SPRITE, REQ, 0, 0, NULL, NULL,
                                                    "sprite of the portrait") };
static const struct api_param talk_run[] = {
    PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, "f(): says and asks with say and choose"),
    PARAM("hold", A_STR, OPT, 0, 0, NULL, "fire", "what players cannot do: fire (or bomb), all (nor move) or none"),
    PARAM("clear", A_BOOL, OPT, 0, 0, NULL, "true", "remove all bullets and lasers at the start"),
    PARAM("skip", A_BOOL, OPT, 0, 0, NULL, "true", "let the player skip it by holding special"),
    PARAM("clock", A_BOOL, OPT, 0, 0, NULL, "false", "let the stage's clock run meanwhile")
};
static const struct api_param say[] = {
    PARAM("who", A_STR, OPT, 0, 0, NULL, NULL, "speaker of a talk.def; nil: nobody"),
    PARAM("text", A_STR, REQ, 0, 4096, NULL, NULL, "words, in pages of three rows; \\n starts a row"),
    PARAM("face", A_STR, OPT, 0, 0, NULL, NULL,
          "one of the speaker's faces; the last one used if left out, at first calm"),
    PARAM("side", A_STR, OPT, 0, 0, NULL, NULL, "side of the portrait, left or right; the speaker's if left out"),
    PARAM("letter", A_INT, OPT, 0, 600, "frames", "2", "frames from one letter to the next; 0 shows all at once"),
    LIMIT("frames until a full page turns by itself; waits for fire if left out"),
    PARAM("voice", A_SOUND, OPT, 0, 0, NULL, NULL, "sound for this line, played once; the speaker's voice if left out"),
};
static const struct api_param choose[] = {
    PARAM("list", A_TABLE, REQ, 0, 0, NULL, NULL, "list of texts to choose from"),
    PARAM("title", A_STR, OPT, 0, 0, NULL, NULL, "text above the list"),
    PARAM("chosen", A_INT, OPT, 1, 99, NULL, "1", "item chosen first, and the answer if the talk is skipped"),
    PARAM("p", A_PAD, OPT, 0, 0, NULL, NULL, "player whose buttons count; both players if left out"),
    LIMIT("frames until the current item is taken; no limit if left out"),
    PARAM("back", A_INT, OPT, 1, 99, NULL, NULL, "answer that bomb gives; bomb does nothing if left out")
};
static const struct api_param values[] = { PARAM(
    "values", A_TABLE, REQ, 0, 0, NULL, NULL,
    "values by name of a difficulty, { NAME = value }, or a list from the easiest one") };

#define LUA(name, params, plain, flags, returns, help)                                                                 \
    {                                                                                                                  \
        name, NULL, PARAMS(params), plain, API_LUA | (flags), returns, HELP(help)                                      \
    }
static const struct api_entry entries[] = {
    LUA("wait_until", wait_until, 2, API_GLOBAL, "boolean",
        "waits until f() returns true; returns false if the limit runs out first"),
    { "wait_for", NULL, NULL, 0, 0, API_LUA | API_GLOBAL | API_MORE, NULL,
      HELP("waits until every given task has ended and every given thing is dead") },
    LUA("by_difficulty", values, 1, API_GLOBAL, "value",
        "returns the value for the difficulty being played, or the nearest easier one, or the easiest given"),
    LUA("pattern.ring", ring, 0, API_FIRE, NULL, "fires n bullets in all directions, evenly spaced, the first at dir"),
    LUA("pattern.fan", fan, 0, API_FIRE, NULL, "fires n bullets in a fan, centred on dir"),
    LUA("pattern.arc", arc, 0, API_FIRE, NULL, "fires n bullets over an arc that starts at dir"),
    LUA("pattern.stack", stack, 0, API_FIRE, NULL,
        "fires n bullets in one direction, at speeds from speed to speed_to"),
    LUA("pattern.line", line, 0, API_FIRE, NULL, "fires n bullets side by side, in a line across dir"),
    LUA("pattern.polygon", polygon, 0, API_FIRE, NULL,
        "fires n bullets as a growing polygon; its corners fly at speed, the first of them along dir"),
    LUA("pattern.star", star, 0, API_FIRE, NULL,
        "fires n bullets as a growing star; its tips fly at speed, the first of them along dir"),
    LUA("pattern.ellipse", ellipse, 0, API_FIRE, NULL,
        "fires n bullets as a growing ellipse, at speed along its axis, the first along dir"),
    LUA("pattern.rose", rose, 0, API_FIRE, NULL,
        "fires n bullets over the full circle as a growing flower, the tip of the first petal along dir"),
    LUA("pattern.whip", whip, 0, API_FIRE, NULL,
        "fires n bullets as a bent stack: speed and direction change from the first to the last"),
    LUA("pattern.scatter", scatter, 0, API_FIRE, NULL,
        "fires n bullets at random directions and speeds; draws two numbers of rng for each"),
    LUA("pattern.points", figure, 0, API_FIRE, NULL,
        "fires a bullet from each point of a list; all fly in the same direction"),
    LUA("pattern.picture", picture, 0, API_FIRE, NULL,
        "fires a bullet for each character of a picture made of text, centred on the position"),
    LUA("pattern.spiral", spiral, 0, API_FIRE, NULL,
        "fires volleys that turn by step each time; takes time, so call it in a task"),
    LUA("pattern.aimed", aimed, 0, API_FIRE, NULL,
        "fires n bullets one after the other at the player (shots: at an enemy); takes time, so call it in a task"),
    LUA("path.def", points, 1, API_LOAD, "route", "makes a route for enemies and bullets from a list of points"),
    LUA("path.def point", point, 0, API_SYS, NULL,
        "one entry of the list: { x, y } to start, then { x, y, over } or { wait }"),
    LUA("path.run", path_run, 3, 0, NULL, "moves an enemy along a route; returns when it arrives at the end"),
    LUA("spark.trail", trail, 0, 0, "task",
        "leaves after-images: a spark where a thing is, every few frames, until the task's owner or the thing is gone"),
    LUA("stage.def", stage_def, 2, API_LOAD, NULL,
        "declares a stage: one task that spawns waves and fights bosses in order"),
    LUA("stage.at", stage_at, 1, 0, NULL, "waits for frame n of the stage's clock, which stops during boss.fight"),
    LUA("stage.wave", wave, 0, 0, NULL,
        "spawns n enemies that follow a route, one by one or in a formation, and returns at once"),
    LUA("stage.clear", limit_only, 1, 0, "boolean",
        "waits until all waves are spawned and no enemy is left; returns false if the limit runs out first"),
    LUA("stage.mark", name_only, 1, 0, NULL,
        "names a moment of the stage, where practice and --stage NAME:MARK can start"),
    { "stage.skipping", NULL, NULL, 0, 0, API_LUA, "boolean",
      HELP("true while the stage skips ahead to the mark it starts at") },
    LUA("boss.def", boss_def, 1, API_LOAD, NULL,
        "declares a boss: one enemy, or a cast of several, that fights in phases"),
    LUA("boss.def phase", phase, 0, API_SYS, NULL,
        "one phase of the fight; it ends when hp are gone or time is up, and clears the field of what its run spawned"),
    LUA("boss.def cast", boss_cast, 0, API_SYS, NULL, "one of the cast"),
    LUA("boss.def talk", boss_talk, 0, API_SYS, NULL, "a talk between two phases; the boss is safe during it"),
    LUA("boss.def clear", phase_clear, 0, API_SYS, NULL, "what the bullets leave when the phase ends"),
    LUA("boss.fight", boss_fight, 1, 0, "boolean",
        "brings the boss in and fights all its phases; returns true if every phase was beaten"),
    { "boss.now", NULL, NULL, 0, 0, API_LUA, "boss, id, frames",
      HELP("returns the name of the boss, the id of its phase and how long that has lasted; nil if there is none") },
    LUA("boss.history", boss_history, 2, 0, "tries, captures",
        "returns how often a spell was tried and captured, saved across runs; practice does not count"),
    LUA("bg.def", bg_def, 2, API_LOAD, NULL,
        "declares a background: a task that sets up bg.layer and bg.plane, all of which are off at its start"),
    LUA("bg.show", bg_show, 1, 0, NULL,
        "fades through black to a background declared with bg.def, whose task starts in the middle of the fade"),
    LUA("score.rule", rule, 0, API_LOAD, NULL,
        "declares what an event is worth, in points and in registers: chains, multipliers, gauges"),
    LUA("score.count", count, 3, 0, NULL, "reports that a rule's own event happened n times"),
    LUA("score.tally", tally, 1, API_LOAD, NULL, "declares the bonus lines of a stage's results"),
    LUA("score.tally line", tally_line, 0, API_SYS, NULL, "one line of the results"),
    LUA("unlock.def", unlock_def, 1, API_LOAD, NULL,
        "declares an unlock: a reward, saved for good, for a run that fulfills its conditions"),
    LUA("unlock.def when", unlock_when, 0, API_SYS, NULL, "conditions, all of which must hold"),
    LUA("unlock.has", unlock_has, 1, 0, "boolean", "true if it is unlocked"),
    LUA("mission.def", mission_def, 1, API_LOAD, NULL,
        "declares a mission: a part of a stage, or a boss, to play for a goal and up to three stars"),
    LUA("mission.best", mission_best, 1, 0, "value, stars, ship",
        "returns the best result of a mission, its stars and its ship; nil and 0 if it was never done"),
    { "mission.stars", NULL, NULL, 0, 0, API_LUA, "got, most",
      HELP("returns the stars earned in all missions, and how many there are") },
    LUA("game.def", game_def, 0, API_LOAD, NULL,
        "declares the registers of a run, such as rank; read and write them as game.NAME"),
    LUA("talk.def", talk_def, 1, API_LOAD, NULL, "declares a speaker for say: name, portrait and voice"),
    LUA("talk.def face", talk_face, 1, API_SYS, NULL, "each face by name"),
    LUA("talk.run", talk_run, 1, 0, NULL,
        "runs f(), whose say and choose share one box; the stage's clock stops and players do not fire"),
    LUA("say", say, 2, API_GLOBAL, NULL,
        "shows a line of dialogue and waits for fire, which first shows all letters at once"),
    LUA("choose", choose, 1, API_GLOBAL, "number",
        "shows a list, lets the player choose with up, down and fire, and returns the number of the item"),
    LUA("boot.run", boot_run, 0, 0, NULL, "runs the game from title to score table; the last line of main.lua"),
#ifndef WITHOUT_HELP
    LUA("boot.run mode", boot_mode, 0, API_SYS, NULL, "one mode to choose"),
    LUA("boot.run ship", boot_ship, 0, API_SYS, NULL, "each ship, by the name of its player kind"),
    LUA("boot.run form", boot_form, 0, API_SYS, NULL,
        "one of the forms of a ship: another player kind behind the same choice"),
    LUA("boot.run ending", boot_ending, 0, API_SYS, NULL, "one ending"),
    LUA("boot.run staff", boot_staff, 0, API_SYS, NULL,
        "one section of the credits: a list of texts, the heading first"),
    LUA("boot.run page", boot_page, 0, API_SYS, NULL, "one page of the game's own"),
    LUA("boot.run screens", boot_screens, 0, API_SYS, NULL,
        "functions that replace a screen: each runs in a task, shows what it likes, and returns the choice"),
#endif
    LUA("boot.run music", boot_music, 0, API_SYS, NULL, "one piece of the music room"),
};
static const struct api_module api_std = { entries, sizeof entries / sizeof *entries };

extern const struct api_module api_time, api_bullet, api_value, api_enemy, api_body, api_item, api_player, api_screen,
    api_rng, api_query, api_save, api_board, api_sys, api_line, api_bg, api_laser, api_bomb, api_option, api_boss,
    api_sound, api_bulletml;
const struct api_module *const api_modules[] = { &api_time,   &api_bullet,  &api_value, &api_enemy,  &api_body,
                                                 &api_player, &api_screen,  &api_rng,   &api_query,  &api_save,
                                                 &api_board,  &api_sys,     &api_std,   &api_item,   &api_line,
                                                 &api_bg,     &api_laser,   &api_bomb,  &api_option, &api_boss,
                                                 &api_sound,  &api_bulletml };
const int api_module_count = sizeof api_modules / sizeof *api_modules;

extern const struct api_thing api_bullet_thing, api_shot_thing, api_enemy_thing, api_player_thing, api_sprite_thing,
    api_task_thing, api_motion_thing, api_group_thing, api_shots_thing, api_enemies_thing, api_item_thing,
    api_items_thing, api_line_thing, api_layer_thing, api_plane_thing, api_laser_thing, api_lasers_thing,
    api_option_thing, api_bulletml_thing;
const struct api_thing *const api_things[HANDLES] = { NULL,
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

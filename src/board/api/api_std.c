/*
 * api_std.c - the entries written in Lua (scripts/): their arguments and help; and the list of all modules.
 */
#include "../api.h"

#define N        PARAM("n", A_INT, REQ, 0, 65535, "bullets", NULL, "")
#define NF       PARAM("n", A_COUNT, REQ, 0, 65535, "times", NULL, "")
#define EVERY    PARAM("every", A_INT, REQ, 0, 65535, "frames", NULL, "")
#define SPEED_TO PARAM("speed_to", A_NUM, REQ, -MAX_SPEED, MAX_SPEED, "px/frame", NULL, "")
#define TURNS    PARAM("turns", A_BOOL, OPT, 0, 0, NULL, "false", "")
/* What every pattern has. */
#define PATTERN                                                                                                        \
    PARAM("skip", A_SPAN, OPT, -65535, 65535, NULL, NULL, ""), PARAM("fire", A_FIRE, OPT, 0, 0, NULL, "bullet", ""),   \
        PARAM("each", A_FUNC, OPT, 0, 0, NULL, NULL, "")
#define NAME  PARAM("name", A_STR, REQ, 1, 31, NULL, NULL, "")
#define LIMIT PARAM("limit", A_COUNT, OPT, 0, INT32_MAX, "frames", NULL, "")

static const struct api_param trail[] = {
    PARAM("kind", A_SPARK_KIND, REQ, 0, 0, NULL, NULL, ""),
    PARAM("follow", A_THING, REQ, PLACES, 0, NULL, NULL, ""),
    PARAM("every", A_INT, OPT, 1, 65535, "frames", "4", ""),
    PARAM("over", A_COUNT, OPT, 1, INT32_MAX, "frames", "forever", ""),
    PARAM("dx", A_FX, OPT, -WORLD, WORLD, "px", "0", ""),
    PARAM("dy", A_FX, OPT, -WORLD, WORLD, "px", "0", ""),
};
static const struct api_param wait_until[] = { PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, ""), LIMIT };
static const struct api_param ring[] = { N, PATTERN };
static const struct api_param fan[] = { N, PARAM("spread", A_NUM, REQ, -32767, 32767, "degrees", NULL, ""), PATTERN };
static const struct api_param arc[] = { N, PARAM("sweep", A_NUM, REQ, -32767, 32767, "degrees", NULL, ""), PATTERN };
static const struct api_param stack[] = { N, SPEED_TO, PATTERN };
static const struct api_param line[] = { N, PARAM("width", A_NUM, REQ, -WORLD, WORLD, "px", NULL, ""), PATTERN };
static const struct api_param polygon[] = { N, PARAM("sides", A_INT, REQ, 3, 65535, NULL, NULL, ""), PATTERN };
static const struct api_param star[] = { N, PARAM("points", A_INT, REQ, 2, 32767, NULL, NULL, ""),
                                         PARAM("inner", A_NUM, OPT, 0, 1, "of speed", "0.5", ""), PATTERN };
static const struct api_param ellipse[] = { N, SPEED_TO, PARAM("tilt", A_NUM, OPT, -32767, 32767, "degrees", "0", ""),
                                            PATTERN };
static const struct api_param rose[] = { N, PARAM("petals", A_INT, REQ, 1, 65535, NULL, NULL, ""), SPEED_TO, PATTERN };
static const struct api_param whip[] = { N, SPEED_TO, PARAM("bend", A_NUM, REQ, -32767, 32767, "degrees", NULL, ""),
                                         PATTERN };
static const struct api_param scatter[] = { N, PARAM("spread", A_NUM, REQ, -32767, 32767, "degrees", NULL, ""),
                                            SPEED_TO, PATTERN };
static const struct api_param figure[] = { PARAM("list", A_TABLE, REQ, 0, 0, NULL, NULL, ""),
                                           PARAM("scale", A_NUM, OPT, -WORLD, WORLD, NULL, "1", ""), TURNS, PATTERN };
static const struct api_param picture[] = { PARAM("dots", A_STR, REQ, 1, 4096, NULL, NULL, ""),
                                            PARAM("gap", A_NUM, OPT, 0, WORLD, "px", "8", ""), TURNS, PATTERN };
static const struct api_param spiral[] = { NF, PARAM("step", A_NUM, REQ, -32767, 32767, "degrees", NULL, ""), EVERY,
                                           PARAM("arms", A_INT, OPT, 1, 65535, "bullets", "1", ""), PATTERN };
static const struct api_param aimed[] = { NF, EVERY, PARAM("lock", A_BOOL, OPT, 0, 0, NULL, "false", ""), PATTERN };
static const struct api_param points[] = { PARAM("list", A_TABLE, REQ, 0, 0, NULL, NULL, "") };
static const struct api_param point[] = { PARAM("x", A_NUM, OPT, -WORLD, WORLD, "px", NULL, ""),
                                          PARAM("y", A_NUM, OPT, -WORLD, WORLD, "px", NULL, ""),
                                          PARAM("over", A_INT, OPT, 1, 65535, "frames", NULL, ""),
                                          PARAM("ease", A_EASE, OPT, 0, 0, NULL, "linear", ""),
                                          PARAM("wait", A_INT, OPT, 0, 65535, "frames", NULL, "") };
static const struct api_param path_run[] = { PARAM("e", A_THING, REQ, 1 << H_ENEMY, 0, NULL, NULL, ""),
                                             PARAM("route", A_ROUTE, REQ, 0, 0, NULL, NULL, ""),
                                             PARAM("mirror", A_BOOL, OPT, 0, 0, NULL, "false", "") };
static const struct api_param bg_def[] = { NAME, PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, "") };
static const struct api_param stage_def[] = { NAME, PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, ""),
                                              PARAM("needs", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                              PARAM("music", A_TUNE, OPT, 0, 0, NULL, NULL, "") };
static const struct api_param stage_at[] = { PARAM("n", A_INT, REQ, 0, INT32_MAX, "frames", NULL, "") };
static const struct api_param wave[] = { PARAM("n", A_INT, REQ, 0, 4096, "enemies", NULL, ""),
                                         EVERY,
                                         PARAM("kind", A_ENEMY_KIND, REQ, 0, 0, NULL, NULL, ""),
                                         PARAM("path", A_ROUTE, REQ, 0, 0, NULL, NULL, ""),
                                         PARAM("mirror", A_BOOL, OPT, 0, 0, NULL, "false", ""),
                                         PARAM("dx", A_NUM, OPT, -WORLD, WORLD, "px", "0", ""),
                                         PARAM("dy", A_NUM, OPT, -WORLD, WORLD, "px", "0", ""),
                                         PARAM("run", A_FUNC, OPT, 0, 0, NULL, NULL, ""),
                                         PARAM("stay", A_BOOL, OPT, 0, 0, NULL, "false", ""),
                                         PARAM("hp", A_INT, OPT, 1, INT32_MAX, NULL, NULL, ""),
                                         PARAM("bank", A_INT, OPT, 0, 15, NULL, NULL, ""),
                                         PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                         PARAM("on_death", A_FUNC, OPT, 0, 0, NULL, NULL, ""),
                                         PARAM("drops", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                         PARAM("formation", A_ANY, OPT, 0, 0,
                                               "v, line, column, circle, or a list of { x, y }", NULL, ""),
                                         PARAM("gap", A_NUM, OPT, 0, WORLD, "px", "24", "") };
static const struct api_param limit_only[] = { LIMIT };
static const struct api_param name_only[] = { NAME };
static const struct api_param boss_def[] = { NAME,
                                             PARAM("title", A_STR, REQ, 0, 63, NULL, NULL, ""),
                                             PARAM("kind", A_ENEMY_KIND, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("x", A_NUM, OPT, -WORLD, WORLD, "px", NULL, ""),
                                             PARAM("y", A_NUM, OPT, -WORLD, WORLD, "px", NULL, ""),
                                             PARAM("phases", A_TABLE, REQ, 0, 0, NULL, NULL, ""),
                                             PARAM("cast", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("portrait", A_SPRITE, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("portrait_left", A_BOOL, OPT, 0, 0, NULL, "false", ""),
                                             PARAM("warning", A_INT, OPT, 0, 65535, "frames", "0", ""),
                                             PARAM("epithet", A_STR, OPT, 1, 63, NULL, NULL, ""),
                                             PARAM("entrance", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("bg", A_STR, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("music", A_TUNE, OPT, 0, 0, NULL, NULL, "") };
static const struct api_param boss_cast[] = { NAME,
                                              PARAM("title", A_STR, REQ, 0, 63, NULL, NULL, ""),
                                              PARAM("kind", A_ENEMY_KIND, REQ, 0, 0, NULL, NULL, ""),
                                              PARAM("x", A_NUM, REQ, -WORLD, WORLD, "px", NULL, ""),
                                              PARAM("y", A_NUM, REQ, -WORLD, WORLD, "px", NULL, ""),
                                              PARAM("portrait", A_SPRITE, OPT, 0, 0, NULL, NULL, ""),
                                              PARAM("portrait_left", A_BOOL, OPT, 0, 0, NULL, NULL, "") };
static const struct api_param boss_talk[] = { PARAM("talk", A_FUNC, REQ, 0, 0, NULL, NULL, "") };
static const struct api_param boss_fight[] = { NAME, PARAM("clock", A_BOOL, OPT, 0, 0, NULL, "false", "") };
static const struct api_param boss_history[] = { NAME, PARAM("id", A_STR, REQ, 1, 31, NULL, NULL, ""),
                                                 PARAM("difficulty", A_STR, OPT, 0, 0, NULL, NULL, ""),
                                                 PARAM("ship", A_PLAYER_KIND, OPT, 0, 0, NULL, NULL, "") };
static const struct api_param phase[] = { PARAM("id", A_STR, REQ, 1, 31, NULL, NULL, ""),
                                          PARAM("hp", A_ANY, OPT, 0, 0, "whole number, or { NAME = n }", NULL, ""),
                                          PARAM("time", A_INT, REQ, 1, INT32_MAX, "frames", NULL, ""),
                                          PARAM("run", A_ANY, OPT, 0, 0, "function, or { NAME = function }", NULL, ""),
                                          PARAM("spell", A_STR, OPT, 0, 127, NULL, NULL, ""),
                                          PARAM("bonus", A_INT, OPT, 0, INT32_MAX, "points", "0", ""),
                                          PARAM("bonus_to", A_INT, OPT, 0, INT32_MAX, "points", NULL, ""),
                                          PARAM("survive", A_BOOL, OPT, 0, 0, NULL, "false", ""),
                                          PARAM("last", A_BOOL, OPT, 0, 0, NULL, "false", ""),
                                          PARAM("safe", A_INT, OPT, 0, 65535, "frames", "0", ""),
                                          PARAM("armour", A_INT, OPT, 0, 65535, "frames", "0", ""),
                                          PARAM("rate", A_NUM, OPT, 0, 1, NULL, "0.25", ""),
                                          PARAM("down", A_DOWN, OPT, 0, 0, NULL, "all", ""),
                                          PARAM("cut_in", A_BOOL, OPT, 0, 0, NULL, NULL, ""),
                                          PARAM("portrait", A_SPRITE, OPT, 0, 0, NULL, NULL, ""),
                                          PARAM("portrait_left", A_BOOL, OPT, 0, 0, NULL, NULL, ""),
                                          PARAM("rest", A_INT, OPT, 0, 65535, "frames", "60", ""),
                                          PARAM("clear", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                          PARAM("drops", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                          PARAM("bg", A_STR, OPT, 0, 0, NULL, NULL, ""),
                                          PARAM("music", A_TUNE, OPT, 0, 0, NULL, NULL, "") };
static const struct api_param phase_clear[] = { PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, ""),
                                                PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "") };
static const struct api_param bg_show[] = { PARAM("name", A_STR, OPT, 0, 0, NULL, NULL, ""),
                                            PARAM("over", A_INT, OPT, 0, 65535, "frames", "30", "") };
static const struct api_param rule[] = { PARAM("on", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                         PARAM("name", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                         PARAM("kind", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                         PARAM("points", A_ANY, OPT, 0, 0, "whole number, or a register", NULL, ""),
                                         PARAM("times", A_ANY, OPT, 0, 0, "whole number, or a register", NULL, ""),
                                         PARAM("gain", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                         PARAM("most", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                         PARAM("set", A_TABLE, OPT, 0, 0, NULL, NULL, "") };
static const struct api_param count[] = { NAME, PARAM("n", A_INT, REQ, 0, INT32_MAX, NULL, NULL, ""),
                                          PARAM("p", A_PAD, OPT, 0, 0, NULL, "1", "") };
static const struct api_param tally[] = { PARAM("list", A_TABLE, REQ, 0, 0, NULL, NULL, "") };
static const struct api_param tally_line[] = {
    PARAM("label", A_STR, REQ, 1, 31, NULL, NULL, ""),
    PARAM("value", A_ANY, REQ, 0, 0, "property, register or function", NULL, ""),
    PARAM("points", A_INT, REQ, 0, 1e12, "points", NULL, ""), PARAM("stage", A_BOOL, OPT, 0, 0, NULL, "false", ""),
    PARAM("last", A_BOOL, OPT, 0, 0, NULL, "false", "")
};
#define UNLOCK_NAME PARAM("name", A_STR, REQ, 1, NV_KEY - 7, NULL, NULL /* kept under "unlock/NAME" */, "")
static const struct api_param unlock_def[] = { UNLOCK_NAME,
                                               PARAM("when", A_ANY, REQ, 0, 0, "conditions, or a function", NULL, ""),
                                               PARAM("title", A_STR, OPT, 1, 63, NULL, NULL, ""),
                                               PARAM("hint", A_STR, OPT, 1, 127, NULL, NULL, "") };
static const struct api_param unlock_when[] = { PARAM("clear", A_ANY, OPT, 0, 0, "true, or a stage", NULL, ""),
                                                PARAM("mode", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                                PARAM("difficulty", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                                PARAM("ship", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                                PARAM("continues", A_INT, OPT, 0, INT32_MAX, NULL, NULL, ""),
                                                PARAM("score", A_INT, OPT, 1, 1e12, "points", NULL, ""),
                                                PARAM("spell", A_STR, OPT, 1, 63, NULL, NULL, ""),
                                                PARAM("heard", A_TUNE, OPT, 0, 0, NULL, NULL, "") };
static const struct api_param unlock_has[] = { UNLOCK_NAME };
#define MISSION_NAME PARAM("name", A_STR, REQ, 1, NV_KEY - 8, NULL, NULL /* kept under "mission/NAME" */, "")
static const struct api_param mission_def[] = { MISSION_NAME,
                                                PARAM("title", A_STR, REQ, 1, 63, NULL, NULL, ""),
                                                PARAM("text", A_STR, OPT, 0, 127, NULL, NULL, ""),
                                                PARAM("stage", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                                PARAM("mark", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                                PARAM("to", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                                PARAM("boss", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                                PARAM("phase", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                                PARAM("ship", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                                PARAM("difficulty", A_STR, OPT, 1, 31, NULL, NULL, ""),
                                                PARAM("lives", A_INT, OPT, 1, 99, NULL, "1", ""),
                                                PARAM("registers", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                                PARAM("goal", A_ANY, OPT, 0, 0, "{ NAME = n, .. }, or a function", NULL,
                                                      ""),
                                                PARAM("clear", A_BOOL, OPT, 0, 0, NULL, "false", ""),
                                                PARAM("limit", A_INT, OPT, 1, INT32_MAX, "frames", NULL, ""),
                                                PARAM("bombs", A_INT, OPT, 0, 99, NULL, NULL, ""),
                                                PARAM("by", A_STR, OPT, 1, 31, NULL, "time", ""),
                                                PARAM("medals", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                                PARAM("needs", A_STR, OPT, 1, 31, NULL, NULL, "") };
static const struct api_param mission_best[] = { MISSION_NAME };
static const struct api_param boot_run[] = { PARAM("stages", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("players", A_TABLE, REQ, 0, 0, NULL, NULL, ""),
                                             PARAM("demo", A_STR, OPT, 1, 63, NULL, NULL, ""),
                                             PARAM("demos", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("modes", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("difficulties", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("ships", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("ending", A_ANY, OPT, 0, 0,
                                                   "function, or a list of { when, show, music }", NULL, ""),
                                             PARAM("opening", A_FUNC, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("staff", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("music", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("continues", A_INT, OPT, 1, 99, NULL, NULL, ""),
                                             PARAM("pages", A_TABLE, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("grades", A_FUNC, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("screens", A_TABLE, OPT, 0, 0, NULL, NULL, "") };
static const struct api_param boot_music[] = { PARAM("name", A_TUNE, REQ, 0, 0, NULL, NULL, ""),
                                               PARAM("title", A_STR, OPT, 0, 63, NULL, NULL, ""),
                                               PARAM("text", A_STR, OPT, 0, 127, NULL, NULL, ""),
                                               PARAM("needs", A_STR, OPT, 1, 31, NULL, NULL, "") };
static const struct api_param game_def[] = { PARAM("registers", A_TABLE, REQ, 0, 0, NULL, NULL, "") };
static const struct api_param talk_def[] = {
    PARAM("who", A_STR, REQ, 1, 31, NULL, NULL, ""),    PARAM("name", A_STR, REQ, 0, 63, NULL, NULL, ""),
    PARAM("faces", A_TABLE, OPT, 0, 0, NULL, NULL, ""), PARAM("side", A_STR, OPT, 0, 0, NULL, "left", ""),
    PARAM("bank", A_INT, OPT, 0, 15, NULL, "0", ""),    PARAM("voice", A_SOUND, OPT, 0, 0, NULL, NULL, "")
};
static const struct api_param talk_face[] = { PARAM("face", A_SPRITE, REQ, 0, 0, NULL, NULL, "") };
static const struct api_param talk_run[] = { PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, ""),
                                             PARAM("hold", A_STR, OPT, 0, 0, NULL, "fire", ""),
                                             PARAM("clear", A_BOOL, OPT, 0, 0, NULL, "true", ""),
                                             PARAM("skip", A_BOOL, OPT, 0, 0, NULL, "true", ""),
                                             PARAM("clock", A_BOOL, OPT, 0, 0, NULL, "false", "") };
static const struct api_param say[] = {
    PARAM("who", A_STR, OPT, 0, 0, NULL, NULL, ""),         PARAM("text", A_STR, REQ, 0, 4096, NULL, NULL, ""),
    PARAM("face", A_STR, OPT, 0, 0, NULL, NULL, ""),        PARAM("side", A_STR, OPT, 0, 0, NULL, NULL, ""),
    PARAM("letter", A_INT, OPT, 0, 600, "frames", "2", ""), LIMIT,
    PARAM("voice", A_SOUND, OPT, 0, 0, NULL, NULL, ""),
};
static const struct api_param choose[] = { PARAM("list", A_TABLE, REQ, 0, 0, NULL, NULL, ""),
                                           PARAM("title", A_STR, OPT, 0, 0, NULL, NULL, ""),
                                           PARAM("chosen", A_INT, OPT, 1, 99, NULL, "1", ""),
                                           PARAM("p", A_PAD, OPT, 0, 0, NULL, NULL, ""),
                                           LIMIT,
                                           PARAM("back", A_INT, OPT, 1, 99, NULL, NULL, "") };
static const struct api_param values[] = { PARAM("values", A_TABLE, REQ, 0, 0, NULL, NULL, "") };

#define LUA(name, params, plain, flags, returns, help)                                                                 \
    {                                                                                                                  \
        name, NULL, PARAMS(params), plain, API_LUA | (flags), returns, HELP(help)                                      \
    }
static const struct api_entry entries[] = {
    LUA("wait_until", wait_until, 2, API_GLOBAL, "boolean",
        "waits until f() is true, asked once a frame, first at once; false: the limit ran out"),
    { "wait_for", NULL, NULL, 0, 0, API_LUA | API_GLOBAL | API_MORE, NULL,
      HELP("waits until every given task has ended and every given thing is dead") },
    LUA("by_difficulty", values, 1, API_GLOBAL, "value",
        "the value for the difficulty being played, else the nearest easier one, else the easiest given; by their "
        "names, or a "
        "list from the easiest on"),
    LUA("pattern.ring", ring, 0, API_FIRE, NULL, "n bullets over the full circle, the first at dir"),
    LUA("pattern.fan", fan, 0, API_FIRE, NULL, "n bullets over spread degrees, centred on dir, both ends included"),
    LUA("pattern.arc", arc, 0, API_FIRE, NULL, "n bullets from dir through sweep, both ends included"),
    LUA("pattern.stack", stack, 0, API_FIRE, NULL, "n one behind the other, speeds from speed to speed_to"),
    LUA("pattern.line", line, 0, API_FIRE, NULL, "n abreast over width px, across dir"),
    LUA("pattern.polygon", polygon, 0, API_FIRE, NULL,
        "n over the outline of a polygon that grows, equally many a side; the corners have speed, the first at dir"),
    LUA("pattern.star", star, 0, API_FIRE, NULL,
        "as polygon, of a star: outer corners have speed, inner ones inner of it"),
    LUA("pattern.ellipse", ellipse, 0, API_FIRE, NULL,
        "n over an ellipse that grows: speed along dir + tilt, speed_to across; the first at dir"),
    LUA("pattern.rose", rose, 0, API_FIRE, NULL,
        "n over the full circle: speed at the tips of the petals, the first at dir, speed_to between two"),
    LUA("pattern.whip", whip, 0, API_FIRE, NULL, "a stack that bends: n from speed to speed_to, from dir through bend"),
    LUA("pattern.scatter", scatter, 0, API_FIRE, NULL,
        "n by chance, over spread degrees about dir, from speed to speed_to; draws two numbers of rng a bullet"),
    LUA("pattern.points", figure, 0, API_FIRE, NULL,
        "one from each { x, y } of list, px times scale from the place; turns: the list's +x is where they fly"),
    LUA("pattern.picture", picture, 0, API_FIRE, NULL,
        "rows of signs, gap px apart, centred on the place: a bullet from each but dots and blanks; turns as of "
        "points"),
    LUA("pattern.spiral", spiral, 0, API_FIRE, NULL,
        "n times: arms bullets about dir, then dir grows by step, then waits every; in a task"),
    LUA("pattern.aimed", aimed, 0, API_FIRE, NULL,
        "n at the player, shots at an enemy, one each every frames; in a task"),
    LUA("path.def", points, 1, API_LOAD, "route",
        "a route: a list of { x, y, over, ease } and { wait }; the first starts it"),
    LUA("path.def point", point, 0, API_SYS, NULL, "one entry of path.def"),
    LUA("path.run", path_run, 3, 0, NULL, "takes an enemy along a route; returns when it arrived"),
    LUA("spark.trail", trail, 0, 0, "task",
        "leaves a spark of that kind where a thing is, one each `every` frames: its after-images, until the task's "
        "owner "
        "or the thing goes"),
    LUA("stage.def", stage_def, 2, API_LOAD, NULL,
        "declares a stage: one task, plain code; needs: an unlock without which boot.run passes it over; music: plays "
        "from its beginning"),
    LUA("stage.at", stage_at, 1, 0, NULL,
        "waits for frame n of the stage's clock, which stands still during boss.fight"),
    LUA("stage.wave", wave, 0, 0, NULL,
        "n enemies along a path, one each every frames (0: all at once), each dx, dy further than the one before, or, "
        "with "
        "formation, at its place of \"v\", \"line\", \"column\" or \"circle\", neighbours gap apart, or of a list of { "
        "x, y }; returns at "
        "once; stay, hp, bank, tag, on_death, drops as of enemy.spawn"),
    LUA("stage.clear", limit_only, 1, 0, "boolean", "waits until no enemy is left; false: the limit ran out"),
    LUA("stage.mark", name_only, 1, 0, NULL, "a named moment, where --stage NAME:MARK starts"),
    { "stage.skipping", NULL, NULL, 0, 0, API_LUA, "boolean",
      HELP("is the stage being run through, to the mark it starts at?") },
    LUA("boss.def", boss_def, 1, API_LOAD, NULL,
        "declares a boss: phases = { { id, hp, time, run, ... }, ... }, with talks, { talk = f }, among them; cast = { "
        "{ name, title, kind, x, y }, ... } in place of kind, x and y: several at once; portrait: spells cut in with "
        "it, "
        "or a phase's; warning: frames of a WARNING round a card with epithet and title; entrance: sparks; "
        "music and bg: of the fight"),
    LUA("boss.def phase", phase, 0, API_SYS, NULL,
        "one phase of boss.def; drops = { NAME = n } of a phase that is beaten; safe, then armour frames at that rate "
        "of "
        "damage; bonus runs down to bonus_to, and a death or a bomb loses it; last: only if all before were beaten, "
        "and a "
        "hit ends it in place of a life; with a cast hp and run may be { NAME = value }, a bar and a task each, and "
        "down "
        "says whether all bars or any must be emptied; music: while it lasts"),
    LUA("boss.def cast", boss_cast, 0, API_SYS, NULL, "one of the cast of boss.def"),
    LUA("boss.def talk", boss_talk, 0, API_SYS, NULL, "a talk among the phases of boss.def: f(e), with the boss safe"),
    LUA("boss.def clear", phase_clear, 0, API_SYS, NULL,
        "what the bullets leave that are there at a phase's end; items if it is beaten"),
    LUA("boss.fight", boss_fight, 1, 0, "boolean",
        "flies in, fights all phases; true if every one was beaten; clock: the stage's goes on"),
    { "boss.now", NULL, NULL, 0, 0, API_LUA, "boss, id, frames",
      HELP("the names of the boss and of the phase that is fought, and how long it has been; nil: none is") },
    LUA("boss.history", boss_history, 2, 0, "tries, captures",
        "how often that spell was fought and captured, at the difficulty played or that one, with that ship or any"),
    LUA("bg.def", bg_def, 2, API_LOAD, NULL,
        "declares a background: a task that sets up layers and plane, which are all off when it begins"),
    LUA("bg.show", bg_show, 1, 0, NULL,
        "fades to black and to that background, which runs from the middle of the fade on; nil: to none"),
    LUA("score.rule", rule, 0, API_LOAD, NULL,
        "what a deed is worth: points, times a multiple; gain, most, set: of registers. on: graze, kill, take, death, "
        "bomb; name: one that score.count tells"),
    LUA("score.count", count, 3, 0, NULL, "n deeds of a rule's own name, by player p"),
    LUA("score.tally", tally, 1, API_LOAD, NULL, "what a stage brings at its end: { label, value, points }, .."),
    LUA("score.tally line", tally_line, 0, API_SYS, NULL,
        "value: a property, a register or f(p), a number, or true, or nil for no line; stage: since it began; last: "
        "after the "
        "last one alone"),
    LUA("unlock.def", unlock_def, 1, API_LOAD, NULL,
        "declares what can be earned; when: conditions, or f(run) at a run's end; kept under \"unlock/NAME\""),
    LUA("unlock.def when", unlock_when, 0, API_SYS, NULL,
        "all must hold: clear = true or a stage, at least that difficulty and score, at most so many continues, "
        "spell = \"boss/id\" captured, a piece of music heard"),
    LUA("unlock.has", unlock_has, 1, 0, "boolean", "has it been earned?"),
    LUA("mission.def", mission_def, 1, API_LOAD, NULL,
        "declares a short task: a part of a stage, from mark up to the mark to, or a boss or its phase; done when the "
        "goal's counts are reached, or if clear when the part was beaten too; no more than so many bombs, within "
        "limit; "
        "kept under \"mission/NAME\""),
    LUA("mission.best", mission_best, 1, 0, "value, stars, ship",
        "the best so far of what the mission measures, its stars and the ship; nil, 0: it was never done"),
    { "mission.stars", NULL, NULL, 0, 0, API_LUA, "got, most",
      HELP("the stars of all missions, and how many there are") },
    LUA("game.def", game_def, 0, API_LOAD, NULL,
        "declares the registers of a run, as those of player.def: then game.NAME; it reads stage, mode, continues and "
        "frames too"),
    LUA("talk.def", talk_def, 1, API_LOAD, NULL,
        "declares who talks: the name that is shown, and faces = { calm = SPRITE, .. }; a face stands on the box; "
        "voice: a sound that goes with the letters"),
    LUA("talk.def face", talk_face, 1, API_SYS, NULL, "one face of talk.def"),
    LUA("talk.run", talk_run, 1, 0, NULL,
        "calls f(), in which say and choose share one box: the stage's clock stands, players do not fire; special held "
        "skips all of it, and a stage on its way to a mark does not call f"),
    LUA("say", say, 2, API_GLOBAL, NULL,
        "who, or nobody (nil), says it; returns when a player presses fire, which first shows all letters at once"),
    LUA("choose", choose, 1, API_GLOBAL, "number",
        "shows a list, returns the number chosen with up, down and fire; `chosen` where the talk is skipped"),
    LUA("boot.run", boot_run, 0, 0, NULL,
        "title, attract, game, name entry; the last line of main.lua; music = { SCREEN = piece, .. }, and room = true "
        "or a "
        "list of pieces: the music room"),
    LUA("boot.run music", boot_music, 0, API_SYS, NULL, "one piece of boot.run's music"),
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

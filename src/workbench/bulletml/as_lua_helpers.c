/*
 * as_lua_helpers.c - helper functions for scripts. A script contains only those that it calls; each may call those
 * before it.
 *
 * `o` is the state of a bullet, or of the entity that runs the document: me (the handle), dir and speed (as the
 * document defines them), pending changes. `s` is the state of a list of commands: o, and the direction and speed of
 * the last shot.
 */
#include "as_lua_parts.h"

#include <string.h>

static const struct {
    const char *name, *text;
} helpers[] = {
    { "count", "-- A number of frames or repeats, rounded down.\n"
               "local function count(v, least)\n"
               "  return math.max(least, math.floor(math.min(v + 0.000001, 1000000000)))\n"
               "end\n" },
    { "fly", "-- Moves with dir and speed plus x and y, the velocity from accel.\n"
             "local function fly(o)\n"
             "  local x = angle.cos(o.dir) * o.speed + (o.x or 0)\n"
             "  local y = angle.sin(o.dir) * o.speed + (o.y or 0)\n"
             "  if o.root then\n"
             "    o.me:shift(x * unit, y * unit)\n"
             "  else\n"
             "    o.me.vx, o.me.vy = x * unit, y * unit\n"
             "  end\n"
             "end\n" },
    { "fly_straight", "local function fly_straight(o)\n"
                      "  if o.root then\n"
                      "    local v = o.speed * unit\n"
                      "    o.me:shift(angle.cos(o.dir) * v, angle.sin(o.dir) * v)\n"
                      "  else\n"
                      "    o.me.dir, o.me.speed = o.dir, o.speed * unit\n"
                      "  end\n"
                      "end\n" },
    { "update", "-- Updates the values that change in this frame.\n"
                "local function update(o)\n"
                "  local now = board.frame()\n"
                "  for _, name in ipairs { \"dir\", \"speed\", \"x\", \"y\" } do\n"
                "    local c = o[name .. \"_to\"]\n"
                "    if c and now > c.start then\n"
                "      local share = math.min((now - c.start) / c.over, 1)\n"
                "      o[name] = c.from + (c.to - c.from) * share\n"
                "      if share == 1 then o[name .. \"_to\"] = nil end\n"
                "    end\n"
                "  end\n"
                "end\n" },
    { "change", "-- Changes a value linearly over some frames; all changes run at the same time.\n"
                "local function change(o, name, to, over)\n"
                "  update(o)\n"
                "  o[name .. \"_to\"] = { from = o[name] or 0, to = to, over = over, start = board.frame() }\n"
                "  if o.driven then return end\n"
                "  o.driven = true\n"
                "  task.own(o.me, function()\n"
                "    while o.root or o.dir_to or o.speed_to or o.x_to or o.y_to do\n"
                "      wait(1)\n"
                "      update(o)\n"
                "      FLY(o)\n"
                "    end\n"
                "    o.driven = false\n"
                "  end)\n"
                "end\n" },
    { "pause",
      "-- Waits n frames. A bullet that vanishes is removed, with its tasks, after its commands for that frame.\n"
      "local function pause(s, n)\n"
      "  if n > 0 and s.o.gone and not s.o.root then s.o.me:remove() end\n"
      "  wait(n)\n"
      "UPDATE"
      "end\n" },
    { "straight",
      "-- Directions and speeds for a shot or a change. They are stored because a sequence starts from the last one.\n"
      "local function straight(s, v)\n"
      "  s.dir = v\n"
      "  return v\n"
      "end\n" },
    { "aimed", "local function aimed(s, v)\n"
               "  local p = player.nearest(s.o.me.x, s.o.me.y)\n"
               "  s.dir = (p and angle.to(s.o.me, p) or 90) + v\n"
               "  return s.dir\n"
               "end\n" },
    { "turned", "local function turned(s, v)\n"
                "  s.dir = s.o.dir + v\n"
                "  return s.dir\n"
                "end\n" },
    { "next_dir", "local function next_dir(s, v)\n"
                  "  if not s.dir then return aimed(s, 0) end\n"
                  "  s.dir = s.dir + v\n"
                  "  return s.dir\n"
                  "end\n" },
    { "plain", "local function plain(s, v)\n"
               "  s.speed = v\n"
               "  return v\n"
               "end\n" },
    { "faster", "local function faster(s, v)\n"
                "  s.speed = s.o.speed + v\n"
                "  return s.speed\n"
                "end\n" },
    { "next_speed", "local function next_speed(s, v)\n"
                    "  s.speed = s.speed and s.speed + v or 1\n"
                    "  return s.speed\n"
                    "end\n" },
    { "turn_to", "-- Turns the shorter way round.\n"
                 "local function turn_to(s, dir, over)\n"
                 "  change(s.o, \"dir\", s.o.dir + angle.difference(s.o.dir, dir), over)\n"
                 "end\n" },
    { "turn_on", "local function turn_on(s, v, over)\n"
                 "  change(s.o, \"dir\", s.o.dir + v * over, over)\n"
                 "end\n" },
    { "speed_to", "local function speed_to(s, v, over)\n"
                  "  change(s.o, \"speed\", v, over)\n"
                  "end\n" },
    { "speed_on", "local function speed_on(s, v, over)\n"
                  "  change(s.o, \"speed\", s.o.speed + v * over, over)\n"
                  "end\n" },
    { "push_to", "local function push_to(s, name, v, over)\n"
                 "  change(s.o, name, v, over)\n"
                 "end\n" },
    { "push_on", "local function push_on(s, name, v, over)\n"
                 "  change(s.o, name, (s.o[name] or 0) + v, over)\n"
                 "end\n" },
    { "launch", "-- Fires a shot: dir, speed, label, motion, and run, the function of the bullet's task.\n"
                "local function launch(s, shot)\n"
                "  local dir, speed = shot.dir or aimed(s, 0), shot.speed or plain(s, 1)\n"
                "  local b = bullet.fire { kind = kinds[shot.label] or kind, from = s.o.me, dir = dir,\n"
                "                          speed = speed * unit, motion = shot.motion }\n"
                "  if shot.run then\n"
                "    task.own(b, function()\n"
                "      local o = { me = b, dir = dir, speed = speed }\n"
                "      shot.run { o = o }\n"
                "      if o.gone then b:remove() end\n"
                "    end)\n"
                "  end\n"
                "end\n" },
};

enum { HELPERS = sizeof helpers / sizeof *helpers };

static bool calls(const char *text, const char *name)
{
    const size_t n = strlen(name);

    for (const char *at = text; (at = strstr(at, name)) != NULL; at += n)
        if (at[n] == '(' && (at == text || !strchr("_abcdefghijklmnopqrstuvwxyz", at[-1])))
            return true;
    return false;
}

/* Writes a helper; two of them have variants. */
static void put_helper(struct byte_buffer *t, int i, bool pushes, bool changes)
{
    const char *at = strstr(helpers[i].text, "FLY"), *update = strstr(helpers[i].text, "UPDATE");

    if (at)
        byte_buffer_print(t, "%.*s%s%s\n", (int)(at - helpers[i].text), helpers[i].text,
                          pushes ? "fly" : "fly_straight", at + 3);
    else if (update)
        byte_buffer_print(t, "%.*s%s%s\n", (int)(update - helpers[i].text), helpers[i].text,
                          changes ? "  update(s.o)\n" : "", update + 6);
    else
        byte_buffer_print(t, "%s\n", helpers[i].text);
}

void as_lua_helpers(struct byte_buffer *t, const char *body)
{
    const bool pushes = calls(body, "push_to") || calls(body, "push_on");
    bool used[HELPERS] = { 0 }, changes = false;

    for (int i = HELPERS - 1; i >= 0; i--) {
        used[i] = calls(body, helpers[i].name);
        for (int k = i + 1; k < HELPERS; k++)
            used[i] |= used[k] && calls(helpers[k].text, helpers[i].name);
        changes |= used[i] && strcmp(helpers[i].name, "change") == 0;
        if (strcmp(helpers[i].name, "fly") == 0)
            used[i] = changes && pushes;
        else if (strcmp(helpers[i].name, "fly_straight") == 0)
            used[i] = changes && !pushes;
    }
    for (int i = 0; i < HELPERS; i++)
        if (used[i])
            put_helper(t, i, pushes, changes);
}

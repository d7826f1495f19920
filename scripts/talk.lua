-- talk.lua - dialogue: who talks, and talk.run, say and choose. What a talk looks like is the piece talk/box, which is
-- read when one begins.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local talk = {}

-- How all talks of the game look: share of black over the picture; bank of the plates; font of the words, one of
-- rom.lua's, nil: the cells'.
talk.look = { dim = 0.45, bank = 0 }

local LINE = 240 -- characters of a line of text in a font
local HOLDS = { none = 0, fire = 1, all = 2 } -- as sys.hold_players counts them

local talkers, names = {}, {} -- who -> definition; in the order they were declared
local now -- the talk that runs: its box, and task, which may be stopped at any time
local fire = {} -- player -> frames fire is held since it was pressed in a talk: what was held before shot at somebody;
                -- seen, the clock when that was counted

local function expect_word(api, what, word, words, list)
  for _, known in ipairs(words) do
    if known == word then return end
  end
  local near = sys.near(word, words)
  sys.fail(api, ('%s: expected %s, got "%s"%s'):format(what, list, word, near and (' (did you mean "%s"?)'):format(near) or ""))
end

local function expect_side(api, side)
  if side then expect_word(api, "side", side, { "left", "right" }, "left or right") end
end

function talk.def(who, def)
  local a, list = sys.check("talk.def", who, def), {}
  if talkers[a.who] then sys.fail("talk.def", ('"%s" is declared twice'):format(a.who)) end
  expect_side("talk.def", a.side)
  for _, face in ipairs(sys.keys(a.faces or {})) do
    if type(face) ~= "string" then sys.fail("talk.def", "faces: expected names as keys, as in { calm = SPRITE }") end
    sys.check("talk.def face", a.faces[face])
    list[#list + 1] = face
  end
  a.list, a.face = list, a.faces and (a.faces.calm and "calm" or list[1])
  talkers[a.who] = a
  names[#names + 1] = a.who
end

-- For <close>: calls f when the block ends, or the task does.
local function at_end(f) return setmetatable({}, { __close = f }) end

local function passed() return stage.skipping() or sys.skipping() end

local function begin(a)
  if not sys.task() then sys.fail("talk.run", "only a task can talk; start one with task.go") end
  if now and task.alive(now.task) then
    sys.fail("talk.run", "a talk is already running; call `say` and `choose` in it (a phase { talk = f } runs f as a talk)")
  end
  local t = sys.read("talk/box")(talk.look, a.skip, fire)
  t.task = sys.task()
  sys.hold_players(HOLDS[a.hold])
  t.hold = HOLDS[a.hold]
  now = t
  return t
end

local function finish(t)
  t.close(now == t)
  if now ~= t then return end -- another talk began since the task of this one was stopped
  now = nil
  sys.hold_players(0)
end

local function run(f, a)
  if passed() then return sys.pass() end
  local t = begin(a)
  local box <close> = at_end(function() finish(t) end)
  local s = not a.clock and stage.stop_clock()
  local clock <close> = at_end(function() if s then stage.start_clock(s) end end)
  if a.clear then bullet.clear { all = true } end
  f()
  if t.skipped then sys.skip(false) end
end

function talk.run(f, args)
  local a = sys.check("talk.run", f, args)
  expect_word("talk.run", "hold", a.hold, { "fire", "all", "none" }, "fire, all or none")
  run(a.f, a)
end

sys.talk = talk.run -- for boss/talk.lua, which must not name the module

-- f(box) in the talk that runs, or in one of its own.
local function within(f)
  if passed() then
    sys.pass()
    return false
  end
  if now and task.alive(now.task) then return true, f(now) end
  local answer
  run(function() answer = f(now) end, { hold = "fire", clear = true, skip = true })
  return true, answer
end

-- say and choose: say.lua and choose.lua hand them out.

function sys.say(who, words, args)
  if words == nil and type(who) == "string" and not talkers[who] then
    sys.fail("say", ("expected a speaker and a text; for no speaker, write say(nil, \"%s\")"):format(who))
  end
  local a = sys.check("say", who, words, args)
  local talker = a.who and talkers[a.who]
  if a.who and not talker then sys.unknown("say", "speaker", a.who, names) end
  if a.face and not (talker and talker.faces and talker.faces[a.face]) then
    sys.unknown("say", ('"%s": face'):format(a.who or "nobody"), a.face, talker and talker.list or {})
  end
  expect_side("say", a.side)
  local said = text.lang(a.text)
  if talk.look.font and sys.cells(said) > LINE then
    sys.fail("say", ("text: with a font, expected at most %d characters, got %d"):format(LINE, sys.cells(said)))
  end
  within(function(t) t.say(talker, said, a) end)
end

function sys.choose(list, args)
  if type(list) ~= "table" then sys.fail("choose", 'list: expected a list of strings, as in choose { "Yes", "No" }') end
  local a, items = sys.check("choose", list, args), {}
  for _, key in ipairs(sys.keys(a.list)) do
    if math.type(key) ~= "integer" then
      sys.fail("choose", ('list: expected strings, got the key "%s"; options go in a second table'):format(tostring(key)))
    end
  end
  if #a.list == 0 then sys.fail("choose", "list: expected at least one string") end
  for i, item in ipairs(a.list) do
    if type(item) ~= "string" then sys.fail("choose", ("list: entry %d: expected a string, got a %s"):format(i, type(item))) end
    items[i] = text.lang(item)
  end
  for _, key in ipairs { "chosen", "back" } do
    if a[key] and a[key] > #items then
      sys.fail("choose", ("%s: expected a number from 1 to %d, got %d"):format(key, #items, a[key]))
    end
  end
  a.title = a.title and text.lang(a.title)
  local shown, answer = within(function(t) return t.choose(items, a) end)
  return shown and answer or a.chosen
end

return talk

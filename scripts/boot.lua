-- boot.lua - a game from the title to the score table: attract demo, choices, stages, results, name entry.
--
-- boot.run starts one task. The screens are in screens/, the way to a game in boot/front.lua, what follows a game in
-- boot/after.lua. This file has what is needed during a game.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local boot = {}

local RESULT <const> = 75 -- frames that the result of a practised section is shown

local screens = {} -- the game's own screens, by name
local entries = {} -- the game's own entries in the pause menu, { label, function } each
local over, left   -- all players are out; how the game was left: "restart", "quit" or nil
local obey         -- does what the pause menu asks for in this frame

on.game_over(function() over = true end)

-- Returns the name of a score table: that of the difficulty, for all modes but the first after the mode's name.
function sys.score_table(difficulty, mode)
  local modes = rawget(sys, "modes")
  if not mode or mode == (modes and modes[1].name) then return difficulty end
  return mode .. "/" .. difficulty
end

-- Shows the game's own screen with that name, or the library's.
local function show(name, ...) return (screens[name] or sys.read("screens/" .. name))(...) end

-- Hides sprites, lines of text, and plates with their text, which would cover a window. Returns the list of them.
local function set_aside()
  local plates, list = sys.covers()
  for _, s in ipairs(plates) do
    local col, row = s.x // 8 | 0, s.y // 8 | 0
    text.clear { col = col, row = row, w = ((s.x + s.w) // 8 | 0) - col + 1, h = ((s.y + s.h) // 8 | 0) - row + 1 }
    list[#list + 1] = s
  end
  for _, s in ipairs(list) do s.hidden = true end
  return list
end

-- Freezes the board, calls f, which shows a screen, and then restores the text on the screen. A frozen board runs only
-- the tasks of one scope, so the screen gets a scope of its own.
local function freeze_for(f)
  local scope, written, aside = sys.scope(), sys.keep_text(), {}
  local function close()
    sys.freeze() -- without a scope: all tasks run again
    sys.text_back(written)
    for _, s in ipairs(aside) do s.hidden = false end
    task.stop(scope)
  end
  local shown = task.own(scope, function()
    aside = set_aside()
    screen.flash { over = 1, share = 0 } -- would last as long as the board is frozen
    f()
    close()
  end)
  if not task.alive(shown) then return task.stop(scope) end -- no free task, so nothing could unfreeze the board
  task.own(scope, function()
    repeat
      wait(1)
      obey()
    until left
    close()
  end)
  sys.freeze(scope)
end

-- Makes the program's pause menu part of this game: it can restart or leave it, or choose one of the game's entries.
local function listen(game)
  local labels = {}
  for i, entry in ipairs(entries) do labels[i] = text.lang(entry[1]) end
  sys.listen(labels)
  function obey()
    local code = sys.code(1)
    if code == "restart" or code == "quit" then left = code end
    if entries[code] then task.own(game, entries[code][2]) end
  end
  task.own(game, function()
    while true do
      wait(1)
      obey()
    end
  end)
end

-- Clears the field and the screen and brings the players in. continues: how often each player may continue, or nil.
-- Returns the scope that owns all tasks of this game.
local function enter(ships, continues)
  sys.wipe()
  over, left = false, nil
  for p, kind in ipairs(ships) do sys.join(p, kind) end
  local game = sys.scope()
  sys.start(game)
  hud.start(game, #ships, sys.score_table(board.difficulty(), rawget(sys, "mode")))
  if continues or #ships > 1 then sys.read("boot/continue")(game, #ships, continues or 0, freeze_for, screens.continue) end
  listen(game)
  return game
end

-- Ends the run: the program's pause menu no longer belongs to it. done: everything was cleared; reached: the number of
-- stages cleared.
local function finish(done, reached)
  sys.listen()
  sys.mark("over", done and "clear" or left and "quit" or "over", nil, nil, reached)
end

local function leave(game, players)
  sys.listen()
  task.stop(game)
  sys.wipe()
  for p = 1, players do sys.leave(p) end
end

local function stopped() return over or left end

-- Waits until the scope `part` ends, or the game does: all players are out, or it was left. Returns true if the scope
-- ended first.
local function finished(part)
  wait_until(function() return stopped() or not task.alive(part) end)
  return not stopped()
end

-- Shows a line after the game in large letters, unless the player left it. Fire shortens it after a third of a second.
local function show_end(line)
  if left then return end
  hud.banner({ line }, 180, nil, 2)
  for age = 1, 180 do
    wait(1)
    local pressed = pad.take("fire", 0, 1) or pad.take("fire", 0, 2)
    if pressed and age > 20 then break end
  end
  hud.banner()
end

-- Removes what would still move behind the results, and hides sprites that would cover them.
local function quieten()
  set_aside()
  bullet.clear { all = true }
  enemy.each(nil, function(e) e:remove() end)
end

-- Records of a run. Loaded at each use, because they take Lua memory and are needed only between stages.
local function records() return sys.read("boot/records") end

local function play_stages(game, run)
  local i = records().next(run, 0)
  while i do
    local title = text.lang("Stage %s"):format(menu.label(run.stages[i]))
    hud.banner({ title:upper() }, 150)
    if not finished(stage.play(run.stages[i], game)) then return end
    quieten()
    hud.banner()
    show("results", text.lang("%s Clear"):format(title), #run.ships, stopped, records().stage(run, i))
    if stopped() then return end
    i = records().next(run, i)
    if i then
      sys.wipe()
      hud.refresh()
    end
  end
end

-- run: mode, stages and ships to play; the results are added to it. Returns whether to play it again.
local function play(a, run)
  local ships = run.ships
  sys.mode = run.mode -- game.mode
  local game = enter(ships, a.continues)
  sys.mark("game", ships[1], nil, nil, #ships)
  sys.mark("difficulty", board.difficulty())
  records().begin(run)
  run.grades = a.grades
  play_stages(game, run)
  run.grades = nil
  run.clear = not stopped()
  finish(run.clear, run.reached)
  local new = left and {} or records().over(run)
  local jingle = screens[run.clear and "clear" or "over"]
  if jingle and not left then jingle() end
  show_end(run.clear and "ALL STAGES CLEAR" or "GAME OVER")
  for _, title in ipairs(new) do show_end(text.lang("Unlocked: %s"):format(title)) end
  leave(game, #ships)
  if left then return left == "restart" end
  sys.read("boot/after")(a, show, run)
  return show("again", run) == true
end

-- The functions of this file that boot/mission.lua needs.
local host = {
  enter = enter, finish = finish, leave = leave, show = show, quieten = quieten, stopped = stopped,
  left = function() return left end,
}

-- Plays one game after the other, each from the title.
local function play_games(a)
  local first, from = board.difficulty(), nil
  while true do
    local run = sys.read("boot/front")(a, show, from)
    if run.mission then
      sys.mode = nil
      sys.read("boot/mission")(run, host)
    else
      repeat local again = play(a, run) until not again
    end
    from = run.mission
    board.difficulty(first)
  end
end

-- Plays the section of a practice start with one ship, again and again, without a title. Says how each attempt ended.
local function practise(a, start, kind)
  while true do
    local game, won, began = enter({ kind }), true, sys.clock()
    local cleared = finished(start(game, function(is_won) won = is_won end)) and won
    local time = sys.read("menu/page").amount("time", sys.clock() - began)
    if not left then
      wait(1) -- the verdict on the last phase comes first
      hud.banner(cleared and { "CLEARED", time } or { "FAILED" }, RESULT)
      wait(RESULT)
    end
    leave(game, 1)
  end
end

function boot.run(args)
  local a, practice, with = sys.read("boot/args")(args), sys.practice()
  screens, entries = a.screens or screens, a.pause or entries
  sys.modes = a.modes
  if practice == "" then return task.go(play_games, a) end
  a.with = with
  local start, kind = sys.read("boot/practice")(a, practice)
  if start then return task.go(practise, a, start, kind) end
  task.go(sys.read("boot/list"), a, enter, leave) -- the program asks for the list of sections
end

return boot

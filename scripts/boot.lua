-- boot.lua - from power-on to the score table and round again: title, attract, choices, game, results, name entry.
-- boot.run starts one task. What is seen before, between and after is in pieces: the screens in screens/, the way there
-- in boot/front.lua and boot/after.lua; here is what stays while a game is played.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local boot = {}

-- Items of the pause menu.
local PLAYED, PRACTISED = { "RESUME", "RESTART", "SETTINGS", "QUIT TO TITLE" }, { "RESUME", "RETRY", "SETTINGS" }

local screens = {} -- a game's own, by name
local over, left   -- the last player is out; the item of the pause menu by which this game is left

on.game_over(function() over = true end)

-- Shows a screen, the game's own or else the library's.
local function show(name, ...) return (screens[name] or sys.read("screens/" .. name))(...) end

-- Hides what would be drawn over a screen's window, a plate with the text on it. Returns the list of it.
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

-- Calls f, a screen, while the game stands, and puts back all text that stood there. A frozen board gives turns to the
-- tasks of one scope alone; the screen gets a scope of its own, so that none of the game's tasks run.
local function stand(f)
  local screen, written, aside = sys.scope(), sys.keep_text(), nil
  local menu_task = task.own(screen, function()
    aside = set_aside()
    f()
    sys.freeze() -- without a scope: all go on
    sys.text_back(written)
    for _, s in ipairs(aside) do s.hidden = false end
    task.stop(screen)
  end)
  if not task.alive(menu_task) then return task.stop(screen) end -- no room for it, and nobody would unfreeze the board
  sys.freeze(screen)
end

local function pause(p, items)
  stand(function()
    sys.cue("pause")
    local i = show("pause", p, items)
    while items[i] == "SETTINGS" do
      board.ask("settings")
      i = show("pause", p, items, i)
    end
    if i ~= 1 then left = items[i] end
  end)
end

local function watch_pause(_, players, items)
  while true do
    wait(1)
    for p = 1, players do
      if not over and pad.take("start", 0, p) then
        pause(p, items)
        break
      end
    end
  end
end

-- Empties field and screen and brings the players in. practised: it is a try of practice; continues: how often each may
-- go on, or nil. Returns the scope that owns all tasks of this game.
local function enter(ships, practised, continues)
  sys.wipe()
  over, left = false, nil
  for p, kind in ipairs(ships) do sys.join(p, kind) end
  local game = sys.scope()
  sys.start(game)
  hud.start(game, #ships)
  if continues then sys.read("boot/continue")(game, #ships, continues, stand, screens.continue) end
  task.own(game, watch_pause, #ships, practised and PRACTISED or PLAYED)
  return game
end

local function leave(game, players)
  task.stop(game)
  sys.wipe()
  for p = 1, players do sys.leave(p) end
end

local function stopped() return over or left end

-- Waits until the scope `part` is over, or the game is: all players are out, or it was left. True for the first.
local function finished(part)
  wait_until(function() return stopped() or not task.alive(part) end)
  return not stopped()
end

-- Shows the game's last line, unless it was ended from the pause menu.
local function last_words(line)
  if left then return end
  hud.banner({ line }, 180)
  wait_until(function() return left end, 180)
end

-- Removes what would go on moving over the results. Sprites stay, but for those that would cover the results: they are
-- the picture behind them.
local function quieten()
  set_aside()
  bullet.clear { all = true }
  enemy.each(nil, function(e) e:remove() end)
end

-- What a run leaves behind; read anew each time, as it is wanted between stages alone.
local function records() return sys.read("boot/records") end

local function play_stages(game, run)
  local i = records().next(run, 0)
  while i do
    local title = text.lang("STAGE %s"):format(menu.label(run.stages[i]))
    hud.banner({ title }, 150)
    if not finished(stage.play(run.stages[i], game)) then return end
    quieten()
    hud.banner()
    show("results", text.lang("%s CLEAR"):format(title), #run.ships, stopped, records().stage(run, i))
    if stopped() then return end
    i = records().next(run, i)
    if i then
      sys.wipe()
      hud.refresh()
    end
  end
end

-- run: what is to be played, mode, stages and ships; gets what became of it.
local function play(a, run)
  local ships = run.ships
  sys.mode = run.mode -- game.mode
  local game = enter(ships, false, a.continues)
  sys.mark("game", ships[1], nil, nil, #ships)
  records().begin(run)
  run.grades = a.grades
  play_stages(game, run)
  run.grades = nil
  run.clear = not stopped()
  sys.mark("over", run.clear and "clear" or left and "quit" or "over", nil, nil, run.reached)
  local new = left and {} or records().over(run)
  local jingle = screens[run.clear and "clear" or "over"]
  if jingle and not left then jingle() end
  last_words(run.clear and "ALL STAGES CLEAR" or "GAME OVER")
  for _, title in ipairs(new) do last_words(text.lang("UNLOCKED: %s"):format(title)) end
  leave(game, #ships)
  if not left then sys.read("boot/after")(a, show, run) end
end

-- What a mission's task needs of this file.
local host = {
  enter = enter, leave = leave, show = show, quieten = quieten, stopped = stopped,
  left = function() return left end,
}

local function go_round(a)
  local first, from = board.difficulty(), nil
  while true do
    local run = sys.read("boot/front")(a, show, from)
    if run.mission then
      sys.mode = nil
      sys.read("boot/mission")(run, host)
    else
      repeat play(a, run) until left ~= "RESTART"
    end
    from = run.mission
    board.difficulty(first)
  end
end

-- A practice start: no title, one ship, the same piece again and again.
local function practise(a, start, kind)
  while true do
    local game = enter({ kind }, true)
    finished(start(game))
    leave(game, 1)
  end
end

function boot.run(args)
  local a, practice, with = sys.read("boot/args")(args), sys.practice()
  screens = a.screens or screens
  if practice == "" then return task.go(go_round, a) end
  a.with = with
  local start, kind = sys.read("boot/practice")(a, practice)
  if start then return task.go(practise, a, start, kind) end
  task.go(sys.read("boot/list"), a, enter, leave) -- the cabinet asks what there is
end

return boot

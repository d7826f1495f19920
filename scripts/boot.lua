-- boot.lua - from power-on to the score table and round again: title, attract, choices, game, results, name entry.
-- boot.run starts one task; the screens are menu.lua's and hud.lua's.
local sys = ...
local boot = {}

local ATTRACT = 10 * 60 -- frames the title waits before it shows the demo
local SCORES = 6 * 60   -- frames the score table stands by itself

local over, quit -- the last player is out; the pause menu's other item was chosen

on.game_over(function() over = true end)

-- A frozen board gives turns to the pause screen alone. The scope is its own: the game's tasks must not run.
local function pause(p, other)
  local screen = sys.scope()
  task.own(screen, function()
    quit = menu.pause(p, other) == 2
    sys.freeze()
    hud.refresh()
    task.stop(screen)
  end)
  sys.freeze(screen)
end

local function watch_pause(_, players, other)
  while true do
    wait(1) -- first of all: the press that chose the game is not meant for it
    for p = 1, players do
      if not over and pad.pressed("start", p) then
        pause(p, other)
        break
      end
    end
  end
end

-- Brings the players in, clean field and screen; returns the scope that holds all of this game.
local function enter(ships, other)
  sys.wipe()
  over, quit = false, false
  for p, kind in ipairs(ships) do sys.join(p, kind) end
  local game = sys.scope()
  hud.start(game, #ships)
  task.own(game, watch_pause, #ships, other)
  return game
end

local function leave(game, players)
  task.stop(game)
  sys.wipe()
  for p = 1, players do sys.leave(p) end
end

local function stopped() return over or quit end

-- Until the part is over by itself, or the players are, or they had enough. True for the first.
local function finished(part)
  wait_until(function() return stopped() or not task.alive(part) end)
  return not stopped()
end

local function last_words(line)
  if quit then return end
  hud.banner({ line }, 180)
  wait_until(function() return quit end, 180)
end

-- True if all stages were cleared.
local function play_stages(game, stages, players)
  for i, name in ipairs(stages) do
    local title = "STAGE " .. menu.label(name)
    hud.banner({ title }, 150)
    if not finished(stage.play(name, game)) then return false end
    bullet.clear()
    menu.results(title .. " CLEAR", players, stopped)
    if stopped() then return false end
    if i < #stages then
      sys.wipe()
      hud.refresh()
    end
  end
  return true
end

-- Everybody whose score is among the best enters a name, then sees it in the table.
local function enter_names(scores)
  local name = board.difficulty()
  for p, points in ipairs(scores) do
    local rank = menu.rank(name, points)
    if rank then
      score.enter(name, { name = menu.name(p, points), score = points })
      menu.scores(name, SCORES, rank)
    end
  end
end

local function game(a, ships)
  local scope, scores = enter(ships, "QUIT"), {}
  local all = play_stages(scope, a.stages, #ships)
  last_words(all and "ALL STAGES CLEAR" or "GAME OVER")
  for p = 1, #ships do scores[p] = hud.score(p) end
  leave(scope, #ships)
  if not quit then enter_names(scores) end
end

-- The choices before a game, as few as there are; sets the difficulty. Returns each player's ship, or nil for back.
local function choose(a)
  local count, ships, names = 1, {}, sys.difficulties()
  if sys.players() > 1 then count = menu.players() end
  if not count then return nil end
  for p = 1, count do
    ships[p] = #a.players == 1 and a.players[1] or menu.ship(p, a.players, count > 1)
    if not ships[p] then return nil end
  end
  if #names > 1 then
    local name = menu.difficulty(names, board.difficulty())
    if not name then return nil end
    board.difficulty(name)
  end
  return ships
end

local function front(a)
  local first = board.difficulty()
  while true do
    if menu.title(ATTRACT) then
      local ships = choose(a)
      if ships then game(a, ships) end
      board.difficulty(first)
    else
      if a.demo then
        board.attract(a.demo)
        wait(1)
      end
      menu.scores(first, SCORES)
    end
  end
end

-- What `--stage` asks for, as a function that starts it in a scope; names are checked while the game loads.
local function part(practice)
  local name, phase = practice:match("^([^/]*)/(.*)$")
  if name then
    local fight = boss.practice("boot.run", name, phase)
    return function(owner)
      local scope = task.scope(owner)
      task.own(scope, function()
        fight()
        task.stop(scope)
      end)
      return scope
    end
  end
  local stage_name, mark = practice:match("^([^:]*):(.*)$")
  stage_name = stage_name or practice
  stage.expect("boot.run", stage_name)
  return function(owner) return stage.play(stage_name, owner, mark) end
end

-- A practice start: no title, first ship, the same piece again and again.
local function practise(a, start)
  while true do
    local scope = enter({ a.players[1] }, "AGAIN")
    finished(start(scope))
    leave(scope, 1)
  end
end

function boot.run(args)
  local a, kinds = sys.check("boot.run", args), sys.kinds("player")
  local known = {}
  for _, kind in ipairs(kinds) do known[kind] = true end
  for _, kind in ipairs(a.players) do
    if not known[kind] then sys.unknown("boot.run", "player", tostring(kind), kinds) end
  end
  for _, name in ipairs(a.stages) do stage.expect("boot.run", tostring(name)) end
  if #a.players == 0 or #a.stages == 0 then sys.fail("boot.run", "stages and players: expected at least one of each") end
  local practice = sys.practice()
  if practice == "" then return task.go(front, a) end
  task.go(practise, a, part(practice))
end

return boot

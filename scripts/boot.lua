-- boot.lua - from power-on to the score table and round again: title, attract, choices, game, results, name entry.
-- boot.run starts one task; the screens are menu.lua's and hud.lua's.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local boot = {}

local ATTRACT = 10 * 60 -- frames the title waits before it shows the demo
local SCORES = 6 * 60   -- frames the score table stands by itself

local over, quit -- the last player is out; the pause menu's other item was chosen

on.game_over(function() over = true end)

-- Calls f, a screen, while the game stands. A frozen board gives turns to the tasks of one scope alone; the screen gets a
-- scope of its own, so that none of the game's tasks run.
local function stand(f)
  local screen = sys.scope()
  local menu_task = task.own(screen, function()
    f()
    sys.freeze() -- without a scope: all go on
    hud.refresh()
    task.stop(screen)
  end)
  if not task.alive(menu_task) then return task.stop(screen) end -- no room for it, and nobody would unfreeze the board
  sys.freeze(screen)
end

local function watch_pause(_, players, other)
  while true do
    wait(1)
    for p = 1, players do
      if not over and pad.take("start", 0, p) then
        stand(function() quit = menu.pause(p, other) == 2 end)
        break
      end
    end
  end
end

-- What a practice start gives player p's ship in place of what its kind says.
local function fit_out(p, with)
  local ship = player.get(p)
  if with.lives > 0 then ship.lives = with.lives - 1 end
  for _, r in ipairs(with.registers) do sys.fit(p, r.name, r.value) end
end

-- Empties field and screen and brings the players in. other: the second item of the pause menu; with: what a practice
-- start gives the ships, or nil; continues: how often each may go on, or nil. Returns the scope that owns all tasks of
-- this game.
local function enter(ships, other, with, continues)
  sys.wipe()
  over, quit = false, false
  for p, kind in ipairs(ships) do sys.join(p, kind) end
  local game = sys.scope()
  sys.start(game)
  if with then fit_out(1, with) end
  hud.start(game, #ships)
  if continues then sys.read("boot/continue")(game, #ships, continues, stand) end
  task.own(game, watch_pause, #ships, other)
  return game
end

local function leave(game, players)
  task.stop(game)
  sys.wipe()
  for p = 1, players do sys.leave(p) end
end

local function stopped() return over or quit end

-- Waits until the scope `part` is over, or the game is: all players are out, or the other item was chosen. True for the
-- first.
local function finished(part)
  wait_until(function() return stopped() or not task.alive(part) end)
  return not stopped()
end

-- Shows the game's last line, unless it was ended from the pause menu.
local function last_words(line)
  if quit then return end
  hud.banner({ line }, 180)
  wait_until(function() return quit end, 180)
end

-- Removes what would go on moving over the results. Sprites stay: they are the picture behind the results.
local function quieten()
  bullet.clear { all = true }
  enemy.each(nil, function(e) e:remove() end)
end

-- How many stages were cleared.
local function play_stages(game, stages, players)
  for i, name in ipairs(stages) do
    local title = text.lang("STAGE %s"):format(menu.label(name))
    hud.banner({ title }, 150)
    if not finished(stage.play(name, game)) then return i - 1 end
    quieten()
    menu.results(text.lang("%s CLEAR"):format(title), players, stopped)
    if stopped() then return i end
    if i < #stages then
      sys.wipe()
      hud.refresh()
    end
  end
  return #stages
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
  local scope, scores = enter(ships, "QUIT", nil, a.continues), {}
  sys.mark("game", ships[1], nil, nil, #ships)
  local cleared = play_stages(scope, a.stages, #ships)
  local all = not stopped()
  sys.mark("over", all and "clear" or quit and "quit" or "over", nil, nil, cleared)
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

-- practice is "boss/phase", "stage" or "stage:mark". Returns a function that starts that part in a scope owned by
-- `owner`, and returns the scope. Names are checked at once, while the game loads.
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
  return function(owner)
    if not mark then sys.mark("start", "") end -- with a mark, stage.mark says so when the stage is there
    return stage.play(stage_name, owner, mark)
  end
end

local function expect_registers(kind, with)
  local names, known = {}, {}
  for i, r in ipairs(sys.ship(kind).registers) do names[i], known[r.name] = r.name, true end
  for _, r in ipairs(with.registers) do
    if not known[r.name] then
      sys.fail("--register", ('ship "%s" has no register "%s"%s'):format(kind, r.name, sys.hint(r.name, names)))
    end
  end
end

-- A practice start: no title, first ship, the same piece again and again.
local function practise(a, start)
  while true do
    local scope = enter({ a.players[1] }, "AGAIN", a.with)
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
  local practice, with = sys.practice()
  if practice == "" then return task.go(front, a) end
  expect_registers(a.players[1], with)
  a.with = with
  if practice == "?" then return task.go(sys.read("boot/list"), a, enter, leave) end -- the cabinet asks what there is
  task.go(practise, a, part(practice))
end

return boot

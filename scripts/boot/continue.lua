-- boot/continue.lua - a player who lost the last life can continue, n times: by START while the other one flies;
-- otherwise the board is frozen and a screen asks. A player without continues is told so while the other one flies.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local BLINK <const>, SEEN <const> = 60, 40 -- frames
local TOLD <const> = 240 -- frames that a player reads that there are no continues

local ROW = (rom.view.y + rom.view.h) // 8 - 2
local LEFT, RIGHT = rom.view.x // 8 + 1, (rom.view.x + rom.view.w) // 8 - 1

-- One line at the bottom of the field, on the player's side.
local function show_prompt(p, line)
  local n = math.ceil(sys.cells(line))
  local col = p == 1 and LEFT or RIGHT - n
  if board.frame() % BLINK == 0 then hud.put(col, ROW, line) end
  if board.frame() % BLINK == SEEN then text.clear { col = col, row = ROW, w = n, h = 1 } end
end

local function anyone(players)
  for p = 1, players do
    if player.get(p).alive then return true end
  end
  return false
end

local function clear_prompt() text.clear { col = LEFT, row = ROW, w = RIGHT - LEFT, h = 1 } end

local function go_on(p)
  clear_prompt()
  sys.cue("continue")
  sys.go_on(p)
end

-- freeze_for(f) calls f while the board is frozen; screen: the game's own, or nil for the library's.
return function(game, players, n, freeze_for, screen)
  for p = 1, n > 0 and players or 0 do sys.continues(p, n) end
  local out = { 0, 0 } -- frames that each player is out without continues
  task.own(game, function()
    while true do
      wait(1)
      for p = 1, players do
        local left = sys.continues(p)
        local is_out = not player.get(p).alive
        local asks = left ~= 0 and is_out
        out[p] = is_out and left == 0 and out[p] + 1 or 0
        if asks and not anyone(players) then
          clear_prompt()
          freeze_for(function()
            local yes = (screen or sys.read("screens/continue"))(p, left)
            if yes then go_on(p) else sys.continues(p, 0) end
          end)
          break
        elseif asks and pad.take("start", 0, p) then
          go_on(p)
        elseif asks then
          sys.tell_key("start", "Continue", p)
          show_prompt(p, text.lang("Press Start: %d Left"):format(left))
        elseif out[p] == TOLD then
          clear_prompt()
        elseif out[p] > 0 and out[p] < TOLD and anyone(players) then
          show_prompt(p, text.lang("No Continues"))
        end
      end
    end
  end)
end

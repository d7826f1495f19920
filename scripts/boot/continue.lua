-- boot/continue.lua - who lost the last life may go on, n times. While another flies, by START; else the board stands
-- and asks.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local BLINK <const>, SEEN <const> = 60, 40 -- frames

local ROW = (rom.field.y + rom.field.h) // 8 - 2
local LEFT, RIGHT = rom.field.x // 8 + 1, (rom.field.x + rom.field.w) // 8 - 1

-- One line at the bottom of the field, on the player's side.
local function remind(p, left)
  local line = text.lang("START: %d LEFT"):format(left)
  local n = sys.cells(line)
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

local function forget() text.clear { col = LEFT, row = ROW, w = RIGHT - LEFT, h = 1 } end

local function go_on(p)
  forget()
  sys.cue("continue")
  sys.go_on(p)
end

-- stand(f) calls f while the board stands; screen: a game's own, else the library's.
return function(game, players, n, stand, screen)
  for p = 1, players do sys.continues(p, n) end
  task.own(game, function()
    while true do
      wait(1)
      for p = 1, players do
        local left = sys.continues(p)
        local asks = left ~= 0 and not player.get(p).alive -- it neither flies, nor is it over
        if asks and not anyone(players) then
          forget()
          stand(function()
            local yes = (screen or sys.read("screens/continue"))(p, left)
            if yes then go_on(p) else sys.continues(p, 0) end
          end)
          break
        elseif asks and pad.take("start", 0, p) then
          go_on(p)
        elseif asks then
          remind(p, left)
        end
      end
    end
  end)
end

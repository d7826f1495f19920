-- menu/preview.lua - ships that play by themselves on a page. They are real players in the field behind the page's
-- panel: they fire their own shots, move and bomb by the buttons that the page holds for them. The player's own buttons
-- don't reach them.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local preview = {}

local BITS <const> = { up = 1, down = 2, left = 4, right = 8, fire = 16, bomb = 32, focus = 64, special = 128 }
local PRESSES <const> = BITS.bomb | BITS.special -- these count as one press; the others are held
local NAMES <const> = { "bomb", "down", "fire", "focus", "left", "right", "special", "up" }

local held = { 0, 0 } -- the buttons of each ship

-- Removes ship p.
function preview.hide(p)
  if not player.get(p).alive then return end
  sys.play_ship(p, 0)
  sys.leave(p)
  hud.gone[p] = false
end

-- Shows a ship of this kind as player p, at a position of the field, in place of the one before.
function preview.ship(p, kind, x, y)
  preview.hide(p)
  held[p] = 0
  sys.play_ship(p, 0)
  sys.join(p, kind)
  preview.place(p, x, y)
  hud.gone[p] = true -- a game's own display at the field's lower edge
end

function preview.place(p, x, y)
  local ship = player.get(p)
  if ship.alive then ship.x, ship.y, ship.safe = x, y, 0 end
end

-- From now on ship p holds these buttons, given by name; bomb and special are pressed once.
function preview.hold(p, ...)
  held[p] = 0
  for _, name in ipairs { ... } do
    if not BITS[name] then sys.unknown("area.hold", "button", tostring(name), NAMES) end
    held[p] = held[p] | BITS[name]
  end
end

-- To be called in each frame.
function preview.step()
  for p = 1, 2 do
    if player.get(p).alive then sys.play_ship(p, held[p]) end
    held[p] = held[p] & ~PRESSES
  end
end

-- Removes the ships and what they fired.
function preview.close()
  for p = 1, 2 do preview.hide(p) end
  sys.wipe(true)
end

return preview

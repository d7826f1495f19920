-- lamps.lua - the colours of the crafts. The setting `lamps` selects one that has been
-- unlocked. If both players fly the same craft, player 2's has another colour.
local lamps = {}

-- The alternative pictures of a craft.
function lamps.pictures(ship) return { gilt = ship .. "_gilt", ember = ship .. "_ember" } end

local function craft_of(p) return p.kind:match("^%a+") end

-- Sets the colour of player p's craft. Player 2's stays once player 1 is out.
function lamps.wear(p)
  local first, colour = player.get(1), board.dip("lamps")
  if p.index == 2 and not first.alive then return end
  if colour == "glass" or not unlock.has(colour) then colour = nil end
  if p.index == 2 and craft_of(p) == craft_of(first) then
    colour = colour == "ember" and "gilt" or "ember"
  end
  if p.picture ~= colour then p.picture = colour end
end

return lamps

-- lamps.lua - the colours of the crafts. The setting `lamps` selects one that has been
-- unlocked.
local lamps = {}

-- The alternative pictures of a craft.
function lamps.pictures(ship) return { gilt = ship .. "_gilt", ember = ship .. "_ember" } end

function lamps.wear(p)
  local colour = board.dip("lamps")
  if colour ~= "glass" and unlock.has(colour) then p.picture = colour end
end

return lamps

-- lamps.lua - in what colours the craft fly: the switch `lamps` of the settings says it, once
-- they were earned.
local lamps = {}

-- The pictures of a craft besides its own.
function lamps.pictures(ship) return { gilt = ship .. "_gilt", ember = ship .. "_ember" } end

function lamps.wear(p)
  local colour = board.dip("lamps")
  if colour ~= "glass" and unlock.has(colour) then p.picture = colour end
end

return lamps

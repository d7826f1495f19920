-- lamps.lua - the colours of the crafts. The setting `lamps` selects one that has been
-- unlocked. If both players fly the same craft, player 2's has another colour.
local lamps = {}

-- The alternative pictures of a craft: banking, and in other colours.
function lamps.pictures(ship)
  local all = { left = ship .. "_left", right = ship .. "_right" }
  for _, colour in ipairs { "gilt", "ember" } do
    for _, side in ipairs { "", "_left", "_right" } do
      all[colour .. side] = ship .. "_" .. colour .. side
    end
  end
  return all
end

-- The end of the name of the picture for the direction in which player p steers.
local function side(p)
  local left, right = pad.down("left", p), pad.down("right", p)
  return left == right and "" or left and "_left" or "_right"
end

local function craft_of(p) return p.kind:match("^%a+") end

-- Sets the colour of player p's craft. Player 2's stays once player 1 is out.
function lamps.wear(p)
  local first, colour = player.get(1), board.dip("lamps")
  if p.index == 2 and not first.alive then return end
  if colour == "glass" or not unlock.has(colour) then colour = nil end
  if p.index == 2 and craft_of(p) == craft_of(first) then
    colour = colour == "ember" and "gilt" or "ember"
  end
  p.picture = colour and colour .. side(p)
end

return lamps

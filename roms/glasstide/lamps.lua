-- lamps.lua - the colours of the crafts. The setting `lamps` selects one that has been
-- unlocked. If both players fly the same craft, player 2's has another colour.
local lamps = {}

local SLOW <const>, HARD <const>, MOST <const> = 3, 5, 8 -- frames of steering: the most in focus, to bank hard, the most

local PICTURES <const> = {
  "left", "right", "hard_left", "hard_right",
  "gilt", "gilt_left", "gilt_right", "gilt_hard_left", "gilt_hard_right",
  "ember", "ember_left", "ember_right", "ember_hard_left", "ember_hard_right",
}

-- The alternative pictures of a craft: banking, and in other colours.
function lamps.pictures(ship)
  local all = {}
  for _, name in ipairs(PICTURES) do all[name] = ship .. "_" .. name end
  return all
end

-- The next lean of player p's craft: it follows the steering by a frame at a time; left is negative.
local function lean_on(p, lean)
  local left, right = pad.down("left", p), pad.down("right", p)
  local most = p.focus and SLOW or MOST
  local goal = left == right and 0 or left and -most or most
  return lean < goal and lean + 1 or lean > goal and lean - 1 or lean
end

-- The end of the name of the picture for a lean.
local function side(lean)
  if lean == 0 then return "" end
  return (math.abs(lean) >= HARD and "_hard" or "") .. (lean < 0 and "_left" or "_right")
end

local function craft_of(p) return p.kind:match("^%a+") end

local function colour_of(p, first)
  local colour = board.dip("lamps")
  colour = colour ~= "glass" and unlock.has(colour) and "_" .. colour or ""
  if p.index == 2 and craft_of(p) == craft_of(first) then return colour == "_ember" and "_gilt" or "_ember" end
  return colour
end

-- Sets the picture of player p's craft. look: { lean, colour }, which the craft keeps; player 2's colour stays once
-- player 1 is out.
function lamps.wear(p, look)
  local first = player.get(1)
  look.lean = lean_on(p, look.lean)
  if p.index == 1 or first.alive then look.colour = colour_of(p, first) end
  local name = look.colour .. side(look.lean)
  p.picture = name ~= "" and name:sub(2) or nil
end

return lamps

-- stage/formation.lua - the offsets of a wave's enemies from its path, for the argument `formation` of stage.wave.
local sys = ...

local named = {}

-- The first enemy is in front (down the field); the others follow on alternate sides.
function named.v(i, _, gap)
  local k = (i + 1) // 2
  return (i % 2 == 1 and -k or k) * gap, -k * gap
end

function named.line(i, n, gap) return (i - (n - 1) / 2) * gap, 0 end

function named.column(i, _, gap) return 0, -i * gap end

-- Neighbours are `gap` apart; the first is in front.
function named.circle(i, n, gap)
  local radius = n > 1 and gap / 2 / angle.sin(180 / n) or 0
  local dir = 90 + 360 * i / n
  return radius * angle.cos(dir), radius * angle.sin(dir)
end

local function listed(a)
  for i = 1, #a.formation do
    local at = a.formation[i]
    if type(at) ~= "table" or type(at[1]) ~= "number" or type(at[2]) ~= "number" or #at ~= 2 then
      sys.fail("stage.wave", ("formation: entry %d: expected { x, y }"):format(i))
    end
  end
  if #a.formation < a.n then
    sys.fail("stage.wave", ("formation: expected %d positions (`n`), got %d"):format(a.n, #a.formation))
  end
  return function(i) return a.formation[i + 1][1], a.formation[i + 1][2] end
end

-- Returns a function of the enemy's number, from 0, that returns dx and dy.
return function(a)
  if type(a.formation) == "table" then return listed(a) end
  local place = named[a.formation]
  if not place then sys.unknown("stage.wave", "formation", tostring(a.formation), { "circle", "column", "line", "v" }) end
  return function(i) return place(i, a.n, a.gap) end
end

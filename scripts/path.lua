-- path.lua - routes for enemies: a list of points, each reached exactly after its `over` frames.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local path = {}

local known = {} -- the routes that path.def made; other tables are refused

-- The first entry is the start; each later entry is a point to reach, or a wait.
local function checked(i, entry)
  entry = entry or {} -- a hole in the list
  local a = sys.check("path.def point", entry)
  local start, moves = i == 1, a.x or a.y or a.over or entry.ease -- moves: has anything but wait
  local good
  if start then
    good = a.x and a.y and not (a.over or a.wait or entry.ease)
  elseif a.wait then
    good = not moves
  else
    good = a.x and a.y and a.over
  end
  if not good then
    local want = start and "{ x=, y= }" or "{ x=, y=, over= } or { wait= }"
    sys.fail("path.def", ("point %d: expected %s"):format(i, want))
  end
  return a
end

function path.def(list)
  if not sys.loading() then sys.fail("path.def", "declare routes while scripts load, not later") end
  if type(list) ~= "table" or #list == 0 then sys.fail("path.def", "expected a list of points") end
  for _, key in ipairs(sys.keys(list)) do
    if math.type(key) ~= "integer" then sys.fail("path.def", ('unknown argument "%s"'):format(tostring(key))) end
  end
  local route = {}
  for i = 1, #list do route[i] = checked(i, list[i]) end
  known[route] = true
  return route
end

function path.known(route) return known[route] == true end

-- Returns a point of the route shifted by dx, dy. Mirrored: reflected at the field's middle, including the shift.
function path.place(point, mirror, dx, dy)
  local x = point.x + dx
  return mirror and rom.field.w - x or x, point.y + dy
end

local function follow(e, route, mirror, dx, dy)
  e.x, e.y = path.place(route[1], mirror, dx, dy)
  for i = 2, #route do
    local point = route[i]
    if point.wait then
      wait(point.wait)
    else
      local x, y = path.place(point, mirror, dx, dy)
      e:move { x = x, y = y, over = point.over, ease = point.ease }
      wait(point.over)
    end
    if not e.alive then return end
  end
end

function path.run(e, route, mirror)
  local a = sys.check("path.run", e, route, mirror)
  if not path.known(a.route) then sys.fail("path.run", "route: expected a route from path.def") end
  follow(a.e, a.route, a.mirror, 0, 0)
end

-- The task of an enemy spawned on a route, which despawns where the route ends.
function path.travel(e, route, mirror, dx, dy)
  follow(e, route, mirror, dx or 0, dy or 0)
  e:remove()
end

return path

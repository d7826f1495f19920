-- trail.lua - spark.trail: after-images, sparks left at an entity's position at regular intervals.
local sys = ...

local function trail(a)
  local left = a.over
  while left > 0 and a.follow.alive do
    spark.burst { kind = a.kind, from = a.follow, dx = a.dx, dy = a.dy, speed = 0 }
    wait(a.every)
    left = left - a.every
  end
end

function spark.trail(args) return task.go(trail, sys.check("spark.trail", args)) end

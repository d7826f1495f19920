-- looks.lua - n purely visual things. DIP price_look selects them: sparks that stay; sparks thrown in each frame, 64 at a time,
-- that last one frame; trails with one spark per frame; sprites that stand still, or that follow a bullet.
local price = board.dip("price_look")
local H = rom.field.h

local function place(i) return i % 64 * 5, 8 + i // 64 * 8 % (H - 16) end

bullet.def("dot", { sprite = "d8", hit = "none", graze = false })
spark.def("fly", { sprite = "d12", life = 65535, gravity = 0.00005, drag = 0.01, banks = { 3, 2, 5, 1 } })
spark.def("blip", { sprite = "d12", life = 1 })

local function dot(x, y) return bullet.fire { kind = "dot", x = x, y = y, speed = 0 } end

local from = {
  sparks_burst = {}, sparks_ring = { radius = 12 }, sparks_row = { to_x = 300, to_y = 60 },
}

local once = {
  sparks_fly = function(x, y) spark.burst { kind = "fly", x = x, y = y, speed = 0.001 } end,
  trails = function(x, y) spark.trail { follow = dot(x, y), kind = "blip", every = 1 } end,
  dots = dot,
  stand = function(x, y) dot(x, y) sprite.put { sprite = "d12", x = x, y = y } end,
  follow = function(x, y) sprite.put { sprite = "d12", follow = dot(x, y) } end,
}

return function(n)
  return function()
    for i = 1, once[price] and n or 0 do once[price](place(i)) end
    local burst = from[price]
    if not burst then return end
    burst.kind, burst.x, burst.y, burst.n, burst.speed = "blip", 60, 60, 64, 1
    while true do
      for _ = 1, n // 64 do spark.burst(burst) end
      wait(1)
    end
  end
end

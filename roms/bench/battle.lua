-- battle.lua - a full pool of shots among n enemies. Each shot that hits is replaced by another. The hitboxes are so large
-- that a shot touches about a tenth of the enemies.
shot.def("shot", { sprite = "d8", hit = { box = { 16, 16 } } })
enemy.def("enemy", { sprite = "d24", hit = { box = { 84, 70 } }, hp = 2147483647, touch = false })

local function place() return rng.number(0, rom.field.w), rng.number(0, rom.field.h) end

return function(n)
  return function()
    for _ = 1, n do
      local x, y = place()
      enemy.spawn { kind = "enemy", x = x, y = y }
    end
    while true do
      for _ = board.live("shots") + 1, 512 do
        local x, y = place()
        shot.fire { kind = "shot", x = x, y = y, speed = 8 }
      end
      wait(1)
    end
  end
end

-- main.lua - acts in the order in which pairs visits names: Lua's own order is another in every run.
bullet.def("dot", { sprite = "dot", hit = { circle = 2 } })

local speeds = {}
for name in ("amber birch coral denim ebony flint grape hazel ivory jade khaki lemon"):gmatch "%a+" do
  speeds[name] = (name:byte(2) - 90) / 16
end

task.go(function()
  wait(20)
  while true do
    local dir = 0
    for name, speed in pairs(speeds) do
      board.note(name)
      bullet.fire { kind = "dot", x = 32, y = 32, dir = dir, speed = speed }
      dir = dir + 30
    end
    wait(40)
  end
end)

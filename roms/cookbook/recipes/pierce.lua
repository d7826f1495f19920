-- pierce.lua - Piercing spear: A spear passes through enemies: it survives three hits, and the
-- fourth removes it. It can hit the same enemy again after six frames. The kind's `pierce` and
-- `every` set these numbers.
shot.def("spear", { sprite = "dart", hit = { capsule = { 8, 3 } }, damage = 4, turns = true,
                    bank = 2, pierce = 3, every = 6 })

player.def("spearman", { sprite = "ship", hit = { circle = 2 }, run = function(p)
  while true do
    if pad.down("fire", p) then
      for side = -1, 1, 2 do
        shot.fire { kind = "spear", from = p, dx = 10 * side, dy = -12, speed = 8 }
      end
    end
    wait(14)
  end
end })

local down = path.def { { x = 114, y = -20 }, { x = 114, y = 340, over = 260 } }

local function run()
  while true do
    stage.wave { kind = "wisp", n = 5, every = 0, formation = "line", gap = 30,
                 path = down }
    wait(50)
  end
end

return { run = run, ship = "spearman", alone = true }

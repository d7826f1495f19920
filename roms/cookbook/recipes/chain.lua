-- chain.lua - Chain: Each kill is worth more than the last if it comes within a second. The
-- register keeps its value for `hold` frames after a kill, then drops to zero. The multiplier
-- floats up from the killed enemy.
player.def("linker", { sprite = "ship", hit = { circle = 2 },
  registers = { chain = { drain = forever, hold = 60, show = "number" } },
  run = function(p)
    while true do
      if pad.down("fire", p) then
        pattern.fan { fire = "shot", from = p, dy = -12, kind = "dart", n = 5, spread = 50,
                      speed = 9,
                      by = p }
      end
      wait(6)
    end
  end })

on.kill(function(e, p)
  if not p or p.kind ~= "linker" then return end
  p.chain = p.chain + 1
  score.add(100 * p.chain, p)
  local note = text.line { x = e.x, y = e.y, text = "x" .. p.chain, font = "slim",
                           align = "center", bank = 3 }
  task.go(function()
    for _ = 1, 30 do
      if not note.alive then return end -- the page was turned
      note.y = note.y - 0.5
      wait(1)
    end
    note:remove()
  end)
end)

local function run()
  for k = 0, forever do
    enemy.spawn { kind = "wisp", x = 30 + 53 * k % 180, y = 40 + 29 * k % 90, hp = 2 }
    wait(k % 12 == 11 and 90 or 16)
  end
end

return { run = run, ship = "linker", alone = true, hud = true }

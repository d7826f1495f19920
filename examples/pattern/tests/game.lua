-- tests/game.lua - each pattern fires and fits the pool. `curtain test .` runs it (docs/guide/27-testing.md).
for _, name in ipairs { "try", "flower", "curtains", "clockwork", "stopped" } do
  local run = test.run { stage = name, invincible = true, frames = 600 }
  test.expect(run:live("bullets") > 20, name .. ": it fires")
  test.expect(run:refused("bullets") == 0, name .. ": no bullet is dropped")
end

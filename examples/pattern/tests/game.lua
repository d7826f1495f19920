-- tests/game.lua - each pattern fires, and finds room. `curtain test .` runs it (docs/guide/27-testing.md).
for _, name in ipairs { "try", "flower", "curtains", "clockwork", "stopped" } do
  local run = test.run { stage = name, invincible = true, frames = 600 }
  test.expect(run:live("bullets") > 20, name .. ": there is something to see")
  test.expect(run:refused("bullets") == 0, name .. ": there was room for all of it")
end

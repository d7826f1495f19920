-- boss/cut_in.lua - the boss's portrait crosses the field while a spell is declared: quickly in, slowly on, quickly out.
-- It is the phase's, so it goes with that; nothing waits for it.
local IN <const>, DRIFT <const> = 18, 48 -- frames
local FAR <const>, NEAR <const> = 0.66, 0.5 -- of the field's width: where the drift begins and ends
local BESIDE <const> = 96 -- px from the field's edge to where it comes from and goes to

return function(b, _, scene)
  local w, h = rom.field.w, rom.field.h
  local function at(k) return h * 0.56 - h * 0.12 * k end -- it rises all the way, of which k is done
  task.own(scene, function()
    local s = sprite.put { sprite = b.portrait, x = w + BESIDE, y = at(0), layer = "back" }
    for t = 1, 2 * IN + DRIFT do
      local k = 1 - math.min(t, IN) / IN
      local out = math.max(t - IN - DRIFT, 0) / IN
      local on = math.min(math.max(t - IN, 0), DRIFT) / DRIFT
      s.x = w * (FAR + (NEAR - FAR) * on) + (w * (1 - FAR) + BESIDE) * k * k - (w * NEAR + BESIDE) * out * out
      s.y = at(t / (2 * IN + DRIFT))
      wait(1)
    end
    s:remove()
  end)
end

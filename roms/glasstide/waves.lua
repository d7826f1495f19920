-- waves.lua - wave helpers for all stages.
local waves = {}

-- The same wave from both sides.
function waves.both(w)
  stage.wave(w)
  w.mirror = true
  stage.wave(w)
end

return waves

-- heard.lua - a demo stage for sound and music: a ring on every beat, and a drum panned to its position.
stage.def("heard", function()
  local e = enemy.spawn { kind = "jelly", x = 120, y = 60 }
  e.safe = forever
  music.play("tide")
  while true do
    local beat = music.wait()
    sound.play(beat % 4 == 0 and "boom" or "drum", { from = e })
    pattern.ring { from = e, kind = "orb", bank = beat % 4, n = 16, dir = 11 * beat, speed = 1.5 }
  end
end)

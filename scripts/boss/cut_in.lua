-- boss/cut_in.lua - the picture of a cut-in, or the phase's portrait, crosses the field while a spell is declared: quickly
-- in, slowly on, quickly out, with a light as it comes and images of itself behind it while it is quick. It is the
-- phase's, so it goes with that; nothing waits for it. It is below the boss and behind what can be hit.
local sys = ... -- functions for the standard library only; documented in src/script/api/api_sys.c
local IN <const>, DRIFT <const> = 18, 60 -- frames
local FAR <const>, NEAR <const> = 0.70, 0.54 -- of the field's width: where the drift begins and ends
local BESIDE <const> = 96 -- px from the field's edge to where it comes from and goes to
local IMAGES <const>, LATER <const> = 3, 3 -- how many come behind it, each so many frames later
local SHARE <const> = 0.25 -- of the light

-- Where it is in the field t frames after it came, from the right of the view; from the left that is mirrored.
local function place(t, left)
  local x0, y0 = sys.to_field(rom.view.x, rom.view.y)
  local x1, y1 = sys.to_field(rom.view.x + rom.view.w, rom.view.y + rom.view.h)
  local w, h = x1 - x0, y1 - y0
  t = math.max(0, t)
  local k = 1 - math.min(t, IN) / IN
  local out = math.max(t - IN - DRIFT, 0) / IN
  local on = math.min(math.max(t - IN, 0), DRIFT) / DRIFT
  local x = w * (FAR + (NEAR - FAR) * on) + (w * (1 - FAR) + BESIDE) * k * k - (w * NEAR + BESIDE) * out * out
  return x0 + (left and w - x or x), y0 + h * (0.66 - 0.06 * math.min(1, t / (2 * IN + DRIFT))) -- it rises all the way
end

-- The cut-in of the phase's leader, of the boss, or the phase's portrait.
local function picture(b, phase)
  local leader = b.cast[1]
  for i = #b.cast, 1, -1 do
    if type(phase.hp) == "table" and phase.hp[b.cast[i].name] then leader = b.cast[i] end
  end
  return leader.cut_in or b.cut_in or phase.portrait
end

return function(b, phase, scene)
  local left, name = phase.portrait_left, picture(b, phase)
  task.own(scene, function()
    local x, y = place(0, left)
    local images = {}
    for i = IMAGES, 0, -1 do -- the last one put is drawn over the others
      images[i + 1] = sprite.put { sprite = name, x = x, y = y, layer = "back", flip_x = left }
    end
    screen.flash { share = SHARE, over = IN }
    for t = 1, 2 * IN + DRIFT do
      local quick = t <= IN + IMAGES * LATER or t > IN + DRIFT
      for i, s in ipairs(images) do
        s.x, s.y = place(t - LATER * (i - 1), left)
        s.hidden = i > 1 and not (quick and (t + i) % 2 == 0) -- they flicker: half there
      end
      wait(1)
    end
    for _, s in ipairs(images) do s:remove() end
  end)
end

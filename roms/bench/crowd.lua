-- crowd.lua - n bullets of 16 kinds in 8 banks. Each crosses a part of the field in 60 frames, turns around, and comes back,
-- forever: one step of its program every 60 frames, with the same number of steps in every frame.
local kinds, leg = 16, 60
local W, H = rom.field.w, rom.field.h

local names, ways = {}, {}
for k = 1, kinds do
  names[k] = "kind" .. k
  bullet.def(names[k], { sprite = names[k], hit = { circle = 3 }, bank = k % 8 })
end
for left = 1, leg do
  ways[left] = motion.def { { wait = left }, { loop = forever, { turn = 180 }, { wait = leg } } }
end

-- Both ends of its path are in the field. It starts `left` frames before the far end.
local function throw(i)
  local speed, left = rng.number(0.5, 3), i % leg + 1
  local x, y, dir, dx, dy
  repeat
    x, y, dir = rng.number(0, W), rng.number(0, H), rng.dir()
    dx, dy = speed * leg * angle.cos(dir), speed * leg * angle.sin(dir)
  until x + dx >= 0 and x + dx < W and y + dy >= 0 and y + dy < H
  local flown = (leg - left) / leg
  bullet.fire { kind = names[rng.int(1, kinds)], x = x + dx * flown, y = y + dy * flown, dir = dir, speed = speed,
                motion = ways[left] }
end

-- Fires in batches, so that the script is not stopped as an endless loop.
return function(n)
  return function()
    for i = 1, n do
      throw(i)
      if i % 16384 == 0 then wait(1) end
    end
  end
end

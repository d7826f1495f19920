-- crowd.lua - n bullets of 16 kinds in 8 banks. Each crosses a part of the field in 60 frames, turns round, and comes back,
-- for ever: one step of its program each 60 frames, and as many of them in one frame as in any other.
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

-- Both ends of its way are in the field; it starts where `left` frames are left to the far one.
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

-- So many a frame that a script that fires them is not taken for an endless loop.
return function(n)
  return function()
    for i = 1, n do
      throw(i)
      if i % 65536 == 0 then wait(1) end
    end
  end
end

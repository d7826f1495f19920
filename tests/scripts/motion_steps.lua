-- Motion programs: where a bullet is after each frame. It starts at (100, 100) and flies to the right by 2 px a frame.
--board: motions=40
bullet.def('dot', { sprite = 'dot', hit = 'none', bank = 2 })
bullet.def('red', { sprite = 'dot', hit = 'none', bank = 9 })
player.def('ship', { sprite = 'dot', hit = { circle = 1 } })
local function dot(program, speed)
  return bullet.fire { kind = 'dot', x = 100, y = 100, dir = 0, speed = speed or 2, motion = motion.def(program) }
end
local function ship()
  string.sys.join(1, 'ship')
  local p = player.get(1)
  p.x, p.y = 100, 230
end
local function fly(frames, program, meanwhile)
  ship()
  local b, places = dot(program), {}
  for i = 1, frames do
    wait(1)
    places[i] = b.alive and ('%g %g'):format(b.x, b.y) or 'gone'
    if i == 1 and meanwhile then meanwhile(b) end
  end
  print(table.concat(places, ', '))
end

--each: waiting
fly(5, { { wait = 3 }, { speed = 0 } })
--> 102 100, 104 100, 106 100, 106 100, 106 100
fly(2, { { wait = 0 }, { speed = 1 } })
--> 101 100, 102 100
fly(3, { { wait = forever }, { speed = 0 } })
--> 102 100, 104 100, 106 100

--each: steps that take no time
fly(2, { { dir = 270 }, { speed = 3 } })
--> 100 97, 100 94
fly(2, { { dir = 180, turn = 90 } })
--> 100 98, 100 96
fly(2, { { speed = -1 } })
--> 99 100, 98 100
fly(2, { { speed = 1, accel = 0.5 } })
--> 101.5 100, 103 100
fly(2, { { aim = true, speed = 4 } })
--> 100 104, 100 108
fly(2, { { aim = true, turn = 90 } })
--> 98 100, 96 100
fly(3, { { wait = 2 }, { die = true } })
--> 102 100, 104 100, gone

--each: steps that take time end in their last frame; the next one starts in the frame after
fly(5, { { speed = 4, over = 4 } })
--> 102.5 100, 105.5 100, 109 100, 113 100, 117 100
fly(4, { { accel = 0.5, over = 3 } })
--> 102.5 100, 105.5 100, 109 100, 112.5 100
fly(3, { { turn = 90, speed = 4, over = 2 } })
--> 100 103, 96 103, 92 103
fly(3, { { speed = 4, accel = 1, over = 2 } })
--> 104 100, 109 100, 114 100
fly(6, { { home = 180, over = 5 }, { dir = 0 } })
--> 100 102, 100 104, 100 106, 100 108, 100 110, 102 110
fly(4, { { aim = true, over = 2 }, { wait = 1 }, { speed = 0 } })
--> 100 102, 100 104, 100 106, 100 106
fly(3, { { speed = 3, over = 1 }, { speed = 1, over = 1 }, { dir = 180 } })
--> 103 100, 104 100, 103 100

--each: loops
fly(3, { { loop = 2, { turn = 90 }, { wait = 1 } } })
--> 100 102, 98 102, 96 102
fly(5, { { loop = forever, { turn = 90, over = 1 } } })
--> 100 102, 98 102, 98 100, 100 100, 100 102
fly(2, { { loop = 0, { turn = 90, over = 1 } }, { speed = 1 } })
--> 101 100, 102 100
fly(5, { { loop = 2, { loop = 2, { accel = 1 }, { wait = 1 } }, { dir = 90 } } })
--> 103 100, 107 100, 107 105, 107 111, 107 117
fly(2, { { loop = 2, { loop = 2, { loop = 2, { loop = 2, { accel = 0.25 } } } } } })
--> 106 100, 112 100

--each: what a script writes wins over the running step, and the program continues
fly(5, { { turn = 90, over = 4 }, { speed = 1 } }, function(b) b.dir = 0 end)
--> 100 102, 102 102, 104 102, 106 102, 107 102
fly(3, { { turn = 90, speed = 4, over = 2 }, { turn = 90 } }, function(b) b.speed = 8 end)
--> 100 103, 92 103, 92 95
fly(3, { { turn = 90, over = 2 }, { turn = 90 } }, function(b) b.vx, b.vy = 3, 0 end)
--> 100 102, 103 102, 103 105
fly(3, { { turn = 90, over = 9 } }, function(b) b.motion = nil end)
--> 100 102, 100 104, 100 106
fly(4, { { turn = 90, over = 2 } }, function(b) b.motion = b.motion end)
--> 100 102, 98 102, 98 100, 98 98
fly(3, { { turn = 90, over = 2 } }, function(b) b.x, b.y = 50, 60 end)
--> 100 102, 48 60, 46 60
fly(3, { { turn = 90, over = 2 } }, function(b) b:turn(180) end)
--> 100 102, 100 100, 100 98

--case: a kind brings its bank, unless the step gives one; with `over`, at the start
local b = dot {
  { wait = 1 },
  { kind = 'red' },
  { wait = 1 },
  { bank = 4, over = 2 },
  { kind = 'dot', bank = 5, over = 2 },
}
for i = 1, 7 do
  wait(1)
  print(b.kind, b.bank, b.motion ~= nil)
  if i == 5 then b.bank = 7 end
end
--> dot 2 true
--> red 9 true
--> red 4 true
--> red 4 true
--> dot 5 true
--> dot 7 true
--> dot 7 false

--case: without a player, aimed bullets keep their direction, and new ones fly down
local b = dot({ { aim = true }, { home = 9, over = 3 } }, 1)
wait(5)
local c = bullet.fire { kind = 'dot', x = 9, y = 9, speed = 1, aim = true }
print(b.x, b.dir, c.dir)
--> 105.0 0.0 90.0

--case: equal programs are stored once; with a full store bullets fly straight
local a, b = motion.def { { turn = 3, over = 4 } }, motion.def { name = 'n', { turn = 3, over = 4 } }
print(a == b, board.live 'motions')
for i = 1, 40 do motion.def { { wait = i } } end
print(board.live 'motions', board.refused 'motions')
local c = dot({ { turn = 90 } }, 1)
print(c.motion)
wait(2)
print(c.x)
--> true 1
--> main.lua:124: motion pool full (40): bullets with a new motion fly straight; raise `board.motions` in rom.lua
--> 40 1
--> nil
--> 102.0

--case: a change of speed ends at its goal, whatever its length
local goal = bullet.fire { kind = 'dot', x = 9, y = 9, speed = 1.7 }.speed
for _, n in ipairs { 1, 3, 7, 11, 59 } do
  local b = dot({ { speed = 1.7, over = n } }, 0.3)
  wait(n)
  print(b.speed == goal)
  wait(1)
  print(b.speed == goal, b.motion)
end
--> true
--> true nil
--> true
--> true nil
--> true
--> true nil
--> true
--> true nil
--> true
--> true nil

-- main.lua - n bullets, thrown at random, that fly to and fro forever: a motion program turns each around before it can leave.
-- The other scenes have their own files.
--
-- Each flies `there` frames one way and the same way back, so the crowd stays the same. Every 20th has its turning points
-- on both sides of a screen edge, so about 5 % are drawn clipped.
local n = board.dip("n") + 65536 * board.dip("n_high")
local does = board.dip("does")
assert(pattern) -- a line that tools/lab/bench/worst.c runs in this game needs it, so it must be packed

local function shuttle()
  bullet.def("d8",  { sprite = "d8",  hit = { circle = 3 } })
  bullet.def("d12", { sprite = "d12", hit = { circle = 5 } })
  bullet.def("d16", { sprite = "d16", hit = { circle = 7 } })
  bullet.def("d24", { sprite = "d24", hit = { box = { 16, 16 } } })
end

local function target()
  player.def("target", { sprite = "d8", hit = { circle = 2 }, graze = 12, safe = 0, lives = 99,
    magnet = 0, pull = 0.001 })
  on.hit(function(p) p.safe = 1 end) -- a hit is counted, but has no effect
end

-- One bullet. It flies at most 24 frames of 1 px each way, so from a start 28 px inside it never reaches an edge.
local function thrower()
  local small = board.dip("mix") == "small"
  local kinds = small and { "d8" } or { "d8", "d8", "d8", "d12", "d8", "d16", "d8", "d24" }
  local there = 24
  local to_and_fro = motion.def { name = "shuttle", { loop = forever, { wait = there }, { turn = 180 } } }
  return function(i)
    local x, y = rng.number(28, 292), rng.number(28, 212)
    if i % 20 == 0 then
      if rng.chance(0.5) then x = rng.pick { -4, 324 } else y = rng.pick { -4, 244 } end
    end
    bullet.fire { kind = kinds[i % #kinds + 1], x = x, y = y, dir = rng.dir(), speed = rng.number(0.25, 1), bank = i % 8,
                  motion = to_and_fro }
  end
end

-- All in the first frame, so that all later frames are the same.
if does == "shuttle" then
  shuttle()
  target()
  local throw = thrower()
  task.go(function() for i = 1, n do throw(i) end end)
else
  target()
  task.go(require(does)(n))
end

boot.run()

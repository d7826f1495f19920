-- prices.lua - n bullets that all do what DIP price says each frame, to be compared with as many that fly straight. They
-- creep, so that none leaves the field, and out of the player's way, so that none is near.
bullet.def("d8", { sprite = "d8", hit = { circle = 3 } })

local function ever(...) return motion.def { { loop = forever, ... } } end

-- A program for each op of motion programs, which is active in every frame.
local ops = {
  ever { wait = 60 },
  ever { kind = "d8", over = 1 },
  ever { bank = 3, over = 1 },
  ever({ dir = 90 }, { wait = 1 }),
  ever { aim = true, over = 60 },
  ever { turn = 1, over = 60 },
  ever { home = 1, over = 60 },
  ever({ speed = 0.02, over = 60 }, { speed = 0.01, over = 60 }),
  ever({ accel = 0.0001, over = 60 }, { accel = -0.0001, over = 60 }),
  ever { loop = 2, { wait = 1 } },
}
local drive = { loop = forever, { turn = 1, speed = 0.02, over = 60 }, { turn = 1, speed = 0.01, over = 60 } }
local fine_drive = motion.def { fine = true, drive }
local motions = {
  accel = ops[9], turn = ops[6], aim = ops[5], home = ops[7],
  drive = motion.def { drive },
  fine = motion.def { fine = true },
  fine_drive = fine_drive,
  polar = motion.def { { polar = 0.001, spin = 1, over = forever } },
  wave = motion.def { { wave = 4, every = 60, over = forever } },
  fire = motion.def { { die = true } },
}

local function motion_of(price, i)
  if price == "mixed" then return ops[i % #ops + 1] end
  if price == "half" then return i % 2 == 0 and ops[i // 2 % #ops + 1] or nil end
  return motions[price]
end

local function fire(i, price)
  return bullet.fire { kind = "d8", x = i % 64 * 4, y = i // 64 % 16, dir = 7 * i, speed = 0.001, tag = "all",
                       motion = motion_of(price, i) }
end

-- What a task does that has fired n bullets.
local then_ = {
  group = function() local all = bullet.group("all") while true do all.bank = 3 wait(1) end end,
  each = function() while true do bullet.each("all", function(b) b.bank = 3 end) wait(1) end end,
}

return function(n)
  local price = board.dip("price")
  if price == "fire" then -- n a frame, gone in the same frame
    return function() while true do for i = 1, n do fire(i, price) end wait(1) end end
  end
  return function()
    for i = 1, n do
      local b = fire(i, price)
      if price == "task" then task.own(b, function() while true do wait(1) end end) end
    end
    if then_[price] then then_[price]() end
  end
end

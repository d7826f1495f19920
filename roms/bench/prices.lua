-- prices.lua - n bullets that all do one thing each frame, to be compared with as many that fly straight. They creep, so
-- that none leaves the field, and out of the player's way, so that none is near.
local drive = { loop = forever, { turn = 1, speed = 0.02, over = 60 }, { turn = 1, speed = 0.01, over = 60 } }
local motions = {
  drive = motion.def { drive },
  home = motion.def { { loop = forever, { home = 1, over = 60 } } },
  fine = motion.def { fine = true },
  fine_drive = motion.def { fine = true, drive },
  gone = motion.def { { die = true } },
}

local function fire(i, motion)
  return bullet.fire { kind = "d8", x = i % 64 * 4, y = i // 64 % 16, dir = 7 * i, speed = 0.001, tag = "all", motion = motion }
end

-- What a task does that has fired n bullets.
local then_ = {
  group = function() local all = bullet.group("all") while true do all.bank = 3 wait(1) end end,
  each = function() while true do bullet.each("all", function(b) b.bank = 3 end) wait(1) end end,
}

return function(does, n)
  if does == "fire" then -- n a frame, gone in the same frame
    return function() while true do for i = 1, n do fire(i, motions.gone) end wait(1) end end
  end
  return function()
    for i = 1, n do
      local b = fire(i, motions[does])
      if does == "task" then task.own(b, function() while true do wait(1) end end) end
    end
    if then_[does] then then_[does]() end
  end
end

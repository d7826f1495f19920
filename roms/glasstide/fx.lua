-- fx.lua - what breaks, in three sizes, and how a boss goes down. Stages name kinds.small, large,
-- burst and collapse, which call these; what is none of a kind's may call them at any place.
local fx = {}

fx.COLLAPSE = 170 -- frames that a boss takes to go down; a stage waits as long behind its fight

-- A place: a thing, or a table of x and y.
function fx.small(at)
  spark.burst { kind = "blast", x = at.x, y = at.y, speed = 0 }
  spark.burst { kind = "fizz", x = at.x, y = at.y, n = 5, speed = 1 }
end

function fx.large(at)
  sound.play("crash", { from = at })
  spark.burst { kind = "blaze", x = at.x, y = at.y, speed = 0 }
  spark.burst { kind = "shock", x = at.x, y = at.y, speed = 0 }
  spark.burst { kind = "fizz", x = at.x, y = at.y, n = 12, speed = 1.6 }
  board.stop(2)
end

function fx.huge(at)
  fx.large(at)
  spark.burst { kind = "crumb", x = at.x, y = at.y, n = 32, speed = 4 }
  screen.shake { size = 4, over = 24 }
  board.stop(4)
end

-- A boss goes down in a chain of fire. Its handle is dead by then: the place is kept.
function fx.collapse(e)
  local x, y = e.x, e.y
  screen.shake { size = 5, over = 80 }
  sound.play("collapse", { from = e })
  task.go(function()
    for i = 1, 14 do
      local dx, dy = 34 * angle.cos(137 * i), 26 * angle.sin(137 * i)
      spark.burst { kind = i % 3 == 0 and "blaze" or "blast", x = x + dx, y = y + dy, speed = 0.4 }
      spark.burst { kind = "crumb", x = x + dx, y = y + dy, n = 8, speed = 3 }
      wait(5)
    end
    spark.burst { kind = "blaze", x = x, y = y, n = 7, speed = 2 }
    spark.burst { kind = "shock", x = x, y = y, speed = 0 }
    spark.burst { kind = "glint", x = x, y = y, n = 48, speed = 5 }
    screen.flash { over = 30, share = 0.6 }
  end)
end

return fx

-- tests/game.lua - each document fires, fits the pool, and restarts when it has ended. `curtain test .` runs it.
local first = test.run { stage = "gallery", invincible = true, frames = 1 }
local n = #first:eval "bullet.documents()"
test.expect(n >= 12, "there are documents to browse")
for i = 1, n do
  local run = test.run { stage = "gallery", invincible = true, dips = { document = i, rank = 100 }, frames = 240 }
  test.expect(run:live("bullets") > 5, i .. ": it fires")
  test.expect(run:refused("bullets") == 0, i .. ": no bullet is dropped")
end

-- The contact sheet: each document for 240 frames.
local sheet = test.run { stage = "sheet", invincible = true, frames = 230 }
local pages = 0
for _ = 1, n do
  pages = pages + (sheet:live("bullets") > 5 and 1 or 0)
  sheet:step(240)
end
test.expect(pages >= n - 1, "a contact sheet of all: " .. pages)

-- Fire goes to the next document, and from the last to the first.
local run = test.run { stage = "gallery", invincible = true, dips = { document = n }, frames = 200 }
local before = run:live("bullets")
run:press "fire"
run:step(3)
run:press()
test.expect(before > 40 and run:live("bullets") < 20, "the next document has just started")
run:step(197)
local same = test.run { stage = "gallery", invincible = true, dips = { document = 1 }, frames = 198 }
test.expect(math.abs(run:live("bullets") - same:live("bullets")) < 4, "and it is the first one")

-- A document that has ended restarts on an empty field.
run = test.run { stage = "gallery", invincible = true, dips = { document = 13, rank = 0 }, frames = 600 }
test.expect(run:live("bullets") > 20, "it is running")
test.expect(run:wait(function(r) return r:live("bullets") < 30 end, 900), "it ends")
test.expect(run:wait(function(r) return r:live("bullets") > 100 end, 300), "and restarts")

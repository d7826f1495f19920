-- tests/game.lua - each document fires, finds room, and begins anew when it has ended. `curtain test .` runs it.
local first = test.run { stage = "gallery", invincible = true, frames = 1 }
local n = #first:eval "bullet.documents()"
test.expect(n >= 12, "there is something to browse")
for i = 1, n do
  local run = test.run { stage = "gallery", invincible = true, dips = { document = i, rank = 100 }, frames = 240 }
  test.expect(run:live("bullets") > 5, i .. ": there is something to see")
  test.expect(run:refused("bullets") == 0, i .. ": there was room for all of it")
end

-- All of them, for a contact sheet: one a page of 240 frames, and then the next.
local sheet = test.run { stage = "sheet", invincible = true, frames = 230 }
local pages = 0
for _ = 1, n do
  pages = pages + (sheet:live("bullets") > 5 and 1 or 0)
  sheet:step(240)
end
test.expect(pages >= n - 1, "a contact sheet of all: " .. pages)

-- Fire is the next one, and from the last the first.
local run = test.run { stage = "gallery", invincible = true, dips = { document = n }, frames = 200 }
local before = run:live("bullets")
run:press "fire"
run:step(3)
run:press()
test.expect(before > 40 and run:live("bullets") < 20, "the next has only begun")
run:step(197)
local same = test.run { stage = "gallery", invincible = true, dips = { document = 1 }, frames = 198 }
test.expect(math.abs(run:live("bullets") - same:live("bullets")) < 4, "and it is the first")

-- What has ended begins anew, on an empty field.
run = test.run { stage = "gallery", invincible = true, dips = { document = 13, rank = 0 }, frames = 600 }
test.expect(run:live("bullets") > 20, "it is under way")
test.expect(run:wait(function(r) return r:live("bullets") < 30 end, 900), "it ends")
test.expect(run:wait(function(r) return r:live("bullets") > 100 end, 300), "and begins anew")

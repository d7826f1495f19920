-- modes.lua - the caravan ends at exactly 2:00 and pays for remaining lives and bombs; the rush has all bosses, in the
-- order of the dive.
local MINUTES <const> = 2 * 60 * 60 -- frames

local run = test.run { stage = "caravan", seed = 1, invincible = true, pads = "fire" }

-- Frames of the stage, without hit-stops.
local function clock() return run:eval "game.frames" end

run:step(MINUTES - 120)
while clock() < MINUTES do run:step(MINUTES - clock()) end
test.expect(run:live("enemies") > 0, "creatures appear until the end")
test.expect(run:live("bullets") > 0, "and bullets fly")
run:step(2)
local points = run.score
test.equal(run:live("enemies"), 0, "then no creatures are left")
test.equal(run:live("bullets"), 0, "and no bullets")
test.expect(points > 55000, "lives and bombs were paid")
run:step(120)
test.equal(run:live("enemies"), 0, "nothing appears afterwards")
test.shot("caravan-over")
test.expect(run:wait(function(r) return r:moment("clear", "caravan") end, 180), "the stage ends")

local ORDER <const> = { "nautilus", "crab", "bellows", "eels", "angler", "queen", "moon" }
local rush = test.run { stage = "rush", seed = 1, invincible = true, difficulty = "easy",
                        pads = "fire" }
for _, name in ipairs(ORDER) do
  test.expect(rush:wait(function(r) return r:moment("boss", name) end, 20000), name .. " appears")
end
test.expect(rush:wait(function(r) return r:moment("clear", "rush") end, 20000), "and then the stage ends")

local came = {}
for _, m in ipairs(rush.moments) do
  if m.kind == "boss" and came[#came] ~= m.name then came[#came + 1] = m.name end
end
test.equal(table.concat(came, " "), table.concat(ORDER, " "), "the bosses and their order")

-- undertow.lua - the bomb: it clears bullets, uses one bomb, and keeps the craft safe; without bombs, nothing happens.
local function fight(bombs)
  local run = test.run { stage = "queen/flower", seed = 3, registers = { bombs = bombs } }
  test.expect(run:wait(function(r) return r:live("bullets") >= 40 end, 900), "40 bullets fly")
  return run
end

local run = fight(2)
local before = run:live("bullets")
local frame = run.frame
run:press("bomb@" .. frame .. ":" .. frame + 2)
run:step(40)
test.equal(run:eval "player.get(1).bombs", 1, "bombs left")
test.expect(run:live("bullets") < before // 2, "most bullets are cleared")
test.expect(run:eval "player.get(1).safe" > 0, "the craft is safe")
test.equal(run:heard("bomb"), 1, "the bomb's sound plays")
test.expect(not run:moment("death"), "nobody dies")
test.shot("undertow")

local none = fight(0)
none:press("bomb")
none:step(20)
test.equal(none:heard("bomb"), 0, "no sound without a bomb")

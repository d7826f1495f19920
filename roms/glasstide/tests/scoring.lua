-- scoring.lua - grazes fill the gauge and pay less with time, its release turns bullets into
-- shards, shards and chains raise the score, and a death halves them.
local function ring(run, n, radius)
  run:exec(("for i = 1, %d do bullet.fire { kind = 'orb', from = player.get(1), " ..
            "dx = %d * angle.cos(360 * i / %d), dy = %d * angle.sin(360 * i / %d), speed = 0 } end")
           :format(n, radius, n, radius, n))
end

local function own(run, name) return run:eval("player.get(1)." .. name) end

local run = test.run { stage = "one", invincible = true, frames = 30 }
run:exec "player.get(1).gauge = 100"
ring(run, 6, 14)
run:step(2)
test.equal(own(run, "gauge"), 160, "six grazes add sixty")

-- Too low: nothing happens. High enough: nearby bullets become shards, and the gauge is emptied.
run:press("special@" .. run.frame .. ":" .. run.frame + 1)
run:step(3)
test.equal(own(run, "gauge"), 160, "it is unchanged")
run:exec "player.get(1).gauge = 1000"
ring(run, 30, 100)
run:step(1)
run:press("special@" .. run.frame .. ":" .. run.frame + 1)
run:step(3)
test.equal(own(run, "gauge"), 0, "it is released")
test.equal(run:heard("release"), 1, "with its sound")
test.expect(own(run, "safe") > 30, "the craft is safe")
run:press()
run:step(90)
test.expect(own(run, "shards") >= 130, "30 shards raise the multiplier")
test.expect(own(run, "prisms") >= 30, "and are counted")

-- The same kill is worth more with a chain and a multiplier.
local function kill_of(shards, chain)
  local one = test.run { stage = "one", invincible = true, frames = 5 }
  one:exec(("local p = player.get(1) p.shards, p.chain = %d, %d"):format(shards, chain))
  one:exec "enemy.spawn { kind = 'krill', x = 120, y = 60, drops = {} }:kill(player.get(1))"
  one:step(2)
  return one.score
end
local plain = kill_of(100, 0)
test.expect(plain > 0, "a kill scores")
test.equal(kill_of(300, 0) // plain, 3, "three times with x3.00")
test.expect(kill_of(100, 100) > 3 * plain // 2, "more in a chain")

-- Repeated grazes in one phase pay less and less, and finally nothing.
local tired = test.run { stage = "one", invincible = true, frames = 5 }
tired:exec "player.get(1).worn = 700"
local before = tired.score
ring(tired, 6, 14)
tired:step(2)
test.equal(own(tired, "gauge"), 0, "no gauge")
test.equal(tired.score, before, "no points")

-- A death halves the multiplier's part above x1.00, and the rank falls.
local dies = test.run { stage = "one", frames = 5 }
dies:exec "local p = player.get(1) p.shards, p.chain, p.gauge, p.safe = 300, 50, 800, 0"
dies:exec "game.rank = 60"
dies:exec "bullet.fire { kind = 'orb', from = player.get(1), speed = 0 }"
dies:step(2)
test.expect(dies:moment("death"), "the craft dies")
local left = { own(dies, "shards"), own(dies, "chain"), own(dies, "gauge") }
test.equal(left, { 200, 0, 400 }, "what is left")
test.equal(dies:eval "game.rank", 36, "the rank")

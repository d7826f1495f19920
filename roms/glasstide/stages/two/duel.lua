-- stages/two/duel.lua - helpers for two bosses with separate bars. The one that is left alone gets
-- angry, visibly and audibly.

local pair_of = {} -- the two bosses by name, while a phase runs

local function other(e) return e == pair_of.cinder and pair_of.quench or pair_of.cinder end

-- Is the other boss down? Then rest() is shorter.
local function angry(e)
  local o = other(e)
  return o and (not o.alive or o.hp == 0)
end

local CRIES <const> = { cinder = "cinder_cry", quench = "quench_cry" }

-- A boss that is left alone cries out and glows.
local function mourn(e)
  wait(2)
  wait_until(function() return angry(e) end)
  sound.play(CRIES[e == pair_of.cinder and "cinder" or "quench"], { from = e })
  screen.shake { size = 2, over = 20 }
  spark.burst { kind = "shock", from = e, speed = 0 }
  while true do
    spark.burst { kind = "ember", from = e, n = 3, dir = 270, spread = 150, speed = 1.4 }
    wait(5)
  end
end

local function rest(e, n) wait(angry(e) and n * 2 // 3 or n) end

-- The run functions for a phase with two bars.
local function pair(cinder, quench)
  local function alone(name, run)
    return function(e)
      pair_of[name] = e
      sound.play(CRIES[name], { from = e })
      task.go(mourn, e)
      run(e)
    end
  end
  return { cinder = alone("cinder", cinder), quench = alone("quench", quench) }
end

return { angry = angry, rest = rest, pair = pair }

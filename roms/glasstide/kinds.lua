-- kinds.lua - bullets, and what creatures share. Stages use its functions to declare their own kinds.
require "items"
require "sparks"

-- A glass bullet with a delay starts as mist; a cleared one pops.
local function glass(name, def)
  def.sprite, def.cloud, def.vanish = def.sprite or name, def.cloud or "mist", def.vanish or "pop"
  bullet.def(name, def)
end

glass("pellet", { hit = { circle = 2 }, cloud = "mist_70" })
glass("orb",    { hit = { circle = 3.5 } })
glass("ring",   { hit = { circle = 5 } })
glass("drop",   { hit = { circle = 2.5 }, turns = true })
glass("star",   { hit = { circle = 4 } })
glass("pearl",  { hit = { circle = 6 } })
glass("big",    { hit = { circle = 8 },  cloud = "mist_150" })
glass("bubble", { hit = { circle = 9 },  cloud = "mist_150" })
glass("marble", { hit = { circle = 12 }, cloud = "mist_150" })

-- Long bullets hit along their length; tumbling ones only at their middle.
glass("rice",  { hit = { capsule = { 5, 1.5 } }, turns = true })
glass("petal", { hit = { capsule = { 4, 2 } },   turns = true })
glass("shard", { hit = { capsule = { 4, 1.5 } }, turns = true })
glass("chip",  { hit = { circle = 2 }, sprite = "shard", spin = 11, vanish = "glint" })

-- order draws aimed bullets above others.
glass("kunai",  { hit = { circle = 2.5 }, cloud = "mist_70", turns = true, order = 1 })
glass("needle", { hit = { capsule = { 8, 1.2 } },   turns = true, order = 1 })
glass("lance",  { hit = { capsule = { 18, 1.4 } },  turns = true, order = 1, vanish = "glint" })

-- Bombs don't clear these two, and they can't be grazed. A lamp can be shot; its light then clears
-- the bullets around it.
glass("moon", { hit = { circle = 6 }, sprite = "pearl", clearable = false, graze = false })
glass("lamp", { hit = { circle = 8 }, clearable = false, graze = false, order = 2, hp = 18,
  score = 500, spark = "splint", on_death = function(b)
    sound.play("lamp", { from = b })
    spark.burst { kind = "shock", from = b, speed = 0 }
    bullet.sweep { x = b.x, y = b.y, radius = 8, radius_to = 64, over = 14 }
  end })

-- A ray of the crab's lamps; only its core hits.
laser.def("ray", { strip = "ray_of_light", width = 12, hit = { share = 0.5 }, graze = 12,
                   vanish = "glint" })

local EVERY <const> = 6 -- least frames from one sound of a hit to the next
local taps, tapped = 0, 0 -- sounds of hits that follow one another; the frame of the last

-- The taps of a long attack change their pitch and grow softer, down to half their volume.
local function tap(e)
  local since = board.frame() - tapped
  if since < EVERY then return end
  taps, tapped = since > 30 and 0 or taps + 1, board.frame()
  sound.play("chip", { from = e, pitch = taps * 5 % 9 - 4, volume = math.max(0.5, 1 - taps / 30) })
end

-- A hit by a shot.
local function chip(e, p, damage)
  tap(e)
  fx.hit(e, p, damage)
end

-- on_death handlers by the size of the creature. A boss's end, with its picture of the same name as its
-- kind, lasts two seconds; stages wait for COLLAPSE frames after the fight.
local COLLAPSE <const> = 170

local function explosion(size) return function(e, _) fx.explode { from = e, size = size } end end

local function collapse(e, _)
  sound.play("collapse", { from = e })
  fx.collapse { from = e, sprite = rom.has(e.kind) and e.kind or nil, bank = e.bank, radius = 40,
                over = 94, crack = "crack", size = "end" }
end

-- A tough shell throws tumbling splinters at the craft that broke it.
local function burst(e, _)
  fx.explode { from = e, size = "large" }
  sound.play("shatter", { from = e })
  pattern.ring { from = e, kind = "chip", bank = 7, aim = true, speed = 1.8,
                 n = by_difficulty { easy = 6, normal = 10, hard = 16 } }
end

local COLD, WARM = 0, 1 -- the two colours of glass

local BLINK = 8 -- frames that a hurt creature blinks; a quarter of them are white
local LARGE = 36 -- px: hitboxes from this size on blink softly, or the screen would flash

-- The pictures of a creature that turns to where it flies, flinches, and shows that it will fire.
local function poses(name)
  return { left = name .. "_left", right = name .. "_right", hurt = name .. "_hurt", attack = name .. "_attack" }
end

local function creature(name, bank, w, h, hp, score, on_death, drops, pictures)
  enemy.def(name, { sprite = name, bank = bank, hit = { box = { w, h } }, hp = hp, score = score,
                    spark = "crumb", blink = BLINK, blink_soft = math.max(w, h) >= LARGE,
                    on_hit = chip, on_death = on_death, drops = drops, pictures = pictures or poses(name) })
end

return { glass = glass, creature = creature, chip = chip, small = explosion "small",
         large = explosion "large", huge = explosion "huge", burst = burst, collapse = collapse,
         COLLAPSE = COLLAPSE, COLD = COLD, WARM = WARM, BLINK = BLINK }

-- kinds.lua - kinds for all recipes. A ship that is hit flickers and survives.
bullet.def("orb",   { sprite = "orb",   hit = { circle = 3.5 } })
bullet.def("rice",  { sprite = "rice",  hit = { circle = 2 }, turns = true })
bullet.def("knife", { sprite = "knife", hit = { circle = 2.5 }, turns = true })
bullet.def("drop",  { sprite = "drop",  hit = { circle = 2.5 }, turns = true })
bullet.def("petal", { sprite = "petal", hit = { circle = 2.5 }, turns = true })
bullet.def("star",  { sprite = "star",  hit = { circle = 4 } })
bullet.def("big",   { sprite = "big",   hit = { circle = 8 } })
spark.def("glint",  { sprite = "glint", life = 16, drag = 0.06 })
shot.def("dart",    { sprite = "dart",  hit = { box = { 6, 12 } }, damage = 2, turns = true })
enemy.def("wisp",   { sprite = "wisp",  hit = { box = { 16, 16 } }, hp = 8, score = 200, spark = "glint", blink = 4 })
enemy.def("jelly",  { sprite = "jelly", hit = { box = { 28, 26 } }, hp = 40, score = 1000, spark = "glint", blink = 4 })
enemy.def("queen",  { sprite = "queen", hit = { box = { 52, 56 } }, score = 50000, spark = "glint", blink = 4 })
laser.def("ray",    { strip = "ray",    width = 12, hit = { share = 0.5 }, vanish = "glint" })
laser.def("shine",  { strip = "shine",  width = 18, hit = { share = 0.4 }, blend = "glow", head = "ember" })
laser.def("scale",  { strip = "scale",  width = 9,  hit = { share = 0.6 }, vanish = "glint" })

player.def("ship", { sprite = "ship", hit = { circle = 2 } })
player.def("gun", { sprite = "ship", hit = { circle = 2 }, run = function(p)
  while true do
    if pad.down("fire", p) then shot.fire { kind = "dart", from = p, dy = -12, speed = 9 } end
    wait(5)
  end
end })

-- Only the ship kind "mortal" dies.
on.hit(function(p)
  if p.kind ~= "mortal" then p.safe = 30 end
end)

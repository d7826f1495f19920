-- creep.lua - n bullets all over the field that fly straight, so slowly that they never leave it.
bullet.def("dot", { sprite = "kind1", hit = { circle = 3 } })

return function(n)
  return function()
    for _ = 1, n do
      bullet.fire { kind = "dot", x = rng.number(0, rom.field.w), y = rng.number(0, rom.field.h), dir = rng.dir(), speed = 0.001 }
    end
  end
end

-- echoes.lua - After-images: Every few frames a spark copies the look of its source and fades
-- through a list of colours. spark.trail follows an enemy, a ship or a bullet, and ends when its
-- target despawns.
spark.def("echo_jelly", { sprite = "jelly", life = 28, banks = { 4, 5, 6 }, blend = "ghost" })
spark.def("echo_star",  { sprite = "star", life = 20, banks = { 3, 2, 1 }, blend = "ghost" })

return function(e)
  spark.trail { kind = "echo_jelly", follow = e, every = 5 }
  for k = 0, forever do
    e:move { x = 120 + 80 * angle.cos(144 * k), y = 100 + 50 * angle.sin(144 * k), over = 34,
             ease = "both" }
    wait(40)
    pattern.fan { from = e, kind = "star", bank = 3, n = 5, spread = 60, aim = true, speed = 2.2,
                  each = function(a) spark.trail { kind = "echo_star", follow = bullet.fire(a),
                                                   every = 4 } end }
    wait(20)
  end
end

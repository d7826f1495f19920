-- stages/three.lua - the abyss, and the Queen of the Glass Tide.
require "stages/three/creatures"
local queen = require "stages/three/queen"
local meeting = require "stages/three/meeting"
local sea = require "sea"

stage.def("three", function()
  palette.load("three")
  bg.show("abyss", { over = 0 })
  sea.speed(1.6)
  stage.mark("queen")
  sea.speed(0.5)
  music.stop { fade = 60 }
  wait(60)
  meeting()
  music.play("queen") -- until she is broken, however often she comes back
  queen.fight()
  music.stop { fade = 140 }
  wait(150)
end, { music = "tide" })

-- main.lua - runs first: requires the others, and begins.
require "kinds"
require "ship"
require "night"
require "stages/river"
require "bosses/keeper"

boot.run { stages = { "river" }, players = { "kite" }, music = { title = "river" } }

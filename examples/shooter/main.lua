-- main.lua - runs first: loads the other files and starts the game.
require "kinds"
require "ship"
require "night"
require "stages/river"
require "bosses/keeper"

boot.run { stages = { "river" }, players = { "kite" }, music = { title = "river" } }

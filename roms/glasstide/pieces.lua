-- pieces.lua - the music room: all pieces in the order of the dive, each with a line of text. Most are locked until
-- the player has come far enough to hear them.
local function piece(name, title, text, needs)
  return { name = name, title = title, text = text, needs = needs }
end

local ROOM <const>, LAST <const> = "music_room", "ember"

return {
  piece("title", "Lamps of the Harbour", "A wave, and a smaller one."),
  piece("opening", "The Tide Went Out", "Three beats, and no water."),
  piece("tide", "Down the Slope", "One: threes over the beat."),
  piece("lantern", "A Lamp That Looks Back", "It waits halfway down.", ROOM),
  piece("claws", "Sidestep in Crystal", "It knows it walks sideways.", ROOM),
  piece("works", "Slag and Brass", "Two: sevens, and anvils.", ROOM),
  piece("furnace", "Hot Iron, Cold Iron", "One left, the other right.", ROOM),
  piece("abyss", "Where Light Has Weight", "Three: as slow as sinking.", ROOM),
  piece("queen", "She Who Keeps the Water", "She counts every wave.", ROOM),
  piece("moon", "What the Moon Sang", "The whole tune, at last.", LAST),
  piece("caravan", "Two Minutes of Daylight", "Do not look at the clock.", ROOM),
  piece("clear", "Up for Air", "Breathe.", ROOM),
  piece("over", "The Light Goes Out", "The wave, upside down.", ROOM),
  piece("ending", "Water in the Harbour", "A hand's breadth at a time.", ROOM),
  piece("true_ending", "The Moon Let Go", "What it sang, in daylight.", LAST),
  piece("staff", "All Lamps Lit", "Everyone comes home.", ROOM),
  piece("scores", "Names in the Log", "The evening after."),
}

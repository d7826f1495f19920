-- missions.lua - short dives with one goal each, in the order of the stages.
local S <const> = 60 -- frames per second

local function dive(name, title, text, m)
  m.title, m.text = title, text
  mission.def(name, m)
end

dive("lesson", "First Breath", "Learn to focus, graze, take prisms and bomb.",
  { stage = "lesson", difficulty = "normal", clear = true, lives = 9, medals = { 60 * S, 45 * S } })

-- ---- the shallows ----

dive("first_light", "First Light", "Make a chain of 20 before the wreck.",
  { stage = "one", to = "wreck", goal = { chain = 20 }, medals = { 15 * S, 10 * S } })
dive("clear_water", "Clear Water", "Reach the wreck without a bomb.",
  { stage = "one", to = "wreck", clear = true, bombs = 0, by = "score",
    medals = { 23000, 37000 } })
dive("salvage", "Salvage", "Break 12 enemies in the wreck.",
  { stage = "one", mark = "wreck", to = "nautilus", goal = { kills = 12 },
    medals = { 10 * S, 9 * S } })
dive("rivets", "Rivets", "Make a chain of 14 in the wreck.",
  { stage = "one", mark = "wreck", to = "nautilus", difficulty = "hard", goal = { chain = 14 },
    medals = { 10 * S, 9 * S } })
dive("wick", "A Short Wick", "Beat the Lantern Nautilus in 75 seconds.",
  { boss = "nautilus", difficulty = "normal", clear = true, limit = 75 * S,
    medals = { 62 * S, 50 * S } })
dive("snail", "Snail's Pace", "Let the Chambered Lamp burn 20 seconds. No bomb.",
  { boss = "nautilus", phase = "chambers", difficulty = "hard", goal = { frames = 20 * S },
    bombs = 0, by = "grazes", medals = { 30, 60 } })
dive("nets", "Cut the Nets", "Score 30,000 points above the crab.",
  { stage = "one", mark = "deep", to = "crab", goal = { score = 30000 },
    medals = { 26 * S, 21 * S } })
dive("hooks", "By Hook", "Break 40 enemies above the crab with hooks.",
  { stage = "one", mark = "deep", to = "crab", ship = "tern_hooks", goal = { kills = 40 },
    medals = { 26 * S, 22 * S } })
dive("ribs", "Spare Ribs", "Break 30 enemies among the whale's bones.",
  { stage = "one", mark = "whale", to = "crab", goal = { kills = 30 },
    medals = { 22 * S, 18 * S } })
dive("pinch", "A Pinch of Salt", "Graze 100 in Pincers without a bomb.",
  { boss = "crab", phase = "pincers", difficulty = "normal", goal = { grazes = 100 }, bombs = 0,
    limit = 30 * S, medals = { 20 * S, 15 * S } })
dive("echo", "No Echo", "Break the Grotto of Rings with the lens.",
  { boss = "crab", phase = "grotto", ship = "heron_lens", difficulty = "normal", clear = true,
    limit = 35 * S, medals = { 31 * S, 26 * S } })
dive("waltz", "Last Waltz", "Let the Waltz of Lamps run 25 seconds. No bomb.",
  { boss = "crab", phase = "lamplight", difficulty = "hard", goal = { frames = 25 * S },
    bombs = 0, by = "grazes", medals = { 30, 60 } })
dive("glazier", "The Glazier", "Collect 70 prisms under the Falling Chandelier.",
  { boss = "crab", phase = "chandelier", goal = { prisms = 70 }, bombs = 0,
    registers = { gauge = 500 }, medals = { 30 * S, 20 * S } })
dive("harbour", "Harbour Dues", "Break Harbour Lights without a bomb.",
  { boss = "crab", phase = "harbour", difficulty = "normal", clear = true, bombs = 0,
    medals = { 32 * S, 26 * S } })
dive("whole_crab", "A Whole Crab", "Beat the Chandelier Crab with one life.",
  { boss = "crab", difficulty = "normal", clear = true, by = "score",
    medals = { 120000, 200000 } })
dive("one_breath", "In One Breath", "Dive through the shallows with one life.",
  { stage = "one", difficulty = "normal", clear = true, by = "score",
    medals = { 250000, 400000 } })
dive("prism", "Prism", "Raise RATE to x3.00 in the shallows.",
  { stage = "one", lives = 3, goal = { shards = 300 }, medals = { 260 * S, 235 * S } })

-- ---- the works ----

dive("soot", "Soot", "Make a chain of 24 in the street of the works.",
  { stage = "two", mark = "street", to = "bellows", lives = 3, goal = { chain = 24 },
    medals = { 13 * S, 11 * S } })
dive("asthma", "Out of Breath", "Graze 30 while the Bellows breathes.",
  { boss = "bellows", phase = "breath", difficulty = "normal", goal = { grazes = 30 },
    limit = 20 * S, medals = { 16 * S, 13 * S } })
dive("gears", "Spare Gear", "Break Meshing Wheels on hard without a bomb.",
  { boss = "bellows", phase = "wheels", difficulty = "hard", clear = true, bombs = 0,
    medals = { 38 * S, 30 * S } })
dive("shift", "Night Shift", "Break 40 enemies in the halls.",
  { stage = "two", mark = "halls", to = "eels", lives = 3, goal = { kills = 40 },
    medals = { 27 * S, 23 * S } })
dive("rails", "Off the Rails", "Make a chain of 20 in the yard of the works.",
  { stage = "two", mark = "yard", to = "eels", lives = 3, goal = { chain = 20 },
    medals = { 20 * S, 15 * S } })
dive("panes", "Window Shopping", "Collect 40 prisms among Panes in Rows.",
  { boss = "eels", phase = "panes", difficulty = "normal", goal = { prisms = 40 }, bombs = 0,
    registers = { gauge = 500 }, medals = { 26 * S, 16 * S } })
dive("press", "Stop Press", "Break The Press with fangs.",
  { boss = "eels", phase = "press", ship = "petrel", difficulty = "normal", clear = true,
    medals = { 40 * S, 33 * S } })

-- ---- the abyss ----

dive("trench", "Trench Coat", "Break 18 enemies in the trench.",
  { stage = "three", mark = "trench", to = "angler", lives = 3, goal = { kills = 18 },
    medals = { 14 * S, 13 * S } })
dive("bait", "Bait", "Graze 50 around the Anglerlamp's bait.",
  { boss = "angler", phase = "bait", difficulty = "normal", goal = { grazes = 50 },
    limit = 26 * S, medals = { 22 * S, 17 * S } })
dive("match", "Struck Match", "Break Struck Match in 40 seconds.",
  { boss = "angler", phase = "match", difficulty = "normal", clear = true, limit = 40 * S,
    medals = { 34 * S, 26 * S } })
dive("teeth", "Dentist", "Break Closing Teeth with the swarm.",
  { boss = "angler", phase = "teeth", ship = "petrel_swarm", difficulty = "normal", clear = true,
    medals = { 46 * S, 36 * S } })
dive("hoard", "Hoard", "Collect 60 prisms above the Queen.",
  { stage = "three", mark = "deep", to = "queen", lives = 3, goal = { prisms = 60 },
    medals = { 28 * S, 24 * S } })
dive("lamps", "Lamplighter", "Break 25 enemies on the drowned quay.",
  { stage = "three", mark = "quay", to = "queen", lives = 3, goal = { kills = 25 },
    medals = { 16 * S, 13 * S } })
dive("wheels", "Full Measure", "Fill GLASS among the Queen's wheels. No bomb.",
  { boss = "queen", phase = "wheels", difficulty = "normal", goal = { gauge = 1000 }, bombs = 0,
    registers = { gauge = 400 }, limit = 45 * S, medals = { 26 * S, 19 * S } })
dive("breath", "Hold It", "Beat Held Breath in 30 seconds.",
  { boss = "queen", phase = "held", difficulty = "normal", clear = true, limit = 30 * S,
    medals = { 25 * S, 20 * S } })
dive("ebb", "Slack Water", "Break Ebb and Flow with lances. No bomb.",
  { boss = "queen", phase = "ebb", ship = "tern", difficulty = "normal", clear = true, bombs = 0,
    medals = { 25 * S, 18 * S } })
dive("window", "Stained Glass", "Break the Rose Window on hard.",
  { boss = "queen", phase = "window", difficulty = "hard", clear = true, by = "grazes",
    medals = { 50, 100 } })
dive("flower", "Fathomless", "Let the abyss flower for 30 seconds.",
  { boss = "queen", phase = "flower", difficulty = "abyss", goal = { frames = 30 * S },
    by = "grazes", medals = { 80, 160 } })
dive("throne", "Audience", "Beat the Queen with two lives.",
  { boss = "queen", difficulty = "normal", lives = 2, clear = true, by = "score",
    medals = { 350000, 600000 } })
dive("undertow", "The Tide Returns", "Send her back without a bomb.",
  { boss = "undertow", difficulty = "normal", clear = true, bombs = 0, by = "score",
    medals = { 120000, 180000 } })

-- ---- the moon ----

dive("tithe", "Tithe", "Graze 120 under the waxing moon.",
  { boss = "moon", phase = "gibbous", difficulty = "normal", goal = { grazes = 120 }, bombs = 0,
    limit = 45 * S, medals = { 27 * S, 20 * S }, needs = "rush" })
dive("eclipse", "Eclipse", "Survive The Sea Falls In.",
  { boss = "moon", phase = "eclipse", difficulty = "normal", lives = 2, clear = true,
    by = "grazes", medals = { 60, 120 }, needs = "rush" })

-- missions.lua - short dives with one thing to do in each.
local S <const> = 60 -- frames of a second

mission.def("first_light", { title = "First Light", text = "Chain 20 in the shallows.",
  stage = "one", to = "deep", goal = { chain = 20 }, medals = { 14 * S, 9 * S } })

-- players/pilots.lua - the pilots as speakers in dialogue, by player kind.
local function pilot(kinds, name, voice)
  for _, kind in ipairs(kinds) do
    talk.def(kind, { name = name, voice = voice,
                     faces = { calm = voice, cross = voice .. "_cross" } })
  end
end

pilot({ "heron_lens" }, "Iri", "iri")
pilot({ "petrel_swarm" }, "Sen", "sen")
pilot({ "tern", "tern_hooks" }, "Ono", "ono")

-- players/forms.lua - the texts and ratings of the crafts and their forms for the select screen.
return {
  heron = { text = "Iri's: quick and narrow.", forms = {
    { kind = "heron", title = "DARTS", text = "Two darts abreast, beads that aim ahead.",
      figures = { { "POWER", 4 }, { "RANGE", 2 }, { "SPEED", 5 } } },
    { kind = "heron_lens", title = "LENS", text = "A ray that pierces everything.",
      figures = { { "POWER", 3 }, { "RANGE", 3 }, { "SPEED", 4 } } } } },
  petrel = { text = "Sen's: slower and wide.", forms = {
    { kind = "petrel", title = "FANGS", text = "A fan that closes while you focus.",
      figures = { { "POWER", 4 }, { "RANGE", 4 }, { "SPEED", 2 } } },
    { kind = "petrel_swarm", title = "SWARM", text = "Motes that home in on enemies.",
      figures = { { "POWER", 2 }, { "RANGE", 5 }, { "SPEED", 3 } } } } },
  tern = { text = "Ono's: heavy, with a lamp.", forms = {
    { kind = "tern", title = "LANCES", text = "Pierce three in a row; beads trail behind.",
      figures = { { "POWER", 5 }, { "RANGE", 2 }, { "SPEED", 3 } } },
    { kind = "tern_hooks", title = "HOOKS", text = "Fly out, come back, and hit both ways.",
      figures = { { "POWER", 5 }, { "RANGE", 3 }, { "SPEED", 3 } } } } } }

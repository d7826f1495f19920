-- players/forms.lua - what is told of the craft and their forms where they are chosen.
return {
  heron = { text = "Iri's: quick and narrow.", forms = {
    { kind = "heron", title = "DARTS", text = "Two darts abreast, beads that aim ahead.",
      figures = { { "FORCE", 4 }, { "RANGE", 2 }, { "SPEED", 5 } } },
    { kind = "heron_lens", title = "LENS", text = "A ray that goes through all it meets.",
      figures = { { "FORCE", 3 }, { "RANGE", 3 }, { "SPEED", 4 } } } } },
  petrel = { text = "Sen's: slower and wide.", forms = {
    { kind = "petrel", title = "FANGS", text = "A fan that closes while you focus.",
      figures = { { "FORCE", 4 }, { "RANGE", 4 }, { "SPEED", 2 } } },
    { kind = "petrel_swarm", title = "SWARM", text = "Motes that find their way.",
      figures = { { "FORCE", 2 }, { "RANGE", 5 }, { "SPEED", 3 } } } } },
  tern = { text = "Ono's: heavy, with a lamp.", forms = {
    { kind = "tern", title = "LANCES", text = "Pierce three in a row; beads trail behind.",
      figures = { { "FORCE", 5 }, { "RANGE", 2 }, { "SPEED", 3 } } },
    { kind = "tern_hooks", title = "HOOKS", text = "Fly out, come back, and hit both ways.",
      figures = { { "FORCE", 5 }, { "RANGE", 3 }, { "SPEED", 3 } } } } } }

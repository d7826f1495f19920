-- players/forms.lua - the texts and ratings of the crafts and their forms for the select screen.
return {
  heron = { text = "Iri's: quick and narrow.", forms = {
    { kind = "heron", title = "Darts", text = "Two darts abreast, beads that aim ahead.",
      figures = { { "Power", 4 }, { "Range", 2 }, { "Speed", 5 } } },
    { kind = "heron_lens", title = "Lens", text = "A ray that pierces everything.",
      figures = { { "Power", 3 }, { "Range", 3 }, { "Speed", 4 } } } } },
  petrel = { text = "Sen's: slower and wide.", forms = {
    { kind = "petrel", title = "Fangs", text = "A fan that closes while you focus.",
      figures = { { "Power", 4 }, { "Range", 4 }, { "Speed", 2 } } },
    { kind = "petrel_swarm", title = "Swarm", text = "Motes that home in on enemies.",
      figures = { { "Power", 2 }, { "Range", 5 }, { "Speed", 3 } } } } },
  tern = { text = "Ono's: heavy, with a lamp.", forms = {
    { kind = "tern", title = "Lances", text = "Pierce three in a row; beads trail behind.",
      figures = { { "Power", 5 }, { "Range", 2 }, { "Speed", 3 } } },
    { kind = "tern_hooks", title = "Hooks", text = "Fly out, come back, and hit both ways.",
      figures = { { "Power", 5 }, { "Range", 3 }, { "Speed", 3 } } } } } }

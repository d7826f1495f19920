-- players/forms.lua - the texts and ratings of the crafts and their forms for the select screen.
return {
  heron = { text = "Iri's ship is fast. Its shot is narrow.", forms = {
    { kind = "heron", title = "Darts", text = "Two darts fly side by side. Beads aim ahead.",
      figures = { { "Power", 4 }, { "Range", 2 }, { "Speed", 5 } } },
    { kind = "heron_lens", title = "Lens", text = "A ray pierces everything.",
      figures = { { "Power", 3 }, { "Range", 3 }, { "Speed", 4 } } } } },
  petrel = { text = "Sen's ship is slower. Its shot is wide.", forms = {
    { kind = "petrel", title = "Fangs", text = "The fan of shots closes while you focus.",
      figures = { { "Power", 4 }, { "Range", 4 }, { "Speed", 2 } } },
    { kind = "petrel_swarm", title = "Swarm", text = "Motes home in on enemies.",
      figures = { { "Power", 2 }, { "Range", 5 }, { "Speed", 3 } } } } },
  tern = { text = "Ono's ship is heavy and carries a lamp.", forms = {
    { kind = "tern", title = "Lances", text = "Lances pierce three enemies. Beads trail behind.",
      figures = { { "Power", 5 }, { "Range", 2 }, { "Speed", 3 } } },
    { kind = "tern_hooks", title = "Hooks", text = "Hooks fly out and back, and hit both ways.",
      figures = { { "Power", 5 }, { "Range", 3 }, { "Speed", 3 } } } } } }

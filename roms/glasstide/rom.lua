-- rom.lua - Glass Tide: what the packer needs to know. tools/art/art.c draws the pictures in art/.
return {
  id = "glasstide", title = "Glass Tide", author = "The Curtain authors", version = 1, entry = "main",
  screen = { w = 240, h = 320 },
  board = { bullets = 4096, shots = 512, enemies = 128, sparks = 4096, sprites = 96, motions = 192,
            tasks = 1024, lua_kib = 4096,
            -- what only some games need: bullets that can be shot, that circle something, that
            -- stand still, and that have numbers of their own; bosses of parts, shots that go through
            hp = true, around = true, frozen = true, values = { bullet = 4 },
            bodies = true, pierce = true,
            items = 512, lasers = 32, options = 8,
            wide = true }, -- cells that hold any character
  palette = "art/palette.png", font = "art/font.png",
  -- each stage has creatures and scenery in colours of its own (banks 10 to 13)
  palettes = { one = "art/palette_one.png", two = "art/palette_two.png",
               three = "art/palette_three.png", moon = "art/palette_moon.png" },
  -- what the cells' font lacks comes from here
  fonts = { kana = { file = "art/kana.png", cell = { 8, 8 }, fixed = true, chars =
    "ァアィイゥウェエォオカガキギクグケゲコゴサザシジスズセゼソゾタダチヂッツヅテデトドナニヌネノ" ..
    "ハバパヒビピフブプヘベペホボポマミムメモャヤュユョヨラリルレロヮワヰヱヲンヴヵヶ・ー、。「」" } },
  sheets = {
    bullets = { file = "art/bullets.png", bank = 0 },
    shots   = { file = "art/shots.png",   bank = 0 },
    sparks  = { file = "art/sparks.png",  bank = 0 },
    finds   = { file = "art/finds.png",   bank = 0 },
    blasts  = { file = "art/blasts.png",  bank = 14 },
    fires   = { file = "art/fires.png",   bank = 14 },
    lights  = { file = "art/lights.png",  bank = 0 },
    sherds  = { file = "art/sherds.png",  bank = 10 },
    logo    = { file = "art/logo.png",    bank = 15 },
    -- crafts, and who flies them
    heron   = { file = "art/heron.png",   bank = 8 },
    petrel  = { file = "art/petrel.png",  bank = 9 },
    iri     = { file = "art/iri.png",     bank = 8 },
    sen     = { file = "art/sen.png",     bank = 8 },
    -- stage one
    enemies = { file = "art/enemies.png", bank = 10 },
    shoal   = { file = "art/shoal.png",   bank = 10, palette = "one" },
    lantern_nautilus = { file = "art/lantern_nautilus.png", bank = 12, palette = "one" },
    crab    = { file = "art/crab.png",    bank = 12, palette = "one" },
    crab_face = { file = "art/crab_face.png", bank = 12, palette = "one" },
    shafts  = { file = "art/shafts.png",  bank = 13, palette = "one" },
    -- stage two

    -- stage three
    queen   = { file = "art/queen.png",   bank = 12 },
    queen_face = { file = "art/queen_face.png", bank = 12 },
    -- the moon

  },
  sprites = {
    -- bullets: what turns is drawn pointing right
    pellet = { sheet = "bullets", x = 0,   y = 0,  w = 8,  h = 8 },
    orb    = { sheet = "bullets", x = 16,  y = 0,  w = 12, h = 12 },
    ring   = { sheet = "bullets", x = 32,  y = 0,  w = 16, h = 16 },
    rice   = { sheet = "bullets", x = 48,  y = 0,  w = 12, h = 12, rotations = 32 },
    kunai  = { sheet = "bullets", x = 64,  y = 0,  w = 14, h = 14, rotations = 32 },
    drop   = { sheet = "bullets", x = 80,  y = 0,  w = 14, h = 14, rotations = 32 },
    shard  = { sheet = "bullets", x = 96,  y = 0,  w = 14, h = 14, rotations = 32 },
    petal  = { sheet = "bullets", x = 112, y = 0,  w = 14, h = 14, rotations = 32 },
    star   = { sheet = "bullets", x = 0,   y = 16, w = 16, h = 16, frames = 4, every = 4 },
    needle = { sheet = "bullets", x = 64,  y = 16, w = 16, h = 16, rotations = 32 },
    big    = { sheet = "bullets", x = 0,   y = 32, w = 24, h = 24 },
    marble = { sheet = "bullets", x = 32,  y = 32, w = 32, h = 32 },
    pearl  = { sheet = "bullets", x = 64,  y = 32, w = 18, h = 18 },
    bubble = { sheet = "bullets", x = 96,  y = 32, w = 24, h = 24 },
    mist   = { sheet = "bullets", x = 0,   y = 64, w = 24, h = 24, frames = 4,
               sizes = { 70, 150 } },
    lance  = { sheet = "bullets", x = 96,  y = 64, w = 28, h = 28, rotations = 64 },
    lamp   = { sheet = "bullets", x = 0,   y = 92, w = 24, h = 24, frames = 4, every = 5 },

    dart   = { sheet = "shots", x = 0,  y = 0, w = 16, h = 16, rotations = 32 },
    fang   = { sheet = "shots", x = 16, y = 0, w = 14, h = 14, rotations = 32 },
    sliver = { sheet = "shots", x = 32, y = 0, w = 12, h = 12, rotations = 32 },

    heron  = { sheet = "heron",  x = 0, y = 0,  w = 28, h = 36, frames = 4, every = 3,
               origin = { 14, 17 } },
    petrel = { sheet = "petrel", x = 0, y = 0,  w = 30, h = 34, frames = 4, every = 3,
               origin = { 15, 16 } },
    heron_bead  = { sheet = "heron",  x = 0, y = 38, w = 14, h = 14, frames = 2, every = 8 },
    petrel_bead = { sheet = "petrel", x = 0, y = 38, w = 14, h = 14, frames = 2, every = 8 },

    -- stage one
    krill    = { sheet = "enemies", x = 0,  y = 0,   w = 20, h = 22, frames = 4, every = 5 },
    fish     = { sheet = "enemies", x = 80, y = 0,   w = 28, h = 32, frames = 4, every = 6 },
    jelly    = { sheet = "enemies", x = 0,  y = 32,  w = 36, h = 44, frames = 4, every = 9,
                 origin = { 18, 17 } },
    ray      = { sheet = "enemies", x = 0,  y = 76,  w = 52, h = 44, frames = 4, every = 8,
                 origin = { 26, 26 } },
    urchin   = { sheet = "enemies", x = 0,  y = 120, w = 38, h = 38, frames = 4, every = 7 },
    nautilus = { sheet = "enemies", x = 0,  y = 158, w = 44, h = 42, frames = 4, every = 9,
                 origin = { 20, 20 } },
    float    = { sheet = "enemies", x = 0,  y = 200, w = 36, h = 40, frames = 4, every = 12,
                 origin = { 18, 22 } },
    arrow    = { sheet = "shoal",   x = 0,  y = 0,   w = 30, h = 44, frames = 4, every = 7,
                 origin = { 15, 26 } },
    seahorse = { sheet = "shoal",   x = 0,  y = 46,  w = 32, h = 48, frames = 4, every = 6 },
    hatch      = { sheet = "shoal", x = 0,  y = 96,  w = 40, h = 40 },
    hatch_ajar = { sheet = "shoal", x = 40, y = 96,  w = 40, h = 40 },
    hatch_half = { sheet = "shoal", x = 80, y = 96,  w = 40, h = 40 },
    hatch_open = { sheet = "shoal", x = 120, y = 96, w = 40, h = 40 },
    lantern_nautilus = { sheet = "lantern_nautilus", x = 0, y = 0, w = 84, h = 80, frames = 4,
                         every = 9, origin = { 40, 36 } },
    crab     = { sheet = "crab",    x = 0,  y = 0,   w = 112, h = 88, frames = 4, every = 9,
                 origin = { 56, 44 } },
    claw     = { sheet = "crab",    x = 0,  y = 88,  w = 48, h = 64, frames = 4, every = 9 },
    shaft       = { sheet = "shafts", x = 0,   y = 0, w = 112, h = 320 },
    shaft_thin  = { sheet = "shafts", x = 112, y = 0, w = 112, h = 320 },
    -- stage two

    -- stage three
    queen    = { sheet = "queen",   x = 0,  y = 0,   w = 96, h = 96, frames = 4, every = 10,
                 origin = { 48, 44 } },
    -- the moon

    -- who talks
    iri         = { sheet = "iri",        x = 0,  y = 0, w = 72, h = 96 },
    iri_cross   = { sheet = "iri",        x = 72, y = 0, w = 72, h = 96 },
    sen         = { sheet = "sen",        x = 0,  y = 0, w = 72, h = 96 },
    sen_cross   = { sheet = "sen",        x = 72, y = 0, w = 72, h = 96 },
    crab_face   = { sheet = "crab_face",  x = 0,  y = 0, w = 72, h = 96 },
    crab_cross  = { sheet = "crab_face",  x = 72, y = 0, w = 72, h = 96 },
    queen_face  = { sheet = "queen_face", x = 0,  y = 0, w = 72, h = 96 },
    queen_cross = { sheet = "queen_face", x = 72, y = 0, w = 72, h = 96 },

    -- sparks, and what a craft wears
    glint   = { sheet = "sparks", x = 0,   y = 0,  w = 12, h = 12, frames = 4, every = 4 },
    crumb   = { sheet = "sparks", x = 48,  y = 0,  w = 8,  h = 8,  frames = 4, every = 3 },
    hoop    = { sheet = "sparks", x = 80,  y = 0,  w = 12, h = 12, frames = 4, every = 3 },
    dot     = { sheet = "sparks", x = 128, y = 0,  w = 8,  h = 8 },
    fizz    = { sheet = "sparks", x = 160, y = 0,  w = 7,  h = 7 },
    halo    = { sheet = "sparks", x = 0,   y = 16, w = 48, h = 48, frames = 4, every = 5 },
    shock   = { sheet = "sparks", x = 0,   y = 64, w = 48, h = 48, frames = 8, every = 2 },
    blast   = { sheet = "blasts", x = 0,   y = 0,  w = 32, h = 32, frames = 8, every = 3 },
    blaze   = { sheet = "blasts", x = 0,   y = 32, w = 72, h = 72, frames = 8, every = 4 },
    -- fire in three sizes, light that is added, and what glass leaves: fx.lua
    fire_a  = { sheet = "fires",  x = 0, y = 0,   w = 32,  h = 32,  frames = 10, every = 3 },
    fire_b  = { sheet = "fires",  x = 0, y = 32,  w = 32,  h = 32,  frames = 10, every = 3 },
    fire_c  = { sheet = "fires",  x = 0, y = 64,  w = 64,  h = 64,  frames = 10, every = 4 },
    fire_d  = { sheet = "fires",  x = 0, y = 128, w = 64,  h = 64,  frames = 10, every = 4 },
    fire_e  = { sheet = "fires",  x = 0, y = 192, w = 112, h = 112, frames = 14, every = 4 },
    flare   = { sheet = "lights", x = 0, y = 0,   w = 64,  h = 64,  frames = 6, every = 3 },
    ripple  = { sheet = "lights", x = 0, y = 64,  w = 64,  h = 64,  frames = 8, every = 3 },
    breaker = { sheet = "lights", x = 0, y = 128, w = 144, h = 144, frames = 8, every = 4 },
    sherd_s = { sheet = "sherds", x = 0, y = 0,   w = 8,   h = 8,   frames = 8, every = 3 },
    sherd_m = { sheet = "sherds", x = 0, y = 8,   w = 12,  h = 12,  frames = 8, every = 4 },
    sherd_l = { sheet = "sherds", x = 0, y = 20,  w = 18,  h = 18,  frames = 8, every = 5 },
    bubbles = { sheet = "sherds", x = 0, y = 38,  w = 12,  h = 12,  frames = 4, every = 14 },

    nacre    = { sheet = "finds", x = 0,  y = 0, w = 14, h = 14 },
    conch    = { sheet = "finds", x = 16, y = 0, w = 16, h = 16 },
    heart    = { sheet = "finds", x = 32, y = 0, w = 16, h = 16 },
    foam     = { sheet = "finds", x = 48, y = 0, w = 8,  h = 8 },
    ray_of_light = { sheet = "finds", x = 60, y = 0, w = 1, h = 16 },
    logo     = { sheet = "logo",  x = 0, y = 0,   w = 208, h = 112 },
  },
  maps = {
    -- stage one
    floor    = { tiles = "art/floor.png",  bank = 13, file = "maps/floor.csv" },
    caustics = { tiles = "art/floor.png",  bank = 13, file = "maps/caustics.csv" },
    reef     = { tiles = "art/reef.png",   bank = 13, file = "maps/reef.tmx", size = 8 },
    kelp     = { tiles = "art/kelp.png",   bank = 13, file = "maps/floor.csv", palette = "one" },
    wreck    = { tiles = "art/wreck.png",  bank = 13, file = "maps/wreck.csv", palette = "one" },
    -- stage two

    -- stage three
    seabed   = { tiles = "art/seabed.png", bank = 13, file = "maps/seabed.csv" },
    -- the moon

  },
  blends = { ghost = { mix = 50 }, glow = "add" },
  -- What is heard often is short and gives way first. The first eleven play by themselves.
  sounds = {
    graze    = { mml = "t300 @fm E0,25,0,10 o7 V64 g32", priority = 1 },
    item     = { mml = "t300 @fm E0,60,0,30 o6 V84 a32>d16", priority = 2 },
    kill     = { file = "sfx/kill.mml", priority = 3, limit = 2 },
    menu     = { mml = "t300 @sine E0,40,0,20 o5 V90 e32a16", priority = 5 },
    time     = { mml = "t300 @fm E0,22,0,12 o6 V96 c16", priority = 5, limit = 1 },
    spell    = { file = "sfx/spell.mml", priority = 5, limit = 1 },
    warning  = { file = "sfx/warning.mml", priority = 6, limit = 1 },
    bomb     = { file = "sfx/bomb.mml", priority = 6, limit = 1 },
    extend   = { file = "sfx/extend.mml", priority = 6, limit = 1 },
    hit      = { file = "sfx/hit.mml", priority = 7, limit = 1 },
    -- each craft fires, and a creature is hurt
    dart     = { mml = "t300 @pulse E0,16,0,6 o6 V100 {c<g}32", priority = 0, limit = 1 },
    fang     = { mml = "t300 @triangle E0,22,0,8 o5 V76 {a<d}16", priority = 0, limit = 1 },
    chip     = { mml = "t300 @fm E0,11,0,6 o6 V92 b64", priority = 0, limit = 1 },
    -- what breaks, by size
    crash    = { file = "sfx/crash.mml", priority = 4, limit = 1 },
    shatter  = { file = "sfx/shatter.mml", priority = 4, limit = 1 },
    lamp     = { file = "sfx/lamp.mml", priority = 4, limit = 1 },
    phase    = { file = "sfx/phase.mml", priority = 6, limit = 1 },
    collapse = { file = "sfx/collapse.mml", priority = 7, limit = 1 },
    -- what is found and won
    conch    = { file = "sfx/conch.mml", priority = 5, limit = 1 },
    power    = { file = "sfx/power.mml", priority = 5, limit = 1 },
    bonus    = { file = "sfx/bonus.mml", priority = 6, limit = 1 },
    -- what bosses do
    charge   = { file = "sfx/charge.mml", priority = 4, limit = 1 },
    beam     = { file = "sfx/beam.mml", priority = 4, limit = 1 },
    still    = { file = "sfx/still.mml", priority = 5, limit = 1 },
    flow     = { file = "sfx/flow.mml", priority = 5, limit = 1 },
    -- stage one: a claw breaks, a hatch opens, a bubble bursts; the crab speaks
    claw     = { file = "sfx/claw.mml", priority = 6, limit = 1 },
    hatch    = { file = "sfx/hatch.mml", priority = 4, limit = 1 },
    bubble   = { file = "sfx/bubble.mml", priority = 2, limit = 2 },
    the_crab = { mml = "t300 @pulse E0,18,0,8 o4 V104 f64c64", priority = 5, limit = 1 },
    snap     = { mml = "t300 @pulse E0,20,0,10 o4 V112 {g>c}32", priority = 4, limit = 1 },

    -- stage two: the works, and the voices of the two eels
    pour     = { file = "sfx/pour.mml", priority = 4, limit = 1 },
    steam    = { file = "sfx/steam.mml", priority = 3, limit = 2 },
    gear     = { file = "sfx/gear.mml", priority = 3, limit = 1 },
    reflect  = { file = "sfx/reflect.mml", priority = 2, limit = 2 },
    cinder_cry = { file = "sfx/cinder_cry.mml", priority = 6, limit = 1 },
    quench_cry = { file = "sfx/quench_cry.mml", priority = 6, limit = 1 },
    cinder   = { mml = "t300 @saw E1,24,0,12 o4 V72 {d<b}32", priority = 5, limit = 1 },
    quench   = { mml = "t300 @sine E2,30,0,16 o6 V80 {d<a}32", priority = 5, limit = 1 },

    -- stage three: a lamp in the dark, the queen's five glasses
    angler   = { file = "sfx/angler.mml", priority = 5, limit = 1 },
    chord    = { file = "sfx/chord.mml", priority = 5, limit = 1 },

    -- the moon: its bell, its voice
    toll     = { file = "sfx/toll.mml", priority = 6, limit = 1 },
    the_moon = { mml = "t300 @fm E4,60,0,40 o3 V92 a16", priority = 5, limit = 1 },

    -- crafts: what the tern fires, shots that are gathered, bombs; gauge, chain, tasks
    peal     = { mml = "t300 @fm E0,30,0,12 o5 V72 {d>d}32", priority = 0, limit = 1 },
    charge_shot = { file = "sfx/charge_shot.mml", priority = 3, limit = 1 },
    ray      = { file = "sfx/ray.mml", priority = 3, limit = 1 },
    bell_bomb = { file = "sfx/bell_bomb.mml", priority = 6, limit = 1, duck = 0.7 },
    lamp_bomb = { file = "sfx/lamp_bomb.mml", priority = 6, limit = 1, duck = 0.7 },
    full     = { file = "sfx/full.mml", priority = 5, limit = 1 },
    release  = { file = "sfx/release.mml", priority = 6, limit = 1 },
    shard    = { file = "sfx/shard.mml", priority = 2, limit = 2 },
    medal    = { file = "sfx/medal.mml", priority = 3, limit = 2 },
    chain_one   = { file = "sfx/chain_one.mml", priority = 4, limit = 1 },
    chain_two   = { file = "sfx/chain_two.mml", priority = 4, limit = 1 },
    chain_three = { file = "sfx/chain_three.mml", priority = 5, limit = 1 },
    mission  = { file = "sfx/mission.mml", priority = 6, limit = 1 },
    failed   = { file = "sfx/failed.mml", priority = 6, limit = 1 },
    ono      = { mml = "t300 @fm E1,22,0,12 o5 V88 {g>c}32", priority = 5, limit = 1 },

    -- a boss comes in; a clock's last seconds; what is unlocked
    entrance = { file = "sfx/entrance.mml", priority = 6, limit = 1 },
    tick     = { mml = "t300 @pulse E0,14,0,8 o6 V84 g32", priority = 5, limit = 1 },
    unlock   = { file = "sfx/unlock.mml", priority = 6, limit = 1 },
    -- menus, and the way round
    select   = { file = "sfx/select.mml", priority = 5, limit = 1 },
    back     = { file = "sfx/back.mml", priority = 5, limit = 1 },
    wrong    = { mml = "t300 @pulse E2,90,20,20 o3 V124 c16r32c8", priority = 5, limit = 1 },
    pause    = { file = "sfx/pause.mml", priority = 6, limit = 1 },
    continue = { file = "sfx/continue.mml", priority = 6, limit = 1 },
    ready    = { file = "sfx/ready.mml", priority = 6, limit = 1 },
    -- voices of those who talk, a letter each
    iri       = { mml = "t300 @pulse E1,22,0,10 o5 V116 a32", priority = 5, limit = 1 },
    sen       = { mml = "t300 @triangle E1,24,0,10 o5 V84 d32", priority = 5, limit = 1 },
    the_crab  = { mml = "t300 @noise E0,14,0,8 o6 V118 c64r64c64", priority = 5, limit = 1 },
    the_queen = { mml = "t300 @fm E1,34,0,16 o4 V84 {a<a}16", priority = 5, limit = 1 },
  },
  music = { -- each file says its key, chords and form; docs/music.md
    title   = { file = "music/title.mml", volume = 0.74 },
    opening = { file = "music/opening.mml", volume = 0.74 },
    -- stages
    tide    = { file = "music/tide.mml", volume = 0.71 },
    works   = { file = "music/works.mml", volume = 0.71 },
    abyss   = { file = "music/abyss.mml", volume = 0.71 },
    caravan = { file = "music/caravan.mml", volume = 0.71 },
    -- bosses
    lantern = { file = "music/lantern.mml", volume = 0.75 },
    claws   = { file = "music/claws.mml", volume = 0.75 },
    furnace = { file = "music/furnace.mml", volume = 0.75 },
    queen   = { file = "music/queen.mml", volume = 0.75 },
    moon    = { file = "music/moon.mml", volume = 0.75 },
    -- and afterwards
    clear   = { file = "music/clear.mml", volume = 0.64 },
    over    = { file = "music/over.mml", volume = 0.62 },
    ending  = { file = "music/ending.mml", volume = 0.82 },
    true_ending = { file = "music/true_ending.mml", volume = 0.82 },
    staff   = { file = "music/staff.mml", volume = 0.82 },
    scores  = { file = "music/scores.mml", volume = 0.82 },
  },
  difficulties = { "easy", "normal", "hard", "abyss" }, difficulty = "normal",
  players = 2, extends = { 100000, 300000 },
}

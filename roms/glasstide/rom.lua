-- rom.lua - the manifest of Glass Tide. source/art/art.c draws the pictures in art/.
local rom = {
  id = "glasstide", title = "Glass Tide", author = "The Curtain authors", version = 1, entry = "main",
  screen = { w = 240, h = 320, full_width = 12 }, border = "art/border.png",
  board = { bullets = 4096, shots = 512, enemies = 128, sparks = 4096, sprites = 96, motions = 192,
            tasks = 1024, lua_kib = 4096,
            -- optional: bullets with hp, that orbit something, that can be frozen, and that have
            -- declared values; enemies with parts, piercing shots
            hp = true, around = true, frozen = true, values = { bullet = 4 },
            bodies = true, pierce = true,
            items = 1024, lasers = 64, curve_points = 2048, options = 8, lines = 64,
            registers = 128,
            wide = true }, -- text cells for any character
  palette = "art/palette.png", font = "art/font.png",
  theme = { ink = 0, accent = 3, rule = 9, paper = 1 }, -- the program's screens, in the banks of hud.banks (main.lua)
  -- each stage has its own colours for creatures and scenery (banks 10 to 13)
  palettes = { one = "art/palette_one.png", deep = "art/palette_deep.png",
               two = "art/palette_two.png", three = "art/palette_three.png",
               moon = "art/palette_moon.png", dark = "art/palette_dark.png",
               story = "art/palette_story.png" },
  -- Japanese of 8 px, for the HUD, and of 12 px; make copies the fonts from Debian's fonts-misaki and
  -- xfonts-efont-unicode
  fonts = { japanese = { file = "art/misaki_gothic.ttf", size = 8, ink = 13, shadow = true, optional = true },
            japanese_12 = { file = "art/efont_12.bdf", ink = 13, shadow = true, optional = true } },
  sheets = {
    bullets = { file = "art/bullets.png", bank = 0 },
    shots   = { file = "art/shots.png",   bank = 0 },
    sparks  = { file = "art/sparks.png",  bank = 0 },
    finds   = { file = "art/finds.png",   bank = 0 },
    fires   = { file = "art/fires.png",   bank = 14 },
    lights  = { file = "art/lights.png",  bank = 0 },
    sherds  = { file = "art/sherds.png",  bank = 10 },
    logo    = { file = "art/logo.png",    bank = 15 },
    logo_light = { file = "art/logo_light.png", bank = 15 },
    marker  = { file = "art/marker.png",  bank = 1 },
    gems    = { file = "art/gems.png",    bank = 0 },
    -- crafts and pilots
    heron   = { file = "art/heron.png",   bank = 8 },
    petrel  = { file = "art/petrel.png",  bank = 9 },
    tern    = { file = "art/tern.png",    bank = 8 },
    arms    = { file = "art/arms.png",    bank = 0 },
    iri     = { file = "art/iri.png",     bank = 8 },
    sen     = { file = "art/sen.png",     bank = 8 },
    ono     = { file = "art/ono.png",     bank = 8 },
    -- stage one
    enemies = { file = "art/enemies.png", bank = 10 },
    shoal   = { file = "art/shoal.png",   bank = 10, palette = "one" },
    enemies_poses = { file = "art/enemies_poses.png", bank = 10 },
    shoal_poses = { file = "art/shoal_poses.png", bank = 10, palette = "one" },
    lantern_nautilus = { file = "art/lantern_nautilus.png", bank = 12, palette = "one" },
    crab    = { file = "art/crab.png",    bank = 12, palette = "one" },
    crab_face = { file = "art/crab_face.png", bank = 12, palette = "one" },
    shafts  = { file = "art/shafts.png",  bank = 13, palette = "one" },
    bones   = { file = "art/bones.png",   bank = 10, palette = "one" },
    -- stage two
    creatures_two = { file = "art/creatures_two.png", bank = 10, palette = "two" },
    train   = { file = "art/train.png",   bank = 10, palette = "two" },
    creatures_two_poses = { file = "art/creatures_two_poses.png", bank = 10, palette = "two" },
    bullets_two = { file = "art/bullets_two.png", bank = 0 },
    bellows = { file = "art/bellows.png", bank = 12, palette = "two" },
    cinder  = { file = "art/cinder.png",  bank = 12, palette = "two" },
    quench  = { file = "art/quench.png",  bank = 11, palette = "two" },
    cinder_face = { file = "art/cinder_face.png", bank = 12, palette = "two" },
    quench_face = { file = "art/quench_face.png", bank = 11, palette = "two" },
    -- stage three
    lamplight = { file = "art/lamplight.png", bank = 0, palette = "three" },
    queen   = { file = "art/queen.png",   bank = 12 },
    queen_abyss = { file = "art/queen_abyss.png", bank = 12, palette = "three" },
    queen_face = { file = "art/queen_face.png", bank = 12, palette = "three" },
    abyss_life = { file = "art/abyss_life.png", bank = 10, palette = "three" },
    quay_lamps = { file = "art/quay_lamps.png", bank = 10, palette = "three" },
    gulper  = { file = "art/gulper.png",  bank = 10, palette = "three" },
    abyss_life_poses = { file = "art/abyss_life_poses.png", bank = 10, palette = "three" },
    gulper_poses = { file = "art/gulper_poses.png", bank = 10, palette = "three" },
    angler  = { file = "art/angler.png",  bank = 12, palette = "three" },
    -- the moon
    -- unlockable colours of the crafts
    heron_gilt = { file = "art/heron_gilt.png", bank = 15 },
    petrel_gilt = { file = "art/petrel_gilt.png", bank = 15 },
    tern_gilt = { file = "art/tern_gilt.png", bank = 15 },
    heron_ember = { file = "art/heron_ember.png", bank = 14 },
    petrel_ember = { file = "art/petrel_ember.png", bank = 14 },
    tern_ember = { file = "art/tern_ember.png", bank = 14 },
    last    = { file = "art/last.png",    bank = 12, palette = "moon" },
    last_face = { file = "art/last_face.png", bank = 12, palette = "moon" },
    -- pictures of the opening and the endings
    dry     = { file = "art/dry.png",     bank = 8,  palette = "story" },
    brink   = { file = "art/brink.png",   bank = 9,  palette = "story" },
    wave    = { file = "art/wave.png",    bank = 10, palette = "story" },
    dive    = { file = "art/dive.png",    bank = 11, palette = "story" },
    flood   = { file = "art/flood.png",   bank = 12, palette = "story" },
    home    = { file = "art/home.png",    bank = 14, palette = "story" },

  },
  sprites = {
    -- bullets; sprites with rotations point right
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

    dart   = { sheet = "shots", x = 0,  y = 16, w = 40, h = 40, rotations = 32 },
    fang   = { sheet = "arms",  x = 0,  y = 0,  w = 24, h = 24, rotations = 32 },
    sliver = { sheet = "shots", x = 40, y = 16, w = 22, h = 22, rotations = 32 },
    pike   = { sheet = "arms",  x = 0,  y = 56, w = 56, h = 56, rotations = 64 },
    hook   = { sheet = "arms",  x = 32, y = 0,  w = 28, h = 28, rotations = 32 },
    mote   = { sheet = "arms",  x = 56, y = 56, w = 32, h = 32, rotations = 32 },
    prism  = { sheet = "arms",  x = 64, y = 0, w = 12, h = 10, frames = 4, every = 3 },
    lens_ray = { sheet = "arms", x = 116, y = 0, w = 1, h = 14 },
    lamp_ray = { sheet = "arms", x = 120, y = 0, w = 1, h = 52 },

    tern_bead   = { sheet = "tern",   x = 0, y = 38, w = 14, h = 14, frames = 2, every = 8 },
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
    rib         = { sheet = "bones", x = 0,  y = 0,  w = 80, h = 48 },
    flower      = { sheet = "bones", x = 0,  y = 48, w = 40, h = 40 },
    flower_ajar = { sheet = "bones", x = 40, y = 48, w = 40, h = 40 },
    flower_open = { sheet = "bones", x = 80, y = 48, w = 40, h = 40 },
    hatch_ajar = { sheet = "shoal", x = 40, y = 96,  w = 40, h = 40 },
    hatch_half = { sheet = "shoal", x = 80, y = 96,  w = 40, h = 40 },
    hatch_open = { sheet = "shoal", x = 120, y = 96, w = 40, h = 40 },
    claw     = { sheet = "crab",    x = 0,  y = 352, w = 48, h = 64, frames = 6, every = 6 },
    shaft       = { sheet = "shafts", x = 0,   y = 0, w = 112, h = 320 },
    shaft_thin  = { sheet = "shafts", x = 112, y = 0, w = 112, h = 320 },
    -- stage two
    drone    = { sheet = "creatures_two", x = 0,   y = 0,   w = 24, h = 28, frames = 4, every = 5 },
    bottle   = { sheet = "creatures_two", x = 96,  y = 0,   w = 22, h = 34, frames = 4, every = 7 },
    tongs    = { sheet = "creatures_two", x = 0,   y = 36,  w = 36, h = 38, frames = 4, every = 6 },
    worm     = { sheet = "creatures_two", x = 144, y = 36,  w = 32, h = 56, frames = 4, every = 7 },
    puffer   = { sheet = "creatures_two", x = 0,   y = 92,  w = 36, h = 40, frames = 4, every = 8 },
    gear_ray = { sheet = "creatures_two", x = 0,   y = 134, w = 60, h = 50, frames = 4, every = 5 },
    crucible = { sheet = "creatures_two", x = 0,   y = 186, w = 44, h = 46, frames = 4, every = 9 },
    kiln     = { sheet = "creatures_two", x = 0,   y = 234, w = 68, h = 62, frames = 4, every = 9 },
    engine   = { sheet = "train", x = 0,  y = 0,   w = 44, h = 68, frames = 4, every = 5 },
    engine_up = { sheet = "train", x = 0, y = 180, w = 44, h = 68, frames = 4, every = 5 },
    gun      = { sheet = "train", x = 0,  y = 68,  w = 44, h = 56, frames = 4, every = 8 },
    ladle    = { sheet = "train", x = 0,  y = 124, w = 44, h = 56, frames = 4, every = 7 },
    cog      = { sheet = "bullets_two", x = 0,  y = 0,  w = 22, h = 22, frames = 4, every = 3 },
    ember    = { sheet = "bullets_two", x = 92, y = 0,  w = 6,  h = 5,  frames = 4, every = 30 },
    pane     = { sheet = "bullets_two", x = 90, y = 8,  w = 34, h = 12 },
    gob      = { sheet = "bullets_two", x = 0,  y = 24, w = 30, h = 30, frames = 4, every = 7 },
    steam    = { sheet = "bullets_two", x = 0,  y = 56, w = 22, h = 22, frames = 4, every = 8 },
    ingot    = { sheet = "bullets_two", x = 90, y = 56, w = 20, h = 20, rotations = 32 },
    -- stage three
    mite     = { sheet = "abyss_life", x = 0,   y = 0,   w = 24, h = 22, frames = 4, every = 5 },
    bell     = { sheet = "abyss_life", x = 96,  y = 0,   w = 20, h = 22, frames = 4, every = 7 },
    viper    = { sheet = "abyss_life", x = 176, y = 0,   w = 32, h = 52, frames = 4, every = 6,
                 origin = { 16, 32 } },
    chain_head = { sheet = "abyss_life", x = 0, y = 52,  w = 40, h = 44, frames = 4, every = 8,
                 origin = { 20, 17 } },
    comb     = { sheet = "abyss_life", x = 160, y = 52,  w = 36, h = 48, frames = 4, every = 6,
                 origin = { 18, 21 } },
    squid    = { sheet = "abyss_life", x = 0,   y = 100, w = 40, h = 56, frames = 4, every = 7,
                 origin = { 20, 24 } },
    shark    = { sheet = "abyss_life", x = 0,   y = 156, w = 52, h = 72, frames = 4, every = 7,
                 origin = { 26, 44 } },
    spider   = { sheet = "abyss_life", x = 0,   y = 228, w = 60, h = 52, frames = 4, every = 7,
                 origin = { 30, 28 } },
    lamp_out = { sheet = "quay_lamps", x = 0, y = 0, w = 32, h = 40 },
    lamp_lit = { sheet = "quay_lamps", x = 32, y = 0, w = 32, h = 40, frames = 4, every = 6 },
    gulper   = { sheet = "gulper",  x = 0,   y = 0,   w = 64, h = 64, frames = 4, every = 8 },
    lantern  = { sheet = "angler",  x = 0,   y = 384, w = 28, h = 32, frames = 4, every = 6 },
    stalk    = { sheet = "angler",  x = 112, y = 384, w = 8,  h = 8 },
    lamplight = { sheet = "lamplight", x = 0, y = 0, w = 168, h = 168 },
    queen_afar = { sheet = "queen", x = 0,   y = 0,   w = 96, h = 96, frames = 4, every = 14 },
    -- the moon
    moon         = { sheet = "last", x = 0, y = 0,   w = 160, h = 160, frames = 6, every = 8 },
    moon_half    = { sheet = "last", x = 0, y = 160, w = 160, h = 160, frames = 6, every = 8 },
    moon_sickle  = { sheet = "last", x = 0, y = 320, w = 160, h = 160, frames = 6, every = 8 },
    moon_new     = { sheet = "last", x = 0, y = 480, w = 160, h = 160, frames = 6, every = 8 },
    moon_full    = { sheet = "last", x = 0, y = 640, w = 160, h = 160, frames = 6, every = 8 },
    moon_face    = { sheet = "last_face", x = 0,  y = 0, w = 72, h = 96 },
    moon_cross   = { sheet = "last_face", x = 72, y = 0, w = 72, h = 96 },
    moon_cut_in = { sheet = "last_face", x = 0, y = 96, w = 176, h = 60 },
    dry   = { sheet = "dry",   x = 0, y = 0, w = 240, h = 160 },
    brink = { sheet = "brink", x = 0, y = 0, w = 240, h = 160 },
    wave  = { sheet = "wave",  x = 0, y = 0, w = 240, h = 160 },
    dive  = { sheet = "dive",  x = 0, y = 0, w = 240, h = 160 },
    flood = { sheet = "flood", x = 0, y = 0, w = 240, h = 160 },
    home  = { sheet = "home",  x = 0, y = 0, w = 240, h = 160 },
    moon_eclipse = { sheet = "last", x = 0, y = 800, w = 160, h = 160, frames = 6, every = 4 },
    moon_hurt    = { sheet = "last", x = 0, y = 960, w = 160, h = 160, frames = 6, every = 8 },
    moon_broken  = { sheet = "last", x = 0, y = 1120, w = 160, h = 160, frames = 6, every = 8 },
    moon_glare   = { sheet = "last", x = 0, y = 1280, w = 160, h = 160, frames = 6, every = 4 },

    -- portraits
    iri         = { sheet = "iri",        x = 0,  y = 0, w = 72, h = 96 },
    iri_cross   = { sheet = "iri",        x = 72, y = 0, w = 72, h = 96 },
    sen         = { sheet = "sen",        x = 0,  y = 0, w = 72, h = 96 },
    sen_cross   = { sheet = "sen",        x = 72, y = 0, w = 72, h = 96 },
    cinder_face  = { sheet = "cinder_face", x = 0,  y = 0, w = 72, h = 96 },
    cinder_cross = { sheet = "cinder_face", x = 72, y = 0, w = 72, h = 96 },
    cinder_cut_in = { sheet = "cinder_face", x = 0, y = 96, w = 176, h = 60 },
    quench_face  = { sheet = "quench_face", x = 0,  y = 0, w = 72, h = 96 },
    quench_cross = { sheet = "quench_face", x = 72, y = 0, w = 72, h = 96 },
    quench_cut_in = { sheet = "quench_face", x = 0, y = 96, w = 176, h = 60 },
    crab_face   = { sheet = "crab_face",  x = 0,  y = 0, w = 72, h = 96 },
    crab_cross  = { sheet = "crab_face",  x = 72, y = 0, w = 72, h = 96 },
    crab_cut_in = { sheet = "crab_face", x = 0, y = 96, w = 176, h = 60 },
    ono         = { sheet = "ono",        x = 0,  y = 0, w = 72, h = 96 },
    ono_cross   = { sheet = "ono",        x = 72, y = 0, w = 72, h = 96 },
    queen_face  = { sheet = "queen_face", x = 0,  y = 0, w = 72, h = 96 },
    queen_cross = { sheet = "queen_face", x = 72, y = 0, w = 72, h = 96 },
    queen_cut_in = { sheet = "queen_face", x = 0, y = 96, w = 176, h = 60 },

    -- sparks, and sprites on a craft
    glint   = { sheet = "sparks", x = 0,   y = 0,  w = 12, h = 12, frames = 4, every = 4 },
    crumb   = { sheet = "sparks", x = 48,  y = 0,  w = 8,  h = 8,  frames = 4, every = 3 },
    hoop    = { sheet = "sparks", x = 80,  y = 0,  w = 12, h = 12, frames = 4, every = 3 },
    dot     = { sheet = "sparks", x = 128, y = 0,  w = 8,  h = 8 },
    fizz    = { sheet = "sparks", x = 160, y = 0,  w = 7,  h = 7 },
    halo    = { sheet = "sparks", x = 0,   y = 16, w = 48, h = 48, frames = 4, every = 5 },
    shock   = { sheet = "sparks", x = 0,   y = 64, w = 48, h = 48, frames = 8, every = 2 },
    -- fire in three sizes, additive light, and glass debris: sparks.lua
    fire_a  = { sheet = "fires",  x = 0, y = 0,   w = 32,  h = 32,  frames = 10, every = 3 },
    fire_b  = { sheet = "fires",  x = 0, y = 32,  w = 32,  h = 32,  frames = 10, every = 3 },
    fire_c  = { sheet = "fires",  x = 0, y = 64,  w = 64,  h = 64,  frames = 10, every = 4 },
    fire_d  = { sheet = "fires",  x = 0, y = 128, w = 64,  h = 64,  frames = 10, every = 4 },
    fire_e  = { sheet = "fires",  x = 0, y = 192, w = 112, h = 112, frames = 14, every = 4 },
    flare   = { sheet = "lights", x = 0, y = 0,   w = 64,  h = 64,  frames = 6, every = 3 },
    ripple  = { sheet = "lights", x = 0, y = 64,  w = 64,  h = 64,  frames = 8, every = 3 },
    breaker = { sheet = "lights", x = 0, y = 128, w = 144, h = 144, frames = 8, every = 4 },
    shine   = { sheet = "lights", x = 0, y = 272, w = 48,  h = 48,  frames = 6, every = 2 },
    muzzle  = { sheet = "lights", x = 288, y = 272, w = 20, h = 20, frames = 3, every = 2 },
    spit    = { sheet = "lights", x = 348, y = 272, w = 20, h = 20, frames = 3, every = 3 },
    swell   = { sheet = "lights", x = 0, y = 320, w = 192, h = 192, frames = 6, every = 4 },
    sherd_s = { sheet = "sherds", x = 0, y = 0,   w = 8,   h = 8,   frames = 8, every = 3 },
    sherd_m = { sheet = "sherds", x = 0, y = 8,   w = 12,  h = 12,  frames = 8, every = 4 },
    sherd_l = { sheet = "sherds", x = 0, y = 20,  w = 18,  h = 18,  frames = 8, every = 5 },
    bubbles = { sheet = "sherds", x = 0, y = 38,  w = 12,  h = 12,  frames = 4, every = 14 },

    nacre    = { sheet = "gems", x = 0, y = 0,  w = 16, h = 16, frames = 10, every = 5,
                 origin = { 7, 7 } },
    conch    = { sheet = "gems", x = 0, y = 16, w = 16, h = 16, frames = 10, every = 5 },
    heart    = { sheet = "gems", x = 0, y = 32, w = 16, h = 16, frames = 10, every = 5 },
    bomb     = { sheet = "gems", x = 0, y = 48, w = 12, h = 12 },
    bomb_large = { sheet = "gems", x = 16, y = 48, w = 24, h = 24 },
    foam     = { sheet = "finds", x = 48, y = 0, w = 8,  h = 8 },
    ray_of_light = { sheet = "finds", x = 60, y = 0, w = 1, h = 16 },
    logo     = { sheet = "logo",  x = 0, y = 0,   w = 208, h = 112 },
    logo_light = { sheet = "logo_light", x = 0, y = 0, w = 208, h = 112, frames = 8, every = 3 },
    -- marks a boss's position at the lower edge
    boss_marker = { sheet = "marker", x = 0, y = 0, w = 24, h = 10, frames = 2, every = 10,
                    origin = { 12, 10 } },
  },
  maps = {
    -- stage one
    floor    = { tiles = "art/floor.png",  bank = 13, file = "maps/floor.csv" },
    caustics = { tiles = "art/floor.png",  bank = 13, file = "maps/caustics.csv" },
    reef     = { tiles = "art/reef.png",   bank = 13, file = "maps/reef.tmx", size = 8 },
    kelp     = { tiles = "art/kelp.png",   bank = 13, file = "maps/floor.csv", palette = "one" },
    wreck    = { tiles = "art/wreck.png",  bank = 13, file = "maps/wreck.csv", palette = "one" },
    whale    = { tiles = "art/whale.png",  bank = 13, file = "maps/whale.csv", palette = "one" },
    -- stage two
    works    = { tiles = "art/works.png",  bank = 13, palette = "two", file = "maps/works.csv" },
    pipes    = { tiles = "art/works.png",  bank = 13, palette = "two", file = "maps/pipes.csv" },
    stacks   = { tiles = "art/stacks.png", bank = 13, palette = "two", file = "maps/stacks.tmx",
                 size = 8 },
    street   = { tiles = "art/street.png", bank = 13, palette = "two", file = "maps/street.csv" },
    skyline  = { tiles = "art/skyline.png", bank = 13, palette = "two", file = "maps/skyline.csv" },
    yard     = { tiles = "art/yard.png",   bank = 13, palette = "two", file = "maps/yard.csv" },
    -- stage three
    trench   = { tiles = "art/trench.png", bank = 13, file = "maps/trench.csv", palette = "three" },
    quay     = { tiles = "art/quay.png",   bank = 13, file = "maps/quay.csv", palette = "three" },
    chains   = { tiles = "art/abyss_tiles.png", bank = 13, file = "maps/chains.csv",
                 palette = "three" },
    walls    = { tiles = "art/abyss_tiles.png", bank = 13, file = "maps/walls.csv",
                 palette = "three" },
    snow     = { tiles = "art/abyss_tiles.png", bank = 13, file = "maps/snow.csv",
                 palette = "three" },
    depths   = { tiles = "art/abyss_tiles.png", bank = 13, file = "maps/depths.csv",
                 palette = "three" },
    -- the moon
    water    = { tiles = "art/water.png",  bank = 13, file = "maps/floor.csv", palette = "moon" },
    town     = { tiles = "art/water.png",  bank = 13, file = "maps/town.csv", palette = "moon" },
    moonlight = { tiles = "art/water.png", bank = 13, file = "maps/caustics.csv", palette = "moon" },

  },
  blends = { ghost = { mix = 50 }, glow = "add", light = { ramp = "add" } },
  -- Frequent sounds are short and have low priority. The first ten play automatically.
  sounds = {
    graze    = { file = "sfx/graze.mml", priority = 1 },
    item     = { mml = "t300 @fm E0,60,0,30 o5 V80 a32>d16", priority = 2 },
    kill     = { file = "sfx/kill.mml", priority = 3, limit = 2 },
    menu     = { mml = "t300 @sine E0,40,0,20 o5 V90 e32a16", priority = 5 },
    time     = { mml = "t300 @fm E0,22,0,12 o6 V96 c16", priority = 5, limit = 1 },
    spell    = { file = "sfx/spell.mml", priority = 5, limit = 1 },
    warning  = { file = "sfx/warning.mml", priority = 6, limit = 1 },
    bomb     = { file = "sfx/bomb.mml", priority = 6, limit = 1 },
    extend   = { file = "sfx/extend.mml", priority = 6, limit = 1 },
    hit      = { file = "sfx/hit.mml", priority = 7, limit = 1 },
    -- shots, and hits on creatures
    dart     = { file = "sfx/dart.mml", priority = 0, limit = 1 },
    fang     = { file = "sfx/fang.mml", priority = 0, limit = 1 },
    chip     = { file = "sfx/chip.mml", priority = 0, limit = 1 },
    -- things that break, by size
    crash    = { file = "sfx/crash.mml", priority = 4, limit = 1 },
    shatter  = { file = "sfx/shatter.mml", priority = 4, limit = 1 },
    lamp     = { file = "sfx/lamp.mml", priority = 4, limit = 1 },
    phase    = { file = "sfx/phase.mml", priority = 6, limit = 1 },
    collapse = { file = "sfx/collapse.mml", priority = 7, limit = 1, duck = 0.9 },
    burst    = { file = "sfx/burst.mml", priority = 7, limit = 1, duck = 0.95 },
    -- items and bonuses
    conch    = { file = "sfx/conch.mml", priority = 5, limit = 1 },
    power    = { file = "sfx/power.mml", priority = 5, limit = 1 },
    bonus    = { file = "sfx/bonus.mml", priority = 6, limit = 1 },
    -- bosses
    charge   = { file = "sfx/charge.mml", priority = 4, limit = 1 },
    beam     = { file = "sfx/beam.mml", priority = 4, limit = 1 },
    still    = { file = "sfx/still.mml", priority = 5, limit = 1 },
    flow     = { file = "sfx/flow.mml", priority = 5, limit = 1 },
    -- stage one: a claw breaks off, a hatch opens, a bubble bursts; the crab snaps
    claw     = { file = "sfx/claw.mml", priority = 6, limit = 1 },
    hatch    = { file = "sfx/hatch.mml", priority = 4, limit = 1 },
    bubble   = { file = "sfx/bubble.mml", priority = 2, limit = 2 },
    snap     = { mml = "t300 @pulse E0,20,0,10 o4 V127 {g>c}32", priority = 4, limit = 1 },

    -- stage two: the works, and the voices of the two eels
    pour     = { file = "sfx/pour.mml", priority = 4, limit = 1 },
    steam    = { file = "sfx/steam.mml", priority = 3, limit = 2 },
    gear     = { file = "sfx/gear.mml", priority = 3, limit = 1 },
    reflect  = { file = "sfx/reflect.mml", priority = 2, limit = 2 },
    cinder_cry = { file = "sfx/cinder_cry.mml", priority = 6, limit = 1 },
    quench_cry = { file = "sfx/quench_cry.mml", priority = 6, limit = 1 },
    cinder   = { mml = "t300 @saw E1,24,0,12 o4 V120 {d<b}32", priority = 5, limit = 1 },
    quench   = { mml = "t300 @sine E2,30,0,16 o6 V80 {d<a}32", priority = 5, limit = 1 },

    -- stage three: a lamp in the dark, the queen's five glasses
    angler   = { file = "sfx/angler.mml", priority = 5, limit = 1 },
    chord    = { file = "sfx/chord.mml", priority = 5, limit = 1 },

    -- the moon: its bell and its voice
    toll     = { file = "sfx/toll.mml", priority = 6, limit = 1 },
    the_moon = { mml = "t300 @fm E4,60,0,40 o3 V92 a16", priority = 5, limit = 1 },

    -- crafts: shots of the tern, the ray, bombs, gauge, shards, chain, missions
    peal     = { file = "sfx/peal.mml", priority = 0, limit = 1 },
    ray      = { file = "sfx/ray.mml", priority = 3, limit = 1 },
    bell_bomb = { file = "sfx/bell_bomb.mml", priority = 6, limit = 1, duck = 0.7 },
    lamp_bomb = { file = "sfx/lamp_bomb.mml", priority = 6, limit = 1, duck = 0.7 },
    full     = { file = "sfx/full.mml", priority = 5, limit = 1 },
    release  = { file = "sfx/release.mml", priority = 6, limit = 1 },
    shard    = { file = "sfx/shard.mml", priority = 2, limit = 1 },
    medal    = { file = "sfx/medal.mml", priority = 3, limit = 2 },
    chain_one   = { file = "sfx/chain_one.mml", priority = 4, limit = 1 },
    chain_two   = { file = "sfx/chain_two.mml", priority = 4, limit = 1 },
    chain_three = { file = "sfx/chain_three.mml", priority = 5, limit = 1 },
    mission  = { file = "sfx/mission.mml", priority = 6, limit = 1 },
    failed   = { file = "sfx/failed.mml", priority = 6, limit = 1 },
    ono      = { mml = "t300 @fm E1,22,0,12 o5 V88 {g>c}32", priority = 5, limit = 1 },
    lens     = { file = "sfx/lens.mml", priority = 0, limit = 1 },
    mote     = { file = "sfx/mote.mml", priority = 0, limit = 1 },
    hook     = { file = "sfx/hook.mml", priority = 0, limit = 1 },

    -- a boss's entrance; the last seconds of a clock; unlocks
    entrance = { file = "sfx/entrance.mml", priority = 6, limit = 1 },
    tick     = { mml = "t300 @pulse E0,14,0,8 o6 V118 g32", priority = 5, limit = 1 },
    unlock   = { file = "sfx/unlock.mml", priority = 6, limit = 1 },
    -- menus
    select   = { file = "sfx/select.mml", priority = 5, limit = 1 },
    back     = { file = "sfx/back.mml", priority = 5, limit = 1 },
    wrong    = { mml = "t300 @pulse E2,90,20,20 o3 V124 c16r32c8", priority = 5, limit = 1 },
    pause    = { file = "sfx/pause.mml", priority = 6, limit = 1 },
    continue = { file = "sfx/continue.mml", priority = 6, limit = 1 },
    ready    = { file = "sfx/ready.mml", priority = 6, limit = 1 },
    -- voices in dialogue, one sound per letter
    iri       = { mml = "t300 @pulse E1,22,0,10 o5 V116 a32", priority = 5, limit = 1 },
    sen       = { mml = "t300 @triangle E1,24,0,10 o5 V84 d32", priority = 5, limit = 1 },
    the_crab  = { mml = "t300 @noise E0,14,0,8 o6 V80 c64r64c64", priority = 5, limit = 1 },
    the_queen = { mml = "t300 @fm E1,34,0,16 o4 V84 {a<a}16", priority = 5, limit = 1 },
  },
  music = { -- each file states its key, chords and form; docs/measured/music.md
    title   = { file = "music/title.mml", volume = 0.53 },
    opening = { file = "music/opening.mml", volume = 0.51 },
    -- stages
    tide    = { file = "music/tide.mml", volume = 0.49 },
    works   = { file = "music/works.mml", volume = 0.50 },
    abyss   = { file = "music/abyss.mml", volume = 0.49 },
    caravan = { file = "music/caravan.mml", volume = 0.47 },
    -- bosses
    lantern = { file = "music/lantern.mml", volume = 0.45 },
    claws   = { file = "music/claws.mml", volume = 0.60 },
    furnace = { file = "music/furnace.mml", volume = 0.41 },
    queen   = { file = "music/queen.mml", volume = 0.50 },
    moon    = { file = "music/moon.mml", volume = 0.45 },
    -- results, endings, scores
    clear   = { file = "music/clear.mml", volume = 0.46 },
    over    = { file = "music/over.mml", volume = 0.45 },
    ending  = { file = "music/ending.mml", volume = 0.60 },
    true_ending = { file = "music/true_ending.mml", volume = 0.54 },
    staff   = { file = "music/staff.mml", volume = 0.49 },
    scores  = { file = "music/scores.mml", volume = 0.59 },
  },
  dip = { lamps = { "glass", "gilt", "ember" }, -- the colour of the craft, once unlocked
          rank = { "hidden", "shown" } },       -- in the HUD
  difficulties = { "easy", "normal", "hard", "abyss" }, difficulty = "normal",
  players = 2, extends = { 200000, 600000, 1500000, 4000000 },
}

-- The crafts in each of their colours: level, and banking to each side, a little and hard.
local COLOURS, SIDES = { "", "_gilt", "_ember" }, { "", "_left", "_right", "_hard_left", "_hard_right" }
local ROWS = { 0, 54, 90, 126, 162 }

local function add_craft(name, w, h)
  for i = 1, #COLOURS do
    for k = 1, #SIDES do
      local sheet = name .. COLOURS[i]
      rom.sprites[sheet .. SIDES[k]] = { sheet = sheet, x = 0, y = ROWS[k], w = w, h = h, frames = 4,
                                         every = 3, origin = { w // 2, h // 2 - 1 } }
    end
  end
end
add_craft("heron", 28, 36)
add_craft("petrel", 30, 34)
add_craft("tern", 32, 36)

-- A boss at rest and attacking, and what is drawn over it once it is hurt, and broken.
local function add_boss(name, sheet, w, h, x, y, every)
  local states = { "", "_attack", "_hurt", "_broken" }
  for row = 1, #states do
    rom.sprites[name .. states[row]] = { sheet = sheet, x = 0, y = h * (row - 1), w = w, h = h, frames = 6, every = every,
                                   origin = { x, y } }
  end
end
add_boss("lantern_nautilus", "lantern_nautilus", 84, 80, 40, 36, 6)
add_boss("crab", "crab", 112, 88, 56, 44, 6)
add_boss("bellows", "bellows", 116, 96, 58, 44, 6)
add_boss("cinder", "cinder", 84, 92, 42, 62, 6)
add_boss("quench", "quench", 84, 92, 42, 62, 6)
add_boss("angler", "angler", 120, 96, 60, 48, 6)
add_boss("queen", "queen_abyss", 128, 128, 64, 58, 7)

-- Creatures as they fly to a side, when they are hit, and before they fire: blocks of h px in a sheet of their own.
local function add_poses(sheet, h, names)
  local poses = { "_left", "_right", "_hurt", "_attack" }
  for i = 1, #names do
    local s = rom.sprites[names[i]]
    for k = 1, #poses do
      rom.sprites[names[i] .. poses[k]] = { sheet = sheet .. "_poses", x = s.x, y = s.y + h * (k - 1), w = s.w, h = s.h,
                                            frames = s.frames, every = s.every, origin = s.origin }
    end
  end
end
add_poses("enemies", 240, { "krill", "fish", "jelly", "ray", "urchin", "nautilus" })
add_poses("shoal", 136, { "arrow", "seahorse" })
add_poses("creatures_two", 306, { "drone", "bottle", "tongs", "worm", "puffer", "gear_ray", "crucible", "kiln" })
add_poses("abyss_life", 280, { "mite", "bell", "viper", "chain_head", "comb", "squid", "shark", "spider" })
add_poses("gulper", 64, { "gulper" })

return rom

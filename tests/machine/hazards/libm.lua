-- stock: distinct with GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA
-- board: same
local digest = 0
for i = 1, 20000 do
  local x = i * 0.37
  local u = i / 20001
  for _, v in ipairs { math.sin(x), math.cos(x), math.tan(x), math.atan(x), math.asin(u), math.acos(u) } do
    digest = (digest * 31 + math.floor(v * (1 << 50))) & 0xffffffffffff
  end
end
print(digest)

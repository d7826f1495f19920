-- stock: distinct with GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA
-- board: refused main.lua:4: operator ^ is not available (results differ between machines); use x*x or math.sqrt
local digest = 0
for i = 1, 20000 do digest = (digest * 31 + math.floor((1 + i / 20001) ^ 1.7 * (1 << 50))) & 0xffffffffffff end
print(digest)

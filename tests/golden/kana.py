"""Makes a BDF font of kana.txt: kana.py KANA.TXT >KANA.BDF

A letter with a voicing mark is the letter without it, and the mark in its upper right corner."""
import sys
import unicodedata

MARKS = {"\u3099": (5, 5, 0), "\u309a": (2, 5, 2)}  # three rows of three pixels
glyphs = {}
for line in open(sys.argv[1], encoding="utf-8"):
    if line[0] != "#":
        letter, *rows = line.split()
        glyphs[letter] = [int(row, 16) << 1 for row in rows]
for code in range(0x30a1, 0x30fb):
    parts = unicodedata.normalize("NFD", chr(code))
    if len(parts) == 2 and parts[0] in glyphs:
        corner = MARKS[parts[1]]
        base = glyphs[parts[0]]
        glyphs[chr(code)] = [row & ~7 | mark for row, mark in zip(base, corner)] + base[3:]

print("STARTFONT 2.1\nFONT kana\nSIZE 8 75 75\nFONTBOUNDINGBOX 8 8 0 -1\nSTARTPROPERTIES 4\nFONT_ASCENT 7\n"
      'FONT_DESCENT 1\nCHARSET_REGISTRY "ISO10646"\nCHARSET_ENCODING "1"\nENDPROPERTIES\nCHARS %d' % len(glyphs))
for letter, rows in sorted(glyphs.items()):
    print("STARTCHAR u%04X\nENCODING %d\nDWIDTH 8 0\nBBX 8 7 0 0\nBITMAP\n%s\nENDCHAR" % (
        ord(letter), ord(letter), "\n".join("%02X" % row for row in rows)))
print("ENDFONT")

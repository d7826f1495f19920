/*
 * image.c - see image.h. A program is loaded by its program headers alone; the table of sections is for linkers and
 * debuggers.
 */
#include "image.h"

#if defined __ELF__ && defined __has_include /* wasi has the header, and not what it includes */
#if __has_include(<elf.h>)
#define HAS_ELF
#include <elf.h>
#include <stdbool.h>
#include <string.h>
#endif
#endif

#ifdef HAS_ELF

#if UINTPTR_MAX > 0xffffffffu
typedef Elf64_Ehdr elf_header;
typedef Elf64_Phdr elf_piece;
enum { CLASS = ELFCLASS64 };
#else
typedef Elf32_Ehdr elf_header;
typedef Elf32_Phdr elf_piece;
enum { CLASS = ELFCLASS32 };
#endif

static bool ours(const elf_header *h)
{
    const uint16_t one = 1;
    const int order = *(const uint8_t *)&one ? ELFDATA2LSB : ELFDATA2MSB;

    return memcmp(h->e_ident, ELFMAG, SELFMAG) == 0 && h->e_ident[EI_CLASS] == CLASS && h->e_ident[EI_DATA] == order &&
           h->e_phentsize == sizeof(elf_piece);
}

size_t image_trim(uint8_t *file, size_t size)
{
    elf_header h;
    elf_piece p;
    size_t end;

    if (size < sizeof h)
        return size;
    memcpy(&h, file, sizeof h);
    end = (size_t)h.e_phoff + (size_t)h.e_phnum * sizeof p;
    if (!ours(&h) || h.e_phoff > size || end > size)
        return size;
    for (unsigned i = 0; i < h.e_phnum; i++) {
        memcpy(&p, file + h.e_phoff + i * sizeof p, sizeof p);
        if (p.p_offset > size || p.p_filesz > size - p.p_offset)
            return size;
        end = p.p_offset + p.p_filesz > end ? (size_t)(p.p_offset + p.p_filesz) : end;
    }
    h.e_shoff = 0;
    h.e_shnum = h.e_shstrndx = 0;
    memcpy(file, &h, sizeof h);
    return end;
}

#else

size_t image_trim(uint8_t *file, size_t size)
{
    (void)file;
    return size;
}

#endif

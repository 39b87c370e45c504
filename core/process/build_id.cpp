// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/build_id.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <cstdint>
#include <cstring>

namespace parison::core {
namespace {

/// An address in this program or module, and what is found for it.
struct Wanted {
  std::uintptr_t address;
  std::string id;
};

bool contains(const dl_phdr_info& object, std::uintptr_t address) {
  for (int i = 0; i < object.dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = object.dlpi_phdr[i];
    const std::uintptr_t begin = object.dlpi_addr + part.p_vaddr;
    if (part.p_type == PT_LOAD && begin <= address && address - begin < part.p_memsz) return true;
  }
  return false;
}

/// Notes are records of a name and a content, each rounded up to whole words of four bytes.
std::string id_in_notes(const char* at, const char* end) {
  const auto rounded = [](std::size_t size) { return (size + 3) / 4 * 4; };
  while (end - at >= static_cast<std::ptrdiff_t>(sizeof(ElfW(Nhdr)))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, at, sizeof note);
    const char *name = at + sizeof note, *content = name + rounded(note.n_namesz);
    if (content + note.n_descsz > end) return {};
    std::string id;
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == sizeof "GNU" && std::memcmp(name, "GNU", sizeof "GNU") == 0)
      for (std::size_t i = 0; i < note.n_descsz; ++i)
        id += fmt::format("{:02x}", static_cast<unsigned char>(content[i]));
    if (!id.empty()) return id;
    at = content + rounded(note.n_descsz);
  }
  return {};
}

int look(dl_phdr_info* object, std::size_t, void* data) {
  auto& wanted = *static_cast<Wanted*>(data);
  if (!contains(*object, wanted.address)) return 0;
  for (int i = 0; i < object->dlpi_phnum && wanted.id.empty(); ++i) {
    const ElfW(Phdr)& part = object->dlpi_phdr[i];
    const auto* notes = reinterpret_cast<const char*>(object->dlpi_addr + part.p_vaddr);
    if (part.p_type == PT_NOTE) wanted.id = id_in_notes(notes, notes + part.p_memsz);
  }
  return 1;
}

std::string find_build_id() {
  static const char here = 0;
  Wanted wanted{reinterpret_cast<std::uintptr_t>(&here), {}};
  dl_iterate_phdr(look, &wanted);
  return wanted.id;
}

}  // namespace

const std::string& build_id() {
  static const std::string id = find_build_id();
  return id;
}

}  // namespace parison::core

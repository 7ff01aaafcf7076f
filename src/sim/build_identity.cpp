// SPDX-License-Identifier: BSD-3-Clause
#include "build_identity.h"

#include <link.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace drill_rig_sim
{
namespace
{
struct Search
{
  std::uintptr_t address;  // of something inside the binary
  BuildIdentity found{};
};

bool holds(const dl_phdr_info& object, std::uintptr_t address)
{
  for (int i = 0; i < object.dlpi_phnum; ++i)
  {
    const ElfW(Phdr)& part = object.dlpi_phdr[i];
    const std::uintptr_t begin = object.dlpi_addr + part.p_vaddr;
    if (part.p_type == PT_LOAD && address >= begin && address < begin + part.p_memsz) return true;
  }
  return false;
}

/// Notes are records of name size, value size, type, name and value, the two padded to four bytes.
void take_identity(const unsigned char* note, std::size_t size, BuildIdentity& out)
{
  const auto padded = [](std::size_t n) { return (n + 3) / 4 * 4; };
  while (size >= sizeof(ElfW(Nhdr)))
  {
    ElfW(Nhdr) head;
    std::memcpy(&head, note, sizeof head);
    const std::size_t whole = sizeof head + padded(head.n_namesz) + padded(head.n_descsz);
    if (whole > size) return;
    if (head.n_type == NT_GNU_BUILD_ID)
      std::memcpy(out.data(), note + sizeof head + padded(head.n_namesz), std::min<std::size_t>(out.size(), head.n_descsz));
    note += whole;
    size -= whole;
  }
}

int look_at(dl_phdr_info* object, std::size_t, void* data)
{
  auto* search = static_cast<Search*>(data);
  if (!holds(*object, search->address)) return 0;
  for (int i = 0; i < object->dlpi_phnum; ++i)
  {
    const ElfW(Phdr)& part = object->dlpi_phdr[i];
    if (part.p_type == PT_NOTE)
      // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader gives addresses as numbers
      take_identity(reinterpret_cast<const unsigned char*>(object->dlpi_addr + part.p_vaddr), part.p_memsz, search->found);
  }
  return 1;
}
}  // namespace

BuildIdentity build_identity() noexcept
{
  static const int inside = 0;
  Search search{reinterpret_cast<std::uintptr_t>(&inside)};
  dl_iterate_phdr(look_at, &search);
  return search.found;
}

}  // namespace drill_rig_sim

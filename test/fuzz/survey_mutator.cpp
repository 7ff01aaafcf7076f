// SPDX-License-Identifier: BSD-3-Clause
// Changes surveys by the number and by the line; libFuzzer's own mutations do the rest.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "text_changes.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed)
{
  using namespace drill_rig_sim::fuzz;
  Random random(seed);
  if (random.one_in(8)) return LLVMFuzzerMutate(data, size, max_size);
  std::string text(reinterpret_cast<const char*>(data), size);
  do
  {
    const std::size_t which = random.below(10);
    if (which < 6)
      change_number(text, random);
    else if (which < 8)
      change_lines(text, random);
    else
      change_seed(text, random);
  } while (random.one_in(2));
  const std::size_t length = std::min(text.size(), max_size);
  std::memcpy(data, text.data(), length);
  return length;
}

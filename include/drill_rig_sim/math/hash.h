// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_HASH_H
#define DRILL_RIG_SIM_MATH_HASH_H

#include <cstddef>
#include <cstdint>

namespace drill_rig_sim
{
/// FNV-1a, 64 bits (Fowler, Noll and Vo): for telling values apart; no defence against forgery. `from`: goes on from an earlier
/// hash.
inline std::uint64_t hash_bytes(const void* data, std::size_t size, std::uint64_t from = 0xcbf29ce484222325ull) noexcept
{
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < size; ++i) from = (from ^ bytes[i]) * 0x100000001b3ull;
  return from;
}

}  // namespace drill_rig_sim

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "between.h"

#include <algorithm>

namespace drill_rig_sim
{
Between find_between(const Mesh& mesh, double from_bit) noexcept
{
  const auto& nodes = mesh.nodes;
  const auto above =
      std::upper_bound(nodes.begin(), nodes.end(), from_bit, [](double s, const MeshNode& n) { return s < n.from_bit; });
  const int upper = std::clamp(static_cast<int>(above - nodes.begin()), 1, static_cast<int>(nodes.size()) - 1);
  const double low = nodes[upper - 1].from_bit, high = nodes[upper].from_bit;
  return {upper - 1, (from_bit - low) / (high - low)};
}

}  // namespace drill_rig_sim

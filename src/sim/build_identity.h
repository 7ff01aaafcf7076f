// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_BUILD_IDENTITY_H
#define DRILL_RIG_SIM_SRC_SIM_BUILD_IDENTITY_H

#include <array>

namespace drill_rig_sim
{
using BuildIdentity = std::array<unsigned char, 20>;

/// The linker's hash of the binary that holds this library (its GNU build id); zeros where the linker wrote none.
BuildIdentity build_identity() noexcept;

}  // namespace drill_rig_sim

#endif

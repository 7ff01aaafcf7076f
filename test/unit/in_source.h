// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_IN_SOURCE_H
#define DRILL_RIG_SIM_TEST_IN_SOURCE_H

#include <string>

namespace drill_rig_sim
{
/// Where a file or folder of the package is, as "config/scenes/quick.yaml"; where the package is for an empty one. In a source of
/// its own, so that what is compiled for other tests does not depend on where the package lies.
std::string in_source(const std::string& path = "");
}  // namespace drill_rig_sim
#endif

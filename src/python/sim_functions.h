// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace drill_rig_sim
{
/// What drill_rig_sim._sim does without a rig: units, surveys and texts of files, loads of a scene's string at its start.
void bind_functions(pybind11::module_& module);
}  // namespace drill_rig_sim

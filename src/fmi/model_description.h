// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_FMI_MODEL_DESCRIPTION_H
#define DRILL_RIG_SIM_SRC_FMI_MODEL_DESCRIPTION_H

#include <string>

#include "variables.h"

namespace drill_rig_sim::fmi
{
/// Name of the shared library in an FMU, without its ending.
inline constexpr char model_identifier[] = "drill_rig_sim_fmu";

/// Identifies the variables: an FMU's description and library must have the same.
std::string guid();
/// The text of modelDescription.xml (FMI 2.0, 2.2 and 4.3). `model`: its name; `start`: of parameters and inputs.
std::string model_description(const std::string& model, const Inputs& start);

}  // namespace drill_rig_sim::fmi

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_BESIDE_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_BESIDE_H

#include "survey_header.h"

namespace drill_rig_sim
{
/// Columns that are not read and show that those which are read are not all: minutes of an angle, a drilled well under a name
/// that is not known beside its plan. Sets what is wrong with the header.
void check_columns_beside(const SurveyFormat& format, SurveyHeader& header);

}  // namespace drill_rig_sim

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PROBE_TOOL_H
#define DRILL_RIG_SIM_SRC_RVIZ_PROBE_TOOL_H

#include <rviz/tool.h>

namespace drill_rig_sim
{
/// A click on the drillstring shows the numbers there; one beside it, none. Other buttons move the camera.
class ProbeTool : public rviz::Tool
{
  Q_OBJECT
public:
  ProbeTool();
  void activate() override;
  void deactivate() override {}
  int processMouseEvent(rviz::ViewportMouseEvent& event) override;
};

}  // namespace drill_rig_sim

#endif

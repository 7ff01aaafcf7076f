// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_WELL_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_WELL_CONTROLS_H

#include "controls.h"

class QLineEdit;

namespace drill_rig_sim::console
{
/// Back to the start of a scene, or a well from a survey file.
class WellControls : public Controls
{
  Q_OBJECT
public:
  WellControls(RigLink& link, QWidget* parent);

private:
  void ask_for_scene();
  void reset();
  void ask_for_survey();
  void load_survey(const QString& file);
  void take_answer(const QString& what, bool success, const QString& text);

  QLineEdit* scene_;
  UnitBox *hole_depth_, *bit_depth_;
  QLabel* answer_;
};

}  // namespace drill_rig_sim::console

#endif

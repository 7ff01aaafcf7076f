// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_FAULT_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_FAULT_CONTROLS_H

#include "controls.h"

class QComboBox;

namespace drill_rig_sim::console
{
/// Every fault with what it needs.
class FaultControls : public Controls
{
  Q_OBJECT
public:
  FaultControls(RigLink& link, QWidget* parent);
  void set_units(UnitSystem system) override;

private:
  void follow_fault();
  void follow_target();
  void inject(bool clear);

  QComboBox *fault_, *target_;
  UnitBox *depth_, *magnitude_;
  QLabel* magnitude_label_;
};

}  // namespace drill_rig_sim::console

#endif

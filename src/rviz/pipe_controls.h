// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_PIPE_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_PIPE_CONTROLS_H

#include "controls.h"

class QSpinBox;

namespace drill_rig_sim::console
{
/// Tare, slips and connections.
class PipeControls : public Controls
{
  Q_OBJECT
public:
  PipeControls(RigLink& link, QWidget* parent);
  void show_news(const News& news) override;

private:
  void set_slips(bool on);
  void connect_pipe(bool remove);

  QSpinBox* joints_;
  QLabel* in_force_;
};

}  // namespace drill_rig_sim::console

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_HEADER_BAR_H
#define DRILL_RIG_SIM_RVIZ_HEADER_BAR_H

#include <QWidget>

#include "message_values.h"

class QLabel;
class QProgressBar;

namespace drill_rig_sim::console
{
/// What stands above all pages: how the simulator is, its time, its operation, and the gravest of its warnings.
class HeaderBar : public QWidget
{
  Q_OBJECT
public:
  explicit HeaderBar(QWidget* parent);
  /// `age`: of the last reading [s].
  void show_state(LinkState state, const QString& rig, double age, const News& news);
  /// One line, and how grave it is.
  void show_warning(const QString& text, Level level);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void cut_warning();
  void show_operation(const RigState* state);

  QLabel *state_, *rig_, *time_, *operation_, *warning_;
  QProgressBar* progress_;
};

}  // namespace drill_rig_sim::console

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_SNAPSHOT_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_SNAPSHOT_CONTROLS_H

#include <QStringList>

#include "controls.h"

class QComboBox;

namespace drill_rig_sim::console
{
/// Snapshots by name in the node's memory, or in a file where the name holds a slash. The list holds what the node keeps and the
/// files named here; it is asked for when the mouse or the keys come to it, and after each of the buttons.
class SnapshotControls : public Controls
{
  Q_OBJECT
public:
  SnapshotControls(RigLink& link, QWidget* parent);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void take_states(const QStringList& names);
  void save();
  void restore();
  void forget();
  /// The name as it stands, without blanks at its ends.
  std::string name() const;

  QComboBox* name_;
  QStringList files_;
};

}  // namespace drill_rig_sim::console

#endif

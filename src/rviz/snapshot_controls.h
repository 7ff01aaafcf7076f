#ifndef DRILL_RIG_SIM_RVIZ_SNAPSHOT_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_SNAPSHOT_CONTROLS_H

#include "controls.h"

class QComboBox;

namespace drill_rig_sim::console
{
/// Snapshots by name in the node's memory, or in a file where the name holds a slash.
class SnapshotControls : public Controls
{
  Q_OBJECT
public:
  SnapshotControls(RigLink& link, QWidget* parent);

private:
  void save();
  void restore();
  void forget();
  /// The name as it stands, without blanks at its ends.
  std::string name() const;

  QComboBox* name_;
};

}  // namespace drill_rig_sim::console

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_SETTINGS_PAGE_H
#define DRILL_RIG_SIM_RVIZ_SETTINGS_PAGE_H

#include <QWidget>

#include "console/limits.h"
#include "console/units.h"

class QCheckBox;
class QComboBox;
class QTableWidget;

namespace drill_rig_sim::console
{
class UnitBox;

/// What the user chooses once; kept in rviz's config.
struct Settings
{
  QString rig;  // namespace; empty: rviz's own
  UnitSystem units = UnitSystem::si;
  bool truth = false;
  double bit_diameter = 0.0;  // [m]; 0: not known
  OwnAlarms alarms;
};

/// Where they are chosen.
class SettingsPage : public QWidget
{
  Q_OBJECT
public:
  explicit SettingsPage(QWidget* parent);
  const Settings& settings() const { return settings_; }
  /// Shows them; says nothing.
  void set_settings(const Settings& settings);
  /// The rig's own limits, beside the user's.
  void show_limits(const RigAbilities& rig);

Q_SIGNALS:
  /// The user has changed something but the namespace.
  void changed();
  void namespace_changed(const QString& name);

private:
  void make_table();
  void find_rigs();
  void take_namespace();
  void take_units();
  void take_cell(int row, int column);
  void fill_table();

  Settings settings_;
  RigAbilities rig_;
  QComboBox *rig_box_, *units_;
  QCheckBox* truth_;
  UnitBox* bit_;
  QTableWidget* table_;
  bool fills_ = false;
};

}  // namespace drill_rig_sim::console

#endif

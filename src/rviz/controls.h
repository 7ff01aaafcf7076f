// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_CONTROLS_H

#include <QElapsedTimer>
#include <QGroupBox>
#include <vector>

#include "rig_link.h"
#include "unit_box.h"

class QGridLayout;
class QLabel;

namespace drill_rig_sim::console
{
/// A group of controls that sends commands or calls services of one rig, and shows what is in force.
class Controls : public QGroupBox
{
  Q_OBJECT
public:
  Controls(const QString& title, RigLink& link, QWidget* parent);
  virtual void set_units(UnitSystem system);
  /// What is in force now.
  virtual void show_news(const News&) {}

protected:
  /// A box for a number that follows the units.
  UnitBox* add_box(const QString& name, Dimension dimension, double least, double most, double value);
  /// A box of a set point. While it has the focus, Enter applies the set points of the group and Escape takes all their edits
  /// back.
  UnitBox* add_set_point(const QString& name, Dimension dimension, double least, double most, double value);
  /// Another widget of a set point, for Enter and Escape.
  void watch_keys(QWidget* widget) { widget->installEventFilter(this); }
  /// Sends the set points.
  virtual void apply() {}
  /// Ends all edits: the boxes follow what is in force again.
  virtual void take_back();
  /// The set points were sent. They stay on show until the rig has had a second to take them.
  void settle();
  /// Whether set points in force may be shown now.
  bool follows() const { return !sent_.isValid() || sent_.elapsed() > 1000; }
  bool eventFilter(QObject* watched, QEvent* event) override;
  QLabel* add_label(const QString& text);
  QGridLayout& grid() { return *grid_; }
  RigLink& link() { return link_; }
  UnitSystem units() const { return system_; }

private:
  RigLink& link_;
  UnitSystem system_ = UnitSystem::si;
  QGridLayout* grid_;
  std::vector<UnitBox*> boxes_, set_points_;
  QElapsedTimer sent_;
};

}  // namespace drill_rig_sim::console

#endif

#ifndef DRILL_RIG_SIM_RVIZ_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_CONTROLS_H

#include <QGroupBox>
#include <vector>

#include "rig_link.h"
#include "unit_box.h"

class QGridLayout;
class QLabel;

namespace drill_rig_sim::console
{
/// A group of controls that sends commands or calls services of one rig, and tells what is in force.
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
  QLabel* add_label(const QString& text);
  QGridLayout& grid() { return *grid_; }
  RigLink& link() { return link_; }
  UnitSystem units() const { return system_; }

private:
  RigLink& link_;
  UnitSystem system_ = UnitSystem::si;
  QGridLayout* grid_;
  std::vector<UnitBox*> boxes_;
};

}  // namespace drill_rig_sim::console

#endif

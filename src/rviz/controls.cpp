#include "controls.h"

#include <QGridLayout>
#include <QLabel>

#include "look.h"

namespace drill_rig_sim::console
{
Controls::Controls(const QString& title, RigLink& link, QWidget* parent) : QGroupBox(title, parent), link_(link), grid_(new QGridLayout(this))
{
  setAccessibleName("group " + title.toLower());
  grid_->setContentsMargins(6, 4, 6, 5);
  grid_->setHorizontalSpacing(5);
  grid_->setVerticalSpacing(4);
}

void Controls::set_units(UnitSystem system)
{
  system_ = system;
  for (UnitBox* box : boxes_) box->set_units(system);
}

UnitBox* Controls::add_box(const QString& name, Dimension dimension, double least, double most, double value)
{
  auto* box = new UnitBox(name, dimension, least, most, value, this);
  boxes_.push_back(box);
  return box;
}

QLabel* Controls::add_label(const QString& text)
{
  QLabel* label = make_label(text, this);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return label;
}

}  // namespace drill_rig_sim::console

// SPDX-License-Identifier: BSD-3-Clause
#include "unit_box.h"

#include <QLineEdit>
#include <cmath>

#include "look.h"

namespace drill_rig_sim::console
{
UnitBox::UnitBox(const QString& name, Dimension dimension, double least, double most, double value, QWidget* parent)
    : QDoubleSpinBox(parent), dimension_(dimension), least_(least), most_(most), kept_(value)
{
  setAccessibleName(name);
  setKeyboardTracking(false);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setMinimumWidth(84);
  lay_out(value);
  connect(lineEdit(), &QLineEdit::textEdited, this, [this] { mark(true); });
}

void UnitBox::lay_out(double value)
{
  const Unit& unit = unit_of(dimension_, system_);
  const QString name = unit_text(dimension_, system_);
  setDecimals(unit.decimals);
  setSuffix(name.isEmpty() ? "" : " " + name);
  setRange(least_ * unit.per_si, most_ * unit.per_si);
  setSingleStep(
      std::pow(10.0, std::floor(std::log10(std::max(std::abs(value * unit.per_si), std::pow(10.0, 1 - unit.decimals))))) / 2.0);
  set_si(value);
}

void UnitBox::set_units(UnitSystem system)
{
  if (system == system_) return;
  const double value = si();
  system_ = system;
  lay_out(value);
}

void UnitBox::set_dimension(Dimension dimension)
{
  if (dimension == dimension_) return;
  dimension_ = dimension;
  lay_out(0.0);
}

double UnitBox::si() const
{
  // what is shown is rounded: a value that was not changed is what it was
  return value() == kept_shown_ ? kept_ : to_si(value(), dimension_, system_);
}

void UnitBox::set_si(double value)
{
  setValue(to_shown(value, dimension_, system_));
  kept_ = value;
  kept_shown_ = this->value();
}

void UnitBox::follow(double in_force)
{
  follows_ = true;
  if (!edited_ && in_force != si()) set_si(in_force);
}

void UnitBox::end_edit()
{
  interpretText();
  mark(false);
}

void UnitBox::stepBy(int steps)
{
  QDoubleSpinBox::stepBy(steps);
  mark(true);
}

void UnitBox::mark(bool edited)
{
  if (!follows_ || edited == edited_) return;
  edited_ = edited;
  show_edited(this, edited);
}

}  // namespace drill_rig_sim::console

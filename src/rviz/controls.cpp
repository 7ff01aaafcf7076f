// SPDX-License-Identifier: BSD-3-Clause
#include "controls.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>

#include "look.h"

namespace drill_rig_sim::console
{
Controls::Controls(const QString& title, RigLink& link, QWidget* parent)
    : QGroupBox(title, parent), link_(link), grid_(new QGridLayout(this))
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

UnitBox* Controls::add_set_point(const QString& name, Dimension dimension, double least, double most, double value)
{
  UnitBox* box = add_box(name, dimension, least, most, value);
  set_points_.push_back(box);
  watch_keys(box);
  return box;
}

void Controls::take_back()
{
  sent_.invalidate();
  for (UnitBox* box : set_points_) box->end_edit();
}

void Controls::settle()
{
  take_back();
  sent_.start();
}

bool Controls::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::KeyPress)
  {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter)
    {
      if (auto* box = qobject_cast<UnitBox*>(watched)) box->interpretText();
      apply();
    }
    if (key == Qt::Key_Escape) take_back();
  }
  return QGroupBox::eventFilter(watched, event);
}

QLabel* Controls::add_label(const QString& text)
{
  QLabel* label = make_label(text, this);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return label;
}

}  // namespace drill_rig_sim::console

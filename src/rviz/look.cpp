// SPDX-License-Identifier: BSD-3-Clause
#include "look.h"

#include <QCheckBox>
#include <QLabel>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>

#include "console/quantities.h"

namespace drill_rig_sim::console
{
QColor color_of(Level level)
{
  switch (level)
  {
    case Level::alarm:
      return QColor(look::alarm);
    case Level::caution:
      return QColor(look::caution);
    case Level::normal:
      break;
  }
  return QColor(look::good);
}

QPalette console_palette()
{
  QPalette p;
  const QColor text(look::text), off(look::off);
  p.setColor(QPalette::Window, QColor(look::ground));
  p.setColor(QPalette::Base, QColor(look::field));
  p.setColor(QPalette::AlternateBase, QColor(look::tile));
  p.setColor(QPalette::Button, QColor(look::groove));
  p.setColor(QPalette::Highlight, QColor(look::accent));
  p.setColor(QPalette::HighlightedText, Qt::black);
  p.setColor(QPalette::ToolTipBase, QColor(look::tile));
  p.setColor(QPalette::ToolTipText, text);
  p.setColor(QPalette::Link, QColor(look::accent));
  p.setColor(QPalette::PlaceholderText, off);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::BrightText})
  {
    p.setColor(role, text);
    p.setColor(QPalette::Disabled, role, off);
  }
  p.setColor(QPalette::Light, QColor(0xff4a525e));
  p.setColor(QPalette::Midlight, QColor(0xff424a55));
  p.setColor(QPalette::Mid, QColor(0xff20242a));
  p.setColor(QPalette::Dark, QColor(0xff15181c));
  p.setColor(QPalette::Shadow, Qt::black);
  return p;
}

QString unit_text(Dimension dimension, UnitSystem system)
{
  QString name = unit_of(dimension, system).name;
  return name.replace("m2", QString::fromUtf8("m²"))
      .replace("m3", QString::fromUtf8("m³"))
      .replace("in2", QString::fromUtf8("in²"));
}

QString shown_text(double si, Dimension dimension, UnitSystem system)
{
  const QString unit = unit_text(dimension, system);
  return QString::fromStdString(number_text(si, dimension, system)) + (unit.isEmpty() ? "" : " " + unit);
}

QPushButton* make_button(const QString& text, const QString& name, QWidget* parent)
{
  auto* button = new QPushButton(text, parent);
  button->setAccessibleName(name);
  button->setAutoDefault(false);
  // no wider than its words ask for: the panel is narrow
  button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  return button;
}

QLabel* make_label(const QString& text, QWidget* parent)
{
  auto* label = new QLabel(text, parent);
  label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  return label;
}

QLabel* make_reading(const QString& name, QWidget* parent)
{
  QLabel* label = make_label("", parent);
  label->setAccessibleName(name);
  QPalette p = parent->palette();
  p.setColor(QPalette::WindowText, QColor(look::faint));
  label->setPalette(p);
  return label;
}

QCheckBox* make_check(const QString& text, const QString& name, QWidget* parent)
{
  auto* check = new QCheckBox(text, parent);
  check->setAccessibleName(name);
  QPalette p = parent->palette();
  p.setColor(QPalette::Base, QColor(0xff56606c));  // the box is to be seen on the dark ground
  check->setPalette(p);
  return check;
}

void show_edited(QWidget* widget, bool edited)
{
  QFont font = widget->font();
  font.setBold(edited);
  widget->setFont(font);
  QPalette p = widget->palette();
  p.setColor(QPalette::Base, QColor(edited ? look::edited : look::field));
  widget->setPalette(p);
  widget->setAccessibleDescription(edited ? "edited" : "");
}

void ask(QWidget* parent, const QString& name, const QString& question, const QString& yes, const std::function<void()>& act)
{
  auto* box = new QMessageBox(QMessageBox::Question, yes, question, QMessageBox::Cancel, parent);
  box->setAccessibleName(name);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::PlainText);
  QPushButton* button = box->addButton(yes, QMessageBox::DestructiveRole);
  button->setAccessibleName(name + " yes");
  box->setDefaultButton(QMessageBox::Cancel);
  QObject::connect(button, &QPushButton::clicked, parent, act);
  box->open();
}

void tell(QLabel* label, const QString& text)
{
  if (label->text() == text) return;
  label->setText(text);
  label->setAccessibleDescription(text);
}

void paint_tile(QPainter& painter, const QWidget& widget, const QString& title)
{
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(widget.rect(), QColor(look::tile));
  QFont small = widget.font();
  small.setPixelSize(12);
  painter.setFont(small);
  painter.setPen(QColor(look::faint));
  painter.drawText(QRect(6, 2, widget.width() - 12, title_height), Qt::AlignLeft | Qt::AlignVCenter, title);
}

}  // namespace drill_rig_sim::console

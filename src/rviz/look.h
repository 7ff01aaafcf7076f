// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_LOOK_H
#define DRILL_RIG_SIM_RVIZ_LOOK_H

#include <QColor>
#include <QPalette>
#include <QString>
#include <functional>

#include "console/limits.h"
#include "console/units.h"

class QCheckBox;
class QLabel;
class QPainter;
class QPushButton;
class QWidget;

namespace drill_rig_sim::console
{
/// The console's colours: dark, so that what is coloured is what matters.
namespace look
{
constexpr QRgb ground = 0xff1e2228, field = 0xff15181c, edited = 0xff1f4a70, tile = 0xff2a2f37, groove = 0xff3a414b,
               text = 0xffe8e8e8, faint = 0xff98a0ac;
constexpr QRgb good = 0xff4caf7a, caution = 0xffe0b03c, alarm = 0xffe8544f, accent = 0xff58a6e0, off = 0xff7a828e;
}  // namespace look

/// Of a value or a warning.
QColor color_of(Level level);
/// Of the whole console; dialogs inherit it.
QPalette console_palette();

/// "kN" and so on, as it stands behind a number; "" for a mere number.
QString unit_text(Dimension dimension, UnitSystem system);
/// A number with its unit.
QString shown_text(double si, Dimension dimension, UnitSystem system);

/// Widgets with the name that tests and screen readers know them by.
QPushButton* make_button(const QString& text, const QString& name, QWidget* parent);
QLabel* make_label(const QString& text, QWidget* parent);
/// A label with information: in small faint letters.
QLabel* make_reading(const QString& name, QWidget* parent);
QCheckBox* make_check(const QString& text, const QString& name, QWidget* parent);
/// Marks a widget whose set point was edited and is not in force yet, by bold letters and a blue ground, or takes the mark away.
void show_edited(QWidget* widget, bool edited);
/// Asks before something that cannot be undone; `act` runs if the user agrees. Enter cancels. The dialog is called `name`, its
/// button with the text `yes` is called "NAME yes".
void ask(QWidget* parent, const QString& name, const QString& question, const QString& yes, const std::function<void()>& act);
/// Says what a reading label shows, on screen and to a screen reader.
void tell(QLabel* label, const QString& text);

/// Of a widget that paints itself: how high the title is that paint_tile() writes [pixels].
constexpr int title_height = 16;
/// The ground of such a widget, and its title in small faint letters at the top, which the painter keeps.
void paint_tile(QPainter& painter, const QWidget& widget, const QString& title);

}  // namespace drill_rig_sim::console

#endif

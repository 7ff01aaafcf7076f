// SPDX-License-Identifier: BSD-3-Clause
#include "toolface_dial.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "console/quantities.h"
#include "look.h"

namespace drill_rig_sim::console
{
namespace
{

QPointF on_circle(const QPointF& centre, double radius, double toolface)
{
  return {centre.x() + radius * std::sin(toolface), centre.y() - radius * std::cos(toolface)};
}
}  // namespace

ToolfaceDial::ToolfaceDial(QWidget* parent) : QWidget(parent), truth_(missing)
{
  setAccessibleName("toolface dial");
  setToolTip("The last toolfaces, the latest outside; a line for the truth where that is shown");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ToolfaceDial::show_toolfaces(const std::vector<double>& toolfaces, bool magnetic, bool stale)
{
  if (toolfaces == toolfaces_ && magnetic == magnetic_ && stale == stale_) return;
  toolfaces_ = toolfaces;
  magnetic_ = magnetic;
  stale_ = stale;
  setAccessibleDescription(toolfaces.empty() ? QString("none yet")
                                             : shown_text(toolfaces.back(), Dimension::angle, UnitSystem::si) +
                                                   (magnetic ? " magnetic" : " gravity") +
                                                   QStringLiteral(", %1 in history").arg(toolfaces.size()));
  update();
}

void ToolfaceDial::set_truth(double toolface)
{
  if (toolface == truth_ || (std::isnan(toolface) && std::isnan(truth_))) return;
  truth_ = toolface;
  update();
}

void ToolfaceDial::paint_face(QPainter& painter, const QPointF& centre, double radius)
{
  painter.setPen(QPen(QColor(look::groove), 2));
  painter.setBrush(Qt::NoBrush);
  for (const double ring : {1.0, 0.66, 0.33}) painter.drawEllipse(centre, ring * radius, ring * radius);
  QFont small = font();
  small.setPixelSize(10);
  painter.setFont(small);
  const char* const gravity[] = {"0", "90 R", "180", "90 L"};
  const char* const compass[] = {"N", "E", "S", "W"};
  for (int n = 0; n < 4; ++n)
  {
    const double angle = 0.5 * M_PI * n;
    painter.setPen(QPen(QColor(look::faint), 1));
    painter.drawLine(on_circle(centre, 0.93 * radius, angle), on_circle(centre, 1.05 * radius, angle));
    const QString text = magnetic_ ? compass[n] : gravity[n];
    const double away = n % 2 == 0 ? radius + 9 : radius + 17;
    const QPointF at = on_circle(centre, away, angle);
    painter.drawText(QRectF(at.x() - 20, at.y() - 7, 40, 14), Qt::AlignCenter, text);
  }
}

void ToolfaceDial::paint_history(QPainter& painter, const QPointF& centre, double radius)
{
  const auto number = static_cast<int>(toolfaces_.size());
  QPointF before;
  for (int n = 0; n < number; ++n)
  {
    const int age = number - 1 - n;
    QColor color(age == 0 && !stale_ ? look::accent : look::faint);
    color.setAlpha(std::max(60, 255 - 18 * age));
    const QPointF at = on_circle(centre, radius * (0.9 - 0.062 * age), toolfaces_[static_cast<std::size_t>(n)]);
    painter.setPen(QPen(color, 1));
    if (n > 0) painter.drawLine(before, at);
    painter.setBrush(color);
    const double size = age == 0 ? 5.0 : 2.5;
    painter.drawEllipse(at, size, size);
    before = at;
  }
}

void ToolfaceDial::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  paint_tile(painter, *this, magnetic_ ? "Toolface from north" : "Toolface");
  const QRectF area(0, title_height, width(), height() - title_height);
  const double radius = std::max(10.0, std::min(0.5 * area.width() - 34, 0.5 * area.height() - 18));
  const QPointF centre = area.center();
  paint_face(painter, centre, radius);
  if (std::isfinite(truth_))
  {
    painter.setPen(QPen(QColor(look::off), 2, Qt::DashLine));
    painter.drawLine(centre, on_circle(centre, radius, truth_));
  }
  paint_history(painter, centre, radius);
  QFont large = font();
  large.setBold(true);
  large.setPixelSize(toolfaces_.empty() ? 12 : std::clamp(static_cast<int>(radius / 3.0), 12, 26));
  painter.setFont(large);
  painter.setPen(QColor(stale_ || toolfaces_.empty() ? look::off : look::text));
  QString text = "none yet";
  if (!toolfaces_.empty())
    text = QString::fromStdString(number_text(toolfaces_.back(), Dimension::angle, UnitSystem::si)) + QChar(0xb0);
  const QRectF box(centre.x() - radius, centre.y() - 0.25 * radius, 2 * radius, 0.5 * radius);
  painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace drill_rig_sim::console

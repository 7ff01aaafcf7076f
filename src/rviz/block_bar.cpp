// SPDX-License-Identifier: BSD-3-Clause
#include "block_bar.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "console/quantities.h"
#include "look.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr int mast_width = 34, block_height = 12;
}

BlockBar::BlockBar(QWidget* parent) : QWidget(parent), place_{missing, missing, missing, missing, 0, false, false, true}
{
  setAccessibleName("block bar");
  setToolTip("The block between its lowest and highest position; the stands in the string");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void BlockBar::set_units(UnitSystem system)
{
  system_ = system;
  show_place(place_);
}

QString BlockBar::height_text() const
{
  return shown_text(place_.height, Dimension::length, system_);
}

QString BlockBar::way_text() const
{
  if (!std::isfinite(place_.height) || !std::isfinite(place_.lowest)) return "-";
  return shown_text(place_.height - place_.lowest, Dimension::length, system_) + " left";
}

void BlockBar::show_place(const BlockPlace& place)
{
  place_ = place;
  const QString text = QStringLiteral("%1, %2, %3 stands%4%5")
                           .arg(height_text(), way_text())
                           .arg(place.stands)
                           .arg(place.in_slips ? ", in slips" : "", place.brake ? ", brake set" : "");
  if (text != accessibleDescription() || isVisible()) update();
  if (text != accessibleDescription()) setAccessibleDescription(text);
}

void BlockBar::paint_mast(QPainter& painter, const QRect& mast)
{
  painter.fillRect(mast, QColor(look::groove));
  const double way = place_.highest - place_.lowest;
  const auto y = [&](double height)
  { return mast.bottom() - std::clamp((height - place_.lowest) / way, 0.0, 1.0) * mast.height(); };
  if (!(way > 0.0) || !std::isfinite(place_.height)) return;
  const auto zone = [&](double from, double to, Level level)
  {
    QColor color = color_of(level);
    color.setAlpha(120);
    painter.fillRect(QRectF(mast.left(), y(to), mast.width(), y(from) - y(to)), color);
  };
  for (const auto& [near, far, level] : {std::make_tuple(0.01, 0.05, Level::caution), std::make_tuple(0.0, 0.01, Level::alarm)})
  {
    zone(place_.lowest + near * way, place_.lowest + far * way, level);
    zone(place_.highest - far * way, place_.highest - near * way, level);
  }
  const double here = y(place_.height);
  painter.setPen(QPen(QColor(look::faint), 2));
  painter.drawLine(QPointF(mast.center().x(), mast.top()), QPointF(mast.center().x(), here));  // the lines
  painter.setPen(QPen(QColor(look::accent), 3));
  painter.drawLine(QPointF(mast.center().x(), here), QPointF(mast.center().x(), mast.bottom() + 1));  // the pipe
  const QColor color(place_.stale ? look::off : look::text);
  const double top = std::clamp(here - block_height, double(mast.top()), double(mast.bottom() - block_height));
  painter.fillRect(QRectF(mast.left() + 3, top, mast.width() - 6, block_height), color);
  if (!place_.in_slips) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(look::caution));
  const double x = mast.center().x(), b = mast.bottom() + 1;
  painter.drawPolygon(QPolygonF({{x - 12, b - 9}, {x - 2, b - 9}, {x - 2, b}}));
  painter.drawPolygon(QPolygonF({{x + 12, b - 9}, {x + 2, b - 9}, {x + 2, b}}));
}

void BlockBar::paint_lines(QPainter& painter, const QRect& area)
{
  const QString arrow = place_.velocity > 5e-4    ? QString(QChar(0x25b2))
                        : place_.velocity < -5e-4 ? QString(QChar(0x25bc))
                                                  : QString("=");
  const struct
  {
    QString text;
    QRgb color;
    bool large;
  } lines[] = {{height_text(), place_.stale ? look::off : look::text, true},
               {way_text(), look::faint, false},
               {arrow + " " + shown_text(std::abs(place_.velocity), Dimension::speed, system_), look::faint, false},
               {QStringLiteral("%1 stands").arg(place_.stands), look::faint, false},
               {place_.in_slips ? "in slips" : "on the hook", place_.in_slips ? look::caution : look::faint, false},
               {place_.brake ? "brake set" : "brake off", place_.brake ? look::caution : look::faint, false}};
  const int step = std::min(24, area.height() / 6);
  QRect line(area.left(), area.top() + (area.height() - 6 * step) / 2, area.width(), step);
  for (const auto& one : lines)
  {
    QFont f = font();
    f.setBold(one.large);
    f.setPixelSize(std::clamp(step - 4, 9, one.large ? 17 : 14));
    while (f.pixelSize() > 9 && QFontMetrics(f).horizontalAdvance(one.text) > line.width()) f.setPixelSize(f.pixelSize() - 1);
    painter.setFont(f);
    painter.setPen(QColor(one.color));
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, one.text);
    line.translate(0, step);
  }
}

void BlockBar::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  paint_tile(painter, *this, "Block");
  const QRect below(8, title_height + 6, width() - 16, height() - title_height - 14);
  paint_mast(painter, QRect(below.left() + 2, below.top(), mast_width, below.height()));
  paint_lines(painter, below.adjusted(mast_width + 14, 0, 0, 0));
}

}  // namespace drill_rig_sim::console

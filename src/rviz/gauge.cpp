// SPDX-License-Identifier: BSD-3-Clause
#include "gauge.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "look.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr int margin = 6, least_width = 150, least_height = 37, truth_height = 12, bar_height = 5, mark_height = 4;
constexpr double over_pull = -2e3;  // surface weight on bit below which the string is pulled, as on the page of drill web [N]

bool same(const Limits& a, const Limits& b)
{
  const auto equal = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return equal(a.low_alarm, b.low_alarm) && equal(a.low_caution, b.low_caution) && equal(a.high_caution, b.high_caution) &&
         equal(a.high_alarm, b.high_alarm);
}
}  // namespace

Gauge::Gauge(const QuantityRow& row, const QString& kind, QWidget* parent) : QWidget(parent), row_(row)
{
  setAccessibleName(kind + " " + row.key);
  setToolTip(QStringLiteral("%1: %2").arg(row.label, row.source));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  scale_ = scale_of(row.quantity, limits_, least_, most_);
}

QSize Gauge::sizeHint() const
{
  return {190, minimumSizeHint().height() + 4};
}

QSize Gauge::minimumSizeHint() const
{
  return {least_width, least_height + (shows_truth_ ? truth_height : 0)};
}

void Gauge::set_units(UnitSystem system)
{
  system_ = system;
  text_.clear();
  set_truth(truth_);
  set_error(error_);
  show_value(value_, why_, lost_, stale_, limits_);
}

void Gauge::show_truth(bool on)
{
  if (shows_truth_ == on) return;
  shows_truth_ = on;
  updateGeometry();
  update();
}

void Gauge::forget()
{
  least_ = most_ = missing;
}

bool Gauge::is_filled() const
{
  return std::isfinite(value_);
}

bool Gauge::is_pulled() const
{
  return row_.quantity == Quantity::surface_wob && value_ < over_pull;
}

QString Gauge::state_text() const
{
  if (!is_filled()) return why_;
  QString text = shown_text(is_pulled() ? -value_ : value_, row_.dimension, system_);
  if (lost_) text += " drop-out";
  return text;
}

QString Gauge::margin_text() const
{
  if (!is_pulled() || std::isnan(margin_)) return {};
  return margin_ > 0.0 ? shown_text(margin_, Dimension::force, system_) + " to yield" : QString("beyond yield");
}

void Gauge::show_value(double value, const char* why, bool lost, bool stale, const Limits& limits)
{
  if (std::isfinite(value))
  {
    least_ = std::isnan(least_) ? value : std::min(least_, value);
    most_ = std::isnan(most_) ? value : std::max(most_, value);
  }
  const bool was_filled = is_filled();
  value_ = value;
  why_ = why;
  const Scale scale = scale_of(row_.quantity, limits, least_, most_);
  bool differs = stale != stale_ || lost != lost_ || was_filled != is_filled() || !same(limits, limits_) ||
                 scale.high != scale_.high || scale.low != scale_.low;
  lost_ = lost;
  stale_ = stale;
  limits_ = limits;
  scale_ = scale;
  level_ = level_of(value, limits_);
  if (is_pulled()) level_ = std::max(level_, Level::caution);
  const QString text = state_text(), margin = margin_text();
  const int bar = is_filled() ? static_cast<int>(std::lround(place(value, rect()))) : -1;
  const char* const words[] = {"", " caution", " alarm"};
  const QString description = QString(is_pulled() ? "over-pull " : "") + text + (shows_error() ? " " + error_text_ : QString()) +
                              (margin.isEmpty() ? QString() : ", " + margin) + words[static_cast<int>(level_)] +
                              (stale_ ? " stale" : "");
  if (description != accessibleDescription()) setAccessibleDescription(description);
  differs = differs || text != text_ || margin != margin_text_ || bar != bar_;
  text_ = text;
  margin_text_ = margin;
  bar_ = bar;
  if (differs) update();
}

void Gauge::set_error(double error)
{
  error_ = error;
  const QString text = QString::fromStdString(error_text(error, row_.dimension, system_));
  if (text == error_text_) return;
  error_text_ = text;
  update();
}

void Gauge::set_marks(const std::vector<GaugeMark>& marks)
{
  QString tip = QStringLiteral("%1: %2").arg(row_.label, row_.source);
  for (const GaugeMark& mark : marks) tip += "\n" + mark.text;
  if (tip == toolTip()) return;
  marks_ = marks;
  setToolTip(tip);
  update();
}

void Gauge::set_truth(double value)
{
  truth_ = value;
  const QString text = std::isfinite(value) ? "truth " + shown_text(value, row_.dimension, system_) : QString("truth -");
  if (text == truth_text_) return;
  truth_text_ = text;
  if (shows_truth_) update();
}

double Gauge::place(double value, const QRect& area) const
{
  const double share = (value - scale_.low) / (scale_.high - scale_.low);
  return area.left() + std::clamp(share, 0.0, 1.0) * area.width();
}

void Gauge::paint_texts(QPainter& painter, const QRect& area)
{
  const int tall = std::clamp(area.height() - bar_height - 4 - (shows_truth_ ? truth_height : 0), 16, 44);
  const QRect line(area.left(), area.top(), area.width(), tall);
  QFont small = font();
  small.setPixelSize(std::clamp(tall / 2, 11, 16));
  painter.setFont(small);
  painter.setPen(QColor(look::faint));
  QString label = is_pulled() ? QString("Over-pull") : QString(row_.label);
  if (is_filled() && !stale_ && level_ != Level::normal) label.prepend(QString::fromUtf8(level_ == Level::alarm ? "▲ " : "△ "));
  int label_width = painter.fontMetrics().horizontalAdvance(label);
  const QString below = margin_text_.isEmpty() && shows_error() ? error_text_ : margin_text_;
  const QRect two_lines(area.left(), area.top() - 1, area.width(), area.height() - bar_height);
  painter.drawText(below.isEmpty() ? line : two_lines, Qt::AlignLeft | (below.isEmpty() ? Qt::AlignVCenter : Qt::AlignTop),
                   label);
  if (!below.isEmpty())
  {
    QFont fine = small;
    fine.setPixelSize(std::min(small.pixelSize(), 10));
    painter.setFont(fine);
    painter.drawText(two_lines, Qt::AlignLeft | Qt::AlignBottom, below);
    label_width = std::max(label_width, painter.fontMetrics().horizontalAdvance(below));
  }
  const QRect room = line.adjusted(label_width + 6, 0, 0, 0);

  QFont large = font();
  large.setBold(is_filled());
  int size = is_filled() ? std::clamp(tall * 13 / 20, 15, 23) : small.pixelSize();
  large.setPixelSize(size);
  while (size > 9 && QFontMetrics(large).horizontalAdvance(text_) > room.width()) large.setPixelSize(--size);
  painter.setFont(large);
  QColor color = level_ == Level::normal ? QColor(look::text) : color_of(level_);
  if (stale_ || lost_) color = QColor(look::off);
  if (!is_filled()) color = QColor(look::faint);
  painter.setPen(color);
  painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, text_);

  if (!shows_truth_) return;
  small.setPixelSize(10);
  painter.setFont(small);
  painter.setPen(QColor(look::off));
  painter.drawText(QRect(area.left(), area.bottom() - truth_height + 1, area.width(), truth_height),
                   Qt::AlignRight | Qt::AlignVCenter, truth_text_);
}

void Gauge::paint_bar(QPainter& painter, const QRect& area)
{
  painter.fillRect(area, QColor(look::groove));
  const auto zone = [&](double from, double to, Level level)
  {
    if (!std::isfinite(from) || !std::isfinite(to)) return;
    QColor color = color_of(level);
    color.setAlpha(110);
    const double a = place(from, area), b = place(to, area);
    painter.fillRect(QRectF(a, area.top(), b - a, area.height()), color);
  };
  zone(scale_.low, limits_.low_alarm, Level::alarm);
  zone(std::isfinite(limits_.low_alarm) ? limits_.low_alarm : scale_.low, limits_.low_caution, Level::caution);
  zone(limits_.high_caution, std::isfinite(limits_.high_alarm) ? limits_.high_alarm : scale_.high, Level::caution);
  zone(limits_.high_alarm, scale_.high, Level::alarm);
  if (!is_filled()) return;
  const double zero = place(std::clamp(0.0, scale_.low, scale_.high), area), here = place(value_, area);
  const QColor color = stale_ ? QColor(look::off) : color_of(level_);
  painter.fillRect(QRectF(std::min(zero, here), area.top(), std::max(std::abs(here - zero), 1.0), area.height()), color);
  painter.fillRect(QRectF(std::clamp(here - 1.0, double(area.left()), area.right() - 1.0), area.top() - 2, 3, area.height() + 4),
                   QColor(look::text));
  for (const GaugeMark& mark : marks_) paint_mark(painter, area, mark);
  if (shows_truth_ && std::isfinite(truth_))
    painter.fillRect(QRectF(place(truth_, area) - 0.5, area.top() - 2, 1, area.height() + 4), QColor(look::accent));
}

void Gauge::paint_mark(QPainter& painter, const QRect& bar, const GaugeMark& mark)
{
  const double at = place(mark.value, bar), top = bar.bottom() + 1.5, bottom = top + mark_height;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(QColor(look::text));
  painter.setPen(Qt::NoPen);
  if (mark.shape == MarkShape::line) painter.drawRect(QRectF(at - 1.0, top, 2.0, mark_height));
  if (mark.shape == MarkShape::dot)
    painter.drawEllipse(QPointF(at, top + 0.5 * mark_height), 0.5 * mark_height, 0.5 * mark_height);
  const bool is_up = mark.shape == MarkShape::up;
  const double tip = is_up ? top : bottom, base = is_up ? bottom : top;
  if (is_up || mark.shape == MarkShape::down) painter.drawPolygon(QPolygonF({{at, tip}, {at - 3.5, base}, {at + 3.5, base}}));
  painter.restore();
}

void Gauge::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(rect(), QColor(look::tile));
  if (level_ != Level::normal && is_filled() && !stale_) painter.fillRect(QRect(0, 0, 3, height()), color_of(level_));
  const QRect area = rect().adjusted(margin, 2, -margin, -6);
  paint_texts(painter, area);
  const int below = shows_truth_ ? truth_height : 0;
  paint_bar(painter, QRect(area.left(), area.bottom() - below - bar_height + 1, area.width(), bar_height));
}

void Gauge::contextMenuEvent(QContextMenuEvent* event)
{
  QMenu menu(this);
  menu.addAction("Scale anew from now on", this, &Gauge::forget);
  menu.exec(event->globalPos());
}

}  // namespace drill_rig_sim::console

// SPDX-License-Identifier: BSD-3-Clause
#include "chart_track.h"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "look.h"

namespace drill_rig_sim::console
{
/// A curve in pieces: nothing is drawn where nothing was received.
class StrokeCurve : public QwtPlotCurve
{
public:
  void set_strokes(const std::vector<Stroke>& strokes, double per_si, double per_place, bool downwards)
  {
    QVector<QPointF> points;
    begins_.clear();
    for (const Stroke& stroke : strokes)
    {
      begins_.push_back(points.size());
      for (const ChartPoint& p : stroke)
      {
        const double x = p.x * per_place, y = p.y * per_si;
        points.push_back(downwards ? QPointF(y, x) : QPointF(x, y));
      }
    }
    setSamples(points);
  }

protected:
  void drawSeries(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas, int from,
                  int to) const override
  {
    if (to < 0) to = static_cast<int>(dataSize()) - 1;
    for (std::size_t n = 0; n < begins_.size(); ++n)
    {
      const int begin = std::max(from, begins_[n]);
      const int end = std::min(to, n + 1 < begins_.size() ? begins_[n + 1] - 1 : to);
      if (end >= begin) QwtPlotCurve::drawSeries(painter, x, y, canvas, begin, end);
    }
  }

private:
  std::vector<int> begins_;
};

namespace
{
constexpr int value_extent = 46, end_margin = 24, columns = 500;
constexpr QRgb colors[] = {0xff58a6e0, 0xffe0a050, 0xff70c080, 0xffd070c0, 0xffd8d060, 0xff60c8c8};

/// Simulated time as h:mm:ss.
class TimeDraw : public QwtScaleDraw
{
public:
  QwtText label(double value) const override
  {
    const auto s = static_cast<long long>(std::floor(value + 0.5));
    if (s < 0) return QString();
    return QStringLiteral("%1:%2:%3").arg(s / 3600).arg(s / 60 % 60, 2, 10, QChar('0')).arg(s % 60, 2, 10, QChar('0'));
  }
};

void paint_plot(QwtPlot* plot)
{
  plot->setAutoReplot(false);
  plot->setCanvasBackground(QColor(0xff15181c));
  auto* canvas = new QwtPlotCanvas(plot);
  canvas->setFrameStyle(QFrame::NoFrame);
  canvas->setMouseTracking(true);
  plot->setCanvas(canvas);
  plot->plotLayout()->setAlignCanvasToScales(true);
  auto* grid = new QwtPlotGrid;
  grid->setPen(QPen(QColor(look::tile), 1));
  grid->attach(plot);
  QFont small = plot->font();
  small.setPixelSize(10);
  for (int axis = 0; axis < QwtPlot::axisCnt; ++axis)
  {
    plot->setAxisFont(axis, small);
    plot->axisWidget(axis)->setMargin(0);
    plot->axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MinorTick, 0);
  }
}
}  // namespace

ChartTrack::ChartTrack(Quantity quantity, int number, QWidget* parent)
    : QWidget(parent),
      quantity_(quantity),
      color_(colors[static_cast<std::size_t>(number) % (sizeof colors / sizeof colors[0])]),
      title_(make_label("", this)),
      plot_(new QwtPlot(this)),
      curve_(new StrokeCurve),
      cursor_(new QwtPlotMarker)
{
  setAccessibleName(QStringLiteral("chart ") + row_of(quantity).key);
  title_->setAccessibleName(QStringLiteral("chart value ") + row_of(quantity).key);
  QPalette p = palette();
  p.setColor(QPalette::WindowText, color_);
  title_->setPalette(p);
  paint_plot(plot_);
  curve_->setPen(color_, 1.2);
  curve_->setPaintAttribute(QwtPlotCurve::FilterPoints, true);
  curve_->attach(plot_);
  cursor_->setLinePen(QColor(look::text), 1, Qt::DashLine);
  cursor_->setVisible(false);
  cursor_->attach(plot_);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(0);
  box->addWidget(title_);
  box->addWidget(plot_, 1);
  set_axis(Axis::time, false, true);
}

ChartTrack::~ChartTrack() = default;

void ChartTrack::set_axis(Axis axis, bool downwards, bool labelled)
{
  axis_ = axis;
  downwards_ = downwards;
  const int common = downwards ? QwtPlot::yLeft : QwtPlot::xBottom;
  plot_->setAxisScaleDraw(value_side(), new QwtScaleDraw);
  plot_->setAxisScaleDraw(common, axis == Axis::time ? new TimeDraw : new QwtScaleDraw);
  plot_->axisScaleDraw(QwtPlot::yLeft)->setMinimumExtent(downwards ? 0 : value_extent);
  // an axis without numbers still keeps their margins: the tracks stand in line
  plot_->enableAxis(QwtPlot::xBottom, true);
  plot_->enableAxis(QwtPlot::yLeft, true);
  for (const auto part : {QwtScaleDraw::Labels, QwtScaleDraw::Ticks, QwtScaleDraw::Backbone})
    plot_->axisScaleDraw(common)->enableComponent(part, labelled);
  plot_->axisWidget(QwtPlot::xBottom)->setMinBorderDist(downwards ? 4 : end_margin, downwards ? 4 : end_margin);
  plot_->axisWidget(QwtPlot::yLeft)->setMinBorderDist(6, 6);
  plot_->setAxisMaxMajor(QwtPlot::xBottom, downwards ? 3 : 5);
  plot_->setAxisMaxMajor(QwtPlot::yLeft, downwards ? 12 : 4);
  for (const int side : {int(QwtPlot::xBottom), int(QwtPlot::yLeft)})
    plot_->axisScaleDraw(side)->setTickLength(QwtScaleDiv::MinorTick, 0);
  title_->setFixedHeight((downwards ? 3 : 1) * title_->fontMetrics().lineSpacing() + 2);
  title_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  title_->setMinimumWidth(10);  // a track does not widen with its number
  cursor_->setLineStyle(downwards ? QwtPlotMarker::HLine : QwtPlotMarker::VLine);
  plot_->setMinimumSize(downwards ? 50 : 120, downwards ? 120 : 50);
}

void ChartTrack::set_units(UnitSystem system)
{
  system_ = system;
}

double ChartTrack::shown_place(double place) const
{
  return axis_ == Axis::time ? place : to_shown(place, Dimension::length, system_);
}

double ChartTrack::place_at(const QPoint& point) const
{
  const double place =
      downwards_ ? plot_->invTransform(QwtPlot::yLeft, point.y()) : plot_->invTransform(QwtPlot::xBottom, point.x());
  return axis_ == Axis::time ? place : to_si(place, Dimension::length, system_);
}

int ChartTrack::value_side() const
{
  return downwards_ ? QwtPlot::xBottom : QwtPlot::yLeft;
}

FixedScale ChartTrack::scale() const
{
  const QwtScaleDiv& shown = plot_->axisScaleDiv(value_side());
  const double per_si = unit_of(row_of(quantity_).dimension, system_).per_si;
  return {shown.lowerBound() / per_si, shown.upperBound() / per_si};
}

void ChartTrack::scale_values()
{
  const int side = value_side();
  const Unit& unit = unit_of(row_of(quantity_).dimension, system_);
  if (scale_) return plot_->setAxisScale(side, scale_->low * unit.per_si, scale_->high * unit.per_si);
  const QRectF box = curve_->boundingRect();
  double low = downwards_ ? box.left() : box.top(), high = downwards_ ? box.right() : box.bottom();
  if (curve_->dataSize() == 0) low = 0.0, high = 1.0;
  const double least = 10.0 * std::pow(10.0, -unit.decimals);  // a scale that shows nothing but the last digit would show noise
  const double more = std::max(0.06 * (high - low), 0.5 * std::max(0.0, least - (high - low)));
  plot_->setAxisScale(side, low - more, high + more);
}

void ChartTrack::show_line(const History& history, double from, double to)
{
  const double per_si = unit_of(row_of(quantity_).dimension, system_).per_si;
  curve_->set_strokes(history.line(quantity_, from, to, columns), per_si, shown_place(1.0), downwards_);
  if (downwards_)
    plot_->setAxisScale(QwtPlot::yLeft, shown_place(to), shown_place(from));  // deeper, or later, is further down
  else
    plot_->setAxisScale(QwtPlot::xBottom, shown_place(from), shown_place(to));
  scale_values();
  plot_->replot();
}

void ChartTrack::show_cursor(const History& history, double place)
{
  const QuantityRow& row = row_of(quantity_);
  double value = missing;
  if (!history.empty())
    value = history[std::isfinite(place) ? history.nearest(place) : history.size() - 1].value[index_of(quantity_)];
  // downwards a track is narrow: name, value and place one below the other
  const QString apart = downwards_ ? "\n" : "  ";
  QString text = row.label + apart + shown_text(value, row.dimension, system_);
  if (scale_ && value > scale_->high) text += QString::fromUtf8(" ▲");
  if (scale_ && value < scale_->low) text += QString::fromUtf8(" ▼");
  const QString where = axis_ == Axis::time ? TimeDraw().label(place).text() : shown_text(place, Dimension::length, system_);
  if (std::isfinite(place)) text += apart + "at " + where;
  tell(title_, text);
  cursor_->setVisible(std::isfinite(place));
  if (!std::isfinite(place)) return;
  if (downwards_)
    cursor_->setYValue(shown_place(place));
  else
    cursor_->setXValue(shown_place(place));
}

}  // namespace drill_rig_sim::console

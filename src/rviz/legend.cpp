// SPDX-License-Identifier: BSD-3-Clause
#include "legend.h"

#include <QFontMetrics>
#include <QPainter>

namespace drill_rig_sim
{
namespace
{
constexpr int width = 230, edge = 10, row_height = 20, bar_height = 200, bar_width = 22, title_height = 26;
const QColor ink(235, 235, 235), faint(170, 175, 180), ground(18, 20, 24, 205);

QColor to_qcolor(const Color& c)
{
  return QColor::fromRgbF(c.r, c.g, c.b, c.a);
}

QFont font(bool bold)
{
  QFont f("Liberation Sans");
  f.setPixelSize(14);
  f.setBold(bold);
  return f;
}

QImage ground_of(int height)
{
  QImage image(width, height, QImage::Format_ARGB32);
  image.fill(ground);
  return image;
}

void write(QPainter& painter, const QString& text, int y, const QColor& color, Qt::Alignment where = Qt::AlignLeft,
           int indent = 0)
{
  painter.setPen(color);
  painter.drawText(QRect(edge + indent, y, width - 2 * edge - indent, row_height), static_cast<int>(where | Qt::AlignVCenter),
                   text);
}

void write_rows(QPainter& painter, const std::vector<std::pair<QString, QString>>& rows, int y)
{
  for (const auto& [what, value] : rows)
  {
    write(painter, what, y, faint);
    write(painter, value, y, ink, Qt::AlignRight);
    y += row_height;
  }
}

void draw_bar(QPainter& painter, const ColorScale& scale, int top)
{
  const auto row_of = [&](double value)
  { return top + static_cast<int>((scale.high() - value) / (scale.high() - scale.low()) * (bar_height - 1)); };
  for (int y = 0; y < bar_height; ++y)
  {
    painter.setPen(to_qcolor(scale.at(scale.high() - (scale.high() - scale.low()) * y / (bar_height - 1))));
    painter.drawLine(edge, top + y, edge + bar_width, top + y);
  }
  const std::vector<double> ticks = scale.ticks(6);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : scale.high();
  for (const double tick : ticks)
  {
    const int y = row_of(tick);
    painter.setPen(ink);
    painter.drawLine(edge + bar_width, y, edge + bar_width + 6, y);
    write(painter, QString::fromStdString(written(tick, step)), y - row_height / 2, ink, Qt::AlignLeft, bar_width + 12);
  }
}
}  // namespace

QImage paint_legend(const Legend& legend)
{
  const int rows = static_cast<int>(legend.rows.size()), classes = static_cast<int>(legend.classes.size());
  const int middle = classes > 0 ? classes * row_height : bar_height + 8;
  QImage image = ground_of(2 * edge + title_height + middle + (rows > 0 ? 8 + rows * row_height : 0));
  QPainter painter(&image);
  painter.setFont(font(true));
  write(painter, legend.title, edge - 4, ink);
  painter.setFont(font(false));
  const int top = edge + title_height;
  if (classes == 0) draw_bar(painter, legend.scale, top);
  for (int i = 0; i < classes; ++i)
  {
    const auto& [name, color] = legend.classes[static_cast<std::size_t>(i)];
    painter.fillRect(edge, top + i * row_height + 3, bar_width, row_height - 6, to_qcolor(color));
    write(painter, name, top + i * row_height, ink, Qt::AlignLeft, bar_width + 12);
  }
  write_rows(painter, legend.rows, top + middle + 8);
  return image;
}

QImage paint_table(const QString& title, const std::vector<std::pair<QString, QString>>& rows)
{
  QImage image = ground_of(2 * edge + title_height + static_cast<int>(rows.size()) * row_height);
  QPainter painter(&image);
  painter.setFont(font(true));
  write(painter, title, edge - 4, ink);
  painter.setFont(font(false));
  write_rows(painter, rows, edge + title_height);
  return image;
}

}  // namespace drill_rig_sim

// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_LEGEND_H
#define DRILL_RIG_SIM_SRC_RVIZ_LEGEND_H

#include <QImage>
#include <QString>
#include <utility>
#include <vector>

#include "picture/color_scale.h"

namespace drill_rig_sim
{
/// What colours mean, and some numbers beside.
struct Legend
{
  QString title;  ///< quantity and unit
  ColorScale scale{0.0, 1.0};
  std::vector<std::pair<QString, Color>> classes;  ///< instead of a scale
  std::vector<std::pair<QString, QString>> rows;   ///< what, how much
};

/// A colour bar with ticks, or classes, above a table; light on dark, 230 pixels wide.
QImage paint_legend(const Legend& legend);

/// A table alone, under a title.
QImage paint_table(const QString& title, const std::vector<std::pair<QString, QString>>& rows);

}  // namespace drill_rig_sim

#endif

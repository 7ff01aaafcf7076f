// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_BLOCK_BAR_H
#define DRILL_RIG_SIM_RVIZ_BLOCK_BAR_H

#include <QString>
#include <QWidget>

#include "console/units.h"

namespace drill_rig_sim::console
{
/// What the block bar shows [SI].
struct BlockPlace
{
  double height, velocity, lowest, highest;  // NaN: not known
  unsigned stands;                           // in the string
  bool in_slips, brake, stale;
};

/// Where the block hangs in the mast, between its lowest and highest place, how it moves, and how many stands hang on it.
class BlockBar : public QWidget
{
  Q_OBJECT
public:
  explicit BlockBar(QWidget* parent);
  void show_place(const BlockPlace& place);
  void set_units(UnitSystem system);

  QSize sizeHint() const override { return {190, 150}; }
  QSize minimumSizeHint() const override { return {130, 110}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  QString height_text() const;
  QString way_text() const;
  void paint_mast(QPainter& painter, const QRect& mast);
  void paint_lines(QPainter& painter, const QRect& area);

  BlockPlace place_;
  UnitSystem system_ = UnitSystem::si;
};

}  // namespace drill_rig_sim::console

#endif

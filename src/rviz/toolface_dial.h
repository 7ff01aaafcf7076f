// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_TOOLFACE_DIAL_H
#define DRILL_RIG_SIM_RVIZ_TOOLFACE_DIAL_H

#include <QWidget>
#include <vector>

namespace drill_rig_sim::console
{
/// Where the bend points, as looked at downhole: the latest toolface outside, earlier ones further in and fainter. Up is the high
/// side, or north for a magnetic toolface. Its accessible description is what it shows.
class ToolfaceDial : public QWidget
{
  Q_OBJECT
public:
  explicit ToolfaceDial(QWidget* parent);
  /// Oldest first [rad]; `magnetic`: of the latest.
  void show_toolfaces(const std::vector<double>& toolfaces, bool magnetic, bool stale);
  /// NaN: none [rad].
  void set_truth(double toolface);

  QSize sizeHint() const override { return {190, 150}; }
  QSize minimumSizeHint() const override { return {130, 110}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  void paint_face(QPainter& painter, const QPointF& centre, double radius);
  void paint_history(QPainter& painter, const QPointF& centre, double radius);

  std::vector<double> toolfaces_;
  bool magnetic_ = false, stale_ = true;
  double truth_;
};

}  // namespace drill_rig_sim::console

#endif

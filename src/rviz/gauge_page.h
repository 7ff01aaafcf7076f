// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_GAUGE_PAGE_H
#define DRILL_RIG_SIM_RVIZ_GAUGE_PAGE_H

#include <QWidget>
#include <vector>

#include "console/limits.h"
#include "console/string_weights.h"
#include "message_values.h"

class QGridLayout;

namespace drill_rig_sim::console
{
class BlockBar;
class Gauge;
class ToolfaceDial;

/// The gauges in as many columns as there is room for, toolface dial and block bar below them.
class GaugePage : public QWidget
{
  Q_OBJECT
public:
  explicit GaugePage(QWidget* parent);
  /// A few of the gauges once more, for another page: what is shown is the same, but for the truth. Their accessible names begin
  /// with `kind`.
  QWidget* make_strip(const QString& kind, const std::vector<Quantity>& chosen, QWidget* parent);

  void set_units(UnitSystem system);
  void show_truth(bool on);
  /// Marks of the hook load: what it was when WOB was zeroed, and the weights of the string.
  void show_marks(const News& news, const StringWeights& weights, UnitSystem system);
  void show_news(const News& news, const Values& readings, const Values& truth, const OwnAlarms& own, bool stale);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void arrange(int columns);
  void show_block(const News& news, const RigAbilities& rig, bool stale);
  void show_toolface(const News& news, const Values& truth, bool stale);

  std::vector<Gauge*> gauges_, all_;  // of this page; of the strips too
  ToolfaceDial* dial_;
  BlockBar* block_;
  QGridLayout* grid_;
  int columns_ = 0;
};

}  // namespace drill_rig_sim::console

#endif

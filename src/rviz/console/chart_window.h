// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_CHART_WINDOW_H
#define DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_CHART_WINDOW_H

#include <algorithm>

namespace drill_rig_sim::console
{
/// The piece of the axis that a chart shows: it follows the latest sample until it is paused, which recording is not.
class ChartWindow
{
public:
  /// `least`, `most`: how little and how much it shows at once [s] or [m].
  ChartWindow(double span, double least, double most) : span_(span), least_(least), most_(most) {}

  double from() const { return end_ - span_; }
  double to() const { return end_; }
  double span() const { return span_; }
  bool paused() const { return paused_; }
  void set_span(double span) { span_ = std::clamp(span, least_, most_); }
  /// A window that goes on after a pause jumps to the latest at once.
  void pause(bool on)
  {
    paused_ = on;
    if (!on) end_ = latest_;
  }
  /// There is a sample here.
  void follow(double latest)
  {
    latest_ = latest;
    if (!paused_) end_ = latest;
  }
  /// Shows `factor` times as much; what is at `around` stays there, or the latest while it follows.
  void zoom(double factor, double around)
  {
    const double before = span_;
    set_span(span_ * factor);
    if (paused_) end_ = around + (end_ - around) * span_ / before;
  }
  /// Moves by so much, and pauses: who looks back does not want it to run away.
  void pan(double by)
  {
    paused_ = true;
    end_ += by;
  }

private:
  double span_, least_, most_, end_ = 0.0, latest_ = 0.0;
  bool paused_ = false;
};

}  // namespace drill_rig_sim::console

#endif

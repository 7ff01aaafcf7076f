// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_DRILLERS_CONSOLE_H
#define DRILL_RIG_SIM_RVIZ_DRILLERS_CONSOLE_H

#include <rviz/panel.h>

#include <vector>

#include "console/link_state.h"
#include "console/string_weights.h"
#include "drill_rig_sim/RigTruth.h"
#include "settings_page.h"

class QLabel;
class QTabWidget;
class QTimer;
class QHBoxLayout;

namespace drill_rig_sim
{
namespace console
{
class ChartPage;
class Controls;
class EventPage;
class GaugePage;
class HeaderBar;
class LawControls;
class RigLink;
class WinchControls;
}  // namespace console

/// What a driller watches and works with, as a panel of rviz. It listens to one rig while it is shown, and to nothing while it is
/// hidden.
class DrillersConsole : public rviz::Panel
{
  Q_OBJECT
public:
  explicit DrillersConsole(QWidget* parent = nullptr);
  ~DrillersConsole() override;

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;
  QSize sizeHint() const override { return {420, 680}; }

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void make_pages();
  QWidget* make_control_page(const QString& name, QWidget* above, const std::vector<console::Controls*>& groups);
  void add_page(QWidget* page, const QString& title);
  void arrange(bool wide);
  void connect_pages();
  void apply_settings();
  void change_namespace(const QString& name);
  void tick();
  void show_state();
  void show_news();
  void take_answer(const QString& what, bool success, const QString& text);

  console::RigLink* link_;
  QTimer* timer_;
  console::HeaderBar* header_;
  QHBoxLayout* body_;
  QTabWidget* tabs_;
  console::GaugePage* gauges_;
  console::ChartPage* chart_;
  console::EventPage* events_;
  console::SettingsPage* settings_;
  console::WinchControls* winch_;
  console::LawControls* law_;
  std::vector<console::Controls*> controls_;
  QLabel* answer_;
  console::LinkState state_ = console::LinkState::hidden;
  boost::shared_ptr<const RigTruth> truth_;  // the latest
  console::StringWeights weights_;
  const void* limits_ = nullptr;  // the last that were shown
  int ticks_ = 0;
};

}  // namespace drill_rig_sim

#endif

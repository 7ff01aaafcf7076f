// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_LAW_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_LAW_CONTROLS_H

#include <QJsonObject>
#include <QStringList>
#include <vector>

#include "controls.h"

class QProcess;
class QPushButton;
class QTimer;

namespace drill_rig_sim::console
{
/// The package's autodriller: limits that start it and that it follows, which loop leads, and a button that stops it; and a
/// connection by one click. The law runs in a process of its own (src/python/web/law_process.py), by the orders of drill web's
/// page, and ends with this box. What any law does is shown by the topic controller/status. A command to the winch takes the
/// block from the law.
class LawControls : public Controls
{
  Q_OBJECT
public:
  LawControls(RigLink& link, QWidget* parent);
  ~LawControls() override;
  void show_news(const News& news) override;
  /// Ends the law's process: the law stops, and the brake is set.
  void end();

private:
  void start();
  void connect_pipe();
  void stop();
  void apply() override;
  void take_block();
  /// Sends an order of this type with all limits; a limit of 0 of differential pressure or torque is none.
  void order(const char* type);
  void write(const QJsonObject& order);
  void begin_process();
  void read();
  void process_ended();
  bool runs() const { return law_.value("running").toBool(); }
  /// Whether what runs is a connection.
  bool connects() const { return runs() && law_.value("connects").toBool(); }

  std::vector<UnitBox*> boxes_;  // by law_points
  QPushButton *start_, *apply_, *stop_, *connection_;
  QLabel* status_;
  QProcess* process_ = nullptr;
  QTimer* alive_;
  QJsonObject law_;  // what the process has said last
};

}  // namespace drill_rig_sim::console

#endif

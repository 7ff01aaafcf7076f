// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_RIG_LINK_H
#define DRILL_RIG_SIM_RVIZ_RIG_LINK_H

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <chrono>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "drill_rig_sim/MudPumpCommand.h"
#include "drill_rig_sim/SteeringCommand.h"
#include "drill_rig_sim/TopDriveCommand.h"
#include "drill_rig_sim/WinchCommand.h"
#include "message_values.h"
#include "service_caller.h"

namespace drill_rig_sim::console
{
/// The console's side of the ROS interface: topics of one rig, its commands and services. Messages are taken by `poll` alone, in
/// the thread that calls it.
class RigLink : public QObject
{
  Q_OBJECT
public:
  explicit RigLink(QObject* parent = nullptr);
  ~RigLink() override;

  /// Namespace of the rig; empty: rviz's own, or, where there is none, the only rig that the master knows. What ROS takes for no
  /// name is refused.
  void set_namespace(const QString& name);
  const QString& wanted_namespace() const { return wanted_; }
  /// The one that is listened to, from the root: "/rig".
  QString used_namespace() const;
  /// All that the master knows.
  static QStringList known_namespaces();
  /// Whether truth/bit is subscribed to, and the news hold the truth.
  void set_truth(bool on);
  bool truth() const { return truth_; }
  /// Subscribes; advertises the commands, which then stay.
  void start();
  /// Unsubscribes from everything.
  void stop();
  /// Takes what has come; looks for the master or a rig that is not there.
  void poll();

  const News& news() const { return news_; }
  /// Every rig_state since the last call, oldest first.
  std::vector<RigStateConstPtr> take_states() { return std::exchange(taken_, {}); }
  /// Every truth/rig_state since the last call: its flags that no rig can sense are alarms.
  std::vector<RigTruthConstPtr> take_truths() { return std::exchange(taken_truths_, {}); }
  LinkState state() const;
  /// Since rig_state last came [s of wall time].
  double age() const;

  /// Commands: false, and `said`, where they have no subscriber.
  bool command(const WinchCommand& command);  // `winch_commanded` where it was sent
  bool command(const TopDriveCommand& command);
  bool command(const MudPumpCommand& command);
  bool command(const SteeringCommand& command);
  /// Why top drive and pump take no command at present, as while a law of the console has them; empty: they do.
  void set_busy(const QString& why) { busy_ = why; }
  /// Calls a service of the rig by its relative name; the answer comes as `said`.
  template <class Service>
  void call(const QString& name, const Service& service, double patience = 10.0)
  {
    if (!can_call(name)) return;
    caller_.call(node_->resolveName(name.toStdString()), name, service, patience);
  }
  /// Asks for the names of the snapshots that the rig keeps, which come as `states`; where no rig answers nothing comes.
  void ask_states();
  int pending_calls() const { return caller_.pending(); }

Q_SIGNALS:
  /// Answer of a service, or why a command was not sent.
  void said(const QString& what, bool success, const QString& text);
  void states(const QStringList& names);
  void winch_commanded();
  /// Another rig from now on, or none.
  void changed();

private:
  using Clock = std::chrono::steady_clock;

  template <class Message>
  void hear(const std::string& topic, boost::shared_ptr<Message const>& slot);
  // A command's topic and the nodes that are connected to it.
  struct Outlet
  {
    ros::Publisher publisher;
    std::set<std::string> hearers;
  };
  template <class Message>
  void advertise(Outlet& outlet, const std::string& topic);
  template <class Message>
  bool send(Outlet& outlet, const QString& what, const Message& message);
  bool is_heard(const Outlet& outlet) const;
  bool is_free(const QString& what);
  bool can_call(const QString& name);
  void subscribe();
  void subscribe_truth();
  void take_state(const ros::MessageEvent<RigState const>& event);
  void take_toolface(const MwdToolfaceConstPtr& m);
  void take_diagnostics(const diagnostic_msgs::DiagnosticArrayConstPtr& m);
  void look_around();
  void move_to(const std::string& name);
  RunState run_state() const;

  QString wanted_;
  bool truth_ = false, shown_ = false, master_ = false;
  ros::CallbackQueue queue_;
  std::unique_ptr<ros::NodeHandle> node_;
  std::vector<ros::Subscriber> subscribers_, of_truth_;
  ros::Subscriber states_, controller_;
  QString busy_;
  Outlet winch_, top_drive_, pump_, steering_;
  std::string rig_node_;  // that simulates; empty: not known yet
  std::vector<RigStateConstPtr> taken_;
  std::vector<RigTruthConstPtr> taken_truths_;
  News news_;
  Clock::time_point state_heard_, diagnostics_heard_, looked_;
  ServiceCaller caller_;
};

}  // namespace drill_rig_sim::console

#endif

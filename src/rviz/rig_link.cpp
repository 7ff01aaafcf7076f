// SPDX-License-Identifier: BSD-3-Clause
#include "rig_link.h"

#include <ros/master.h>
#include <ros/names.h>

#include <algorithm>

#include "drill_rig_sim/math/ends_with.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr std::size_t most_toolfaces = 12;  // that are remembered
constexpr unsigned longest_queue =
    4000;  // of rig_state: no peak is lost in 2 s of a busy window at 100 Hz and 20 times real time
constexpr auto between_looks = std::chrono::seconds(2);  // at master and rigs that are not there
const std::string state_topic = "rig_state";

double seconds_since(std::chrono::steady_clock::time_point then)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

std::string value_of(const diagnostic_msgs::DiagnosticStatus& status, const std::string& key)
{
  for (const auto& pair : status.values)
    if (pair.key == key) return pair.value;
  return "";
}

double number_of(const std::string& text, double otherwise)
{
  bool is_number = false;
  const double number = QString::fromStdString(text).toDouble(&is_number);
  return is_number ? number : otherwise;
}

constexpr char list_states[] = "list_states";
}  // namespace

RigLink::RigLink(QObject* parent)
    : QObject(parent), state_heard_(Clock::now()), diagnostics_heard_(state_heard_), looked_(state_heard_)
{
  connect(&caller_, &ServiceCaller::answered, this,
          [this](const QString& what, bool success, const QString& text)
          {
            if (what != list_states)
              Q_EMIT said(what, success, text);
            else if (success)
              Q_EMIT states(text.split('\n', Qt::SkipEmptyParts));
          });
  move_to("");
}

RigLink::~RigLink()
{
  stop();
  queue_.disable();
}

void RigLink::move_to(const std::string& name)
{
  stop();
  for (Outlet* outlet : {&winch_, &top_drive_, &pump_, &steering_})
  {
    outlet->publisher.shutdown();
    outlet->hearers.clear();
  }
  rig_node_.clear();
  node_ = std::make_unique<ros::NodeHandle>(name);
  node_->setCallbackQueue(&queue_);
  news_ = News();
}

void RigLink::set_namespace(const QString& name)
{
  std::string why;
  const std::string text = name.trimmed().toStdString();
  if (!text.empty() && !ros::names::validate(text, why))
  {
    Q_EMIT said("namespace", false, QString::fromStdString(why));
    return;
  }
  const bool was_shown = shown_;
  wanted_ = QString::fromStdString(text);
  move_to(text);
  if (was_shown) start();
  Q_EMIT changed();
}

QString RigLink::used_namespace() const
{
  return QString::fromStdString(node_->getNamespace());
}

QStringList RigLink::known_namespaces()
{
  QStringList names;
  ros::master::V_TopicInfo topics;
  if (!ros::master::getTopics(topics)) return names;
  for (const auto& topic : topics)
    if (topic.datatype == "drill_rig_sim/RigState" && ends_with(topic.name, "/" + state_topic))
      names << QString::fromStdString(topic.name.size() == state_topic.size() + 1 ? "/"
                                                                                  : ros::names::parentNamespace(topic.name));
  names.sort();
  return names;
}

template <class Message>
void RigLink::hear(const std::string& topic, boost::shared_ptr<Message const>& slot)
{
  const boost::function<void(const boost::shared_ptr<Message const>&)> take = [&slot](const boost::shared_ptr<Message const>& m)
  { slot = m; };
  subscribers_.push_back(node_->subscribe<Message>(topic, 1, take));
}

void RigLink::start()
{
  shown_ = true;
  state_heard_ = diagnostics_heard_ = looked_ = Clock::now();
  master_ = ros::ok() && ros::master::check();
  if (master_) subscribe();
}

void RigLink::stop()
{
  shown_ = false;
  subscribers_.clear();
  of_truth_.clear();
  states_.shutdown();
  controller_.shutdown();
  news_.controller.reset();
  taken_.clear();
  taken_truths_.clear();
}

void RigLink::subscribe()
{
  states_ = node_->subscribe(state_topic, longest_queue, &RigLink::take_state, this, ros::TransportHints().tcpNoDelay());
  const boost::function<void(const RigTruthConstPtr&)> take_truth = [this](const RigTruthConstPtr& m)
  {
    taken_truths_.push_back(m);
    if (truth_) news_.truth = m;
  };
  subscribers_.push_back(node_->subscribe<RigTruth>("truth/rig_state", longest_queue, take_truth));
  const boost::function<void(const ControllerStatusConstPtr&)> take_controller = [this](const ControllerStatusConstPtr& m)
  { news_.controller = m; };
  controller_ = node_->subscribe<ControllerStatus>("controller/status", 10, take_controller);
  hear("rig_limits", news_.limits);
  hear("accuracy", news_.accuracy);
  hear("downhole/mwd", news_.survey);
  hear("downhole/inclination", news_.inclination);
  hear("downhole/dynamics", news_.dynamics);
  subscribers_.push_back(node_->subscribe("downhole/toolface", 10, &RigLink::take_toolface, this));
  subscribers_.push_back(node_->subscribe("/diagnostics", 10, &RigLink::take_diagnostics, this));
  if (truth_) subscribe_truth();
  if (winch_.publisher) return;
  advertise<WinchCommand>(winch_, "winch/command");
  advertise<TopDriveCommand>(top_drive_, "top_drive/command");
  advertise<MudPumpCommand>(pump_, "mud_pump/command");
  advertise<SteeringCommand>(steering_, "steering/command");
}

void RigLink::subscribe_truth()
{
  const boost::function<void(const BitTruthConstPtr&)> bit = [this](const BitTruthConstPtr& m) { news_.bit = m; };
  of_truth_.push_back(node_->subscribe<BitTruth>("truth/bit", 1, bit));
}

template <class Message>
void RigLink::advertise(Outlet& outlet, const std::string& topic)
{
  const ros::SubscriberStatusCallback comes = [&outlet](const ros::SingleSubscriberPublisher& p)
  { outlet.hearers.insert(p.getSubscriberName()); };
  const ros::SubscriberStatusCallback goes = [&outlet](const ros::SingleSubscriberPublisher& p)
  { outlet.hearers.erase(p.getSubscriberName()); };
  outlet.publisher = node_->advertise<Message>(topic, 1, comes, goes);
}

void RigLink::set_truth(bool on)
{
  if (truth_ == on) return;
  truth_ = on;
  of_truth_.clear();
  news_.truth.reset();
  news_.bit.reset();
  if (on && shown_ && master_) subscribe_truth();
}

void RigLink::take_state(const ros::MessageEvent<RigState const>& event)
{
  const RigStateConstPtr m = event.getMessage();
  rig_node_ = event.getPublisherName();
  if (news_.state && m->header.stamp < news_.state->header.stamp)  // a node that began anew
  {
    news_.survey.reset();
    news_.inclination.reset();
    news_.dynamics.reset();
    news_.accuracy.reset();
    news_.toolfaces.clear();
  }
  news_.state = m;
  taken_.push_back(m);
  state_heard_ = Clock::now();
}

void RigLink::take_toolface(const MwdToolfaceConstPtr& m)
{
  news_.toolfaces.push_back(m);
  if (news_.toolfaces.size() > most_toolfaces) news_.toolfaces.pop_front();
}

void RigLink::take_diagnostics(const diagnostic_msgs::DiagnosticArrayConstPtr& m)
{
  for (const auto& status : m->status)
  {
    // its node's name without the first slash; the node lies in the rig's namespace itself
    if (QString::fromStdString(ros::names::parentNamespace("/" + status.hardware_id)) != used_namespace()) continue;
    rig_node_ = "/" + status.hardware_id;
    const std::string text = status.level == diagnostic_msgs::DiagnosticStatus::OK ? "" : status.message;
    Diagnosis& d = news_.diagnosis;
    if (ends_with(status.name, ": time"))
    {
      d.time = text;
      d.run_state = run_state_of(value_of(status, "state"));
      d.real_time_factor = number_of(value_of(status, "real_time_factor"), missing);
      d.speed = number_of(value_of(status, "speed"), 1.0);
      diagnostics_heard_ = Clock::now();
    }
    else if (ends_with(status.name, ": physics"))
    {
      d.physics = text;
      d.pull_to_yield = number_of(value_of(status, "pull_to_yield"), missing);
    }
    else if (ends_with(status.name, ": accuracy"))
      d.accuracy = text;
    else if (ends_with(status.name, ": commands"))
      d.commands = text;
  }
}

void RigLink::poll()
{
  if (!shown_ || !ros::ok()) return;
  queue_.callAvailable();
  if (Clock::now() - looked_ < between_looks) return;
  looked_ = Clock::now();
  if (controller_.getNumPublishers() == 0) news_.controller.reset();  // a law whose node is gone does not run
  look_around();
}

void RigLink::look_around()
{
  if (!master_)
  {
    start();
    return;
  }
  if (state() != LinkState::absent) return;
  master_ = ros::master::check();
  if (!master_ || !wanted_.isEmpty()) return;
  const QStringList names = known_namespaces();
  if (names.size() != 1 || names.front() == used_namespace()) return;
  move_to(names.front().toStdString());
  start();
  Q_EMIT changed();
}

double RigLink::age() const
{
  return seconds_since(state_heard_);
}

RunState RigLink::run_state() const
{
  // rig_state is the quicker of the two; who did not listen when a pause began has only the other
  const bool diagnosed = news_.diagnosis.run_state != RunState::unknown && diagnostics_heard_ > state_heard_;
  return news_.state && !diagnosed ? run_state_of(*news_.state) : news_.diagnosis.run_state;
}

LinkState RigLink::state() const
{
  Heard heard;
  heard.shown = shown_;
  heard.master = master_ && ros::ok();
  heard.publisher = states_ && states_.getNumPublishers() > 0;
  heard.state_age = age();
  heard.diagnostics_age = seconds_since(diagnostics_heard_);
  heard.speed = news_.diagnosis.speed;
  heard.run_state = run_state();
  return link_state(heard);
}

bool RigLink::is_heard(const Outlet& outlet) const
{
  return rig_node_.empty() ? !outlet.hearers.empty() : outlet.hearers.count(rig_node_) > 0;
}

template <class Message>
bool RigLink::send(Outlet& outlet, const QString& what, const Message& message)
{
  const LinkState now = state();
  if (!outlet.publisher || (now != LinkState::hidden && !hears(now)))
  {
    Q_EMIT said(what, false, "not sent: no simulator at " + used_namespace());
    return false;
  }
  if (!is_heard(outlet))
  {
    Q_EMIT said(what, false, "not sent: the simulator does not listen to it yet");
    return false;
  }
  outlet.publisher.publish(message);
  return true;
}

bool RigLink::is_free(const QString& what)
{
  if (!busy_.isEmpty()) Q_EMIT said(what, false, "not sent: " + busy_);
  return busy_.isEmpty();
}

bool RigLink::command(const WinchCommand& command)
{
  const bool sent = send(winch_, "winch", command);
  if (sent) Q_EMIT winch_commanded();
  return sent;
}
bool RigLink::command(const TopDriveCommand& command)
{
  return is_free("top drive") && send(top_drive_, "top drive", command);
}
bool RigLink::command(const MudPumpCommand& command)
{
  return is_free("mud pump") && send(pump_, "mud pump", command);
}
bool RigLink::command(const SteeringCommand& command)
{
  return send(steering_, "steering", command);
}

void RigLink::ask_states()
{
  if (hears(state())) call(list_states, ListStates(), 2.0);
}

bool RigLink::can_call(const QString& name)
{
  if (hears(state())) return true;
  Q_EMIT said(name, false, "not sent: no simulator at " + used_namespace());
  return false;
}

}  // namespace drill_rig_sim::console

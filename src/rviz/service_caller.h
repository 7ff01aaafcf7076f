// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_SERVICE_CALLER_H
#define DRILL_RIG_SIM_RVIZ_SERVICE_CALLER_H

#include <ros/ros.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "drill_rig_sim/ListStates.h"

class QTimer;

namespace drill_rig_sim::console
{
/// What the answer of a service says: its message; of list_states the names, a line each.
template <class Response>
QString text_of(const Response& response)
{
  return QString::fromStdString(response.message);
}
inline QString text_of(const ListStatesResponse& response)
{
  QStringList names;
  for (const std::string& name : response.names) names << QString::fromStdString(name);
  return names.join('\n');
}

/// Calls services in a thread of its own, one after the other: a window must not wait for an answer.
class ServiceCaller : public QObject
{
  Q_OBJECT
public:
  explicit ServiceCaller(QObject* parent = nullptr);
  /// A call under way is cut off.
  ~ServiceCaller() override;

  /// Calls the service `topic` (its full name), whose answer comes as `answered` by the name `what`; after `patience` [s] without
  /// one the call is cut off and this is reported. Services that answer `success` and `message`.
  template <class Service>
  void call(const std::string& topic, const QString& what, const Service& service, double patience)
  {
    add({what, patience,
         [this, topic, service = Service(service)]() mutable -> Answer
         {
           // persistent: only such a call can be cut off
           ros::ServiceClient client = ros::NodeHandle().serviceClient<Service>(topic, true);
           if (!client.isValid()) return {false, "no service " + QString::fromStdString(topic)};
           if (!hold(client)) return {false, "given up"};
           const bool came = client.call(service);
           release();
           if (!came) return {false, "no answer: the connection broke"};
           return {service.response.success != 0, text_of(service.response)};
         }});
  }
  /// How many calls have no answer yet.
  int pending() const;

Q_SIGNALS:
  /// In the thread of this object.
  void answered(const QString& what, bool success, const QString& text);

private:
  struct Answer
  {
    bool success;
    QString text;
  };
  struct Job
  {
    QString what;
    double patience;
    std::function<Answer()> run;
  };
  using Clock = std::chrono::steady_clock;

  void add(Job job);
  void work();
  bool hold(const ros::ServiceClient& client);
  void release();
  void cut_off_the_late();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> jobs_;
  bool ends_ = false, works_ = false, cut_ = false;
  Clock::time_point deadline_;
  ros::ServiceClient current_;  // of the call under way
  QTimer* timer_;
  std::thread thread_;
};

}  // namespace drill_rig_sim::console

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "service_caller.h"

#include <QTimer>

namespace drill_rig_sim::console
{
ServiceCaller::ServiceCaller(QObject* parent) : QObject(parent), timer_(new QTimer(this)), thread_([this] { work(); })
{
  connect(timer_, &QTimer::timeout, this, &ServiceCaller::cut_off_the_late);
  timer_->start(200);
}

ServiceCaller::~ServiceCaller()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
    jobs_.clear();
    current_.shutdown();
  }
  changed_.notify_all();
  thread_.join();
}

int ServiceCaller::pending() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return static_cast<int>(jobs_.size()) + (works_ ? 1 : 0);
}

void ServiceCaller::add(Job job)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  changed_.notify_all();
}

void ServiceCaller::work()
{
  std::unique_lock<std::mutex> lock(mutex_);
  while (true)
  {
    changed_.wait(lock, [this] { return ends_ || !jobs_.empty(); });
    if (ends_) return;
    Job job = std::move(jobs_.front());
    jobs_.pop_front();
    works_ = true;
    cut_ = false;
    deadline_ = Clock::now() + std::chrono::milliseconds(static_cast<long>(1e3 * job.patience));
    lock.unlock();
    Answer answer = job.run();
    lock.lock();
    works_ = false;
    if (ends_) return;
    if (cut_) answer = {false, QStringLiteral("no answer within %1 s").arg(job.patience)};
    lock.unlock();
    Q_EMIT answered(job.what, answer.success, answer.text);
    lock.lock();
  }
}

bool ServiceCaller::hold(const ros::ServiceClient& client)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (ends_) return false;
  current_ = client;
  return true;
}

void ServiceCaller::release()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  current_ = ros::ServiceClient();
}

void ServiceCaller::cut_off_the_late()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!works_ || cut_ || Clock::now() < deadline_) return;
  cut_ = true;
  current_.shutdown();
}

}  // namespace drill_rig_sim::console

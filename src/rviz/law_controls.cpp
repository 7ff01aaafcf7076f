// SPDX-License-Identifier: BSD-3-Clause
#include "law_controls.h"

#include <QGridLayout>
#include <QJsonDocument>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "console/law_points.h"
#include "look.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr int between_words = 1000;  // between messages of the console to the law's process, at most 3 s [ms]
constexpr int patience = 3000;       // for the process to end [ms]

constexpr std::size_t to_depth = 6;

/// To where the block can go without a connection [m].
double depth_ahead(const News& news)
{
  const double lowest = news.limits ? news.limits->lowest_block_height : 1.0;
  return news.state->hole_depth + std::max(news.state->block_height - lowest - 1.0, 0.0);
}

double in_force(const ControllerStatus& status, const char* name, double otherwise)
{
  for (std::size_t n = 0; n < std::min(status.set_point.size(), status.value.size()); ++n)
    if (status.set_point[n] == name) return status.value[n];
  return otherwise;
}
}  // namespace

LawControls::LawControls(RigLink& link, QWidget* parent)
    : Controls("Autodriller", link, parent),
      start_(make_button("Start", "autodriller start", this)),
      apply_(make_button("Apply", "autodriller apply", this)),
      stop_(make_button("Stop", "autodriller stop", this)),
      connection_(make_button("Make connection", "autodriller connection", this)),
      status_(make_reading("autodriller status", this)),
      alive_(new QTimer(this))
{
  for (std::size_t n = 0; n < sizeof law_points / sizeof law_points[0]; ++n)
  {
    const LawPoint& point = law_points[n];
    const double least = point.optional ? 0.0 : point.least;  // 0: no limit
    UnitBox* box = add_set_point(QString("autodriller ") + point.name, point.dimension, least, point.most, point.first);
    if (point.optional) box->setSpecialValueText("no limit");
    boxes_.push_back(box);
    const int row = static_cast<int>(n);
    QString label = point.label;
    label[0] = label[0].toUpper();
    if (point.dimension == Dimension::penetration) label += " at most";
    grid().addWidget(add_label(label), row, 0);
    grid().addWidget(box, row, 1);
  }
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {start_, apply_, stop_}) buttons->addWidget(button);
  const int below = static_cast<int>(boxes_.size());
  grid().addLayout(buttons, below, 0, 1, 2);
  grid().addWidget(connection_, below + 1, 0, 1, 2);
  grid().addWidget(status_, below + 2, 0, 1, 2);
  grid().setColumnStretch(1, 1);
  start_->setToolTip(
      "Zeroes weight and pressure off bottom, goes to bottom and drills. The limit that is reached first leads. A command to the "
      "winch takes over.");
  connection_->setToolTip(
      "Picks up off bottom, stops rotary and pump, sets the slips, adds a stand and pulls the slips. A command to the winch "
      "takes "
      "over.");
  connect(start_, &QPushButton::clicked, this, &LawControls::start);
  connect(connection_, &QPushButton::clicked, this, &LawControls::connect_pipe);
  connect(apply_, &QPushButton::clicked, this, &LawControls::apply);
  connect(stop_, &QPushButton::clicked, this, &LawControls::stop);
  connect(alive_, &QTimer::timeout, this, [this] { write({{"type", "alive"}}); });
  connect(&link, &RigLink::changed, this, &LawControls::end);
  connect(&link, &RigLink::winch_commanded, this, &LawControls::take_block);
}

LawControls::~LawControls()
{
  end();
}

void LawControls::end()
{
  if (process_ == nullptr) return;
  process_->disconnect(this);
  process_->closeWriteChannel();
  if (!process_->waitForFinished(patience)) process_->kill();
  process_->deleteLater();
  process_ = nullptr;
  process_ended();
}

void LawControls::begin_process()
{
  if (process_ != nullptr) return;
  process_ = new QProcess(this);
  connect(process_, &QProcess::readyReadStandardOutput, this, &LawControls::read);
  connect(process_, &QProcess::errorOccurred, this,
          [this](QProcess::ProcessError error)
          {
            if (error == QProcess::FailedToStart) Q_EMIT link().said("autodriller", false, "python3 could not be started");
          });
  connect(process_, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished), this,
          [this]
          {
            const QString last = QString::fromUtf8(process_->readAllStandardError()).trimmed().section('\n', -1);
            Q_EMIT link().said("autodriller", false, last.isEmpty() ? QString("its process has ended") : last);
            process_->deleteLater();
            process_ = nullptr;
            process_ended();
          });
  process_->start("python3", {"-m", "drill_rig_sim.web.law_process", link().used_namespace()});
  alive_->start(between_words);
}

void LawControls::process_ended()
{
  alive_->stop();
  law_ = {};
  link().set_busy({});
}

void LawControls::write(const QJsonObject& order)
{
  if (process_ != nullptr) process_->write(QJsonDocument(order).toJson(QJsonDocument::Compact) + '\n');
}

void LawControls::order(const char* type)
{
  QJsonObject order{{"type", type}};
  for (std::size_t n = 0; n < boxes_.size(); ++n)
  {
    const double value = boxes_[n]->si();
    const bool is_none = value == 0.0 && !boxes_[n]->specialValueText().isEmpty();
    if (!is_none)
      order.insert(law_points[n].order, value);
    else
      order.insert(law_points[n].order, QJsonValue());
  }
  write(order);
  settle();
}

void LawControls::start()
{
  begin_process();
  order("start_law");
}

void LawControls::connect_pipe()
{
  begin_process();
  write({{"type", "connect"}});
}

void LawControls::apply()
{
  if (runs()) order("set_law");
}

void LawControls::stop()
{
  write({{"type", "stop_law"}});
}

void LawControls::take_block()
{
  if (runs()) write({{"type", "leave_block"}});
}

void LawControls::read()
{
  while (process_->canReadLine())
  {
    const QJsonObject message = QJsonDocument::fromJson(process_->readLine()).object();
    if (message.value("type") == "answer")
    {
      Q_EMIT link().said("autodriller", false, message.value("text").toString());
      continue;
    }
    if (message.value("type") != "law") continue;
    const QString problem = message.value("problem").toString();
    if (!problem.isEmpty() && problem != law_.value("problem").toString()) Q_EMIT link().said("autodriller", false, problem);
    law_ = message;
    link().set_busy(connects() ? "a connection is being made: stop it first"
                    : runs()   ? "the autodriller has it: use the boxes of the autodriller, or stop it"
                               : "");
  }
}

void LawControls::show_news(const News& news)
{
  const ControllerStatus* status = news.controller && news.controller->running ? news.controller.get() : nullptr;
  start_->setEnabled(!runs() && status == nullptr);
  connection_->setEnabled(start_->isEnabled());
  apply_->setEnabled(runs() && !connects());
  stop_->setEnabled(process_ != nullptr);  // also while the law is about to start
  // the law's last phase until its process says that it has stopped: before, Start is not enabled
  QString text = law_.value(runs() ? "phase" : "problem").toString();
  if (process_ != nullptr && law_.isEmpty()) text = "starting";
  if (status != nullptr)
  {
    text = connects() ? QString("connection: ")
           : runs()   ? QString()
                      : QString::fromStdString(status->law).replace('_', ' ') + ", not of this console: ";
    text += QString::fromStdString(status->phase);
    if (const LawPoint* leader = law_point(status->leads)) text += QStringLiteral(", %1 leads").arg(leader->label);
    if (const int stalls = law_.value("stalls").toInt(); runs() && stalls > 0)
      text += QStringLiteral(", %1 %2").arg(stalls).arg(stalls == 1 ? "stall" : "stalls");
  }
  tell(status_, text.isEmpty() ? QString("stopped") : text);
  if (!follows()) return;
  const bool is_own = status != nullptr && runs() && !connects();
  if (is_own)
    for (std::size_t n = 0; n < boxes_.size(); ++n) boxes_[n]->follow(in_force(*status, law_points[n].name, 0.0));
  else if (news.state && !runs())
    boxes_[to_depth]->follow(depth_ahead(news));
}

}  // namespace drill_rig_sim::console

// SPDX-License-Identifier: BSD-3-Clause
#include "console_test.h"

#include <ros/package.h>

#include <QApplication>
#include <QFileInfo>
#include <QLineEdit>
#include <QSpinBox>
#include <csignal>
#include <cstdlib>
#include <pluginlib/class_loader.hpp>
#include <tuple>

#include "drill_rig_sim/SetSpeed.h"

namespace console_test
{
namespace
{
std::unique_ptr<RigProcess> the_rig;

QString environment(const char* name, const QString& otherwise)
{
  const char* const value = std::getenv(name);
  return value != nullptr ? value : otherwise;
}

using Loader = pluginlib::ClassLoader<rviz::Panel>;
std::unique_ptr<Loader> the_loader;  // of main: it must go before the library of loaders does
}  // namespace

RigProcess::RigProcess(const std::string& name, const QStringList& more)
{
  const QString scene = QString::fromStdString(ros::package::getPath("drill_rig_sim")) + "/test/scenes/console.yaml";
  QStringList arguments{"__ns:=" + QString::fromStdString(name)};
  if (more.filter("_scene:=").isEmpty()) arguments << "_scene:=" + environment("CONSOLE_SCENE", scene);
  process_.setProcessChannelMode(QProcess::ForwardedChannels);
  process_.start(environment("RIG_SIMULATOR", "rig_simulator"), arguments + more);
  if (!process_.waitForStarted()) throw std::runtime_error("rig_simulator does not start: set RIG_SIMULATOR to its path");
}

RigProcess::~RigProcess()
{
  end(SIGINT);
}

void RigProcess::end(int signal)
{
  if (!runs()) return;
  ::kill(static_cast<pid_t>(process_.processId()), signal);
  if (!process_.waitForFinished(10000)) process_.kill();
  process_.waitForFinished();
}

bool RigProcess::runs() const
{
  return process_.state() != QProcess::NotRunning;
}

RigProcess& shared_rig()
{
  if (!the_rig || !the_rig->runs()) the_rig = std::make_unique<RigProcess>(shared_name);
  return *the_rig;
}

void end_shared_rig()
{
  the_rig.reset();
}

void set_speed(const std::string& rig, double factor)
{
  drill_rig_sim::SetSpeed call;
  call.request.speed = factor;
  if (!ros::service::call("/" + rig + "/set_speed", call) || !call.response.success)
    throw std::runtime_error("set_speed: " + call.response.message);
}

bool wait_until(const std::function<bool()>& condition, double seconds)
{
  QElapsedTimer since;
  since.start();
  while (!condition())
  {
    if (since.elapsed() > 1e3 * seconds) return false;
    QTest::qWait(20);
    ros::spinOnce();
  }
  return true;
}

void wait_for(double seconds)
{
  wait_until([] { return false; }, seconds);
}

QString out_folder()
{
  return QFileInfo(environment("ROS_HOME", "/tmp/x")).path();
}

Console::Console(const QString& rig, int width, int height)
    : window_(new QMainWindow), panel_(the_loader->createUnmanagedInstance("drill_rig_sim/DrillersConsole"))
{
  panel_->setClassId("drill_rig_sim/DrillersConsole");
  panel_->setName("DrillersConsole");
  panel_->initialize(nullptr);  // the console needs nothing of rviz
  rviz::Config config;
  config.mapSetValue("Namespace", rig);
  panel_->load(config);
  window_->setCentralWidget(panel_);
  window_->resize(width, height);
  window_->show();
  window_->activateWindow();
  QTest::qWait(50);
}

Console::~Console()
{
  close();
}

void Console::close()
{
  if (!window_) return;
  window_->close();
  window_.reset();
}

void Console::open_page_of(const QString& name)
{
  QWidget* widget = get(name);
  for (int n = 0; n < tabs()->count(); ++n)
    if (tabs()->widget(n)->isAncestorOf(widget)) tabs()->setCurrentIndex(n);
}

void Console::click(const QString& name)
{
  open_page_of(name);
  QWidget* widget = get(name);
  wait_until([&] { return widget->isEnabled(); });
  QTest::mouseClick(widget, Qt::LeftButton);
}

void Console::click_and_agree(const QString& name, const QString& question)
{
  click(name);
  QWidget* yes = get(question + " yes");
  wait_until([&] { return yes->isVisible(); });
  QTest::mouseClick(yes, Qt::LeftButton);
}

void Console::type(const QString& name, const QString& text)
{
  open_page_of(name);
  auto* box = get<QAbstractSpinBox>(name);
  box->setFocus();
  box->selectAll();
  QTest::keyClick(box, Qt::Key_Delete);
  QTest::keyClicks(box, text);
  QTest::keyClick(box, Qt::Key_Return);
}

void Console::choose(const QString& name, const QString& text)
{
  open_page_of(name);
  auto* box = get<QComboBox>(name);
  const int n = box->findText(text);
  if (n < 0) throw std::runtime_error(name.toStdString() + " has no " + text.toStdString());
  // by the keys, as the popup of a combo box is a window of its own
  box->setFocus();
  while (box->currentIndex() < n) QTest::keyClick(box, Qt::Key_Down);
  while (box->currentIndex() > n) QTest::keyClick(box, Qt::Key_Up);
}

void Console::forget_answer()
{
  get<QLabel>("answer")->setText("");
}

::testing::AssertionResult Console::answers(const QString& beginning)
{
  if (wait_until([&] { return get<QLabel>("answer")->text().startsWith(beginning); })) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "the answer shown is \"" << get<QLabel>("answer")->text().toStdString()
                                       << "\", expected \"" << beginning.toStdString() << "...\"";
}

::testing::AssertionResult Console::is_in_state(const QString& state)
{
  if (wait_until([&] { return get<QLabel>("simulator state")->text().startsWith(state); })) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "the simulator is shown as " << get<QLabel>("simulator state")->text().toStdString()
                                       << ", expected " << state.toStdString();
}

::testing::AssertionResult Console::asks(const QString& button, const QString& beginning)
{
  forget_answer();
  click(button);
  return answers(beginning);
}

::testing::AssertionResult Console::is_heard()
{
  for (const char* const button : {"winch release brake", "top drive stop", "mud pump stop", "steering apply"})
  {
    const auto is_sent = [&]
    {
      forget_answer();
      click(button);
      return get<QLabel>("answer")->text().isEmpty();
    };
    if (!wait_until(is_sent)) return ::testing::AssertionFailure() << get<QLabel>("answer")->text().toStdString();
  }
  wait_for(0.3);  // until what was sent has come everywhere
  return ::testing::AssertionSuccess();
}

void Console::look(const QString& name)
{
  const QSize size = window_->size();
  QWidget* const page = tabs()->currentWidget();
  const QString chosen = get<QComboBox>("settings units")->currentText();
  for (const char* const units : {"oilfield", "SI"})
  {
    choose("settings units", units);
    for (const auto& [screen, width, height] : {std::tuple("1280x800", 420, 690), std::tuple("1920x1080", 900, 970)})
    {
      open_page_of("event log");
      for (int n = 0; n < 2; ++n)  // the first is as narrow as gauges and pages side by side can be
      {
        window_->resize(width, height);
        wait_for(0.2);
      }
      const QString file = QStringLiteral("%1/console_%2_%3_%4").arg(out_folder(), name, screen, units);
      window_->grab().save(file + ".png");
      if (width > 500) continue;  // the gauges are beside the events
      open_page(0);
      wait_for(0.4);
      window_->grab().save(file + "_gauges.png");
    }
  }
  choose("settings units", chosen);
  window_->resize(size);
  tabs()->setCurrentWidget(page);
  wait_for(0.3);
}

rviz::Config Console::config() const
{
  rviz::Config config;
  panel_->save(config);
  return config;
}

}  // namespace console_test

int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_console", ros::init_options::AnonymousName | ros::init_options::NoSigintHandler);
  ros::NodeHandle node;
  QApplication application(argc, argv);
  console_test::the_loader = std::make_unique<console_test::Loader>("rviz", "rviz::Panel");
  const int result = RUN_ALL_TESTS();
  console_test::the_rig.reset();
  console_test::the_loader.reset();
  return result;
}

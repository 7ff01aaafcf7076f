// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_RVIZ_CONSOLE_TEST_H
#define DRILL_RIG_SIM_TEST_RVIZ_CONSOLE_TEST_H

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rviz/panel.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QMainWindow>
#include <QProcess>
#include <QTabWidget>
#include <QtTest>
#include <functional>
#include <memory>
#include <string>

namespace console_test
{
constexpr double patience = 60.0;  // wall seconds that anything may take on a loaded machine

/// A rig_simulator in a namespace of its own, with test/scenes/console.yaml unless told otherwise.
class RigProcess
{
public:
  explicit RigProcess(const std::string& name, const QStringList& more = {});
  ~RigProcess();
  /// Ends it by a signal and waits.
  void end(int signal);
  bool runs() const;

private:
  mutable QProcess process_;
};

/// The rig that most tests share; begun when it is first asked for.
RigProcess& shared_rig();
/// Ends it, so that a rig of a picture is the only node that publishes /clock.
void end_shared_rig();
constexpr const char* shared_name = "console_rig";

/// Simulated seconds per second of the wall, for what takes long.
void set_speed(const std::string& rig, double factor);

/// Handles events of Qt until the condition is true.
bool wait_until(const std::function<bool()>& condition, double seconds = patience);
/// Handles events of Qt for so long.
void wait_for(double seconds);
/// Where pictures and files of the tests go: the folder of ROS_HOME.
QString out_folder();

/// The panel, loaded as rviz loads it, in a window.
class Console
{
public:
  /// `rig`: its namespace; the window's size in pixels.
  explicit Console(const QString& rig = shared_name, int width = 420, int height = 692);
  ~Console();

  rviz::Panel* panel() const { return panel_; }
  QMainWindow& window() { return *window_; }
  /// The widget of an accessible name; fails the test and ends it where there is none.
  template <class Widget = QWidget>
  Widget* get(const QString& name) const
  {
    for (Widget* widget : panel_->findChildren<Widget*>())
      if (widget->accessibleName() == name) return widget;
    throw std::runtime_error("no widget is called " + name.toStdString());
  }
  /// What a reading widget shows.
  QString shows(const QString& name) const { return get(name)->accessibleDescription(); }
  /// Clicks a button of any page as a user does: its page is opened first.
  void click(const QString& name);
  /// Types a number into a spin box, then Enter; a set point is applied by that.
  void type(const QString& name, const QString& text);
  void choose(const QString& name, const QString& text);
  /// Clicks a button that asks first, and agrees: `question` is the dialog's name.
  void click_and_agree(const QString& name, const QString& question);
  /// Opens the page with this widget.
  void open_page_of(const QString& name);
  void open_page(int index) { tabs()->setCurrentIndex(index); }
  QTabWidget* tabs() const { return get<QTabWidget>("pages"); }
  /// The answer shown begins so, within a minute.
  ::testing::AssertionResult answers(const QString& beginning);
  ::testing::AssertionResult is_in_state(const QString& state);
  /// The simulator is connected to all topics of commands: it was not a moment ago, after the panel was opened.
  ::testing::AssertionResult is_heard();
  /// Clicks a button that calls a service, and waits for the answer.
  ::testing::AssertionResult asks(const QString& button, const QString& beginning);
  /// Pictures to look at, console_NAME_SCREEN_UNITS.png: as a dock of a small and a large screen, in both systems of units, the
  /// gauges and the events. Ends with the page, size and units of before.
  void look(const QString& name);
  /// The panel's config, as rviz would keep it.
  rviz::Config config() const;
  void forget_answer();
  /// Closes the window, and deletes the panel.
  void close();

private:
  std::unique_ptr<QMainWindow> window_;
  rviz::Panel* panel_;
};

/// A subscriber that keeps the messages of a topic of a rig.
template <class Message>
class Listener
{
public:
  explicit Listener(const std::string& topic, const std::string& rig = shared_name)
      : subscriber_(ros::NodeHandle("/" + rig).subscribe(topic, 1000, &Listener::take, this))
  {
  }
  const std::vector<typename Message::ConstPtr>& all()
  {
    ros::spinOnce();
    return messages_;
  }
  bool connected() const { return subscriber_.getNumPublishers() > 0; }
  void clear() { messages_.clear(); }

private:
  void take(const typename Message::ConstPtr& m) { messages_.push_back(m); }

  ros::Subscriber subscriber_;
  std::vector<typename Message::ConstPtr> messages_;
};

}  // namespace console_test

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_DEAD_MAN_H
#define DRILL_RIG_SIM_RVIZ_DEAD_MAN_H

#include <QWidget>

class QPushButton;
class QTimer;

namespace drill_rig_sim::console
{
/// Two buttons that act as long as they are held, by the mouse, the space bar, or the arrows up and down: `hold` comes ten times
/// a second, and `hold(0)` once when the button is let go, when the focus or the window is lost, and when they are hidden or
/// closed.
class DeadMan : public QWidget
{
  Q_OBJECT
public:
  explicit DeadMan(QWidget* parent);
  bool is_held() const { return direction_ != 0; }

public Q_SLOTS:
  /// As if the button were let go.
  void let_go();

Q_SIGNALS:
  /// +1: up, -1: down, 0: let go.
  void hold(int direction);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  QPushButton* make(const QString& text, const QString& name, int direction);
  void begin(int direction);
  bool take_key(QEvent* event);

  QPushButton *up_, *down_;
  QTimer* timer_;
  QWidget* window_ = nullptr;
  int direction_ = 0;
};

}  // namespace drill_rig_sim::console

#endif

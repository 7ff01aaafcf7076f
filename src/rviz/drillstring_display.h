// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_DRILLSTRING_DISPLAY_H
#define DRILL_RIG_SIM_SRC_RVIZ_DRILLSTRING_DISPLAY_H

#include <OgreRay.h>
#include <nav_msgs/Path.h>
#include <ros/subscriber.h>
#include <ros/time.h>
#include <rviz/display.h>

#include <memory>
#include <optional>

#include "drill_rig_sim/ControllerStatus.h"
#include "drill_rig_sim/DrillstringState.h"
#include "drill_rig_sim/RigDescription.h"
#include "drill_rig_sim/RigTruth.h"
#include "drawn_rig.h"
#include "drillstring_options.h"
#include "own_work.h"
#include "picture/pick.h"

namespace rviz
{
class BoolProperty;
class EnumProperty;
class RosTopicProperty;
}  // namespace rviz

namespace drill_rig_sim
{
class DerrickScene;
class DrillstringProperties;
class OverlayPanel;
class RulerScene;
class StringScene;
class WellScene;

/// The drillstring in its well. Hears drillstring_state and, beside it in the same namespace, rig_description, trajectory,
/// truth/rig_state and controller/status, only while it is enabled; how bit, blades and block stand it takes from TF. A message
/// that cannot be drawn is refused, and the status says why.
class DrillstringDisplay : public rviz::Display
{
  Q_OBJECT
public:
  DrillstringDisplay();
  ~DrillstringDisplay() override;

  void setTopic(const QString& topic, const QString& datatype) override;
  void update(float wall_dt, float ros_dt) override;
  void reset() override;
  /// Shows the numbers of the place on the string that a ray of the fixed frame meets, or is at most `slope` times its distance
  /// from: until another is picked. Where there is none, shows none and returns false.
  bool probe(const Ogre::Ray& ray, double slope);

protected:
  void onInitialize() override;
  void onEnable() override;
  void onDisable() override;
  void fixedFrameChanged() override { reset(); }

private Q_SLOTS:
  void changeTopic();
  void changeOptions();
  void changeCamera();

private:
  void subscribe();
  void unsubscribe();
  void hear(const DrillstringState::ConstPtr& m);
  void hear_description(const RigDescription::ConstPtr& m);
  void hear_controller(const ControllerStatus::ConstPtr& m);
  void hear_truth(const RigTruth::ConstPtr& m);
  void hear_path(const nav_msgs::Path::ConstPtr& m);
  bool place_floor();
  void draw();
  void turn_parts();
  void tell_status();
  void show_legend();
  void follow_units();
  void show_probe();
  void apply_camera();
  void resolve_exaggeration();
  void keep_legend_off_bit(const Ogre::Camera& camera, double width, double height);
  void choose_detail(const Ogre::Camera& camera);
  void clear();

  std::unique_ptr<DrillstringProperties> properties_;
  ros::Subscriber string_, description_, path_, truth_, controller_;
  DrawnRig model_;
  DrillstringOptions options_;
  std::unique_ptr<StringScene> string_scene_;
  std::unique_ptr<WellScene> well_scene_;
  std::unique_ptr<RulerScene> ruler_scene_;
  std::unique_ptr<DerrickScene> derrick_scene_;
  std::unique_ptr<OverlayPanel> legend_, probe_panel_;
  std::optional<Between> probed_;
  OwnCost cost_;
  ros::WallTime heard_, told_, ruled_;  // when a string came, statuses were set and the ruler drawn last
  bool string_due_ = false, well_due_ = false, camera_due_ = false, floor_placed_ = false;
};

}  // namespace drill_rig_sim

#endif

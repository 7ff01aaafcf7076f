// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_DRILLSTRING_PROPERTIES_H
#define DRILL_RIG_SIM_SRC_RVIZ_DRILLSTRING_PROPERTIES_H

#include <optional>
#include <string>

#include "drillstring_options.h"
#include "picture/camera_preset.h"

class QObject;
namespace rviz
{
class BoolProperty;
class EnumProperty;
class FloatProperty;
class IntProperty;
class Property;
class RosTopicProperty;
}  // namespace rviz

namespace drill_rig_sim
{
/// The display's list of properties. They belong to their parent, which deletes them.
class DrillstringProperties
{
public:
  /// Below `parent`, whose slots changeTopic(), changeOptions() and changeCamera() are called when one of theirs has changed.
  DrillstringProperties(rviz::Property* parent, QObject* receiver);

  DrillstringOptions options() const;
  std::string topic() const;
  void set_topic(const std::string& topic);
  /// Of the property, or of the console.
  UnitSystem units() const;
  /// The camera asked for; none: as it is.
  std::optional<Preset> preset() const;
  bool follow() const;

private:
  void add_looks(rviz::Property* parent, QObject* receiver);
  void add_switches(rviz::Property* parent, QObject* receiver);

  rviz::RosTopicProperty* topic_;
  rviz::EnumProperty *coloring_, *units_, *camera_, *wall_;
  rviz::FloatProperty *full_scale_, *exaggeration_, *force_scale_, *cased_to_;
  rviz::IntProperty* sides_;
  rviz::BoolProperty *true_diameter_, *follow_, *string_, *blades_, *layers_, *forces_, *plan_, *stations_, *trail_, *ruler_,
      *parts_, *derrick_, *legend_, *faults_;
};

}  // namespace drill_rig_sim

#endif

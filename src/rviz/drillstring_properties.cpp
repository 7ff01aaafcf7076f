// SPDX-License-Identifier: BSD-3-Clause
#include "drillstring_properties.h"

#include <ros/message_traits.h>
#include <rviz/properties/bool_property.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/int_property.h>
#include <rviz/properties/ros_topic_property.h>

#include "drill_rig_sim/DrillstringState.h"
#include "picture/coloring.h"
#include "shared_units.h"

namespace drill_rig_sim
{
namespace
{
const char* const options_changed = SLOT(changeOptions());
constexpr int as_the_console = -1;  // of the property Units

rviz::FloatProperty* number(const char* name, double value, double least, double most, const char* text, rviz::Property* parent,
                            QObject* receiver)
{
  auto* property = new rviz::FloatProperty(name, static_cast<float>(value), text, parent, options_changed, receiver);
  property->setMin(static_cast<float>(least));
  property->setMax(static_cast<float>(most));
  return property;
}
}  // namespace

DrillstringProperties::DrillstringProperties(rviz::Property* parent, QObject* receiver)
{
  topic_ = new rviz::RosTopicProperty("Topic", "rig/drillstring_state",
                                      QString::fromStdString(ros::message_traits::datatype<DrillstringState>()),
                                      "drillstring_state of a rig; its rig_description and trajectory are subscribed to as well.",
                                      parent, SLOT(changeTopic()), receiver);
  add_looks(parent, receiver);
  camera_ = new rviz::EnumProperty("Camera", "as it is", "Puts the camera there once, when it is chosen.", parent,
                                   SLOT(changeCamera()), receiver);
  int i = 0;
  for (const char* name : {"as it is", "derrick", "along the hole", "bit", "plan", "section"}) camera_->addOption(name, i++);
  follow_ = new rviz::BoolProperty("Follow the bit", false, "The camera moves along with the bit.", parent, SLOT(changeCamera()),
                                   receiver);
  add_switches(parent, receiver);
}

void DrillstringProperties::add_looks(rviz::Property* parent, QObject* receiver)
{
  const DrillstringOptions by_default;
  coloring_ = new rviz::EnumProperty("Coloured by", colorings()[by_default.coloring].name, "What colours the string.", parent,
                                     options_changed, receiver);
  for (std::size_t i = 0; i < colorings().size(); ++i) coloring_->addOption(colorings()[i].name, static_cast<int>(i));
  units_ = new rviz::EnumProperty("Units", "as the console",
                                  "Of legend, ruler and probe; \"as the console\": those of the driller's console.", parent,
                                  options_changed, receiver);
  units_->addOption("as the console", as_the_console);
  units_->addOption("SI", static_cast<int>(UnitSystem::si));
  units_->addOption("oilfield", static_cast<int>(UnitSystem::oilfield));
  full_scale_ = number("Full scale", by_default.full_scale, 0.0, 1e9, "Of the colours, in the legend's unit; 0: automatic.",
                       parent, receiver);
  exaggeration_ =
      number("Lateral exaggeration", by_default.exaggeration, 0.0, 1000.0,
             "Distances across the hole are drawn larger by this factor; 0: as suits the camera chosen last.", parent, receiver);
  true_diameter_ = new rviz::BoolProperty("True diameter", by_default.true_diameter,
                                          "The string's own diameter is not exaggerated.", parent, options_changed, receiver);
  sides_ = new rviz::IntProperty("Sides", by_default.sides, "Faces of the string's tube: fewer are drawn faster.", parent,
                                 options_changed, receiver);
  sides_->setMin(3);
  sides_->setMax(48);
  force_scale_ = number("Force scale", by_default.force_scale, 0.0, 1e6,
                        "Length of contact forces' arrows [m per kN/m]; 0: automatic.", parent, receiver);
  cased_to_ =
      number("Cased to", by_default.cased_to, -1.0, 20000.0,
             "Measured depth of the casing shoe [m]; -1: all hole sections but the last are cased, which a scene does not say.",
             parent, receiver);
  wall_ = new rviz::EnumProperty("Wellbore", "cut open", "The hole's wall.", parent, options_changed, receiver);
  wall_->addOption("cut open", static_cast<int>(WallStyle::cut_open));
  wall_->addOption("whole", static_cast<int>(WallStyle::whole));
  wall_->addOption("none", static_cast<int>(WallStyle::none));
}

void DrillstringProperties::add_switches(rviz::Property* parent, QObject* receiver)
{
  auto* show = new rviz::Property("Show", QVariant(), "What is drawn.", parent);
  const auto add = [&](const char* name, const char* text)
  { return new rviz::BoolProperty(name, true, text, show, options_changed, receiver); };
  string_ = add("String", "Tubes and tool joints.");
  blades_ = add("Bit and blades", "They turn as the string does.");
  layers_ = add("Formation", "Layers of rock as bands of a plane through the well.");
  forces_ = add("Contact forces", "Of the wall on the string, as arrows from the rock.");
  plan_ = add("Paths", "Drilled (yellow) and planned (blue, dashed), and the way between them at the bottom.");
  stations_ = add("Survey stations", "Of the scene's survey, as rings.");
  trail_ =
      add("Bit's trail",
          "Where the bit was since the display was switched on, as it moved; the drilled path is that after the correction.");
  ruler_ = add("Ruler", "Measured depth along the hole, casing shoe, layers.");
  parts_ = add("Part names", "Where the picture is large enough.");
  faults_ = add("Faults", "Where they are: stuck pipe, pack-off, wash-outs and others with a depth; the legend lists all.");
  derrick_ = add("Derrick", "With block, lines and top drive.");
  legend_ = add("Legend", "Colours, units, depths.");
}

DrillstringOptions DrillstringProperties::options() const
{
  DrillstringOptions o;
  o.coloring = static_cast<std::size_t>(std::max(coloring_->getOptionInt(), 0));
  o.full_scale = full_scale_->getFloat();
  o.exaggeration = exaggeration_->getFloat();
  o.true_diameter = true_diameter_->getBool();
  o.sides = sides_->getInt();
  o.force_scale = force_scale_->getFloat();
  o.cased_to = cased_to_->getFloat();
  o.wall = static_cast<WallStyle>(wall_->getOptionInt());
  o.string = string_->getBool();
  o.blades = blades_->getBool();
  o.layers = layers_->getBool();
  o.forces = forces_->getBool();
  o.plan = plan_->getBool();
  o.stations = stations_->getBool();
  o.trail = trail_->getBool();
  o.ruler = ruler_->getBool();
  o.parts = parts_->getBool();
  o.derrick = derrick_->getBool();
  o.legend = legend_->getBool();
  o.faults = faults_->getBool();
  o.units = units();
  return o;
}

UnitSystem DrillstringProperties::units() const
{
  const int chosen = units_->getOptionInt();
  return chosen == as_the_console ? console_units() : static_cast<UnitSystem>(chosen);
}

std::string DrillstringProperties::topic() const
{
  return topic_->getTopicStd();
}

void DrillstringProperties::set_topic(const std::string& topic)
{
  topic_->setString(QString::fromStdString(topic));
}

std::optional<Preset> DrillstringProperties::preset() const
{
  const int chosen = camera_->getOptionInt();
  if (chosen <= 0) return std::nullopt;
  return static_cast<Preset>(chosen - 1);
}

bool DrillstringProperties::follow() const
{
  return follow_->getBool();
}

}  // namespace drill_rig_sim

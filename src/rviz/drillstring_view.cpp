// SPDX-License-Identifier: BSD-3-Clause
// What the display reports: statuses, legend, the numbers of a place; and where it puts the camera.
#include <OgreCamera.h>
#include <OgreRay.h>
#include <OgreSceneNode.h>
#include <ros/console.h>
#include <rviz/display_context.h>
#include <rviz/properties/property.h>
#include <rviz/properties/tf_frame_property.h>
#include <rviz/properties/vector_property.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>

#include <algorithm>
#include <cmath>

#include "console/law_points.h"
#include "drillstring_display.h"
#include "drillstring_properties.h"
#include "label_set.h"
#include "legend.h"
#include "overlay_panel.h"
#include "picture/coloring.h"
#include "string_scene.h"
#include "well_scene.h"

namespace drill_rig_sim
{
namespace
{
using rviz::StatusProperty;

constexpr double coarse_pixel = 0.3;  // from this size of a pixel on little detail is drawn [m]
constexpr double old_age = 2.0;       // of the last message, from which on the status warns [s]

/// A number of SI with its unit, with as many decimals as are usual for it, or with `digits`.
QString shown(double si, Dimension dimension, UnitSystem units, int digits = -1)
{
  const Unit& unit = unit_of(dimension, units);
  return QString::number(si * unit.per_si, 'f', digits < 0 ? unit.decimals : digits) + " " + unit.name;
}

using Rows = std::vector<std::pair<QString, QString>>;

/// What a legend's colours mean, in a line.
QString in_words(const Legend& legend)
{
  if (legend.classes.empty())
    return QString("%1, %2 to %3").arg(legend.title).arg(legend.scale.low(), 0, 'g', 4).arg(legend.scale.high(), 0, 'g', 4);
  QStringList names;
  for (const auto& [name, color] : legend.classes) names << name;
  return legend.title + ": " + names.join(", ");
}

/// A table in a line.
QString in_words(const QString& title, const Rows& rows)
{
  QStringList words;
  for (const auto& [what, value] : rows) words << what + " " + value;
  return title + ": " + words.join(", ");
}

/// Name and phase of a law that commands the rig, and its set points; the one that leads is marked.
void add_law(const DrawnRig::Law& law, UnitSystem units, Rows& rows)
{
  rows.emplace_back(QString::fromStdString(law.name), QString::fromStdString(law.phase));
  for (const auto& [name, value] : law.set_points)
  {
    const console::LawPoint* point = console::law_point(name);
    if (point == nullptr) continue;
    rows.emplace_back(QString(name == law.leads ? "> " : "  ") + point->label, shown(value, point->dimension, units));
  }
}

double blend(const std::vector<double>& values, const Between& at)
{
  return values[at.node] + at.share * (values[at.node + 1] - values[at.node]);
}
}  // namespace

void DrillstringDisplay::tell_status()
{
  if (!isEnabled()) return;
  if (!model_.rig) setStatus(StatusProperty::Warn, "Rig", "no rig_description yet");
  if (!model_.axis) setStatus(StatusProperty::Warn, "Well", "no trajectory yet");
  if (heard_.isZero()) return;
  const double age = (ros::WallTime::now() - heard_).toSec();
  if (age > old_age)
    setStatus(StatusProperty::Warn, "String", QString("last message %1 s ago: the rig is paused, or gone").arg(age, 0, 'f', 0));
  else if (model_.string)
    setStatus(StatusProperty::Ok, "String", QString("%1 nodes").arg(model_.string->size()));
  if (!cost_.due()) return;
  const OwnShare share = cost_.share();
  if (share.frames == 0.0) return;
  setStatus(StatusProperty::Ok, "Own work", QString("%1 % of a processor core").arg(100.0 * share.processor, 0, 'f', 1));
  ROS_DEBUG("Drillstring: own work %.2f %% of a processor core, %.1f frames a second, %zu nodes", 100.0 * share.processor,
            share.frames, model_.string ? model_.string->size() : 0);
}

void DrillstringDisplay::show_legend()
{
  if (!model_.complete()) return legend_->hide();
  const Coloring& coloring = colorings()[options_.coloring];
  Legend legend;
  const UnitSystem units = options_.units;
  const QString unit = *coloring.remark ? coloring.remark : unit_of(coloring.dimension, units).name;
  legend.title = QString(coloring.name) + (unit.isEmpty() ? QString() : QString(" [%1]").arg(unit));
  legend.scale = string_scene_->scale(options_);
  if (coloring.levels) legend.classes = {{"free in all directions", level_color(0.0)}, {"guided by the hole", level_color(1.0)}};
  for (const DrawnRig::Fault& fault : model_.faults)
    legend.rows.emplace_back("! " + QString::fromStdString(fault.name),
                             std::isnan(fault.md) ? QString() : shown(fault.md, Dimension::length, units));
  legend.rows.emplace_back("bit", shown(model_.bit_md(), Dimension::length, units));
  legend.rows.emplace_back("hole", shown(model_.axis->depth(), Dimension::length, units));
  const PlanDistance& plan = well_scene_->plan_distance();
  if (plan.there) legend.rows.emplace_back("off the plan", shown(plan.distance, Dimension::length, units));
  legend.rows.emplace_back("across the hole", "x " + QString::number(options_.exaggeration, 'g', 4));
  if (options_.forces)
  {
    legend.rows.emplace_back("largest side force", shown(string_scene_->largest_force(), Dimension::force_per_length, units,
                                                         units == UnitSystem::si ? 2 : 4));
    if (string_scene_->largest_force() > 1.0)
    {
      const Unit &length = unit_of(Dimension::length, units), &force = unit_of(Dimension::force_per_length, units);
      legend.rows.emplace_back("its scale", QStringLiteral("%1 %2 per %3")
                                                .arg(string_scene_->force_scale() * length.per_si / force.per_si, 0, 'g', 3)
                                                .arg(length.name, force.name));
    }
  }
  if (model_.law) add_law(*model_.law, units, legend.rows);
  const double age = heard_.isZero() ? 0.0 : (ros::WallTime::now() - heard_).toSec();
  if (age > old_age) legend.rows.emplace_back("no message for", QString::number(age, 'f', 0) + " s");
  setStatus(StatusProperty::Ok, "Colours", in_words(legend));
  setStatus(StatusProperty::Ok, "Legend", in_words("below the colours", legend.rows));
  legend_->show(paint_legend(legend));
}

void DrillstringDisplay::follow_units()
{
  if (properties_->units() != options_.units) changeOptions();
}

bool DrillstringDisplay::probe(const Ogre::Ray& ray, double slope)
{
  probed_.reset();
  if (model_.complete())
  {
    const Ogre::Vector3 origin = scene_node_->convertWorldToLocalPosition(ray.getOrigin());
    const Ogre::Vector3 direction = scene_node_->convertWorldToLocalOrientation(Ogre::Quaternion::IDENTITY) * ray.getDirection();
    const double radius = model_.rig->parts.back().radius * (options_.true_diameter ? 1.0 : options_.exaggeration);
    const auto picked = pick(model_.nodes, radius, slope, {to_eigen(origin), to_eigen(direction).normalized()});
    if (picked) probed_ = picked->place;
  }
  show_probe();
  return probed_.has_value();
}

void DrillstringDisplay::resolve_exaggeration()
{
  if (options_.exaggeration > 0.0) return;
  const HoleAxis none;
  const HoleAxis& axis = model_.axis ? *model_.axis : none;
  const double radius = model_.rig ? model_.rig->hole_radius(axis.depth()) : 0.1;
  options_.exaggeration = exaggeration_for(properties_->preset().value_or(Preset::bit), axis, radius);
}

void DrillstringDisplay::show_probe()
{
  if (!probe_panel_) return;
  if (!probed_ || !model_.complete() || probed_->node + 1 >= model_.string->size())
  {
    deleteStatus("Probe");
    return probe_panel_->hide();
  }
  const StringData& s = *model_.string;
  const double from_bit = blend(s.from_bit, *probed_);
  const std::vector<double> bounds = part_bounds(model_.rig->parts, s.from_bit.back());
  std::size_t part = 0;
  while (part + 1 < model_.rig->parts.size() && from_bit > bounds[part + 1]) ++part;
  const QString name = QString::fromStdString(model_.rig->parts[part].name);
  const UnitSystem units = options_.units;
  const Rows rows = {
      {"measured depth", shown(blend(s.md, *probed_), Dimension::length, units)},
      {"from the bit", shown(from_bit, Dimension::length, units)},
      {"tension", shown(blend(s.tension, *probed_), Dimension::force, units)},
      {"torque", shown(blend(s.torque, *probed_), Dimension::torque, units)},
      {"bending moment", shown(blend(s.bending_moment, *probed_), Dimension::torque, units)},
      {"bending stress", shown(blend(s.bending_stress, *probed_), Dimension::specific_energy, units)},
      {"contact force", shown(blend(side_force(s), *probed_), Dimension::force_per_length, units, 3)},
      {"its side",
       s.contact_force[probed_->node] > 0.0 ? shown(s.contact_side[probed_->node], Dimension::angle, units, 0) : QString("-")},
      {"spin", shown(blend(s.spin_speed, *probed_), Dimension::rotation, units)},
      {"buckling", QString::number(blend(s.buckling, *probed_), 'f', 2)},
      {"modelled", s.guided[probed_->node] ? "guided" : "free"}};
  setStatus(StatusProperty::Ok, "Probe", in_words(name, rows));
  probe_panel_->show(paint_table(name, rows));
}

void DrillstringDisplay::keep_legend_off_bit(const Ogre::Camera& camera, double width, double height)
{
  const Ogre::Vector3 seen = camera.getViewMatrix(true) * scene_node_->convertLocalToWorldPosition(to_ogre(model_.bit_face()));
  if (seen.z > 0.0f) return;  // behind the eye
  const Ogre::Vector3 place = camera.getProjectionMatrix() * seen;
  legend_->avoid(0.5 * width * place.x, 0.5 * height * place.y, width, height);
}

void DrillstringDisplay::choose_detail(const Ogre::Camera& camera)
{
  double pixel = INFINITY;  // the smallest along the string
  for (std::size_t i = 0; i < model_.nodes.size(); i += 1 + model_.nodes.size() / 200)
    pixel = std::min(pixel, pixel_size(camera, scene_node_->convertLocalToWorldPosition(to_ogre(model_.nodes[i].position))));
  // not to and fro where the eye stands between the two
  const bool coarse = pixel > (options_.coarse ? 0.8 : 1.2) * coarse_pixel;
  if (coarse == options_.coarse) return;
  options_.coarse = coarse;
  string_due_ = well_due_ = true;
}

void DrillstringDisplay::apply_camera()
{
  camera_due_ = false;
  const std::optional<Preset> preset = properties_->preset();
  const bool follow = properties_->follow();
  rviz::ViewManager* views = context_->getViewManager();
  if (!preset && !follow && !views->getCurrent()) return;
  if (preset && views->getCurrent()->getClassId() != "rviz/Orbit") views->setCurrentViewControllerType("rviz/Orbit");
  rviz::ViewController* view = views->getCurrent();
  auto* target = dynamic_cast<rviz::TfFrameProperty*>(view->subProp("Target Frame"));
  auto* focal = dynamic_cast<rviz::VectorProperty*>(view->subProp("Focal Point"));
  if (!target || !focal) return;  // a view that has no place to look at
  const std::string frame =
      model_.prefix() + (model_.rig->parts.front().kind == PartKind::bit ? model_.rig->parts.front().name : "bit");
  target->setStdString(follow ? frame : model_.floor);
  if (!preset) return;
  changeOptions();  // the exaggeration may go by the camera
  const Subject subject{model_.bit_face(), model_.bit_md(), options_.exaggeration * model_.rig->hole_radius(model_.bit_md()),
                        model_.rig->crown_height};
  const OrbitView orbit = view_of(*preset, *model_.axis, subject);
  // rviz' orbit goes by the fixed frame's axes, about the target frame's origin
  const Ogre::Quaternion turned = scene_node_->getOrientation();
  const Ogre::Vector3 east = turned * Ogre::Vector3::UNIT_X;
  focal->setVector(turned * to_ogre(follow ? Eigen::Vector3d(orbit.focus - subject.bit) : orbit.focus));
  view->subProp("Distance")->setValue(static_cast<float>(orbit.distance));
  view->subProp("Yaw")->setValue(static_cast<float>(orbit.yaw) + std::atan2(east.y, east.x));
  view->subProp("Pitch")->setValue(static_cast<float>(orbit.pitch));
}

}  // namespace drill_rig_sim

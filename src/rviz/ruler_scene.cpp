// SPDX-License-Identifier: BSD-3-Clause
#include "ruler_scene.h"

#include <OgreCamera.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "well_scene.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr Color ink{0.92f, 0.92f, 0.92f}, tick_color{0.80f, 0.80f, 0.80f}, part_color{1.00f, 0.90f, 0.55f},
    well_color{0.75f, 0.85f, 0.95f}, plan_color{1.00f, 0.60f, 0.50f}, probe_color{1.00f, 1.00f, 0.30f},
    fault_color{1.00f, 0.42f, 0.35f};
constexpr double letter_height = 17.0, tick_distance = 60.0, name_distance = 20.0;  // [pixels]
constexpr double long_label = 3.2 * letter_height;  // to the right from its place, which is half way up [pixels]
constexpr int most_ticks = 60;

/// `format`: with a number and the unit's name.
std::string length_text(const char* format, double metres, UnitSystem units)
{
  const Unit& unit = unit_of(Dimension::length, units);
  char text[120];
  std::snprintf(text, sizeof text, format, metres * unit.per_si, unit.name);
  return text;
}

/// Measured depths at which it is asked whether the hole is seen: all along, and closely near its end.
std::vector<double> samples(double depth)
{
  std::vector<double> result;
  for (int i = 0; i <= 200; ++i) result.push_back(depth * i / 200.0);
  for (int back = 0; back < std::min(200.0, depth); back += 2) result.push_back(depth - back);
  return result;
}
}  // namespace

RulerScene::RulerScene(Ogre::SceneManager* manager, Ogre::SceneNode* parent)
    : manager_(manager),
      root_(parent->createChildSceneNode()),
      ticks_(MeshStyle{true}),
      label_set_(std::make_unique<LabelSet>(manager, root_))
{
  root_->attachObject(&ticks_);
}

RulerScene::~RulerScene()
{
  label_set_.reset();  // its nodes hang on this one
  root_->detachAllObjects();
  manager_->destroySceneNode(root_);
}

bool RulerScene::Sight::sees(Ogre::SceneNode& root, const Vector3d& place) const
{
  return camera->isVisible(root.convertLocalToWorldPosition(to_ogre(place)));
}

Ogre::Vector2 RulerScene::Sight::screen(Ogre::SceneNode& root, const Vector3d& place) const
{
  const Ogre::Vector3 world = root.convertLocalToWorldPosition(to_ogre(place)), seen = camera->getViewMatrix(true) * world;
  const double size = pixel_size(*camera, world);
  return {static_cast<float>(seen.x / size), static_cast<float>(seen.y / size)};
}

double RulerScene::Sight::pixel(Ogre::SceneNode& root, const Vector3d& place) const
{
  return pixel_size(*camera, root.convertLocalToWorldPosition(to_ogre(place)));
}

Vector3d RulerScene::Sight::beside(const AxisPoint& p) const
{
  const Vector3d across = p.tangent.cross(p.position - eye);
  if (across.norm() < 1e-6) return right;
  return (across.dot(right) < 0.0 ? -1.0 : 1.0) * across.normalized();
}

RulerScene::Sight RulerScene::sight_of(const Ogre::Camera& camera) const
{
  return {&camera, to_eigen(root_->convertWorldToLocalPosition(camera.getDerivedPosition())),
          to_eigen(root_->convertWorldToLocalOrientation(camera.getDerivedOrientation()) * Ogre::Vector3::UNIT_X)};
}

void RulerScene::draw(const DrawnRig& model, const DrillstringOptions& options, const PlanDistance& plan,
                      const std::optional<Between>& probed, const Ogre::Camera& camera,
                      const std::vector<Ogre::FloatRect>& covered)
{
  covered_ = covered;
  mesh_.clear();
  labels_.clear();
  written_.clear();
  const Sight sight = sight_of(camera);
  if (probed) add_probed(model, options, *probed, sight);
  if (options.faults) add_faults(model, options, sight);
  if (options.ruler) add_well(model, options, plan, sight);
  if (options.parts) add_parts(model, options, sight);
  if (options.ruler) add_ruler(model, options, sight);
  ticks_.set(mesh_);
  label_set_->set(labels_);
  label_set_->scale_to(camera, letter_height);
}

bool RulerScene::is_covered(const Ogre::Vector2& here, double width) const
{
  for (const Ogre::FloatRect& c : covered_)
    if (here.x + width > c.left && here.x < c.right && here.y - 0.5 * letter_height < c.top &&
        here.y + 0.5 * letter_height > c.bottom)
      return true;
  return false;
}

void RulerScene::add_label(const std::string& text, const Vector3d& place, const Color& color, const Sight& sight)
{
  const Ogre::Vector2 here = sight.screen(*root_, place);
  if (is_covered(here, long_label)) return;
  for (const Ogre::Vector2& there : written_)
    if (std::abs(here.x - there.x) < long_label && std::abs(here.y - there.y) < letter_height) return;
  written_.push_back(here);
  labels_.push_back({text, to_ogre(place), color});
}

void RulerScene::clear()
{
  ticks_.show(false);
  label_set_->set({});
}

void RulerScene::add_ruler(const DrawnRig& model, const DrillstringOptions& options, const Sight& sight)
{
  double first = INFINITY, last = -INFINITY, pixel = INFINITY;
  for (const double md : samples(model.axis->depth()))
  {
    const Vector3d place = model.axis->at(md).position;
    if (!sight.sees(*root_, place)) continue;
    first = std::min(first, md);
    last = std::max(last, md);
    pixel = std::min(pixel, sight.pixel(*root_, place));
  }
  if (first > last) return;
  const double per_metre = unit_of(Dimension::length, options.units).per_si;
  first *= per_metre;  // from here on in the unit shown
  last *= per_metre;
  double step = std::max(round_up(tick_distance * pixel * per_metre), 1.0);
  if (step == 2.5) step = 5.0;
  while ((last - first) / step > most_ticks) step *= 2.0;
  const double reach = 4.0 * step;  // beyond the samples that were seen
  const int from = std::max(0, static_cast<int>(std::floor((first - reach) / step)));
  const int to = static_cast<int>(std::floor(std::min(last + reach, model.axis->depth() * per_metre) / step));
  for (int k = from; k <= to; ++k)
  {
    const double md = k * step / per_metre;
    const AxisPoint p = model.axis->at(md);
    const Vector3d beside = sight.beside(p);
    const double wall = options.exaggeration * model.rig->hole_radius(md), length = 10.0 * sight.pixel(*root_, p.position);
    mesh_.add_line(p.position + wall * beside, p.position + (wall + length) * beside, tick_color);
    add_label(length_text("%.0f %s", md, options.units), p.position + (wall + 1.5 * length) * beside, ink, sight);
  }
}

void RulerScene::add_probed(const DrawnRig& model, const DrillstringOptions& options, const Between& probed, const Sight& sight)
{
  if (probed.node + 1 >= model.nodes.size()) return;
  const DrawnNode &a = model.nodes[probed.node], &b = model.nodes[probed.node + 1];
  const Vector3d place = a.position + probed.share * (b.position - a.position);
  const double md =
      model.string->md[probed.node] + probed.share * (model.string->md[probed.node + 1] - model.string->md[probed.node]);
  const double pixel = sight.pixel(*root_, place), wall = options.exaggeration * model.rig->hole_radius(md);
  const Vector3d beside = -sight.beside(model.axis->at(md));
  mesh_.add_line(place - 1.2 * wall * beside, place + (wall + 60.0 * pixel) * beside, probe_color);
  add_label(length_text("%.2f %s", md, options.units),
            place + (wall + 64.0 * pixel) * beside - 4.0 * letter_height * pixel * sight.right, probe_color, sight);
}

void RulerScene::add_faults(const DrawnRig& model, const DrillstringOptions& options, const Sight& sight)
{
  for (const DrawnRig::Fault& fault : model.faults)
  {
    if (!(fault.md >= 0.0 && fault.md <= model.axis->depth())) continue;
    const AxisPoint p = model.axis->at(fault.md);
    const double pixel = sight.pixel(*root_, p.position), wall = options.exaggeration * model.rig->hole_radius(fault.md);
    const Vector3d beside = sight.beside(p);
    for (const double side : {-1.0, 1.0})  // an arrow from either side to the wall
    {
      const Vector3d head = p.position + side * wall * beside, back = 9.0 * pixel * side * beside;
      mesh_.add_line(head, head + 5.0 * back, fault_color);
      for (const double way : {-7.0, 7.0}) mesh_.add_line(head, head + back + way * pixel * p.tangent, fault_color);
    }
    const char* const format = fault.name == "friction change" ? " below %.0f %s" : " %.0f %s";
    const std::string text = "! " + fault.name + length_text(format, fault.md, options.units);
    const double width = 0.55 * letter_height * static_cast<double>(text.size()), away = wall + 50.0 * pixel;
    const bool right = beside.dot(sight.right) > 0.0;
    Vector3d place = p.position + away * beside - (right ? 0.0 : width * pixel) * sight.right;
    if (is_covered(sight.screen(*root_, place), width))
      place = p.position - away * beside - (right ? width * pixel : 0.0) * sight.right;
    add_label(text, place, fault_color, sight);
  }
}

void RulerScene::add_parts(const DrawnRig& model, const DrillstringOptions& options, const Sight& sight)
{
  const std::vector<double> bounds = part_bounds(model.rig->parts, model.string->from_bit.back());
  double least = -INFINITY;  // where the next name finds room
  for (std::size_t i = 0; i + 1 < model.rig->parts.size(); ++i)
  {
    // a short part at its middle, of a long one near its lower end
    const double middle = std::min(0.5 * (bounds[i] + bounds[i + 1]), bounds[i] + 6.0);
    const Between at = between(model.string->from_bit, middle);
    const DrawnNode& node = model.nodes[at.node];
    const Vector3d place = node.position + at.share * (model.nodes[at.node + 1].position - node.position);
    const double pixel = sight.pixel(*root_, place);
    if (middle < least || pixel > 0.5 || !sight.sees(*root_, place)) continue;
    least = middle + name_distance * pixel;
    const AxisPoint p = model.axis->at(model.bit_md() - middle);
    const Vector3d beside = -sight.beside(p);
    const double wall = options.exaggeration * model.rig->hole_radius(p.md);
    const std::string& name = model.rig->parts[i].name;
    const double width = 0.55 * letter_height * static_cast<double>(name.size()) * pixel;  // texts begin where they stand
    mesh_.add_line(place, place + (wall + 10.0 * pixel) * beside, tick_color);
    add_label(name, place + (wall + 14.0 * pixel) * beside - (beside.dot(sight.right) < 0.0 ? width : 0.0) * sight.right,
              part_color, sight);
  }
}

void RulerScene::add_well(const DrawnRig& model, const DrillstringOptions& options, const PlanDistance& plan, const Sight& sight)
{
  const double shoe = WellScene::shoe(model, options);
  if (shoe > 0.0 && shoe < model.axis->depth())
  {
    const AxisPoint p = model.axis->at(shoe);
    const double pixel = sight.pixel(*root_, p.position);
    const Vector3d beside = sight.beside(p), place = p.position + options.exaggeration * model.rig->hole_radius(shoe) * beside;
    mesh_.add_line(place, place + 80.0 * pixel * beside, tick_color);
    add_label(length_text("casing shoe %.0f %s", shoe, options.units), place + 85.0 * pixel * beside, well_color, sight);
  }
  const Vector3d along = closure_direction(*model.axis);
  for (std::size_t i = 0; options.layers && i + 1 < model.rig->layer_base.size(); ++i)
  {
    const double base = model.rig->layer_base[i];
    const Vector3d place = (model.axis->points().back().position.dot(along) + 30.0) * along - base * Vector3d::UnitZ();
    if (base < 100.0 - model.axis->points().back().position.z())
      add_label("layer " + std::to_string(i + 2) + length_text(" below %.0f %s TVD", base, options.units), place, well_color,
                sight);
  }
  if (options.plan && plan.there && plan.distance > 0.05)
    add_label(length_text("%.2f %s off plan", plan.distance, options.units),
              0.5 * (plan.nearest + model.axis->points().back().position), plan_color, sight);
}

}  // namespace drill_rig_sim

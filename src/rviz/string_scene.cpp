// SPDX-License-Identifier: BSD-3-Clause
#include "string_scene.h"

#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

#include <algorithm>
#include <cmath>

#include "picture/coloring.h"
#include "picture/tools_picture.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr Color force_color{0.95f, 0.25f, 0.95f};
constexpr int coarse_sides = 5;
constexpr double least_force = 1.0;  // that has an arrow [N/m]
constexpr double longest_bit = 3.0;  // how much longer than it is a bit is drawn, so that it looks like one [-]

/// What rounds down to 1, 2 or 5 times a power of ten.
double round_down(double value)
{
  const double power = std::pow(10.0, std::floor(std::log10(value))), digits = value / power;
  return power * (digits >= 5.0 ? 5.0 : digits >= 2.0 ? 2.0 : 1.0);
}
}  // namespace

StringScene::StringScene(Ogre::SceneManager* manager, Ogre::SceneNode* parent)
    : manager_(manager), root_(parent->createChildSceneNode()), tube_(root_, MeshStyle{}), forces_(MeshStyle{})
{
  root_->attachObject(&forces_);
}

StringScene::~StringScene()
{
  remove_turning();
  tube_.clear();
  root_->detachAllObjects();
  manager_->destroySceneNode(root_);
}

void StringScene::remove_turning()
{
  for (Turning& t : turning_)
  {
    t.node->detachAllObjects();
    manager_->destroySceneNode(t.node);
  }
  turning_.clear();
}

void StringScene::add_turning(const std::string& part, double from_bit, MeshData mesh)
{
  shade(mesh);
  MeshStyle style;
  style.both_sides = true;
  Turning& added = turning_.emplace_back();
  added.part = part;
  added.from_bit = from_bit;
  added.mesh = std::make_unique<MeshObject>(style);
  added.node = root_->createChildSceneNode();
  added.mesh->set(mesh);
  added.node->attachObject(added.mesh.get());
  added.mesh->show(false);  // until it is known where
}

void StringScene::new_rig(const DrawnRig& model)
{
  remove_turning();
  shape_.forget();
  range_.restart();
  if (!model.rig) return;
  double bottom = 0.0;
  for (const PartData& part : model.rig->parts)
  {
    if (part.kind == PartKind::bit) add_turning(part.name, bottom, bit_mesh(std::max(part.length, 0.1), part.radius));
    if (part.kind == PartKind::stabilizer) add_turning(part.name, bottom, stabilizer_mesh(part.length, part.radius, part.widest));
    bottom += part.length;
  }
}

void StringScene::take(const DrawnRig& model, const DrillstringOptions& options)
{
  range_.take(values_of(options.coloring, *model.string, options.units), colorings()[options.coloring].share);
}

ColorScale StringScene::scale(const DrillstringOptions& options) const
{
  const Coloring& coloring = colorings()[options.coloring];
  const ColorScale automatic = at_least(range_.scale(), coloring, options.units);
  const double fixed = options.full_scale > 0.0 ? options.full_scale : coloring.fixed_high;
  return fixed > 0.0 ? ColorScale(automatic.low() < 0.0 ? -fixed : 0.0, fixed) : automatic;
}

void StringScene::draw(const DrawnRig& model, const DrillstringOptions& options)
{
  if (options.string)
  {
    shape_.shape(*model.rig, model.string->from_bit, !options.coarse);
    const ColorScale scale = this->scale(options);
    const bool levels = colorings()[options.coloring].levels;
    const auto color = [&](double value) { return levels ? level_color(value) : scale.at(value); };
    const double thickness = options.true_diameter ? 1.0 : options.exaggeration;
    tube_.set(shape_.rings(model.nodes, values_of(options.coloring, *model.string, options.units), color, thickness),
              options.coarse ? std::min(options.sides, coarse_sides) : options.sides);
  }
  tube_.show(options.string);
  draw_forces(model, options);
  place_turning(model, options);
}

void StringScene::clear()
{
  tube_.show(false);
  forces_.show(false);
  for (Turning& t : turning_) t.mesh->show(false);
}

void StringScene::draw_forces(const DrawnRig& model, const DrillstringOptions& options)
{
  const StringData& s = *model.string;
  mesh_.clear();
  const std::vector<double> force = side_force(s);
  largest_force_ = *std::max_element(force.begin(), force.end());
  const double hole = options.exaggeration * model.rig->hole_radius(model.bit_md());
  force_scale_ = options.force_scale > 0.0 ? 1e-3 * options.force_scale : round_down(6.0 * hole / std::max(largest_force_, 1.0));
  for (std::size_t i = 0; options.forces && i < s.size(); ++i)
  {
    if (force[i] < least_force || s.md[i] < 0.0) continue;
    const DrawnNode& node = model.nodes[i];
    const Vector3d off = node.position - node.axis.position;
    const Vector3d out = off.norm() > 1e-9 ? Vector3d(off.normalized()) : node.axis.side;
    const Vector3d wall = node.axis.position + options.exaggeration * model.rig->hole_radius(s.md[i]) * out;
    add_arrow(mesh_, wall + force_scale_ * force[i] * out, wall, 0.06 * hole, force_color, options.coarse ? 3 : 6);
  }
  shade(mesh_);
  forces_.set(mesh_);
}

void StringScene::place_turning(const DrawnRig& model, const DrillstringOptions& options)
{
  const float across = static_cast<float>(options.true_diameter ? 1.0 : options.exaggeration);
  for (Turning& t : turning_)
  {
    const Between at = between(model.string->from_bit, t.from_bit);
    const DrawnNode &a = model.nodes[at.node], &b = model.nodes[at.node + 1];
    const Vector3d place = a.position + at.share * (b.position - a.position);
    t.node->setPosition(to_ogre(place));
    const bool is_bit = &t == &turning_.front();
    t.node->setScale(is_bit ? std::min(across, static_cast<float>(longest_bit)) : 1.0f, across, across);
    t.mesh->show(options.blades);
  }
}

void StringScene::turn(const std::function<std::optional<Ogre::Quaternion>(const std::string&)>& orientation)
{
  for (Turning& t : turning_)
    if (const auto q = orientation(t.part)) t.node->setOrientation(*q);
}

}  // namespace drill_rig_sim

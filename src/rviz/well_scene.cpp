// SPDX-License-Identifier: BSD-3-Clause
#include "well_scene.h"

#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

#include <algorithm>

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr Color planned{0.45f, 0.75f, 1.00f}, drilled{1.00f, 0.85f, 0.30f}, off_plan{1.00f, 0.45f, 0.35f},
    station{0.95f, 0.95f, 0.95f}, trail{0.30f, 1.00f, 0.95f};
constexpr double most_rings = 1500.0;  // of the wall
constexpr int wall_sides = 24, coarse_wall_sides = 10;
constexpr double trail_spacing = 0.01;  // of the bit's places that are kept [m]
constexpr std::size_t trail_length = 1000;
constexpr float whole_opacity = 0.35f;

MeshStyle lines(float width)
{
  MeshStyle style;
  style.lines = true;
  style.line_width = width;
  return style;
}

MeshStyle seen_through()
{
  MeshStyle style;
  style.see_through = style.both_sides = true;
  return style;
}
}  // namespace

WellScene::WellScene(Ogre::SceneManager* manager, Ogre::SceneNode* parent)
    : manager_(manager),
      root_(parent->createChildSceneNode()),
      wall_(root_, MeshStyle{}),
      whole_wall_(root_, seen_through()),
      bands_(seen_through()),
      band_lines_(lines(1.0f)),
      paths_(lines(2.0f)),
      stations_(MeshStyle{}),
      trail_line_(lines(2.0f))
{
  for (MeshObject* object : {&bands_, &band_lines_, &paths_, &stations_, &trail_line_}) root_->attachObject(object);
}

WellScene::~WellScene()
{
  wall_.clear();
  whole_wall_.clear();
  root_->detachAllObjects();
  manager_->destroySceneNode(root_);
}

double WellScene::shoe(const DrawnRig& model, const DrillstringOptions& options)
{
  return options.cased_to < 0.0 ? model.rig->casing_shoe() : options.cased_to;
}

void WellScene::draw(const DrawnRig& model, const DrillstringOptions& options)
{
  draw_wall(model, options);
  draw_paths(model, options);
  draw_stations(model, options);
  mesh_.clear();
  other_mesh_.clear();
  if (options.layers) add_layers(mesh_, other_mesh_, *model.axis, *model.rig, 100.0);
  bands_.set(mesh_);
  band_lines_.set(other_mesh_);
}

void WellScene::clear()
{
  wall_.show(false);
  whole_wall_.show(false);
  for (MeshObject* object : {&bands_, &band_lines_, &paths_, &stations_, &trail_line_}) object->show(false);
}

void WellScene::draw_wall(const DrawnRig& model, const DrillstringOptions& options)
{
  std::vector<Ring> rings;
  if (options.wall != WallStyle::none)
    rings = wall_rings(*model.axis, *model.rig, shoe(model, options), options.exaggeration,
                       std::max(1.0, model.axis->depth() / most_rings));
  const bool whole = options.wall == WallStyle::whole;
  if (whole)
    for (Ring& ring : rings) ring.color.a = whole_opacity;
  const int sides = options.coarse ? coarse_wall_sides : wall_sides;
  wall_.set(whole ? std::vector<Ring>() : rings, sides, true, true);
  whole_wall_.set(whole ? rings : std::vector<Ring>(), sides, true, true);
}

void WellScene::draw_paths(const DrawnRig& model, const DrillstringOptions& options)
{
  mesh_.clear();
  plan_distance_ = distance_to_plan(model.plan(), model.axis->points().back().position);
  if (options.plan)
  {
    const std::vector<AxisPoint>& points = model.axis->points();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) mesh_.add_line(points[i].position, points[i + 1].position, drilled);
    add_dashes(mesh_, model.plan(), 2.0, planned);
    if (plan_distance_.there) mesh_.add_line(points.back().position, plan_distance_.nearest, off_plan);
  }
  paths_.set(mesh_);
}

void WellScene::draw_stations(const DrawnRig& model, const DrillstringOptions& options)
{
  mesh_.clear();
  const int sides = options.coarse ? coarse_wall_sides : wall_sides;
  for (std::size_t i = 0; options.stations && i < model.rig->stations.size(); ++i)
  {
    // a collar about the hole; one that is still to be drilled about the plan
    const double md = model.rig->station_md[i], half = 0.15;
    const bool ahead = md > model.axis->depth();
    AxisPoint p = model.axis->at(md);
    if (ahead) p.position = model.rig->stations[i];
    const double radius = (ahead ? 0.5 : 1.03) * options.exaggeration * model.rig->hole_radius(md);
    Ring top{p.position - half * p.tangent, p.side, p.other(), radius, station};
    Ring bottom = top;
    bottom.center = p.position + half * p.tangent;
    add_tube(mesh_, {top, bottom}, sides, true);
  }
  shade(mesh_);
  stations_.set(mesh_);
}

void WellScene::follow_bit(const DrawnRig& model, const DrillstringOptions& options, bool whole)
{
  const Vector3d& bit = model.string->position.front();
  const bool moved = trail_.empty() || (trail_.back() - bit).norm() > trail_spacing;
  if (!moved && !whole) return;
  if (moved) trail_.push_back(bit);
  if (trail_.size() > trail_length) trail_.erase(trail_.begin(), trail_.begin() + trail_length / 2);
  mesh_.clear();
  if (options.trail)
  {
    Vector3d before = Vector3d::Zero();
    double md = model.string->md.front();
    for (std::size_t i = trail_.size(); i-- > 0;)
    {
      const AxisPoint axis = model.axis->nearest(trail_[i], md);
      md = axis.md;
      const Vector3d here = exaggerated(axis, trail_[i], options.exaggeration);
      if (i + 1 < trail_.size()) mesh_.add_line(before, here, trail);
      before = here;
    }
  }
  trail_line_.set(mesh_);
}

}  // namespace drill_rig_sim

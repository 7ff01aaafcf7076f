// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/wellbore.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/well/hole_nodes.h"
#include "drill_rig_sim/well/well_checks.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t raw_capacity = 16384;
constexpr double raw_spacing = 5e-4;                       // [m]
constexpr double first_interval_by_steps = 0.1;            // L2 until the first Stage II when steps are counted [m]
constexpr double shortest_chord = least_stage_two_length;  // Stage II waits for it

std::size_t checked_capacity(int capacity)
{
  if (capacity < 1 || (capacity & (capacity - 1)) != 0)
    throw std::invalid_argument("wellbore: drilled_capacity must be a positive power of two");
  return static_cast<std::size_t>(capacity);
}
}  // namespace

Wellbore::Wellbore(const WellSpec& spec, const TrajectorySpec& trajectory, double bit_radius,
                   const std::vector<FormationLayer>& rock, int drilled_capacity)
    : original_(build(spec, trajectory, bit_radius, rock)), drilled_(checked_capacity(drilled_capacity)), raw_(raw_capacity)
{
  last_ = original_->nodes.back();
  bottom_ = last_.position;
  bottom_normal_ = last_.tangent;
  raw_tangent_ = last_.tangent;
  interval_ = original_->stage_two_steps > 0 ? first_interval_by_steps : original_->stage_two_length;
  update_new_interval();
}

std::shared_ptr<const Wellbore::Original> Wellbore::build(const WellSpec& spec, const TrajectorySpec& trajectory,
                                                          double bit_radius, const std::vector<FormationLayer>& rock)
{
  const Survey survey(spec.survey);
  const ProblemList problems = trajectory_problems(trajectory);
  if (!problems.empty()) throw std::invalid_argument(problems.front().key + ": " + problems.front().text);
  auto hole = std::make_shared<Original>();
  hole->nodes = place_nodes(spec, survey, bit_radius);
  hole->sections = spec.sections;
  hole->rock = rock;
  hole->stage_two_length = trajectory.stage_two_length;
  hole->stage_two_steps = trajectory.stage_two_steps;
  const WellNode& top = hole->nodes.front();
  hole->segments.push_back(HoleSegment::line(top.position, -Eigen::Vector3d::UnitZ(), top));
  for (std::size_t i = 1; i < hole->nodes.size(); ++i)
    hole->segments.push_back(HoleSegment::between(hole->nodes[i - 1], hole->nodes[i]));
  for (const HoleSegment& segment : hole->segments) hole->boxes.push_back(Box::around(segment));
  return hole;
}

WellNode Wellbore::node(int i) const noexcept
{
  const int originals = original_count();
  return i < originals ? original_->nodes[static_cast<std::size_t>(i)] : drilled_[static_cast<std::size_t>(i - originals)].node;
}

WellNode Wellbore::at(double md) const noexcept
{
  // the last node at or above md, by bisection; -1: above the first
  int above = -1;
  int below = node_count();
  while (below - above > 1)
  {
    const int middle = (above + below) / 2;
    (node(middle).md <= md ? above : below) = middle;
  }
  const HoleSegment& g = segment(above + 1);
  return g.at((md - g.md) / g.length);
}

int Wellbore::segment_at(double md, int hint) const noexcept
{
  const int last = new_interval_index();
  hint = std::clamp(hint, 0, last);
  while (hint > 0 && md < segment(hint).md) --hint;
  while (hint < last && md > segment(hint + 1).md) ++hint;
  return hint;
}

WellNode Wellbore::at(double md, int& hint) const noexcept
{
  const HoleSegment& g = segment_there(md, hint);
  return g.at((md - g.md) / g.length);
}

HoleWall Wellbore::wall_at(double md, int hint) const noexcept
{
  const HoleSegment& g = segment_there(md, hint);
  const double s = (md - g.md) / g.length;
  return {g.radius + s * g.radius_change, g.friction + s * g.friction_change, g.section + s * g.section_change};
}

bool Wellbore::extend(const Eigen::Vector3d& bottom_displacement, const Eigen::Vector3d& bit_axis) noexcept
{
  const double drilled = bottom_displacement.norm();
  if (!(drilled <= longest_extension) || !std::isfinite(bit_axis.sum())) return false;
  if (drilled == 0.0) return true;

  // stage I: a raw node
  turn_bottom(bottom_displacement / drilled, drilled);
  bottom_ += bottom_displacement;
  raw_tangent_ = bit_axis;
  drilled_path_ += drilled;
  ++interval_steps_;
  if (drilled_path_ - pictured_path_ >= raw_spacing)
  {
    raw_.push(bottom_, bottom_.x(), bottom_.y(), bottom_.z());
    pictured_path_ = drilled_path_;
  }

  if (stage_two_due()) commit_stage_two();
  update_new_interval();
  return true;
}

void Wellbore::turn_bottom(const Eigen::Vector3d& direction, double drilled) noexcept
{
  const Eigen::Vector3d turn = direction - bottom_normal_;
  const double most = drilled / new_interval_.radius;
  const double wanted = turn.norm();
  bottom_normal_ = wanted <= most ? direction : (bottom_normal_ + (most / wanted) * turn).normalized();
}

bool Wellbore::stage_two_due() const noexcept
{
  if (drilled_.count() == drilled_.capacity()) return false;
  const double chord2 = (bottom_ - last_.position).squaredNorm();
  if (original_->stage_two_steps == 0 || strained_) return chord2 >= interval_ * interval_;
  return interval_steps_ >= original_->stage_two_steps && chord2 >= shortest_chord * shortest_chord;
}

WellNode Wellbore::node_to_commit() const noexcept
{
  const Original& hole = *original_;
  const Eigen::Vector3d chord = bottom_ - last_.position;
  const double length = chord.norm();
  const std::size_t section = section_at(hole.sections, last_.md + length);
  WellNode node;
  node.md = last_.md + length;
  node.position = bottom_;
  node.tangent = chord / length;
  node.radius = new_interval_.radius;
  node.friction = hole.rock.empty() ? FormationLayer::unset : layer_at(hole.rock, -bottom_.z()).friction;
  if (std::isnan(node.friction)) node.friction = hole.sections[section].friction;
  node.section = static_cast<double>(section);
  return node;
}

void Wellbore::commit_stage_two() noexcept
{
  const WellNode node = node_to_commit();
  const double length = (node.position - last_.position).norm();
  const HoleSegment segment = HoleSegment::between(last_, node);
  drilled_.push({segment, Box::around(segment), node}, bottom_.x(), bottom_.y(), bottom_.z());
  last_ = node;
  interval_steps_ = 0;
  if (original_->stage_two_steps > 0 && !strained_) interval_ = length;

  // Each time half of the room that was left is used the interval doubles, so it lasts log2(capacity) times as long.
  const std::size_t left = drilled_.capacity() - drilled_.count();
  if ((left & (left - 1)) == 0)
  {
    interval_ *= 2.0;
    strained_ = true;
  }
}

void Wellbore::update_new_interval() noexcept
{
  const Eigen::Vector3d chord = bottom_ - last_.position;
  const Eigen::Vector3d d = (last_.tangent * std::max(interval_ - chord.norm(), 0.0) + chord).normalized();
  const double along = chord.dot(d);
  new_interval_ = HoleSegment::line(bottom_ - along * d, d, last_);
  hole_depth_ = last_.md + along;
}

void Wellbore::raw_path(std::vector<Eigen::Vector3d>& out) const
{
  out.clear();
  for (std::size_t i = raw_.first(); i < raw_.count(); ++i) out.push_back(raw_[i]);
  out.push_back(bottom_);
}

}  // namespace drill_rig_sim

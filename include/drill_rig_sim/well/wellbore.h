// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_WELLBORE_H
#define DRILL_RIG_SIM_WELL_WELLBORE_H

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "drill_rig_sim/well/formation.h"
#include "drill_rig_sim/well/well_spec.h"
#include "drill_rig_sim/well/history.h"
#include "drill_rig_sim/well/hole_segment.h"
#include "drill_rig_sim/well/well_node.h"

namespace drill_rig_sim
{
/// The hole's cross section nearest to a point D: where c(md) satisfies (r_D - c) . c' = 0.
struct ClosestPoint
{
  double md = 0.0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = -Eigen::Vector3d::UnitZ();       ///< unit
  Eigen::Vector3d centre_slope = -Eigen::Vector3d::UnitZ();  ///< dc/dmd, nearly the tangent
  Eigen::Vector3d md_gradient = -Eigen::Vector3d::UnitZ();   ///< d md / d r_D = c' / (|c'|^2 - (r_D - c) . c'')
  double radius = 0.0;
  double radius_slope = 0.0;  ///< dR/dmd
  double friction = 0.0;      ///< kinetic [-]
  double section = 0.0;       ///< index of the hole section; between two, over the millimetre where one gives way to the next
  int segment = 0;            ///< start of the next search
  int iterations = 0;         ///< Newton iterations used
};

/// The hole: permanent nodes joined by cubic Hermites, and below the last of them, P, the straight newly drilled interval that is
/// being drilled.
///
/// Drilling, in two stages (the paper's correction). Stage I, each step: the bottom centre C moves by what the bit drilled; the
/// raw path goes to a bounded buffer for pictures and nothing else. Stage II, each time |C - P| reaches the stage-two length L2
/// (or every N drilling steps): C becomes a permanent node with tangent (C - P)/|C - P| and md = md_P + |C - P|; all between is
/// dropped.
///
/// The newly drilled interval is the straight line through C with the direction
///   d = normalised( t_P max(L2 - |C - P|, 0) + (C - P) ),
/// so it is always measured over at least L2: raw nodes lie microns apart and their directions swing by a degree. When a Stage II
/// commit happens d is the chord before and t_P after: the line does not jump. (By steps, L2 is the previous interval's length,
/// and d turns by what the interval's length changed.) Measured depth along the line is md_P + (r - P) . d, hence
///   hole depth = md_P + (C - P) . d,
/// continuous along the hole and in time; on commit it is md_P + |C - P|. At P the line is offset sideways by up to
/// (1 - |C - P|/L2) times C's distance from the tangent at P: tens of microns in a raw helix of 30 um.
///
/// Friction of drilled hole: that of the rock layer at the node, if the layer has one, else its hole section's; in a straight
/// line between nodes. Until its first commit the newly drilled interval has that of the hole above it.
///
/// Segments are numbered 0: the straight vertical line above the first node (md = -z), 1 .. n: permanent, n + 1: the newly
/// drilled interval. Copies are snapshots. Assignment between copies of one well costs what was drilled in between and does not
/// allocate.
class Wellbore
{
public:
  /// Drilled nodes that a Wellbore has room for by default: 0.8 km at 0.1 m, then as much again at twice the spacing, and so on.
  static constexpr int default_capacity = 16384;
  static constexpr double longest_extension = 1000.0;  ///< of one step; what would be longer is a step that has gone astray [m]

  /// A hole with its first node at the origin. `spec.survey`'s first station must be at md 0; `bit_radius` [m] is the radius of
  /// everything drilled and of the hole at its bottom; `rock`: layers whose friction drilled hole gets, none: its sections'
  /// friction everywhere; `drilled_capacity`: most drilled nodes, a power of two. Throws std::invalid_argument with one line if
  /// survey, sections, depth or trajectory are not usable.
  Wellbore(const WellSpec& spec, const TrajectorySpec& trajectory, double bit_radius,
           const std::vector<FormationLayer>& rock = {}, int drilled_capacity = default_capacity);

  /// The cross section nearest to `point` [m]. `segment_hint` < 0 searches the whole hole (nearest of all); otherwise the search
  /// walks from that segment, and turns to the whole hole if it walks far or ends more than four radii from the axis. Newton's
  /// method on f(s) = (r_D - c(s)) . c'(s), f' = -|c'|^2 + (r_D - c) . c''; s outside 0 .. 1 moves to the neighbour. Exact while
  /// the point is nearer than the hole's radius of curvature. Any hint is safe; a point that is not finite gives one that is
  /// not.
  ClosestPoint locate(const Eigen::Vector3d& point, int segment_hint) const noexcept;

  /// The segment for those who search several points at a time; null where the search from it at `point` may have to look at one
  /// of the hole's two kinks: the line above the first node and what is beside it, the newly drilled interval and the segment
  /// above that.
  const HoleSegment* smooth_segment(int i, const Eigen::Vector3d& point) const noexcept;

  /// Radius of the hole at about `point` [m], which lies in or beside `segment`: read off that segment's chord, without a search;
  /// < 0 searches.
  double radius_near(const Eigen::Vector3d& point, int segment) const noexcept;
  /// Tangent of the hole there, in the same way: unit, downhole.
  Eigen::Vector3d tangent_near(const Eigen::Vector3d& point, int segment) const noexcept;

  /// Stage I, and Stage II when due. `bottom_displacement`: how far the bit moved the bottom in this step, world axes [m];
  /// `bit_axis`: the raw node's tangent, unit, downhole. False and nothing changed if a number is not finite or the displacement
  /// is longer than longest_extension. About a hundred flops, whatever the drilled length.
  bool extend(const Eigen::Vector3d& bottom_displacement, const Eigen::Vector3d& bit_axis) noexcept;

  /// Measured depth of the bottom [m], md_P + (C - P) . d.
  double hole_depth() const noexcept { return hole_depth_; }
  /// C, the centre of the bottom [m].
  const Eigen::Vector3d& bottom_position() const noexcept { return bottom_; }
  /// Normal of the bottom plane, the rock just cut: it turns towards the direction v/|v| of the displacement (the tangent of the
  /// well's last raw node in the rock-penetration equations; the start's tangent until something is drilled), by at most the
  /// angle |displacement| / bottom_radius(). For rock does not grow back: a plane that turns about its centre by more than it
  /// recedes would rise at its rim. It swings with the bit's tilt (up to 1 deg).
  const Eigen::Vector3d& bottom_normal() const noexcept { return bottom_normal_; }
  /// Tangent that Stage I gives the raw node: the bit's axis at the last displacement.
  const Eigen::Vector3d& raw_tangent() const noexcept { return raw_tangent_; }
  /// d, the smoothed direction of the newly drilled interval: for the wall, and for the hole's inclination and azimuth at bottom.
  const Eigen::Vector3d& end_direction() const noexcept { return new_interval_.c1; }
  double bottom_radius() const noexcept { return new_interval_.radius; }
  /// Length of the raw path drilled since construction [m], the sum of |displacement|.
  double drilled_path_length() const noexcept { return drilled_path_; }

  /// Permanent nodes, from the top down.
  int node_count() const noexcept { return original_count() + static_cast<int>(drilled_.count()); }
  WellNode node(int i) const noexcept;
  /// The hole at measured depth `md`; above 0 on the vertical line, below the last node on the newly drilled interval.
  WellNode at(double md) const noexcept;
  /// The same from where `segment` of the last search was, brought up to date: without a search where little has changed.
  WellNode at(double md, int& segment) const noexcept;
  HoleWall wall_at(double md, int segment) const noexcept;
  /// The segment in which they look, in the same way.
  const HoleSegment& segment_there(double md, int& segment) const noexcept
  {
    const std::vector<HoleSegment>& originals = original_->segments;
    if (segment > 0 && static_cast<std::size_t>(segment) < originals.size())
    {
      const HoleSegment& last = originals[static_cast<std::size_t>(segment)];
      if (md >= last.md && md - last.md <= last.length) return last;  // where it was, mostly
    }
    return this->segment(segment = segment_at(md, segment));
  }
  /// Changes when permanent nodes change, and back when a snapshot is restored.
  std::uint64_t version() const noexcept { return drilled_.hash(); }
  /// Nearly full: Stage II intervals have been lengthened to make the room last (or, when full, no more nodes are added and the
  /// newly drilled interval runs on straight from the last one).
  bool capacity_strained() const noexcept { return strained_; }

  /// The uncorrected path of the last metres, oldest first: points 0.5 mm or more of raw path apart, then C. At most 16385.
  void raw_path(std::vector<Eigen::Vector3d>& out) const;

  /// What drilling has changed: the hole as it was built is no part of it (math/visit.h).
  template <class V>
  void visit(V& v)
  {
    v("drilled", drilled_);
    v("raw", raw_);
    v("last", last_);
    v("new_interval", new_interval_);
    v("bottom", bottom_);
    v("bottom_normal", bottom_normal_);
    v("raw_tangent", raw_tangent_);
    v("hole_depth", hole_depth_);
    v("drilled_path", drilled_path_);
    v("pictured_path", pictured_path_);
    v("interval", interval_);
    v("interval_steps", interval_steps_);
    v("strained", strained_);
  }

private:
  int segment_at(double md, int hint) const noexcept;
  // What never changes, shared by all copies.
  struct Original
  {
    std::vector<WellNode> nodes;
    std::vector<HoleSegment> segments;  // [0]: above the first node; [i]: from node i - 1 to node i
    std::vector<Box> boxes;             // of segments; [0] unused
    std::vector<HoleSection> sections;
    std::vector<FormationLayer> rock;
    double stage_two_length;
    int stage_two_steps;
  };
  // A drilled node and the segment that ends in it.
  struct Drilled
  {
    HoleSegment segment;
    Box box;
    WellNode node;

    template <class V>
    void visit(V& v)
    {
      v("segment", segment);
      v("box", box);
      v("node", node);
    }
  };

  static std::shared_ptr<const Original> build(const WellSpec& spec, const TrajectorySpec& trajectory, double bit_radius,
                                               const std::vector<FormationLayer>& rock);
  int original_count() const noexcept { return static_cast<int>(original_->nodes.size()); }
  int new_interval_index() const noexcept { return node_count(); }
  const HoleSegment& segment(int i) const noexcept;
  const Box& box(int i) const noexcept;
  int neighbour(int i, double s, const Eigen::Vector3d& point) const noexcept;
  int nearest_segment(const Eigen::Vector3d& point) const noexcept;
  void turn_bottom(const Eigen::Vector3d& direction, double drilled) noexcept;
  bool stage_two_due() const noexcept;
  WellNode node_to_commit() const noexcept;
  void commit_stage_two() noexcept;
  void update_new_interval() noexcept;

  std::shared_ptr<const Original> original_;
  History<Drilled> drilled_;
  History<Eigen::Vector3d> raw_;

  WellNode last_;             // P
  HoleSegment new_interval_;  // the line, from the plane through P, s in metres
  Eigen::Vector3d bottom_;
  Eigen::Vector3d bottom_normal_;
  Eigen::Vector3d raw_tangent_;
  double hole_depth_ = 0.0;
  double drilled_path_ = 0.0;
  double pictured_path_ = 0.0;  // drilled_path_ when the last raw point was kept
  double interval_ = 0.0;       // L2
  int interval_steps_ = 0;      // drilling steps since P
  bool strained_ = false;
};

}  // namespace drill_rig_sim

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_WELL_SCENE_H
#define DRILL_RIG_SIM_SRC_RVIZ_WELL_SCENE_H

#include <vector>

#include "drawn_rig.h"
#include "drillstring_options.h"
#include "tube_object.h"

namespace Ogre
{
class SceneManager;
class SceneNode;
}  // namespace Ogre

namespace drill_rig_sim
{
/// Hole, rock, plan, stations and the bit's trail: what changes when the hole grows.
class WellScene
{
public:
  /// Draws below `parent`, in the axes of the rig floor.
  WellScene(Ogre::SceneManager* manager, Ogre::SceneNode* parent);
  ~WellScene();

  /// Draws a well whose rig and axis are known.
  void draw(const DrawnRig& model, const DrillstringOptions& options);
  void clear();
  /// Remembers where the bit is, and draws where it was: if it has moved, or `whole` where options or the path have changed.
  void follow_bit(const DrawnRig& model, const DrillstringOptions& options, bool whole);
  void forget_trail() { trail_.clear(); }

  /// Of the hole's bottom from the plan, by the path drawn last.
  const PlanDistance& plan_distance() const noexcept { return plan_distance_; }
  /// Measured depth down to which the hole is drawn as cased [m].
  static double shoe(const DrawnRig& model, const DrillstringOptions& options);

private:
  void draw_wall(const DrawnRig& model, const DrillstringOptions& options);
  void draw_paths(const DrawnRig& model, const DrillstringOptions& options);
  void draw_stations(const DrawnRig& model, const DrillstringOptions& options);

  Ogre::SceneManager* manager_;
  Ogre::SceneNode* root_;
  TubeObject wall_, whole_wall_;
  MeshObject bands_, band_lines_, paths_, stations_, trail_line_;
  std::vector<Eigen::Vector3d> trail_;  // where the bit's centre was, true
  PlanDistance plan_distance_;
  MeshData mesh_, other_mesh_;  // keep their memory
};

}  // namespace drill_rig_sim

#endif

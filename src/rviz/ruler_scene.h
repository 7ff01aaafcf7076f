// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_RULER_SCENE_H
#define DRILL_RIG_SIM_SRC_RVIZ_RULER_SCENE_H

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drawn_rig.h"
#include "drillstring_options.h"
#include "label_set.h"
#include "mesh_object.h"

namespace drill_rig_sim
{
/// A ruler of measured depth along the hole, as fine as the picture is large, and the names of what is seen: parts, casing shoe,
/// layers, faults under way, distance to the plan. All of it goes by the camera.
class RulerScene
{
public:
  /// Draws below `parent`, in the axes of the rig floor.
  RulerScene(Ogre::SceneManager* manager, Ogre::SceneNode* parent);
  ~RulerScene();

  /// Draws a complete model for a camera. `plan`: of the hole's bottom; `probed`: a place on the string that is pointed at;
  /// `covered`: where nothing is written, from the picture's middle, x right, y up [pixels].
  void draw(const DrawnRig& model, const DrillstringOptions& options, const PlanDistance& plan,
            const std::optional<Between>& probed, const Ogre::Camera& camera, const std::vector<Ogre::FloatRect>& covered);
  void clear();

private:
  /// What the camera sees, in the axes of the rig floor.
  struct Sight
  {
    const Ogre::Camera* camera;
    Eigen::Vector3d eye, right;
    bool sees(Ogre::SceneNode& root, const Eigen::Vector3d& place) const;
    /// From the picture's middle, x right, y up [pixels].
    Ogre::Vector2 screen(Ogre::SceneNode& root, const Eigen::Vector3d& place) const;
    double pixel(Ogre::SceneNode& root, const Eigen::Vector3d& place) const;
    /// Unit, across the hole and across the line of sight, towards the picture's right.
    Eigen::Vector3d beside(const AxisPoint& p) const;
  };
  Sight sight_of(const Ogre::Camera& camera) const;
  /// Whether a text of this width would stand on what is covered [pixels].
  bool is_covered(const Ogre::Vector2& here, double width) const;
  /// Adds a label unless it would stand on another one, or on what is covered.
  void add_label(const std::string& text, const Eigen::Vector3d& place, const Color& color, const Sight& sight);
  void add_ruler(const DrawnRig& model, const DrillstringOptions& options, const Sight& sight);
  void add_probed(const DrawnRig& model, const DrillstringOptions& options, const Between& probed, const Sight& sight);
  void add_parts(const DrawnRig& model, const DrillstringOptions& options, const Sight& sight);
  /// Where faults are under way, by name and depth.
  void add_faults(const DrawnRig& model, const DrillstringOptions& options, const Sight& sight);
  void add_well(const DrawnRig& model, const DrillstringOptions& options, const PlanDistance& plan, const Sight& sight);

  Ogre::SceneManager* manager_;
  Ogre::SceneNode* root_;
  MeshObject ticks_;
  std::unique_ptr<LabelSet> label_set_;
  MeshData mesh_;
  std::vector<Label> labels_;
  std::vector<Ogre::FloatRect> covered_;
  std::vector<Ogre::Vector2> written_;  // where labels begin on the screen [pixels]
};

}  // namespace drill_rig_sim

#endif

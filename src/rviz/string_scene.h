// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_STRING_SCENE_H
#define DRILL_RIG_SIM_SRC_RVIZ_STRING_SCENE_H

#include <OgreQuaternion.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drawn_rig.h"
#include "drillstring_options.h"
#include "picture/color_scale.h"
#include "tube_object.h"

namespace Ogre
{
class SceneManager;
class SceneNode;
}  // namespace Ogre

namespace drill_rig_sim
{
/// The string, its bit and blades, and the forces of the wall on it: what changes with every message.
class StringScene
{
public:
  /// Draws below `parent`, in the axes of the rig floor.
  StringScene(Ogre::SceneManager* manager, Ogre::SceneNode* parent);
  ~StringScene();

  /// Another string: its rings and blades are made anew.
  void new_rig(const DrawnRig& model);
  /// What the next messages' values are is another quantity.
  void new_coloring() { range_.restart(); }
  /// Takes a message's values into the colour scale. Draws nothing.
  void take(const DrawnRig& model, const DrillstringOptions& options);
  /// Draws a string that is complete.
  void draw(const DrawnRig& model, const DrillstringOptions& options);
  /// Draws nothing.
  void clear();
  /// Turns bit and blades. `orientation`: of a part's frame on the rig floor, none where it is not known.
  void turn(const std::function<std::optional<Ogre::Quaternion>(const std::string&)>& orientation);

  ColorScale scale(const DrillstringOptions& options) const;
  double largest_force() const noexcept { return largest_force_; }  ///< of the wall on a metre of the string, drawn last [N/m]
  double force_scale() const noexcept { return force_scale_; }      ///< of the arrows drawn last [m per N/m]

private:
  struct Turning
  {
    std::string part;
    double from_bit;  // of its lower end
    std::unique_ptr<MeshObject> mesh;
    Ogre::SceneNode* node;
  };
  void remove_turning();
  void add_turning(const std::string& part, double from_bit, MeshData mesh);
  void draw_forces(const DrawnRig& model, const DrillstringOptions& options);
  void place_turning(const DrawnRig& model, const DrillstringOptions& options);

  Ogre::SceneManager* manager_;
  Ogre::SceneNode* root_;
  TubeObject tube_;
  MeshObject forces_;
  StringTube shape_;
  SteadyRange range_;
  std::vector<Turning> turning_;
  MeshData mesh_;  // keeps its memory
  double largest_force_ = 0.0, force_scale_ = 0.0;
};

}  // namespace drill_rig_sim

#endif

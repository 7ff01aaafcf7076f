// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_LABEL_SET_H
#define DRILL_RIG_SIM_SRC_RVIZ_LABEL_SET_H

#include <memory>
#include <string>
#include <vector>

#include "ogre_vector.h"
#include "picture/color_scale.h"

namespace Ogre
{
class Camera;
class SceneManager;
class SceneNode;
}  // namespace Ogre
namespace rviz
{
class MovableText;
}

namespace drill_rig_sim
{
/// A text at a place in space.
struct Label
{
  std::string text;
  Ogre::Vector3 position = Ogre::Vector3::ZERO;
  Color color;
};

/// Texts that face the eye and are as high on the screen wherever they stand.
class LabelSet
{
public:
  LabelSet(Ogre::SceneManager* manager, Ogre::SceneNode* parent);
  ~LabelSet();

  /// Shows these; texts that were there before are used again.
  void set(const std::vector<Label>& labels);
  /// Gives each the size that makes it `pixels` high for this camera.
  void scale_to(const Ogre::Camera& camera, double pixels);

private:
  struct Shown
  {
    Ogre::SceneNode* node;
    std::unique_ptr<rviz::MovableText> text;
    std::string caption;
  };
  Ogre::SceneManager* manager_;
  Ogre::SceneNode* parent_;
  std::vector<Shown> shown_;
  std::size_t used_ = 0;
};

/// How large a pixel is, at a place in world axes, across the line of sight [m].
double pixel_size(const Ogre::Camera& camera, const Ogre::Vector3& place);

}  // namespace drill_rig_sim

#endif

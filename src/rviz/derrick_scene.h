// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_DERRICK_SCENE_H
#define DRILL_RIG_SIM_SRC_RVIZ_DERRICK_SCENE_H

#include "mesh_object.h"
#include "picture/string_data.h"

namespace Ogre
{
class SceneManager;
class SceneNode;
}  // namespace Ogre

namespace drill_rig_sim
{
/// Derrick, lines, travelling block and top drive, in true size.
class DerrickScene
{
public:
  /// Draws below `parent`, in the axes of the rig floor.
  DerrickScene(Ogre::SceneManager* manager, Ogre::SceneNode* parent);
  ~DerrickScene();

  void draw(const RigData& rig);
  /// `height`: of the top drive's shaft [m].
  void move_block(double height);
  void clear();

private:
  Ogre::SceneManager* manager_;
  Ogre::SceneNode *root_, *block_node_;
  MeshObject derrick_, block_, lines_;
  RigData rig_;
  double height_ = -1e9;  // of the block, drawn last
};

}  // namespace drill_rig_sim

#endif

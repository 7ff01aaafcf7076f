// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_TUBE_OBJECT_H
#define DRILL_RIG_SIM_SRC_RVIZ_TUBE_OBJECT_H

#include <memory>
#include <vector>

#include "mesh_object.h"

namespace Ogre
{
class SceneNode;
}

namespace drill_rig_sim
{
/// A long tube in pieces, so that those out of sight cost nothing.
class TubeObject
{
public:
  /// Its pieces are children of `node`, which outlives them.
  TubeObject(Ogre::SceneNode* node, const MeshStyle& style) : node_(node), style_(style) {}
  ~TubeObject() { clear(); }
  TubeObject(const TubeObject&) = delete;
  TubeObject& operator=(const TubeObject&) = delete;

  /// Draws the tube through these rings, shaded, seen from outside or `inside` from within; with `closed` a disc at the last
  /// ring.
  void set(const std::vector<Ring>& rings, int sides, bool inside = false, bool closed = false);
  void show(bool shown);
  /// Takes all pieces off the node.
  void clear();

private:
  Ogre::SceneNode* node_;
  MeshStyle style_;
  std::vector<std::unique_ptr<MeshObject>> pieces_;
  std::size_t used_ = 0;  // of the pieces
  MeshData mesh_;         // keep their memory
  std::vector<Ring> part_;
};

}  // namespace drill_rig_sim

#endif

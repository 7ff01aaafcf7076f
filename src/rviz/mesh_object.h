// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_MESH_OBJECT_H
#define DRILL_RIG_SIM_SRC_RVIZ_MESH_OBJECT_H

#include <OgreMaterial.h>
#include <OgreSimpleRenderable.h>

#include "picture/mesh_data.h"

namespace drill_rig_sim
{
/// How a MeshObject looks.
struct MeshStyle
{
  bool lines = false;        ///< pairs of points instead of triangles
  bool see_through = false;  ///< by the colours' opacity; hides nothing behind it
  bool both_sides = false;   ///< of triangles; else only the one from which they run counterclockwise
  float line_width = 1.0f;   ///< [pixels]
};

/// Triangles or lines of one material in one buffer of the graphics card, which keeps its memory while the mesh does not grow.
/// Goes on a scene node by attachObject(), and has left it before it ends.
class MeshObject : public Ogre::SimpleRenderable
{
public:
  explicit MeshObject(const MeshStyle& style);
  ~MeshObject() override;

  /// Replaces what is drawn, and shows it. An empty mesh draws nothing.
  void set(const MeshData& mesh);
  /// Apart from setVisible(), which rviz uses for all of a display's objects when it is switched on.
  void show(bool shown) { shown_ = shown; }

  Ogre::Real getBoundingRadius() const override { return radius_; }
  Ogre::Real getSquaredViewDepth(const Ogre::Camera* camera) const override;
  void _updateRenderQueue(Ogre::RenderQueue* queue) override;

private:
  void fit(const MeshData& mesh);

  std::size_t vertices_ = 0, indices_ = 0;  // room in the buffers
  Ogre::Real radius_ = 0.0f;
  bool shown_ = false;
};

}  // namespace drill_rig_sim

#endif

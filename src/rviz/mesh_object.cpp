// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_object.h"

#include <OgreCamera.h>
#include <OgreHardwareBufferManager.h>
#include <OgreMaterialManager.h>
#include <OgreNode.h>
#include <OgreTechnique.h>

#include <algorithm>
#include <string>

namespace drill_rig_sim
{
namespace
{
Ogre::MaterialPtr make_material(const MeshStyle& style)
{
  static int made = 0;
  const Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton().create(
      "drill_rig_sim/mesh" + std::to_string(made++), Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME);
  material->setReceiveShadows(false);
  Ogre::Pass* pass = material->getTechnique(0)->getPass(0);
  pass->setLightingEnabled(false);  // the colours are shaded already
  pass->setLineWidth(style.line_width);
  if (style.both_sides || style.lines) pass->setCullingMode(Ogre::CULL_NONE);
  if (style.see_through)
  {
    pass->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
    pass->setDepthWriteEnabled(false);
  }
  return material;
}
}  // namespace

MeshObject::MeshObject(const MeshStyle& style)
{
  mRenderOp.operationType = style.lines ? Ogre::RenderOperation::OT_LINE_LIST : Ogre::RenderOperation::OT_TRIANGLE_LIST;
  mRenderOp.useIndexes = true;
  mRenderOp.vertexData = new Ogre::VertexData;  // Ogre's render operation has no owner of its own
  mRenderOp.indexData = new Ogre::IndexData;
  Ogre::VertexDeclaration* layout = mRenderOp.vertexData->vertexDeclaration;
  layout->addElement(0, offsetof(Vertex, position), Ogre::VET_FLOAT3, Ogre::VES_POSITION);
  layout->addElement(0, offsetof(Vertex, normal), Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
  layout->addElement(0, offsetof(Vertex, color), Ogre::VET_COLOUR_ABGR, Ogre::VES_DIFFUSE);  // bytes r, g, b, a
  setMaterial(make_material(style));
  setCastShadows(false);
}

MeshObject::~MeshObject()
{
  delete mRenderOp.vertexData;
  delete mRenderOp.indexData;
  Ogre::MaterialManager::getSingleton().remove(getMaterial());
}

void MeshObject::fit(const MeshData& mesh)
{
  Ogre::HardwareBufferManager& buffers = Ogre::HardwareBufferManager::getSingleton();
  if (mesh.vertices.size() > vertices_)
  {
    vertices_ = mesh.vertices.size() + mesh.vertices.size() / 4;
    mRenderOp.vertexData->vertexBufferBinding->setBinding(
        0, buffers.createVertexBuffer(sizeof(Vertex), vertices_, Ogre::HardwareBuffer::HBU_DYNAMIC_WRITE_ONLY_DISCARDABLE));
  }
  if (mesh.indices.size() > indices_)
  {
    indices_ = mesh.indices.size() + mesh.indices.size() / 4;
    mRenderOp.indexData->indexBuffer = buffers.createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT, indices_,
                                                                 Ogre::HardwareBuffer::HBU_DYNAMIC_WRITE_ONLY_DISCARDABLE);
  }
}

void MeshObject::set(const MeshData& mesh)
{
  shown_ = !mesh.indices.empty();
  if (!shown_) return;
  fit(mesh);
  mRenderOp.vertexData->vertexBufferBinding->getBuffer(0)->writeData(0, mesh.vertices.size() * sizeof(Vertex),
                                                                     mesh.vertices.data(), true);
  mRenderOp.vertexData->vertexStart = 0;
  mRenderOp.vertexData->vertexCount = mesh.vertices.size();
  mRenderOp.indexData->indexBuffer->writeData(0, mesh.indices.size() * sizeof(std::uint32_t), mesh.indices.data(), true);
  mRenderOp.indexData->indexStart = 0;
  mRenderOp.indexData->indexCount = mesh.indices.size();
  Ogre::AxisAlignedBox box;
  for (const Vertex& v : mesh.vertices) box.merge(Ogre::Vector3(v.position));
  setBoundingBox(box);
  radius_ = std::max(box.getMinimum().length(), box.getMaximum().length());
  if (mParentNode) mParentNode->needUpdate();
}

void MeshObject::_updateRenderQueue(Ogre::RenderQueue* queue)
{
  if (shown_ && mRenderOp.indexData->indexCount > 0) SimpleRenderable::_updateRenderQueue(queue);
}

Ogre::Real MeshObject::getSquaredViewDepth(const Ogre::Camera* camera) const
{
  return mParentNode ? mParentNode->_getDerivedPosition().squaredDistance(camera->getDerivedPosition()) : 0.0f;
}

}  // namespace drill_rig_sim

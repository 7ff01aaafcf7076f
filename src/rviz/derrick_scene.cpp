// SPDX-License-Identifier: BSD-3-Clause
#include "derrick_scene.h"

#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

#include <cmath>

#include "picture/derrick_picture.h"

namespace drill_rig_sim
{
namespace
{
constexpr double least_move = 1e-3;  // of the block that is drawn [m]
}  // namespace

DerrickScene::DerrickScene(Ogre::SceneManager* manager, Ogre::SceneNode* parent)
    : manager_(manager),
      root_(parent->createChildSceneNode()),
      block_node_(root_->createChildSceneNode()),
      derrick_(MeshStyle{}),
      block_(MeshStyle{}),
      lines_(MeshStyle{true})
{
  root_->attachObject(&derrick_);
  root_->attachObject(&lines_);
  block_node_->attachObject(&block_);
}

DerrickScene::~DerrickScene()
{
  block_node_->detachAllObjects();
  root_->detachAllObjects();
  manager_->destroySceneNode(block_node_);
  manager_->destroySceneNode(root_);
}

void DerrickScene::draw(const RigData& rig)
{
  rig_ = rig;
  MeshData derrick = derrick_mesh(rig.crown_height);
  shade(derrick);
  derrick_.set(derrick);
  height_ = -1e9;
}

void DerrickScene::move_block(double height)
{
  if (std::abs(height - height_) < least_move) return;
  if (height_ == -1e9)
  {
    MeshData block = block_mesh();
    shade(block);
    block_.set(block);
  }
  height_ = height;
  block_node_->setPosition(0.0f, 0.0f, static_cast<float>(height));
  MeshData lines;
  add_lines(lines, rig_.crown_height, height, rig_.sheaves);
  lines_.set(lines);
}

void DerrickScene::clear()
{
  for (MeshObject* object : {&derrick_, &block_, &lines_}) object->show(false);
  height_ = -1e9;
}

}  // namespace drill_rig_sim

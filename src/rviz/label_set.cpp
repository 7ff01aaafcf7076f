// SPDX-License-Identifier: BSD-3-Clause
#include "label_set.h"

#include <OgreCamera.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>
#include <rviz/ogre_helpers/movable_text.h>

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
LabelSet::LabelSet(Ogre::SceneManager* manager, Ogre::SceneNode* parent) : manager_(manager), parent_(parent)
{
}

LabelSet::~LabelSet()
{
  for (Shown& label : shown_)
  {
    label.node->detachAllObjects();
    manager_->destroySceneNode(label.node);
  }
}

void LabelSet::set(const std::vector<Label>& labels)
{
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const Label& label = labels[i];
    if (i == shown_.size())
    {
      Shown& added = shown_.emplace_back();
      added.node = manager_->createSceneNode();
      added.text = std::make_unique<rviz::MovableText>(label.text, "Liberation Sans", 1.0f);
      added.caption = label.text;
      added.text->setTextAlignment(rviz::MovableText::H_LEFT, rviz::MovableText::V_CENTER);
      added.text->showOnTop(true);
      added.text->setSpaceWidth(0.3f);
      added.node->attachObject(added.text.get());
    }
    Shown& shown = shown_[i];
    if (shown.caption != label.text) shown.text->setCaption(label.text);
    shown.caption = label.text;
    const Ogre::ColourValue color(label.color.r, label.color.g, label.color.b, label.color.a);
    if (shown.text->getColor() != color) shown.text->setColor(color);
    shown.node->setPosition(label.position);
    if (i >= used_) parent_->addChild(shown.node);
  }
  for (std::size_t i = labels.size(); i < used_; ++i) parent_->removeChild(shown_[i].node);  // rviz sets visible what hangs there
  used_ = labels.size();
}

void LabelSet::scale_to(const Ogre::Camera& camera, double pixels)
{
  for (std::size_t i = 0; i < used_; ++i)
  {
    const auto size = static_cast<float>(std::max(pixels * pixel_size(camera, shown_[i].node->_getDerivedPosition()), 1e-6));
    if (std::abs(shown_[i].node->getScale().x - size) > 0.01f * size) shown_[i].node->setScale(size, size, size);
  }
}

double pixel_size(const Ogre::Camera& camera, const Ogre::Vector3& place)
{
  const Ogre::Viewport* viewport = camera.getViewport();
  const double height = viewport ? std::max(viewport->getActualHeight(), 1) : 600;
  if (camera.getProjectionType() == Ogre::PT_ORTHOGRAPHIC) return camera.getOrthoWindowHeight() / height;
  const double ahead = (place - camera.getDerivedPosition()).dotProduct(camera.getDerivedDirection());
  return 2.0 * std::max(ahead, 0.01) * std::tan(0.5 * camera.getFOVy().valueRadians()) / height;
}

}  // namespace drill_rig_sim

// SPDX-License-Identifier: BSD-3-Clause
#include "overlay_panel.h"

#include <OgreHardwarePixelBuffer.h>
#include <OgreMaterialManager.h>
#include <Overlay/OgreOverlay.h>
#include <Overlay/OgreOverlayManager.h>
#include <Overlay/OgrePanelOverlayElement.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>

#include <cstring>

namespace drill_rig_sim
{
namespace
{
constexpr int distance_from_edge = 10, room = 30;  // [pixels]
const std::string& group = Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME;
}  // namespace

OverlayPanel::OverlayPanel(Corner corner) : corner_(corner)
{
  static int made = 0;
  name_ = "drill_rig_sim/panel" + std::to_string(made++);
  Ogre::OverlayManager& overlays = Ogre::OverlayManager::getSingleton();
  overlay_ = overlays.create(name_);
  panel_ = static_cast<Ogre::PanelOverlayElement*>(overlays.createOverlayElement("Panel", name_ + "/element"));
  material_ = Ogre::MaterialManager::getSingleton().create(name_ + "/material", group);
  Ogre::Pass* pass = material_->getTechnique(0)->getPass(0);
  pass->setLightingEnabled(false);
  pass->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  pass->setDepthCheckEnabled(false);
  pass->setDepthWriteEnabled(false);
  pass->createTextureUnitState();
  panel_->setMetricsMode(Ogre::GMM_PIXELS);
  panel_->setMaterial(material_);
  overlay_->add2D(panel_);
  overlay_->setZOrder(200);
}

OverlayPanel::~OverlayPanel()
{
  Ogre::OverlayManager& overlays = Ogre::OverlayManager::getSingleton();
  overlay_->hide();
  overlay_->remove2D(panel_);
  overlays.destroyOverlayElement(panel_);
  overlays.destroy(overlay_);
  Ogre::MaterialManager::getSingleton().remove(material_);
  if (texture_) Ogre::TextureManager::getSingleton().remove(texture_);
}

void OverlayPanel::make_texture(int width, int height)
{
  if (texture_) Ogre::TextureManager::getSingleton().remove(texture_);
  texture_ = Ogre::TextureManager::getSingleton().createManual(name_ + "/texture", group, Ogre::TEX_TYPE_2D,
                                                               static_cast<unsigned>(width), static_cast<unsigned>(height), 0,
                                                               Ogre::PF_A8R8G8B8, Ogre::TU_DEFAULT);
  Ogre::TextureUnitState* unit = material_->getTechnique(0)->getPass(0)->getTextureUnitState(0);
  unit->setTexture(texture_);
  unit->setTextureFiltering(Ogre::TFO_NONE);
}

void OverlayPanel::show(const QImage& image)
{
  if (image.isNull()) return hide();
  const QImage pixels = image.convertToFormat(QImage::Format_ARGB32);
  const int width = pixels.width(), height = pixels.height();
  if (!texture_ || static_cast<int>(texture_->getWidth()) != width || static_cast<int>(texture_->getHeight()) != height)
    make_texture(width, height);
  const Ogre::HardwarePixelBufferSharedPtr buffer = texture_->getBuffer();
  buffer->blitFromMemory(Ogre::PixelBox(static_cast<unsigned>(width), static_cast<unsigned>(height), 1, Ogre::PF_A8R8G8B8,
                                        const_cast<uchar*>(pixels.constBits())));
  panel_->setDimensions(static_cast<float>(width), static_cast<float>(height));
  place();
  overlay_->show();
}

void OverlayPanel::place()
{
  const bool right = corner_ == Corner::top_right, top = corner_ != Corner::bottom_left;
  const float edge = static_cast<float>(distance_from_edge);
  panel_->setHorizontalAlignment(right ? Ogre::GHA_RIGHT : Ogre::GHA_LEFT);
  panel_->setVerticalAlignment(top ? Ogre::GVA_TOP : Ogre::GVA_BOTTOM);
  panel_->setPosition(right ? -panel_->getWidth() - edge : edge, top ? edge : -panel_->getHeight() - edge);
}

bool OverlayPanel::covers(double x, double y, double view_width, double view_height) const
{
  const Ogre::FloatRect a = area(view_width, view_height);
  return x > a.left - room && x < a.right + room && y > a.bottom - room && y < a.top + room;
}

void OverlayPanel::avoid(double x, double y, double view_width, double view_height)
{
  if (!overlay_->isVisible() || !covers(x, y, view_width, view_height)) return;
  const Corner before = corner_;
  corner_ = before == Corner::top_right ? Corner::top_left : Corner::top_right;
  if (covers(x, y, view_width, view_height)) corner_ = before;
  place();
}

void OverlayPanel::hide()
{
  overlay_->hide();
}

Ogre::FloatRect OverlayPanel::area(double view_width, double view_height) const
{
  if (!overlay_->isVisible()) return {};
  const bool right = corner_ == Corner::top_right, top = corner_ != Corner::bottom_left;
  const double width = panel_->getWidth(), height = panel_->getHeight();
  const double left = right ? 0.5 * view_width - distance_from_edge - width : distance_from_edge - 0.5 * view_width;
  const double bottom = top ? 0.5 * view_height - distance_from_edge - height : distance_from_edge - 0.5 * view_height;
  return {static_cast<float>(left), static_cast<float>(bottom + height), static_cast<float>(left + width),
          static_cast<float>(bottom)};
}

}  // namespace drill_rig_sim

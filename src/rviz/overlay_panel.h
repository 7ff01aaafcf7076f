// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_OVERLAY_PANEL_H
#define DRILL_RIG_SIM_SRC_RVIZ_OVERLAY_PANEL_H

#include <OgreCommon.h>
#include <OgreMaterial.h>
#include <OgreTexture.h>

#include <QImage>
#include <string>

namespace Ogre
{
class Overlay;
class PanelOverlayElement;
}  // namespace Ogre

namespace drill_rig_sim
{
/// A picture that stands in a corner of the view, in front of everything, pixel by pixel.
class OverlayPanel
{
public:
  enum class Corner
  {
    top_right,
    top_left,
    bottom_left
  };

  explicit OverlayPanel(Corner corner);
  ~OverlayPanel();
  OverlayPanel(const OverlayPanel&) = delete;
  OverlayPanel& operator=(const OverlayPanel&) = delete;

  /// Shows the image, or nothing where it is empty.
  void show(const QImage& image);
  void hide();
  /// Goes to the other corner at the top where it stands within 30 pixels of this place, and there is room. x, y: as in area().
  void avoid(double x, double y, double view_width, double view_height);
  /// What it covers of a view of this size: from the view's middle, x right, y up [pixels]; nothing while it is hidden.
  Ogre::FloatRect area(double view_width, double view_height) const;

private:
  void make_texture(int width, int height);
  void place();
  bool covers(double x, double y, double view_width, double view_height) const;

  Corner corner_;
  std::string name_;
  Ogre::Overlay* overlay_;
  Ogre::PanelOverlayElement* panel_;
  Ogre::MaterialPtr material_;
  Ogre::TexturePtr texture_;
};

}  // namespace drill_rig_sim

#endif

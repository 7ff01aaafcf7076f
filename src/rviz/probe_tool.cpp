// SPDX-License-Identifier: BSD-3-Clause
#include "probe_tool.h"

#include <OgreCamera.h>
#include <OgreViewport.h>
#include <rviz/display_context.h>
#include <rviz/display_group.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/viewport_mouse_event.h>

#include <cmath>
#include <pluginlib/class_list_macros.hpp>

#include "drillstring_display.h"

namespace drill_rig_sim
{
namespace
{
constexpr double pixels_beside = 8.0;  // that still hit

/// Through a place of the picture, 0 to 1 from its left upper corner. Ogre's own goes by the inverse of a projection in single
/// precision: a kilometre down it passes many pixels from that place.
Ogre::Ray ray_through(const Ogre::Camera& camera, double x, double y)
{
  if (camera.getProjectionType() != Ogre::PT_PERSPECTIVE)
    return camera.getCameraToViewportRay(static_cast<float>(x), static_cast<float>(y));
  const double high = std::tan(0.5 * camera.getFOVy().valueRadians());
  const Ogre::Vector3 ahead(static_cast<float>((2.0 * x - 1.0) * high * camera.getAspectRatio()),
                            static_cast<float>((1.0 - 2.0 * y) * high), -1.0f);
  return {camera.getDerivedPosition(), camera.getDerivedOrientation() * ahead.normalisedCopy()};
}

/// Asks every Drillstring that is shown, in groups too; whether one was hit.
bool probe(rviz::DisplayGroup& group, const Ogre::Ray& ray, double slope)
{
  bool hit = false;
  for (int i = 0; i < group.numDisplays(); ++i)
  {
    rviz::Display* display = group.getDisplayAt(i);
    if (!display->isEnabled()) continue;
    if (auto* string = dynamic_cast<DrillstringDisplay*>(display)) hit |= string->probe(ray, slope);
    if (auto* inner = dynamic_cast<rviz::DisplayGroup*>(display)) hit |= probe(*inner, ray, slope);
  }
  return hit;
}
}  // namespace

ProbeTool::ProbeTool()
{
  shortcut_key_ = 'p';
}

void ProbeTool::activate()
{
  setStatus("Click on the drillstring: its numbers there are shown. A click beside it ends that.");
}

int ProbeTool::processMouseEvent(rviz::ViewportMouseEvent& event)
{
  if (!event.leftDown())
  {
    if (event.panel->getViewController()) event.panel->getViewController()->handleMouseEvent(event);
    return 0;
  }
  const Ogre::Camera* camera = event.viewport->getCamera();
  const int width = event.viewport->getActualWidth(), height = event.viewport->getActualHeight();
  const Ogre::Ray ray = ray_through(*camera, (event.x + 0.5) / width, (event.y + 0.5) / height);
  const double slope = pixels_beside * 2.0 * std::tan(0.5 * camera->getFOVy().valueRadians()) / height;
  const bool hit = probe(*context_->getRootDisplayGroup(), ray, slope);
  setStatus(hit ? "Numbers of this place: bottom left." : "No drillstring there.");
  return Render;
}

}  // namespace drill_rig_sim

PLUGINLIB_EXPORT_CLASS(drill_rig_sim::ProbeTool, rviz::Tool)

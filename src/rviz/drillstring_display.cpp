// SPDX-License-Identifier: BSD-3-Clause
#include "drillstring_display.h"

#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>
#include <ros/names.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <tf2_ros/buffer.h>

#include <QGuiApplication>
#include <algorithm>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>

#include "derrick_scene.h"
#include "drillstring_messages.h"
#include "drillstring_properties.h"
#include "overlay_panel.h"
#include "ruler_scene.h"
#include "string_scene.h"
#include "well_scene.h"

namespace drill_rig_sim
{
namespace
{
using rviz::StatusProperty;

const ros::WallDuration ruler_period(0.1), status_period(0.5);
constexpr double another_well = 20.0;  // the hole's bottom has moved by more from one message to the next [m]

/// A topic beside another one, in its namespace.
std::string beside(const std::string& topic, const std::string& name)
{
  return ros::names::append(ros::names::parentNamespace(topic), name);
}
}  // namespace

DrillstringDisplay::DrillstringDisplay() : properties_(std::make_unique<DrillstringProperties>(this, this))
{
}

DrillstringDisplay::~DrillstringDisplay()
{
  unsubscribe();
}

void DrillstringDisplay::onInitialize()
{
  // rviz may draw once more after its window is closed, the likelier the longer a frame takes; Mesa's software renderer then
  // clears beyond a picture of no size
  if (auto* manager = dynamic_cast<rviz::VisualizationManager*>(context_))
    connect(qApp, &QGuiApplication::lastWindowClosed, manager, [manager] { manager->stopUpdate(); });
  options_ = properties_->options();
  resolve_exaggeration();
  string_scene_ = std::make_unique<StringScene>(scene_manager_, scene_node_);
  well_scene_ = std::make_unique<WellScene>(scene_manager_, scene_node_);
  ruler_scene_ = std::make_unique<RulerScene>(scene_manager_, scene_node_);
  derrick_scene_ = std::make_unique<DerrickScene>(scene_manager_, scene_node_);
  legend_ = std::make_unique<OverlayPanel>(OverlayPanel::Corner::top_right);
  probe_panel_ = std::make_unique<OverlayPanel>(OverlayPanel::Corner::bottom_left);
}

void DrillstringDisplay::onEnable()
{
  subscribe();
}

void DrillstringDisplay::onDisable()
{
  unsubscribe();
  reset();
}

void DrillstringDisplay::setTopic(const QString& topic, const QString& /*datatype*/)
{
  properties_->set_topic(topic.toStdString());
}

void DrillstringDisplay::changeTopic()
{
  unsubscribe();
  reset();
  subscribe();
}

void DrillstringDisplay::changeOptions()
{
  const std::size_t coloring = options_.coloring;
  const UnitSystem units = options_.units;
  const bool coarse = options_.coarse;
  options_ = properties_->options();
  options_.coarse = coarse;
  if (!string_scene_) return;
  resolve_exaggeration();
  if (options_.coloring != coloring || options_.units != units)
  {
    string_scene_->new_coloring();
    if (model_.complete()) string_scene_->take(model_, options_);
  }
  string_due_ = well_due_ = true;
  if (!options_.derrick) derrick_scene_->clear();
  if (!options_.legend) legend_->hide();
  told_ = ros::WallTime();
}

void DrillstringDisplay::changeCamera()
{
  camera_due_ = true;
}

void DrillstringDisplay::subscribe()
{
  const std::string topic = properties_->topic();
  if (!isEnabled() || topic.empty()) return;
  try
  {
    const auto quickly = ros::TransportHints().tcpNoDelay();
    description_ = update_nh_.subscribe(beside(topic, "rig_description"), 1, &DrillstringDisplay::hear_description, this);
    path_ = update_nh_.subscribe(beside(topic, "trajectory"), 1, &DrillstringDisplay::hear_path, this);
    truth_ = update_nh_.subscribe(beside(topic, "truth/rig_state"), 1, &DrillstringDisplay::hear_truth, this);
    controller_ = update_nh_.subscribe(beside(topic, "controller/status"), 1, &DrillstringDisplay::hear_controller, this);
    string_ = update_nh_.subscribe(topic, 1, &DrillstringDisplay::hear, this, quickly);
    setStatus(StatusProperty::Warn, "String", "no message yet");
  }
  catch (const ros::Exception& error)
  {
    unsubscribe();
    setStatus(StatusProperty::Error, "String", QString("cannot subscribe: ") + error.what());
  }
}

void DrillstringDisplay::unsubscribe()
{
  string_.shutdown();
  description_.shutdown();
  path_.shutdown();
  truth_.shutdown();
  controller_.shutdown();
}

void DrillstringDisplay::clear()
{
  if (!string_scene_) return;
  string_scene_->clear();
  well_scene_->clear();
  ruler_scene_->clear();
  derrick_scene_->clear();
  legend_->hide();
  probe_panel_->hide();
}

void DrillstringDisplay::reset()
{
  Display::reset();
  clear();
  model_.string.reset();
  model_.nodes.clear();
  model_.faults.clear();
  model_.law.reset();
  heard_ = ros::WallTime();
  string_due_ = well_due_ = model_.axis && model_.rig;
  if (isEnabled()) return;
  model_ = DrawnRig();  // what is latched comes again
}

void DrillstringDisplay::hear_description(const RigDescription::ConstPtr& m)
{
  RigData rig = to_rig_data(*m);
  const std::string problem = problem_of(rig);
  if (!problem.empty()) return setStatusStd(StatusProperty::Error, "Rig", "refused: " + problem);
  setStatusStd(StatusProperty::Ok, "Rig", std::to_string(rig.parts.size()) + " parts, bit first: " + rig.parts.front().name);
  model_.rig = std::move(rig);
  model_.floor = m->header.frame_id;
  model_.string.reset();  // the one of before has other parts
  string_scene_->new_rig(model_);
  well_scene_->forget_trail();
  derrick_scene_->clear();
  resolve_exaggeration();
  well_due_ = true;
}

void DrillstringDisplay::hear_truth(const RigTruth::ConstPtr& m)
{
  const OwnWork work(cost_);
  model_.faults = to_faults(*m);
}

void DrillstringDisplay::hear_controller(const ControllerStatus::ConstPtr& m)
{
  const OwnWork work(cost_);
  model_.law = to_law(*m);
  well_due_ = true;
}

void DrillstringDisplay::hear_path(const nav_msgs::Path::ConstPtr& m)
{
  const std::string problem = problem_of(*m);
  if (!problem.empty()) return setStatusStd(StatusProperty::Error, "Well", "refused: " + problem);
  const OwnWork work(cost_);
  HoleAxis axis = to_hole_axis(*m);
  if (model_.axis && properties_->follow() &&
      (axis.points().back().position - model_.axis->points().back().position).norm() > another_well)
    camera_due_ = true;
  model_.axis = std::move(axis);
  model_.reach_bit();
  setStatusStd(StatusProperty::Ok, "Well", std::to_string(m->poses.size()) + " places");
  well_due_ = string_due_ = true;
}

void DrillstringDisplay::hear(const DrillstringState::ConstPtr& m)
{
  const OwnWork work(cost_);
  StringData string = to_string_data(*m);
  const std::string problem = problem_of(string);
  if (!problem.empty()) return setStatusStd(StatusProperty::Error, "String", "refused: " + problem);
  heard_ = ros::WallTime::now();
  model_.string = std::move(string);
  model_.floor = m->header.frame_id;
  if (!model_.rig || !model_.axis) return;
  if (model_.reach_bit()) well_due_ = true;
  string_scene_->take(model_, options_);
  string_due_ = true;
}

bool DrillstringDisplay::place_floor()
{
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  if (model_.floor.empty()) return false;
  if (!context_->getFrameManager()->getTransform(model_.floor, ros::Time(), position, orientation))
  {
    setStatusStd(StatusProperty::Error, "Transform", "no transform from " + model_.floor + " to " + fixed_frame_.toStdString());
    return false;
  }
  if (!floor_placed_) setStatus(StatusProperty::Ok, "Transform", "of the rig floor");
  scene_node_->setPosition(position);
  scene_node_->setOrientation(orientation);
  return true;
}

void DrillstringDisplay::update(float /*wall_dt*/, float /*ros_dt*/)
{
  const ros::WallTime now = ros::WallTime::now();
  const OwnWork work(cost_);
  cost_.count_frame();
  const bool placed = place_floor();
  if (placed) draw();
  if (placed != floor_placed_ && !placed) clear();
  if (placed && !floor_placed_) string_due_ = well_due_ = true;
  floor_placed_ = placed;
  if (now - told_ > status_period)
  {
    told_ = now;
    follow_units();
    if (model_.law && controller_.getNumPublishers() == 0)  // its node is gone
    {
      model_.law.reset();
      well_due_ = true;
    }
    tell_status();
    if (placed && options_.legend) show_legend();
    if (placed) show_probe();
  }
  const rviz::ViewController* view = context_->getViewManager()->getCurrent();
  if (placed && model_.complete() && view && now - ruled_ > ruler_period)
  {
    ruled_ = now;
    choose_detail(*view->getCamera());
    const Ogre::Viewport& port = *view->getCamera()->getViewport();
    const double width = port.getActualWidth(), height = port.getActualHeight();
    keep_legend_off_bit(*view->getCamera(), width, height);
    ruler_scene_->draw(model_, options_, well_scene_->plan_distance(), probed_, *view->getCamera(),
                       {legend_->area(width, height), probe_panel_->area(width, height)});
  }
  if (camera_due_ && placed && model_.complete()) apply_camera();
}

void DrillstringDisplay::draw()
{
  if (well_due_ && model_.rig && model_.axis)
  {
    well_scene_->draw(model_, options_);
    if (options_.derrick) derrick_scene_->draw(*model_.rig);
  }
  if (string_due_ && model_.rig && model_.axis && model_.string)
  {
    model_.nodes = StringTube::place(*model_.string, *model_.axis, options_.exaggeration);
    string_scene_->draw(model_, options_);
    well_scene_->follow_bit(model_, options_, well_due_);
  }
  if (string_due_ || well_due_) context_->queueRender();
  string_due_ = well_due_ = false;
  if (model_.complete()) turn_parts();
}

void DrillstringDisplay::turn_parts()
{
  const std::shared_ptr<tf2_ros::Buffer> buffer = context_->getTF2BufferPtr();
  const std::string prefix = model_.prefix();
  const auto look_up = [&](const std::string& part) -> std::optional<geometry_msgs::Transform>
  {
    const std::string frame = prefix + part;
    if (!buffer->canTransform(model_.floor, frame, ros::Time())) return std::nullopt;
    return buffer->lookupTransform(model_.floor, frame, ros::Time()).transform;
  };
  string_scene_->turn(
      [&](const std::string& part) -> std::optional<Ogre::Quaternion>
      {
        const auto t = look_up(part);
        if (!t) return std::nullopt;
        const auto& q = t->rotation;
        return Ogre::Quaternion(static_cast<float>(q.w), static_cast<float>(q.x), static_cast<float>(q.y),
                                static_cast<float>(q.z));
      });
  if (!options_.derrick) return;
  if (const auto block = look_up("traveling_block")) derrick_scene_->move_block(block->translation.z);
}

}  // namespace drill_rig_sim

PLUGINLIB_EXPORT_CLASS(drill_rig_sim::DrillstringDisplay, rviz::Display)

// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/robot_description.h"

#include <tinyxml2.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace drill_rig_sim
{
namespace
{
using Printer = tinyxml2::XMLPrinter;
using Three = std::array<double, 3>;

struct Look
{
  const char* name;
  const char* rgba;
};
constexpr Look steel{"steel", "0.45 0.47 0.5 1"}, yellow{"yellow", "0.9 0.75 0.1 1"}, dark{"dark", "0.34 0.36 0.38 1"},
    copper{"copper", "0.8 0.56 0.32 1"};
// of a derrick, as rviz' display of this package draws it [m]
constexpr double floor_width = 9.0, leg_distance = 7.0, leg_width = 0.4, floor_thickness = 0.3;

std::string words(const Three& v)
{
  char text[80];
  std::snprintf(text, sizeof text, "%.6g %.6g %.6g", v[0], v[1], v[2]);
  return text;
}

/// Opens a visual up to its shape; close_visual() ends it.
void open_visual(const Three& at, const Three& turn, Printer& out)
{
  out.OpenElement("visual");
  out.OpenElement("origin");
  out.PushAttribute("xyz", words(at).c_str());
  out.PushAttribute("rpy", words(turn).c_str());
  out.CloseElement();
  out.OpenElement("geometry");
}

void close_visual(const Look& look, Printer& out)
{
  out.CloseElement();
  out.OpenElement("material");
  out.PushAttribute("name", look.name);
  out.OpenElement("color");
  out.PushAttribute("rgba", look.rgba);
  for (int open = 0; open < 3; ++open) out.CloseElement();
}

void add_box(const Three& middle, const Three& size, const Look& look, Printer& out)
{
  open_visual(middle, {}, out);
  out.OpenElement("box");
  out.PushAttribute("size", words(size).c_str());
  out.CloseElement();
  close_visual(look, out);
}

void add_cylinder(const Three& middle, const Three& turn, double diameter, double length, const Look& look, Printer& out)
{
  open_visual(middle, turn, out);
  out.OpenElement("cylinder");
  out.PushAttribute("radius", 0.5 * diameter);
  out.PushAttribute("length", length);
  out.CloseElement();
  close_visual(look, out);
}

void open_link(const std::string& name, Printer& out)
{
  out.OpenElement("link");
  out.PushAttribute("name", name.c_str());
}

void add_joint(const std::string& floor, const std::string& link, Printer& out)
{
  out.OpenElement("joint");
  out.PushAttribute("name", ("to_" + link).c_str());
  out.PushAttribute("type", "floating");
  for (const auto& [element, name] : {std::pair{"parent", floor}, {"child", link}})
  {
    out.OpenElement(element);
    out.PushAttribute("link", name.c_str());
    out.CloseElement();
  }
  out.CloseElement();
}

void add_derrick(const std::string& floor, double height, Printer& out)
{
  open_link(floor, out);
  add_box({0.0, 0.0, -0.5 * floor_thickness}, {floor_width, floor_width, floor_thickness}, dark, out);
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      add_box({x * leg_distance, y * leg_distance, 0.5 * height}, {leg_width, leg_width, height}, steel, out);
  add_box({0.0, 0.0, height}, {leg_distance, leg_distance, leg_width}, steel, out);
  out.CloseElement();
}

double diameter_of(const PartSpec& part)
{
  if (part.bit) return part.bit->diameter;
  return part.stabilizer ? part.stabilizer->blade_diameter : part.outer_diameter;
}

/// x runs along the string towards the bit, from the part's lower end.
void add_part(const PartSpec& part, const std::string& name, Printer& out)
{
  const double length = part.joints > 1 ? part.joints * part.joint_length : part.length;
  open_link(name, out);
  add_cylinder({-0.5 * length, 0.0, 0.0}, {0.0, M_PI_2, 0.0}, diameter_of(part), length, part.bit ? yellow : copper, out);
  out.CloseElement();
}
}  // namespace

std::string robot_description(const Scene& scene, const std::string& frame_prefix)
{
  Printer out;
  out.PushHeader(false, true);
  out.OpenElement("robot");
  out.PushAttribute("name", "drill_rig");
  const std::string floor = frame_prefix + "rig_floor", block = frame_prefix + "traveling_block",
                    drive = frame_prefix + "top_drive";
  add_derrick(floor, scene.rig.hoisting.crown_height, out);
  open_link(block, out);
  add_box({0.0, 0.0, 3.8}, {1.2, 1.8, 1.6}, yellow, out);
  out.CloseElement();
  add_joint(floor, block, out);
  open_link(drive, out);
  add_box({0.0, 0.0, 2.0}, {0.9, 0.9, 1.6}, steel, out);
  add_cylinder({0.0, 0.0, 0.6}, {}, 0.3, 1.2, dark, out);
  out.CloseElement();
  add_joint(floor, drive, out);
  for (const PartSpec& part : scene.string)
  {
    if (part.type == PartType::pipe) continue;
    const std::string name = frame_prefix + part.name;
    add_part(part, name, out);
    add_joint(floor, name, out);
  }
  out.CloseElement();
  return out.CStr();
}

}  // namespace drill_rig_sim

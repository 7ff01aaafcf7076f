// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <utility>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/needs.h"
#include "drill_rig_sim/sim/accuracy.h"

namespace drill_rig_sim
{
namespace
{
template <class... Numbers>
std::string text(const char* format, Numbers... numbers)
{
  char line[400];
  std::snprintf(line, sizeof line, format, numbers...);
  return line;
}

/// At first the range so far is small, and errors over it are large without a meaning.
std::string share_text(double share)
{
  if (share > 1.0) return "more than 100 %";
  return text(share < 0.1 ? "%.2g %%" : "%.0f %%", 100.0 * share);
}

/// An element's length with a tenth to spare, for the string bends a little more on a finer mesh, and its two digits are rounded
/// down [m].
double shorter(double length)
{
  const double unit = std::pow(10.0, std::floor(std::log10(0.9 * length)) - 1.0);
  return std::floor(0.9 * length / unit) * unit;
}

/// To two digits.
double rounded_up(double number)
{
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1.0);
  return std::ceil(number / unit) * unit;
}

/// Of the needs that a level may leave out.
std::string words_of(unsigned needs)
{
  std::string out;
  const std::pair<Need, const char*> words[] = {{need_torque, "waves of torque"},
                                                {need_bit_speed, "waves of bit speed"},
                                                {need_direction, "direction"},
                                                {need_contact, "contact"},
                                                {need_buckling, "buckling"}};
  for (const auto& [need, word] : words)
    if (needs & need) out += (out.empty() ? "" : ", ") + std::string(word);
  return out;
}
}  // namespace

const char* code_of(AccuracyDoubt doubt) noexcept
{
  switch (doubt)
  {
    case AccuracyDoubt::none:
      return "";
    case AccuracyDoubt::measured:
      return "measured_error";
    case AccuracyDoubt::confined:
      return "guided_pipe_buckles";
    case AccuracyDoubt::compression:
      return "element_compression";
    case AccuracyDoubt::twist:
      return "element_twist";
    case AccuracyDoubt::embedding:
      return "soft_wall";
    case AccuracyDoubt::slant:
      return "slanted_start";
    case AccuracyDoubt::level:
      return "level";
    case AccuracyDoubt::turn:
      return "turn_of_hole";
  }
  return "";
}

std::string text_of(const AccuracyReport& r)
{
  switch (r.doubt)
  {
    case AccuracyDoubt::none:
      return "";
    case AccuracyDoubt::measured:
      return text(
          "%s: measured error %s of its range so far, over 3 s; over 30 s %s in the average, %s in the deviation, %s in the "
          "extremes; numerics.tolerance is %.3g %%. Use only averages that are accurate enough, or double numerics.refinement "
          "(default: 1)",
          traits_of(r.output).words, share_text(r.measure).c_str(), share_text(r.statistics.mean).c_str(),
          share_text(r.statistics.deviation).c_str(), share_text(r.statistics.extremes).c_str(), 100.0 * r.allowed);
    case AccuracyDoubt::confined:
      return text(
          "guided pipe %.4g m above the bit carries %.2f times its critical buckling load, but does not bend: drag and torque "
          "are too low; use numerics.level: beam3d, or hybrid with numerics.free_length above %.4g",
          r.from_bit, r.measure, r.from_bit);
    case AccuracyDoubt::compression:
      return text(
          "an element of %.3g m, %.4g m above the bit, carries %.2f times the compression that it can represent: its bending "
          "is uncertain; use numerics.element_length: %.2g or less",
          r.element_length, r.from_bit, r.measure, shorter(r.element_length / std::sqrt(r.measure)));
    case AccuracyDoubt::twist:
      return text(
          "an element of %.3g m, %.4g m above the bit, is twisted by %.2f rad, more than 1: its torque is uncertain; use "
          "numerics.element_length: %.2g or less",
          r.element_length, r.from_bit, r.measure, shorter(r.element_length / r.measure));
    case AccuracyDoubt::embedding:
      return text(
          "%.4g m above the bit the string is %.3g mm deep in the wall, more than its clearance: side forces are too small "
          "there; use contact.stiffness: %.2g or more, in that part if it has its own contact",
          r.from_bit, 1e3 * r.measure, rounded_up(r.allowed));
    case AccuracyDoubt::level:
      return "numerics.level does not represent " + words_of(static_cast<unsigned>(r.measure)) +
             " (guided pipe has no bending, rigid pipe no waves); use hybrid or beam3d, or remove this from needs";
    case AccuracyDoubt::turn:
      return text(
          "by the rock law the hole turns by %.0f deg/30 m, but the body behind the bit allows %.0f: direction and rate of "
          "penetration are uncertain;"
          " use a smaller bend_deg, sleeve_diameter or side_cutting",
          30.0 * r.measure / degree, 30.0 * r.allowed / degree);
    case AccuracyDoubt::slant:
      return text(
          "the hole is inclined by %.0f deg at the rotary table, but the rig is upright: hook load and torque include a bend "
          "there;"
          " use a well.survey that begins vertical",
          r.measure / degree);
  }
  return "";
}

}  // namespace drill_rig_sim

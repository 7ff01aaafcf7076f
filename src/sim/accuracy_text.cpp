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
  char line[256];
  std::snprintf(line, sizeof line, format, numbers...);
  return line;
}

/// An element's length with a tenth to spare, for the string bends a little more on a finer mesh, and its two digits are rounded down [m].
double shorter(double length)
{
  const double unit = std::pow(10.0, std::floor(std::log10(0.9 * length)) - 1.0);
  return std::floor(0.9 * length / unit) * unit;
}

/// What makes the step `share` of what it is [s]; of variable ones, step 0, which go with the root of the tolerance.
std::string shorter_step(double step, double share)
{
  return step > 0.0 ? text("numerics.step: %.2g s", share * step) : text("numerics.tolerance: %.2g of what it is", share * share);
}

std::string any_shorter_step(double step)
{
  return step > 0.0 ? text("numerics.step: below %.3g s", step) : "numerics.tolerance: smaller";
}

/// Of the needs that a level may leave out.
std::string words_of(unsigned needs)
{
  std::string out;
  const std::pair<Need, const char*> words[] = {{need_torque, "waves of torque"}, {need_bit_speed, "waves of bit speed"},
                                                {need_direction, "direction"},    {need_contact, "contact"},    {need_buckling, "buckling"}};
  for (const auto& [need, word] : words)
    if (needs & need) out += (out.empty() ? "" : ", ") + std::string(word);
  return out;
}
}  // namespace

std::string text_of(const AccuracyReport& r, double step)
{
  switch (r.doubt)
  {
    case AccuracyDoubt::none: return "";
    case AccuracyDoubt::measured:
      return text("%s is off by %.2g %% of its range, as a finer model beside this one shows; numerics.tolerance: smaller, or means of longer times", traits_of(r.output).words, 100.0 * r.measure);
    case AccuracyDoubt::confined:
      return text("%.4g m above the bit guided pipe is compressed by %.2f times what it bears straight: it would buckle; numerics.level: beam3d, or hybrid with numerics.free_length beyond it",
                  r.from_bit, r.measure);
    case AccuracyDoubt::compression:
      return text("%.4g m above the bit an element of %.3g m carries %.2f times the compression that it can bend under; numerics.element_length: %.2g or less",
                  r.from_bit, r.element_length, r.measure, shorter(r.element_length / std::sqrt(r.measure)));
    case AccuracyDoubt::twist:
      return text("%.4g m above the bit an element of %.3g m is twisted by %.2f rad; numerics.element_length: %.2g or less", r.from_bit,
                  r.element_length, r.measure, shorter(r.element_length / r.measure));
    case AccuracyDoubt::embedding:
      return text("%.4g m above the bit the string is %.2g mm deep in the wall, more than its clearance; contact.stiffness: stiffer", r.from_bit,
                  1e3 * r.measure);
    case AccuracyDoubt::refused_steps:
      return text("%.0f %% of the steps had to be taken in parts; ", 100.0 * r.measure) + any_shorter_step(step);
    case AccuracyDoubt::dissipation:
      return text("the method takes %.0f %% of the energy that goes through; ", 100.0 * r.measure) + any_shorter_step(step) + ", or shorter elements";
    case AccuracyDoubt::cut:
      return text("a blade comes where the one before was in %.0f steps, too few for the waves that it leaves; ", 1.0 / r.measure) +
             shorter_step(step, 0.01 / r.measure) + " or less";
    case AccuracyDoubt::shaking:
      return text("the bent motor shakes the string three times a turn, and the method damps such waves by %.2g a second; ", r.measure) +
             shorter_step(step, std::cbrt(0.1 / r.measure)) + " or less";
    case AccuracyDoubt::waves:
    case AccuracyDoubt::load_waves:
      return text("the steps blur the %s waves by %.2g %% of its range; ", r.doubt == AccuracyDoubt::waves ? "torque's" : "hook load's", 100.0 * r.measure) +
             shorter_step(step, std::sqrt(0.02 / r.measure)) + " or less";
    case AccuracyDoubt::blows:
      return text("the bit strikes the bottom %.2g times a second: the waves of its blows are blurred, and where it goes on bouncing so are means; how much, ", r.measure) + shorter_step(step, 0.5) + " and shorter elements show";
    case AccuracyDoubt::loose:
      return text("the string came loose wound up by %.0f turns: the moment and the waves after it are off by a tenth of a second; ", r.measure) +
             shorter_step(step, 0.5) + " or less, and shorter elements";
    case AccuracyDoubt::hesitation:
      return text("the string's lower end came loose to %.2g rad/s and stuck again: when it goes hangs on the smallest waves, and so does the time of all that"
                  " follows; means and extremes hold, how far, ", r.measure) + shorter_step(step, 0.5) + " shows";
    case AccuracyDoubt::jerks:
      return text("the string sticks and slips on its walls %.2g times a second: long means hold, peaks, means of seconds and what a stop leaves are"
                  " one case of many; how far apart these are, ", r.measure) + shorter_step(step, 0.5) + " and shorter elements show";
    case AccuracyDoubt::whirl:
      return text("the string whirls: it rolls along its walls at %.2g of pure rolling, how far and where hangs on the mesh; numerics.element_length: half as long shows"
                  " what of it is the mesh's", r.measure);
    case AccuracyDoubt::level:
      return "guided pipe has no bending, rigid pipe no waves: this level does not represent " + words_of(static_cast<unsigned>(r.measure)) +
             "; numerics.level: hybrid or beam3d, or needs without it";
    case AccuracyDoubt::turn:
      return text("the bit is pressed aside so far that the hole would have to turn by %.0f deg/30 m; the body that follows the bit lets it turn by %.0f:"
                  " direction and rate of penetration are uncertain; bend_deg, sleeve_diameter or side_cutting: smaller", 30.0 * r.measure / degree, 30.0 * r.allowed / degree);
    case AccuracyDoubt::slant:
      return text("the hole leaves the table by %.0f deg from the vertical, and the rig stands upright: hook load and torque are those of a string pulled over"
                  " a corner; well.survey: vertical at the table", r.measure / degree);
  }
  return "";
}

}  // namespace drill_rig_sim

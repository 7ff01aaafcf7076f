// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_STRING_WATCH_H
#define DRILL_RIG_SIM_SIM_STRING_WATCH_H

#include <cstddef>
#include <vector>

namespace drill_rig_sim
{
class Model;
struct RigForces;
struct State;

/// A load over what is borne, where it is largest.
struct LoadShare
{
  double share = 0.0;     ///< above 1: too much
  double from_bit = 0.0;  ///< of the element's middle [m]
};

/// Loads of the string's pipe.
struct StringLoads
{
  LoadShare stress;    ///< von Mises' stress at the outer fibre over the part's yield strength
  LoadShare torque;    ///< torque over the make-up torque of the part's connections, where that is given
  LoadShare buckling;  ///< compression over the load at which the pipe buckles in its hole
  double pull_to_yield =
      0.0;  ///< further tension at which the weakest pipe yields, with its torque and bending; below 0: it does [N]
};

/// Compression over that at which an element's pipe buckles into a sine [-]; 0 in tension and above the rotary table. It buckles
/// at 2 sqrt(E I N / r), N what presses it to its wall per length, r the clearance of its body (Dawson and Paslay, J. Petroleum
/// Technology 36 (1984), 1734-1738), with N = |w_n + T k|, the weight across the hole and the tension on its bend, k towards the
/// bend's centre: a build presses compressed pipe down, a drop lifts it (He and Kyllingstad, SPE Drilling and Completion 10
/// (1995), 10-15), but at no less than 1.94 (E I w^2)^(1/3), as in a vertical hole (Lubinski 1950).
double buckling_share(const Model& model, const State& state, std::size_t e, double tension) noexcept;

/// Pipe that is buckled in its hole.
struct BuckledPipe
{
  double length = 0.0;              ///< of the elements whose buckling_share() is above 1 [m]
  double helical = 0.0;             ///< of those that buckle into a helix, above `helical_share` [m]
  double from_bit = 0.0, to = 0.0;  ///< between these distances above the bit's face [m]
};

/// A helix forms at 2 sqrt(2) sqrt(E I N / r), by the energy of a helix that the pipe is turned into (Chen, Lin, Cheatham, J.
/// Energy Resources Technology 112 (1990), 247-253).
constexpr double helical_share = 1.41421356;

BuckledPipe buckled_pipe(const Model& model, const State& state, const RigForces& forces) noexcept;

/// Compares the loads of the string with its limits. Limits are reported, not simulated: pipe beyond them does not fail.
class StringWatch
{
public:
  explicit StringWatch(const Model& model);

  /// - Stress: sqrt((|T|/A + M/W)^2 + 3 (Q/W_t)^2), T the element's tension, M the larger bending moment of its ends, Q its
  /// torque, of a
  ///   tube with the part's diameters (any book on strength of materials). Without pressure.
  /// - Pull to yield: the least over the string of A (sqrt(Y^2 - 3 (Q/W_t)^2) - M/W) - T, Y the part's yield strength. A pull on
  ///   the hook that friction or a stuck point keeps from the weakest pipe may be larger.
  /// - Buckling: buckling_share().
  StringLoads look(const Model& model, const State& state, const RigForces& forces) const noexcept;

private:
  /// Of an element, for shares without a division.
  struct Strength
  {
    double by_tension, by_moment, by_torque;  // 1/(A yield) [1/N], 1/(W yield), sqrt(3)/(W_t yield) [1/(N m)]
    double by_make_up;                        // [1/(N m)]; 0: not known
    double from_bit;                          // [m]
    double least_buckling;                    // it does not buckle below [N]
  };
  std::vector<Strength> strength_;
};

}  // namespace drill_rig_sim

#endif

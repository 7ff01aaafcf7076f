// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/hydraulics/hydraulics.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr int kMostIterations = 60;
constexpr double kSmallest = 1e-13;  // of the nominal flow: a change that is none
constexpr double kRest = 1.0;        // below it mud stands that is not pumped [Pa]

double power(double x, double exponent) noexcept
{
  return exponent == 2.0 ? x * x : std::pow(x, exponent);
}

/// root() of losses by a law, which is neither concave nor convex.
double root_of_law(double top, double by_flow, const HydraulicResistance& r, double guess) noexcept
{
  const auto excess = [&](double q) { return LossTable::Value{top - by_flow * q - r.pressure(q), -by_flow - r.slope(q)}; };
  return falling_root(excess, guess > 0.0 ? guess : r.nominal_flow, kSmallest * r.nominal_flow);
}

/// Root > 0 of top - by_flow Q - r.pressure(Q), which falls with Q and is positive at 0. On either side of the motor's leakage it
/// is concave, so Newton's iterates come down on the root from the first on that lies beyond it.
double root(double top, double by_flow, const HydraulicResistance& r, double guess) noexcept
{
  if (r.law) return root_of_law(top, by_flow, r, guess);
  const auto excess = [&](double q) { return top - by_flow * q - r.pressure(q); };
  const bool leaks = r.motor > 0.0 && excess(mud_motor_leakage) < 0.0;  // the root lies below the leakage
  const double least = leaks || r.motor <= 0.0 ? 0.0 : mud_motor_leakage, most = leaks ? mud_motor_leakage : HUGE_VAL;
  double q = guess > least && guess < most ? guess : leaks ? 0.5 * mud_motor_leakage : std::max(least, r.nominal_flow);
  for (int k = 0; k < kMostIterations; ++k)
  {
    const double slope = by_flow + r.slope(q);
    if (slope <= 0.0) break;
    const double next =
        std::clamp(q + excess(q) / slope, std::max(least, 0.1 * q), std::min(most, std::max(10.0 * q, r.nominal_flow)));
    const double change = std::abs(next - q);
    q = next;
    if (change <= kSmallest * r.nominal_flow) break;
  }
  return q;
}

/// outflow() of a volume whose mud may as well go the other way.
Outflow outflow_either_way(double capacity, double pressure, double inflow, double step, const HydraulicResistance& r,
                           double guess) noexcept
{
  const double sign = (capacity > 0.0 ? pressure + step / capacity * inflow : inflow) < 0.0 ? -1.0 : 1.0;
  const Outflow out = outflow(capacity, sign * pressure, sign * inflow, step, r, sign * guess);
  return {sign * out.flow, sign * out.pressure};
}

/// Losses of the annulus by a law, and what narrows it.
struct AnnulusLaw
{
  const SectionLosses& law;
  double narrowing;
  const LossPlaces* warm;

  LossTable::Value at(double flow, double displaced) const noexcept
  {
    const LossTable::Value plain = law.outer(flow, displaced, warm);
    return {narrowing * plain.loss, narrowing * plain.slope};
  }
};

/// The annulus with losses by a law: p + (step/capacity) (inflow - Q) = P(Q, displaced) + held, the last against the flow and as
/// much as there is. Either way.
Outflow annulus_by_law(const HydraulicCircuit& circuit, const AnnulusLaw& law, double pressure, double inflow, double displaced,
                       double step, double held, double guess) noexcept
{
  if (circuit.annulus.capacity <= 0.0) return {inflow, law.at(inflow, displaced).loss};
  const double by_flow = step / circuit.annulus.capacity, top = pressure + by_flow * inflow;
  const double driving = top - law.at(0.0, displaced).loss;
  if (std::abs(driving) <= held || driving == 0.0) return {0.0, top};
  const double sign = driving < 0.0 ? -1.0 : 1.0;
  const auto excess = [&](double q)
  {
    const LossTable::Value loss = law.at(sign * q, displaced);
    return LossTable::Value{sign * (top - loss.loss) - by_flow * q - held, -by_flow - loss.slope};
  };
  const double flow =
      sign * falling_root(excess, sign * guess > 0.0 ? sign * guess : circuit.nominal_flow, kSmallest * circuit.nominal_flow);
  return {flow, top - by_flow * flow};
}

/// What leaves a bore that falls to no pressure at the pump, drawn by its own weight.
Outflow emptied(double capacity, double pressure, double inflow, double step) noexcept
{
  return {std::max(0.0, inflow + capacity * pressure / step), 0.0};
}

/// What leaves the annulus at the flow line, and its pressure.
Outflow advance_annulus(const HydraulicCircuit& circuit, const HydraulicState& state, double inflow, double displaced,
                        double step, double held, const MudWays& ways) noexcept
{
  if (!circuit.law.any())
  {
    const HydraulicResistance outer{0.0, circuit.annulus.loss, held, 0.0, circuit.nominal_flow, circuit.exponent};
    return outflow_either_way(circuit.annulus.capacity, state.annulus_pressure, inflow + displaced, step, outer,
                              state.return_flow);
  }
  const AnnulusLaw law{circuit.law, ways.narrowing, ways.warm};
  Outflow out = annulus_by_law(circuit, law, state.annulus_pressure - ways.load, inflow, displaced, step, held,
                               state.return_flow - displaced);
  out.flow += displaced;
  out.pressure += ways.load;
  return out;
}
}  // namespace

double advance_gel(double gel, double flow, double step) noexcept
{
  const bool breaks = flow * gel_time > gel_break_volume;
  return breaks ? gel * std::exp(-flow * step / gel_break_volume) : gel + (1.0 - gel) * -std::expm1(-step / gel_time);
}

double HydraulicResistance::pressure(double flow) const noexcept
{
  return back + gel + (law ? law->inner(flow, warm).loss : loss * power(flow / nominal_flow, exponent)) +
         motor * std::min(1.0, flow / mud_motor_leakage);
}

double HydraulicResistance::slope(double flow) const noexcept
{
  return (law ? law->inner(flow, warm).slope : exponent * loss * power(flow / nominal_flow, exponent) / flow) +
         (flow < mud_motor_leakage ? motor / mud_motor_leakage : 0.0);
}

Outflow outflow(double capacity, double pressure, double inflow, double step, const HydraulicResistance& r, double guess) noexcept
{
  if (capacity <= 0.0) return {inflow, inflow > 0.0 ? r.pressure(inflow) : 0.0};
  const double by_flow = step / capacity, top = pressure + by_flow * inflow;
  const double least = r.back + r.gel;
  if (top <= least || (inflow <= 0.0 && top - least < kRest)) return {0.0, top};
  const double flow = root(top, by_flow, r, guess);
  if (r.law && flow < r.law->creep(r.warm)) return {0.0, top};  // its yield stress holds it
  return {flow, top - by_flow * flow};
}

double outflow_at(double pressure, const HydraulicResistance& r, double guess) noexcept
{
  return pressure <= r.back + r.gel ? 0.0 : root(pressure, 0.0, r, guess);
}

double orifice_flow(double area, double pressure, double density) noexcept
{
  constexpr double contraction = pi / (pi + 2.0);
  return pressure > 0.0 && density > 0.0 ? contraction * area * std::sqrt(2.0 * pressure / density) : 0.0;
}

void advance_hydraulics(const MudPumpSpec& spec, const HydraulicCircuit& circuit, double commanded, double motor_pressure,
                        double displaced, double step, double& flow, HydraulicState& state, const MudWays& ways) noexcept
{
  state.pump_flow = advance_pump(spec, state.pump_flow, commanded, step);
  state.strokes += state.pump_flow * step / spec.stroke_volume;
  const double n = circuit.nominal_flow, m = circuit.exponent;
  const SectionLosses* law = circuit.law.any() ? &circuit.law : nullptr;
  const double back = std::max(state.annulus_pressure, ways.heads.annulus) - ways.heads.bore;
  const HydraulicResistance inner{back, circuit.bore.loss, state.bore_gel * circuit.bore.gel, motor_pressure, n, m,
                                  law,  ways.warm};
  const double fill = std::min(state.pump_flow, ways.air / step);
  state.filled += fill * step;
  const double leak =
      std::min(ways.leak, state.pump_flow - fill + std::max(0.0, state.stand_pipe_pressure) * circuit.bore.capacity / step);
  Outflow bore;
  if (fill * step >= ways.air)
    bore = outflow(circuit.bore.capacity, state.stand_pipe_pressure, state.pump_flow - fill - leak, step, inner, flow);
  if (ways.warm && bore.pressure < 0.0)
    bore = emptied(circuit.bore.capacity, state.stand_pipe_pressure, state.pump_flow - fill - leak, step);
  state.relief_open = bore.pressure > spec.relief_pressure;
  if (state.relief_open) bore = {std::min(bore.flow, outflow_at(spec.relief_pressure, inner, bore.flow)), spec.relief_pressure};

  const double plug = bore.flow + leak > 0.0 ? ways.plug : 0.0;
  const double held = state.annulus_gel * circuit.annulus.gel + plug;
  const Outflow annulus = advance_annulus(circuit, state, bore.flow + leak, displaced, step, held, ways);
  flow = bore.flow;
  state.stand_pipe_pressure = bore.pressure;
  state.annulus_pressure = annulus.pressure;
  state.return_flow = annulus.flow;
  state.bore_gel = advance_gel(state.bore_gel, flow, step);
  state.annulus_gel = advance_gel(state.annulus_gel, std::abs(annulus.flow), step);
}

double equivalent_circulating_density(double density, double annulus_pressure, double depth) noexcept
{
  return depth > 1.0 ? density + annulus_pressure / (standard_gravity * depth) : density;
}

}  // namespace drill_rig_sim

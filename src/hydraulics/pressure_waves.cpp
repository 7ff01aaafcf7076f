// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/hydraulics/pressure_waves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/hydraulics/pump_strokes.h"

namespace drill_rig_sim
{
namespace
{
constexpr double in_time = 1e-9;          // [s]
constexpr double atmosphere = 101325.0;   // [Pa]
constexpr double smallest_change = 1e-7;  // of a root, over the nominal flow: Newton's next one is far below

using Value = LossTable::Value;

/// One tick of the waves.
class Tick
{
public:
  Tick(const MudPumpSpec& pump, const HydraulicCircuit& circuit, const PressureWaves& waves, const WaveLoads& loads,
       const HydraulicState& mud, PressureWaveState& state) noexcept
      : pump_(pump),
        circuit_(circuit),
        waves_(waves),
        loads_(loads),
        mud_(mud),
        s_(state),
        smallest_(smallest_change * circuit.nominal_flow),
        creep_(circuit.law.creep(loads.ways.warm)),
        bore_head_(mud.pump_flow > 0.0 ? loads.ways.heads.bore : std::min(loads.ways.heads.bore, loads.ways.heads.annulus)),
        moves_(loads.displaced != 0.0)
  {
  }

  /// @param inflow  mean of what the pump delivers in the tick [m3/s]
  void advance(double inflow) noexcept
  {
    leak_ = leak();
    cross_annulus(cross_bore(inflow));
    s_.time += waves_.tick;
  }

private:
  Value bore_loss(std::size_t node, double flow) const noexcept
  {
    const WaveLine::Node& n = waves_.bore.nodes[node];
    Value sum;
    for (std::size_t k = n.first; k < n.last; ++k)
    {
      const WaveLine::Share& share = waves_.bore.shares[k];
      const LossPlaces* warm = loads_.ways.warm;
      const Value here = warm ? circuit_.law.warm_bore[share.section].at(flow, warm->bore[share.section])
                              : waves_.bore_losses[share.section].at(flow);
      sum.loss += share.share * here.loss;
      sum.slope += share.share * here.slope;
    }
    return sum;
  }

  /// @param flow  without what the string displaces [m3/s]
  Value annulus_loss(std::size_t node, double flow) const noexcept
  {
    const WaveLine::Node& n = waves_.annulus.nodes[node];
    Value sum;
    for (std::size_t k = n.first; k < n.last; ++k)
    {
      const WaveLine::Share& share = waves_.annulus.shares[k];
      const Value here = circuit_.law.along_section(share.section, flow, loads_.displaced, loads_.ways.warm);
      sum.loss += loads_.ways.narrowing * share.share * here.loss;
      sum.slope += loads_.ways.narrowing * share.share * here.slope;
    }
    return sum;
  }

  /// annulus_loss() without flow: as the string alone drags the mud. Neighbours share their section, which is asked once.
  double still_loss(std::size_t node) noexcept
  {
    const WaveLine::Node& n = waves_.annulus.nodes[node];
    double sum = 0.0;
    for (std::size_t k = n.first; k < n.last; ++k)
    {
      const WaveLine::Share& share = waves_.annulus.shares[k];
      if (share.section != still_section_)
        still_here_ = circuit_.law.along_section(share.section, 0.0, loads_.displaced, loads_.ways.warm).loss;
      still_section_ = share.section;
      sum += loads_.ways.narrowing * share.share * still_here_;
    }
    return sum;
  }

  /// (3): driving = impedance Q + loss(Q), where a gel holds as much as it can.
  /// @param still   loss(0)
  /// @param creeps  what holds standing mud beside the gel [Pa], the loss of creeping mud: dear, asked only where it matters
  template <class Creeps, class Loss>
  double flow_between(double driving, double impedance, double gel, double still, const Creeps& creeps, const Loss& loss,
                      double guess) const noexcept
  {
    const double net = driving - still;
    const auto held = [&] { return std::abs(net) <= gel + creeps(); };
    if (std::abs(net) <= gel || (std::abs(guess) <= creep_ && held())) return 0.0;
    const double sign = net > 0.0 ? 1.0 : -1.0;
    const auto excess = [&](double q)
    {
      const Value here = loss(sign * q);
      return Value{sign * (driving - here.loss) - gel - impedance * q, -impedance - here.slope};
    };
    const double flow = falling_root(excess, std::max(sign * guess, smallest_), smallest_);
    return flow <= creep_ && held() ? 0.0 : sign * flow;
  }

  double displaced_by(std::size_t cell) const noexcept { return waves_.annulus.outside[cell] * loads_.string_speed; }

  /// Place of the hole in the string, between cells.
  static std::size_t inside(std::size_t cell, const WaveLine& line) noexcept
  {
    return std::clamp<std::size_t>(cell == PressureWaves::no_cell ? line.cells() : cell, 1, line.cells() - 1);
  }

  /// Through the hole in the string, with the pressure that it takes from the waves there: k sqrt(p - Z q) = q [m3/s].
  double leak() noexcept
  {
    if (loads_.leak_area <= 0.0) return 0.0;
    const std::size_t b = leak_in_bore_ = inside(waves_.bore_cell[loads_.leak_element], waves_.bore);
    const std::size_t a = leak_in_annulus_ = inside(waves_.annulus_cell[loads_.leak_element], waves_.annulus);
    const auto parallel = [](double one, double other) { return one * other / (one + other); };
    const double bore = parallel(waves_.bore.impedance[b - 1], waves_.bore.impedance[b]);
    const double annulus = parallel(waves_.annulus.impedance[a - 1], waves_.annulus.impedance[a]);
    const double inner =
        bore * (s_.bore_with[b - 1] / waves_.bore.impedance[b - 1] + s_.bore_against[b] / waves_.bore.impedance[b]);
    const double outer = annulus * (s_.annulus_with[a - 1] / waves_.annulus.impedance[a - 1] +
                                    s_.annulus_against[a] / waves_.annulus.impedance[a]);
    const double pressure = inner - outer, impedance = bore + annulus;
    if (pressure <= 0.0) return 0.0;
    const double k = orifice_flow(loads_.leak_area, 1.0, waves_.density), b2 = k * k * impedance;
    return 2.0 * k * k * pressure / (b2 + std::sqrt(b2 * b2 + 4.0 * k * k * pressure));
  }

  /// From pump to bit; returns the wave that arrives there.
  double cross_bore(double inflow) noexcept
  {
    const WaveLine& line = waves_.bore;
    double arriving = s_.bore_with[0];
    double flow = enter_pump(inflow);
    for (std::size_t j = 1; j < line.cells(); ++j)
    {
      const double before = line.impedance[j - 1], behind = line.impedance[j], against = s_.bore_against[j];
      const double lost = leak_ > 0.0 && j == leak_in_bore_ ? leak_ : 0.0;
      flow = flow_between(
          arriving - against - before * lost, before + behind, mud_.bore_gel * line.nodes[j].gel, 0.0,
          [&] { return bore_loss(j, creep_).loss; }, [&](double q) { return bore_loss(j, q); }, flow);
      s_.bore_against[j - 1] = arriving - 2.0 * before * (flow + lost);
      arriving = std::exchange(s_.bore_with[j], against + 2.0 * behind * flow);
    }
    return arriving;
  }

  double gas_at(double pressure) const noexcept
  {
    const double precharge = waves_.spec.dampener_pressure;
    return waves_.spec.dampener_volume * (pressure <= precharge ? 1.0 : (precharge + atmosphere) / (pressure + atmosphere));
  }

  /// The pump's end; returns the flow into the string.
  double enter_pump(double inflow) noexcept
  {
    const double impedance = waves_.bore.impedance[0], against = s_.bore_against[0];
    const auto pressure = [&](double q)
    {
      Value p = bore_loss(0, q);
      p.loss += against + impedance * q;
      p.slope += impedance;
      if (circuit_.law.lines.empty()) return p;
      const Value lines = circuit_.law.lines.at(q);
      return Value{p.loss + lines.loss, p.slope + lines.slope};
    };
    const auto below_held = [&](double q)
    {
      const Value p = pressure(q);
      return Value{s_.pump_pressure - p.loss, -p.slope};
    };
    double flow = inflow;
    if (waves_.spec.dampener_volume > 0.0) flow = flow_with_dampener(inflow, pressure);
    s_.pump_pressure = pressure(flow).loss;
    s_.relief_open = s_.pump_pressure > pump_.relief_pressure;
    if (s_.relief_open || s_.pump_pressure < 0.0)
    {
      s_.pump_pressure = s_.relief_open ? pump_.relief_pressure : 0.0;
      flow = signed_root(below_held, inflow, smallest_);
    }
    s_.gas = gas_at(s_.pump_pressure);
    s_.bore_with[0] = against + 2.0 * impedance * flow;
    return flow;
  }

  template <class Pressure>
  double flow_with_dampener(double inflow, const Pressure& pressure) const noexcept
  {
    const auto excess = [&](double q)
    {
      const Value p = pressure(q);
      const double gas = gas_at(p.loss);
      const double by_pressure = p.loss > waves_.spec.dampener_pressure ? -gas / (p.loss + atmosphere) : 0.0;
      return Value{inflow + (gas - s_.gas) / waves_.tick - q, by_pressure * p.slope / waves_.tick - 1.0};
    };
    return signed_root(excess, inflow, smallest_);
  }

  /// Nozzles, motor and pulser.
  Value bit_loss(double flow) const noexcept
  {
    const bool closed = waves_.spec.pulse_height > 0.0 &&
                        std::fmod(s_.time + waves_.tick, waves_.spec.pulse_period) < 0.5 * waves_.spec.pulse_period;
    const double pulser = closed ? waves_.spec.pulse_height / (circuit_.nominal_flow * circuit_.nominal_flow) : 0.0;
    const double nozzles = circuit_.law.nozzles(1.0, loads_.ways.warm);
    const double per_leak = loads_.motor_pressure / mud_motor_leakage;
    const bool leaks = flow < mud_motor_leakage;
    return {(nozzles + pulser) * flow * flow + (leaks ? per_leak * flow : loads_.motor_pressure),
            2.0 * (nozzles + pulser) * flow + (leaks ? per_leak : 0.0)};
  }

  /// The flow through the bit against a pressure behind it, none backwards.
  /// @param driving  wave that arrives, less what a plug holds [Pa]
  template <class Behind>
  double flow_through_bit(double driving, const Behind& behind) const noexcept
  {
    const std::size_t last = waves_.bore.cells();
    const double impedance = waves_.bore.impedance[last - 1];
    const auto excess = [&](double q)
    {
      const Value bore = bore_loss(last, q), bit = bit_loss(q), after = behind(q);
      return Value{driving - impedance * q - bore.loss - bit.loss - after.loss,
                   -impedance - bore.slope - bit.slope - after.slope};
    };
    if (excess(0.0).loss <= bore_loss(last, creep_).loss) return 0.0;
    return falling_root(excess, s_.bit_flow > 0.0 ? s_.bit_flow : circuit_.nominal_flow, smallest_);
  }

  /// From the bit to the flow line.
  void cross_annulus(double at_bit) noexcept
  {
    const WaveLine& line = waves_.annulus;
    double arriving = s_.annulus_with[0];
    double flow = pass_bit(at_bit);
    const std::size_t n = line.cells();
    for (std::size_t j = 1; j <= n; ++j)
    {
      const double before = line.impedance[j - 1], behind = j < n ? line.impedance[j] : 0.0;
      const double against = j < n ? s_.annulus_against[j] : 0.0;
      const double lost = leak_ > 0.0 && j == leak_in_annulus_ ? leak_ : 0.0;
      const double below = displaced_by(j - 1), above = (j < n ? displaced_by(j) : 0.0) + lost;
      flow = flow_between(
          arriving - against - before * below - behind * above, before + behind, mud_.annulus_gel * line.nodes[j].gel,
          moves_ ? still_loss(j) : 0.0, [] { return 0.0; }, [&](double q) { return annulus_loss(j, q); }, flow);
      s_.annulus_against[j - 1] = arriving - 2.0 * before * (flow + below);
      if (j < n) arriving = std::exchange(s_.annulus_with[j], against + 2.0 * behind * (flow + above));
      flow += lost;
    }
    s_.return_flow = flow + displaced_by(n - 1);
  }

  /// Returns the flow through the bit.
  double pass_bit(double at_bit) noexcept
  {
    const double bore = waves_.bore.impedance.back(), annulus = waves_.annulus.impedance[0];
    const double against = s_.annulus_against[0], displaced = displaced_by(0);
    const auto in_annulus = [&](double q)
    {
      Value p = annulus_loss(0, q);
      p.loss += against + annulus * (q + displaced) + loads_.ways.load;
      p.slope += annulus;
      return p;
    };
    // its own motion draws nothing from the string (hydraulics.h): not that part of a pressure below 0
    const MudWays& ways = loads_.ways;
    const double still = ways.heads.annulus;  // pressure of mud that does not flow
    const double swab = loads_.displaced < 0.0 ? ways.narrowing * circuit_.law.outer(0.0, loads_.displaced, ways.warm).loss : 0.0;
    const auto behind_bit = [&](double q)
    {
      const Value p = in_annulus(q);
      return p.loss >= still ? p : p.loss < still + swab ? Value{p.loss - swab, p.slope} : Value{still, 0.0};
    };
    const double flow = flow_through_bit(at_bit + bore_head_ - ways.plug, behind_bit);
    const double behind = in_annulus(flow).loss;
    s_.bit_pressure = std::clamp(at_bit + bore_head_, behind, behind + ways.plug);
    s_.bit_flow = flow;
    s_.bore_against.back() = at_bit - 2.0 * bore * flow;
    s_.annulus_with[0] = against + 2.0 * annulus * (flow + displaced);
    return flow;
  }

  const MudPumpSpec& pump_;
  const HydraulicCircuit& circuit_;
  const PressureWaves& waves_;
  const WaveLoads& loads_;
  const HydraulicState& mud_;
  PressureWaveState& s_;
  double smallest_;   // change of a flow that is none [m3/s]
  double creep_;      // the loss at this flow in the bore is its yield stress's [m3/s]
  double bore_head_;  // by which the bore weighs more than the reference; at rest it does not push [Pa]
  bool moves_;        // the string
  std::size_t still_section_ = static_cast<std::size_t>(-1);  // whose loss without flow is still_here_
  double still_here_ = 0.0;                                   // [Pa]
  double leak_ = 0.0;                                         // [m3/s]
  std::size_t leak_in_bore_ = 0, leak_in_annulus_ = 0;
};
}  // namespace

void advance_pressure_waves(const MudPumpSpec& pump, const HydraulicCircuit& circuit, const PressureWaves& waves,
                            double commanded, const WaveLoads& loads, double time, double step, double& flow,
                            HydraulicState& state, PressureWaveState& wave_state) noexcept
{
  const double before = state.strokes;
  state.pump_flow = advance_pump(pump, state.pump_flow, commanded, step);
  const double rate = state.pump_flow / pump.stroke_volume;
  state.strokes += rate * step;
  Tick tick(pump, circuit, waves, loads, state, wave_state);
  while (wave_state.time + waves.tick <= time + step + in_time)
  {
    const double strokes = std::max(wave_state.strokes, before + rate * (wave_state.time + waves.tick - time));
    const double delivered =
        delivered_strokes(strokes, waves.spec.cylinders) - delivered_strokes(wave_state.strokes, waves.spec.cylinders);
    wave_state.strokes = strokes;
    tick.advance(pump.stroke_volume * delivered / waves.tick);
  }
  flow = wave_state.bit_flow;
  state.stand_pipe_pressure = wave_state.pump_pressure;
  state.annulus_pressure = wave_state.bit_pressure;
  state.return_flow = wave_state.return_flow;
  state.relief_open = wave_state.relief_open;
  state.bore_gel = advance_gel(state.bore_gel, flow, step);
  state.annulus_gel = advance_gel(state.annulus_gel, std::abs(state.return_flow), step);
}

}  // namespace drill_rig_sim

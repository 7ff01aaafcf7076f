// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_FUZZ_COUNTERS_H
#define DRILL_RIG_SIM_TEST_FUZZ_COUNTERS_H

#include <cstdint>
#include <string>

namespace drill_rig_sim
{
namespace fuzz
{
/// What became of the inputs.
struct Counters
{
  std::uint64_t inputs = 0;
  std::uint64_t refused = 0;      ///< by the reader
  std::uint64_t unbuildable = 0;  ///< refused when the rig was built
  std::uint64_t too_large = 0;    ///< left out: they would take the fuzzer's time
  std::uint64_t accepted = 0;     ///< gone through to the end
  std::uint64_t failed = 0;       ///< accepted, and a frame could not be solved
};

/// This process's counts. If the environment names a file in FUZZ_COUNTS they lie in it, mapped into memory, so that they outlive
/// whatever end the process takes.
Counters& counters();

/// Ends the program with one line if `good` is false: a finding.
void check(bool good, const std::string& what);
/// Checks a refusal: at least one character, one line, nothing that a terminal obeys.
void check_refusal(const std::string& line);

}  // namespace fuzz
}  // namespace drill_rig_sim

#endif

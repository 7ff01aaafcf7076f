// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_REPORT_H
#define DRILL_RIG_SIM_ACCURACY_REPORT_H

#include <functional>
#include <string>
#include <vector>

/// Published and closed-form cases: each prints one line `case, ours, published, relative difference, bound, source`.
namespace drill_rig_sim
{
/// One figure of ours beside one that was computed or derived elsewhere.
struct CaseLine
{
  std::string name;  ///< with the unit, no comma: "tip z at P 300 N [in]"
  double ours = 0.0;
  double published = 0.0;
  double bound = 0.0;  ///< on |ours - published| / |published|; or, if `absolute`, on |ours - published|
  std::string source;  ///< paper, equation or derivation; no comma
  bool absolute = false;
};

/// Collects and prints the lines, and remembers whether all held.
class Report
{
public:
  /// Prints the line; a difference beyond the bound, or a figure that is not finite, makes the report fail.
  void add(const CaseLine& line);
  /// `published` is a band instead of a figure: holds if low <= ours <= high. The line shows the nearer limit, and the bound 0.
  void add_band(const std::string& name, double ours, double low, double high, const std::string& source);
  /// A case that could not be run (data absent): a line that reports it; no failure, but the program's exit status shows it.
  void skip(const std::string& name, const std::string& why);
  bool all_hold() const { return failed_ == 0; }
  int lines() const { return lines_; }
  int failed() const { return failed_; }
  int skipped() const { return skipped_; }

private:
  void print(const CaseLine& line, double difference, bool holds);
  int lines_ = 0;
  int failed_ = 0;
  int skipped_ = 0;
};

/// When a group is run: short ones (seconds at most) are part of ./test/run, those that need ../shared/data apart from the rest,
/// so that they show as skipped where it is absent.
enum class When
{
  fast,
  fast_with_data,
  slow
};

/// A file of cases that belong together.
struct CaseGroup
{
  const char* name;  ///< as on the command line
  When when;
  void (*run)(Report&);
};

const std::vector<CaseGroup>& case_groups();

}  // namespace drill_rig_sim

#endif

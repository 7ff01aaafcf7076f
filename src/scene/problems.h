// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_PROBLEMS_H
#define DRILL_RIG_SIM_SRC_SCENE_PROBLEMS_H

#include <map>
#include <string>
#include <vector>

#include "drill_rig_sim/well/problem.h"
#include "number_with_unit.h"

namespace drill_rig_sim
{
/// Collects what is wrong with a file, and remembers on which line each key stands so that checks between keys can name it.
class Problems
{
public:
  explicit Problems(std::string file) : file_(std::move(file)) {}

  /// Key `path` (dots and [index]) stands on `line`, counted from 1.
  void note(const std::string& path, int line) { lines_.emplace(path, is_from_outside(path) ? from_outside : line); }
  /// Key `path`, with all that is below it, was set from outside the file; messages name that instead of a line.
  void note_setting(const std::string& path) { lines_[path] = from_outside; }
  bool has(const std::string& path) const { return lines_.count(path) != 0; }
  /// A number of key `path`, whose own unit is `key_unit`, was given in another one. A station has three numbers.
  void note_unit(const std::string& path, const std::string& key_unit, const InputUnit& unit)
  {
    units_[path].push_back({key_unit, unit});
  }

  /// A problem with the key `path`, on its own line or, if it was left out, on that of the block around it.
  void add(const std::string& path, const std::string& text) { add_at(line_of(path), path, text); }
  void add_at(int line, const std::string& path, const std::string& text);

  /// A problem of add(), whose numbers are in the key's own unit; they are shown in the unit of the input.
  void add_in_input_unit(const std::string& path, const std::string& text);

  /// Adds a last problem and throws SceneError.
  [[noreturn]] void fail(int line, const std::string& path, const std::string& text);

  bool empty() const { return problems_.empty(); }
  /// Throws SceneError if there is any problem.
  void raise() const;

private:
  struct GivenUnit
  {
    std::string key_unit;
    InputUnit unit;
  };

  static constexpr int from_outside = -1;
  int line_of(std::string path) const;
  bool is_from_outside(const std::string& path) const { return line_of(path) == from_outside; }

  std::string file_;
  std::map<std::string, int> lines_;
  std::map<std::string, std::vector<GivenUnit>> units_;
  std::vector<std::string> problems_;
};

/// A file's name, which may hold any letters, for a one-line message.
std::string one_line(const std::string& file);

/// A key or name from the file, short enough for a one-line message.
std::string shortened(const std::string& text);

}  // namespace drill_rig_sim

#endif

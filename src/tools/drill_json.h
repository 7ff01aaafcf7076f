#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_JSON_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_JSON_H

#include <string>
#include <utility>
#include <vector>

namespace drill_rig_sim
{
/// A JSON object that is written in the order in which it was filled.
class Json
{
public:
  /// Shortest decimal that reads back to the same double; null if it is not finite.
  void add(const std::string& key, double value);
  void add(const std::string& key, const std::string& value);
  void add(const std::string& key, const Json& value);

  /// With two blanks of indent per level, no newline at the end.
  std::string text(int level = 0) const;

private:
  std::vector<std::pair<std::string, std::string>> members_;  // values as text
};

}  // namespace drill_rig_sim

#endif

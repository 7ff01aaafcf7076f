// SPDX-License-Identifier: BSD-3-Clause
#include "read_fill.h"

#include "drill_rig_sim/well/problem.h"
#include "drill_rig_sim/well/well_checks.h"
#include "key_table.h"
#include "yaml_reader.h"

namespace drill_rig_sim
{
namespace
{
void read_row(const YAML::Node& node, const std::string& path, const Range& allowed, std::vector<FillLevel>& fill,
              Problems& problems)
{
  FillLevel row;
  if (!node.IsSequence() || node.size() != 2)
    return problems.add(path, describe(node) + " is given, allowed: [bit depth m, level m]");
  const bool depth_read = read_number(node[0], path, allowed, "m", row.bit_depth, problems);
  if (!read_number(node[1], path, allowed, "m", row.level, problems) || !depth_read) return;
  if (!fill.empty() && row.bit_depth <= fill.back().bit_depth)
    problems.add_in_input_unit(path, "bit depth " + metres(row.bit_depth) +
                                         " is not below the row before it, needed: more than " + metres(fill.back().bit_depth));
  fill.push_back(row);
}
}  // namespace

void read_fill(const YAML::Node& node, const std::string& path, std::vector<FillLevel>& fill, Problems& problems)
{
  const Range allowed = between(0.0, deepest_well);
  if (!node.IsSequence())
  {
    FillLevel row;
    if (read_number(node, path, allowed, "m", row.level, problems) && row.level > 0.0) fill.push_back(row);
    return;
  }
  if (node.size() == 0) problems.add(path, "an empty list is given, allowed: a level in m, or rows [bit depth m, level m]");
  for (std::size_t i = 0; i < node.size(); ++i)
  {
    problems.note(item_key(path, i), line_of(node[i]));
    read_row(node[i], item_key(path, i), allowed, fill, problems);
  }
}

}  // namespace drill_rig_sim

// SPDX-License-Identifier: BSD-3-Clause
#include "read_operations.h"

#include "drill_rig_sim/scene/read_scene.h"
#include "operation_problems.h"
#include "scene_keys.h"
#include "yaml_document.h"
#include "yaml_reader.h"

namespace drill_rig_sim
{
void read_operations(const YAML::Node& list, const std::string& path, std::vector<Operation>& operations, Problems& problems)
{
  for_each_item(list, path, problems,
                [&](const YAML::Node& item, const std::string& place)
                {
                  int word = 0;
                  if (!read_kind(item, place, "do", operation_words, word, problems)) return;
                  operations.push_back(default_operation(static_cast<OperationKind>(word)));
                  read_block(item, place, operation_keys, 1u << word, operations.back(), problems);
                });
}

std::vector<Operation> parse_operations(const std::string& yaml_text, const std::string& name_for_messages, Scene present)
{
  Problems problems(name_for_messages);
  const char* nothing = "is empty, needed: at least one operation";
  if (yaml_text.find_first_not_of(" \t\r\n") == std::string::npos) problems.fail(1, "operations", nothing);
  const YAML::Node root = load_document(yaml_text, problems).root;
  YAML::Node list;
  if (root.IsMap()) list.push_back(root);
  present.program.clear();
  present.operations.clear();
  read_operations(root.IsMap() ? list : root, "operations", present.operations, problems);
  if (problems.empty() && present.operations.empty()) problems.add("operations", nothing);
  problems.raise();
  for (const Problem& problem : operation_problems(present)) problems.add_in_input_unit(problem.key, problem.text);
  problems.raise();
  return present.operations;
}

}  // namespace drill_rig_sim

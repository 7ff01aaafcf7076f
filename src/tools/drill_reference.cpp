// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/App.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "drill_command.h"
#include "drill_tables.h"

namespace drill_rig_sim
{
Command add_reference_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("reference", "prints the scene file's reference as Markdown, or another list");
  const auto of = std::make_shared<std::string>("scene");
  std::vector<std::string> names;
  for (const TableText& table : table_texts()) names.emplace_back(table.name);
  words->add_option("--of", *of, "scene, signals, modes (of the top drive), RigState.msg, RigTruth.msg or tables.py")
      ->type_name("LIST")
      ->check(CLI::IsMember(names));
  return {words, [of]
          {
            for (const TableText& table : table_texts())
              if (*of == table.name) std::fputs(table.text().c_str(), stdout);
          }};
}

}  // namespace drill_rig_sim

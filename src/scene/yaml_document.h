// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_YAML_DOCUMENT_H
#define DRILL_RIG_SIM_SRC_SCENE_YAML_DOCUMENT_H

#include <yaml-cpp/yaml.h>

#include <string>

#include "problems.h"

namespace drill_rig_sim
{
struct Document
{
  YAML::Node root;
  bool has_aliases = false;  ///< nodes may stand in several places: a change in one is one in all
};

/// Parses `text` as exactly one YAML document of bounded size. Throws SceneError, with `problems`' file and the line, if it is
/// not.
Document load_document(const std::string& text, Problems& problems);

/// `text` as yaml-cpp gets it: version 0.6.3 (Debian 11) goes on for ever, and takes all memory, where the colon of a key in
/// braces is the last character or stands before a ]. There it gets a blank.
std::string text_for_yaml(const std::string& text);

/// Whether YAML takes the unit of a number for a comment, as in `19.5 #/ft`: it would be read as a number without a unit.
bool hides_a_unit(const std::string& line);
constexpr const char* hidden_unit = "YAML reads # as the start of a comment; write lb/ instead of #/";

}  // namespace drill_rig_sim

#endif

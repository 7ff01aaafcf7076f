// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_READ_SCENE_H
#define DRILL_RIG_SIM_SCENE_READ_SCENE_H

#include <stdexcept>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// A scene or survey file that cannot be used. what() holds one line per problem,
/// `file:LINE: key: what is wrong, what is allowed`, without a newline at its end.
class SceneError : public std::runtime_error
{
public:
  explicit SceneError(std::vector<std::string> problems);
  const std::vector<std::string>& problems() const noexcept { return problems_; }

private:
  std::vector<std::string> problems_;
};

/// Reads and checks a scene file; a survey path in it counts from the scene file's folder. `settings`, such as
/// `numerics.step=0.002` or `well.sections[0].friction=0`, replace what the file says before anything is checked.
/// Either a complete, checked Scene comes back or SceneError is thrown with all problems found.
Scene read_scene(const std::string& file, const std::vector<std::string>& settings = {});

/// The same from text. `name_for_messages` stands for the file's name in messages; a survey path counts from its folder.
Scene parse_scene(const std::string& yaml_text, const std::string& name_for_messages,
                  const std::vector<std::string>& settings = {});

/// Operations for a rig that runs already: YAML as `operations` of a scene has it, a list or one block.
/// `present`: the rig's scene, with the hole's depth, the bit's depth and the block's height at present as its start.
/// Throws SceneError with all problems found: in a key, or where the operations do not fit that rig.
std::vector<Operation> parse_operations(const std::string& yaml_text, const std::string& name_for_messages, Scene present);

/// The scene file's reference as Markdown: every block with its keys, units, defaults, allowed ranges and meanings.
std::string scene_reference();

}  // namespace drill_rig_sim

#endif

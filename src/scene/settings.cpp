// SPDX-License-Identifier: BSD-3-Clause
#include "settings.h"

#include <algorithm>
#include <cctype>

#include "yaml_document.h"

namespace drill_rig_sim
{
namespace
{
struct Place
{
  std::string key;
  std::vector<std::size_t> indices;
};

// "sections[0]" -> key and indices; false if it is spelled otherwise
bool parse_place(const std::string& text, Place& place)
{
  std::size_t at = text.find('[');
  place.key = text.substr(0, at);
  while (at != std::string::npos && at < text.size())
  {
    const std::size_t end = text.find(']', at);
    if (text[at] != '[' || end == std::string::npos || end == at + 1 || end - at > 7) return false;
    std::size_t index = 0;
    for (std::size_t i = at + 1; i < end; ++i)
    {
      if (!std::isdigit(static_cast<unsigned char>(text[i]))) return false;
      index = 10 * index + static_cast<std::size_t>(text[i] - '0');
    }
    place.indices.push_back(index);
    at = end + 1;
  }
  return !place.key.empty();
}

// the node at `path`, made on the way where blocks are missing; empty message if all is well
std::string descend(YAML::Node& node, const std::string& path)
{
  std::size_t begin = 0;
  while (begin <= path.size())
  {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    Place place;
    if (!parse_place(path.substr(begin, end - begin), place))
      return "is not a key; examples: numerics.step, well.sections[0].friction";
    if (!node.IsMap() && !node.IsNull()) return "goes through a value, not a section";
    node.reset(node[place.key]);
    if (!node.IsDefined() && end < path.size()) node = YAML::Node(YAML::NodeType::Map);
    for (const std::size_t index : place.indices)
    {
      if (!node.IsSequence() || index >= node.size()) return "there is no such list item in the file";
      node.reset(node[index]);
    }
    begin = end + 1;
  }
  return "";
}
}  // namespace

void apply_settings(const YAML::Node& root, const std::vector<std::string>& settings, Problems& problems)
{
  for (const std::string& setting : settings)
  {
    const std::size_t equals = setting.find('=');
    const std::string path = setting.substr(0, equals);
    problems.note_setting(path);
    if (equals == std::string::npos)
    {
      problems.add(path, "has no value, needed: KEY=VALUE");
      continue;
    }
    if (hides_a_unit(setting))
    {
      problems.add(path, hidden_unit);
      continue;
    }
    YAML::Node node = root;
    const std::string wrong = descend(node, path);
    if (!wrong.empty())
    {
      problems.add(path, wrong);
      continue;
    }
    try
    {
      node = YAML::Load(text_for_yaml(setting.substr(equals + 1)));
    }
    catch (const YAML::Exception& e)
    {
      problems.add(path, "cannot be parsed: " + e.msg);
    }
  }
}

}  // namespace drill_rig_sim

// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_YAML_READER_H
#define DRILL_RIG_SIM_SRC_SCENE_YAML_READER_H

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "key_table.h"
#include "problems.h"

/// Reads blocks of YAML by the rows of a Table. Whatever is wrong goes to Problems; values that are wrong are left at their
/// defaults.
namespace drill_rig_sim
{
/// Line of a node, counted from 1.
int line_of(const YAML::Node& node);
/// What a node is, for messages: "text", "a list", "a block", "nothing". Its content is not shown: the file may be a wrong one.
std::string describe(const YAML::Node& node);

/// One value out of a scalar; the value stays (false, and a problem noted) if it is no such value or out of range. A number may
/// carry a unit of the same quantity as `unit`, in which `allowed` and `value` are.
bool read_number(const YAML::Node& node, const std::string& path, const Range& allowed, const std::string& unit, double& value,
                 Problems& problems);
void read_whole(const YAML::Node& node, const std::string& path, const Range& allowed, int& value, Problems& problems);
bool read_word(const YAML::Node& node, const std::string& path, const std::vector<const char*>& words, int& word,
               Problems& problems);
void read_word_set(const YAML::Node& node, const std::string& path, const std::vector<const char*>& words, unsigned& value,
                   Problems& problems);
bool read_text(const YAML::Node& node, const std::string& path, std::string& value, Problems& problems);
void read_flag(const YAML::Node& node, const std::string& path, double& value, Problems& problems);
void read_count_or_fill(const YAML::Node& node, const std::string& path, const Range& allowed, int& value, Problems& problems);

/// The entries of a block by key, each key noted with its line; problems for duplicates, keys that are no text and unknown keys
/// (`known` lists the allowed ones). Empty if the node is not a section.
std::map<std::string, YAML::Node> read_entries(const YAML::Node& node, const std::string& path,
                                               const std::vector<const char*>& known, Problems& problems);

/// Reads the word under `key` ahead of the other keys, where it decides which of them a block may have. False, and a problem
/// noted: it is missing or none of `words`.
bool read_kind(const YAML::Node& node, const std::string& path, const char* key, const std::vector<const char*>& words, int& word,
               Problems& problems);

/// Calls read(node, path) for each item of a list and notes its line.
template <class Read>
void for_each_item(const YAML::Node& node, const std::string& path, Problems& problems, const Read& read)
{
  if (!node.IsSequence())
  {
    problems.add(path, describe(node) + " is given, allowed: a list");
    return;
  }
  for (std::size_t i = 0; i < node.size(); ++i)
  {
    problems.note(item_key(path, i), line_of(node[i]));
    read(node[i], item_key(path, i));
  }
}

/// "a.b" from "a" and "b".
std::string join(const std::string& path, const std::string& key);

/// A row's unit: where the table names a placeholder (`signal`), it stands for `meant`.
std::string unit_with(const char* unit, const std::string& meant);

/// Reads one row's value into `spec`; Nested rows are left to the caller. `meant`: as for unit_with().
template <class Spec>
void read_value(const YAML::Node& node, const std::string& path, const Key<Spec>& key, Spec& spec, Problems& problems,
                const std::string& meant)
{
  const auto number = [&](double& target)
  {
    double value = 0.0;
    if (read_number(node, path, key.allowed, unit_with(key.unit, meant), value, problems)) target = value * unit_of(key.name);
  };
  if (const auto* field = std::get_if<double Spec::*>(&key.field)) number(spec.*(*field));
  if (const auto* field = std::get_if<Inside<Spec>>(&key.field)) number(field->ref(spec));
  if (const auto* field = std::get_if<int Spec::*>(&key.field)) read_whole(node, path, key.allowed, spec.*(*field), problems);
  if (const auto* field = std::get_if<std::string Spec::*>(&key.field)) read_text(node, path, spec.*(*field), problems);
  if (const auto* field = std::get_if<Flag<Spec>>(&key.field)) read_flag(node, path, spec.*(field->member), problems);
  if (const auto* field = std::get_if<CountOrFill<Spec>>(&key.field))
  {
    read_count_or_fill(node, path, key.allowed, spec.*(field->member), problems);
  }
  if (const auto* field = std::get_if<WordSet<Spec>>(&key.field))
    read_word_set(node, path, field->words, spec.*(field->member), problems);
  if (const auto* field = std::get_if<Choice<Spec>>(&key.field))
  {
    int word = 0;
    if (read_word(node, path, field->words, word, problems)) field->set(spec, word);
  }
}

/// Reads a whole block into `spec` by its table and gives back the entries, so that the caller can go on with the Nested ones.
/// `kind` is the bit of the part type or law at hand: rows of other kinds are refused. `meant`: the unit that a placeholder
/// stands for.
template <class Spec>
std::map<std::string, YAML::Node> read_block(const YAML::Node& node, const std::string& path, const Table<Spec>& table,
                                             unsigned kind, Spec& spec, Problems& problems, const std::string& meant = "")
{
  std::vector<const char*> known;
  for (const Key<Spec>& key : table.keys)
  {
    if (key.kinds & kind) known.push_back(key.name);
  }
  auto entries = read_entries(node, path, known, problems);
  if (!node.IsMap()) return entries;
  for (const Key<Spec>& key : table.keys)
  {
    if (!(key.kinds & kind)) continue;
    const auto entry = entries.find(key.name);
    if (entry != entries.end())
    {
      read_value(entry->second, join(path, key.name), key, spec, problems, meant);
    }
    else if (key.required & kind)
    {
      problems.add(join(path, key.name), std::string("is missing: ") + key.meaning);
    }
  }
  return entries;
}

}  // namespace drill_rig_sim

#endif

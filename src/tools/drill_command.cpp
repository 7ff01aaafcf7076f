#include "drill_command.h"

#include <algorithm>
#include <cstdio>
#include <locale>
#include <sstream>

namespace drill_rig_sim
{
namespace
{
std::string shown(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}
}  // namespace

std::string Arguments::text(const std::string& name, const std::string& otherwise) const
{
  const auto found = options.find(name);
  return found == options.end() ? otherwise : found->second.back();
}

std::vector<std::string> Arguments::all(const std::string& name) const
{
  const auto found = options.find(name);
  return found == options.end() ? std::vector<std::string>{} : found->second;
}

double Arguments::number(const std::string& name, double low, double high, double otherwise) const
{
  if (!has(name)) return otherwise;
  std::istringstream in(text(name));
  in.imbue(std::locale::classic());
  double value = 0.0;
  const bool whole = (in >> value) && in.peek() == std::istringstream::traits_type::eof();
  if (!whole || !(value >= low && value <= high))
  {
    throw UsageError(name + ": '" + text(name) + "' is not allowed, needed: a number from " + shown(low) + " to " + shown(high));
  }
  return value;
}

Arguments parse_arguments(const Command& command, const std::vector<std::string>& words)
{
  Arguments arguments;
  std::vector<std::string> files;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    const std::string& word = words[i];
    if (word.rfind("--", 0) != 0)
    {
      files.push_back(word);
      continue;
    }
    // both `--every 1` and `--every=1`
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const auto option = std::find_if(command.options.begin(), command.options.end(),
                                     [&](const Option& candidate) { return name == candidate.name; });
    if (option == command.options.end()) throw UsageError(name + ": unknown option; see drill " + command.name + " --help");
    std::string value;
    if (option->argument)
    {
      if (equals == std::string::npos && i + 1 == words.size()) throw UsageError(name + ": needs a value, " + option->argument);
      value = equals == std::string::npos ? words[++i] : word.substr(equals + 1);
      if (value.empty()) throw UsageError(name + ": needs a value, " + option->argument);
    }
    else if (equals != std::string::npos)
    {
      throw UsageError(name + ": takes no value");
    }
    arguments.options[name].push_back(value);
  }
  const std::size_t needed = command.positional[0] ? 1 : 0;
  if (files.size() < needed)
    throw UsageError(std::string("needs a ") + command.positional + "; see drill " + command.name + " --help");
  if (files.size() > needed)
    throw UsageError("'" + files[needed] + "' is one argument too many; see drill " + command.name + " --help");
  if (needed) arguments.file = files[0];
  return arguments;
}

std::string help(const Command& command)
{
  std::ostringstream out;
  out << "usage: drill " << command.name << (command.positional[0] ? " " : "") << command.positional
      << (command.options.empty() ? "" : " [options]") << "\n"
      << command.summary << "\n";
  for (const Option& option : command.options)
  {
    const std::string left = std::string(option.name) + (option.argument ? " " : "") + (option.argument ? option.argument : "");
    out << "  " << left << std::string(left.size() < 26 ? 26 - left.size() : 1, ' ') << option.meaning << "\n";
  }
  return out.str();
}

}  // namespace drill_rig_sim

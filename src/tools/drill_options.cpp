// SPDX-License-Identifier: BSD-3-Clause
#include "drill_options.h"

#include <cstdio>

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

std::string problem_of_text(const std::string& value)
{
  if (value.empty()) return "'' is not allowed, needed: a text";
  if (value.rfind("--", 0) == 0) return "'" + value + "' is not allowed, needed: a text that does not start with --";
  return "";
}

// CLI::Range does the same but lets nan pass.
std::string problem_of_number(const std::string& value, double low, double high)
{
  double number = 0.0;
  if (CLI::detail::lexical_cast(value, number) && number >= low && number <= high) return "";
  return "'" + value + "' is not allowed, needed: a number from " + shown(low) + " to " + shown(high);
}

std::string join(const std::vector<const CLI::App*>& commands)
{
  std::string out;
  for (std::size_t i = 0; i < commands.size(); ++i)
    out += (i == 0 ? "" : i + 1 == commands.size() ? " or " : ", ") + commands[i]->get_name();
  return out;
}

// CLI11 lists all words that it could not place, after its other checks; the first one is the cause of the others.
// What follows a `--` stands with the program itself, not with its command.
std::string problem_of_extra(const CLI::App& drill)
{
  std::string word = "--";
  for (const std::string& candidate : drill.remaining(true))
  {
    if (word == "--") word = candidate;
  }
  if (word.size() > 1 && word[0] == '-') return word.substr(0, word.find('=')) + ": unknown option";
  if (!drill.get_subcommands().empty()) return "'" + word + "' is one argument too many";
  return "'" + word + "' is not a command, allowed: " + join(drill.get_subcommands([](const CLI::App*) { return true; }));
}
// An option without its value, or a switch with one; `subject` is its name, with or without dashes.
std::string problem_of_count(const CLI::App& app, const std::string& subject)
{
  const std::string name = "--" + subject.substr(subject.find_first_not_of('-'));
  const CLI::Option* option = app.get_option_no_throw(name);
  const bool is_switch = option == nullptr || option->get_items_expected_max() == 0;
  return name + (is_switch ? ": takes no value" : ": needs a value, " + option->get_type_name());
}
}  // namespace

CLI::Option* add_file(CLI::App& command, const std::string& name, std::string& value, const std::string& meaning)
{
  return command.add_option(name, value, meaning)->type_name("")->required()->check(problem_of_text);
}

CLI::Option* add_text(CLI::App& command, const std::string& name, std::string& value, const std::string& placeholder,
                      const std::string& meaning)
{
  return command.add_option(name, value, meaning)->type_name(placeholder)->take_last()->check(problem_of_text);
}

CLI::Option* add_number(CLI::App& command, const std::string& name, std::optional<double>& value, double low, double high,
                        const std::string& placeholder, const std::string& meaning)
{
  const auto in_range = [low, high](const std::string& text) { return problem_of_number(text, low, high); };
  return command.add_option(name, value, meaning)->type_name(placeholder)->take_last()->check(in_range);
}

CLI::Option* add_settings(CLI::App& command, std::vector<std::string>& settings)
{
  return command.add_option("--set", settings, "any key of the scene, such as well.sections[0].friction=0; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)  // a word each: the next one may be the scene
      ->take_all()
      ->check(problem_of_text);
}

std::string problem_of(const CLI::App& drill, const CLI::ParseError& error)
{
  const std::vector<CLI::App*> chosen = drill.get_subcommands();
  const CLI::App& app = chosen.empty() ? drill : *chosen.front();
  const std::string name = chosen.empty() ? "drill" : "drill " + app.get_name();

  const std::string said = error.what();
  const std::string subject = said.substr(0, said.find_first_of(": "));  // CLI11 begins with what it is about
  if (dynamic_cast<const CLI::ExtrasError*>(&error)) return name + ": " + problem_of_extra(drill) + "; see " + name + " --help";
  if (dynamic_cast<const CLI::RequiredError*>(&error)) return name + ": needs a " + subject + "; see " + name + " --help";
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return name + ": " + problem_of_count(app, subject);
  return name + ": " + said;
}

}  // namespace drill_rig_sim

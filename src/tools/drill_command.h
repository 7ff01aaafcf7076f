#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_COMMAND_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_COMMAND_H

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/// How the runner's subcommands describe themselves and read their command line.
namespace drill_rig_sim
{
/// What the caller asked for cannot be done; the runner prints its one line and exits with status 2.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The equations could not be solved; the runner prints its one line and exits with status 3.
class ComputationError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

struct Option
{
  const char* name;      ///< with its dashes
  const char* argument;  ///< placeholder in the help; nullptr for a switch
  const char* meaning;
};

/// A parsed command line.
struct Arguments
{
  std::string file;  ///< the one positional argument; empty where the command takes none
  std::map<std::string, std::vector<std::string>> options;

  bool has(const std::string& name) const { return options.count(name) != 0; }
  /// The option's last value, or `otherwise` where it was not given.
  std::string text(const std::string& name, const std::string& otherwise = "") const;
  /// The same as a number from `low` to `high`. Throws UsageError with one line that names the option if it is none.
  double number(const std::string& name, double low, double high, double otherwise) const;
  /// Every value of an option that may be given more than once.
  std::vector<std::string> all(const std::string& name) const;
};

struct Command
{
  const char* name;
  const char* positional;  ///< placeholder of the positional argument; "" where there is none
  const char* summary;
  std::vector<Option> options;
  void (*run)(const Arguments&);
};

extern const Command run_command;
extern const Command check_command;
extern const Command static_command;
extern const Command survey_command;
extern const Command reference_command;

/// Reads what follows the subcommand's name. Throws UsageError with one line for an unknown option, a missing value or a missing
/// or superfluous positional argument.
Arguments parse_arguments(const Command& command, const std::vector<std::string>& words);

/// The subcommand's help.
std::string help(const Command& command);

}  // namespace drill_rig_sim

#endif

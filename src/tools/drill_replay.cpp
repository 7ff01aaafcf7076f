#include <memory>
#include <string>
#include <vector>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_python.h"
#include "drill_units.h"

namespace drill_rig_sim
{
namespace
{
struct ReplayOptions
{
  std::string record, scene, columns, from, to, start, json, csv, plots, units = "si";
  std::vector<std::string> more, left_out;
};

void replay(const ReplayOptions& options)
{
  std::vector<std::string> words;
  for (const std::string& file : options.more) add_word(words, "--with", file);
  add_word(words, "--columns", options.columns);
  add_word(words, "--from", options.from);
  add_word(words, "--to", options.to);
  for (const std::string& stretch : options.left_out) add_word(words, "--leave-out", stretch);
  add_word(words, "--start", options.start);
  add_word(words, "--json", options.json);
  add_word(words, "--csv", options.csv);
  add_word(words, "--plots", options.plots);
  add_word(words, "--units", options.units);
  words.insert(words.end(), {"--", options.record, options.scene});
  become_python("replay_command", words);
}
}  // namespace

Command add_replay_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("replay", "plays a rig's record to a scene: how far are hook load, torque and pressure off");
  const auto options = std::make_shared<ReplayOptions>();
  add_file(*words, "RECORD", options->record, "a log of WITSML or LAS, or a table (of drill run --csv --readings, with columns of known names, or with --columns)");
  add_file(*words, "SCENE", options->scene, "the scene's file; its start is where the record begins");
  words->add_option("--with", options->more, "a further file of the same well, joined by time; may be given again")->type_name("FILE")->allow_extra_args(false);
  add_text(*words, "--columns", options->columns, "FILE", "which column is what, and its unit: `hook_load: {column: HL, unit: klbf}` a line");
  add_text(*words, "--from", options->from, "TIME", "in the record where the replay begins: s, or an ISO date");
  add_text(*words, "--to", options->to, "TIME", "where it ends");
  words->add_option("--leave-out", options->left_out, "a stretch A:B of the record that is not compared (dates: A..B); may be given again")->type_name("A:B")->allow_extra_args(false);
  add_text(*words, "--start", options->start, "scene|record", "where bit and block begin; default: as the scene says, or the record where the scene has no start.bit_depth")
      ->check(CLI::IsMember({"scene", "record"}));
  add_text(*words, "--json", options->json, "FILE", "writes the residuals");
  add_text(*words, "--csv", options->csv, "FILE", "writes what was recorded and simulated");
  add_text(*words, "--plots", options->plots, "FILE", "draws both (.png, .svg, .pdf)");
  add_units(*words, options->units);
  return {words, [options] { replay(*options); }};
}

}  // namespace drill_rig_sim

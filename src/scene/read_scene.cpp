// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/scene/read_scene.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <optional>

#include "drill_rig_sim/scene/scene_problems.h"
#include "drill_rig_sim/scene/survey_file.h"
#include "drill_rig_sim/well/projection.h"
#include "drill_rig_sim/well/tie_in.h"
#include "join_depths.h"
#include "problems.h"
#include "scene_keys.h"
#include "read_hydraulics.h"
#include "read_operations.h"
#include "settings.h"
#include "survey_entry.h"
#include "text_file.h"
#include "unlikely_values.h"
#include "yaml_document.h"
#include "yaml_reader.h"

namespace drill_rig_sim
{
namespace
{
using Entries = std::map<std::string, YAML::Node>;

/// Walks a parsed document table by table and fills a Scene.
class SceneReader
{
public:
  explicit SceneReader(std::string name) : name_(std::move(name)), problems_(name_) {}

  Scene read(const std::string& text, const std::vector<std::string>& settings)
  {
    const auto [root, has_aliases] = load_document(text, problems_);
    Scene scene;
    scene.file = name_;
    problems_.note("", line_of(root));
    if (has_aliases && !settings.empty())
      problems_.fail(0, "--set", "the scene uses YAML aliases, which --set cannot change; needed: values written out");
    apply_settings(root, settings, problems_);
    problems_.raise();
    const Entries top = read_block(root, "", scene_keys, every_kind, scene, problems_);
    in(top, "", "well", [&](const YAML::Node& n, const std::string& p) { read_well(n, p, scene); });
    read_list(top, "", "formation", layer_keys, scene.formation);
    in(top, "", "mud", [&](const YAML::Node& n, const std::string& p) { read_mud(n, p, scene, problems_); });
    read_string(top, scene.string);
    in(top, "", "rig", [&](const YAML::Node& n, const std::string& p) { read_rig(n, p, scene.rig); });
    read_one(top, "", "contact", contact_keys, scene.contact);
    read_one(top, "", "trajectory", trajectory_keys, scene.trajectory);
    if (!scene.well.survey.empty() && !problems_.has("well.hole_depth")) scene.well.hole_depth = scene.well.survey.back().md;
    scene.start.bit_depth = scene.well.hole_depth;
    read_one(top, "", "start", start_keys, scene.start);
    read_one(top, "", "numerics", numerics_keys, scene.numerics);
    in(top, "", "instruments", [&](const YAML::Node& n, const std::string& p) { read_instruments(n, p, scene.instruments); });
    read_program(top, scene.program);
    in(top, "", "operations",
       [&](const YAML::Node& n, const std::string& p) { read_operations(n, p, scene.operations, problems_); });

    // checks between keys make sense only once every key alone is right
    problems_.raise();
    join_depths(scene);
    tie_in_survey(scene.well);
    project(scene);
    check(scene);
    problems_.raise();
    for (const std::string& value : unlikely_values(scene, problems_.has("well.stations")))
      scene.remarks.push_back(one_line(name_) + ": " + value);
    return scene;
  }

private:
  void check(const Scene& scene)
  {
    for (const Problem& problem : scene_problems(scene)) problems_.add_in_input_unit(problem.key, problem.text);
    check_hydraulics(scene, problems_);
    if (problems_.has("trajectory.stage_two_length") && problems_.has("trajectory.stage_two_steps"))
      problems_.add("trajectory.stage_two_steps", "is given together with stage_two_length, allowed: one of them");
  }

  // calls read(node, path) if the entry is there
  template <class Read>
  void in(const Entries& entries, const std::string& block, const char* key, const Read& read)
  {
    const auto found = entries.find(key);
    if (found != entries.end()) read(found->second, join(block, key));
  }

  template <class Spec>
  void read_one(const Entries& entries, const std::string& block, const char* key, const Table<Spec>& table, Spec& spec,
                const char* signal_unit = "")
  {
    in(entries, block, key,
       [&](const YAML::Node& n, const std::string& p) { read_block(n, p, table, every_kind, spec, problems_, signal_unit); });
  }

  template <class Spec>
  void read_list(const Entries& entries, const std::string& block, const char* key, const Table<Spec>& table,
                 std::vector<Spec>& list)
  {
    in(entries, block, key,
       [&](const YAML::Node& n, const std::string& p)
       {
         for_each_item(n, p, problems_,
                       [&](const YAML::Node& item, const std::string& path)
                       {
                         list.emplace_back();
                         read_block(item, path, table, every_kind, list.back(), problems_);
                       });
       });
  }

  void read_well(const YAML::Node& node, const std::string& path, Scene& scene)
  {
    WellSpec& well = scene.well;
    const Entries entries = read_block(node, path, well_keys, every_kind, well, problems_);
    read_list(entries, path, "sections", section_keys, well.sections);
    if (entries.count("survey") + entries.count("stations") != 1)
    {
      problems_.add(path, "both or neither of `survey` and `stations` are given, needed: one of them");
      return;
    }
    in(entries, path, "tie_in",
       [&](const YAML::Node& n, const std::string& p)
       {
         tie_in_.emplace();
         read_block(n, p, tie_in_keys, every_kind, *tie_in_, problems_);
       });
    in(entries, path, "survey", [&](const YAML::Node& n, const std::string& p) { read_survey(n, p, scene); });
    in(entries, path, "stations", [&](const YAML::Node& n, const std::string& p) { read_stations(n, p, well); });
  }

  void read_survey(const YAML::Node& node, const std::string& path, Scene& scene)
  {
    SurveyEntry entry;
    if (!read_survey_entry(node, path, entry, problems_)) return;
    std::string& file = entry.file;
    const std::size_t folder_end = name_.find_last_of('/');
    if (file[0] != '/' && folder_end != std::string::npos) file = name_.substr(0, folder_end + 1) + file;
    try
    {
      const SurveyTable table = read_survey_file(file, entry.format, tie_in_);
      scene.well.survey = table.stations;
      scene.remarks = table.remarks;
      if (table.stations.front().md > 0.0) tie_in_ = table.tie_in;
    }
    catch (const SceneError& e)
    {
      for (const std::string& problem : e.problems()) problems_.add(path, problem);
    }
  }

  // up to the first number that is wrong: what follows it is likely wrong for the same reason
  void read_stations(const YAML::Node& node, const std::string& path, WellSpec& well)
  {
    bool good = true;
    for_each_item(node, path, problems_,
                  [&](const YAML::Node& item, const std::string& p)
                  {
                    double value[3] = {};
                    if (!good) return;
                    if (!item.IsSequence() || item.size() != 3)
                    {
                      problems_.add(p, describe(item) + " is given, allowed: [measured depth m, inclination deg, azimuth deg]");
                      good = false;
                      return;
                    }
                    const Range ranges[3] = {between(0.0, deepest_well), between(0.0, 180.0), between(-360.0, 360.0)};
                    const char* units[3] = {"m", "deg", "deg"};
                    for (std::size_t i = 0; i < 3 && good; ++i)
                      good = read_number(item[i], p, ranges[i], units[i], value[i], problems_);
                    well.survey.push_back({value[0], value[1] * degree, value[2] * degree});
                  });
    if (!good || !node.IsSequence()) return;
    for (const SurveyProblem& problem : survey_problems(well.survey, tie_in_))
      problems_.add_in_input_unit(item_key(path, problem.station), problem.text);
  }

  // puts the hole above a first station that is tied in
  void tie_in_survey(WellSpec& well)
  {
    const std::string problem = tie_in_ ? tie_survey_in(*tie_in_, well.survey) : "";
    if (!problem.empty()) problems_.add(problems_.has("well.tie_in") ? "well.tie_in" : "well.survey", problem);
    problems_.raise();
  }

  // goes on from the last station to the hole's bottom
  void project(Scene& scene)
  {
    const std::string done = project_survey(scene.well);
    if (done.empty()) return;
    scene.remarks.push_back(one_line(name_) + ": " + done);
    const std::vector<SurveyProblem> found = survey_problems(scene.well.survey);
    if (!found.empty()) problems_.add("well.project", done + "; " + found.front().text);
    problems_.raise();
  }

  void read_string(const Entries& top, std::vector<PartSpec>& parts)
  {
    in(top, "", "string",
       [&](const YAML::Node& n, const std::string& p)
       {
         for_each_item(n, p, problems_,
                       [&](const YAML::Node& item, const std::string& path)
                       {
                         parts.emplace_back();
                         read_part(item, path, parts.back());
                       });
       });
  }

  void read_part(const YAML::Node& node, const std::string& path, PartSpec& part)
  {
    int word = 0;
    if (!read_kind(node, path, "type", part_type_words, word, problems_)) return;
    const auto type = static_cast<PartType>(word);
    if (type == PartType::bit) part.bit.emplace();
    if (type == PartType::mud_motor) part.motor.emplace();
    if (type == PartType::stabilizer) part.stabilizer.emplace();
    if (type == PartType::mwd) part.mwd.emplace();
    if (type == PartType::pipe) part.pipe.emplace();
    if (type == PartType::rotary_steerable) part.steerable.emplace();
    const Entries entries = read_block(node, path, part_keys, 1u << word, part, problems_);
    in(entries, path, "contact",
       [&](const YAML::Node& n, const std::string& p)
       {
         part.contact.emplace();
         read_block(n, p, part_contact_keys, every_kind, *part.contact, problems_);
       });
    if (part.bit)
    {
      in(entries, path, "nozzles",
         [&](const YAML::Node& n, const std::string& p) { read_nozzles(n, p, part.bit->nozzles, problems_); });
      read_one(entries, path, "bottom", bit_bottom_keys, part.bit->bottom);
      in(entries, path, "torque", [&](const YAML::Node& n, const std::string& p) { read_bit_torque(n, p, part.bit->torque); });
      const BitLawTraits law = traits_of(part.bit->torque.model);
      if (entries.count("bottom") && law.by_cut)
        problems_.add(join(path, "bottom"), std::string("has no effect with the ") + law.word +
                                                " torque model, which computes the weight on bit; leave it out");
    }
    if (part.stiffness.axial > 0.0 && entries.count("poisson_ratio"))
      problems_.add(join(path, "poisson_ratio"),
                    "is given together with the stiffnesses, which define it, allowed: one of the two");
    finish_length(entries, path, part);
  }

  void read_program(const Entries& top, std::vector<ProgramStep>& program)
  {
    in(top, "", "program",
       [&](const YAML::Node& n, const std::string& p)
       {
         for_each_item(n, p, problems_,
                       [&](const YAML::Node& line, const std::string& path)
                       {
                         program.emplace_back();
                         read_block(line, path, program_keys, every_kind, program.back(), problems_, unit_of_fault(line));
                       });
       });
  }

  // of the magnitude of a program line's fault
  static std::string unit_of_fault(const YAML::Node& line)
  {
    const auto word_of = [&](const char* key)
    { return line.IsMap() && line[key].IsDefined() && line[key].IsScalar() ? line[key].Scalar() : std::string(); };
    return unit_of(word_of("fault"), word_of("fault_target"));
  }

  void read_bit_torque(const YAML::Node& node, const std::string& path, BitTorqueSpec& torque)
  {
    int word = static_cast<int>(torque.model);
    if (node.IsMap() && node["model"].IsDefined() && !read_kind(node, path, "model", bit_torque_words, word, problems_)) return;
    read_block(node, path, bit_torque_keys, 1u << word, torque, problems_);
  }

  // a part has either one length or joints of one length
  void finish_length(const Entries& entries, const std::string& path, PartSpec& part)
  {
    const bool has_length = entries.count("length") != 0;
    const bool has_joints = entries.count("joints") != 0 || entries.count("joint_length") != 0;
    if (part.type == PartType::pipe || part.type == PartType::collar)
    {
      if (has_length == has_joints)
        problems_.add(path,
                      "both or neither of `length` and `joints` are given, needed: `length`, or `joints` and `joint_length`");
      if (has_joints && !has_length && entries.count("joints") + entries.count("joint_length") != 2)
      {
        problems_.add(path, "only one of `joints` and `joint_length` is given, needed: both");
      }
    }
    if (has_joints)
    {
      part.length = part.joints * part.joint_length;
    }
    else
    {
      part.joints = 1;
      part.joint_length = part.length;
    }
  }

  void read_rig(const YAML::Node& node, const std::string& path, RigSpec& rig)
  {
    const Entries entries = read_block(node, path, rig_keys, every_kind, rig, problems_);
    read_one(entries, path, "hoisting", hoisting_keys, rig.hoisting);
    read_top_drive(entries, path, rig.top_drive);
    in(entries, path, "mud_pump",
       [&](const YAML::Node& n, const std::string& p) { read_mud_pump(n, p, rig.mud_pump, problems_); });
    read_one(entries, path, "heave", heave_keys, rig.heave);
  }

  void read_top_drive(const Entries& entries, const std::string& path, TopDriveSpec& drive)
  {
    in(entries, path, "top_drive",
       [&](const YAML::Node& n, const std::string& p)
       {
         const Entries inside = read_block(n, p, top_drive_keys, every_kind, drive, problems_);
         read_one(inside, p, "soft_torque", soft_torque_keys, drive.soft_torque);
         read_one(inside, p, "z_torque", z_torque_keys, drive.z_torque);
       });
  }

  void read_instruments(const YAML::Node& node, const std::string& path, InstrumentsSpec& instruments)
  {
    const Entries entries = read_block(node, path, instruments_keys, every_kind, instruments, problems_);
    read_one(entries, path, "mwd", mwd_keys, instruments.mwd);
    read_one(entries, path, "toolface", toolface_keys, instruments.toolface);
    read_one(entries, path, "dynamics", dynamics_keys, instruments.dynamics);
    in(entries, path, "surface",
       [&](const YAML::Node& n, const std::string& p)
       {
         const Entries gauges = read_block(n, p, surface_keys, every_kind, instruments, problems_);
#define GAUGE(type, name, ...) read_one(gauges, p, #name, keys_of(instruments.name), instruments.name, unit_of(Gauge::name));
#include "drill_rig_sim/scene/signal_list.h"
       });
  }

  std::string name_;
  Problems problems_;
  std::optional<TieIn> tie_in_;
};
}  // namespace

Scene parse_scene(const std::string& yaml_text, const std::string& name_for_messages, const std::vector<std::string>& settings)
{
  return SceneReader(name_for_messages).read(yaml_text, settings);
}

Scene read_scene(const std::string& file, const std::vector<std::string>& settings)
{
  const TextFile text = read_text_file(file, "a scene file");
  Scene scene = parse_scene(text.text, file, settings);
  if (!text.remark.empty()) scene.remarks.insert(scene.remarks.begin(), text.remark);
  return scene;
}

}  // namespace drill_rig_sim

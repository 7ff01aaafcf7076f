// SPDX-License-Identifier: BSD-3-Clause
#include "survey_witsml.h"

#include <tinyxml2.h>

#include <algorithm>
#include <utility>

#include "drill_rig_sim/well/well_checks.h"

namespace drill_rig_sim
{
namespace
{
using tinyxml2::XMLElement;

// Elements and attributes of a document: some 200 MB once they are loaded. A station has up to a hundred.
constexpr std::ptrdiff_t most_parts = 2000000;
constexpr std::array<const char*, survey_quantities> elements = {"md", "incl", "azi", "dispNs", "dispEw", "tvd"};

// an element's name without its namespace's prefix, in small letters: WITSML 2.0 begins each with a capital one
std::string name_of(const XMLElement& element)
{
  const std::string name = element.Name();
  return lowered(name.substr(name.find(':') + 1));  // npos + 1 is 0
}

std::string text_of(const XMLElement* element)
{
  const char* text = element ? element->GetText() : nullptr;
  if (!text) return "";
  const std::string whole = text;
  const std::size_t first = whole.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? "" : whole.substr(first, whole.find_last_not_of(" \t\r\n") - first + 1);
}

std::vector<const XMLElement*> children_of(const XMLElement& parent, const std::string& name)
{
  std::vector<const XMLElement*> found;
  for (const XMLElement* child = parent.FirstChildElement(); child; child = child->NextSiblingElement())
    if (name_of(*child) == lowered(name)) found.push_back(child);
  return found;
}

const XMLElement* child_of(const XMLElement& parent, const std::string& name)
{
  const std::vector<const XMLElement*> found = children_of(parent, name);
  return found.empty() ? nullptr : found.front();
}

// the document in the answer of a server (SOAP), "" where there is none
std::string answer_in(const XMLElement& element)
{
  if (name_of(element) == "xmlout")
  {
    const std::string text = text_of(&element);
    return text.empty() || text[0] != '<' ? "" : text;
  }
  for (const XMLElement* child = element.FirstChildElement(); child; child = child->NextSiblingElement())
  {
    std::string text = answer_in(*child);
    if (!text.empty()) return text;
  }
  return "";
}

// The one trajectory of a document; nullptr and a problem where there is none, or one of several would have to be chosen.
const XMLElement* trajectory_of(const XMLElement& root, Problems& problems)
{
  if (name_of(root) == "trajectory") return &root;
  const std::vector<const XMLElement*> found = children_of(root, "trajectory");
  if (found.size() == 1) return found.front();
  if (found.empty())
  {
    problems.add_at(root.GetLineNum(), "",
                    "the document has no trajectory, needed: a trajectory of WITSML 1.3.1.1, 1.4.1.1 or 2.0, or a table");
    return nullptr;
  }
  std::string names;
  for (const XMLElement* trajectory : found)
    names += (names.empty() ? "" : ", ") + shortened(text_of(child_of(*trajectory, "name")));
  problems.add_at(found[1]->GetLineNum(), "trajectory",
                  "the document has " + std::to_string(found.size()) + " trajectories (" + names + "), allowed: one");
  return nullptr;
}

// a station's cells; a value without a unit that is known is a problem
SurveyRow row_of(const XMLElement& station, Problems& problems)
{
  SurveyRow row;
  row.line = station.GetLineNum();
  for (std::size_t i = 0; i < survey_quantities; ++i)
  {
    const XMLElement* element = child_of(station, elements[i]);
    row.cells[i] = text_of(element);
    row.units[i] = is_angle(i) ? angle_unit("deg") : length_unit("m");  // of what is missing
    if (!element || row.cells[i].empty()) continue;
    const char* uom = element->Attribute("uom");
    row.units[i] = is_angle(i) ? angle_unit(uom ? uom : "") : length_unit(uom ? uom : "");
    if (row.units[i] || !problems.empty()) continue;
    problems.add_at(element->GetLineNum(), elements[i],
                    uom ? "unit \"" + shortened(uom) + "\" " + why_no_unit(is_angle(i), uom)
                        : "has no unit (uom), allowed: " + survey_unit_names(is_angle(i)));
  }
  return row;
}

// in order of their depth, whatever it is of the document; reported where the document goes up and down
void sort_by_depth(SurveyRows& survey)
{
  std::vector<std::pair<double, SurveyRow>> rows;
  for (SurveyRow& row : survey.rows)
  {
    double md = 0.0;
    if (read_cell(row.cells[survey_md], false, md) != CellKind::number) md = 0.0;
    rows.emplace_back(md * row.units[survey_md]->factor(), std::move(row));
  }
  const auto is_less_deep = [](const auto& a, const auto& b) { return a.first < b.first; };
  const auto out_of_order = std::is_sorted_until(rows.begin(), rows.end(), is_less_deep);
  if (out_of_order != rows.end() && !std::is_sorted(rows.rbegin(), rows.rend(), is_less_deep))
    survey.remarks.push_back("stations were sorted by depth; the first one out of order: md " +
                             out_of_order->second.cells[survey_md]);
  std::stable_sort(rows.begin(), rows.end(), is_less_deep);
  for (std::size_t i = 0; i < rows.size(); ++i) survey.rows[i] = std::move(rows[i].second);
}

void read_stations(const XMLElement& trajectory, SurveyRows& survey, Problems& problems)
{
  int rejected = 0;
  for (const XMLElement* station : children_of(trajectory, "trajectoryStation"))
  {
    if (lowered(text_of(child_of(*station, "statusTrajStation"))) == "rejected")
      ++rejected;
    else if (survey.rows.size() <= most_stations)
      survey.rows.push_back(row_of(*station, problems));
    if (!problems.empty()) return;
  }
  if (rejected > 0) survey.remarks.push_back("stations whose status is `rejected` were left out: " + std::to_string(rejected));
  if (survey.rows.empty()) problems.add_at(trajectory.GetLineNum(), "trajectory", "has no stations, needed: two or more");
}

// a tie-in is one of all its columns: names of those that the first station lacks are none
void name_columns(SurveyRows& survey)
{
  for (std::size_t i = 0; i < survey_quantities; ++i)
    if (i < needed_quantities || !survey.rows.front().cells[i].empty()) survey.names[i] = elements[i];
}

// what the document says of the trajectory as a whole: `actual`, `model` or `plan`; of WITSML 2 `planned`, `simulated`
void add_state(const XMLElement& trajectory, bool plan, SurveyRows& survey)
{
  const XMLElement* common = child_of(trajectory, "commonData");
  std::string state = common ? lowered(text_of(child_of(*common, "itemState"))) : "";
  for (const char* name : {"existence", "existenceKind"})
    if (state.empty()) state = lowered(text_of(child_of(trajectory, name)));
  const bool is_actual = state == "actual", is_other = state == "model" || state == "simulated" || state.substr(0, 4) == "plan";
  if (plan ? is_actual : is_other)
    survey.remarks.push_back("the state of the trajectory is `" + state + "`: it is read as the " + (plan ? "plan" : "survey"));
}

bool is_within_bounds(const std::string& text, Problems& problems)
{
  const auto parts = std::count_if(text.begin(), text.end(), [](char c) { return c == '<' || c == '='; });
  if (parts <= most_parts) return true;
  problems.add_at(0, "", "has more than " + std::to_string(most_parts) + " elements and attributes, needed: a trajectory");
  return false;
}
}  // namespace

SurveyRows read_survey_witsml(const std::string& text, const SurveyFormat& format, Problems& problems)
{
  SurveyRows survey;
  for (const SurveyColumn* column : {&format.md, &format.inclination, &format.azimuth, &format.north, &format.east, &format.tvd})
    if (problems.empty() && !(column->column.empty() && column->unit.empty()))
      problems.add_at(0, "columns", "has no effect on a WITSML trajectory, which defines its own; leave it out");
  if (problems.empty() && !format.delimiter.empty())
    problems.add_at(0, "delimiter", "has no effect on a WITSML trajectory; leave it out");
  if (!problems.empty() || !is_within_bounds(text, problems)) return survey;
  tinyxml2::XMLDocument document;  // knows the five entities of XML only: a document cannot define others
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS || !document.RootElement())
  {
    problems.add_at(document.ErrorLineNum(), "", "is not an XML document, needed: a WITSML trajectory or a table");
    return survey;
  }
  const std::string answer = answer_in(*document.RootElement());
  if (!answer.empty()) return read_survey_witsml(answer, format, problems);
  const XMLElement* trajectory = trajectory_of(*document.RootElement(), problems);
  if (!trajectory) return survey;
  const std::string reference = text_of(child_of(*trajectory, "aziRef"));
  if (reference == "grid north" || reference == "magnetic north")
    survey.remarks.push_back(north_remark(reference.substr(0, reference.find(' '))));
  add_state(*trajectory, format.plan, survey);
  survey.taken = "read as a WITSML trajectory";
  read_stations(*trajectory, survey, problems);
  if (!problems.empty()) return survey;
  sort_by_depth(survey);
  name_columns(survey);
  return survey;
}

}  // namespace drill_rig_sim

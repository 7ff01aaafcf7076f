// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/math/unit_table.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

#include "drill_rig_sim/math/latin_letters.h"

namespace drill_rig_sim
{
namespace
{
using exact::barrel, exact::foot, exact::gallon, exact::gravity, exact::inch, exact::pound, exact::pound_force, exact::psi,
    exact::turn, exact::uk_gallon;

constexpr bool rare = false;
constexpr long double minute = 60.0L, hour = 3600.0L, day = 86400.0L;
constexpr long double litre = 1e-3L;
constexpr long double deg = turn / 360.0L, rev_per_minute = turn / 60.0L;
constexpr long double pound_foot = pound_force * foot;          // [N m]
constexpr long double pound_per_gallon = pound / gallon;        // [kg/m3]
constexpr long double pound_per_foot = pound / foot;            // [kg/m]
constexpr long double foot3 = foot * foot * foot;               // [m3]
constexpr long double short_ton = 2000.0L, long_ton = 2240.0L;  // in pounds
constexpr long double mercury = 133.322387415L;                 // a millimetre of it at 0 degC (conventional) [Pa]
constexpr long double fahrenheit = 5.0L / 9.0L;                 // a difference [K]
constexpr long double survey_foot = 1200.0L / 3937.0L;          // of the USA, until 2022 [m]

// clang-format off
// of sizes, times and forces
std::vector<UnitFamily> first_families()
{
  return {
  {"a length", {
    {"m", 1.0L, "metre metres meter meters mtr mtrs mts mrt metro metros metri"}, {"mm", 1e-3L}, {"cm", 1e-2L}, {"km", 1e3L},
    {"ft", foot, "feet foot f ift ' fuss pied pieds pie pies piedi fot fut futy"}, {"in", inch, "inch inches \""},
        {"ftUS", survey_foot, "usft us.ft ft.us ussft us.survey.ft us.survey.feet ussurveyft ussurveyfeet ftsurvey"},
    {"yd", 3.0L * foot, "yard yards", rare}}},
  {"a mass", {
    {"kg", 1.0L}, {"g", 1e-3L}, {"t", 1e3L, "te tonne tonnes metric.ton metric.tons kkg"}, {"lbm", pound, "lb lbs pound pounds"},
        {"klbm", 1e3L * pound, "klb klbs"},
    {"tonUS", short_ton * pound, "short.ton short.tons ston stons"}, {"tonUK", long_ton * pound, "long.ton long.tons"}},
    {{"ton tons", "t, tonUS or tonUK"}}},
  {"a time", {
    {"s", 1.0L, "sec secs second seconds second(s) sek sekunde sekunden secondes segundo segundos"},
        {"ms", 1e-3L, "msec millisecond milliseconds millisekunden millisecondes milisegundos"},
        {"min", minute, "mins minute minutes minute(s) minuten minutos mn"},
    {"h", hour, "hr hrs hour hours hour(s) stunden heures horas ch chas"}, {"d", day, "day days"}, {"us", 1e-6L, "usec", rare}}},
  {"an angle", {
    {"rad", 1.0L, "rads radian radians"},
        {"deg", deg, "degs degree degrees dega ddeg grados graus grader gradi graden degre degres"},
        {"rev", turn, "revs"},
        {"gon", turn / 400.0L, "gons"}},
    {{"grad grads", "gon or deg"}}},
  {"a force", {
    {"N", 1.0L, "newton newtons"}, {"daN", 10.0L}, {"kN", 1e3L, "k.n kilonewton kilonewtons"}, {"MN", 1e6L},
        {"kgf", gravity, "kg kp"},
    {"tf", 1e3L * gravity, "kkgf t te tonne tonnes tonnef tonne.f kkg metric.ton metric.tons metricton metrictons ton(metric) "
        "tonf.metric tonfm 1000.kgf 1000kgf 1000.kg 1000kg"},
    {"lbf", pound_force, "lb lbs lbsf lb.f pound pounds pounds.force poundforce"},
    {"klbf", 1e3L * pound_force, "klb klbs klbsf klbm klb.f kip kips k.lb k.lbs k.lbf kpound kpounds kilopounds 1000.lbf "
        "1000.lb 1000.lbs 1000lbf 1000lb 1000lbs"},
    {"tonfUS", short_ton * pound_force, "ustonf ton(us) tons(us) ston stons short.ton short.tons us.ton us.tons"},
    {"tonfUK", long_ton * pound_force, "uktonf ton(uk) tons(uk) long.ton long.tons"},
    {"kdaN", 1e4L, "kdn 1000.dan 10.kn", rare}, {"Mgf", 1e3L * gravity, "", rare}, {"gf", 1e-3L * gravity, "", rare},
        {"dyne", 1e-5L, "", rare}, {"kdyne", 1e-2L, "", rare},
    {"ozf", pound_force / 16.0L, "", rare}},
    {{"ton tons tonf tonsf kton mt", "tonfUS (2000 lbf), tonfUK (2240 lbf) or 1000 kgf (tf)"},
     {"mlbf mlb mlbs", "klbf (1000 lbf); M is a thousand in some files, a million in others"}}},
  {"a torque", {
    {"N.m", 1.0L, "nm m.n"}, {"daN.m", 10.0L, "danm m.dan mdan"}, {"kN.m", 1e3L, "knm m.kn mkn"},
        {"kgf.m", gravity, "kg.m kgm m.kgf kp.m"},
        {"lbf.in", pound_force * inch, "lb.in in.lbf in.lb in.lbs"},
    {"ft.lbf", pound_foot, "ft.lb ft.lbs lbf.ft lb.ft lbs.ft ftlb ftlbs ftlbf lbft foot.pound foot.pounds"},
    {"kft.lbf", 1e3L * pound_foot, "kft.lb kft.lbs klbf.ft klb.ft klbs.ft kftlb kftlbs kftlbf klbft ft.klbf ft.klb ft.klbs "
        "ft.kip ft.kips kip.ft kips.ft k.lb.ft k.lbs.ft k.lbf.ft "
      "k.ft.lb k.ft.lbf k.ft.lbs 1000.ft.lbf 1000.ft.lb 1000.ft.lbs 1000.lbf.ft"},
    {"kdaN.m", 1e4L, "kdanm dan.km", rare}, {"MN.m", 1e6L, "", rare}, {"dN.m", 0.1L, "", rare},
        {"kkgf.m", 1e3L * gravity, "tf.m", rare},
    {"tonfUS.ft", short_ton * pound_foot, "", rare}},
    {{"ton.ft tonf.ft ft.ton ft.tonf", "tonfUS.ft"}}},
  };
}

// of pressures and densities
std::vector<UnitFamily> families_of_fluids()
{
  return {
  {"a pressure", {
    {"Pa", 1.0L, "n/m2"}, {"kPa", 1e3L, "kn/m2 kpag kpa(g) kpa.g"}, {"MPa", 1e6L, "n/mm2 mpag mpa(g) mpa.g"}, {"GPa", 1e9L},
        {"bar", 1e5L, "bars barg bar(g) bar.g"},
        {"atm", 101325.0L},
    {"kgf/cm2", 1e4L * gravity, "kg/cm2 kgcm2 ksc at kp/cm2 kgf/cm2(g) kg/cm2g kg/cm2(g)"},
        {"psi", psi, "psig psi(g) psi.g lbf/in2 lb/in2 lbs/in2"},
        {"ksi", 1e3L * psi, "kpsi"},
    {"lbf/100ft2", pound_force / (100.0L * foot * foot), "lb/100ft2 lbs/100ft2 lbf/100.ft2 lb/100.ft2 lbs/100.ft2 lbf/100sqft "
        "lb/100sqft lbs/100sqft lbf/100.sqft lb/100.sqft lbf/100.sq.ft lb/100.sq.ft lbs/100.sq.ft"},
    {"lbf/ft2", pound_force / (foot * foot), "psf", rare}, {"hPa", 100.0L, "mbar", rare}, {"hbar", 1e7L, "", rare},
        {"kgf/m2", gravity, "", rare},
    {"kgf/mm2", 1e6L * gravity, "", rare}, {"mmHg", mercury, "mm.hg torr", rare}, {"inHg", 25.4L * mercury, "in.hg", rare},
        {"mH2O", 1e3L * gravity, "m.h2o mwc", rare}, {"inH2O", 25.4L * gravity, "in.h2o inwc", rare}},
    {{"psia psi(a) psi.a psi.abs bara bar(a) bar.a bar.abs kpaa kpa(a) kpa.a kpa.abs mpaa mpa(a) mpa.a mpa.abs",
        "psi, bar, kPa or MPa of a gauge; absolute pressures are 1 atm more"}}},
  {"an energy per volume", {
    {"J/m3", 1.0L}, {"MJ/m3", 1e6L}, {"Pa", 1.0L}, {"MPa", 1e6L}, {"psi", psi}, {"ksi", 1e3L * psi, "kpsi"}}},
  {"a density", {
    {"kg/m3", 1.0L}, {"g/cm3", 1e3L, "kg/l g/cc"}, {"ppg", pound_per_gallon, "lbm/galus lb/galus"},
        {"lbm/ft3", pound / foot3, "lb/ft3 pcf"}},
    {{"lb/gal lbs/gal lbm/gal", "ppg"},  // of the US gallon; a sixth less of the UK one
     {"sg s.g", "g/cm3"}}},              // of water at 4 deg C, 60 deg F or 20 deg C
  };
}

// of motion and flow
std::vector<UnitFamily> further_families()
{
  return {
  {"a viscosity", {{"Pa.s", 1.0L}, {"mPa.s", 1e-3L}, {"cP", 1e-3L}}},
  {"a consistency", {{"Pa.s^n", 1.0L}, {"mPa.s^n", 1e-3L, "eq.cp"},
      {"lbf.s^n/100ft2", pound_force / (100.0L * foot * foot), "lb.sn/100ft2 lbf.sn/100.ft2 lb.sn/100.ft2"}}},
  {"a speed", {
    {"m/s", 1.0L, "m/sec"}, {"m/min", 1.0L / minute, "mpm mtr/min"}, {"m/h", 1.0L / hour, "m/hr mph mtr/hr"},
    {"ft/s", foot, "fps ft/sec"}, {"ft/min", foot / minute, "fpm feet/min"}, {"ft/h", foot / hour, "ft/hr fph feet/hr feet/hour"},
    {"cm/s", 1e-2L, "", rare}, {"mm/s", 1e-3L, "", rare}, {"km/h", 1e3L / hour, "", rare}, {"m/d", 1.0L / day, "", rare},
        {"ft/d", foot / day, "", rare},
    {"kft/h", 1e3L * foot / hour, "", rare}, {"in/s", inch, "", rare}, {"in/min", inch / minute, "", rare}}},
  {"an angular speed", {
    {"rad/s", 1.0L, "rad/sec"}, {"rpm", rev_per_minute, "rev/min c/min r/min 1/min revs/min /min min.1 rev.min.1 r.p.m rpms "
        "u/min umdr/min tr/min tr/mn trs/min tours/min giri/min ob/min obr/min omdr/min vueltas/min"},
        {"deg/s", deg, "dega/s"}, {"rev/s", turn, "c/s rps hz"},
    {"rev/h", turn / hour, "c/h", rare}, {"deg/min", deg / minute, "dega/min", rare}, {"deg/h", deg / hour, "dega/h", rare}}},
  {"an angular acceleration", {{"rad/s2", 1.0L}, {"rpm/s", rev_per_minute}, {"deg/s2", deg}}},
  {"an acceleration", {{"m/s2", 1.0L}, {"ft/s2", foot}}},
  {"a flow", {
    {"m3/s", 1.0L}, {"m3/min", 1.0L / minute, "m3/m m3pm kl/min 1000.l/min"}, {"m3/h", 1.0L / hour, "m3/hr m3/ch"},
        {"L/s", litre, "lps l/sec ltr/s dm3/s l/sek"},
    {"L/min", litre / minute, "l/m lpm ltr/min lt/min liter/min liters/min litre/min litres/min l/minute l/mn dm3/min"},
    // a gallon of the oilfield is that of the USA
    {"gpm", gallon / minute, "galus/min galus/minute gal/min gal/m gals/min gal(us)/min us.gal/min usgal/min usg/min usgpm "
        "us.gpm gpm(us)"},
    {"bbl/min", barrel / minute, "bpm bbl/m bbls/m bbls/min stb/min"},
        {"galUK/min", uk_gallon / minute, "gal(uk)/min uk.gal/min ukgal/min impgal/min igpm"},
    {"m3/d", 1.0L / day, "", rare}, {"L/h", litre / hour, "", rare}, {"cm3/s", 1e-6L, "", rare},
        {"cm3/min", 1e-6L / minute, "", rare}, {"galUS/s", gallon, "", rare},
    {"galUS/h", gallon / hour, "gal/h gal/hr", rare}, {"galUS/d", gallon / day, "", rare},
        {"galUK/h", uk_gallon / hour, "", rare},
    {"bbl/h", barrel / hour, "bbl/hr bph", rare}, {"bbl/d", barrel / day, "", rare}, {"kbbl/d", 1e3L * barrel / day, "", rare},
    {"ft3/s", foot3, "", rare}, {"ft3/min", foot3 / minute, "cfm cu.ft/min", rare}, {"ft3/h", foot3 / hour, "", rare}}},
  {"a change of flow", {{"m3/s2", 1.0L}, {"L/s2", litre}, {"L/min/s", litre / minute}, {"gpm/s", gallon / minute}}},
  {"a volume", {{"m3", 1.0L}, {"L", litre}, {"galUS", gallon}, {"galUK", uk_gallon}, {"bbl", barrel, "bbls"}, {"ft3", foot3},
      {"in3", inch * inch * inch}},
    {{"gal gals", "galUS or galUK"}}},
  {"a volume per turn", {{"m3/rev", 1.0L}, {"L/rev", litre}, {"galUS/rev", gallon}, {"galUK/rev", uk_gallon}},
    {{"gal/rev", "galUS/rev or galUK/rev"}}},
  };
}

// of sections, stiffness and damping
std::vector<UnitFamily> last_families()
{
  return {
  {"an area", {{"m2", 1.0L}, {"cm2", 1e-4L}, {"mm2", 1e-6L}, {"in2", inch * inch}}},
  {"a temperature", {
    {"degC", 1.0L, "c celsius deg.c deg.celsius"}, {"degF", fahrenheit, "f fahrenheit deg.f deg.fahrenheit", true, 32.0L},
        {"K", 1.0L, "kelvin kelvins", true, 273.15L}}},
  {"a temperature gradient", {
    {"K/m", 1.0L, "degc/m deg.c/m"}, {"K/km", 1e-3L, "degc/km deg.c/km"},
        {"K/100m", 1e-2L, "k/100.m degc/100m degc/100.m deg.c/100.m deg.c/100m"},
    {"degF/ft", fahrenheit / foot, "deg.f/ft f/ft"},
        {"degF/100ft", fahrenheit / (100.0L * foot), "degf/100.ft deg.f/100.ft deg.f/100ft f/100ft f/100.ft"}}},
  {"a frequency", {{"1/s", 1.0L}, {"Hz", 1.0L}, {"1/min", 1.0L / minute, "spm"}}},
  {"a power", {{"W", 1.0L}, {"kW", 1e3L}, {"MW", 1e6L}, {"hp", 550.0L * pound_foot}}},
  {"a mass per length", {{"kg/m", 1.0L}, {"lbm/ft", pound_per_foot, "lb/ft lbs/ft ppf"}}},
  {"a force per length", {{"N/m", 1.0L}, {"kN/m", 1e3L}, {"MN/m", 1e6L}, {"lbf/ft", pound_force / foot},
      {"klbf/ft", 1e3L * pound_force / foot}, {"lbf/in", pound_force / inch}}},
  {"a bending stiffness", {{"N.m2", 1.0L}, {"kN.m2", 1e3L}, {"lbf.ft2", pound_foot * foot},
      {"lbf.in2", pound_force * inch * inch}}},
  {"a moment of inertia", {{"kg.m2", 1.0L}, {"lbm.ft2", pound * foot * foot}}},
  {"a moment of inertia per length", {{"kg.m2/m", 1.0L}, {"lbm.ft2/ft", pound * foot}}},
  {"a torsional stiffness", {{"N.m/rad", 1.0L}, {"kN.m/rad", 1e3L}, {"ft.lbf/rad", pound_foot},
      {"ft.lbf/deg", pound_foot / deg}}},
  {"a torsional damping", {{"N.m.s/rad", 1.0L}, {"N.m/rpm", 1.0L / rev_per_minute}, {"ft.lbf.s/rad", pound_foot},
      {"ft.lbf/rpm", pound_foot / rev_per_minute}}},
  {"a torsional damping per length", {{"N.m.s/rad/m", 1.0L}, {"ft.lbf.s/rad/ft", pound_force}}},
  {"a damping", {{"N.s/m", 1.0L}, {"kN.s/m", 1e3L}, {"lbf.s/ft", pound_force / foot}}},
  {"a damping per length", {{"N.s/m/m", 1.0L}, {"N.s/m2", 1.0L}, {"lbf.s/ft2", pound_force / (foot * foot)}}},
  {"a time per length", {{"s/m", 1.0L}, {"s/ft", 1.0L / foot}}},
  {"a pressure per flow squared", {{"Pa.s2/m6", 1.0L}, {"psi/gpm2", psi * minute * minute / (gallon * gallon)}}},
  };
}
// clang-format on

std::vector<UnitFamily> all_families()
{
  std::vector<UnitFamily> families = first_families();
  for (const auto& more : {families_of_fluids(), further_families(), last_families()})
    families.insert(families.end(), more.begin(), more.end());
  return families;
}

void replace_all(std::string& text, const std::string& what, const std::string& by)
{
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

// those that are others in Latin letters one by one: degrees, kilogram- and tonne-force, centimetre; the longer ones first
constexpr std::pair<const char*, const char*> cyrillic_units[] = {{"\u0433\u0440\u0430\u0434\u0443\u0441\u044b", "deg"},
                                                                  {"\u0433\u0440\u0430\u0434\u0443\u0441", "deg"},
                                                                  {"\u0433\u0440\u0430\u0434", "deg"},
                                                                  {"\u043a\u0433\u0441", "kgf"},
                                                                  {"\u0442\u0441", "tf"},
                                                                  {"\u0441\u043c", "cm"}};

/// Whether a word stands in a list of words between blanks.
bool holds(const char* words, const std::string& word)
{
  return !word.empty() && word.find(' ') == std::string::npos &&
         (" " + std::string(words) + " ").find(" " + word + " ") != std::string::npos;
}

bool has_symbol(const UnitFamily& family, const std::string& plain)
{
  return std::any_of(family.units.begin(), family.units.end(), [&](const UnitName& unit) { return plain == unit.name; });
}
}  // namespace

const std::vector<UnitFamily>& unit_families()
{
  static const std::vector<UnitFamily> families = all_families();
  return families;
}

const UnitFamily& units_of_quantity(const std::string& quantity)
{
  for (const UnitFamily& family : unit_families())
  {
    const std::string name = family.quantity;
    if (name.substr(name.find(' ') + 1) == quantity) return family;
  }
  throw std::out_of_range("no quantity: " + quantity);
}

std::string plain_unit(const std::string& spelling)
{
  std::string text = spelling;
  for (const auto& [cyrillic, latin] : cyrillic_units) replace_all(text, cyrillic, latin);
  text = latin_letters(text);
  replace_all(text, " per ", "/");
  replace_all(text, "\u00b2", "2");
  replace_all(text, "\u00b3", "3");
  for (const char* degree_sign : {"\u00b0", "\u00ba"}) replace_all(text, degree_sign, "deg");
  for (const char* foot_sign : {"\u2018", "\u2019", "\u2032"}) replace_all(text, foot_sign, "'");
  for (const char* inch_sign : {"\u201c", "\u201d", "\u2033", "''"}) replace_all(text, inch_sign, "\"");
  replace_all(text, "**", "^");
  for (const char* bracket : {"[", "]"}) replace_all(text, bracket, "");
  for (const char* product : {" ", "-", "*", "\u00b7", "\u22c5"}) replace_all(text, product, ".");
  for (std::size_t at = text.find('^'); at != std::string::npos; at = text.find('^', at + 1))
  {
    // an exponent of two figures or a fraction is no habit of writing
    const bool one_figure = at + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[at + 1])) &&
                            (at + 2 == text.size() || text[at + 2] == '/');
    if (one_figure) text.erase(at, 1);
  }
  return text;
}

std::string folded_unit(const std::string& plain)
{
  std::string text;
  for (const char c : plain)
  {
    const char sign = c == '_' ? '.' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (sign == '^' || (sign == '.' && (text.empty() || text.back() == '.' || text.back() == '/'))) continue;
    if (sign == '/' && !text.empty() && text.back() == '.') text.pop_back();
    text += sign;
  }
  replace_all(text, ".per.", "/");
  while (!text.empty() && text.back() == '.') text.pop_back();
  return text;
}

FoundUnit find_unit(const UnitFamily& family, const std::string& spelling)
{
  const std::string plain = plain_unit(spelling);
  for (const UnitName& unit : family.units)
    if (plain == unit.name) return {&unit, ""};
  const std::string text = folded_unit(plain);
  for (const AmbiguousUnit& one : family.ambiguous)
    if (holds(one.spellings, text)) return {nullptr, one.allowed};
  for (const UnitName& unit : family.units)
  {
    const bool is_symbol = folded_unit(unit.name) == text;
    if (!is_symbol && !holds(unit.spellings, text)) continue;
    if (is_symbol && unit.name[0] == 'M' && plain[0] == 'm') return {nullptr, unit.name + std::string(" or ") + (unit.name + 1)};
    return {&unit, ""};
  }
  return {};
}

const UnitFamily* family_of(const std::string& spelling)
{
  const std::string plain = plain_unit(spelling);
  const std::vector<UnitFamily>& families = unit_families();
  auto found =
      std::find_if(families.begin(), families.end(), [&](const UnitFamily& family) { return has_symbol(family, plain); });
  if (found == families.end())
    found =
        std::find_if(families.begin(), families.end(), [&](const UnitFamily& family) { return find_unit(family, plain).any(); });
  return found == families.end() ? nullptr : &*found;
}

std::string listed_units(const UnitFamily& family, const std::string& suffix)
{
  std::string text;
  for (const UnitName& unit : family.units)
    if (unit.listed) text += (text.empty() ? "" : ", ") + std::string(unit.name) + suffix;
  return text;
}

}  // namespace drill_rig_sim

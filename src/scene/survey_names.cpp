// SPDX-License-Identifier: BSD-3-Clause
#include "survey_names.h"

#include <sstream>

#include "survey_rows.h"

namespace drill_rig_sim
{
namespace
{
using Names = std::map<std::string, SurveyName>;

// names between blanks
void add(Names& all, std::size_t quantity, const char* names, bool weak = false)
{
  std::istringstream words(names);
  for (std::string name; words >> name;) all[name] = {quantity, weak};
}

void add_english(Names& all)
{
  add(all, survey_md,
      "md tmd mdepth measureddepth measdepth measdep msddepth mddepth depthmd depthmeasured measureddepthmd "
      "mdmeasureddepth mdkb mdrkb mdrt mdbrt ahd ahdepth depthah alonghole alongholedepth surveydepth "
      "surveymd svydepth svymd stationdepth stationmd");
  add(all, survey_md, "depth dept drillersdepth drillerdepth loggersdepth loggerdepth", true);
  add(all, survey_inclination,
      "inc incl incn incln inclin inclination incangle inclangle inclinationangle holeinclination holeinc "
      "holeincl holeangle drift driftangle devi deviation deviationangle");
  add(all, survey_azimuth,
      "azi az azm azim azmth azimth azimuth azimuthangle aziazimuth azimuthazi correctedazimuth "
      "azimuthcorrected driftazimuth driftdirection aziangle azimangle azmangle azangle holeazimuth holeazi holeaz holedirection "
      "hazi direction haz");
  add(all, survey_inclination, "holedev hdev devangle zenith zenithangle surveyinc surveyinclination svyinc", true);
  add(all, survey_azimuth, "holedir hdir dir bearing surveyazi surveyazimuth svyazi", true);
  add(all, survey_north, "north ns northsouth northing localnorth localnorthing northoffset nsoffset dispns");
  add(all, survey_east, "east ew eastwest easting localeast localeasting eastoffset ewoffset dispew");
  add(all, survey_tvd, "tvd tvdepth truevertical trueverticaldepth tvdtrueverticaldepth verticaldepth vertdepth vertdep");
}

// German, Dutch, Norwegian and Danish; ae, oe and ue stand for umlauts too
void add_germanic(Names& all)
{
  add(all, survey_md,
      "messtiefe messteufe gemessenetiefe gemesseneteufe bohrteufe bohrlochteufe bohrlochlange "
      "bohrlochlaenge teufemd mdteufe tiefemd mdtiefe gemetendiepte dieptemd maltdybde maaltdybde maltdyp dybdemd "
      "mddybde");
  add(all, survey_md, "teufe tiefe diepte dybde", true);
  add(all, survey_inclination,
      "neigung neigungswinkel bohrlochneigung inklination inklinationswinkel inclinatie inklinasjon helning "
      "helningsvinkel haeldning");
  add(all, survey_azimuth, "azimutwinkel azimuthwinkel bohrlochazimut asimut");
  add(all, survey_azimuth, "richtung richting retning", true);
  add(all, survey_north, "nord noord nordsud nordsued");
  add(all, survey_east, "ost oost ostwest");
  add(all, survey_tvd,
      "vertikalteufe vertikaltiefe vertikaleteufe vertikaletiefe senkrechteteufe teufetvd tiefetvd "
      "vertikaldybde vertikaldyp verticalediepte");
}

// French, Spanish, Portuguese and Italian
void add_romance(Names& all)
{
  add(all, survey_md,
      "profondeurmesuree profmesuree profondeurmd profmd mdprofondeur profondeurforee coteforeur "
      "profundidadmedida profmedida profundidadmd mdprofundidad profundidademedida profundidademd "
      "profonditamisurata profmisurata profonditamd");
  add(all, survey_md, "profondeur prof profundidad profundidade profondita", true);
  add(all, survey_inclination,
      "inclinaison angledinclinaison inclinacion angulodeinclinacion inclinacao angulodeinclinacao "
      "inclinazione angolodiinclinazione");
  add(all, survey_azimuth, "azimut azimute azimutal");
  add(all, survey_azimuth, "rumbo direccion direcao direzione", true);
  add(all, survey_north, "norte nordsud");
  add(all, survey_east, "est este leste estouest esteoeste");
  add(all, survey_tvd,
      "profondeurverticale profverticale profundidadvertical profvertical profundidadverticalverdadera "
      "profundidadevertical profonditaverticale");
}

// Russian and Polish
void add_slavic(Names& all)
{
  add(all, survey_md,
      "glubinapostvolu glubinastvola dlinastvola dlinapostvolu izmerennayaglubina izmerennajaglubina "
      "glubinaizmerennaya glubinazamera glubinapostvoluskvazhiny glebokoscmierzona");
  add(all, survey_md, "glubina glebokosc", true);
  add(all, survey_inclination,
      "zenit zenitnyyugol zenitnyjugol zenitniyugol zenitnyugol zenitnyiugol ugolzenitnyy ugolnaklona "
      "katodchylenia katinklinacji inklinacja");
  add(all, survey_azimuth, "azymut");
  add(all, survey_north, "sever polnoc");
  add(all, survey_east, "vostok wschod");
  add(all, survey_tvd, "vertikalnayaglubina vertikalnajaglubina glubinapovertikali glubinavertikalnaya");
}

void add_chinese(Names& all)
{
  add(all, survey_md, "井深 测深 斜深 测量深度 测量井深");
  add(all, survey_inclination, "井斜 井斜角");
  add(all, survey_azimuth, "方位 方位角");
  add(all, survey_tvd, "垂深 垂直深度 垂直井深");
}
}  // namespace

const std::map<std::string, SurveyName>& survey_names()
{
  static const Names names = []
  {
    Names all;
    add_english(all);
    add_germanic(all);
    add_romance(all);
    add_slavic(all);
    add_chinese(all);
    return all;
  }();
  return names;
}

}  // namespace drill_rig_sim

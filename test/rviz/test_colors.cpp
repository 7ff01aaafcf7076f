// SPDX-License-Identifier: BSD-3-Clause
// The console as the colour-blind (red and green) see it.
#include <QImage>
#include <QTableWidget>
#include <array>
#include <cmath>
#include <map>

#include "console_test.h"

using namespace console_test;

namespace
{
double linear(double c)
{
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double coded(double c)
{
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

// Deuteranopia after Machado, Oliveira and Fernandes (2009), severity 1, on linear RGB.
std::array<double, 3> deuteranope(QRgb color)
{
  const double r = linear(qRed(color) / 255.0), g = linear(qGreen(color) / 255.0), b = linear(qBlue(color) / 255.0);
  const auto within = [](double c) { return std::min(std::max(c, 0.0), 1.0); };
  return {within(0.367322 * r + 0.860646 * g - 0.227968 * b), within(0.280085 * r + 0.672501 * g + 0.047413 * b),
          within(-0.011820 * r + 0.042940 * g + 0.968881 * b)};
}

// CIE L*a*b* of linear RGB, white D65.
std::array<double, 3> lab(const std::array<double, 3>& c)
{
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  const double x = f((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.9505),
               y = f(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]),
               z = f((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.089);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double difference(QRgb one, QRgb other)
{
  const auto a = lab(deuteranope(one)), b = lab(deuteranope(other));
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The commonest of the bright colours of a gauge's lower quarter, where its bar is.
QRgb bar_of(const QWidget* gauge)
{
  const QImage image = const_cast<QWidget*>(gauge)->grab().toImage();
  std::map<QRgb, int> count;
  for (int y = 3 * image.height() / 4; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (const QColor c = image.pixelColor(x, y); c.value() > 150 && c.saturation() > 60) ++count[c.rgb()];
  const auto most =
      std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == count.end() ? 0 : most->first;
}
}  // namespace

TEST(Colors, LevelsDifferForTheColourBlind)
{
  shared_rig();
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  ASSERT_TRUE(console.is_heard());
  console.open_page_of("gauge hook_load");
  ASSERT_TRUE(wait_until([&] { return console.shows("gauge hook_load").contains("kN"); }));
  const double load = console.shows("gauge hook_load").section(' ', 0, 0).toDouble();
  console.open_page_of("settings alarms");
  auto* table = console.get<QTableWidget>("settings alarms");
  std::map<QString, QRgb> seen;
  for (const auto& [level, limit] : {std::pair("normal", 2.0), std::pair("caution", 1.05), std::pair("alarm", 0.5)})
  {
    table->item(0, 2)->setText(QString::number(limit * load, 'f', 1));
    const QString wanted = level;
    EXPECT_TRUE(wait_until(
        [&]
        {
          return wanted == "normal" ? !console.shows("gauge hook_load").contains("caution")
                                    : console.shows("gauge hook_load").contains(wanted);
        }));
    console.open_page_of("gauge hook_load");
    wait_for(0.5);
    seen[wanted] = bar_of(console.get("gauge hook_load"));
    QImage picture = console.window().grab().toImage().convertToFormat(QImage::Format_RGB32);
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x)
      {
        const auto c = deuteranope(picture.pixel(x, y));
        picture.setPixelColor(x, y, QColor::fromRgbF(coded(c[0]), coded(c[1]), coded(c[2])));
      }
    picture.save(out_folder() + "/console_colour_blind_" + wanted + ".png");
    console.open_page_of("settings alarms");
  }
  table->item(0, 2)->setText("");
  EXPECT_GT(difference(seen["normal"], seen["caution"]), 20.0);
  EXPECT_GT(difference(seen["normal"], seen["alarm"]), 20.0);
  EXPECT_GT(difference(seen["caution"], seen["alarm"]), 20.0);
}

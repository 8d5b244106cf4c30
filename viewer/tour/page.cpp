#include "tour/page.h"

#include <cmath>
#include <cstdio>
#include <sstream>

namespace sectile::viewer {
namespace {

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>A tour of the paper</title>
<style>
:root { color-scheme: light dark; --ink: #1b2027; --back: #fafbfc; --soft: #68727d; --line: #cdd4db;
  --a: #1668ad; --b: #b85c00; --lit: #d0104f; --plain: #68727d; --special: #a85f00; --cut: #c40f4c;
  --kept: #00795a; --dropped: #6b6200; }
@media (prefers-color-scheme: dark) { :root { --ink: #e8ecf1; --back: #16191d; --soft: #9aa5b1;
  --line: #3a424b; --a: #6cb4ee; --b: #f0a04b; --lit: #ff5c92; --plain: #9aa5b1;
  --special: #f0a04b; --cut: #ff5c92; --kept: #3fcf9f; --dropped: #d6c65a; } }
body { font: 17px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--back);
  margin: 0 auto; max-width: 1080px; padding: 0 20px; }
header, footer { padding: 24px 0; color: var(--soft); }
h1 { color: var(--ink); margin: 0; }
section { border-top: 1px solid var(--line); padding: 22px 0 30px; scroll-margin-top: 0; }
section:target { border-top-color: var(--lit); }
h2 { margin: 0 0 2px; } .covers { color: var(--soft); font-size: 14px; margin: 0 0 12px; }
.pair { display: flex; gap: 22px; flex-wrap: wrap; align-items: flex-start; }
figure { margin: 0; flex: 1 1 420px; } figcaption { color: var(--soft); font-size: 14px; }
img, svg { width: 100%; height: auto; border: 1px solid var(--line); border-radius: 6px;
  background: #fff; box-sizing: border-box; }
.picture { position: relative; } .picture b { position: absolute; font-size: 13px; line-height: 1.2;
  padding: 0 4px; border-radius: 4px; background: #ffffffd8; border: 1px solid #c8ced5;
  transform: translate(6px, -110%); white-space: nowrap; }
.verdict { font-weight: 700; font-size: 20px; border-left: 6px solid; padding-left: 9px; }
.plain { color: var(--plain); } .special { color: var(--special); } .cut { color: var(--cut); }
.kept { color: var(--kept); } .dropped { color: var(--dropped); }
ul { margin: 6px 0 10px; padding-left: 22px; }
.key { display: inline-block; margin-right: 12px; font-size: 14px; color: var(--soft); }
.key i { display: inline-block; width: 11px; height: 11px; border: 1px solid #8888; margin-right: 5px;
  border-radius: 3px; } .key i.point { border-radius: 50%; } .key i.line { height: 3px;
  vertical-align: middle; }
details { border: 1px solid var(--line); border-radius: 6px; padding: 8px 12px; max-width: 46em; }
summary { cursor: pointer; } details p { margin: 8px 0 2px; }
nav { float: right; font-size: 15px; } a { color: var(--a); }
svg .line { fill: none; stroke-linecap: round; stroke-linejoin: round; }
svg .area { stroke: none; opacity: .22; } svg text { font: 4.3px system-ui, sans-serif;
  text-anchor: middle; stroke: none; }
svg .black { stroke: #1b2027; fill: #1b2027; } svg .grey { stroke: #7d8894; fill: #7d8894; }
svg .a { stroke: #1668ad; fill: #1668ad; } svg .b { stroke: #c76a00; fill: #c76a00; }
svg .lit { stroke: #d0104f; fill: #d0104f; } svg .line.line { fill: none; } svg text { stroke: none; }
svg text.black, svg text.grey, svg text.a, svg text.b, svg text.lit { stroke: none; }
</style>
</head>
<body>
<header>
<h1>A tour of the paper</h1>
<p>M. Mäntylä, <i>Boolean operations of 2-manifolds through vertex neighborhood classification</i>
(1986), station by station: a scene, one step of the algorithm, the paper's own figure redrawn, and
a question. Keys: → and ← go on and back, Enter shows the answer. In the modeller the same stations
are in the menu Help, and every picture can be turned.</p>
</header>
)";

constexpr const char* tail = R"(<footer>Written by <code>sectile-viewer --tour</code>.</footer>
<script>
const all = [...document.querySelectorAll('section')];
const here = () => all.reduce((best, s, i) =>
  Math.abs(s.getBoundingClientRect().top) < Math.abs(all[best].getBoundingClientRect().top) ? i : best, 0);
addEventListener('keydown', event => {
  const i = here();
  if (event.key === 'ArrowRight' && i + 1 < all.length) location.hash = all[i + 1].id;
  else if (event.key === 'ArrowLeft' && i > 0) location.hash = all[i - 1].id;
  else if (event.key === 'Enter') { const d = all[i].querySelector('details'); d.open = !d.open; }
  else return;
  event.preventDefault();
});
</script>
</body>
</html>
)";

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63];
  }
  return text;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text)
    safe += c == '<'   ? "&lt;"
            : c == '>' ? "&gt;"
            : c == '&' ? "&amp;"
            : c == '"' ? "&quot;"
                       : std::string(1, c);
  return safe;
}

const char* class_of(Verdict::Tone tone) {
  switch (tone) {
    case Verdict::Tone::plain:
      return "plain";
    case Verdict::Tone::special:
      return "special";
    case Verdict::Tone::cut:
      return "cut";
    case Verdict::Tone::kept:
      return "kept";
    case Verdict::Tone::dropped:
      break;
  }
  return "dropped";
}

std::string hex(const Colour& colour) {
  char text[8];
  const auto byte = [](float v) { return static_cast<unsigned>(std::lround(255 * v)); };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(colour.r), byte(colour.g), byte(colour.b));
  return text;
}

void write_legend(std::ostream& out, const std::vector<LegendKey>& legend) {
  for (const LegendKey& key : legend) {
    const char* form = key.form == LegendKey::Form::point  ? " class=\"point\""
                       : key.form == LegendKey::Form::line ? " class=\"line\""
                                                           : "";
    out << "<span class=\"key\"><i" << form << " style=\"background:" << hex(key.colour)
        << "\"></i>" << escaped(key.text) << "</span>\n";
  }
}

void write_names(std::ostream& out, const std::vector<StationSight::Name>& names) {
  for (const StationSight::Name& name : names)
    out << "<b style=\"left:" << 100 * name.x << "%;top:" << 100 * name.y
        << "%;color:" << hex(name.colour) << "\">" << escaped(name.text) << "</b>\n";
}

void write_step(std::ostream& out, const Step& step) {
  if (step.title.empty()) return;
  out << "<p class=\"verdict " << class_of(step.verdict.tone) << "\">"
      << escaped(step.verdict.words) << "</p>\n<p>" << escaped(step.title) << "</p>\n<ul>\n";
  for (const std::string& bullet : step.bullets) out << "<li>" << escaped(bullet) << "</li>\n";
  out << "</ul>\n";
}

void write_station(std::ostream& out, const Station& station, const StationSight& sight,
                   std::size_t number, std::size_t count) {
  out << "<section id=\"station-" << number << "\">\n<nav>";
  if (number > 1) out << "<a href=\"#station-" << number - 1 << "\">← back</a> ";
  out << number << " of " << count;
  if (number < count) out << " <a href=\"#station-" << number + 1 << "\">on →</a>";
  out << "</nav>\n<h2>" << escaped(station.title) << "</h2>\n<p class=\"covers\">";
  for (std::size_t i = 0; i < station.covers.size(); ++i)
    out << (i == 0 ? "" : " · ") << escaped(station.covers[i]);
  out << "</p>\n<p>" << escaped(station.text)
      << "</p>\n<div class=\"pair\">\n<figure><div class=\"picture\"><img alt=\""
      << escaped(station.title) << "\" src=\"data:image/png;base64," << base64(sight.png) << "\">";
  write_names(out, sight.names);
  out << "</div><figcaption>sample <code>" << escaped(station.sample) << "</code>, phase "
      << name_of(station.phase) << "<br>\n";
  write_legend(out, sight.legend);
  out << "</figcaption></figure>\n<figure>" << svg_of(station.figure)
      << "<figcaption>after the paper</figcaption></figure>\n</div>\n";
  write_step(out, sight.step);
  out << "<details><summary>" << escaped(station.question) << "</summary><p>"
      << escaped(station.answer) << "</p></details>\n</section>\n";
}

}  // namespace

std::string tour_page(const std::vector<Station>& stations,
                      const std::vector<StationSight>& sights) {
  std::ostringstream out;
  out << head;
  for (std::size_t i = 0; i < stations.size(); ++i)
    write_station(out, stations[i], sights.at(i), i + 1, stations.size());
  out << tail;
  return out.str();
}

}  // namespace sectile::viewer

#include "tour/figure.h"

#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace sectile::viewer {

Figure& Figure::line(Ink ink, std::vector<FigurePoint> points, float width) {
  shapes_.push_back({FigureShape::Kind::line, ink, std::move(points), {}, width, false});
  return *this;
}

Figure& Figure::dashed(Ink ink, std::vector<FigurePoint> points) {
  shapes_.push_back({FigureShape::Kind::line, ink, std::move(points), {}, 0.8f, true});
  return *this;
}

Figure& Figure::closed(Ink ink, std::vector<FigurePoint> points) {
  points.push_back(points.front());
  return line(ink, std::move(points));
}

Figure& Figure::area(Ink ink, std::vector<FigurePoint> points) {
  shapes_.push_back({FigureShape::Kind::area, ink, points, {}, 0.8f, false});
  return closed(ink, std::move(points));
}

Figure& Figure::arrow(Ink ink, FigurePoint from, FigurePoint to) {
  line(ink, {from, to});
  const float dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  const float ux = dx / length, uy = dy / length;
  return line(ink, {{to.x - 3 * ux + 1.5f * uy, to.y - 3 * uy - 1.5f * ux},
                    to,
                    {to.x - 3 * ux - 1.5f * uy, to.y - 3 * uy + 1.5f * ux}});
}

Figure& Figure::dot(Ink ink, FigurePoint at) {
  shapes_.push_back({FigureShape::Kind::dot, ink, {at}, {}, 1, false});
  return *this;
}

Figure& Figure::text(Ink ink, FigurePoint at, std::string text) {
  shapes_.push_back({FigureShape::Kind::text, ink, {at}, std::move(text), 1, false});
  return *this;
}

namespace {

std::string class_of(Ink ink) {
  constexpr std::array names = {"black", "grey", "a", "b", "lit"};
  return names.at(static_cast<std::size_t>(ink));
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return safe;
}

void write_points(std::ostream& out, const FigureShape& shape) {
  out << " points=\"";
  for (const FigurePoint& p : shape.points) out << p.x << ',' << p.y << ' ';
  out << '"';
}

void write_shape(std::ostream& out, const FigureShape& shape) {
  const FigurePoint& at = shape.points.front();
  switch (shape.kind) {
    case FigureShape::Kind::line:
      out << "<polyline class=\"line " << class_of(shape.ink) << "\" stroke-width=\"" << shape.width
          << '"' << (shape.dashed ? " stroke-dasharray=\"2.5 1.8\"" : "");
      write_points(out, shape);
      out << "/>";
      break;
    case FigureShape::Kind::area:
      out << "<polygon class=\"area " << class_of(shape.ink) << '"';
      write_points(out, shape);
      out << "/>";
      break;
    case FigureShape::Kind::dot:
      out << "<circle class=\"dot " << class_of(shape.ink) << "\" cx=\"" << at.x << "\" cy=\""
          << at.y << "\" r=\"1.4\"/>";
      break;
    case FigureShape::Kind::text:
      out << "<text class=\"" << class_of(shape.ink) << "\" x=\"" << at.x << "\" y=\""
          << at.y + 1.6f << "\">" << escaped(shape.text) << "</text>";
      break;
  }
  out << '\n';
}

}  // namespace

std::string svg_of(const Figure& figure) {
  std::ostringstream out;
  out << "<svg viewBox=\"0 0 " << Figure::across << ' ' << Figure::down
      << "\" role=\"img\" aria-label=\"the paper's figure, redrawn\">\n";
  for (const FigureShape& shape : figure.shapes()) write_shape(out, shape);
  out << "</svg>\n";
  return out.str();
}

}  // namespace sectile::viewer

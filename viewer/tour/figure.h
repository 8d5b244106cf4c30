// The paper's figures redrawn: lines, areas and letters, for a page and for the window.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sectile::viewer {

/// What a line or an area stands for; both themes and the page have a colour for it.
enum class Ink : std::uint8_t { black, grey, a, b, lit };

struct FigurePoint {
  float x = 0, y = 0;  ///< 0 … 100 and 0 … 62, y downwards
};

struct FigureShape {
  enum class Kind : std::uint8_t { line, area, dot, text };
  Kind kind = Kind::line;
  Ink ink = Ink::black;
  std::vector<FigurePoint> points;  ///< of a dot or a text: one, its middle
  std::string text;
  float width = 1;
  bool dashed = false;
};

class Figure {
 public:
  static constexpr float across = 100, down = 62;  ///< the sheet

  Figure& line(Ink ink, std::vector<FigurePoint> points, float width = 0.8f);
  Figure& dashed(Ink ink, std::vector<FigurePoint> points);
  Figure& closed(Ink ink, std::vector<FigurePoint> points);  ///< an outline
  Figure& area(Ink ink, std::vector<FigurePoint> points);    ///< with its outline
  Figure& arrow(Ink ink, FigurePoint from, FigurePoint to);
  Figure& dot(Ink ink, FigurePoint at);
  Figure& text(Ink ink, FigurePoint at, std::string text);

  const std::vector<FigureShape>& shapes() const { return shapes_; }

 private:
  std::vector<FigureShape> shapes_;
};

/// For an HTML page whose style sheet knows the inks as classes.
std::string svg_of(const Figure& figure);

}  // namespace sectile::viewer

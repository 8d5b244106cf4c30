// The station of the tour: what it says, the paper's figure, a question and its answer.
#include <algorithm>
#include <cmath>

#include "app/panels/panels.h"
#include "tour/station.h"

namespace sectile::viewer {
namespace {

class FigureDrawing {
 public:
  FigureDrawing(const Fonts& fonts, const Theme& theme, ImVec2 at, float scale)
      : fonts_(fonts), theme_(theme), at_(at), scale_(scale), draw_(*ImGui::GetWindowDrawList()) {}

  void draw(const Figure& figure) const {
    for (const FigureShape& shape : figure.shapes()) draw(shape);
  }

 private:
  ImVec2 place(const FigurePoint& p) const { return {at_.x + p.x * scale_, at_.y + p.y * scale_}; }

  ImU32 colour(Ink ink, float alpha = 1) const {
    switch (ink) {
      case Ink::black:
        return ImGui::GetColorU32(ImGuiCol_Text, alpha);
      case Ink::grey:
        return ImGui::GetColorU32(ImGuiCol_TextDisabled, alpha);
      case Ink::a:
        return packed(with_alpha(theme_.a, alpha));
      case Ink::b:
        return packed(with_alpha(theme_.b, alpha));
      case Ink::lit:
        break;
    }
    return packed(with_alpha(theme_.step, alpha));
  }

  void draw(const FigureShape& shape) const {
    const ImVec2 at = place(shape.points.front());
    if (shape.kind == FigureShape::Kind::dot) {
      draw_.AddCircleFilled(at, 1.4f * scale_, colour(shape.ink));
    } else if (shape.kind == FigureShape::Kind::text) {
      ImGui::PushFont(fonts_.small);
      const ImVec2 size = ImGui::CalcTextSize(shape.text.c_str());
      draw_.AddText({at.x - size.x / 2, at.y - size.y / 2}, colour(shape.ink), shape.text.c_str());
      ImGui::PopFont();
    } else if (shape.kind == FigureShape::Kind::area) {
      fill(shape);
    } else {
      stroke(shape);
    }
  }

  // Not every area is convex: line by line.
  void fill(const FigureShape& shape) const {
    const ImU32 tint = colour(shape.ink, 0.22f);
    const float bottom = Figure::down * scale_;
    for (float y = 0.5f; y < bottom; y += 1) {
      std::vector<float> crossings;
      for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const ImVec2 p = place(shape.points[i]),
                     q = place(shape.points[(i + 1) % shape.points.size()]);
        const float line = at_.y + y;
        if ((p.y <= line) == (q.y <= line)) continue;
        crossings.push_back(p.x + (q.x - p.x) * (line - p.y) / (q.y - p.y));
      }
      std::sort(crossings.begin(), crossings.end());
      for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        draw_.AddRectFilled({crossings[i], at_.y + y - 0.5f}, {crossings[i + 1], at_.y + y + 0.5f},
                            tint);
    }
  }

  void stroke(const FigureShape& shape) const {
    const float width = std::max(1.2f, shape.width * scale_ * 0.75f);
    for (std::size_t i = 0; i + 1 < shape.points.size(); ++i) {
      const ImVec2 p = place(shape.points[i]), q = place(shape.points[i + 1]);
      if (!shape.dashed) {
        draw_.AddLine(p, q, colour(shape.ink), width);
        continue;
      }
      const float length = std::hypot(q.x - p.x, q.y - p.y);
      for (float from = 0; from < length; from += 8) {
        const float s = from / length, t = std::min(1.0f, (from + 5) / length);
        draw_.AddLine({p.x + (q.x - p.x) * s, p.y + (q.y - p.y) * s},
                      {p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t}, colour(shape.ink), width);
      }
    }
  }

  const Fonts& fonts_;
  const Theme& theme_;
  ImVec2 at_;
  float scale_;
  ImDrawList& draw_;
};

void draw_figure(PanelContext& context, const Figure& figure) {
  const float width = ImGui::GetContentRegionAvail().x;
  const float scale = width / Figure::across;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 end{at.x + width, at.y + Figure::down * scale};
  ImGui::GetWindowDrawList()->AddRectFilled(at, end, ImGui::GetColorU32(ImGuiCol_FrameBg), 4);
  FigureDrawing(context.fonts, context.theme, at, scale).draw(figure);
  ImGui::Dummy({width, Figure::down * scale});
  context.widgets.record_item("tour.figure");
}

void wrapped(const std::string& text) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

void draw_ways(PanelContext& context) {
  const float width = (ImGui::GetContentRegionAvail().x - 2 * 4) / 3;
  for (const char* name : {"tour.previous", "tour.next", "tour.end"}) {
    const Command& command = context.commands.get(name);
    const char* text = name == std::string("tour.end")    ? "End"
                       : name == std::string("tour.next") ? "On"
                                                          : "Back";
    if (name != std::string("tour.previous")) ImGui::SameLine(0, 4);
    if (button(context, name, text, tooltip_of(command), is_enabled(command, context.session),
               width))
      context.commands.run(context.session, command);
  }
}

}  // namespace

void draw_tour(PanelContext& context) {
  if (!context.session.interface.tour.is_on() || context.layout.tour.height <= 0) return;
  TourGuide& tour = context.session.interface.tour;
  const Station& station = tour.station();
  begin_panel(context, "tour", context.layout.tour);
  note(context, "Tour of the paper, " + std::to_string(tour.at() + 1) + " of " +
                    std::to_string(TourGuide::count()));
  draw_ways(context);
  if (context.session.interface.tour.is_on()) {
    ImGui::BeginChild("station", {0, 0});
    ImGui::PushFont(context.fonts.bold);
    wrapped(station.title);
    ImGui::PopFont();
    ImGui::Spacing();
    wrapped(station.text);
    ImGui::Spacing();
    draw_figure(context, station.figure);
    ImGui::Spacing();
    wrapped(station.question);
    if (button(context, "tour.answer", tour.shows_answer ? "Hide the answer" : "Answer", {}, true,
               -1))
      tour.shows_answer = !tour.shows_answer;
    if (tour.shows_answer) wrapped(station.answer);
    ImGui::EndChild();
  }
  end_panel();
}

}  // namespace sectile::viewer

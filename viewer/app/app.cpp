#include "app/app.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "app/commands.h"
#include "app/event_queue.h"
#include "app/interface_input.h"
#include "app/navigation.h"
#include "app/panels/panels.h"
#include "app/picture_maker.h"
#include "app/settings_file.h"

namespace sectile::viewer {
namespace {

/// A field that was left and is typed into again has the undo steps of its earlier text, and ImGui
/// ends the program where they do not fit the text that it has now.
void forget_text_of_fields_left() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.InputTextState.ID != context.ActiveId) context.InputTextState.ID = 0;
}

/// ImGui's context of one App; several can live side by side.
class InterfaceContext {
 public:
  InterfaceContext() : context_(ImGui::CreateContext()) {
    bind();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = io.LogFilename = nullptr;
    io.ConfigDragClickToInputText = true;
    io.ConfigInputTextCursorBlink = false;
    interface_input::prepare();
  }
  ~InterfaceContext() { ImGui::DestroyContext(context_); }
  InterfaceContext(const InterfaceContext&) = delete;
  InterfaceContext& operator=(const InterfaceContext&) = delete;
  void bind() const { ImGui::SetCurrentContext(context_); }

 private:
  ImGuiContext* context_;
};

}  // namespace

class App::Implementation {
 public:
  Implementation(GraphicsContext& context, const AppOptions& options)
      : context_(context),
        options_(options),
        renderer_(context),
        session_(options.data_folder, options.dark) {
    session_.interface.clipboard = {
        [] {
          const char* text = ImGui::GetClipboardText();
          return std::string(text ? text : "");
        },
        [](const std::string& text) { ImGui::SetClipboardText(text.c_str()); }};
    if (!options_.data_folder.empty()) {
      load_settings(settings_path(), session_.view, session_.interface.dialogs.browser.folder);
      session_.interface.recent = RecentFiles(options_.data_folder / "recent");
      session_.offer_recovery(options_.data_folder);
    }
  }

  ~Implementation() {
    if (!options_.data_folder.empty())
      save_settings(settings_path(), session_.view, session_.interface.dialogs.browser.folder);
  }

  void frame(const Input& input, double seconds) {
    interface_.bind();
    events_.add(input);
    begin(seconds);
    const std::vector<Event> fed = events_.feed();
    let_keys_walk_in_menus();
    session_.update(seconds, options_.wait_for_results);
    ImGui::NewFrame();
    forget_text_of_fields_left();
    react(fed);
    was_busy_ = session_.is_busy();
    widgets_.begin_frame();
    draw_interface();
    if (!std::exchange(session_.interface.typed.is_drawn, false))
      session_.interface.typed.field.clear();
    if (options_.wait_for_results) session_.update(0, true);
    tooltip_pending_ = is_tooltip_pending();
    follow_step();
    record_on();
    make_picture(seconds);
    ImGui::Render();
    is_drawn_ = false;
    if (!options_.draw_on_request) draw();
  }

  void draw() {
    if (is_drawn_) return;
    interface_.bind();
    renderer_.begin_frame();
    renderer_.draw(picture_, viewport_);
    renderer_.draw(*ImGui::GetDrawData());
    is_drawn_ = true;
  }

  /// One frame of a film for each of the window.
  void record_on() {
    if (!session_.interface.recording) return;
    if (!session_.interface.recording->prepare(session_.results, session_.view))
      return session_.write_recorded();
    session_.interface.recording->add(draw_image(session_.interface.recording->plan()));
  }

  std::vector<Image> film(const RecordingPlan& plan) {
    interface_.bind();
    Recording recording(plan, session_.results, session_.view);
    while (recording.prepare(session_.results, session_.view)) recording.add(draw_image(plan));
    return recording.take();
  }

  Image draw_image(const RecordingPlan& plan) {
    Picture picture = pictures_.make(session_);
    picture.quality = Quality::full;
    return renderer_.draw_image(picture, static_cast<int>(plan.width),
                                static_cast<int>(plan.height), font_scale_);
  }

  bool needs_frame() const {
    return !events_.is_empty() || was_busy_ || tooltip_pending_ || session_.is_busy() ||
           session_.results.player.is_playing() || session_.interface.messages.is_fading() ||
           settling_ > 0 || !is_at_rest();
  }

  double time_to_next_frame() const {
    const bool moves =
        session_.results.player.is_playing() || tooltip_pending_ || settling_ > 0 || !is_at_rest();
    return moves ? 1.0 / 60 : 0.5;
  }

  Image screenshot() {
    draw();
    return renderer_.read_frame();
  }
  const DrawnWork& drawn() const { return renderer_.work(); }

  glm::dvec2 on_screen(const glm::dvec3& point) const {
    const glm::dvec3 pixel = session_.view.camera.project(point, session_.view.picture_size);
    return {layout_.picture.x + pixel.x, layout_.picture.y + pixel.y};
  }

  Session& session() { return session_; }
  const Session& session() const { return session_; }
  const Widgets& widgets() const { return widgets_; }

 private:
  std::filesystem::path settings_path() const { return options_.data_folder / "settings"; }

  void begin(double seconds) {
    ImGuiIO& io = ImGui::GetIO();
    const float scale = std::max(0.5f, context_.scale());
    if (scale != font_scale_) {
      font_scale_ = scale;
      fonts_ = load_fonts(*io.Fonts, scale);
      io.FontGlobalScale = 1 / scale;
    }
    io.DisplaySize = {static_cast<float>(context_.width()) / scale,
                      static_cast<float>(context_.height()) / scale};
    io.DisplayFramebufferScale = {scale, scale};
    io.DeltaTime = static_cast<float>(std::max(seconds, 1e-4));
    apply_style(session_.view.dark);
    const float menu = options_.show_interface ? 15 + 8 : 0;
    const bool steps = session_.mode() == Mode::steps;
    const double left = steps ? session_.view.left_steps : session_.view.left_model;
    layout_ = make_layout(io.DisplaySize.x, io.DisplaySize.y,
                          {menu, steps, session_.view.hints, session_.interface.tour.is_on(),
                           session_.results.repair.is_open(), static_cast<float>(left),
                           static_cast<float>(session_.view.right_steps)});
    if (!options_.show_interface) layout_.picture = {0, 0, io.DisplaySize.x, io.DisplaySize.y};
    session_.view.picture_size = {layout_.picture.width, layout_.picture.height};
  }

  // Escape closes a menu and arrows walk in it; elsewhere these keys are ours. That a menu was open
  // is asked before ImGui looks at the keys, as Escape is not to do two things.
  void let_keys_walk_in_menus() {
    menu_was_open_ =
        ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    ImGuiIO& io = ImGui::GetIO();
    io.ConfigFlags = menu_was_open_ ? ImGuiConfigFlags_NavEnableKeyboard : ImGuiConfigFlags_None;
    if (menu_was_open_) interface_input::let_enter_activate();
  }

  void react(const std::vector<Event>& fed) {
    // Two quiet frames let menus and tooltips come to rest.
    settling_ = fed.empty() ? std::max(0, settling_ - 1) : 2;
    for (const Event& event : fed) {
      if (event.kind == Event::Kind::close && !session_.interface.dialogs.is_open())
        commands_.run(session_, commands_.get("file.quit"));
      if (event.kind == Event::Kind::drop)
        for (const std::filesystem::path& file : event.files) session_.open(file);
      if (event.kind == Event::Kind::key_down) press(event);
      if (event.kind == Event::Kind::text && !ImGui::GetIO().WantTextInput &&
          session_.interface.typed.field.empty())
        navigation_.text(session_, event.text);
    }
  }

  void press(const Event& event) {
    if (ImGui::GetIO().WantTextInput || session_.interface.dialogs.is_open()) return;
    if (!session_.interface.typed.field.empty()) return;
    if (menu_was_open_) return;
    if (event.key == Key::escape) return escape();
    if (navigation_.key(session_, event)) return;
    if (!navigation_.is_dragging()) commands_.press(session_, event);
  }

  void escape() {
    if (session_.results.repair.is_open()) return session_.give_up_repair();
    if (navigation_.escape(session_)) return;
    if (!session_.document.has_draft()) return session_.select(0);
    // A field that is being dragged.
    session_.document.drop_draft();
    ImGui::ClearActiveID();
  }

  void draw_interface() {
    if (!options_.show_interface) return;
    PanelContext context{session_, commands_, widgets_, layout_, fonts_, theme(session_.view.dark)};
    ImGui::PushFont(fonts_.regular);
    draw_menu_bar(context);
    draw_tool_bar(context);
    draw_left_side(context);
    if (session_.mode() == Mode::steps && layout_.inspector.width > 0) {
      draw_inspector(context);
      draw_time_line(context);
    }
    draw_tour(context);
    draw_legend(context);
    draw_hint_strip(context);
    draw_view_panel(context);
    draw_view_cube(context);
    draw_context_menu(context);
    draw_tool_banner(context);
    draw_messages(context);
    draw_status_bar(context);
    draw_questions(context);
    draw_recording(context);
    draw_file_browser(context);
    draw_key_page(context);
    draw_profile_editor(context);
    draw_help(context);
    ImGui::PopFont();
    Widget picture;
    picture.rectangle = {layout_.picture.x, layout_.picture.y, layout_.picture.width,
                         layout_.picture.height};
    picture.surface = true;
    widgets_.record("picture", picture);
    navigation_.record(widgets_, session_, layout_.picture);
  }

  void draw_left_side(PanelContext& context) {
    if (session_.results.repair.is_open()) return draw_repair(context);
    draw_scene_tree(context);
    if (layout_.properties.height > 0) draw_properties(context);
    draw_splitters(context);
  }

  void follow_step() {
    const auto place = std::pair(session_.results.player.shared(), session_.results.player.step());
    if (place == followed_) return;
    followed_ = place;
    if (!session_.view.follow_steps || session_.mode() != Mode::steps || !place.first ||
        !session_.results.player.current())
      return;
    const Bounds bounds = place.first->place_of(place.second);
    if (!bounds.is_empty())
      session_.view.camera.look_at(bounds,
                                   session_.view.picture_size.x / session_.view.picture_size.y);
  }

  // A picture in full quality may take a second: it waits until the camera has come to rest.
  bool is_at_rest() const { return options_.wait_for_results || still_for_ >= 0.25; }

  void make_picture(double seconds) {
    navigation_.update(session_, layout_.picture);
    // Drawing may take long, and the program may be killed in the meantime.
    session_.document.keep_copy();
    still_for_ = session_.view.camera == seen_camera_ ? still_for_ + seconds : 0;
    seen_camera_ = session_.view.camera;
    picture_ = pictures_.make(session_);
    if (options_.show_interface) navigation_.add_to(picture_, session_);
    if (navigation_.is_dragging() || options_.fast_pictures || !is_at_rest())
      picture_.quality = Quality::fast;
    const float scale = font_scale_;
    const auto pixels = [&](float units) { return static_cast<int>(std::lround(units * scale)); };
    const Rectangle& p = layout_.picture;
    viewport_ = {pixels(p.x), pixels(p.y), pixels(p.width), pixels(p.height)};
    session_.view.legend = picture_.legend;
    draw_labels();
  }

  void draw_labels() {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const Rectangle& p = layout_.picture;
    const Theme& colours = theme(session_.view.dark);
    draw.PushClipRect({p.x, p.y}, {p.x + p.width, p.y + p.height});
    std::vector<ImVec4> plates;
    for (const Label& label : picture_.labels) {
      const glm::dvec3 pixel =
          session_.view.camera.project(label.place, session_.view.picture_size);
      if (pixel.z <= 0) continue;
      const ImVec2 at{std::round(p.x + static_cast<float>(pixel.x) + 5),
                      std::round(p.y + static_cast<float>(pixel.y) - 16)};
      if (label.plate) {
        draw_on_plate(draw, label, at, plates);
        continue;
      }
      const float size = fonts_.small->FontSize / font_scale_;
      for (const ImVec2 by : {ImVec2(-1, 0), ImVec2(1, 0), ImVec2(0, -1), ImVec2(0, 1)})
        draw.AddText(fonts_.small, size, {at.x + by.x, at.y + by.y},
                     packed(with_alpha(colours.text_halo, 0.8f)), label.text.c_str());
      draw.AddText(fonts_.small, size, at, packed(label.colour), label.text.c_str());
    }
    draw.PopClipRect();
  }

  /// Below the plates that are in its way.
  void draw_on_plate(ImDrawList& draw, const Label& label, ImVec2 at,
                     std::vector<ImVec4>& plates) const {
    const float size = fonts_.regular->FontSize / font_scale_;
    const ImVec2 room = fonts_.regular->CalcTextSizeA(size, FLT_MAX, 0, label.text.c_str());
    const Rectangle& p = layout_.picture;
    at.x = std::clamp(at.x, p.x + 8, std::max(p.x + 8, p.x + p.width - room.x - 8));
    at.y = std::clamp(at.y, p.y + 6, std::max(p.y + 6, p.y + p.height - room.y - 6));
    const auto in_the_way = [&](const ImVec4& other) {
      return at.x - 7 < other.z && at.x + room.x + 7 > other.x && at.y - 4 < other.w &&
             at.y + room.y + 4 > other.y;
    };
    for (auto other = plates.begin(); other != plates.end();) {
      if (!in_the_way(*other)) {
        ++other;
        continue;
      }
      at.y = other->w + 6;
      other = plates.begin();
    }
    const ImVec2 low{at.x - 7, at.y - 4}, high{at.x + room.x + 7, at.y + room.y + 4};
    plates.push_back({low.x, low.y, high.x, high.y});
    draw.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_PopupBg, 0.94f), 5);
    draw.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border), 5);
    draw.AddText(fonts_.regular, size, at, packed(label.colour), label.text.c_str());
  }

  GraphicsContext& context_;
  AppOptions options_;
  InterfaceContext interface_;
  Renderer renderer_;
  Session session_;
  Commands commands_;
  Widgets widgets_;
  EventQueue events_;
  Navigation navigation_;
  PictureMaker pictures_;
  Picture picture_;  // of the last frame
  Viewport viewport_;
  bool is_drawn_ = true;
  Layout layout_;
  Fonts fonts_;
  float font_scale_ = 0;
  bool menu_was_open_ = false;
  int settling_ = 2;
  bool tooltip_pending_ = false;
  bool was_busy_ = false;  // when the last frame was drawn, which says so
  Camera seen_camera_;
  double still_for_ = 0;  // the camera, in seconds
  std::pair<std::shared_ptr<const Story>, std::size_t> followed_;
};

App::App(GraphicsContext& context, const AppOptions& options)
    : implementation_(std::make_unique<Implementation>(context, options)) {}
App::~App() = default;

void App::frame(const Input& input, double seconds) {
  implementation_->frame(input, seconds);
}
bool App::wants_to_close() const {
  return implementation_->session().interface.wants_to_close;
}
bool App::needs_frame() const {
  return implementation_->needs_frame();
}
double App::time_to_next_frame() const {
  return implementation_->time_to_next_frame();
}
void App::record(const RecordingPlan& plan) {
  implementation_->session().record(plan);
}
std::vector<Image> App::film(const RecordingPlan& plan) {
  return implementation_->film(plan);
}
const DrawnWork& App::drawn() const {
  return implementation_->drawn();
}
void App::draw() {
  implementation_->draw();
}
Image App::screenshot() {
  return implementation_->screenshot();
}

void App::open(const std::filesystem::path& path) {
  implementation_->session().open(path);
}
void App::open_sample(const std::string& name) {
  implementation_->session().open_sample(name);
}
void App::start(Scene scene, const std::filesystem::path& path) {
  implementation_->session().start(std::move(scene), path);
}
void App::add(const std::filesystem::path& path, const std::vector<MeshPart>& parts) {
  implementation_->session().add_imported(path, parts);
}
const Scene& App::scene() const {
  return implementation_->session().scene();
}
const Camera& App::camera() const {
  return implementation_->session().view.camera;
}
void App::set_camera(const Camera& camera) {
  implementation_->session().keep_camera(camera);
}

void App::show_step(Phase phase, std::size_t step) {
  implementation_->session().set_mode(Mode::steps);
  implementation_->session().results.player.go_to(phase, step);
}

const Widgets& App::widgets() const {
  return implementation_->widgets();
}
const Session& App::session() const {
  return implementation_->session();
}

glm::vec4 App::widget(const std::string& name) const {
  const Widget* found = implementation_->widgets().find(name);
  if (!found) throw std::out_of_range("There is no widget called " + name + " in the last frame.");
  return found->rectangle;
}

bool App::has_widget(const std::string& name) const {
  return implementation_->widgets().find(name) != nullptr;
}

glm::dvec2 App::on_screen(const glm::dvec3& point) const {
  return implementation_->on_screen(point);
}
std::string App::title() const {
  const Document& document = implementation_->session().document;
  if (document.path().empty() && implementation_->session().scene().is_empty()) return "Sectile";
  const std::string name =
      document.path().empty() ? "unnamed" : document.path().filename().string();
  return (document.is_changed() ? "*" : "") + name + " \u2013 Sectile";
}
std::string App::last_message() const {
  return implementation_->session().interface.messages.last();
}

}  // namespace sectile::viewer

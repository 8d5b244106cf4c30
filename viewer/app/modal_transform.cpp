#include "app/modal_transform.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <stdexcept>
#include <string_view>

#include "app/typed_number.h"
#include "app/words.h"
#include "picture/theme.h"

namespace sectile::viewer {
namespace {

constexpr const char* axis_names[] = {"X", "Y", "Z"};

const char* name_of(HandleMode mode) {
  return mode == HandleMode::move ? "Move" : mode == HandleMode::rotate ? "Rotate" : "Scale";
}

/// Nothing while what is typed is not complete.
std::optional<double> number_in(const std::string& text) {
  try {
    return typed_number(text, Quantity::plain);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

double angle_of(const glm::dvec2& on_screen) {
  return std::atan2(-on_screen.y, on_screen.x);
}

}  // namespace

ModalTransform::ModalTransform(Session& session, HandleMode mode, glm::dvec2 pointer)
    : mode_(mode) {
  start_.at = now_.at = pointer;
  session.view.handles = mode;
  axes_ = session.view.local_axes || mode == HandleMode::scale ? Axes::own : Axes::world;
  start_again(session);
}

std::string ModalTransform::title() const {
  return name_of(mode_);
}

std::string ModalTransform::hint(const ViewState&) const {
  return std::string(
             "X, Y or Z: along an axis (again: its own) \u00B7 Shift+X\u2026: across it "
             "\u00B7 type a number") +
         (mode_ == HandleMode::rotate ? "" : " (Tab: the next)") +
         " \u00B7 Ctrl: snap or not \u00B7 Enter or click: take \u00B7 Esc: give back";
}

HandlePart ModalTransform::part() const {
  if (!axis_) return HandlePart::centre;
  const HandlePart first = mode_ == HandleMode::rotate ? HandlePart::ring_x
                           : plane_                    ? HandlePart::plane_x
                                                       : HandlePart::axis_x;
  return static_cast<HandlePart>(static_cast<int>(first) + *axis_);
}

void ModalTransform::start_again(Session& session) {
  session.document.drop_draft();
  const bool own = axes_ == Axes::own;
  handles_ = handles_of(session, own);
  const glm::dvec2 pivot(session.view.camera.project(handles_->origin, session.view.picture_size));
  pull_.emplace(session, *handles_, part(), pivot, own);
  last_angle_ = angle_of(start_.at - pivot);
  turned_ = 0;
  targets_.forget_unused();
}

void ModalTransform::constrain(Session& session, int axis, bool plane) {
  plane = plane && mode_ != HandleMode::rotate;
  const bool again = axis_ == axis && plane_ == plane;
  const bool scales = mode_ == HandleMode::scale;  // along other axes it would shear
  const Axes first = session.view.local_axes || scales ? Axes::own : Axes::world;
  if (again && axes_ == first && !scales) {
    axes_ = first == Axes::own ? Axes::world : Axes::own;
  } else if (again) {
    axis_.reset(), plane_ = false, axes_ = first;
  } else {
    axis_ = axis, plane_ = plane, axes_ = first;
  }
  start_again(session);
  show(session);
}

bool ModalTransform::is_free(int axis) const {
  return !axis_ || (plane_ ? axis != *axis_ : axis == *axis_);
}

bool ModalTransform::has_numbers() const {
  for (const std::string& typed : typed_)
    if (number_in(typed)) return true;
  return false;
}

HandleChange ModalTransform::by_numbers() const {
  HandleChange change;
  change.axis = axis_ ? handles_->axes[*axis_] : glm::dvec3(0, 0, 1);
  const std::optional<double> first = number_in(typed_[0]);
  if (mode_ == HandleMode::rotate) {
    change.degrees = first.value_or(0);
    return change;
  }
  const bool uniform = mode_ == HandleMode::scale && !number_in(typed_[1]) && !number_in(typed_[2]);
  std::size_t next = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_free(axis)) continue;
    const std::optional<double> value = uniform ? first : number_in(typed_[next++]);
    if (!value) continue;
    if (mode_ == HandleMode::move) change.move += handles_->axes[axis] * *value;
    // Nothing is flat: a factor of zero is not taken.
    if (mode_ == HandleMode::scale && *value != 0) change.scale[axis] = *value;
  }
  return change;
}

double ModalTransform::factor(const ViewState& view) const {
  const glm::dvec2 pivot(view.camera.project(handles_->origin, view.picture_size));
  const double from = std::max(10.0, glm::distance(start_.at, pivot));
  return std::max(0.01, glm::distance(now_.at, pivot) / from);
}

HandleChange ModalTransform::by_pointer(const ViewState& view) {
  HandleChange change;
  const Camera& camera = view.camera;
  const glm::dvec2 pivot(camera.project(handles_->origin, view.picture_size));
  if (mode_ == HandleMode::scale) {
    for (int axis = 0; axis < 3; ++axis)
      if (is_free(axis)) change.scale[axis] = factor(view);
    return change;
  }
  const double angle = angle_of(now_.at - pivot), turn = glm::two_pi<double>();
  turned_ += std::remainder(angle - last_angle_, turn);
  last_angle_ = angle;
  change.axis = axis_ ? handles_->axes[*axis_] : -camera.forward();
  const bool faces_away = glm::dot(change.axis, camera.forward()) > 0;
  change.degrees = glm::degrees(faces_away ? -turned_ : turned_);
  return change;
}

void ModalTransform::show(Session& session) {
  const bool snapping = session.view.snapping != now_.control;
  if (has_numbers()) {
    pull_->show(session, by_numbers(), false, targets_);
  } else if (mode_ == HandleMode::move) {
    // The handles follow the pointer from wherever it started.
    const glm::dvec2 pivot(
        session.view.camera.project(handles_->origin, session.view.picture_size));
    pull_->pull(session, pivot + now_.at - start_.at, snapping, targets_);
  } else {
    pull_->show(session, by_pointer(session.view), snapping, targets_);
  }
  session.interface.dragging = told();
}

void ModalTransform::follow(Session& session, const Pointer& pointer) {
  now_ = pointer;
  show(session);
}

void ModalTransform::press(Session& session, const Pointer&) {
  session.document.commit_draft();
  session.interface.dragging.clear();
  finish();
}

void ModalTransform::give_up(Session& session) {
  session.document.drop_draft();
  session.interface.dragging.clear();
}

bool ModalTransform::key(Session& session, const Event& event) {
  const char letter = static_cast<char>(event.key);
  if (event.key == Key::enter || event.key == Key::space) {
    press(session, now_);
  } else if (event.key == Key::tab && mode_ != HandleMode::rotate) {
    place_ = (place_ + 1) % typed_.size();
  } else if (event.key == Key::backspace) {
    if (number().empty() && place_ > 0) --place_;
    if (!number().empty()) number().pop_back();
    show(session);
  } else if (letter >= 'X' && letter <= 'Z' && !event.control) {
    constrain(session, letter - 'X', event.shift);
  } else if ((letter == 'G' || letter == 'R' || letter == 'S') && !event.control) {
    mode_ = letter == 'G'   ? HandleMode::move
            : letter == 'R' ? HandleMode::rotate
                            : HandleMode::scale;
    session.view.handles = mode_;
    typed_ = {}, place_ = 0, plane_ = false;
    axes_ = session.view.local_axes || mode_ == HandleMode::scale ? Axes::own : Axes::world;
    start_ = now_;
    start_again(session);
    show(session);
  }
  return true;  // whatever it was, it was not meant for the commands
}

void ModalTransform::text(Session& session, const std::string& typed) {
  for (const char c : typed) {
    if (c == '-') {
      // A sign may come at any time.
      if (!number().empty() && number().front() == '-')
        number().erase(0, 1);
      else
        number().insert(0, 1, '-');
    } else if ((c >= '0' && c <= '9') ||
               std::string_view(".,/*+()").find(c) != std::string_view::npos) {
      number() += c;
    }
  }
  show(session);
}

std::string ModalTransform::told() const {
  std::string text = pull_->state().text;
  // A turn says its axis already.
  if (axis_ && !(mode_ == HandleMode::rotate && axes_ == Axes::world)) {
    const std::string own = axes_ == Axes::own ? "own " : "";
    text += std::string("   ") +
            (plane_                        ? "across "
             : mode_ == HandleMode::rotate ? "about "
                                           : "along ") +
            own + axis_names[*axis_];
  }
  bool any = false;
  for (const std::string& typed : typed_) any |= !typed.empty();
  if (!any) return text;
  text += "   typed:";
  const std::size_t last =
      typed_[2].empty() && place_ < 2 ? (typed_[1].empty() && place_ < 1 ? 0 : 1) : 2;
  for (std::size_t i = 0; i <= last; ++i)
    text += " " + (typed_[i].empty() ? "\u2013" : typed_[i]) + (i == place_ ? "|" : "");
  return text;
}

void ModalTransform::add_to(Picture& picture, const ViewState& view) const {
  const Theme& colours = theme(view.dark);
  const Colour of_axis[] = {colours.handle_x, colours.handle_y, colours.handle_z};
  const glm::dvec3 origin = handles_->origin;
  const double far = 12 * handles_->size;
  for (int axis = 0; axis < 3; ++axis)
    if (axis_ && is_free(axis))
      picture.lines.push_back({{glm::vec3(origin - far * handles_->axes[axis]),
                                glm::vec3(origin + far * handles_->axes[axis])},
                               of_axis[axis],
                               2,
                               true});
  PullState state = pull_->state();
  state.text = told();
  add_marks(picture, view, pull_->handles(), state);
}

}  // namespace sectile::viewer

// Where in the tour of the paper one is.
#pragma once

#include <cstddef>
#include <optional>

namespace sectile::viewer {

class Session;
struct Station;

class TourGuide {
 public:
  bool is_on() const { return at_.has_value(); }
  std::size_t at() const { return at_.value_or(0); }
  static std::size_t count();
  const Station& station() const;

  /// Opens the station's scene in the place of the present one and tells its steps.
  void go_to(Session& session, std::size_t station);
  void next(Session& session);
  void previous(Session& session);
  void end() { at_.reset(); }
  /// To the station's step, as soon as it is told.
  void update(Session& session);

  bool shows_answer = false;

 private:
  std::optional<std::size_t> at_;
  bool is_waiting_ = false;
};

}  // namespace sectile::viewer

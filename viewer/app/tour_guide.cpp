#include "app/tour_guide.h"

#include "app/session.h"
#include "tour/station.h"

namespace sectile::viewer {

std::size_t TourGuide::count() {
  return stations().size();
}

const Station& TourGuide::station() const {
  return stations().at(at());
}

void TourGuide::go_to(Session& session, std::size_t station) {
  at_ = station;
  shows_answer = false;
  is_waiting_ = true;
  session.results.player.forget();
  session.open_sample(this->station().sample);
  session.view.exploded = this->station().exploded;
  session.view.eight_way = this->station().eight_way;
  session.set_mode(Mode::steps);
}

void TourGuide::next(Session& session) {
  if (at() + 1 < count()) go_to(session, at() + 1);
}

void TourGuide::previous(Session& session) {
  if (at() > 0) go_to(session, at() - 1);
}

void TourGuide::update(Session& session) {
  if (!is_on() || !is_waiting_ || !session.results.player.story() || session.is_busy()) return;
  is_waiting_ = false;
  if (const std::optional<std::size_t> step = step_of(station(), *session.results.player.story()))
    session.results.player.go_to(*step);
  else
    session.results.player.go_to(station().phase, 0);
}

}  // namespace sectile::viewer

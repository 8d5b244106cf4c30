#include "boolean/reduction/pierced_faces.h"

#include <algorithm>
#include <functional>

#include "search/bucket_sort.h"

namespace sectile {
namespace {

// The contact of each place that has one, of a face and something else.
Table<PlaceId, ContactId> only_contacts(const Contacts& found) {
  Table<PlaceId, ContactId> only(found.places.size());
  Table<PlaceId, std::uint8_t> seen(found.places.size(), 0);
  for (const ContactId i : found.contacts.ids()) {
    const Contact& c = found.contacts[i];
    const bool pierces = c.on[Operand::a].is_face() || c.on[Operand::b].is_face();
    only[c.place] = seen[c.place] == 0 && pierces ? i : ContactId();
    seen[c.place] = 1;
  }
  return only;
}

}  // namespace

PiercedFaces::PiercedFaces(const Workspace& w, const Contacts& found) {
  // Where one vertex or edge was tested for many, or pairs were left out, contacts do not tell all
  // that meets.
  const auto tells_all = [&](const Patch& patch) {
    return !patch.tested.any() && w.crowded_lines.empty();
  };
  if (std::all_of(w.patch.begin(), w.patch.end(), tells_all)) {
    only_ = only_contacts(found);
    for (const Operand s : both_operands) group(found, s, w.patch[s].brep.face_count());
  } else {
    only_.resize(found.places.size());
  }
  for (const PlaceId place : found.places.ids())
    if (!only_[place].valid()) others_.push_back(place);
  std::sort(others_.begin(), others_.end());
}

void PiercedFaces::group(const Contacts& found, Operand s, std::size_t faces) {
  OfOperand& of = of_[s];
  const auto face = [&](PlaceId place) {
    return found.contacts[only_[place]].on[s].face().value();
  };
  for (const PlaceId place : only_.ids())
    if (only_[place].valid() && found.contacts[only_[place]].on[s].is_face())
      of.place.push_back(place);
  of.first = bucket_sort(of.place, faces, face, std::less<>());
  for (std::size_t f = 0; f < faces; ++f)
    if (const std::uint32_t from = of.first[f], to = of.first[f + 1]; to - from > most_places)
      others_.insert(others_.end(), of.place.begin() + from, of.place.begin() + to);
}

}  // namespace sectile

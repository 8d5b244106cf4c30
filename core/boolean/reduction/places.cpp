// Step (4) of section 5 of the paper, for any number of vertices and edges at one point.
#include <algorithm>
#include <numeric>
#include <span>

#include "boolean/reduction/contact_table.h"
#include "search/large_sort.h"

namespace sectile {

void find_places(Workspace& w, std::size_t first_contact) {
  const auto position = [&](std::uint32_t i) -> const Vec3& {
    return w.geometry.position(w.contacts[i].point);
  };
  std::vector<std::uint32_t> order(w.contacts.size() - first_contact);
  std::iota(order.begin(), order.end(), static_cast<std::uint32_t>(first_contact));
  large_sort(order, [&](std::uint32_t i, std::uint32_t j) {
    const Vec3 &p = position(i), &q = position(j);
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    if (p.z != q.z) return p.z < q.z;
    return i < j;
  });
  // Equal points have equal rounded positions; among these, exact tests decide.
  PlaceId first_place = w.places.end_id();
  for (std::size_t i = 0; i < order.size(); ++i) {
    Contact& contact = w.contacts[order[i]];
    if (i == 0 || !(position(order[i]) == position(order[i - 1]))) first_place = w.places.end_id();
    PlaceId place;
    for (const PlaceId known : w.places.ids_from(first_place)) {
      if (!w.tests().same_point(w.point(known), contact.point)) continue;
      place = known;
      break;
    }
    if (!place.valid()) place = w.places.add(contact.point);
    if (!w.geometry.is_constructed(contact.point)) w.places[place] = contact.point;
    contact.place = place;
  }
  // Vertices at one place share one point from now on.
  for (const Contact& contact : std::span(w.contacts).subspan(first_contact))
    for (int s = 0; s < 2; ++s)
      if (contact.on[s].is_vertex())
        w.patch[s].brep.point[contact.on[s].vertex().value()] = w.places[contact.place];
}

}  // namespace sectile

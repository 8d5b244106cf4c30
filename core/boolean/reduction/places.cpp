// Step (4) of section 5 of the paper, for any number of vertices and edges at one point.
#include <algorithm>
#include <span>

#include "boolean/reduction/contact_table.h"
#include "search/large_sort.h"

namespace sectile {

void find_places(Workspace& w, ContactId first, Contacts& found) {
  const auto position = [&](ContactId i) -> const Vec3& {
    return w.geometry.position(found.contacts[i].point);
  };
  const IdRange<ContactId> contacts = found.contacts.ids_from(first);
  std::vector<ContactId> order;
  order.reserve(contacts.size());
  for (const ContactId i : contacts) order.push_back(i);
  large_sort(order, [&](ContactId i, ContactId j) {
    const Vec3 &p = position(i), &q = position(j);
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    if (p.z != q.z) return p.z < q.z;
    return i < j;
  });
  // Equal points have equal rounded positions; among these, exact tests decide.
  PlaceId first_place = found.places.end_id();
  for (std::size_t i = 0; i < order.size(); ++i) {
    Contact& contact = found.contacts[order[i]];
    if (i == 0 || !(position(order[i]) == position(order[i - 1])))
      first_place = found.places.end_id();
    PlaceId place;
    for (const PlaceId known : found.places.ids_from(first_place)) {
      if (!w.tests().same_point(found.point(known), contact.point)) continue;
      place = known;
      break;
    }
    if (!place.valid()) place = found.places.add(contact.point);
    if (!w.geometry.is_constructed(contact.point)) found.places[place] = contact.point;
    contact.place = place;
  }
  // Vertices at one place share one point from now on.
  for (const Contact& contact : found.contacts[contacts])
    for (const Operand s : both_operands)
      if (contact.on[s].is_vertex())
        w.patch[s].brep.point[contact.on[s].vertex()] = found.places[contact.place];
}

}  // namespace sectile

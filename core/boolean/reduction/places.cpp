// Step (4) of section 5 of the paper, for any number of vertices and edges at one point.
#include <algorithm>
#include <tuple>

#include "boolean/reduction/contact_table.h"
#include "search/large_sort.h"

namespace sectile {
namespace {

// As neighbouring pairs of faces find them, not along an axis: what is near in the solids is near
// in all tables from here on.
void number_in_order_of_contacts(const IdRange<ContactId>& contacts, PlaceId first,
                                 Contacts& found) {
  Table<PlaceId, PlaceId> number(found.places.size());
  Table<PlaceId, PointId> places;
  for (const PlaceId place : found.places.ids())
    if (place < first) places.add(found.places[place]);
  for (const ContactId i : contacts) {
    PlaceId& place = found.contacts[i].place;
    if (!number[place].valid()) number[place] = places.add(found.places[place]);
    place = number[place];
  }
  found.places = std::move(places);
}

}  // namespace

void find_places(Workspace& w, ContactId first, Contacts& found) {
  struct At {
    Vec3 position;
    ContactId contact;
  };
  const IdRange<ContactId> contacts = found.contacts.ids_from(first);
  std::vector<At> order;
  order.reserve(contacts.size());
  for (const ContactId i : contacts)
    order.push_back({w.geometry.position(found.contacts[i].point), i});
  large_sort(order, [&](const At& i, const At& j) {
    const Vec3 &p = i.position, &q = j.position;
    return std::tie(p.x, p.y, p.z, i.contact) < std::tie(q.x, q.y, q.z, j.contact);
  });
  // Equal points have equal rounded positions; among these, exact tests decide.
  const PlaceId first_new = found.places.end_id();
  PlaceId first_place = first_new;
  for (std::size_t i = 0; i < order.size(); ++i) {
    Contact& contact = found.contacts[order[i].contact];
    if (i == 0 || !(order[i].position == order[i - 1].position))
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
  number_in_order_of_contacts(contacts, first_new, found);
  // Vertices at one place share one point from now on.
  for (const Contact& contact : found.contacts[contacts])
    for (const Operand s : both_operands)
      if (contact.on[s].is_vertex())
        w.patch[s].brep.point[contact.on[s].vertex()] = found.places[contact.place];
  for (Patch& patch : w.patch)
    if (patch.tested.any())
      for (const VertexId v : patch.brep.vertices())
        patch.brep.point[v] = patch.brep.point[patch.tested(v)];
}

}  // namespace sectile

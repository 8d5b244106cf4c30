#include "import/diagnosis.h"
#include "sectile/repair.h"

namespace sectile {
namespace {

using Kind = RepairChange::Kind;

struct Words {
  const char *name, *one, *many;
};

Words words_for(Kind kind) {
  switch (kind) {
    case Kind::united_vertices:
      return {"united_vertices", "vertex at the place of another one united with it",
              "vertices at the places of others united with them"};
    case Kind::removed_flat:
      return {"removed_flat", "face without area removed", "faces without area removed"};
    case Kind::removed_copies:
      return {"removed_copies", "face that repeats another one removed",
              "faces that repeat others removed"};
    case Kind::split_polygons:
      return {"split_polygons", "polygon that is not plane or crosses itself split into triangles",
              "polygons that are not plane or cross themselves split into triangles"};
    case Kind::divided_edges:
      return {"divided_edges", "corner of another face put into an edge on which it lies",
              "corners of other faces put into edges on which they lie"};
    case Kind::stitched_vertices:
      return {"stitched_vertices", "vertex on a border moved onto another one",
              "vertices on borders moved onto others"};
    case Kind::turned_faces:
      return {"turned_faces", "face turned around to agree with its neighbours",
              "faces turned around to agree with their neighbours"};
    case Kind::turned_parts:
      return {"turned_parts", "surface that was inside out turned around",
              "surfaces that were inside out turned around"};
    case Kind::closed_holes:
      return {"closed_holes", "hole closed", "holes closed"};
    case Kind::divided_faces:
      return {"divided_faces", "face divided where others meet it",
              "faces divided where others meet them"};
    case Kind::overlaps:
      return {"overlaps", "place where faces lie on each other made one face",
              "places where faces lie on each other made one face each"};
    case Kind::removed_faces:
      break;
  }
  return {"removed_faces", "face that bounds no material removed",
          "faces that bound no material removed"};
}

}  // namespace

std::string name_of(RepairChange::Kind kind) {
  return words_for(kind).name;
}

std::string in_words(const RepairChange& change) {
  const Words words = words_for(change.kind);
  const bool one = change.count == 1;
  std::string text = std::to_string(change.count) + " " + (one ? words.one : words.many) +
                     (one ? ", at " : ", the first at ") + in_words(change.where);
  if (change.face != no_element) text += ", face " + std::to_string(change.face);
  return text;
}

}  // namespace sectile

#include "evaluation/value_table.h"

#include <algorithm>
#include <vector>

namespace sectile::viewer {

ValueKey& ValueKey::add(const Transform& transform) {
  for (const double entry : transform.m) add(entry);
  return *this;
}

ValueKey& ValueKey::add(const std::vector<Vec2>& points) {
  add(points.size());
  for (const Vec2& point : points) add(point.x).add(point.y);
  return *this;
}

ValueKey& ValueKey::add(const Primitive& p) {
  add(p.kind).add(p.size).add(p.radius).add(p.top_radius).add(p.minor_radius).add(p.height);
  add(p.segments).add(p.rings).add(p.profile.outer).add(p.profile.holes.size());
  for (const std::vector<Vec2>& hole : p.profile.holes) add(hole);
  return *this;
}

ValuePointer ValueTable::find(const ValueKey& key) {
  const auto found = values_.find(key.bytes());
  if (found == values_.end()) return nullptr;
  found->second->last_used = now_;
  return found->second;
}

ValuePointer ValueTable::add(const ValueKey& key, Value value) {
  value.id = next_id_++;
  value.last_used = now_;
  auto made = std::make_shared<Value>(std::move(value));
  values_[key.bytes()] = made;
  return made;
}

void ValueTable::forget_unused(std::size_t faces) {
  using Item = decltype(values_)::iterator;
  std::vector<Item> unused;
  std::size_t held = 0;
  for (auto item = values_.begin(); item != values_.end(); ++item)
    if (item->second->last_used != now_) {
      unused.push_back(item);
      held += item->second->faces + 100;  // even a value without faces takes memory
    }
  std::sort(unused.begin(), unused.end(), [](const Item& a, const Item& b) {
    return a->second->last_used < b->second->last_used;
  });
  for (const Item& item : unused) {
    if (held <= faces) break;
    held -= item->second->faces + 100;
    values_.erase(item);
  }
}

}  // namespace sectile::viewer

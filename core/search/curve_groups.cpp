#include "search/curve_groups.h"

#include <algorithm>

#include "search/hilbert.h"

namespace sectile {
namespace {

class Grouping {
 public:
  Grouping(std::span<const std::uint64_t> keys, std::size_t least, std::size_t most)
      : keys_(keys), least_(least), most_(most) {}

  std::vector<std::size_t> ends() {
    divide(0, keys_.size(), 32 + HilbertCurve::bits);
    if (begin_ < keys_.size()) ends_.push_back(keys_.size());
    return std::move(ends_);
  }

 private:
  // The keys of a cube, which differ in the bits below `shift` only.
  void divide(std::size_t from, std::size_t to, unsigned shift) {
    if (to - from <= most_) return add(from, to);
    if (shift == 32) {
      for (; to - from > most_; from += most_) add(from, from + most_);
      return add(from, to);
    }
    close(from);
    while (from < to) {
      const std::uint64_t octant = keys_[from] >> (shift - 3);
      const auto end =
          std::partition_point(keys_.begin() + static_cast<std::ptrdiff_t>(from),
                               keys_.begin() + static_cast<std::ptrdiff_t>(to),
                               [&](std::uint64_t key) { return key >> (shift - 3) == octant; });
      const auto middle = static_cast<std::size_t>(end - keys_.begin());
      divide(from, middle, shift - 3);
      from = middle;
    }
    close(to);
  }

  void add(std::size_t from, std::size_t to) {
    if (to - begin_ > most_) close(from);
  }

  // A group that is too small joins the one before it, if that has room, or else the one behind.
  void close(std::size_t end) {
    if (end - begin_ >= least_)
      ends_.push_back(end);
    else if (!ends_.empty() && end - begin_of_last() <= most_ + 2 * least_)
      ends_.back() = end;
    else
      return;
    begin_ = end;
  }
  std::size_t begin_of_last() const { return ends_.size() < 2 ? 0 : ends_[ends_.size() - 2]; }

  std::span<const std::uint64_t> keys_;
  std::size_t least_, most_, begin_ = 0;  // of the group that is open
  std::vector<std::size_t> ends_;
};

}  // namespace

void add_groups_along_curve(std::span<const std::uint64_t> keys, std::size_t least,
                            std::size_t most, std::uint32_t first,
                            std::vector<std::uint32_t>& ends) {
  for (const std::size_t end : Grouping(keys, least, most).ends())
    ends.push_back(first + static_cast<std::uint32_t>(end));
}

}  // namespace sectile

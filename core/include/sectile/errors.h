// The exceptions of the library. Every one says what is wrong, where, and what to do about it.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sectile/mesh.h"

namespace sectile {

/// "No such element" in the element numbers that exceptions carry.
inline constexpr std::uint32_t no_element = std::numeric_limits<std::uint32_t>::max();

/// Base of all exceptions thrown by the library.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Two faces that cross or lie on each other, or along whose common line material is on both sides.
struct FaceContact {
  std::uint32_t face = no_element, other = no_element;  ///< of the input
  Vec3 where;                                           ///< a place near it
  std::string what;                                     ///< in words, without the place
};

/// The input does not bound a legal solid. Nothing was changed.
class InvalidSolid : public Error {
 public:
  enum class Reason {
    malformed,           ///< sizes and indices do not fit together
    index_out_of_range,  ///< a corner refers to a position that does not exist
    not_finite,          ///< a coordinate is NaN or infinite
    open,                ///< an edge has no face on its other side
    inconsistent,        ///< faces around an edge are not consistently oriented
    inside_out,          ///< the material would be infinite
    self_intersecting    ///< faces cross each other
  };
  InvalidSolid(Reason reason, const std::string& message, std::uint32_t face = no_element,
               std::uint32_t vertex = no_element)
      : Error(message), reason_(reason), face_(face), vertex_(vertex) {}
  /// `contacts` has at least one element.
  InvalidSolid(const std::string& message, std::vector<FaceContact> contacts)
      : Error(message),
        reason_(Reason::self_intersecting),
        face_(contacts.front().face),
        contacts_(std::move(contacts)) {}

  Reason reason() const { return reason_; }
  std::uint32_t face() const { return face_; }  ///< the input's face concerned, or no_element
  std::uint32_t vertex() const {
    return vertex_;
  }  ///< the input's position concerned, or no_element
  /// Every two faces that meet as those of a solid cannot, if that is what is wrong.
  const std::vector<FaceContact>& contacts() const { return contacts_; }
  /// The first such place.
  std::optional<Vec3> where() const {
    return contacts_.empty() ? std::nullopt : std::optional(contacts_.front().where);
  }

 private:
  Reason reason_;
  std::uint32_t face_ = no_element, vertex_ = no_element;
  std::vector<FaceContact> contacts_;
};

/// A file cannot be read or written, or is not what its format says. The message names file and
/// line.
class FileError : public Error {
 public:
  using Error::Error;
};

/// The work was cancelled from outside; operands are untouched and there is no result.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

/// A state that cannot be: a defect of the library. The operands were saved for reproduction.
class InternalError : public Error {
 public:
  using Error::Error;
};

}  // namespace sectile

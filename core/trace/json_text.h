// JSON, written as it comes: no document is kept in memory, and running out of memory is an
// exception like any other. Each value stands on a line of its own, indented by its depth.
#pragma once

#include <ostream>
#include <string_view>

namespace sectile {

class JsonText {
 public:
  explicit JsonText(std::ostream& out) : out_(out) {}

  void begin_object() { begin('{'); }
  void end_object() { end('}'); }
  void begin_array() { begin('['); }
  void end_array() { end(']'); }
  /// The next value is the object's member of this name.
  void name(std::string_view text);

  void value(std::string_view text);
  void value(const char* text) { value(std::string_view(text)); }
  void value(bool truth) { plain(truth ? "true" : "false"); }
  void value(double number);  ///< null if it is not finite
  void value(int number);
  void value(std::size_t number);

 private:
  void begin(char bracket);
  void end(char bracket);
  void plain(std::string_view text);
  void quoted(std::string_view text);
  void new_line();
  void before_value();

  std::ostream& out_;
  int depth_ = 0;
  bool is_first_ = true;    // in the innermost object or array
  bool is_member_ = false;  // its name was just written
};

}  // namespace sectile

// What the program has to say to the person: shown over the picture until read or dismissed, and
// kept in a list with its time.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace sectile::viewer {

struct Message {
  std::string text;  ///< a sentence
  bool is_error = false;
  double seconds_left = 0;  ///< errors stay until they are closed
  std::chrono::system_clock::time_point time;
};

class Messages {
 public:
  void tell(std::string text);
  void error(std::string text);
  void pass(double seconds);
  void close(std::size_t index);
  void close_all();

  /// The newest ones that were not closed; not more than there is room for.
  const std::vector<Message>& shown() const { return shown_; }
  /// How many errors are neither shown nor closed, because there is no room.
  std::size_t waiting() const { return waiting_; }
  /// Everything that was said, the oldest first.
  const std::vector<Message>& all() const { return all_; }
  const std::string& last() const { return last_; }
  bool is_fading() const;  ///< one of them will vanish by itself

  bool list_open = false;  ///< the list of all of them is on the screen

 private:
  void add(Message message);
  std::vector<Message> shown_, all_;
  std::size_t waiting_ = 0;
  std::string last_;
};

}  // namespace sectile::viewer

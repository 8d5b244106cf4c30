// What the program has to say to the person: shown over the picture until read or dismissed.
#pragma once

#include <string>
#include <vector>

namespace sectile::viewer {

struct Message {
  std::string text;
  bool is_error = false;
  double seconds_left = 0;  ///< errors stay until they are closed
};

class Messages {
 public:
  void tell(std::string text);
  void error(std::string text);
  void pass(double seconds);
  void close(std::size_t index);

  const std::vector<Message>& shown() const { return shown_; }
  const std::string& last() const { return last_; }
  bool is_fading() const;  ///< one of them will vanish by itself

 private:
  void add(Message message);
  std::vector<Message> shown_;
  std::string last_;
};

}  // namespace sectile::viewer

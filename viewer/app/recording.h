// Pictures and films of the scene for files: one frame after another, without the interface.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "picture/camera.h"
#include "render/graphics_context.h"

namespace sectile::viewer {

class Results;
struct ViewState;

struct RecordingPlan {
  enum class Kind : std::uint8_t {
    picture,    ///< as it is seen now
    turntable,  ///< once around
    steps       ///< the steps of the story, one frame for each
  };
  Kind kind = Kind::picture;
  std::uint32_t width = 1280, height = 800;
  std::uint32_t frames = 48;  ///< of a turntable
  double seconds_per_frame = 0.08;
  /// A film ends in .gif, or in .png: then its frames are numbered, name-001.png and so on.
  std::filesystem::path path;

  bool is_film() const { return kind != Kind::picture; }
};

/// What is wrong with a plan, in words; empty if nothing is.
std::string problem_of(const RecordingPlan& plan, const Results& results);
/// The file of a numbered frame, counted from 0.
std::filesystem::path numbered(const std::filesystem::path& path, std::size_t frame,
                               std::size_t frames);
/// Writes what was recorded. Throws FileError and std::runtime_error.
void write_recording(const RecordingPlan& plan, const std::vector<Image>& images);

/// Goes through the frames of a plan.
class Recording {
 public:
  Recording(RecordingPlan plan, Results& results, const ViewState& view);
  const RecordingPlan& plan() const { return plan_; }
  /// Places camera or step for the next frame; false if all are made: then they stand as before.
  bool prepare(Results& results, ViewState& view);
  void add(Image image) { images_.push_back(std::move(image)); }
  std::vector<Image> take() { return std::move(images_); }
  std::size_t done() const { return images_.size(); }
  std::size_t frames() const { return frames_; }
  void stop(Results& results, ViewState& view) const;  ///< everything as before

 private:
  RecordingPlan plan_;
  std::size_t frames_ = 1;
  Camera camera_;
  std::size_t step_ = 0;
  std::vector<Image> images_;
};

}  // namespace sectile::viewer

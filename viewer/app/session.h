// The state of one session of the modeller and everything that a person can do to it. Knows no
// widgets: panels, keys and tests all call the same functions.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/dialogs.h"
#include "app/document.h"
#include "app/file_work.h"
#include "app/messages.h"
#include "app/number_field.h"
#include "app/picture_tool.h"
#include "app/profile_editor.h"
#include "app/recent_files.h"
#include "app/recording.h"
#include "app/repair_bench.h"
#include "app/story_player.h"
#include "app/tour_guide.h"
#include "app/view_settings.h"
#include "evaluation/evaluator.h"
#include "picture/camera.h"
#include "scene/handles.h"
#include "scene/mesh_parts.h"

namespace sectile::viewer {

enum class Mode { model, steps };

struct SolidNumbers {
  Solid of;
  double volume = 0, area = 0;
  SolidCounts counts;
};

/// A name that is being typed in the tree.
struct Renaming {
  NodeId node = 0;  ///< 0: none
  bool begun = false;
  std::string text;
};

/// The desktop's, or one of the program alone.
struct Clipboard {
  std::function<std::string()> read;
  std::function<void(const std::string&)> write;
};

/// From where the sphere of a step is seen; it turns to what is to be seen at each new step.
struct SphereTurn {
  std::shared_ptr<const Story> story;
  std::size_t step = 0;
  Camera camera;
};

class Session {
 public:
  Session(const std::filesystem::path& data_folder, bool dark);

  // --- The document ---
  const Scene& scene() const { return document.scene(); }
  /// One step of undo. What it throws becomes a message, and nothing is changed.
  bool change(const std::string& what, const std::function<void(Scene&)>& edit);
  void undo();
  void redo();

  void new_scene();
  void start(Scene scene, std::filesystem::path path);  ///< as it was read from a file
  void add_imported(const std::filesystem::path& path, std::vector<MeshPart> parts);
  // Files are read and exported in the background; what went wrong becomes a message.
  void open(const std::filesystem::path& path);    ///< replaces a scene, adds a mesh
  void import(const std::filesystem::path& path);  ///< adds a mesh
  void take_repaired();   ///< the solid of the preview comes into the scene
  void give_up_repair();  ///< nothing of the mesh does
  void open_sample(const std::string& name);
  bool save(const std::filesystem::path& path);
  void offer_recovery(
      const std::filesystem::path& data_folder);  ///< asks, if an earlier session crashed
  void export_solid(const std::filesystem::path& path);
  /// The solids that are shown at the top of the tree: all into one 3MF file, or each into a file
  /// of its own beside `path`, named after both: parts.stl becomes "parts-Block.stl" and so on.
  void export_all(const std::filesystem::path& path);
  /// Asks for the file of `recording_plan`, then begins to record.
  void choose_recording_file();
  void record(const RecordingPlan& plan);
  void write_recorded();  ///< in the background, once all frames are made
  /// Runs `then` at once, or after the question whether changes are to be saved.
  void after_saving(const std::string& about, std::function<void()> then);

  // --- Selection ---
  const Selection& selection() const { return document.selection(); }
  bool is_selected(NodeId id) const;
  bool is_selected_with_group(NodeId id) const;  ///< it, or a group that it belongs to
  void select(NodeId id, bool add = false);      ///< add: or take away, if it was selected
  void select(Selection ids) { document.select(std::move(ids)); }
  NodeId selected() const { return selection().empty() ? 0 : selection().back(); }
  /// The selected nodes that do not lie below another selected node, in the order of selection.
  Selection topmost_selected() const;

  // --- Editing ---
  void add(Primitive::Shape shape);
  void combine(Operation operation);
  void split();
  void duplicate_selected();
  void copy_selected();
  void cut_selected();
  void paste();
  void remove_selected();
  void group_selected();
  void ungroup_selected();
  void hide_selected();
  /// Makes or changes the solid of the profile editor, and closes it.
  void take_profile();
  void rename(NodeId id, const std::string& name);

  // --- Looking ---
  void set_mode(Mode wanted);
  Mode mode() const { return mode_; }
  /// The picture shows the scene, and what is clicked there is meant.
  bool is_modelling() const;
  void look_at_selection();
  /// Shows only what is selected, or everything again.
  void isolate_selected();
  bool is_isolating() const;
  /// Is a node drawn as far as isolating is concerned?
  bool passes_isolation(NodeId id) const;
  void look_at_all();
  /// From here, instead of framing what is being opened.
  void keep_camera(const Camera& wanted) { camera = wanted, frame_next_ = false; }
  Bounds bounds_of(NodeId id) const;
  Bounds bounds_of_all() const;
  /// Of what the picture shows, operands and parts pulled apart included: in the steps of the step;
  /// else of what is selected, or of all.
  Bounds bounds_shown(bool selected_only) const;
  /// Where the section's plane would cut nothing it goes to the middle.
  void show_section(bool on, int axis);
  /// The plane of the section in world coordinates: cut away is what lies on its positive side.
  glm::dvec4 section_plane() const;

  // --- Tools in the picture ---
  void begin_tool(std::unique_ptr<PictureTool> wanted);  ///< the one before is given up
  void end_tool();                                       ///< gives it up
  void drop_done_tool();

  // --- Results ---
  const Evaluation* evaluation() const { return evaluation_.get(); }
  /// Null: not computed, or an error, or a group that no operation uses.
  const Solid* solid(NodeId id) const;
  std::string error_of(NodeId id) const;  ///< why there is none, in plain words; or empty
  /// The Boolean whose steps are shown: the selected one, the one above the selection, or the
  /// first.
  NodeId story_node() const;

  std::string why_no_story() const;
  /// Are the operands of an operation drawn in the colours of A and B?
  bool shows_operands() const;
  /// Of an operation with several operands: which of them B is in the story, from 1; A is the
  /// result of all before it.
  std::size_t told_operand() const;
  void tell_operand(std::size_t which);
  /// Volume, area and counts, computed once for each solid.
  const SolidNumbers& numbers(NodeId id, const Solid& solid);

  /// Looks what was computed in the meantime. `wait`: until all of it is.
  void update(double seconds, bool wait);
  bool is_busy() const;
  std::string activity() const;  ///< what is being computed, in words
  double progress() const;
  void cancel();

  Document document;
  Messages messages;
  Dialogs dialogs;
  StoryPlayer player;
  TourGuide tour;
  ViewSettings view;
  Camera camera;
  glm::dvec2 picture_size{800, 600};
  HandleMode handles = HandleMode::move;
  bool local_axes = false;
  bool snapping = true;
  std::string dragging;  ///< how far a drag of a handle has come and what it touches, in words
  Renaming renaming;
  TypedField typed;
  Clipboard clipboard;
  RecentFiles recent;
  RecordingPlan recording_plan;
  std::optional<Recording> recording;  ///< under way
  ProfileEditor profile;
  RepairBench repair;                 ///< of files that are no solids
  bool context_menu = false;          ///< is to open where the pointer is
  std::unique_ptr<PictureTool> tool;  ///< null: none
  glm::dvec2 pointer{0};              ///< where the mouse is in the picture
  NodeId presented = 0;  ///< of a sample: its operands are shown alone until something is selected
  std::vector<LegendKey> legend;  ///< of the picture in the last frame
  SphereTurn sphere;
  int lit_row = -1;         ///< of the step's table: the one that is pointed at
  bool adding = false;      ///< the list of primitives is to open
  bool view_panel = false;  ///< the view settings are open
  std::string typed_stop;   ///< a break point that is being typed
  std::pair<std::string, std::string> typed_pair;  ///< vertices of A and of B, for another
  bool wants_to_close = false;

 private:
  void evaluate();
  void take_evaluation();
  /// `work` may throw what becomes a message.
  void in_background(FileWork::Kind kind, std::string activity,
                     std::function<FileWork::Finish()> work);
  /// Whose union the solid of a node is: itself, or the members of a group. Empty if there is none.
  std::vector<Solid> members_of(NodeId id) const;
  void tell_new_errors();
  void tell_new_first_operands(const Scene& before);
  void tell_story();
  void look_at(const Bounds& bounds);
  std::size_t wished_operand_ = 0;  ///< 0: the last
  void frame_once_computed();
  std::vector<Solid> operands_of(const Node& node) const;
  void recover(const LostWork& work);
  void take_parts(const std::filesystem::path& path, std::vector<MeshPart> parts,
                  std::vector<BrokenMesh> broken);
  void look_at_repair();

  Evaluator evaluator_;
  FileWork files_;
  std::shared_ptr<const Evaluation> evaluation_;
  std::uint64_t seen_revision_ = 0, newest_request_ = 0;
  Mode mode_ = Mode::model;
  Selection isolated_;  ///< empty: everything is shown
  Camera camera_before_repair_;
  bool frame_next_ = false;  ///< look at everything as soon as it is computed
  std::map<NodeId, std::string> told_errors_;
  std::map<NodeId, SolidNumbers> numbers_;
};

}  // namespace sectile::viewer

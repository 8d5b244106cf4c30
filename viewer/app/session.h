// The state of one session of the modeller and everything that a person can do to it. Knows no
// widgets: panels, keys and tests all call the same functions.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/file_work.h"
#include "app/interface_state.h"
#include "app/results.h"
#include "app/view_state.h"

namespace sectile::viewer {

enum class Mode { model, steps };

/// Four parts, each of which may be handed on alone, and what takes several of them.
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
  /// Behind the other solids, or at a place among them. Gives the new nodes.
  Selection add_imported(const std::filesystem::path& path, const std::vector<MeshPart>& parts,
                         std::size_t at = SIZE_MAX);
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
  NodeId selected() const { return document.selected(); }
  /// The selected nodes that do not lie below another selected node, in the order of selection.
  Selection topmost_selected() const;

  // --- Editing ---
  void add(const PrimitiveKind& kind);
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
  void keep_camera(const Camera& wanted) { view.camera = wanted, frame_next_ = false; }
  Bounds bounds_of(NodeId id) const { return results.bounds_of(scene(), id); }
  Bounds bounds_of_all() const { return results.bounds_of_all(scene()); }
  /// Of what the picture shows, operands and parts pulled apart included: in the steps of the step;
  /// else of what is selected, or of all.
  Bounds bounds_shown(bool selected_only) const;
  /// Where the section's plane would cut nothing it goes to the middle.
  void show_section(bool on, int axis);

  // --- Tools in the picture ---
  void begin_tool(std::unique_ptr<PictureTool> wanted);  ///< the one before is given up
  void end_tool();                                       ///< gives it up
  void drop_done_tool();
  void tell_tool_of_changes();  ///< if the scene is not what it was when it was told last

  // --- Results ---
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

  /// Looks what was computed in the meantime. `wait`: until all of it is.
  void update(double seconds, bool wait);
  bool is_busy() const;
  std::string activity() const;  ///< what is being computed, in words
  double progress() const;
  void cancel();

  Document document;
  Results results;
  ViewState view;
  InterfaceState interface;

 private:
  /// `work` may throw what becomes a message.
  void in_background(FileWork::Kind kind, std::string activity,
                     std::function<FileWork::Finish()> work);
  void tell_new_first_operands(const Scene& before);
  void tell_story();
  void frame_once_computed();
  void recover(const LostWork& work);
  /// What of a file bounds a solid, and what does not.
  struct SortedParts {
    std::vector<MeshPart> sound;
    std::vector<BrokenMesh> broken;
    std::vector<std::size_t> sound_before;  ///< each broken one, in the file
    std::string note;
  };
  static SortedParts sorted_parts(const std::filesystem::path& path);
  void take_parts(const std::filesystem::path& path, const SortedParts& parts);
  void look_at_repair();

  FileWork files_;
  std::size_t wished_operand_ = 0;  ///< 0: the last
  Mode mode_ = Mode::model;
  Selection isolated_;            ///< empty: everything is shown
  std::uint64_t tool_knows_ = 0;  ///< the scene's number
  Camera camera_of_model_;        ///< while the steps are shown
  Camera camera_before_repair_;
  bool frame_next_ = false;  ///< look at everything as soon as it is computed
};

}  // namespace sectile::viewer

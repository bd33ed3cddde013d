#pragma once
/// A history keeps what a user edits, and the way back. It has values of the document before and after each edit, with
/// a name.

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/constraints/selection.h>
#include <holdfast/deform/deform.h>
#include <holdfast/surface/surface_location.h>

namespace holdfast {

class SurfaceLocator;

/// The user has kept these vertices under a name, to select them again.
struct SavedSelection {
  std::string name;  ///< unique in its document, not empty
  Selection select;
};

/// Holds what the user has measured, in the order in which it was made.
struct Measurements {
  std::vector<SurfaceLocation> probes;
  std::vector<std::array<SurfaceLocation, 2>> rulers;
};

/// Returns those of `measurements` whose places the mesh of `locator` has.
[[nodiscard]] Measurements onMesh(const Measurements& measurements, const SurfaceLocator& locator);

/// A document keeps annotations beside its constraints. No solution depends on them.
struct Annotations {
  std::vector<SavedSelection> selections;
  Measurements measurements;
};

/// The state holds all that edits change and undo brings back. The mesh is not part of it: another mesh is another
/// document.
struct DocumentState {
  ConstraintList list;
  DeformOptions options;
  /// This is never null. States between which it does not change share it.
  std::shared_ptr<const Annotations> annotations = std::make_shared<const Annotations>();
};

/// Says whether an edit makes a document that is saved an unsaved one.
enum class EditKind {
  OfDocument,
  Aside  ///< a look at the document: its file keeps it once it is saved, and no user wants to be asked about it
};

/// A history keeps the states of one document, oldest first. Undo brings back the very object that was there before. A
/// gesture (a drag) is one edit, however many states it goes through.
class History {
 public:
  explicit History(DocumentState state);

  /// Returns the state that is shown, that of a gesture under way included. It is never null.
  [[nodiscard]] std::shared_ptr<const DocumentState> state() const
  {
    return gesture_ ? gesture_->after : states_[position_].state;
  }

  /// Makes one edit, named for menus ("move P1"). What could be redone is gone. A gesture under way ends before it.
  void edit(std::string name, DocumentState after, EditKind kind = EditKind::OfDocument);

  /// Begins a gesture. One that is under way ends before it.
  void beginGesture(std::string name);
  /// Shows `after` as the state of the gesture, which is under way.
  void updateGesture(DocumentState after);
  /// Makes one edit of the gesture. It makes none where the gesture was never updated, or where there is no gesture.
  void endGesture();
  /// Ends the gesture as if it had not begun: the state is the object that it was.
  void cancelGesture() { gesture_.reset(); }
  [[nodiscard]] bool isInGesture() const noexcept { return gesture_ != nullptr; }

  /// Undo and redo end a gesture before they do their work. They return false where there is nothing to do.
  bool undo();
  bool redo();
  [[nodiscard]] bool canUndo() const noexcept { return position_ > 0; }
  [[nodiscard]] bool canRedo() const noexcept { return position_ + 1 < states_.size(); }
  /// These return the names of the edits that undo and redo would affect. A name is empty where there is none.
  [[nodiscard]] std::string_view undoName() const { return canUndo() ? states_[position_].name : std::string_view(); }
  [[nodiscard]] std::string_view redoName() const
  {
    return canRedo() ? states_[position_ + 1].name : std::string_view();
  }

  /// Notes that the user's file holds `state`.
  void markSaved(std::shared_ptr<const DocumentState> state) noexcept { saved_ = std::move(state); }
  /// Notes that the user's file holds no state, or that there is no file.
  void markUnsaved() noexcept { saved_.reset(); }
  /// Tells whether the user's file holds what is shown, apart from edits aside since.
  [[nodiscard]] bool isSaved() const;

 private:
  struct Entry {
    std::string name;  // of the edit that led here
    std::shared_ptr<const DocumentState> state;
    EditKind kind = EditKind::OfDocument;  // of that edit
  };
  struct Gesture {
    std::string name;
    std::shared_ptr<const DocumentState> after;
  };

  void push(std::string name, std::shared_ptr<const DocumentState> state, EditKind kind);

  std::vector<Entry> states_;
  std::size_t position_ = 0;
  std::unique_ptr<Gesture> gesture_;
  std::shared_ptr<const DocumentState> saved_;
};

/// At most this many edits can be undone. The oldest are forgotten beyond that.
inline constexpr std::size_t kLongestHistory = 1000;

}  // namespace holdfast

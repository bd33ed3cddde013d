#pragma once
/// Deforms on a thread of its own, so that a window never waits: the newest state wins, and none is shown half-done.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <holdfast/deform/deform.h>
#include <holdfast/document/history.h>

namespace holdfast {

/// The worker reports events. Each revision ends once, not by one of the first four, unless a newer one replaced it.
/// `Examined` may follow `Done` twice: with what is found while the picture is drawn, and with what a rest has time
/// for.
struct LiveEvent {
  enum class Kind {
    Started,    ///< work on a revision begins
    Step,       ///< `message` says what is being done now
    Examined,   ///< `report` says more of the result of the revision, which was done before
    Iterate,    ///< `deformation` meets the constraints, and its rotations are still being found: a drag that rests
    Done,       ///< `deformation` is what the state asks for, or the rest shape with the reason in its report
    Unusable,   ///< the constraints do not fit the mesh; `message` says why and where
    Cancelled,  ///< by `cancel`, whether or not the work had started
    Broken      ///< an error that is a mistake of ours or of the machine (memory), in `message`
  };
  Kind kind = Kind::Started;
  std::uint64_t revision = 0;
  std::string message;
  std::shared_ptr<const DeformResult> deformation;
  std::shared_ptr<const DocumentState> state = nullptr;  ///< with `Iterate` and `Done`: what `deformation` is of
  std::shared_ptr<const Report> report = nullptr;        ///< with `Examined`
};

/// What a newer state does to the work that is under way.
enum class Supersede {
  AtNextStep,  ///< it is given up as soon as it can be, as by `cancel`: an edit
  /// It is finished and shown first: a drag, whose frames would starve otherwise. Where rotations are found, a frame
  /// goes on from those of the one before, by a few iterations, and by more as long as nothing newer waits.
  WhenDone
};

/// Deforms one model on a thread of its own. It looks at each result after it was told (`Deformer::checked`), but for
/// frames that others wait for already, where that would take more than 3 % of the time of all; and where nothing newer
/// comes for a while with the care that a drag has no time for (`Deformer::examined`). Calls may come from one thread,
/// the owner's.
class LiveDeformer {
 public:
  /// Called on the worker's thread, never after the destructor has returned, which waits for it. Does not throw.
  using Listener = std::function<void(const LiveEvent&)>;

  LiveDeformer(std::shared_ptr<const Model> model, Listener listener);
  /// Returns at once, or after the call of the listener that is under way. Work under way is given up as by `cancel`.
  ~LiveDeformer();
  LiveDeformer(const LiveDeformer&) = delete;
  LiveDeformer& operator=(const LiveDeformer&) = delete;

  /// Asks for `state`, in the place of what is waiting. Revisions ascend. `source` names the list in messages.
  void submit(std::uint64_t revision, std::shared_ptr<const DocumentState> state, std::string source,
              Supersede supersede);

  /// Gives up what is waiting and, at its next step or its end, what is under way. A `LongStep` goes on.
  void cancel();

  /// What was reported last is seen. The next frame of a drag begins then, or after a tenth of a second: solved beside
  /// the drawing of the last one, it would delay that and be seen later itself.
  void resultIsSeen();

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

}  // namespace holdfast

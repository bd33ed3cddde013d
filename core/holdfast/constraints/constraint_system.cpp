#include "holdfast/constraints/constraint_system.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include <holdfast/constraints/axis_systems.h>
#include <holdfast/constraints/chosen_rows.h>
#include <holdfast/constraints/fitted_guides.h>
#include <holdfast/constraints/handle_motion.h>
#include <holdfast/constraints/mirror_rows.h>
#include <holdfast/constraints/selector.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/numbers/disjoint_sets.h>
#include <holdfast/surface/guide_surface.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

const std::string kUnsaidNote = "unsaid_rotation";

// A person looks at no more.
constexpr std::size_t kMostUnpairedNames = 5;

bool statesRotation(const HandleConstraint& handle)
{
  return !handle.rotations.empty() || !std::holds_alternative<std::monostate>(handle.motion);
}

/// Makes the rows of one list; remembers what several constraints share.
class SystemBuilder {
 public:
  SystemBuilder(const ConstraintList& list, const Mesh& mesh, const SolverMesh& solverMesh,
                const SurfaceLocator& locator, const std::string& source, KnownPlaces& places)
      : list_(list),
        mesh_(mesh),
        solverMesh_(solverMesh),
        source_(source),
        locator_(locator),
        places_(places),
        selector_(mesh, solverMesh, locator_),
        joinedRest_(solverMesh.weld.joinsApart ? restOfVertices(solverMesh) : Positions()),
        rest_(solverMesh.weld.joinsApart ? joinedRest_ : mesh.positions),
        selected_(list.constraints.size()),
        pinOf_(static_cast<std::size_t>(solverMesh.unknownCount()), -1),
        hasRotation_(static_cast<std::size_t>(solverMesh.unknownCount()), false)
  {
  }

  ConstraintSystem build()
  {
    forEach([this](const auto& what) { selectFor(what); });
    std::size_t rows = list_.constraints.size();
    for (const std::span<const Index> selected : selected_) rows += selected.size();
    system_.rows.reserve(rows);
    surroundings_ = surroundings();
    forEach([this](const auto& what) { add(what); });
    handOnRotations(system_, mirrors_, hasRotation_);
    rotateRegionsAsTheirFirst();
    chooseRowsAtOdds(system_, list_, source_);
    requireFewTolerant(system_, list_, source_);
    return std::move(system_);
  }

 private:
  template <class Function>
  void forEach(Function function)
  {
    for (current_ = 0; current_ < static_cast<Index>(list_.constraints.size()); ++current_) {
      const Constraint& constraint = list_.constraints[current_];
      try {
        std::visit(function, constraint.what);
      } catch (const InputError& error) {
        throw InputError(error.location(), fmt::format("{}: {}", inQuotes(constraint.name), error.reason()));
      }
    }
  }

  [[nodiscard]] InputLocation key(const std::string& name) const
  {
    return {source_, 0, fmt::format("constraints[{}]{}", current_, name)};
  }

  /// Names its place in the list where that is at fault alone.
  [[nodiscard]] SurfacePoint located(const SurfaceLocation& location, const char* name) const
  {
    try {
      SurfacePoint point = locator_.locate(location, {});
      for (const Term& term : point.terms) requirePlace(solverMesh_.withoutPlace, term.index, {}, ".vertex");
      return point;
    } catch (const InputError& error) {
      throw InputError(key(name + error.location().element), error.reason());
    }
  }

  [[nodiscard]] bool isEnabled() const { return list_.constraints[current_].isEnabled; }

  template <class What>
  void selectFor(const What& what)
  {
    if constexpr (requires { what.select; })
      selected_[current_] =
          places_.vertices(current_, what.select, [&] { return selector_.select(what.select, key(".select")); });
  }

  [[nodiscard]] HandleSurroundings surroundings() const
  {
    std::vector<Index> fixed;
    for (std::size_t c = 0; c < selected_.size(); ++c)
      if (!selected_[c].empty() && list_.constraints[c].isEnabled &&
          std::holds_alternative<FixedConstraint>(list_.constraints[c].what))
        fixed.insert(fixed.end(), selected_[c].begin(), selected_[c].end());
    if (fixed.empty()) return {std::nullopt, solverMesh_.diagonal};
    for (Index& v : fixed) v = solverMesh_.weld.unknownOf[v];
    const Positions places = solverMesh_.rest(sortedOnce(std::move(fixed)), Eigen::all);
    return {centroid(places), solverMesh_.diagonal};
  }

  void add(const FixedConstraint& /*fixed*/)
  {
    if (!isEnabled()) return;
    for (const Index v : selected_[current_]) {
      addPin(v, rest_.row(v));
      giveRotation(v, {});
    }
  }

  void add(const HandleConstraint& handle)
  {
    if (const std::optional<HandleError> error = validateHandle(handle))
      throw InputError(key(error->key), error->reason);
    if (!isEnabled()) return;
    // Vertices with entries of their own are taken in the order in which they are listed.
    const bool isListed = !handle.rotations.empty() || std::holds_alternative<VertexTargets>(handle.motion);
    const std::span<const Index> vertices =
        isListed ? std::span(std::get<VertexIds>(handle.select.what).ids) : selected_[current_];
    const HandleSetting setting{
        restOf(vertices), surroundings_, key(""), {}, firstOfUnknowns(vertices, solverMesh_.weld.unknownOf)};
    const HandlePlacement placement = placeHandle(handle, setting);
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      addPin(vertices[k], placement.places.row(k));
      giveRotation(vertices[k], {.q = placement.q.row(k), .isStated = statesRotation(handle)});
    }
    noteRotation(handle, placement, shareMoved(handle, setting));
  }

  void requireDirection(const RowDirections& directions) const
  {
    if (!directions.areAll() && !(directions.axis().squaredNorm() > 0.5))
      throw InputError(key(""), "its direction is zero or not finite; give one of any other length");
  }

  void add(const PointConstraint& point)
  {
    requireDirection(point.directions());
    requireTolerance(point.within, point.directions());
    const KnownPlaces::KnownPoint& known = places_.point(current_, point.at, [&] {
      const SurfacePoint found = located(point.at, ".at");
      return KnownPlaces::KnownPoint{point.at, overUnknowns(found).terms, positionOf(found, rest_),
                                     static_cast<int>(found.terms.size()), nearness(point.at, found)};
    });
    if (!isEnabled()) return;
    addNearPlace(point.at, known.nearness);
    std::visit([&](const auto& to) { addPosition(known.terms, known.rest, known.corners, to, point.within); },
               point.to);
  }

  void requireTolerance(const PointTolerance& tolerance, const RowDirections& directions) const
  {
    if (const std::optional<ToleranceError> error = validateTolerance(tolerance, directions))
      throw InputError(key(error->key), error->reason);
  }

  /// A point goes where `to` says, from `rest`. Where that or the tolerance leaves a choice its place is chosen.
  template <class To>
  void addPosition(FewTerms terms, const Vector3& rest, int corners, const To& to, const PointTolerance& within)
  {
    ConstraintRow row{std::move(terms), to.placeFrom(rest), to.shiftFrom(rest), current_, RowKind::Position,
                      corners,          to.directions()};
    std::shared_ptr<const GuideSurface> surface;
    if constexpr (std::is_same_v<To, OnMesh>) {
      surface = requireSurface(to);
      row.directions = RowDirections::along(surface->footOf(rest).normal);
    }
    row.isChosen = surface != nullptr || !std::holds_alternative<Exactly>(within);
    if (row.isChosen)
      system_.tolerant.push_back(
          {static_cast<Index>(system_.rows.size()), within, row.target, row.shift, std::move(surface)});
    system_.rows.push_back(std::move(row));
  }

  [[nodiscard]] std::shared_ptr<const GuideSurface> requireSurface(const OnMesh& on) const
  {
    if (on.surface == nullptr)
      throw InputError(
          key(".on.mesh"),
          fmt::format("{} was not read; put the file there and open this one again, or disable it", inQuotes(on.path)));
    return on.surface;
  }

  void add(const RigidConstraint& /*rigid*/)
  {
    if (!isEnabled()) return;
    std::vector<Index> group = unknownsOfSelection();
    const SurfacePoint reference{{{group.front(), 1.0}}};
    for (const Index u : group)
      if (u != group.front()) addRotatedVector(RowKind::Region, {{{u, 1.0}}}, reference, reference.terms);
    if (group.size() == 1)
      note("rigid_region_of_one_vertex", "a region of one vertex is rigid in any case; select more, or remove it");
    system_.rigidRegions.push_back(std::move(group));
  }

  void add(const RelativeConstraint& relative)
  {
    const SurfacePoint fromVertices = located(relative.from, ".from");
    const SurfacePoint toVertices = located(relative.to, ".to");
    if (!isEnabled()) return;
    addNearPlace(relative.from, nearness(relative.from, fromVertices));
    addNearPlace(relative.to, nearness(relative.to, toVertices));
    const SurfacePoint from = overUnknowns(fromVertices);
    const SurfacePoint to = overUnknowns(toVertices);
    if (!relative.offset) return addRotatedVector(RowKind::Relative, from, to, midpoint(from, to).terms);
    const Vector3 rest = restVector(from, to);
    system_.rows.push_back(
        {difference(from, to), *relative.offset, *relative.offset - rest, current_, RowKind::Relative});
  }

  void add(const SlideConstraint& slide)
  {
    if (!isEnabled()) return;
    const std::vector<Index> unknowns = unknownsOfSelection();
    const Guide guide = guideOf(slide, unknowns);
    const RowDirections directions = std::visit([](const auto& on) { return on.directions(); }, guide);
    requireDirection(directions);
    requireTolerance(slide.within, directions);
    if (std::holds_alternative<OnPlane>(guide) && std::holds_alternative<Exactly>(slide.within))
      for (const Index u : flatAlong(solverMesh_, unknowns, directions.axis()))
        system_.flat.push_back({u, directions.axis()});
    if (!slide.together) {
      for (const Index u : unknowns)
        std::visit(
            [&](const auto& on) {
              addPosition({{u, 1.0}}, solverMesh_.rest.row(u), 0, on, slide.within);
            },
            guide);
      return;
    }
    requireShiftable(slide);
    const auto placeOnGuide = [&](Index u) {
      return std::visit([&](const auto& on) { return on.placeFrom(solverMesh_.rest.row(u)); }, guide);
    };
    const auto shiftToGuide = [&](Index u) {
      return std::visit([&](const auto& on) { return on.shiftFrom(solverMesh_.rest.row(u)); }, guide);
    };
    const Index first = unknowns.front();
    for (const Index u : unknowns)
      if (u != first)
        system_.rows.push_back({difference(SurfacePoint{{{u, 1.0}}}, SurfacePoint{{{first, 1.0}}}),
                                placeOnGuide(u) - placeOnGuide(first), shiftToGuide(u) - shiftToGuide(first), current_,
                                RowKind::Region, 0, directions});
    if (unknowns.size() == 1)
      note("plane_of_one_vertex", "a plane or a line of one vertex that may shift holds nothing; select more vertices");
  }

  void requireShiftable(const SlideConstraint& slide) const
  {
    if (std::holds_alternative<OnMesh>(slide.on))
      throw InputError(key(".together"), "only a plane or a line may shift; leave this out");
    if (!std::holds_alternative<Exactly>(slide.within))
      throw InputError(key(".together"), "vertices that shift together have no tolerance; leave one of both out");
  }

  void add(const CoincidentConstraint& coincident)
  {
    add(RelativeConstraint{coincident.from, coincident.to, Vector3(Vector3::Zero())});
  }

  void add(const MirrorConstraint& mirror)
  {
    const RowDirections along = RowDirections::along(mirror.normal);
    requireDirection(along);
    if (mirror.tolerance && !(*mirror.tolerance >= 0))
      throw InputError(key(".tolerance"), fmt::format("it must not be below 0, this is {}", *mirror.tolerance));
    std::optional<MirrorPairs> listed;
    if (!mirror.pairs.empty()) listed = listedPairs(mirror);
    if (!isEnabled()) return;
    MirrorPairs found = listed ? *std::move(listed) : foundPairs(mirror);
    addMirrorRows(system_, mirror, found, current_, solverMesh_.rest);
    mirrors_.push_back({current_, along.axis(), std::move(found)});
  }

  /// The listed pairs, over unknowns.
  [[nodiscard]] MirrorPairs listedPairs(const MirrorConstraint& mirror) const
  {
    if (mirror.select != Selection{AllOf{}})
      throw InputError(key(".pairs"), R"("select" says that they are to be found; leave one of both out)");
    MirrorPairs result;
    std::map<Index, std::size_t> placeOf;
    for (std::size_t k = 0; k < mirror.pairs.size(); ++k) {
      const InputLocation where = key(fmt::format(".pairs[{}]", k));
      std::array<Index, 2> pair = mirror.pairs[k];
      for (Index& v : pair) {
        requireVertex(mesh_.vertexCount(), v, where, "");
        requirePlace(solverMesh_.withoutPlace, v, where, "");
        v = solverMesh_.weld.unknownOf[v];
      }
      std::ranges::sort(pair);
      const auto [a, b] = pair;
      for (const Index u : {a, b})
        if (const auto [other, isNew] = placeOf.emplace(u, k); !isNew && other->second != k)
          throw InputError(where,
                           fmt::format("pairs[{}] has a vertex of it already; give each one partner", other->second));
      if (a == b)
        result.onPlane.push_back(a);
      else
        result.pairs.push_back(pair);
    }
    return result;
  }

  [[nodiscard]] MirrorPairs foundPairs(const MirrorConstraint& mirror)
  {
    const double tolerance = mirror.tolerance.value_or(kMirrorTolerance * solverMesh_.diagonal);
    std::vector<Index> wanted = unknownsOfSelection();
    // Vertices that no face uses are no part of the surface, and need no partners.
    std::erase_if(wanted, [&](Index u) { return solverMesh_.componentOf[u] < 0; });
    MirrorPairs found = places_.partners(current_, mirror, [&] {
      return mirrorPairs(solverMesh_.rest, wanted, mirror.point, mirror.normal, tolerance);
    });
    if (found.pairs.empty() && found.onPlane.empty())
      throw InputError(key(""), fmt::format("no vertex has a partner across the plane within {:.3g}; move or turn the "
                                            "plane, raise \"tolerance\", or list \"pairs\"",
                                            tolerance));
    noteUnpaired(found.unpaired, wanted.size(), tolerance);
    return found;
  }

  void noteUnpaired(const std::vector<Index>& unpaired, std::size_t wanted, double tolerance)
  {
    if (unpaired.empty()) return;
    std::string names;
    for (std::size_t k = 0; k < std::min(unpaired.size(), kMostUnpairedNames); ++k)
      names += (k == 0 ? "" : ", ") + std::to_string(solverMesh_.weld.firstVertexOf[unpaired[k]]);
    note("unpaired_vertices",
         fmt::format("{} of {} vertices have no partner across its plane within {:.3g} and are free of it: {}{}; "
                     "raise \"tolerance\", or select fewer",
                     unpaired.size(), wanted, tolerance, names, unpaired.size() > kMostUnpairedNames ? ", ..." : ""));
  }

  using Guide = std::variant<OnPlane, OnLine, OnMesh>;

  /// Throws `InputError` where the selection fits no plane or line of its own.
  [[nodiscard]] Guide guideOf(const SlideConstraint& slide, const std::vector<Index>& unknowns) const
  {
    if (const auto* plane = std::get_if<OnPlane>(&slide.on)) return *plane;
    if (const auto* line = std::get_if<OnLine>(&slide.on)) return *line;
    if (const auto* mesh = std::get_if<OnMesh>(&slide.on)) return *mesh;
    const Positions places = solverMesh_.rest(unknowns, Eigen::all);
    if (std::holds_alternative<FittedLine>(slide.on)) {
      if (const std::optional<OnLine> line = fittedLine(places)) return *line;
      throw InputError(key(".on.line"), "its vertices lie along no one line; give a direction in place of \"fit\"");
    }
    if (const std::optional<OnPlane> plane = fittedPlane(places)) return *plane;
    throw InputError(key(".on.plane"),
                     "its vertices lie near no one plane, but on a line, in one place or all around; give a normal in "
                     "place of \"fit\"");
  }

  /// Ascending, each once.
  [[nodiscard]] std::vector<Index> unknownsOfSelection() const
  {
    std::vector<Index> unknowns(selected_[current_].begin(), selected_[current_].end());
    for (Index& v : unknowns) v = solverMesh_.weld.unknownOf[v];
    return sortedOnce(std::move(unknowns));
  }

  [[nodiscard]] Positions restOf(std::span<const Index> vertices) const { return rest_(vertices, Eigen::all); }

  /// Of the place of a location that names one; `found` is the point there.
  [[nodiscard]] std::optional<Nearness> nearness(const SurfaceLocation& location, const SurfacePoint& found) const
  {
    const AtNear* const near = std::get_if<AtNear>(&location);
    if (near == nullptr) return std::nullopt;
    return nearnessOf(near->place, positionOf(found, mesh_.positions), locator_, solverMesh_.diagonal);
  }

  void addNearPlace(const SurfaceLocation& location, const std::optional<Nearness>& nearness)
  {
    if (nearness) system_.nearPlaces.push_back({current_, std::get<AtNear>(location).place, *nearness});
  }

  // A target of a vertex is taken as it is: it is what the written file must hold.
  void addPin(Index vertex, const Vector3& target)
  {
    const Index unknown = solverMesh_.weld.unknownOf[vertex];
    if (isRepeatOfOwnPin(unknown, target)) return;
    pinOf_[unknown] = static_cast<Index>(system_.rows.size());
    const Vector3 rest = rest_.row(vertex);
    system_.rows.push_back({{{unknown, 1.0}}, target, target - rest, current_});
  }

  /// The row from - to whose d is what it is at rest, turned by the rotation of `rotation`.
  void addRotatedVector(RowKind kind, const SurfacePoint& from, const SurfacePoint& to, std::vector<Term> rotation)
  {
    const Vector3 rest = restVector(from, to);
    system_.rotated.push_back({static_cast<Index>(system_.rows.size()), rest, std::move(rotation)});
    system_.rows.push_back({difference(from, to), rest, Vector3::Zero(), current_, kind});
  }

  void giveRotation(Index vertex, const GivenRotation& given)
  {
    giveRotationTo(solverMesh_.weld.unknownOf[vertex], given);
  }

  void giveRotationTo(Index unknown, GivenRotation given)
  {
    given.unknown = unknown;
    given.constraint = current_;
    if (!hasRotation_[unknown]) system_.rotations.push_back(given);
    hasRotation_[unknown] = true;
  }

  /// The rows of a rigid region rotate by the first rotation that is given in it or in one that overlaps it.
  void rotateRegionsAsTheirFirst()
  {
    DisjointSets rigidRegions(solverMesh_.unknownCount());
    rigidRegions.uniteEach(system_.rigidRegions);
    // By representative.
    std::vector<Index> leader(static_cast<std::size_t>(solverMesh_.unknownCount()), -1);
    for (auto given = system_.rotations.rbegin(); given != system_.rotations.rend(); ++given)
      leader[rigidRegions.find(given->unknown)] = given->unknown;
    for (RotatedVector& rotated : system_.rotated) {
      if (system_.rows[rotated.row].kind != RowKind::Region) continue;
      Index& unknown = rotated.rotation.front().index;
      if (const Index given = leader[rigidRegions.find(unknown)]; given >= 0) unknown = given;
    }
  }

  void noteRotation(const HandleConstraint& handle, const HandlePlacement& placement, double share)
  {
    if (!placement.isDetermined)
      note("undetermined_rotation",
           "its targets fit more than one rotation: they or its vertices lie on a line, or the targets mirror it; one "
           "that fits is taken; give \"rotations\" if it should be another");
    if (!statesRotation(handle) && share > kUnsaidRotation)
      note(kUnsaidNote, fmt::format("moved {:.0f} % of its distance to the fixed region without turning; give it "
                                    "a rotation (\"rotate\", or \"turn\": \"about-fixed\") if it should turn",
                                    100 * share));
  }

  void note(std::string kind, std::string message)
  {
    system_.notes.push_back({current_, std::move(kind), std::move(message)});
  }

  [[nodiscard]] SurfacePoint overUnknowns(const SurfacePoint& point) const
  {
    std::vector<Term> terms = point.terms;
    for (Term& term : terms) term.index = solverMesh_.weld.unknownOf[term.index];
    return canonical(std::move(terms));
  }

  [[nodiscard]] Vector3 restVector(const SurfacePoint& from, const SurfacePoint& to) const
  {
    return positionOf(from, solverMesh_.rest) - positionOf(to, solverMesh_.rest);
  }

  /// Vertices of one selection that are one unknown ask for the same thing once.
  [[nodiscard]] bool isRepeatOfOwnPin(Index unknown, const Vector3& target) const
  {
    const Index before = pinOf_[unknown];
    return before >= 0 && system_.rows[before].constraint == current_ && system_.rows[before].target == target;
  }

  const ConstraintList& list_;
  const Mesh& mesh_;
  const SolverMesh& solverMesh_;
  const std::string& source_;
  const SurfaceLocator& locator_;
  KnownPlaces& places_;
  Selector selector_;
  Positions joinedRest_;   // of vertices at their unknowns, where those join vertices at different places
  const Positions& rest_;  // of vertices
  std::vector<std::span<const Index>> selected_;  // vertices of each constraint
  HandleSurroundings surroundings_;
  std::vector<Index> pinOf_;       // of each unknown: the row that pinned it last in a selection
  std::vector<bool> hasRotation_;  // of each unknown: its rotation is given
  std::vector<MirrorPlane> mirrors_;
  Index current_ = 0;
  ConstraintSystem system_;
};

}  // namespace

ConstraintSystem makeConstraintSystem(const ConstraintList& list, const Mesh& mesh, const SolverMesh& solverMesh,
                                      const SurfaceLocator& locator, const std::string& source, KnownPlaces& places)
{
  return SystemBuilder(list, mesh, solverMesh, locator, source, places).build();
}

ConstraintSystem makeConstraintSystem(const ConstraintList& list, const Mesh& mesh, const SolverMesh& solverMesh,
                                      const SurfaceLocator& locator, const std::string& source)
{
  KnownPlaces places;
  return makeConstraintSystem(list, mesh, solverMesh, locator, source, places);
}

ConstraintSystem withStatedRotations(ConstraintSystem system)
{
  std::erase_if(system.rotations, [](const GivenRotation& given) { return !given.isStated; });
  std::erase_if(system.notes, [](const ConstraintNote& note) { return note.kind == kUnsaidNote; });
  return system;
}

ConstraintSystem rotated(ConstraintSystem system, const Columns3& q)
{
  for (const RotatedVector& rotated : system.rotated) {
    Vector3 mean = Vector3::Zero();
    for (const Term& term : rotated.rotation) mean += term.coefficient * q.row(term.index).transpose();
    ConstraintRow& row = system.rows[rotated.row];
    row.target = rotationMatrix(mean) * rotated.rest;
    row.shift = row.target - rotated.rest;
  }
  return system;
}

}  // namespace holdfast

#include "holdfast/deform/factor_store.h"

#include <utility>

#include <fmt/format.h>

#include <holdfast/ordering/elimination_order.h>
#include <holdfast/threads/thread_priority.h>

namespace holdfast {
namespace {

// Where rows that nearly depend on others keep a solution from meeting all of them, those closer than this many times
// the distance before are left out, and so on.
constexpr double kDistanceStep = 100;

}  // namespace

FactorStore::FactorStore(std::shared_ptr<const Model> model, const DeformOptions& options, DeformerMode mode)
    : model_(std::move(model)), options_(options), mode_(mode)
{
}

void FactorStore::orderUnknowns(Progress& progress)
{
  const Index count = model_->solverMesh.unknownCount();
  if (ranks_ == nullptr)
    ranks_ = std::make_unique<LongStep<std::vector<int>>>([isOurs = options_.solver.backend == Backend::Holdfast, count,
                                                           triangles = model_->solverMesh.triangles]() mutable {
      const std::vector<Triangle> own = std::move(triangles);  // not to be kept beside the order
      return isOurs ? eliminationRanks(count, own) : std::vector<int>();
    });
  if (!ranks_->isDone()) progress.step(fmt::format("ordering {} unknowns", count));
  ranks_->start(progress);
}

const ModelOperators& FactorStore::operators(Progress& progress)
{
  if (operators_.A != nullptr) return operators_;
  progress.step(fmt::format("building operators of {} vertices", model_->mesh.vertexCount()));
  ModelOperators made;
  made.operators = std::make_shared<const Operators>(makeOperators(model_->solverMesh, options_.weights));
  if (options_.rotations.source == RotationSource::Given) {
    made.A = std::make_shared<const EnergyMatrix>(weightedRows(*made.operators));
  } else {
    made.energy =
        std::make_shared<const RotationEnergy>(model_->solverMesh, *made.operators, options_.rotations.source);
    made.A = made.energy->A();
  }
  operators_ = std::move(made);
  return operators_;
}

ConstraintFactorization& FactorStore::serving(const ConstraintSystem& system, Progress& progress)
{
  if (coming_ != nullptr && coming_->serves(system) && coming_->isReady()) atHand_ = std::exchange(coming_, {});
  if (atHand_ != nullptr && atHand_->serves(system)) {
    if (atHand_->isBordered && coming_ == nullptr)  // it was given up for a cancelled edit
      coming_ = made(system, kRankTolerance, progress);
    return atHand();
  }
  if (whole_ != nullptr && whole_->serves(system)) {  // back to where edits began
    coming_ = nullptr;
    atHand_ = whole_;
    return atHand();
  }
  if (mode_ == DeformerMode::Interactive && atHand_ != nullptr && !atHand_->isBordered && atHand_->isReady())
    whole_ = atHand_;
  progress.step(fmt::format("eliminating {} rows of constraints", system.rows.size()));
  coming_ = nullptr;  // of other rows: it would take cores from what is wanted now
  std::shared_ptr<ConstraintFactorization> wanted = made(system, kRankTolerance, progress);
  if (!border(wanted, progress)) {
    whole_ = nullptr;
    atHand_ = std::move(wanted);
  }
  return atHand();
}

bool FactorStore::border(std::shared_ptr<ConstraintFactorization> wanted, Progress& progress)
{
  if (whole_ == nullptr || !whole_->turnsAs(wanted->system)) return false;
  auto bordered = std::make_shared<ConstraintFactorization>(*wanted, whole_);
  if (!bordered->positions.result(progress)) return false;
  coming_ = std::move(wanted);
  atHand_ = std::move(bordered);
  return true;
}

ConstraintFactorization& FactorStore::unbordered()
{
  atHand_ = std::exchange(coming_, {});
  return atHand();
}

ConstraintFactorization* FactorStore::withFewerRows(const ConstraintSystem& system, double neededDistance,
                                                    Progress& progress)
{
  if (neededDistance == 0 || !atHand_->mayHaveFewerRows) return nullptr;
  progress.step("leaving out constraints that nearly follow from others");
  double tolerance = atHand_->tolerance;
  while (tolerance < kLargestNeededDistance) {
    tolerance = std::min(kLargestNeededDistance, std::max(kDistanceStep * tolerance, neededDistance));
    std::shared_ptr<ConstraintFactorization> fewer = made(system, tolerance, progress);
    if (fewer->standsOn(*atHand_)) continue;
    coming_ = nullptr;
    whole_ = nullptr;
    atHand_ = std::move(fewer);
    return &atHand();
  }
  return nullptr;
}

void FactorStore::makeNext(Progress& progress)
{
  if (coming_ != nullptr) coming_->positions.start(progress, computeInBackground);
}

std::shared_ptr<ConstraintFactorization> FactorStore::made(const ConstraintSystem& system, double tolerance,
                                                           Progress& progress)
{
  auto result = std::make_shared<ConstraintFactorization>(model_, operators(progress), ranks_->result(progress), system,
                                                          options_, tolerance);
  if (atHand_ != nullptr && atHand_->rotations != nullptr && atHand_->turnsAs(system))
    result->rotations = atHand_->rotations;
  return result;
}

ConstraintFactorization& FactorStore::atHand()
{
  atHand_->isForOneCall = mode_ == DeformerMode::OneCall;
  std::vector<MovedSolutions>& moved = atHand_->moved;
  if (mode_ == DeformerMode::Interactive && moved.empty() && atHand_->isBordered)
    for (const MovedSolutions& base : whole_->moved) moved.emplace_back(model_->solverMesh, base);
  if (mode_ == DeformerMode::Interactive && moved.empty())
    moved.assign(atHand_->eliminated->parts().size(), MovedSolutions(model_->solverMesh));
  return *atHand_;
}

}  // namespace holdfast

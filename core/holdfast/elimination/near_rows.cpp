#include "holdfast/elimination/near_rows.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <holdfast/elimination/sequential_qr.h>
#include <holdfast/elimination/sparse_qr.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

constexpr int kDistanceProbes = 16;

// Distances by probes are off by less than this factor. So many of those that may be on the other side of the tolerance
// are measured: which rows go is then the same whatever the order of the QR.
constexpr double kProbeFactor = 2;
constexpr std::size_t kMostMeasured = 64;

// A pivot below rounding, the square of which is still a double.
constexpr double kLeastPivot = 1e-20;

// Rows this much farther from the others than the tolerance are looked at with those within it: a row takes part in
// what makes others close by its share of it.
constexpr double kClusterFactor = 10;

/// R with a pivot in each column, the dependent columns of exact zeros included.
SparseMatrix withPivots(const SparseQrResult& qr)
{
  std::vector<Eigen::Triplet<double, int>> entries;
  const Index count = qr.R.cols();
  for (Index k = 0; k < count; ++k) {
    double pivot = 0;
    for (SparseMatrix::InnerIterator entry(qr.R, k); entry; ++entry)
      if (entry.row() == k)
        pivot = entry.value();
      else if (entry.row() < k)
        entries.emplace_back(static_cast<int>(entry.row()), static_cast<int>(k), entry.value());
    entries.emplace_back(static_cast<int>(k), static_cast<int>(k),
                         std::copysign(std::max(std::abs(pivot), kLeastPivot), pivot));
  }
  SparseMatrix result(count, count);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// Columns k of R with an estimate so near to the tolerance that it may be on its other side. Of many, the nearest.
std::vector<Index> doubtfulOnes(const Eigen::VectorXd& estimates, double tolerance)
{
  const auto factor = [&](Index k) { return std::max(estimates[k] / tolerance, tolerance / estimates[k]); };
  std::vector<Index> result;
  for (Index k = 0; k < estimates.size(); ++k)
    if (factor(k) < kProbeFactor) result.push_back(k);
  std::ranges::sort(result, {}, factor);
  result.resize(std::min(result.size(), kMostMeasured));
  return result;
}

/// Returns how far each column of `block` (of length 1) is from the span of all others: the inverse length of its row
/// of R^-1. This is estimated to some twenty per cent by what R^-1 makes of vectors of random signs, and measured where
/// that leaves open on which side of `tolerance` it is.
std::vector<double> distancesFromOthers(const SparseMatrix& block, double tolerance)
{
  constexpr double kAcceptAll = -1;
  const SparseQrResult qr = sparseQr(block, kAcceptAll, WantQ::No);
  const SparseMatrix R = withPivots(qr);
  Eigen::MatrixXd probes(block.cols(), kDistanceProbes);
  std::minstd_rand random(1);
  for (double& entry : probes.reshaped()) entry = (random() >> 16) % 2 == 0 ? 1 : -1;
  R.triangularView<Eigen::Upper>().solveInPlace(probes);
  Eigen::VectorXd distances(block.cols());
  for (Index k = 0; k < block.cols(); ++k)
    distances[k] = std::sqrt(static_cast<double>(kDistanceProbes)) / probes.row(k).stableNorm();

  const std::vector<Index> doubtful = doubtfulOnes(distances, tolerance);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(block.cols(), static_cast<Index>(doubtful.size()));
  for (std::size_t m = 0; m < doubtful.size(); ++m) rows(doubtful[m], static_cast<Index>(m)) = 1;
  R.transpose().triangularView<Eigen::Lower>().solveInPlace(rows);
  for (std::size_t m = 0; m < doubtful.size(); ++m)
    distances[doubtful[m]] = 1 / rows.col(static_cast<Index>(m)).stableNorm();

  std::vector<double> result(static_cast<std::size_t>(block.cols()));
  for (Index k = 0; k < block.cols(); ++k) result[qr.columns[k]] = distances[k];
  return result;
}

/// What nearly depends on one another, in one cluster.
struct Cluster {
  RowComponent component;  ///< rows in the order of the basis
  std::vector<double> distances;
};

std::vector<Cluster> clustersOf(const std::vector<RowTerms>& rows, const std::vector<Index>& basis,
                                const std::vector<double>& distances, double tolerance)
{
  std::vector<RowTerms> close;
  std::vector<std::size_t> places;
  Index unknownCount = 0;
  for (std::size_t k = 0; k < basis.size(); ++k) {
    if (!(distances[k] >= kClusterFactor * tolerance)) {
      close.push_back(rows[basis[k]]);
      places.push_back(k);
      unknownCount = std::max(unknownCount, close.back().back().index + 1);
    }
  }
  std::vector<Cluster> result;
  for (RowComponent& component : connectedRows(close, unknownCount)) {
    Cluster cluster{std::move(component), {}};
    for (Index& row : cluster.component.rows) {
      cluster.distances.push_back(distances[places[row]]);
      row = basis[places[row]];
    }
    if (!(std::ranges::min(cluster.distances) >= tolerance)) result.push_back(std::move(cluster));
  }
  return result;
}

bool isLarge(const Cluster& cluster)
{
  return cluster.component.rows.size() > kLargestCluster;
}

/// Returns the rows of a cluster that are too close to the others.
std::vector<Index> closestOf(const Cluster& cluster, double tolerance)
{
  std::vector<Index> result;
  for (std::size_t k = 0; k < cluster.distances.size(); ++k)
    if (!(cluster.distances[k] >= tolerance)) result.push_back(cluster.component.rows[k]);
  return result;
}

/// The rows of a cluster that a sequential QR finds, or the last of those that are closest.
std::vector<Index> lastOf(const Cluster& cluster, const std::vector<RowTerms>& rows, double tolerance)
{
  std::vector<Index> closest = closestOf(cluster, tolerance);
  if (isLarge(cluster)) return {closest.begin() + static_cast<Index>(closest.size() / 2), closest.end()};
  const Eigen::MatrixXd block = transposedBlock(rows, cluster.component);
  SequentialQr qr(block.rows(), block.cols());
  std::vector<Index> result;
  for (Index k = 0; k < block.cols(); ++k)
    if (qr.add(block.col(k), tolerance)) result.push_back(cluster.component.rows[k]);
  if (result.empty()) result.push_back(closest.back());
  return result;
}

}  // namespace

NearRows nearlyDependentRows(const std::vector<RowTerms>& rows, const std::vector<Index>& basis,
                             const std::vector<Index>& unknowns, double tolerance)
{
  SparseMatrix block = transposedBlock(rows, {basis, unknowns});
  (void)normalizeColumns(block);
  const std::vector<Cluster> clusters = clustersOf(rows, basis, distancesFromOthers(block, tolerance), tolerance);
  std::vector<std::vector<Index>> found(clusters.size());
  parallelFor(static_cast<Index>(clusters.size()), [&](Index k) { found[k] = lastOf(clusters[k], rows, tolerance); });
  NearRows result{{}, std::ranges::any_of(clusters, isLarge)};
  for (const std::vector<Index>& some : found) result.last.insert(result.last.end(), some.begin(), some.end());
  return result;
}

}  // namespace holdfast

#include "bench/mumps_factor.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <dmumps_c.h>

namespace holdfast::bench {
namespace {

enum Job { End = -2, Initialise = -1, Analyse = 1, Factorise = 2, Solve = 3 };

constexpr int kMillions = -1'000'000;  // a number below 0 counts these

}  // namespace

struct MumpsFactor::Data {
  DMUMPS_STRUC_C mumps{};
  std::vector<int> rows;  // from 1
  std::vector<int> columns;
  std::vector<double> values;
  std::vector<double> x;

  void run(Job job)
  {
    mumps.job = job;
    dmumps_c(&mumps);
    if (const int code = mumps.infog[0]; code < 0) throw std::runtime_error("MUMPS fails with " + std::to_string(code));
  }
};

MumpsFactor::MumpsFactor(const SparseMatrix& lower) : data_(std::make_unique<Data>())
{
  Data& data = *data_;
  for (int k = 0; k < lower.cols(); ++k)
    for (SparseMatrix::InnerIterator entry(lower, k); entry; ++entry) {
      data.rows.push_back(static_cast<int>(entry.row()) + 1);
      data.columns.push_back(k + 1);
      data.values.push_back(entry.value());
    }
  data.x.resize(3 * static_cast<std::size_t>(lower.cols()));
  DMUMPS_STRUC_C& mumps = data.mumps;
  constexpr int kAllProcesses = -987654;
  mumps.comm_fortran = kAllProcesses;
  mumps.par = 1;
  mumps.sym = 1;  // positive definite
  data.run(Initialise);
  std::fill_n(mumps.icntl, 4, 0);  // silent
  mumps.n = static_cast<int>(lower.cols());
  mumps.nnz = static_cast<MUMPS_INT8>(data.values.size());
  mumps.irn = data.rows.data();
  mumps.jcn = data.columns.data();
  mumps.a = data.values.data();
  mumps.rhs = data.x.data();
  mumps.nrhs = 3;
  mumps.lrhs = mumps.n;
  data.run(Analyse);
}

MumpsFactor::~MumpsFactor()
{
  data_->mumps.job = End;
  dmumps_c(&data_->mumps);
}

void MumpsFactor::factorize()
{
  data_->run(Factorise);
}

void MumpsFactor::solve()
{
  std::ranges::fill(data_->x, 1.0);
  data_->run(Solve);
}

double MumpsFactor::entries() const
{
  const double count = data_->mumps.infog[28];
  return count < 0 ? kMillions * count : count;
}

double MumpsFactor::operations() const
{
  return data_->mumps.rinfog[2];
}

}  // namespace holdfast::bench

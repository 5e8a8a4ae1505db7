#include "egesp/sparse_lu.hpp"

#include <fmt/format.h>
#include <suitesparse/SuiteSparse_config.h>
#include <suitesparse/klu.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/error.hpp"
#include "egesp/batch_shape.hpp"
#include "egesp/large_blocks.hpp"

namespace animado::egesp {
namespace {

constexpr double kMostFactorEntries = 1 << 26;  // of L and U together: 0.8 GiB
// Reciprocal growth of the pivots under which an old order of pivots is given up for a new one.
constexpr double kLeastGrowth = 1e-6;

[[noreturn]] void refuse_size(double entries, double work) {
  throw Error(
      Code::limit,
      fmt::format("the factors would hold about {:.2g} numbers, made by {:.2g} operations", entries, work),
      "values",
      fmt::format("at most {:.2g} numbers and {:.2g} operations are allowed", kMostFactorEntries,
                  kLargestWork));
}

[[noreturn]] void refuse_singular(const std::string& what) {
  throw Error(Code::singular, "the matrix is singular: " + what, "values",
              "look for equations that depend on each other, or for an unknown that none of them holds");
}

// KLU's memory. An ordering that is not AMD's has no estimate, and the factors of a block are one piece of
// memory: that it stays below LargeBlocks::kLargest keeps a service alive which was asked for too much. KLU
// then says that there is no memory. Never destroyed: a system may outlive what main() leaves.
LargeBlocks& memory() {
  static auto* const kMemory = new LargeBlocks;
  return *kMemory;
}

void use_our_memory() {
  SuiteSparse_config.malloc_func = [](size_t bytes) { return memory().allocate(bytes); };
  SuiteSparse_config.realloc_func = [](void* old, size_t bytes) { return memory().resize(old, bytes); };
  SuiteSparse_config.free_func = [](void* old) { memory().release(old); };
}

}  // namespace

struct SparseLu::Klu {
  klu_common common;
  klu_symbolic* symbolic = nullptr;
  klu_numeric* numeric = nullptr;

  explicit Klu(const SparseRule& rule) {
    use_our_memory();
    klu_defaults(&common);
    common.tol = rule.threshold;
    // Natural: KLU calls it "given", and takes the order as it is when no permutation is given.
    common.ordering = rule.ordering == Ordering::natural ? 2 : static_cast<int>(rule.ordering);
  }
  ~Klu() {
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
  }
  void check(bool done) const {
    if (common.status == KLU_OUT_OF_MEMORY || common.status == KLU_TOO_LARGE)
      throw Error(Code::limit, "there is no memory for the factors", "values",
                  "try another ordering, or a smaller system");
    if (common.status == KLU_SINGULAR)
      refuse_singular(fmt::format("no pivot is left in column {}", common.singular_col));
    assert(done && "KLU was called with something invalid");
  }
};

SparseLu::SparseLu(SparseMatrix a, const SparseRule& rule)
    : a_(std::move(a)), klu_(std::make_unique<Klu>(rule)) {
  klu_->symbolic = klu_analyze(a_.n, a_.starts.data(), a_.rows.data(), &klu_->common);
  // With the natural ordering KLU does not look for it; factoring then says what is singular.
  const int rank = klu_->common.structural_rank;
  if (klu_->common.status == KLU_OK && rank >= 0 && rank < a_.n)
    refuse_singular(fmt::format("by its zeros alone its rank is at most {} of {}", rank, a_.n));
  klu_->check(klu_->symbolic != nullptr);
  const klu_symbolic& plan = *klu_->symbolic;
  if (plan.lnz + plan.unz > kMostFactorEntries || plan.est_flops > kLargestWork)
    refuse_size(plan.lnz + plan.unz, plan.est_flops);
  factor();
}

SparseLu::~SparseLu() = default;

void SparseLu::factor() {
  klu_free_numeric(&klu_->numeric, &klu_->common);
  klu_->numeric =
      klu_factor(a_.starts.data(), a_.rows.data(), a_.values.data(), klu_->symbolic, &klu_->common);
  klu_->check(klu_->numeric != nullptr);
}

void SparseLu::refactor(std::vector<double> values) {
  assert(values.size() == a_.values.size());
  a_.values = std::move(values);
  int* starts = a_.starts.data();
  int* rows = a_.rows.data();
  const bool kept =
      klu_->numeric != nullptr &&
      klu_refactor(starts, rows, a_.values.data(), klu_->symbolic, klu_->numeric, &klu_->common) == 1 &&
      klu_->common.status == KLU_OK &&
      klu_rgrowth(starts, rows, a_.values.data(), klu_->symbolic, klu_->numeric, &klu_->common) == 1 &&
      klu_->common.rgrowth >= kLeastGrowth;
  if (!kept) factor();
}

SparseLu::Facts SparseLu::facts() const {
  klu_rcond(klu_->symbolic, klu_->numeric, &klu_->common);
  return {static_cast<int64_t>(a_.values.size()), int64_t{klu_->numeric->lnz} + klu_->numeric->unz,
          klu_->symbolic->nblocks, klu_->common.rcond};
}

size_t SparseLu::bytes() const {
  return klu_->common.memusage + a_.values.size() * (sizeof(double) + sizeof(int)) +
         a_.starts.size() * sizeof(int);
}

double SparseLu::norm_one() const {
  double largest = 0;
  for (size_t j = 0; j < size(); ++j) {
    double sum = 0;
    for (int e = a_.starts[j]; e < a_.starts[j + 1]; ++e) sum += std::abs(a_.values[static_cast<size_t>(e)]);
    largest = std::max(largest, sum);
  }
  return largest;
}

double SparseLu::norm_rows() const {
  std::vector<double> sums(size());
  for (size_t e = 0; e < a_.values.size(); ++e)
    sums[static_cast<size_t>(a_.rows[e])] += std::abs(a_.values[e]);
  return *std::ranges::max_element(sums);
}

// KLU wants each right-hand side by itself.
void SparseLu::solve(std::span<double> b, size_t m) const {
  if (klu_->numeric == nullptr) refuse_singular("its last values were refused");
  const size_t n = size();
  std::vector<double> column(m == 1 ? 0 : n);
  for (size_t c = 0; c < m; ++c) {
    for (size_t i = 0; i < column.size(); ++i) column[i] = b[i * m + c];
    klu_solve(klu_->symbolic, klu_->numeric, a_.n, 1, m == 1 ? b.data() : column.data(), &klu_->common);
    for (size_t i = 0; i < column.size(); ++i) b[i * m + c] = column[i];
  }
}

void SparseLu::solve_transposed(std::span<double> b) const {
  klu_tsolve(klu_->symbolic, klu_->numeric, a_.n, 1, b.data(), &klu_->common);
}

void SparseLu::residual(std::span<const double> b, std::span<const double> x, size_t m, size_t column,
                        std::span<double> r) const {
  std::vector<long double> sums(size());
  for (size_t i = 0; i < sums.size(); ++i) sums[i] = b[i * m + column];
  for (size_t j = 0; j < size(); ++j) {
    const long double factor = x[j * m + column];
    for (auto e = static_cast<size_t>(a_.starts[j]); e < static_cast<size_t>(a_.starts[j + 1]); ++e)
      sums[static_cast<size_t>(a_.rows[e])] -= a_.values[e] * factor;
  }
  for (size_t i = 0; i < sums.size(); ++i) r[i] = static_cast<double>(sums[i]);
}

}  // namespace animado::egesp

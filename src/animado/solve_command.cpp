// animado solve: a linear system from Matrix Market files, by egesp.
#include <fmt/ranges.h>
#include <unistd.h>

#include "animado/commands.hpp"
#include "animado/matrix_market.hpp"
#include "animado/suite_or_own.hpp"
#include "console/terminal.hpp"
#include "controle/results/output_file.hpp"
#include "egesp/client.hpp"
#include "rpc/shared_array.hpp"

namespace animado {

namespace {

using egesp::Array;

constexpr auto kSolveExamples =
    "  animado solve A.mtx b.mtx                     prints x, a number a line\n"
    "  animado solve A.mtx b.mtx -o x.mtx            writes it as a Matrix Market file\n"
    "  animado solve A.mtx b.mtx --refine --condition\n"
    "  animado solve A.mtx b.mtx --least-squares --minimum-norm\n\n"
    "A coordinate file is solved as a sparse system, an array file as a dense one. Asks the egesp of the "
    "suite that runs;\n"
    "when none does, the one that is linked into this program. What is said about x goes to stderr.\n";

constexpr size_t kMostInline = 1 << 16;  // numbers that travel in the message; more are shared

struct SolveOptions {
  SuiteChoice suite;
  std::string matrix, right_side, out, method = "auto", pivoting = "partial";
  std::optional<double> threshold;
  bool residual = false, refine = false, condition = false, least_squares = false, minimum_norm = false;
};

// The numbers of one call, on their way to egesp and back.
class Numbers {
 public:
  explicit Numbers(rpc::Suite& suite) : suite_(suite) {}

  Array send(std::vector<int64_t> shape, std::vector<double> values) {
    if (values.size() <= kMostInline) return Array::inlined(std::move(shape), std::move(values));
    const Array array = make(std::move(shape));
    std::ranges::copy(values, read(array).begin());
    return array;
  }
  std::optional<Array> room_for(std::vector<int64_t> shape) {
    const auto count = static_cast<size_t>(Array::inlined(shape, {}).count());
    if (count <= kMostInline) return std::nullopt;
    return make(std::move(shape));
  }
  std::vector<double> receive(const Array& array) {
    if (!array.is_shared()) return array.values;
    const auto values = read(array);
    return {values.begin(), values.end()};
  }

 private:
  Array make(std::vector<int64_t> shape) {
    std::string name = fmt::format("solve/{}/{}", getpid(), ++count_);
    suite_.arrays().create(name, shape);
    return Array::named(std::move(name), std::move(shape));
  }
  std::span<double> read(const Array& array) { return suite_.arrays().open(array.shared).values(); }

  rpc::Suite& suite_;
  int count_ = 0;
};

void tell(const std::optional<egesp::Accuracy>& accuracy) {
  if (!accuracy) return;
  for (double error : accuracy->backward_errors) print_note(fmt::format("backward error {:.2g}", error));
  for (double condition : accuracy->reciprocal_conditions)
    print_note(fmt::format("reciprocal condition {:.2g}", condition));
  if (!accuracy->warning.empty()) print_note("warning: " + accuracy->warning);
}

std::vector<double> solve_dense(const SolveOptions& o, const MarketMatrix& a, Array b, Numbers& numbers,
                                egesp::Client egesp) {
  egesp::Solve::Request request;
  request.matrices = numbers.send({a.rows, a.columns}, a.dense());
  request.out = numbers.room_for(b.shape);
  request.right_sides = std::move(b);
  request.pivoting = o.pivoting == "complete" ? egesp::Pivoting::complete : egesp::Pivoting::partial;
  request.threshold = o.threshold.value_or(request.threshold);
  request.residual = o.residual, request.refine = o.refine, request.condition = o.condition;
  const auto reply = egesp.solve(request);
  tell(reply.accuracy);
  return numbers.receive(reply.solutions);
}

std::vector<double> solve_sparse(const SolveOptions& o, const MarketMatrix& a, Array b, Numbers& numbers,
                                 egesp::Client egesp) {
  const auto count = static_cast<int64_t>(a.values.size());
  egesp::SparseSolve::Request request;
  request.matrix = {egesp::Format::triplets, a.rows, numbers.send({count}, a.at_row),
                    numbers.send({count}, a.at_column), numbers.send({count}, a.values)};
  request.out = numbers.room_for(b.shape);
  request.right_sides = std::move(b);
  request.options.threshold = o.threshold.value_or(request.options.threshold);
  request.residual = o.residual, request.refine = o.refine, request.condition = o.condition;
  const auto reply = egesp.sparse_solve(request);
  tell(reply.accuracy);
  return numbers.receive(reply.solutions);
}

std::vector<double> fit(const SolveOptions& o, const MarketMatrix& a, Array b, Numbers& numbers,
                        egesp::Client egesp) {
  egesp::LeastSquares::Request request;
  request.matrix = numbers.send({a.rows, a.columns}, a.dense());
  request.out = numbers.room_for({a.columns, b.shape[1]});
  request.right_sides = std::move(b);
  request.threshold = o.threshold.value_or(request.threshold);
  request.minimum_norm = o.minimum_norm;
  const auto reply = egesp.least_squares(request);
  print_note(fmt::format("rank {}, null space of dimension {}, residual norm {:.6g}", reply.rank,
                         reply.null_space, fmt::join(reply.residual_norms, ", ")));
  return numbers.receive(reply.solutions);
}

void check_shapes(const SolveOptions& o, const MarketMatrix& a, const MarketMatrix& b) {
  if (b.rows != a.rows) {
    throw Error(Code::bad_shape, fmt::format("{} rows, and {} in {}", b.rows, a.rows, o.matrix), o.right_side,
                "the right-hand side has a row for each row of the matrix");
  }
  if (a.rows != a.columns && !o.least_squares) {
    throw Error(Code::bad_shape, fmt::format("a matrix of {} × {} has no unique solution", a.rows, a.columns),
                o.matrix, "ask for --least-squares");
  }
}

void write_solution(const std::string& file, const MarketMatrix& a, const MarketMatrix& b,
                    std::span<const double> x) {
  if (file.empty()) {
    for (size_t i = 0; i < x.size(); i += static_cast<size_t>(b.columns))
      fmt::print("{}\n", fmt::join(x.subspan(i, static_cast<size_t>(b.columns)), " "));
    return;
  }
  controle::write_whole(file, matrix_market_text(a.columns, b.columns, x));
}

void solve(const SolveOptions& o) {
  const MarketMatrix a = read_matrix_market(o.matrix), b = read_matrix_market(o.right_side);
  check_shapes(o, a, b);
  const auto suite = suite_or_own(o.suite);
  egesp::Client egesp(suite->channel("egesp"));
  Numbers numbers(*suite);
  Array sides = numbers.send({b.rows, b.columns}, b.dense());
  const bool sparse = o.method == "sparse" || (o.method == "auto" && a.sparse);
  const auto work = o.least_squares ? fit : sparse ? solve_sparse : solve_dense;
  write_solution(o.out, a, b, work(o, a, std::move(sides), numbers, egesp));
}

}  // namespace

void add_solve_command(CommandLine& line) {
  const auto o = std::make_shared<SolveOptions>();
  CLI::App& command =
      add_command(line, "solve", "Solve a linear system from Matrix Market files", kSolveExamples);
  command.add_option("A", o->matrix, "The matrix")->required()->type_name(kFileType);
  command.add_option("b", o->right_side, "The right-hand side, or several as columns")
      ->required()
      ->type_name(kFileType);
  command.add_option("-o,--out", o->out, "Write x here and not to stdout")->type_name(kFileType);
  command.add_option("--method", o->method, "auto (by the file), dense or sparse")
      ->check(CLI::IsMember({"auto", "dense", "sparse"}));
  command.add_option("--pivoting", o->pivoting, "partial or complete (dense systems)")
      ->check(CLI::IsMember({"partial", "complete"}));
  command.add_option("--threshold", o->threshold, "T: see docs/egesp.md; its meaning depends on the method");
  command.add_flag("--residual", o->residual, "Tell the backward error");
  command.add_flag("--refine", o->refine, "One step of iterative refinement");
  command.add_flag("--condition", o->condition,
                   "Tell the reciprocal condition; warn when the system is ill-conditioned");
  CLI::Option* fit = command.add_flag("--least-squares", o->least_squares,
                                      "Any shape and rank: least squares by Householder reflections");
  for (const auto* other : {"--method", "--pivoting", "--residual", "--refine", "--condition"})
    fit->excludes(other);
  command.add_flag("--minimum-norm", o->minimum_norm, "With --least-squares: of all solutions the shortest")
      ->needs(fit);
  add_suite_choice(command, o->suite);
  command.callback([o] { solve(*o); });
}

}  // namespace animado

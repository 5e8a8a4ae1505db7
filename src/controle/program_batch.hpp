// The scene's expressions evaluated together: those of one formula, each about its own body, in one batch
// across SIMD lanes. The same bits as one by one.
#pragma once

#include <optional>
#include <vector>

#include "controle/live_program.hpp"

namespace animado::controle {

// Expressions that differ in the bodies they read and in the values of constants, a mass say. A lane is one
// of them.
class ProgramBatch {
 public:
  explicit ProgramBatch(const LiveProgram& first) : members_{&first} {}

  bool add(const LiveProgram& program);  // whether it is of the same formula
  void close();                          // all are there
  size_t lanes() const { return members_.size(); }

  const double* evaluate(const Moment& moment);  // (3, lanes)

 private:
  // An input of the opened program: where its rows start, and by what bodies they are read.
  struct Column {
    Reading reading;           // of the first lane
    std::vector<int> bodies;   // of each lane; one when all read the same
    bool in_place = false;     // the bodies are neighbours in the state, where the rows may be read
    std::vector<double> rows;  // else they are gathered here
  };
  void gather(Column& column, const Moment& moment);

  std::vector<const LiveProgram*> members_;
  std::optional<interexpserv::Program> opened_;
  std::vector<std::vector<double>> constants_;  // each of all lanes, or one that they share
  std::vector<Column> columns_;
  std::vector<interexpserv::Lanes> inputs_;
  std::vector<double> values_;  // (3, lanes)
};

}  // namespace animado::controle

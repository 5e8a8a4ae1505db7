// The downward sweep of Gauss–Jordan elimination for the systems in one register, of any size. The equations
// and the bits are those of echelon.hpp.
//
// Lanes with different pivots go the same way through the code. Each lane's numbers that change places are
// taken out and put back one by one, which costs the same for any number of rows. A register that is read
// while such a number is on its way to memory waits for it: so all columns change their rows first, and those
// of the pivots, which are needed at once, under masks.
//
// With partial pivoting two steps go together: the columns of their pivots first, then every other column is
// read and written once for both. The last steps are those of a small block.
#pragma once

#include "egesp/lanes.block.hpp"
#include "egesp/lanes.fetch.hpp"
#include "egesp/lanes.last_steps.hpp"

namespace animado::egesp {
namespace {

// f(i, r) for rows begin … end − 1 and r = 0 … 3 in turn: in fours, so that a loop costs a quarter of its
// turns. The last four may reach into the spare rows of a block, which hold zeros at first and whose numbers
// nobody uses.
template <class F>
ANIMADO_INLINE void each_row(int begin, int end, const F& f) {
  for (int i = begin; i < end; i += 4) {
#pragma GCC unroll 4
    for (int r = 0; r < 4; ++r) f(i + r, r);
  }
}

// A maximum in four parts, so that none waits for the one before.
struct Largest {
  Lane part[4] = {};
  ANIMADO_INLINE void see(Lane size, int r) { part[r] = larger(size, part[r]); }
  ANIMADO_INLINE Lane of_all() const { return larger(larger(part[0], part[1]), larger(part[2], part[3])); }
};

// What goes to place k in each lane: as a number to compare with from_end, and where it lies.
struct Choice {
  Lane from_end;
  Places at;
};

// The chosen one of the registers from `first` on and the k-th change places.
ANIMADO_INLINE void change_places(const Choice& choice, Lane* first, Lane& kth) {
  double* const numbers = reinterpret_cast<double*>(first);
  const Lane old = kth, chosen = gather(numbers, choice.at);
  scatter(old, numbers, choice.at);
  kth = chosen;
}

// The same in a column whose rows are needed at once: row k changes here, the others are read as they become.
class Changed {
 public:
  ANIMADO_INLINE Changed(const Choice& choice, Lane* column, int k, const Lane* from_end)
      : chosen_(choice.from_end), old_(column[k]), column_(column), from_end_(from_end) {
    column[k] = gather(reinterpret_cast<const double*>(column), choice.at);
  }
  ANIMADO_INLINE Lane operator()(int i) const { return chosen_ == from_end_[i] ? old_ : column_[i]; }

 private:
  Lane chosen_, old_;
  const Lane *column_, *from_end_;
};

// kKeep: the factors follow their rows, and row_order says which these are.
template <bool kKeep>
class LoopedSweep {
 public:
  explicit LoopedSweep(Block<0, 0>& block) : block_(block), n_(block.n()), columns_(block.columns()) {
    for (int i = 0; i < block.kRows; ++i) from_end_[i] = Lane{} + (block.kRows - i);
    for (int j = 0; j < columns_; ++j) {
      for (int i = n_; i < block.column_stride(); ++i) column(j)[i] = Lane{};
    }
  }

  // Other systems, which this sweep fetches on its way. Not where the factors are kept: those come one by
  // one.
  void fetch(const double* matrices, size_t stride) {
    fetch_.start(matrices, static_cast<size_t>(n_ * n_), stride);
  }

  // Returns the largest |a_i0|, among which the first pivot is looked for.
  ANIMADO_INLINE Lane load(const Source& source) {
    Largest largest;
    Lane of_first = {};
    for (int j = 0; j < n_; ++j) {
      load_column(j, source.matrices, j, n_, source.stride,
                  [&](Lane v, int r) { largest.see(absolute(v), r); });
      if (j == 0) of_first = largest.of_all();
    }
    for (int j = n_; j < columns_; ++j) {
      load_column(j, source.right_sides, j - n_, columns_ - n_, source.stride, [](Lane, int) {});
    }
    block_.largest = largest.of_all();
    return of_first;
  }

  // largest: |a_i0|. A pivot is looked for as soon as its column is ready: most of the search is waiting,
  // during which the processor goes on to the other columns.
  ANIMADO_INLINE void partial(Lane largest) {
    const int last = last_steps(), end = n_ - last;
    Choice first = choose_pivot(0, largest);
    for (int k = 0; k + 1 < end; k += 2) {
      Largest next;
      eliminate(k, k + 1, changed(first, k + 1, k), [&](Lane v, int, int r) { next.see(absolute(v), r); });
      const Choice second = choose_pivot(k + 1, next.of_all());
      change_rows(first, k, k, k + 2);
      const Changed factors = changed(second, k, k + 1);
      each_row(k + 2, n_, [&](int i, int) { column(k)[i] = factors(i); });
      change_rows(second, k + 1, k, k + 2);
      int j = k + 2;
      if (j < end) first = choose_pivot(j++, eliminate_two_in_next(k));
      eliminate_two(k, j);
    }
    if (last == kLastSteps) take_last_steps<kLastSteps>(block_, fetch_);
    if (last == kLastSteps - 1) take_last_steps<kLastSteps - 1>(block_, fetch_);
  }

  ANIMADO_INLINE void complete() {
    Lane row_size[Block<0, 0>::kRows];
    const auto measure = [&](int first, int j, int i, Lane v) {
      if (j == first) row_size[i] = absolute(v);
      if (j > first && j < n_) row_size[i] = larger(absolute(v), row_size[i]);
    };
    for (int j = 0; j < n_; ++j) each_row(0, n_, [&](int i, int) { measure(0, j, i, column(j)[i]); });
    for (int k = 0; k < n_; ++k) {
      Largest sizes;
      each_row(k, n_, [&](int i, int r) { sizes.see(row_size[i], r); });
      const Lane largest = sizes.of_all();
      change_rows(choose(k, largest, 1, [&](int i) { return row_size[i]; }), k, k, k);
      change_columns(k, largest);
      take_pivot(k, largest, [&](int i) { return column(k)[i]; });
      for (int j = k + 1; j < columns_; ++j) {
        const auto row = [&](int i) { return column(j)[i]; };
        eliminate(k, j, row, [&](Lane v, int i, int) { measure(k + 1, j, i, v); });
        if constexpr (!kKeep) fetch_.lines<Fetch::kEliminating>();
      }
    }
  }

 private:
  // Column j of the block, from a matrix's column `from` of `columns`. see(v, r): its registers, r as in
  // each_row.
  template <class See>
  ANIMADO_INLINE void load_column(int j, const double* numbers, int from, int columns, size_t stride,
                                  const See& see) {
    const double* p = numbers + static_cast<size_t>(from) * stride;
    const size_t row = static_cast<size_t>(columns) * stride;
    const auto take = [&](int i, int r) {
      const Lane v = column(j)[i] = egesp::load(p + static_cast<size_t>(r) * row);
      see(v, r);
    };
    int i = 0;
    for (; i + 4 <= n_; i += 4, p += 4 * row) {
#pragma GCC unroll 4
      for (int r = 0; r < 4; ++r) take(i + r, r);
    }
#pragma GCC unroll 4
    for (int r = 0; r < 3; ++r) {
      if (i + r < n_) take(i + r, r);
    }
  }

  // How many steps are left to take_last_steps, so that an even number comes before them. Where factors are
  // kept they would have to follow their rows there too.
  static constexpr int kLastSteps = 6;
  ANIMADO_INLINE int last_steps() const {
    return kKeep || columns_ != n_ + 1 || n_ <= kLastSteps ? 0 : kLastSteps - n_ % 2;
  }

  ANIMADO_INLINE Lane* column(int j) {
    return block_.column(j);
  }
  ANIMADO_INLINE Changed changed(const Choice& choice, int j, int k) {
    return {choice, column(j), k, from_end_};
  }

  // The first of k … n − 1 whose size is the largest; one of them is, so the last where no other was.
  // stride: registers from one to the next.
  template <class Size>
  ANIMADO_INLINE Choice choose(int k, Lane largest, int stride, const Size& size) {
    Largest first;
    first.see(from_end_[n_ - 1], 0);
    each_row(k, n_,
             [&](int i, int r) { first.see((Lane)((Mask)from_end_[i] & equal(size(i), largest)), r); });
    Choice choice;
    choice.from_end = first.of_all();
    for (size_t lane = 0; lane < kWidth; ++lane) {
      const auto place = Block<0, 0>::kRows - static_cast<ptrdiff_t>(choice.from_end[lane]);
      choice.at[lane] = place * stride * static_cast<ptrdiff_t>(kWidth) + static_cast<ptrdiff_t>(lane);
    }
    return choice;
  }
  ANIMADO_INLINE Choice choose_row(int k, Lane largest) {
    return choose(k, largest, 1, [&](int i) { return absolute(column(k)[i]); });
  }

  // The row with the largest, whose column becomes the factors; the other columns still have their rows as
  // they were.
  ANIMADO_INLINE Choice choose_pivot(int k, Lane largest) {
    const Choice choice = choose_row(k, largest);
    take_pivot(k, largest, changed(choice, k, k));
    return choice;
  }

  // In the columns from `begin` on, and in the factors of the steps before `kept` where they are kept.
  ANIMADO_INLINE void change_rows(const Choice& choice, int k, int kept, int begin) {
    if constexpr (kKeep) {
      for (int j = 0; j < kept; ++j) change_places(choice, column(j), column(j)[k]);
      change_places(choice, block_.row_order, block_.row_order[k]);
    }
    Fetch fetch = fetch_;  // in registers
    Lane* c = column(begin);
    for (int j = begin; j < columns_; ++j, c += block_.column_stride()) {
      change_places(choice, c, c[k]);
      if constexpr (!kKeep) fetch.lines<Fetch::kChanging>();
    }
    fetch_ = fetch;
  }

  // largest: |a_kk| once the column that holds it is at k.
  ANIMADO_INLINE void change_columns(int k, Lane largest) {
    const int stride = block_.column_stride();
    const Choice choice = choose(k, largest, stride, [&](int j) { return absolute(column(j)[k]); });
    for (int i = 0; i < n_; ++i) change_places(choice, block_.a + i, column(k)[i]);
    // Places in the order are a register apart, those of columns a column.
    Choice in_order = choice;
    for (size_t lane = 0; lane < kWidth; ++lane)
      in_order.at[lane] =
          (choice.at[lane] - static_cast<ptrdiff_t>(lane)) / stride + static_cast<ptrdiff_t>(lane);
    change_places(in_order, block_.column_order, block_.column_order[k]);
  }

  // With the pivot in its place: column k becomes the factors. row(i): its rows.
  template <class Row>
  ANIMADO_INLINE void take_pivot(int k, Lane largest, const Row& row) {
    Lane* a = column(k);
    block_.weakest = k == 0 ? largest : smaller(largest, block_.weakest);
    const Lane inverse = block_.inverse[k] = with_sign(1.0 / largest, a[k]);
    each_row(k + 1, n_, [&](int i, int) { a[i] = row(i) * inverse; });
  }

  // Step k in column j. row(i): its rows; see(v, i, r): what they become.
  template <class Row, class See>
  ANIMADO_INLINE void eliminate(int k, int j, const Row& row, const See& see) {
    Lane* c = column(j);
    const Lane *factor = column(k), top = c[k];
    each_row(k + 1, n_, [&](int i, int r) {
      c[i] = row(i) - factor[i] * top;
      see(c[i], i, r);
    });
  }

  // Steps k and k + 1 in column j. rows(row): row(i) for the i-th below them, which becomes what it returns.
  template <class Rows>
  ANIMADO_INLINE void eliminate_two_in(int k, int j, Fetch& fetch, const Rows& rows) {
    const Lane *f = column(k) + k + 2, *g = column(k + 1) + k + 2, between = f[-1];
    Lane* c = column(j) + k + 2;
    const Lane top = c[-2], second = c[-1] - between * top;
    c[-1] = second;
    if constexpr (!kKeep) fetch.lines<Fetch::kEliminatingTwo>();
    rows([&](int i) { return c[i] = c[i] - f[i] * top - g[i] * second; });
  }

  // In the column of the next pivot. Returns the largest of it.
  ANIMADO_INLINE Lane eliminate_two_in_next(int k) {
    Largest next;
    eliminate_two_in(k, k + 2, fetch_, [&](const auto& row) {
      each_row(0, n_ - (k + 2), [&](int i, int r) { next.see(absolute(row(i)), r); });
    });
    return next.of_all();
  }

  // In the columns from `begin` on. Rows in twos and without a branch: there is one row too many at the most.
  ANIMADO_INLINE void eliminate_two(int k, int begin) {
    Fetch fetch = fetch_;  // in registers
    unrolled<kLaneSize / 2>((n_ - (k + 2) + 1) / 2, [&]<int kTwos>() {
      for (int j = begin; j < columns_; ++j) {
        eliminate_two_in(k, j, fetch, [](const auto& row) {
#pragma GCC unroll 32
          for (int i = 0; i < 2 * kTwos; ++i) row(i);
        });
      }
    });
    fetch_ = fetch;
  }

  Block<0, 0>& block_;
  Fetch fetch_;
  const int n_, columns_;
  Lane from_end_[Block<0, 0>::kRows];  // rows as numbers of which the first is the largest
};

}  // namespace
}  // namespace animado::egesp

// The cores share the rows of a picture. Which of them draws a row changes nothing in it.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace animado::visao {

template <class Draw>
void for_each_row(int rows, const Draw& draw) {
  std::atomic<int> next = 0;
  const auto work = [&] {
    for (int row; (row = next++) < rows;) draw(row);
  };
  const int others = std::min<int>(static_cast<int>(std::thread::hardware_concurrency()), rows) - 1;
  std::vector<std::jthread> threads;
  for (int k = 0; k < others; ++k) threads.emplace_back(work);
  work();
}

}  // namespace animado::visao

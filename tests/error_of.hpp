// The error that something throws; fails the test when it throws none.
#pragma once

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace animado {

template <class F>
Error error_of(F&& action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was refused";
  return {Code::internal, ""};
}

}  // namespace animado

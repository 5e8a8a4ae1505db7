// What egesp keeps between two requests: handles, common to prepared systems of every kind.
#pragma once

#include "rpc/message.hpp"

namespace animado::egesp {

struct Release {
  static constexpr std::string_view name = "release";
  static constexpr std::string_view doc =
      "Forgets a prepared system, dense or sparse. Nothing happens when the handle is not known: it ended "
      "already.";
  struct Request {
    int64_t handle = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "of prepare or sparse_prepare");
    }
  };
  using Reply = rpc::Nothing;
};

}  // namespace animado::egesp

// What a caller is told when a request is refused. Three kinds of failure, never mixed: a bug asserts; a bad
// request throws Error and names its remedy; a method that does not converge returns a status with iterations
// and residual.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace animado {

// The fixed list of codes of the wire. Order and spelling are part of the protocol.
enum class Code {
  protocol,        // not MessagePack-RPC, or a version that is not spoken here
  unknown_method,  // the service has no such message
  bad_params,      // a field is missing, unknown or of the wrong type
  bad_shape,       // an array's shape does not fit the request
  not_finite,      // NaN or infinity where a number is needed
  singular,        // a linear system without a unique solution
  syntax,          // an expression or a scene that cannot be read
  type,            // an expression of the wrong type
  unknown_name,    // a name that is not defined
  cycle,           // names that need each other
  conflict,        // what is there already forbids it
  unknown_array,   // a shared array that nobody created
  unknown_handle,  // prepared data that this server does not hold (it was restarted: prepare again)
  limit,           // a message, a batch or a time over the stated limit
  refused,         // physical nonsense, a scene that makes no sense
  diverged,        // the motion left the finite
  unavailable,     // the service cannot be reached
  internal,        // a bug in the service: it says where
};

std::string_view name_of(Code code);
Code code_named(std::string_view name);  // Code::internal when the name is unknown

class Error : public std::runtime_error {
 public:
  // where: file:line:column, a field or a service; remedy: what to do about it. Both may be empty.
  Error(Code code, std::string message, std::string where = {}, std::string remedy = {});

  Code code() const { return code_; }
  const std::string& message() const { return message_; }
  const std::string& where() const { return where_; }
  const std::string& remedy() const { return remedy_; }

 private:
  Code code_;
  std::string message_, where_, remedy_;
};

}  // namespace animado

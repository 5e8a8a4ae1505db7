// Words that the algorithms and the messages share.
#pragma once

namespace animado::fred {

// explicit_fixed: steps of one length. explicit_adaptive: an embedded method tells the error. symplectic: for
// separable systems, steps of one length. implicit: for stiff systems, adaptive.
enum class MethodKind { explicit_fixed, explicit_adaptive, symplectic, implicit };

// Why an integration ended. end: the time that was asked for. event: a terminal one. step_too_small: stiff or
// singular there. cancelled: the caller is gone.
enum class Stop { end, event, step_limit, time_limit, step_too_small, not_finite, cancelled };

// Which crossings of zero count.
enum class Crossing { any, rising, falling };

}  // namespace animado::fred

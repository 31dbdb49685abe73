// A program's messages, one per line, and the robot message that follows its hello.
#include "experiments/foreign/protocol.hpp"

#include <algorithm>

#include "tests/fuzz/fuzz.hpp"

using namespace ikbench;
using namespace ikbench::experiments;

namespace {

// A breach is refused, too.
template <class Reader>
void hear(Reader&& reader) {
  read_or_refuse([&] {
    try {
      reader();
    } catch (const Breach& breach) {
      throw std::invalid_argument(breach.what());
    }
  });
}

void tell_arm(const Hello& hello) {
  static const robots::Robot arm = robots::robot("ur5e");
  static const std::vector<std::string> names(arm.chain.links().size(), "joint");
  robot_message({.name = arm.name, .arm = arm.chain, .limits = arm.limits, .joint_names = names}, hello,
                options_of(hello, {}));
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest = text_of(data, size);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::optional<Message> message = message_in(std::string(rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!message) continue;
    why_in(message->json);
    hear([&] { tell_arm(hello_in(*message)); });
    for (const int joints : {1, 3}) {
      hear([&] { candidates_in(*message, joints); });
      hear([&] { solved_in(*message, joints); });
      hear([&] { batch_solved_in(*message, joints, 2); });
    }
  }
  return 0;
}

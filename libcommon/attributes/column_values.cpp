#include "attributes/column_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace partwise {

io::Values values_like(const io::Values& like, const std::vector<double>& numbers) {
  return std::visit(
      [&](const auto& list) -> io::Values {
        using Value = typename std::decay_t<decltype(list)>::value_type;
        std::vector<Value> result;
        result.reserve(numbers.size());
        for (const double number : numbers) {
          if constexpr (std::is_integral_v<Value>) {
            const double least = std::numeric_limits<Value>::min(), most = std::numeric_limits<Value>::max();
            result.push_back(static_cast<Value>(std::clamp(std::round(number), least, most)));
          } else {
            result.push_back(static_cast<Value>(number));
          }
        }
        return result;
      },
      like);
}

bool is_real(const io::Values& values) {
  return std::holds_alternative<std::vector<float>>(values) ||
         std::holds_alternative<std::vector<double>>(values);
}

bool is_colour(const std::string& property) {
  constexpr std::array<const char*, 4> kChannels{"red", "green", "blue", "alpha"};
  return std::any_of(kChannels.begin(), kChannels.end(), [&](const std::string& channel) {
    return property == channel || property.ends_with("_" + channel);
  });
}

}  // namespace partwise

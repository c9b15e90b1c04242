#include "probe_reading.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <sstream>

namespace mirrorball {

namespace {

using namespace std::string_view_literals;
constexpr std::array windowWords{"display"sv, "data"sv};
constexpr std::array fitWords{"none"sv, "stretch"sv, "pad"sv, "crop"sv};
constexpr std::array beyondWords{"black"sv, "mirrored"sv};
constexpr std::array mirrorWords{"none"sv, "x"sv, "y"sv, "z"sv};
constexpr std::array certaintyWords{"certain"sv, "likely"sv, "guess"sv};

/// A turn about one axis in the plane of the next two, from the first of them towards the second.
glm::dmat3 turn(int from, int to, double degrees)
{
    const double c = std::cos(degrees * pi / 180.0), s = std::sin(degrees * pi / 180.0);
    glm::dmat3 m(1.0);
    m[from][from] = m[to][to] = c;
    m[from][to] = s;
    m[to][from] = -s;
    return m;
}

constexpr int x = 0, y = 1, z = 2;

glm::dmat3 rotation(const glm::dvec3& yxz) { return turn(z, x, yxz[0]) * turn(y, z, yxz[1]) * turn(x, y, yxz[2]); }

glm::dmat3 rotation(double w, const glm::dvec3& v)
{
    const auto column = [&](const glm::dvec3& d) { return d + 2.0 * glm::cross(v, glm::cross(v, d) + w * d); };
    return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

/// The angles about Y, X, Z of a rotation; at the poles the turn about Z is none.
glm::dvec3 anglesOf(const glm::dmat3& m)
{
    const double sinX = std::clamp(-m[z][y], -1.0, 1.0);
    glm::dvec3 angles(0.0, std::asin(sinX), 0.0);
    if (std::abs(sinX) < 1.0 - 1e-12) {
        angles[0] = std::atan2(m[z][x], m[z][z]);
        angles[2] = std::atan2(m[x][y], m[y][y]);
    } else {
        angles[0] = std::atan2(-m[x][z], m[x][x]);
    }
    return angles * (180.0 / pi);
}

} // namespace

std::span<const std::string_view> words(PictureWindow) { return windowWords; }
std::span<const std::string_view> words(Fit) { return fitWords; }
std::span<const std::string_view> words(BeyondView) { return beyondWords; }
std::span<const std::string_view> words(MirrorAxis) { return mirrorWords; }

std::string_view name(Certainty certainty) { return certaintyWords[static_cast<size_t>(certainty)]; }

glm::dmat3 orientation(const ProbeReading& reading)
{
    glm::dmat3 mirror(1.0);
    if (reading.mirror != MirrorAxis::None) {
        const int axis = static_cast<int>(reading.mirror) - 1;
        mirror[axis][axis] = -1.0;
    }
    return reading.rotateDeg == glm::dvec3(0.0) ? mirror : rotation(reading.rotateDeg) * mirror;
}

glm::dvec3 parseRotation(const std::string& option, const std::string& text)
{
    std::vector<double> numbers;
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    double number = 0.0;
    bool good = true;
    while (good && stream >> number) {
        numbers.push_back(number);
        char comma = 0;
        good = stream.eof() || (stream >> comma && comma == ',');
    }
    good = good && stream.eof() && !text.ends_with(',') &&
           std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::abs(n) <= 36000.0; });
    if (good && numbers.size() == 3)
        return {numbers[0], numbers[1], numbers[2]};
    const double length = numbers.size() == 4 ? std::hypot(std::hypot(numbers[0], numbers[1]), std::hypot(numbers[2], numbers[3])) : 0.0;
    if (good && length > 1e-9)
        return anglesOf(rotation(numbers[0] / length, glm::dvec3(numbers[1], numbers[2], numbers[3]) / length));
    throw InvalidArgument(
        option + ": must be three angles about Y, X and Z in degrees, such as 90,0,-2.5, or a quaternion w,x,y,z; it is '" + text + "'");
}

void assume(std::vector<Assumption>& assumptions, Assumption assumption)
{
    const auto found =
        std::find_if(assumptions.begin(), assumptions.end(), [&](const Assumption& a) { return a.topic == assumption.topic; });
    if (found == assumptions.end())
        assumptions.push_back(std::move(assumption));
    else
        *found = std::move(assumption);
}

std::string summary(const std::vector<Assumption>& assumptions)
{
    std::string text;
    for (const Assumption& a : assumptions) {
        if (a.topic == "handedness" || a.topic == "parameterization" || (a.certainty == Certainty::Certain && a.others.empty()))
            continue;
        text += (text.empty() ? "" : "; ") + a.topic + " " + a.value;
        for (size_t i = 0; i < a.others.size(); ++i)
            text += (i == 0 ? ", besides " : ", ") + a.others[i];
    }
    return text;
}

} // namespace mirrorball

#include "babylon_env.h"

#include "packed_texel.h"
#include "png_codec.h"
#include "texture_size.h"

#include <nlohmann/json.hpp>

#include <bit>

namespace mirrorball::babylon_env {

namespace {

using namespace std::string_view_literals;
using nlohmann::json;

constexpr std::string_view signature = "\x86\x16\x87\x96\xF6\xD6\x96\x36"sv;
constexpr size_t largestManifest = 1 << 20; ///< bytes of JSON
constexpr int largestWidth = 8192;

std::string facePng(const Image& level, int face)
{
    const auto texels = pictureOf(level, 6, face);
    Image picture(level.width, level.width, 3);
    std::copy(texels.begin(), texels.end(), picture.texels.begin());
    return png::encode(png::packed(picture, PackedColor::Rgbd));
}

/// A member as a number. @throws FileError
double numberOf(const json& object, const char* key, double otherwise, const ByteSource& source)
{
    const auto found = object.find(key);
    if (found == object.end())
        return otherwise;
    if (!found->is_number())
        source.damaged(std::string("\"") + key + "\" of its description is no number");
    return found->get<double>();
}

std::optional<Polynomial> polynomialOf(const json& manifest, const ByteSource& source)
{
    const auto found = manifest.find("irradiance");
    if (found == manifest.end() || !found->is_object())
        return {};
    Polynomial polynomial{};
    for (size_t i = 0; i < terms.size(); ++i) {
        const auto term = found->find(std::string(terms[i]));
        if (term == found->end() || !term->is_array() || term->size() != 3)
            source.damaged("\"irradiance." + std::string(terms[i]) + "\" of its description is not three numbers");
        for (size_t c = 0; c < 3; ++c) {
            if (!(*term)[c].is_number())
                source.damaged("\"irradiance." + std::string(terms[i]) + "\" of its description is not three numbers");
            polynomial[i][static_cast<int>(c)] = (*term)[c].get<double>();
        }
    }
    return polynomial;
}

/// A picture of the specular part, by where the manifest says it lies after itself.
png::Picture pictureAt(const json& entry, std::string_view images, int size, png::Decoder& decoder, const ByteSource& source)
{
    const double position = entry.is_object() ? numberOf(entry, "position", -1.0, source) : -1.0;
    const double length = entry.is_object() ? numberOf(entry, "length", -1.0, source) : -1.0;
    const auto available = static_cast<double>(images.size());
    if (!(position >= 0.0 && length >= 0.0 && position <= available && length <= available - position))
        source.damaged("a level lies beyond its end");
    png::Picture picture = decoder.decode(images.substr(static_cast<size_t>(position), static_cast<size_t>(length)), 1LL * size * size);
    if (picture.width != size || picture.height != size)
        source.damaged("a face of " + std::to_string(picture.width) + " x " + std::to_string(picture.height) + " texels stands where " +
                       std::to_string(size) + " x " + std::to_string(size) + " belong");
    return picture;
}

json manifestOf(std::string_view text, const ByteSource& source)
{
    json manifest = json::parse(text, nullptr, false);
    if (!manifest.is_object())
        source.damaged("its description is no JSON object");
    if (const auto type = manifest.find("imageType"); type != manifest.end() && *type != "image/png")
        source.unsupported("its levels are not PNG pictures; save the environment with imageType \"image/png\"");
    return manifest;
}

} // namespace

bool hasSignature(std::string_view firstBytes) { return firstBytes.starts_with(signature); }

std::string write(const Environment& environment, const JobControl& job)
{
    Texture texture;
    texture.levels = environment.levels;
    validate(texture);
    const int width = texture.width();
    if (!std::has_single_bit(static_cast<unsigned>(width)) || texture.levels.back().width != 1)
        throw InvalidArgument("a Babylon.js environment needs a face edge that is a power of two and every level down to one texel; this "
                              "one has an edge of " +
                              std::to_string(width) + " and ends at " + std::to_string(texture.levels.back().width));
    const int count = 6 * static_cast<int>(texture.levels.size());
    std::vector<std::string> pictures(static_cast<size_t>(count));
    parallelRows(
        count, job,
        [&](int first, int last) {
            for (int i = first; i < last; ++i)
                pictures[static_cast<size_t>(i)] = facePng(texture.levels[static_cast<size_t>(i / 6)], i % 6);
        },
        1);

    json mipmaps = json::array();
    size_t position = 0;
    for (const std::string& picture : pictures) {
        mipmaps.push_back({{"length", picture.size()}, {"position", position}});
        position += picture.size();
    }
    json manifest{{"version", 2}, {"width", width}, {"imageType", "image/png"}};
    if (environment.irradiance)
        for (size_t i = 0; i < terms.size(); ++i) {
            const glm::dvec3& term = (*environment.irradiance)[i];
            manifest["irradiance"][std::string(terms[i])] = {term.r, term.g, term.b};
        }
    manifest["specular"] = {{"mipmaps", std::move(mipmaps)}, {"lodGenerationScale", environment.lodGenerationScale}};
    std::string bytes(signature);
    bytes += manifest.dump();
    bytes.push_back('\0');
    for (const std::string& picture : pictures)
        bytes += picture;
    return bytes;
}

Environment read(std::string_view bytes, const std::string& name)
{
    ByteSource source(bytes, name);
    source.take(signature.size());
    const size_t end = bytes.substr(0, largestManifest).find('\0', signature.size());
    if (end == std::string_view::npos)
        source.damaged("its description has no end");
    const json manifest = manifestOf(bytes.substr(signature.size(), end - signature.size()), source);
    const double claimed = numberOf(manifest, "width", 0.0, source);
    if (!(claimed >= 1.0 && claimed <= largestWidth && std::has_single_bit(static_cast<unsigned>(claimed))))
        source.damaged("its description claims faces that are no power of two up to " + std::to_string(largestWidth) + " wide");
    const int width = static_cast<int>(claimed);
    checkImageSize(name, width, 6LL * width);
    checkTexelsHeld(name, width, 6LL * width, bytes.size(), 256); // its faces may all lie in one place
    const json specular = manifest.value("specular", json::object());
    const json mipmaps = specular.is_object() ? specular.value("mipmaps", json::array()) : json::array();
    const auto levels = static_cast<size_t>(std::bit_width(static_cast<unsigned>(width)));
    if (!mipmaps.is_array() || mipmaps.size() != 6 * levels)
        source.damaged("its description names " + std::to_string(mipmaps.size()) + " pictures instead of " + std::to_string(6 * levels));

    Environment environment;
    environment.irradiance = polynomialOf(manifest, source);
    environment.lodGenerationScale = numberOf(specular, "lodGenerationScale", 0.8, source);
    const std::string_view images = bytes.substr(end + 1);
    const long long faceTexels = 1LL * width * width;
    png::Decoder decoder(name, {.allTexels = 8 * faceTexels, .largestTexels = faceTexels, .bytes = images.size()}); // 6 + 6/4 + 6/16 ...
    for (size_t level = 0; level < levels; ++level) {
        const int size = width >> level;
        Image image;
        image.width = size;
        image.height = 6 * size;
        for (size_t face = 0; face < 6; ++face) // memory grows with the faces that are there
            for (const Rgba8& texel : pictureAt(mipmaps[6 * level + face], images, size, decoder, source).texels) {
                const glm::vec3 rgb = unpackColor(PackedColor::Rgbd, texel);
                image.texels.insert(image.texels.end(), &rgb.x, &rgb.x + 3);
            }
        environment.levels.push_back(std::move(image));
    }
    return environment;
}

} // namespace mirrorball::babylon_env

#include "core/image/exr_attributes.h"

#include "core/base/error.h"
#include "support/exr_builders.h"
#include "support/temporary_folder.h"

#include <ImfBoxAttribute.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfCompressionAttribute.h>
#include <ImfDeepImageStateAttribute.h>
#include <ImfDoubleAttribute.h>
#include <ImfEnvmapAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfKeyCodeAttribute.h>
#include <ImfLineOrderAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfRationalAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfTileDescriptionAttribute.h>
#include <ImfTimeCodeAttribute.h>
#include <ImfVecAttribute.h>

#include <gmock/gmock.h>

#include <memory>
#include <set>

namespace mirrorball {
namespace {

using testing::HasSubstr;

/// OpenEXR's own types whose values have one size.
template <class... Attributes>
std::set<std::string> namesOf()
{
    return {Attributes::staticTypeName()...};
}

std::string little(std::uint32_t number)
{
    std::string bytes;
    for (int i = 0; i < 4; ++i)
        bytes.push_back(static_cast<char>(number >> (8 * i)));
    return bytes;
}

void check(const std::filesystem::path& path)
{
    OpenedFile file(path);
    exr::checkAttributes(file);
}

/// A picture of one texel with the attribute "a" and behind it, as OpenEXR sorts them, "b".
std::string withAttribute(const std::filesystem::path& path, const Imf::Attribute& attribute)
{
    const auto channels = test::exrChannels(test::smallIntegerImage(1, 1));
    Imf::Header header = test::exrHeader(1, 1, channels, Imf::FLOAT);
    header.insert("a", attribute);
    header.insert("b", Imf::StringAttribute("behind it"));
    test::writeScanlineExr(path, header, channels);
    return test::readBytes(path);
}

TEST(ExrAttributes, OfEveryTypeWithOneSizeTheTableHasThatOfOpenExr)
{
    using namespace Imf;
    std::set<std::string> types;
    for (const exr::FixedSize& type : exr::fixedSizes())
        types.insert(std::string(type.type));
    EXPECT_EQ(types, (namesOf<Box2iAttribute, Box2fAttribute, ChromaticitiesAttribute, CompressionAttribute, DeepImageStateAttribute,
                              DoubleAttribute, EnvmapAttribute, FloatAttribute, IntAttribute, KeyCodeAttribute, LineOrderAttribute,
                              M33dAttribute, M33fAttribute, M44dAttribute, M44fAttribute, RationalAttribute, TileDescriptionAttribute,
                              TimeCodeAttribute, V2dAttribute, V2fAttribute, V2iAttribute, V3dAttribute, V3fAttribute, V3iAttribute>()));

    const Header knowsTypes; // registers them
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder / "a.exr";
    for (const exr::FixedSize& type : exr::fixedSizes()) {
        const std::string name(type.type);
        const std::unique_ptr<Attribute> attribute(Attribute::newAttribute(name.c_str()));
        const std::string bytes = withAttribute(path, *attribute);
        const std::string head = std::string("\0a\0", 3) + name + '\0';
        const size_t size = bytes.find(head) + head.size(), value = size + 4;
        ASSERT_LT(size, bytes.size()) << name;
        EXPECT_EQ(bytes.substr(size, 4), little(static_cast<std::uint32_t>(type.bytes))) << name;
        EXPECT_EQ(bytes.substr(value + static_cast<size_t>(type.bytes), 9), std::string("b\0string\0", 9)) << name;
        EXPECT_NO_THROW(check(path)) << name;

        // OpenEXR reads past a size that is wrong, and so does the check: what lies behind is found by both.
        std::string wrong = bytes;
        wrong.replace(size, 4, little(static_cast<std::uint32_t>(type.bytes) + 3));
        test::writeBytes(path, wrong);
        EXPECT_NO_THROW(check(path)) << name;
        EXPECT_EQ(InputFile(path.c_str()).header().typedAttribute<StringAttribute>("b").value(), "behind it") << name;

        test::writeBytes(path, bytes.substr(0, value + static_cast<size_t>(type.bytes) - 1));
        try {
            check(path);
            ADD_FAILURE() << name << ": a value that is cut was accepted";
        } catch (const FileError& error) {
            EXPECT_THAT(error.what(), HasSubstr("its attribute a claims " + std::to_string(type.bytes) + " bytes, and " +
                                                std::to_string(type.bytes - 1) + " are left"));
        }
    }
}

} // namespace
} // namespace mirrorball

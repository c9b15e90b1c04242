#include "core/shading/conductor.h"

#include "support/shared_data.h"

#include <fstream>
#include <sstream>

using namespace mirrorball;

namespace {

struct Row {
    double wavelength, n, k;
};

// The rows of the "data: |" block of a refractiveindex.info file.
std::vector<Row> readTable(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::vector<Row> rows;
    bool inTable = false;
    for (std::string line; std::getline(file, line);) {
        if (line.find("data: |") != std::string::npos) {
            inTable = true;
            continue;
        }
        std::istringstream words(line);
        Row row{};
        if (inTable && words >> row.wavelength >> row.n >> row.k)
            rows.push_back(row);
    }
    return rows;
}

Row interpolate(const std::vector<Row>& rows, double wavelength)
{
    for (size_t i = 1; i < rows.size(); ++i)
        if (rows[i - 1].wavelength <= wavelength && wavelength <= rows[i].wavelength) {
            const Row &a = rows[i - 1], &b = rows[i];
            const double t = (wavelength - a.wavelength) / (b.wavelength - a.wavelength);
            return {wavelength, a.n + t * (b.n - a.n), a.k + t * (b.k - a.k)};
        }
    return {};
}

void expectMatchesTable(std::string_view metal, const std::filesystem::path& path)
{
    const auto rows = readTable(path);
    ASSERT_FALSE(rows.empty()) << path;
    const auto index = conductorFromName(metal);
    ASSERT_TRUE(index) << metal;
    for (int i = 0; i < 3; ++i) {
        const Row row = interpolate(rows, conductorWavelengths[i]);
        EXPECT_NEAR(index->n[i], row.n, 1e-5) << metal << " channel " << i; // printed to five decimals
        EXPECT_NEAR(index->k[i], row.k, 1e-5) << metal << " channel " << i;
    }
}

} // namespace

TEST(Conductor, ValuesAreThoseOfTheMeasuredTables)
{
    SHARED_DATA_OR_SKIP(folder, "optical");
    expectMatchesTable("silver", folder / "Ag_Johnson.yml");
    expectMatchesTable("gold", folder / "Au_Johnson.yml");
    expectMatchesTable("copper", folder / "Cu_Johnson.yml");
    expectMatchesTable("aluminium", folder / "Al_Rakic.yml");
    expectMatchesTable("chromium", folder / "Cr_Johnson.yml");
    expectMatchesTable("iron", folder / "Fe_Johnson.yml");
}

TEST(Conductor, GoldReflectsRedMoreThanGreenMoreThanBlue)
{
    const auto gold = conductorFromName("gold");
    ASSERT_TRUE(gold);
    const glm::dvec3 f = fresnelConductor(1.0, *gold);
    EXPECT_GT(f.r, 0.9);
    EXPECT_GT(f.r, f.g);
    EXPECT_GT(f.g, f.b);
}

TEST(Conductor, KnowsItsNamesAndNoOthers)
{
    for (const Conductor& metal : conductors())
        EXPECT_EQ(conductorFromName(metal.name), metal.index);
    EXPECT_FALSE(conductorFromName("unobtainium"));
}

#include "program.h"

#include "core/image/image_io.h"
#include "core/report/report_files.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <regex>

/// The page of a report as a reader sees it: opened in a real browser, without a display.
namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::TemporaryFolder;

bool hasChromium() { return std::system("command -v chromium >/dev/null 2>&1") == 0; }

/// What Chromium made of a page: the document after its scripts, what the console said, and every address that the page asked for.
struct Browsed {
    std::string document{};
    std::vector<std::string> console{};
    std::vector<std::string> requests{}; ///< of the page; the browser's own (updates, clock) have no page for their origin
};

Browsed browse(const TemporaryFolder& folder, const std::filesystem::path& page)
{
    const auto path = [&](const char* name) { return "'" + (folder / name).string() + "'"; };
    // No name is resolved, so that nothing can leave the machine, the browser's own requests included.
    const std::string command = "timeout 100 chromium --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking "
                                "--disable-component-update --disable-sync --disable-extensions --host-resolver-rules='MAP * ~NOTFOUND' "
                                "--virtual-time-budget=10000 --window-size=1400,1000 --enable-logging=stderr --v=0 --user-data-dir=" +
                                path("profile") + " --log-net-log=" + path("net.json") + " --dump-dom 'file://" + page.string() + "' >" +
                                path("dom") + " 2>" + path("log");
    Browsed result;
    if (std::system(command.c_str()) != 0)
        return result;
    result.document = test::readBytes(folder / "dom");
    std::ifstream log(folder / "log");
    for (std::string line; std::getline(log, line);)
        if (line.find(":CONSOLE") != std::string::npos)
            result.console.push_back(line);

    std::string text = test::readBytes(folder / "net.json");
    nlohmann::json net = nlohmann::json::parse(text, nullptr, false);
    if (net.is_discarded()) // the browser ended before it closed the list
        net = nlohmann::json::parse(text.substr(0, text.find_last_of('}') + 1) + "]}", nullptr, false);
    if (net.is_discarded())
        return {};
    for (const auto& event : net.at("events"))
        if (event.contains("params") && event["params"].contains("initiator") && event["params"]["initiator"] != "not an origin")
            result.requests.push_back(event["params"].value("url", ""));
    return result;
}

std::string attribute(const std::string& document, const std::string& name)
{
    std::smatch match;
    return std::regex_search(document, match, std::regex(name + "=\"([^\"]*)\"")) ? match[1].str() : "";
}

TEST(ReportPage, DrawsItsPlotsWithoutErrorsAndAsksTheNetworkForNothing)
{
    if (!hasChromium())
        GTEST_SKIP() << "needs chromium";
    const TemporaryFolder folder;
    writeImage(folder / "noise.exr", test::noiseProbe(32, 3).image);
    ASSERT_EQ(mirrorballRuns("report '" + (folder / "noise.exr").string() + "' -o '" + (folder / "out").string() +
                             "' --quick --size 8 --lobes phong:20,diffuse --growth-to 256 --longest 60 --directions 16 --methods "
                             "auto,spectral,direct,reference")
                  .status,
              0);
    // What a reader's eye would do: is there ink on every canvas? The page itself is left as it is, up to this script at its end.
    std::string page = test::readBytes(folder / "out" / "report.html");
    const std::string look =
        "<script>{const plots = [...document.querySelectorAll('.plot canvas')];"
        "const ink = c => c.getContext('2d').getImageData(0, 0, c.width, c.height).data.some(v => v > 0);"
        "document.documentElement.dataset.drawn = plots.filter(c => c.width > 200 && ink(c)).length;"
        "document.documentElement.dataset.pictures = [...document.images].filter(i => i.src.startsWith('data:') ).length;"
        "document.documentElement.dataset.sortable = (() => { const t = document.querySelector('#measurements table');"
        "const cells = () => [...t.querySelectorAll('tbody tr')].map(r => r.cells[3].textContent).join(); const before = cells();"
        "const head = t.querySelectorAll('th button')[3]; head.click(); const up = cells(); head.click(); return up !== cells(); })();"
        "}</script>";
    page.insert(page.rfind("</body>"), look);
    test::writeBytes(folder / "page.html", page);

    const Browsed seen = browse(folder, folder / "page.html");
    ASSERT_FALSE(seen.document.empty()) << test::readBytes(folder / "log");
    EXPECT_EQ(attribute(seen.document, "data-state"), "ready");
    EXPECT_EQ(attribute(seen.document, "data-problems"), "");
    EXPECT_EQ(attribute(seen.document, "data-charts"), "10"); // two cases, two predictions, two of parameterizations, four of growth
    EXPECT_EQ(attribute(seen.document, "data-drawn"), "10");
    EXPECT_GE(std::stoi("0" + attribute(seen.document, "data-pictures")), 5); // the probe, two maps, errors
    EXPECT_EQ(attribute(seen.document, "data-sortable"), "true");
    EXPECT_EQ(seen.console, std::vector<std::string>{});
    EXPECT_EQ(seen.requests, std::vector<std::string>{});
}

TEST(ReportPage, ShowsWhatHoldsWhatDoesNotAndWhatIsRefused)
{
    if (!hasChromium())
        GTEST_SKIP() << "needs chromium";
    Report report;
    report.stability.resize(4);
    for (StabilityRow& row : report.stability)
        row.name = "a lobe exactly on a pole <b>";
    report.stability[0].method = Method::Spectral;
    report.stability[0].promised = true;
    report.stability[1].method = Method::Mip;
    report.stability[1].failures = {"not finite"};
    report.stability[2].method = Method::Sh9;
    report.stability[2].refused = "only diffuse";
    report.stability[3].method = Method::Importance; // promises nothing: what is right about it is what it said of itself
    const TemporaryFolder folder;
    const auto page = writeReport(report, folder / "out").front();
    const Browsed seen = browse(folder, page);
    EXPECT_EQ(attribute(seen.document, "data-state"), "ready");
    EXPECT_EQ(seen.console, std::vector<std::string>{});
    EXPECT_NE(seen.document.find(
                  "a lobe exactly on a pole &lt;b&gt;</td><td class=\"mark good\" title=\"rel_rms 0, energy 1, lowest 0\">\u2713</td>"),
              std::string::npos);
    EXPECT_NE(seen.document.find("<td class=\"mark bad\" title=\"not finite\nrel_rms 0, energy 1, lowest 0\">\u2717</td>"),
              std::string::npos);
    EXPECT_NE(seen.document.find("<td class=\"mark\" title=\"only diffuse\">\u2013</td>"), std::string::npos);
    EXPECT_NE(seen.document.find("<td class=\"mark\" title=\"rel_rms 0, energy 1, lowest 0\">~</td>"), std::string::npos);
}

TEST(ReportPage, ThatTestWouldSeeARequestAndAnError)
{
    if (!hasChromium())
        GTEST_SKIP() << "needs chromium";
    const TemporaryFolder folder;
    test::writeBytes(folder / "page.html",
                     "<html><body><img src=\"http://example.invalid/a.png\"><script>undefinedFunction()</script></body></html>");
    const Browsed seen = browse(folder, folder / "page.html");
    ASSERT_FALSE(seen.document.empty());
    EXPECT_EQ(seen.requests, std::vector<std::string>{"http://example.invalid/a.png"});
    EXPECT_FALSE(seen.console.empty());
}

} // namespace
} // namespace mirrorball

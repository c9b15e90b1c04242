#include "repaired_reader.h"

#include "core/base/error.h"

#include <algorithm>

namespace mirrorball {

namespace {

constexpr std::int64_t mostAhead = std::int64_t{1} << 25; ///< texels that are held to find a value

bool isDead(DeadChannels dead, int channel) { return (dead >> channel & 1u) != 0; }

} // namespace

RepairedReader::RepairedReader(std::unique_ptr<ImageReader> reader, NegativePolicy policy) : m_reader(std::move(reader)), m_policy(policy)
{
}

void RepairedReader::readRows(int firstRow, int rows, float* rgb)
{
    const size_t rowFloats = 3 * static_cast<size_t>(info().width);
    std::vector<DeadChannels> dead;
    DeadChannels any = 0;
    for (; !m_ahead.empty() && dead.size() < static_cast<size_t>(rows); m_ahead.pop_front()) {
        std::copy(m_ahead.front().rgb.begin(), m_ahead.front().rgb.end(), rgb + dead.size() * rowFloats);
        dead.push_back(m_ahead.front().dead);
        any |= dead.back();
    }
    if (const int held = static_cast<int>(dead.size()); held < rows) {
        m_reader->readRows(firstRow + held, rows - held, rgb + dead.size() * rowFloats);
        m_nextRow = firstRow + rows;
        for (int y = held; y < rows; ++y) {
            dead.push_back(repairRow(rgb + static_cast<size_t>(y) * rowFloats, info().width, 3, m_policy, m_report));
            any |= dead.back();
        }
    }
    for (int channel = 0; channel < 3; ++channel) {
        if (isDead(any, channel))
            fill(firstRow, rows, rgb, dead, channel);
        for (int y = rows - 1; y >= 0; --y)
            if (!isDead(dead[static_cast<size_t>(y)], channel)) {
                Above& above = m_above[static_cast<size_t>(channel)];
                above.row = firstRow + y;
                above.values.resize(static_cast<size_t>(info().width));
                for (size_t x = 0; x < above.values.size(); ++x)
                    above.values[x] = rgb[static_cast<size_t>(y) * rowFloats + 3 * x + static_cast<size_t>(channel)];
                break;
            }
    }
    if (firstRow + rows == info().height && std::all_of(m_above.begin(), m_above.end(), [](const Above& a) { return a.row < 0; }))
        throw FileError(info().path.string(), "it holds no finite value, only NaN and infinities; export it again");
}

void RepairedReader::fill(int firstRow, int rows, float* rgb, const std::vector<DeadChannels>& dead, int channel)
{
    const auto width = static_cast<size_t>(info().width), c = static_cast<size_t>(channel);
    const auto at = [&](int y, size_t x) { return rgb + (static_cast<size_t>(y) * width + x) * 3 + c; };
    const auto deadAt = [&](int y) { return isDead(dead[static_cast<size_t>(y)], channel); };
    int above = -1; // of these rows
    for (int y = 0; y < rows; ++y) {
        if (!deadAt(y)) {
            above = y;
            continue;
        }
        int below = y, belowRow = info().height;
        while (below < rows && deadAt(below))
            ++below;
        const Row* ahead = nullptr;
        if (below < rows)
            belowRow = firstRow + below;
        else
            ahead = findAhead(firstRow + rows, channel, belowRow);
        const Above& kept = m_above[c];
        const int aboveRow = above >= 0 ? firstRow + above : kept.row;
        for (; y < below; ++y)
            for (size_t x = 0; x < width; ++x)
                *at(y, x) = betweenRows(above >= 0      ? at(above, x)
                                        : kept.row >= 0 ? &kept.values[x]
                                                        : nullptr,
                                        below < rows ? at(below, x)
                                        : ahead      ? &ahead->rgb[3 * x + c]
                                                     : nullptr,
                                        firstRow + y - aboveRow, belowRow - (firstRow + y));
        --y;
    }
}

const RepairedReader::Row* RepairedReader::findAhead(int last, int channel, int& found)
{
    for (size_t i = 0;; ++i) {
        if (i == m_ahead.size()) {
            if (m_nextRow >= info().height)
                return nullptr;
            if (std::int64_t{info().width} * static_cast<std::int64_t>(m_ahead.size()) > mostAhead)
                throw FileError(info().path.string(),
                                "a channel of it has no finite value over " + std::to_string(m_ahead.size()) + " rows; export it again");
            Row row{std::vector<float>(3 * static_cast<size_t>(info().width)), 0};
            m_reader->readRows(m_nextRow++, 1, row.rgb.data());
            row.dead = repairRow(row.rgb.data(), info().width, 3, m_policy, m_report);
            m_ahead.push_back(std::move(row));
        }
        if (!isDead(m_ahead[i].dead, channel)) {
            found = last + static_cast<int>(i);
            return &m_ahead[i];
        }
    }
}

} // namespace mirrorball

#pragma once

#include "image_io.h"
#include "repair.h"

#include <array>
#include <deque>
#include <memory>
#include <vector>

namespace mirrorball {

/// Rows of a picture, mended as repair() mends it whole, to the bit. Where rows have no finite value it reads ahead to the next that has.
/// Throws FileError for a picture without a finite value.
class RepairedReader final : public ImageReader {
public:
    /// @param reader  of three channels
    RepairedReader(std::unique_ptr<ImageReader> reader, NegativePolicy policy);
    const ImageFileInfo& info() const override { return m_reader->info(); }
    /// Rows must be asked for from the first to the last, each once; the first call may begin further down, and what is above then has no
    /// part in mending.
    void readRows(int firstRow, int rows, float* rgb) override;
    /// Of the rows that were read.
    const RepairReport& report() const { return m_report; }

private:
    struct Row {
        std::vector<float> rgb;
        DeadChannels dead;
    };
    /// The last row of a channel that has a value.
    struct Above {
        int row = -1;
        std::vector<float> values{};
    };

    void fill(int firstRow, int rows, float* rgb, const std::vector<DeadChannels>& dead, int channel);
    /// The first row after `last` that has the channel; null after the end.
    const Row* findAhead(int last, int channel, int& found);

    std::unique_ptr<ImageReader> m_reader;
    NegativePolicy m_policy;
    RepairReport m_report{};
    std::deque<Row> m_ahead{}; ///< rows that were read to find values for others
    int m_nextRow = 0;         ///< of the file
    std::array<Above, 3> m_above{};
};

} // namespace mirrorball

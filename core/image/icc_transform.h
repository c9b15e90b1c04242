#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace mirrorball {

/// Colors of an ICC profile as linear Rec.709, through Little CMS, relative colorimetric: white goes to white. In floats throughout, so
/// colors outside Rec.709 come out negative.
class IccTransform {
public:
    /// Null for a profile that is damaged or not for so many channels (1 or 3).
    static std::unique_ptr<IccTransform> open(const std::vector<unsigned char>& profile, int channels);
    ~IccTransform();
    IccTransform(const IccTransform&) = delete;
    IccTransform& operator=(const IccTransform&) = delete;

    /// What the profile is called.
    const std::string& name() const { return m_name; }
    /// In place, three floats a texel; of a gray profile the first is read.
    void toLinear(float* rgb, size_t texels) const;

private:
    IccTransform(void* transform, int channels, std::string name) : m_transform(transform), m_channels(channels), m_name(std::move(name)) {}

    void* m_transform;
    int m_channels;
    std::string m_name;
};

} // namespace mirrorball

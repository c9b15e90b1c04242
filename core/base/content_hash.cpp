#include "content_hash.h"

#include "error.h"

#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <vector>

namespace mirrorball {
namespace {

class Sha256 {
public:
    Sha256() : m_context(EVP_MD_CTX_new(), &EVP_MD_CTX_free)
    {
        if (!m_context || EVP_DigestInit_ex(m_context.get(), EVP_sha256(), nullptr) != 1)
            throw WorkError("SHA-256 is not to be had from this machine's libcrypto; reinstall it");
    }
    void add(const void* bytes, size_t count) { EVP_DigestUpdate(m_context.get(), bytes, count); }
    std::string hex()
    {
        std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
        unsigned length = 0;
        EVP_DigestFinal_ex(m_context.get(), digest.data(), &length);
        constexpr std::string_view digits = "0123456789abcdef";
        std::string text;
        for (unsigned i = 0; i < length; ++i) {
            text += digits[digest[i] >> 4];
            text += digits[digest[i] & 15];
        }
        return text;
    }

private:
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> m_context;
};

} // namespace

std::string contentHash(std::string_view bytes)
{
    Sha256 sum;
    sum.add(bytes.data(), bytes.size());
    return sum.hex();
}

FileContent fileContent(const std::filesystem::path& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) // reading a pipe could block
        throw FileError(path.string(), std::filesystem::exists(path, error) ? "is not a regular file" : "does not exist");
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        throw FileError(path.string(), std::string("cannot be read: ") + std::strerror(errno) + "; check its permissions");
    Sha256 sum;
    FileContent content;
    std::vector<char> block(size_t{1} << 18);
    while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) || stream.gcount() > 0) {
        sum.add(block.data(), static_cast<size_t>(stream.gcount()));
        content.bytes += static_cast<std::uint64_t>(stream.gcount());
    }
    if (stream.bad())
        throw FileError(path.string(), "cannot be read to its end; check the disk");
    content.sha256 = sum.hex();
    return content;
}

} // namespace mirrorball

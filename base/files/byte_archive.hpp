// Values as bytes, exactly: every bit of a number, NaN too, in the byte order of this machine.
//
// For the laboratory's own intermediate work, in which long lists of numbers are most of it; results are JSON, see
// json_members.hpp. Only programs built from the same sources read the bytes again, so there are no versions here.
//
// A type names its parts once, for both ways, in `template <class Archive> void serialize(Archive& archive)`, which
// calls archive(part, ...), or in a function serialize(archive, value).
#pragma once

#include "base/errors/errors.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace poissonlab {

/// Numbers and words of an enum, and arrays of them: their bytes are their value, and lists of them are one block.
template <class T>
struct IsBlock : std::bool_constant<(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) || std::is_enum_v<T>>
{
};
template <class T, std::size_t n>
struct IsBlock<std::array<T, n>> : IsBlock<T>
{
};

template <class T, class Archive>
concept SerializesItself = requires(T& value, Archive& archive)
{
    value.serialize(archive);
};

class ByteWriter
{
public:
    static constexpr bool reads = false;

    template <class... Parts>
    void operator()(const Parts&... parts)
    {
        (put(parts), ...);
    }

    std::string bytes;

private:
    void block(const void* begin, std::size_t size) { bytes.append(static_cast<const char*>(begin), size); }
    void count(std::uint64_t count) { block(&count, sizeof count); }

    template <class T>
    void put(const T& value)
    {
        if constexpr (IsBlock<T>::value)
            block(&value, sizeof value);
        else if constexpr (SerializesItself<T, ByteWriter>)
            const_cast<T&>(value).serialize(*this); // it hands its parts on, which are written
        else
            serialize(*this, const_cast<T&>(value));
    }
    void put(bool value) { bytes += value ? '\1' : '\0'; }
    void put(const std::string& text)
    {
        count(text.size());
        bytes += text;
    }
    template <class T>
    void put(const std::optional<T>& value)
    {
        put(value.has_value());
        if (value) put(*value);
    }
    template <class T, std::size_t n>
    requires(!IsBlock<T>::value) void put(const std::array<T, n>& list)
    {
        for (const T& value : list) put(value);
    }
    template <class T, class Allocator>
    void put(const std::vector<T, Allocator>& list)
    {
        count(list.size());
        if constexpr (IsBlock<T>::value)
            block(list.data(), list.size() * sizeof(T));
        else
            for (const T& value : list) put(value);
    }
};

/// All functions throw InputError where bytes are missing.
class ByteReader
{
public:
    static constexpr bool reads = true;

    explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

    template <class... Parts>
    void operator()(Parts&... parts)
    {
        (get(parts), ...);
    }

    bool is_at_end() const { return rest_.empty(); }

private:
    void block(void* begin, std::size_t size)
    {
        if (size > rest_.size()) throw InputError("stored work ends too early");
        if (size > 0) std::memcpy(begin, rest_.data(), size);
        rest_.remove_prefix(size);
    }

    /// The number of values of a list, which take at least so many bytes each: bytes that say otherwise take no memory.
    std::size_t count(std::size_t bytes_each)
    {
        std::uint64_t count = 0;
        block(&count, sizeof count);
        if (count > rest_.size() / bytes_each) throw InputError("stored work ends too early");
        return static_cast<std::size_t>(count);
    }

    template <class T>
    void get(T& value)
    {
        if constexpr (IsBlock<T>::value)
            block(&value, sizeof value);
        else if constexpr (SerializesItself<T, ByteReader>)
            value.serialize(*this);
        else
            serialize(*this, value);
    }
    void get(bool& value)
    {
        char byte = 0;
        block(&byte, 1);
        value = byte != 0;
    }
    void get(std::string& text)
    {
        text.resize(count(1));
        block(text.data(), text.size());
    }
    template <class T>
    void get(std::optional<T>& value)
    {
        bool is_there = false;
        get(is_there);
        value.reset();
        if (is_there) get(value.emplace());
    }
    template <class T, std::size_t n>
    requires(!IsBlock<T>::value) void get(std::array<T, n>& list)
    {
        for (T& value : list) get(value);
    }
    template <class T, class Allocator>
    void get(std::vector<T, Allocator>& list)
    {
        if constexpr (IsBlock<T>::value) {
            list.resize(count(sizeof(T)));
            block(list.data(), list.size() * sizeof(T));
        } else {
            list.clear();
            for (std::size_t left = count(1); left > 0; --left) get(list.emplace_back());
        }
    }

    std::string_view rest_;
};

/// The bytes of a value.
template <class T>
std::string to_bytes(const T& value)
{
    ByteWriter archive;
    archive(value);
    return std::move(archive.bytes);
}

/// Fills a value from what to_bytes() made of one of its type. Throws InputError where bytes are missing or left over.
template <class T>
void from_bytes(std::string_view bytes, T& value)
{
    ByteReader archive(bytes);
    archive(value);
    if (!archive.is_at_end()) throw InputError("stored work goes on after its end");
}

}

// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_VISIT_H
#define DRILL_RIG_SIM_MATH_VISIT_H

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "drill_rig_sim/math/hash.h"

/// Values that list their own fields.
///
/// A struct has one member, `template <class V> void visit(V& v)`, that calls v(name, field) for every field; structs inside
/// structs have their own. From this one list come the bytes of a value, its equality and its file: nothing can be forgotten in
/// one of them. What is not listed is not part of the value.
namespace drill_rig_sim
{
/// Walks down to the leaves: numbers, truth values, enumerators. `Leaf` is called as leaf(path, number&).
/// Vectors call leaf.size(path, count) first and take the size that it leaves: a reader changes it.
template <class Leaf>
class FieldWalk
{
public:
  explicit FieldWalk(Leaf& leaf) : leaf_(leaf) {}

  template <class T>
  void operator()(const char* name, T& field)
  {
    const std::size_t length = path_.size();
    if (!path_.empty()) path_ += '.';
    path_ += name;
    take(field);
    path_.resize(length);
  }
  /// Entries whose number another field says.
  template <class T>
  void list(const char* name, T* first, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i) (*this)(name, first[i]);
  }

private:
  template <class T>
  void take(T& field)
  {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
      leaf_(path_, field);
    else
      field.visit(*this);
  }
  template <class T, int Rows, int Columns>
  void take(Eigen::Matrix<T, Rows, Columns>& field)
  {
    static_assert(Rows > 0 && Columns > 0, "of fixed size");
    for (Eigen::Index k = 0; k < field.size(); ++k) leaf_(path_, field.data()[k]);
  }
  void take(Eigen::Quaterniond& field)
  {
    for (Eigen::Index k = 0; k < 4; ++k) leaf_(path_, field.coeffs()[k]);
  }
  template <class T, std::size_t N>
  void take(std::array<T, N>& field)
  {
    for (T& entry : field) take(entry);
  }
  template <class T>
  void take(std::vector<T>& field)
  {
    std::size_t count = field.size();
    leaf_.size(path_, count);
    if (count != field.size()) field.resize(count);
    for (T& entry : field) take(entry);
  }

  Leaf& leaf_;
  std::string path_;
};

/// Calls leaf(path, number&) for every number in a value.
template <class T, class Leaf>
void visit_numbers(T& value, Leaf& leaf)
{
  FieldWalk<Leaf> walk(leaf);
  value.visit(walk);
}

/// Names and types of the fields of a value, whatever their values are: what two versions of a program must have in common if one
/// is to read the other's bytes. Of a vector's entries those of one made by default count; of enumerators the size.
class FieldNames
{
public:
  template <class T>
  void operator()(const char* name, T& field)
  {
    const std::size_t length = path_.size();
    path_ += '.';
    path_ += name;
    take(field);
    path_.resize(length);
  }
  template <class T>
  void list(const char* name, T* first, std::size_t count)
  {
    if constexpr (std::is_default_constructible_v<T>)
    {
      T entry{};
      (*this)(name, entry);
    }
    else if (count > 0)
      (*this)(name, *first);
  }
  std::uint64_t hash() const noexcept { return hash_bytes(text_.data(), text_.size()); }

private:
  void write(const std::string& type) { text_ += path_ + ' ' + type + '\n'; }
  template <class T>
  void take(T& field)
  {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
      write((std::is_enum_v<T>             ? "enum"
             : std::is_floating_point_v<T> ? "float"
             : std::is_signed_v<T>         ? "int"
                                           : "unsigned") +
            std::to_string(sizeof(T)));
    else
      field.visit(*this);
  }
  template <class T, int Rows, int Columns>
  void take(Eigen::Matrix<T, Rows, Columns>& field)
  {
    write("matrix" + std::to_string(Rows) + 'x' + std::to_string(Columns));
    take(field.data()[0]);
  }
  void take(Eigen::Quaterniond&) { write("quaternion"); }
  template <class T, std::size_t N>
  void take(std::array<T, N>& field)
  {
    write("array" + std::to_string(N));
    take(field[0]);
  }
  template <class T>
  void take(std::vector<T>&)
  {
    write("vector");
    T entry{};
    take(entry);
  }

  std::string path_, text_;
};

/// The same as a number.
template <class T>
std::uint64_t fields_hash(const T& value)
{
  FieldNames names;
  const_cast<T&>(value).visit(names);  // one list of fields serves readers too; this one only looks
  return names.hash();
}

/// A value as bytes: two values are equal, digit for digit (a NaN equals itself), exactly if their bytes are.
template <class T>
std::vector<unsigned char> to_bytes(const T& value);

/// Reads what to_bytes() of the same struct wrote. False: the bytes end early or late, or hold a vector of more entries than
/// there are bytes left; `value` is then half read, to be thrown away.
template <class T>
bool from_bytes(const std::vector<unsigned char>& bytes, T& value);

namespace detail
{
struct ByteWriter
{
  std::vector<unsigned char>& out;
  template <class N>
  void operator()(const std::string&, N& number)
  {
    const auto* at = reinterpret_cast<const unsigned char*>(&number);
    out.insert(out.end(), at, at + sizeof number);
  }
  void size(const std::string& path, std::size_t& count)
  {
    std::uint64_t written = count;
    (*this)(path, written);
  }
};

struct ByteReader
{
  const std::vector<unsigned char>& in;
  std::size_t at = 0;
  bool good = true;
  template <class N>
  void operator()(const std::string&, N& number)
  {
    good = good && in.size() - at >= sizeof number;
    if (!good) return;
    if constexpr (std::is_same_v<N, bool>)
    {
      good = in[at] <= 1;  // anything else in a bool is undefined
      number = in[at] == 1;
    }
    else
      std::memcpy(&number, in.data() + at, sizeof number);
    at += sizeof number;
  }
  void size(const std::string& path, std::size_t& count)
  {
    std::uint64_t read = 0;
    (*this)(path, read);
    good = good && read <= in.size() - at;
    count = good ? static_cast<std::size_t>(read) : 0;
  }
};
}  // namespace detail

template <class T>
std::vector<unsigned char> to_bytes(const T& value)
{
  std::vector<unsigned char> bytes;
  detail::ByteWriter writer{bytes};
  visit_numbers(const_cast<T&>(value), writer);  // one list of fields serves readers too, so it is not const; this one only looks
  return bytes;
}

template <class T>
bool from_bytes(const std::vector<unsigned char>& bytes, T& value)
{
  detail::ByteReader reader{bytes};
  visit_numbers(value, reader);
  return reader.good && reader.at == bytes.size();
}

}  // namespace drill_rig_sim

#endif

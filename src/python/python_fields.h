// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_PYTHON_PYTHON_FIELDS_H
#define DRILL_RIG_SIM_SRC_PYTHON_PYTHON_FIELDS_H

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>
#include <type_traits>

#include "drill_rig_sim/math/visit.h"

/// Values that list their fields (math/visit.h) as Python sees them: as attributes, and as rows of numpy arrays.
namespace drill_rig_sim
{
namespace detail
{
template <class T>
std::ptrdiff_t offset_in(const T& value, const void* field) noexcept
{
  return static_cast<const char*>(field) - reinterpret_cast<const char*>(&value);
}

/// Adds an attribute for each field.
template <class T>
struct FieldBinder
{
  pybind11::class_<T>& type;
  const T& sample;

  template <class F>
  void operator()(const char* name, F& field)
  {
    const std::ptrdiff_t offset = offset_in(sample, &field);
    const auto at = [offset](const T& self) -> const F&
    { return *reinterpret_cast<const F*>(reinterpret_cast<const char*>(&self) + offset); };
    if constexpr (std::is_enum_v<F>)
      type.def_property_readonly(name, [at](const T& self) { return static_cast<int>(at(self)); });
    else
      type.def_property_readonly(name, at);  // of a struct: a view, which keeps its owner alive
  }
};

/// Lists the numbers of a row.
template <class T>
struct ColumnList
{
  const T& sample;
  pybind11::list names{}, formats{}, offsets{};

  template <class N>
  void operator()(const std::string& path, N& number)
  {
    names.append(path);
    if constexpr (std::is_enum_v<N>)
      formats.append(pybind11::dtype::of<std::underlying_type_t<N>>());
    else
      formats.append(pybind11::dtype::of<N>());
    offsets.append(offset_in(sample, &number));
  }
};
}  // namespace detail

/// Each field of T becomes an attribute of its Python class, read only; enumerators are numbers.
template <class T>
void bind_fields(pybind11::class_<T>& type)
{
  T sample;
  detail::FieldBinder<T> binder{type, sample};
  sample.visit(binder);
}

/// The structured type of an array whose rows are values of T, copied as they lie in memory. A field in a struct is called as its
/// attribute is reached: "winch.brake".
template <class T>
pybind11::dtype dtype_of()
{
  static_assert(std::is_trivially_copyable_v<T>, "rows are copied as bytes");
  T sample;
  detail::ColumnList<T> columns{sample};
  visit_numbers(sample, columns);
  return pybind11::dtype(columns.names, columns.formats, columns.offsets, sizeof(T));
}

}  // namespace drill_rig_sim

#endif

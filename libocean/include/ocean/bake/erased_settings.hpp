// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The settings of a format or of a family of made products, as plans and tables of all formats hold
// them: without their type. Formats never see one, because their functions take settings of their
// own type; see typed_format.hpp and made_product.hpp.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <utility>

namespace ocean {

/// The settings of a format or of a family of made products, as plans and tables hold them: without
/// their type. An immutable value that copies share; a default-constructed one holds nothing.
class ErasedSettings {
  public:
    ErasedSettings() = default;

    template <typename Settings>
    static ErasedSettings of(Settings settings) {
        ErasedSettings erased;
        erased.value_ = std::make_shared<const Settings>(std::move(settings));
        erased.type_ = &typeid(Settings);
        return erased;
    }

    /// Returns the value; it lives as long as this object. Throws std::logic_error unless it was
    /// stored as exactly this type: a format was called with the settings of another one.
    template <typename Settings>
    const Settings& as() const {
        if (*type_ != typeid(Settings)) {
            throw std::logic_error(std::string("settings of type ") + type_->name() +
                                   " were passed to functions for settings of type " +
                                   typeid(Settings).name());
        }
        return *static_cast<const Settings*>(value_.get());
    }

  private:
    std::shared_ptr<const void> value_;
    const std::type_info* type_ = &typeid(void);
};

}  // namespace ocean

//! Controls of the shop: a model that maclint knows, with what is different there.
#pragma once

#include "analyzer/program/tables.hpp"
#include "analyzer/source/made_once.hpp"

#include <memory>
#include <string>
#include <utility>

namespace maclint::cli {

/// Its tables, some 40 kB, are made when somebody asks for them: a configuration may name more controls than
/// there are programs.
class OwnControl {
  public:
    struct Facts {
        Limits limits;
        MachineFunctions functions;
    };

    /// `lathe`: the model where the text is written for one; nullptr: there is none, or nobody wants it.
    OwnControl(std::string name, const ControlModel& model, const ControlModel* lathe, Facts facts)
        : name_(std::move(name))
        , base_(&model)
        , lathe_(lathe)
        , facts_(std::move(facts)) {}

    [[nodiscard]] const ControlModel& model() const;
    /// The one of maclint that it is made from.
    [[nodiscard]] const ControlModel& base() const { return *base_; }

  private:
    [[nodiscard]] ControlModel with_facts(const ControlModel& base) const;

    struct Made {
        ControlModel model;
        std::unique_ptr<const ControlModel> lathe;
    };
    std::string name_;
    const ControlModel* base_;
    const ControlModel* lathe_;
    Facts facts_;
    mutable MadeOnce<Made> made_;
};

} // namespace maclint::cli

//! Controls of the shop: a model that maclint knows, with what is different there.
#pragma once

#include "analyzer/program/tables.hpp"
#include "analyzer/source/made_once.hpp"
#include "cli/config/machine_facts.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace maclint::cli {

/// Its tables, some 40 kB, are made when somebody asks for them: a configuration may name more controls than
/// there are programs.
class OwnControl {
  public:
    struct Facts {
        Limits limits;
        MachineFunctions functions;
        std::optional<bool> block_if = {}; ///< IF … THEN, ELSE, ENDIF as blocks; nothing: as the model
        MachineFacts machine = {};
    };

    /// `lathes`: the models where the text is written for one; empty: there are none, or nobody wants them.
    OwnControl(std::string name, const ControlModel& model, std::vector<const ControlModel*> lathes,
               Facts facts)
        : name_(std::move(name))
        , base_(&model)
        , lathes_(std::move(lathes))
        , facts_(std::move(facts)) {}

    [[nodiscard]] const ControlModel& model() const;
    /// The one of maclint that it is made from.
    [[nodiscard]] const ControlModel& base() const { return *base_; }

  private:
    [[nodiscard]] ControlModel with_facts(const ControlModel& base) const;

    struct Made {
        ControlModel model;
        std::vector<std::unique_ptr<const ControlModel>> lathes;
    };
    std::string name_;
    const ControlModel* base_;
    std::vector<const ControlModel*> lathes_;
    Facts facts_;
    mutable MadeOnce<Made> made_;
};

} // namespace maclint::cli

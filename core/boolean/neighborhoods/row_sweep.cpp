#include "boolean/neighborhoods/row_sweep.h"

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "boolean/neighborhoods/row_order.h"
#include "boolean/neighborhoods/row_pieces.h"
#include "numbers/none.h"
#include "search/bucket_sort.h"
#include "search/circle.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

template <class T>
void make_unique(std::vector<T>& all) {
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

// What happens at the places of a row, by place.
class RowEvents {
 public:
  explicit RowEvents(const Row& row) {
    for (std::uint32_t i = 0; i < row.runs.size(); ++i) {
      all_.push_back({row.runs[i].from, i, Kind::begin});
      all_.push_back({row.runs[i].to, i, Kind::end});
    }
    for (const Row::Meeting& m : row.meetings) all_.push_back({m.place, m.run, Kind::meet});
    first_ = bucket_sort(
        all_, row.places.size(), [](const Event& e) { return e.place; },
        [](const Event& p, const Event& q) {
          return std::tie(p.run, p.kind) < std::tie(q.run, q.kind);
        });
  }

  // Replaces the lists by the runs that begin, end and meet something at a place.
  void look_at(std::uint32_t place) {
    begun.clear();
    ended.clear();
    met.clear();
    for (std::uint32_t i = first_[place]; i < first_[place + 1]; ++i)
      (all_[i].kind == Kind::begin ? begun
       : all_[i].kind == Kind::end ? ended
                                   : met)
          .push_back(all_[i].run);
  }
  std::vector<std::uint32_t> begun, ended, met;

 private:
  enum class Kind : std::uint8_t { begin, end, meet };
  struct Event {
    std::uint32_t place, run;
    Kind kind;
  };
  std::vector<Event> all_;
  std::vector<std::uint32_t> first_;
};

class RowSweep {
 public:
  RowSweep(const Workspace& w, const Contacts& contacts, const Row& row, const Wanted& wanted)
      : w_(w),
        row_(row),
        wanted_(wanted),
        order_(w, contacts, row),
        pieces_(wanted.operations.size()),
        is_present_(row.runs.size()),
        since_(row.runs.size(), none),
        met_at_(row.runs.size(), none),
        cls_(2 * row.runs.size()),
        of_(wanted.operations.size()) {
    for (OfOperation& of : of_) {
      of.is_kept.assign(cls_.size(), 0);
      of.partner.assign(cls_.size(), none);
      of.since.assign(cls_.size(), none);
    }
  }

  void run(Neighborhoods& found) {
    RowEvents events(row_);
    for (std::uint32_t place = 0; place < row_.places.size(); ++place) {
      w_.check_cancelled();
      events.look_at(place);
      visit(place, events);
    }
    pieces_.write(row_, order_, wanted_, found);
  }

 private:
  // For one result: which sides are kept, and with which one each bounds a wedge from where on.
  struct OfOperation {
    Circle kept;
    std::vector<std::uint8_t> is_kept;
    std::vector<RowSide> partner;
    std::vector<std::uint32_t> since;
    // At the place that is visited: of which sides the partner may be another one.
    std::vector<RowSide> looked_at, new_partner;
  };

  void visit(std::uint32_t place, const RowEvents& events) {
    for (const std::uint32_t run : events.met) met_at_[run] = place;
    update_present(events);
    find_changed(events);
    classify();
    for (std::size_t i = 0; i < of_.size(); ++i) find_partners(i, events);
    divide(place, events);
    for (std::size_t i = 0; i < of_.size(); ++i) note_pairs(i, place);
    for (const OfOperation& of : of_) note_cuts(of);
    note_classes();
    for (const std::uint32_t run : events.begun) since_[run] = place;
  }

  void update_present(const RowEvents& events) {
    for (const std::uint32_t run : events.ended) set_present(run, false);
    for (const std::uint32_t run : events.begun) set_present(run, true);
    for (const std::uint32_t run : events.begun) check_neighbours(run);
  }

  void set_present(std::uint32_t run, bool now) {
    is_present_[run] = now ? 1 : 0;
    Circle& present = present_[row_.runs[run].operand];
    for (const RowSide side : {2 * run, 2 * run + 1})
      now ? present.add(order_.position(side)) : present.remove(order_.position(side));
  }

  void check_neighbours(std::uint32_t run) const {
    const Circle& present = present_[row_.runs[run].operand];
    for (const RowSide side : {2 * run, 2 * run + 1})
      if (is_forward(order_.at(present.before(order_.position(side)))) == is_forward(side))
        throw InternalError("the material around a line does not alternate");
  }

  // Sides of which the class may be another one behind this place: of what begins or meets
  // something, and what began, or met something, where nothing of the other operand was. Where that
  // begins, each edge bounds its own wedge again.
  void find_changed(const RowEvents& events) {
    changed_.clear();
    const auto add = [&](const std::vector<std::uint32_t>& runs) {
      for (const std::uint32_t run : runs) changed_.insert(changed_.end(), {2 * run, 2 * run + 1});
    };
    for (const auto* runs : {&events.begun, &events.ended, &events.met}) add(*runs);
    for (const Operand s : both_operands) {
      const bool is_alone = present_[other(s)].empty();
      if (!is_alone) add(std::exchange(waiting_[s], {}));
      if (is_alone && !was_alone_[s]) add({elsewhere_[s].begin(), elsewhere_[s].end()});
      was_alone_[s] = is_alone;
    }
    make_unique(changed_);
  }

  // Right before a position. Material lies behind what is not forward.
  bool is_in(Operand s, std::uint32_t position) const {
    return !is_forward(order_.at(present_[s].before(position)));
  }

  void classify() {
    new_cls_.clear();
    for (const RowSide side : changed_) {
      const bool present = is_present_[side / 2] != 0;
      new_cls_.push_back(present ? class_of(side) : std::nullopt);
      if (present && !new_cls_.back() && is_forward(side))
        waiting_[operand(side)].push_back(side / 2);
      for (std::size_t i = 0; i < of_.size(); ++i)
        set_kept(of_[i], side,
                 new_cls_.back() && kept(wanted_.operations[i], operand(side), *new_cls_.back()));
    }
  }

  // None beside which nothing of the other operand is: the line may lie in it, or outside.
  std::optional<Class> class_of(RowSide side) const {
    const Circle& across = present_[other(operand(side))];
    if (across.empty()) return {};
    const std::uint32_t position = order_.position(side), first = order_.first(position);
    std::uint32_t tied = none;
    across.for_each_in(first, order_.behind(position), [&](std::uint32_t at) { tied = at; });
    if (tied != none)
      return is_forward(order_.at(tied)) == is_forward(side) ? Class::on_plus : Class::on_minus;
    return is_in(other(operand(side)), first) ? Class::in : Class::out;
  }

  void set_kept(OfOperation& of, RowSide side, bool now) const {
    if ((of.is_kept[side] != 0) == now) return;
    of.is_kept[side] = now ? 1 : 0;
    now ? of.kept.add(order_.position(side)) : of.kept.remove(order_.position(side));
  }

  bool starts_material(std::size_t i, RowSide side) const {
    return (is_forward(side) == reversed(wanted_.operations[i], operand(side))) !=
           wanted_.of_complement;
  }

  void find_partners(std::size_t i, const RowEvents& events) {
    OfOperation& of = of_[i];
    of.looked_at = changed_;
    if (!of.kept.empty())
      for (const RowSide side : changed_) {
        of.looked_at.push_back(order_.at(of.kept.before(order_.position(side))));
        of.looked_at.push_back(order_.at(of.kept.behind(order_.position(side))));
      }
    for (const std::uint32_t run : events.met)
      for (const RowSide side : {2 * run, 2 * run + 1})
        if (of.partner[side] != none) of.looked_at.push_back(of.partner[side]);
    make_unique(of.looked_at);
    of.new_partner.clear();
    for (const RowSide side : of.looked_at) of.new_partner.push_back(partner(i, side));
  }

  RowSide partner(std::size_t i, RowSide side) const {
    const OfOperation& of = of_[i];
    if (of.is_kept[side] == 0) return none;
    const std::uint32_t position = order_.position(side);
    const bool starts = starts_material(i, side);
    const RowSide found = order_.at(starts ? of.kept.behind(position) : of.kept.before(position));
    if (starts_material(i, found) == starts)
      throw InternalError("the result's material around a line does not alternate");
    return found;
  }

  // Does the wedge that a side bounded end here? `k`: in looked_at.
  bool parts(const OfOperation& of, std::size_t k, std::uint32_t place) const {
    const RowSide side = of.looked_at[k], before = of.partner[side];
    return of.new_partner[k] != before || met_at_[side / 2] == place ||
           (before != none && met_at_[before / 2] == place);
  }

  // Ends the pieces of all edges of which a side changes, while it is known how they were.
  void divide(std::uint32_t place, const RowEvents& events) {
    for (const auto* runs : {&events.ended, &events.met})
      for (const std::uint32_t run : *runs) end_piece(run, place);
    for (std::size_t k = 0; k < changed_.size(); ++k)
      if (new_cls_[k] != cls_[changed_[k]]) end_piece(changed_[k] / 2, place);
    for (const OfOperation& of : of_)
      for (std::size_t k = 0; k < of.looked_at.size(); ++k)
        if (parts(of, k, place)) end_piece(of.looked_at[k] / 2, place);
    for (const std::uint32_t run : events.ended) since_[run] = none;
  }

  void end_piece(std::uint32_t run, std::uint32_t place) {
    if (since_[run] == none || since_[run] == place) return;
    if (const auto& left = cls_[2 * run], &right = cls_[2 * run + 1]; left && right)
      pieces_.add({run, since_[run], place, {*left, *right}, is_cut(run)});
    since_[run] = place;
  }

  // Do its sides bound wedges with others, or have they different classes, if that is what is
  // asked?
  bool is_cut(std::uint32_t run) const {
    if (of_.empty()) return cls_[2 * run] != cls_[2 * run + 1];
    const auto ends_elsewhere = [](const OfOperation& of, RowSide side) {
      return of.partner[side] != none && of.partner[side] != beyond_edge(side);
    };
    return std::ranges::any_of(of_, [&](const OfOperation& of) {
      return ends_elsewhere(of, 2 * run) || ends_elsewhere(of, 2 * run + 1);
    });
  }

  void note_pairs(std::size_t i, std::uint32_t place) {
    OfOperation& of = of_[i];
    for (std::size_t k = 0; k < of.looked_at.size(); ++k) {
      const RowSide side = of.looked_at[k];
      if (!parts(of, k, place)) continue;
      if (of.partner[side] != none && starts_material(i, side))
        pieces_.add(i, {side, of.partner[side], of.since[side], place});
    }
    for (std::size_t k = 0; k < of.looked_at.size(); ++k) {
      const RowSide side = of.looked_at[k];
      if (!parts(of, k, place)) continue;
      of.partner[side] = of.new_partner[k];
      of.since[side] = place;
    }
  }

  void note_cuts(const OfOperation& of) {
    for (const RowSide side : of.looked_at) {
      std::set<std::uint32_t>& runs = elsewhere_[operand(side)];
      is_cut(side / 2) ? void(runs.insert(side / 2)) : void(runs.erase(side / 2));
    }
  }

  void note_classes() {
    for (std::size_t k = 0; k < changed_.size(); ++k) cls_[changed_[k]] = new_cls_[k];
  }

  Operand operand(RowSide side) const { return row_.runs[side / 2].operand; }

  const Workspace& w_;
  const Row& row_;
  const Wanted& wanted_;
  const RowOrder order_;
  RowPieces pieces_;
  PerOperand<Circle> present_;
  std::vector<std::uint8_t> is_present_;   // per run
  std::vector<std::uint32_t> since_;       // per run that is present: where its last piece begins
  std::vector<std::uint32_t> met_at_;      // per run: the last place where it met something
  std::vector<std::optional<Class>> cls_;  // per side
  std::vector<OfOperation> of_;
  // Runs that are present without classes, until something of the other operand is beside them.
  PerOperand<std::vector<std::uint32_t>> waiting_;
  PerOperand<bool> was_alone_{true, true};         // was nothing of the other operand there?
  PerOperand<std::set<std::uint32_t>> elsewhere_;  // runs that are cut
  // At the place that is visited: sides of which the class may be another one, and their classes.
  std::vector<RowSide> changed_;
  std::vector<std::optional<Class>> new_cls_;
};

}  // namespace

void add_row(const Workspace& w, const Contacts& contacts, const Row& row, const Wanted& wanted,
             Neighborhoods& found) {
  RowSweep(w, contacts, row, wanted).run(found);
}

}  // namespace sectile

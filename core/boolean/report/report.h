// Turns the phases' records into trace events. Called only if somebody observes.
#pragma once

#include "boolean/components/components.h"
#include "sectile/trace.h"

namespace sectile {

void report_reduction(const Workspace& w, const Contacts& contacts);
void report_neighborhoods(const Workspace& w, const Contacts& contacts,
                          const Neighborhoods& neighborhoods, Operation operation);
void report_null_edges(const Workspace& w, const Contacts& contacts,
                       const Neighborhoods& neighborhoods, const Cuts& cuts);
void report_joining(const Workspace& w, const Contacts& contacts,
                    const Neighborhoods& neighborhoods, const JoinedCuts& joined);
void report_components(const Workspace& w, const FaceLabels& kept, Operation operation);
void report_gluing(const Workspace& w, const Contacts& contacts, const Neighborhoods& neighborhoods,
                   const std::vector<WedgePair>& wedges);
void report_cleanup(const Workspace& w, const Solid& result);

}  // namespace sectile

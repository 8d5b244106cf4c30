// Turns the phases' records into trace events. Called only if somebody observes.
#pragma once

#include "boolean/components.h"
#include "sectile/trace.h"

namespace sectile {

void report_reduction(const Workspace& w);
void report_neighborhoods(const Workspace& w, Operation operation);
void report_null_edges(const Workspace& w);
void report_joining(const Workspace& w);
void report_components(const Workspace& w, const FaceLabels& kept, Operation operation);
void report_gluing(const Workspace& w, const std::vector<WedgePair>& wedges);
void report_cleanup(const Workspace& w, const Solid& result);

}  // namespace sectile

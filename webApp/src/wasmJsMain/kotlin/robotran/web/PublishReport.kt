@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web

import robotran.ui.workshop.Workshop

/** Lets the page that holds the workshop ask how its run stands: `robotran.report()` gives the report as JSON. */
internal fun publishReport(workshop: Workshop) = publish { workshop.report().toJson() }

private fun publish(report: () -> String): Unit = js("{ globalThis.robotran = { report }; }")

package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.rcxrom.log.RomLogEntry
import robotran.rcxrom.log.RomLogFilter
import robotran.rcxrom.program.RuntimeWarning
import robotran.rcxrom.program.ThreadView
import robotran.runcontrol.ChartLane
import robotran.runcontrol.ChartLine
import robotran.runcontrol.ShownScope
import robotran.simulation.explain.DeviationCause

/** What the drawer under the world can show of the run. */
enum class DrawerTab { VARIABLES, LOG, CHART, GOALS, WHY }

/**
 * The drawer with what can be known of the run; only what is [open] is kept up to date.
 *
 * @property tab null while it is closed.
 * @property beside what is to be seen next to it, where there is room for two; null if nothing is.
 */
@Immutable
data class DrawerState(
    val tab: DrawerTab? = null,
    val beside: DrawerTab? = null,
    val variables: VariablesState = VariablesState(),
    val log: LogState = LogState(),
    val chart: ChartState = ChartState(),
    val why: WhyState = WhyState(),
) {
    /** What is to be seen. */
    val open: Set<DrawerTab> get() = if (tab == null) emptySet() else setOfNotNull(tab, beside)

    /** With [chosen] in the first place. What was beside and is chosen now changes places with what was there. */
    fun choosing(chosen: DrawerTab?): DrawerState =
        copy(tab = chosen, beside = if (chosen != null && chosen == beside) tab else beside)

    /** With [chosen] in the second place; null to show the first alone. */
    fun choosingBeside(chosen: DrawerTab?): DrawerState {
        val first = if (chosen != null && chosen == tab) beside ?: tab else tab
        return copy(tab = first, beside = chosen.takeIf { it != first })
    }

    /** With [lane] of the chart to be seen or, if it was, not. */
    fun switching(lane: ChartLane): DrawerState =
        copy(chart = chart.copy(hidden = if (lane in chart.hidden) chart.hidden - lane else chart.hidden + lane))
}

/**
 * What the running program is in the middle of.
 *
 * @property threads none if no program runs that can be looked into.
 * @property thread the number of the one that is looked into.
 * @property frame the place in its call stack that is looked into, 0 for the innermost.
 * @property scopes the variables known there.
 */
@Immutable
data class VariablesState(
    val threads: List<ThreadView> = emptyList(),
    val thread: Int = 0,
    val frame: Int = 0,
    val scopes: List<ShownScope> = emptyList(),
)

/**
 * The ROM calls up to now.
 *
 * @property entries those that [filter] lets through, the oldest first.
 * @property total how many there have been.
 * @property isComplete whether all of them were looked at yet.
 */
@Immutable
data class LogState(
    val entries: List<RomLogEntry> = emptyList(),
    val filter: RomLogFilter = RomLogFilter(),
    val total: Long = 0,
    val isComplete: Boolean = true,
)

/**
 * Sensors and motors over time.
 *
 * @property hidden what is not to be seen.
 */
@Immutable
data class ChartState(val lines: List<ChartLine> = emptyList(), val hidden: Set<ChartLane> = emptySet())

/** What made the robots stray so far, and what there is to learn from the run. */
@Immutable
data class WhyState(
    val influences: List<DeviationCause> = emptyList(),
    val remarks: List<RuntimeWarning> = emptyList(),
)

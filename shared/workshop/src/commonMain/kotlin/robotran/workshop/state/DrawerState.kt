package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.brick.kind.BrickKind
import robotran.brick.log.CallLogFilter
import robotran.brick.log.LoggedCall
import robotran.brick.program.RuntimeWarning
import robotran.brick.program.ThreadView
import robotran.legofirmware.device.DatalogEntry
import robotran.runcontrol.ChartLane
import robotran.runcontrol.ChartLine
import robotran.runcontrol.ShownScope
import robotran.simulation.explain.DeviationCause

/** The tabs of the drawer below the world. */
enum class DrawerTab { VARIABLES, LOG, CHART, GOALS, WHY }

/**
 * The state of the drawer; only [open] tabs are updated.
 *
 * @property tab null while it is closed.
 * @property beside the tab shown next to it, on wide screens; null for none.
 */
@Immutable
data class DrawerState(
    val log: LogState,
    val tab: DrawerTab? = null,
    val beside: DrawerTab? = null,
    val variables: VariablesState = VariablesState(),
    val chart: ChartState = ChartState(),
    val why: WhyState = WhyState(),
) {
    /** The visible tabs. */
    val open: Set<DrawerTab> get() = if (tab == null) emptySet() else setOfNotNull(tab, beside)

    /** Shows [chosen] as the first tab. If it is the second tab, swaps the two. */
    fun choosing(chosen: DrawerTab?): DrawerState =
        copy(tab = chosen, beside = if (chosen != null && chosen == beside) tab else beside)

    /** Shows [chosen] as the second tab; null shows the first tab alone. */
    fun choosingBeside(chosen: DrawerTab?): DrawerState {
        val first = if (chosen != null && chosen == tab) beside ?: tab else tab
        return copy(tab = first, beside = chosen.takeIf { it != first })
    }

    /** Shows or hides [lane] of the chart. */
    fun switching(lane: ChartLane): DrawerState =
        copy(chart = chart.copy(hidden = if (lane in chart.hidden) chart.hidden - lane else chart.hidden + lane))
}

/**
 * The state of the running program.
 *
 * @property threads empty if no program runs or it has no debug information.
 * @property thread the index of the selected thread.
 * @property frame the index of the selected frame in its call stack, 0 for the innermost.
 * @property scopes the variables of that frame; once a program of LEGO's firmware has ended, those that the brick keeps.
 * @property hasTasks whether the threads are called tasks, as those of LEGO's firmware are.
 * @property datalog what programs have written to the datalog of LEGO's firmware.
 * @property variableNames the names of the brick's variables in it, by number.
 */
@Immutable
data class VariablesState(
    val threads: List<ThreadView> = emptyList(),
    val thread: Int = 0,
    val frame: Int = 0,
    val scopes: List<ShownScope> = emptyList(),
    val hasTasks: Boolean = false,
    val datalog: List<DatalogEntry> = emptyList(),
    val variableNames: Map<Int, String> = emptyMap(),
)

/**
 * The calls of a brick so far.
 *
 * @property entries those that match [filter], oldest first.
 * @property total the number of all calls.
 * @property isComplete whether all of them were filtered.
 * @property kind the brick whose calls these are.
 */
@Immutable
data class LogState(
    val kind: BrickKind,
    val entries: List<LoggedCall> = emptyList(),
    val filter: CallLogFilter = CallLogFilter(),
    val total: Long = 0,
    val isComplete: Boolean = true,
)

/**
 * Sensors and motors over time.
 *
 * @property hidden the lanes that are not shown.
 */
@Immutable
data class ChartState(val lines: List<ChartLine> = emptyList(), val hidden: Set<ChartLane> = emptySet())

/** Why the robots deviated from their ideal paths so far, and advice on the run. */
@Immutable
data class WhyState(
    val deviationCauses: List<DeviationCause> = emptyList(),
    val warnings: List<RuntimeWarning> = emptyList(),
)

package robotran.workshop.run

import robotran.brick.kind.BrickKind
import robotran.brick.log.CallLogFilter
import robotran.brick.program.CallFrame
import robotran.legofirmware.run.FirmwareState
import robotran.runcontrol.ChartLane
import robotran.runcontrol.FilteredRomCalls
import robotran.runcontrol.PlaybackState
import robotran.runcontrol.RunPlayer
import robotran.runcontrol.ShownScope
import robotran.runcontrol.ShownVariable
import robotran.runcontrol.VariableWatch
import robotran.simulation.StopReason
import robotran.workshop.state.DrawerState
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.LogState
import robotran.workshop.state.VariablesState
import robotran.workshop.state.WhyState

/** Updates the open tabs of the drawer from a run. */
internal class DrawerUpdater {
    val variables = VariableWatch()
    private var calls = FilteredRomCalls(CallLogFilter())

    /** The number of the selected thread and the index of a frame in its call stack; null for the current position. */
    private var chosen: Pair<Int, Int>? = null
    private var isStepping = false

    /** Whether there is more to read while time is paused. */
    val isBusy: Boolean get() = !calls.isComplete

    fun filter(filter: CallLogFilter) {
        calls = FilteredRomCalls(filter)
    }

    fun choose(thread: Int, frame: Int) {
        chosen = thread to frame
    }

    /** The selected thread, which steps. */
    val chosenThread: Int? get() = chosen?.first

    /** Called when the program continues, which invalidates the selection; a step keeps its thread. */
    fun willResume(isStep: Boolean) {
        chosen = chosen?.takeIf { isStep }?.copy(second = 0)
        isStepping = isStep
    }

    /** Called when a new run starts. */
    fun startNewRun() {
        chosen = null
        isStepping = false
        variables.forget()
    }

    /** The selected frame of the program of [player]; null if none is, or no longer. */
    fun chosenFrame(player: RunPlayer): CallFrame? {
        val (thread, frame) = chosen ?: return null
        val threads = player.session.threads
        val callStack = threads.find { it.number == thread }?.callStack.orEmpty()
        // A breakpoint of another thread is where to look.
        val isElsewhere = isStepping && player.stop is StopReason.Breakpoint &&
            threads.none { it.isCurrent && it.number == thread }
        if (player.playback == PlaybackState.Paused) isStepping = false
        if (callStack.isEmpty() || isElsewhere) chosen = null
        return if (isElsewhere) null else callStack.getOrNull(frame) ?: callStack.firstOrNull()
    }

    /** [drawer] with the current data of [player]. */
    fun fill(drawer: DrawerState, player: RunPlayer): DrawerState =
        drawer.open.fold(drawer) { filled, tab -> fill(filled, tab, player) }

    private fun fill(drawer: DrawerState, tab: DrawerTab, player: RunPlayer): DrawerState = when (tab) {
        // While seeking, the intermediate positions are not shown.
        DrawerTab.VARIABLES -> {
            if (player.playback is PlaybackState.Seeking) {
                drawer
            } else {
                drawer.copy(variables = updateVariables(player))
            }
        }

        DrawerTab.LOG -> drawer.copy(log = updateLog(player))

        DrawerTab.CHART -> {
            val lanes = ChartLane.of(player.session.world.robots[player.watched].description)
            drawer.copy(chart = drawer.chart.copy(lines = lanes.map(player::chart)))
        }

        DrawerTab.WHY -> {
            drawer.copy(why = WhyState(player.session.explain(), player.state.robots[player.watched].warnings))
        }

        DrawerTab.GOALS -> drawer
    }

    private fun updateVariables(player: RunPlayer): VariablesState {
        val threads = player.session.threads
        val firmware = player.session.firmwareState() as? FirmwareState
        val datalog = firmware?.datalog.orEmpty()
        val names = firmware?.variableNames.orEmpty()
        val current = threads.find { it.isCurrent } ?: threads.firstOrNull()
            ?: return VariablesState(
                scopes = firmware?.let(::kept).orEmpty(),
                datalog = datalog,
                variableNames = names,
            )
        val thread = threads.find { it.number == chosen?.first } ?: current
        val frame = chosen?.second?.takeIf { thread.number == chosen?.first && it in thread.callStack.indices } ?: 0
        val scopes = variables.update(player.session, thread.number, frame)
        return VariablesState(threads, thread.number, frame, scopes, firmware != null, datalog, names)
    }

    /** The variables that a brick with LEGO's firmware keeps when a program has ended. */
    private fun kept(firmware: FirmwareState): List<ShownScope> {
        val shown = firmware.variableNames.map { (number, name) ->
            ShownVariable(name, "${firmware.variables[number]}", changed = false)
        }
        return if (shown.isEmpty()) emptyList() else listOf(ShownScope(firmware.program.orEmpty(), shown))
    }

    private fun updateLog(player: RunPlayer): LogState {
        val now = player.romCalls
        return LogState(player.watchedBrick, calls.find(now), calls.filter, now.count, calls.isComplete)
    }
}

/** The brick of the robot whose calls are shown. */
internal val RunPlayer.watchedBrick: BrickKind get() = state.robots[watched].brick.kind

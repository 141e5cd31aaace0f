package robotran.workshop.run

import kotlinx.coroutines.CoroutineScope
import robotran.brick.kind.BrickKind
import robotran.brick.program.CallFrame
import robotran.runcontrol.RunPlayer
import robotran.workshop.event.RunEvent
import robotran.workshop.platform.Platform
import robotran.workshop.service.Notices
import robotran.workshop.service.ScreenNavigator
import robotran.workshop.state.DrawerState
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.LogState
import robotran.workshop.state.Pane

/** Holds the drawer below the world; [programName] is that of the shown program, which names its files. */
internal class DrawerStateHolder(
    platform: Platform,
    scope: CoroutineScope,
    notices: Notices,
    private val navigator: ScreenNavigator,
    brick: BrickKind,
    private val programName: () -> String,
) {
    private val updater = DrawerUpdater()
    private val export = RomLogExport(platform, scope, notices)

    var state = DrawerState(LogState(brick))
        private set

    /** Whether there is more to read while time is paused. */
    val isBusy: Boolean get() = DrawerTab.LOG in state.open && updater.isBusy

    fun handle(event: RunEvent.OfDrawer) {
        when (event) {
            is RunEvent.DrawerChosen -> open(event.tab)
            is RunEvent.DrawerBesideChosen -> state = state.choosingBeside(event.tab)
            is RunEvent.FrameChosen -> updater.choose(event.thread, event.frame)
            is RunEvent.LogFiltered -> updater.filter(event.filter)
            RunEvent.LogCopied -> export.copy(state.log)
            RunEvent.LogSaved -> export.save(state.log, programName())
            RunEvent.DatalogSaved -> saveDatalog()
            is RunEvent.LaneSwitched -> state = state.switching(event.lane)
        }
    }

    /** The thread whose frame is selected; null if none is. */
    val chosenThread: Int? get() = updater.chosenThread

    /** Called before the program of [player] continues, which deselects the frame; a step keeps its thread. */
    fun willResume(player: RunPlayer, isStep: Boolean) {
        updater.variables.willResume(player.session)
        updater.willResume(isStep)
    }

    /** The selected frame of the program of [player]; null if none is, or no longer. */
    fun chosenFrame(player: RunPlayer): CallFrame? = updater.chosenFrame(player)

    /** Called when a new run starts. */
    fun startNewRun() = updater.startNewRun()

    /** Fills the open tabs with the current data of [player]. */
    fun update(player: RunPlayer) {
        state = updater.fill(state, player)
    }

    private fun saveDatalog() = with(state.variables) { export.save(datalog, variableNames, programName()) }

    private fun open(tab: DrawerTab?) {
        state = state.choosing(tab)
        if (tab != null) navigator.show(Pane.WORLD)
    }
}

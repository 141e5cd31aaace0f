package robotran.workshop.run

import robotran.brick.program.CallFrame
import robotran.brick.state.RunState
import robotran.runcontrol.PlaybackState
import robotran.simulation.StopReason
import robotran.workshop.service.ProgramsToRun

/**
 * Keeps together what is watched and which program is shown. The brick, the status and the debugger are those of the
 * robot whose program is shown; where a program stops, its robot and its file are shown, once per stop and selected
 * frame. The pupil may then switch to others.
 */
internal class StopLocation(
    private val run: DebuggedRun,
    private val programs: ProgramsToRun,
    private val drawer: DrawerStateHolder,
) {
    private var seenStop: StopReason? = null
    private var seen: Pair<Long, RunState>? = null
    private var seenFrame: CallFrame? = null

    /** Called when a frame was selected, even the one that is already. */
    fun frameChosen() {
        seen = null
    }

    /** Shows the programs of the robot with the index [robot]. */
    fun choose(robot: Int) {
        run.world.robots.getOrNull(robot)?.let { programs.showRobot(it.name) }
    }

    fun watchShownRobot() {
        val stop = run.player.stop as? StopReason.Breakpoint
        if (stop != null && stop !== seenStop) choose(stop.robot)
        seenStop = stop
        val robot = run.world.robots.indexOfFirst { it.name == programs.shownRobot }
        if (robot < 0 || robot == run.player.watched) return
        run.watch(robot)
        drawer.startNewRun()
    }

    /** @param frame the selected frame; null if none is. */
    fun showFile(frame: CallFrame?) {
        if (run.isChanged) return
        val player = run.player
        val brick = player.state.robots[player.watched].brick
        val now = brick.run
        val stop = when {
            now is RunState.Failed -> 0L to now
            now is RunState.Running && player.playback == PlaybackState.Paused -> player.time to now
            else -> null
        }
        if (stop == seen && frame == seenFrame) return
        seen = stop
        seenFrame = frame
        val file = (now as? RunState.Failed)?.failure?.sourceFile ?: frame?.sourceFile
            ?: (now as? RunState.Running)?.sourceFile
        if (stop != null && file != null) {
            programs.showFile(run.world.robots[player.watched].name, brick.selectedSlot, file)
        }
    }
}

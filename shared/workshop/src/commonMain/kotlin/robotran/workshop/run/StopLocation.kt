package robotran.workshop.run

import robotran.brick.program.CallFrame
import robotran.brick.state.RunState
import robotran.runcontrol.PlaybackState
import robotran.runcontrol.RunPlayer
import robotran.workshop.service.ProgramsToRun

/**
 * Shows the file in which the program of the watched robot has stopped, or that of the selected frame, once per stop
 * and selection. The pupil may then switch to another file.
 */
internal class StopLocation(private val programs: ProgramsToRun) {
    private var seen: Pair<Long, RunState>? = null
    private var seenFrame: CallFrame? = null

    /** Called when a frame was selected, even the one that is already. */
    fun frameChosen() {
        seen = null
    }

    /** @param frame the selected frame; null if none is. */
    fun update(player: RunPlayer, robot: String, frame: CallFrame?) {
        val brick = player.state.robots[player.watched].brick
        val run = brick.run
        val stop = when {
            run is RunState.Failed -> 0L to run
            run is RunState.Running && player.playback == PlaybackState.Paused -> player.time to run
            else -> null
        }
        if (stop == seen && frame == seenFrame) return
        seen = stop
        seenFrame = frame
        val file = (run as? RunState.Failed)?.failure?.sourceFile ?: frame?.sourceFile
            ?: (run as? RunState.Running)?.sourceFile
        if (stop != null && file != null) programs.showFile(robot, brick.selectedSlot, file)
    }
}

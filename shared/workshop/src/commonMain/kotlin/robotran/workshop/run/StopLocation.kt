package robotran.workshop.run

import robotran.brick.state.RunState
import robotran.runcontrol.PlaybackState
import robotran.runcontrol.RunPlayer
import robotran.workshop.programs.ProgramsStateHolder

/**
 * Shows the file in which the program of the watched robot has stopped, once per stop. The pupil may then switch to
 * another file.
 */
internal class StopLocation(private val programs: ProgramsStateHolder) {
    private var seen: Pair<Long, RunState>? = null

    fun update(player: RunPlayer, robot: String) {
        val brick = player.state.robots[player.watched].brick
        val run = brick.run
        val stop = when {
            run is RunState.Failed -> 0L to run
            run is RunState.Running && player.playback == PlaybackState.Paused -> player.time to run
            else -> null
        }
        if (stop == seen) return
        seen = stop
        val file = (run as? RunState.Failed)?.failure?.sourceFile ?: (run as? RunState.Running)?.sourceFile
        if (stop != null && file != null) programs.showFile(robot, brick.selectedSlot, file)
    }
}

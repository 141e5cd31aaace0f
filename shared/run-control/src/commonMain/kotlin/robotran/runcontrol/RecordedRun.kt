package robotran.runcontrol

import robotran.simulation.RecordedInput
import robotran.simulation.state.SessionState
import robotran.world.World

/**
 * A run as it is known at one moment, which can be repeated while the player goes on.
 *
 * @property length the length of its known part, in milliseconds.
 */
class RecordedRun internal constructor(
    private val setup: RunSetup,
    private val inputs: List<RecordedInput>,
    val length: Long,
) {
    val world: World get() = setup.world

    /**
     * Repeats the run from its start: its states every [step] milliseconds, from 0 on, and the last one at [length].
     * Each element is the work of one step.
     */
    fun states(step: Int): Sequence<SessionState> = sequence {
        require(step > 0) { "A step takes at least a millisecond, not $step" }
        val player = RunPlayer(setup, inputs)
        try {
            yield(player.state)
            while (player.time < length) {
                val next = minOf(player.time + step, length)
                while (player.time < next) {
                    // A player pauses where the task is completed or its time is up, but this run went on.
                    if (player.playback == PlaybackState.Paused) player.play()
                    player.pass((next - player.time).toInt())
                }
                yield(player.state)
            }
        } finally {
            player.close()
        }
    }
}

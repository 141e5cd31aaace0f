package robotran.simulation.goal

import robotran.brick.sound.SoundEvent
import robotran.brick.sound.SoundTrack
import robotran.brick.state.Screen

/**
 * A tone of the program or the firmware of the robot with the index [robot].
 *
 * @property milliseconds when it was asked for. An RCX plays a tone only when those before it are over.
 * @property drawn what the program had drawn by then, even if nobody could see it yet; null if that is not known.
 */
internal class ProgramEvent(
    val robot: Int,
    val tone: SoundEvent.Tone,
    val milliseconds: Long = tone.milliseconds,
    val drawn: Screen? = null,
)

/** What programs have done since the last call of [take]. */
internal class ProgramEvents(private val tracks: List<SoundTrack>) {
    private val taken = LongArray(tracks.size)

    /** In the order in which the tones sound. */
    fun take(): List<ProgramEvent> {
        if (tracks.indices.all { tracks[it].total == taken[it] }) return emptyList()
        return tracks.indices.flatMap(::take).sortedBy { it.tone.milliseconds }
    }

    private fun take(robot: Int): List<ProgramEvent> {
        val track = tracks[robot]
        val new = track.since(taken[robot])
        taken[robot] = track.total
        return new.mapIndexedNotNull { index, event ->
            if (event !is SoundEvent.Tone) return@mapIndexedNotNull null
            val request = track.requestOf(track.total - new.size + index)
            ProgramEvent(robot, event, request?.milliseconds ?: event.milliseconds, request?.drawn)
        }
    }
}

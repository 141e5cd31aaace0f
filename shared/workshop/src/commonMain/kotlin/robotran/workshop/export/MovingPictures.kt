package robotran.workshop.export

import robotran.animatedpicture.FrameSource
import robotran.runcontrol.RecordedRun
import robotran.simulation.picture.WorldFrames
import robotran.simulation.state.SessionState
import robotran.workshop.state.ShowSpeed

/** How long a frame of a moving picture is shown: 12.5 frames a second, smooth enough for a robot at its pace. */
internal const val FRAME_MILLISECONDS = 80

/** Pixels of the longer side: a phone shows them all, and a minute is still a small file. */
internal const val MOVING_SIDE = 640

/** The longest moving picture: nobody watches longer ones. */
private const val MAX_SECONDS = 60

/** Each speed is twice as fast as the one before. */
private const val SPEEDS = 4

/** The longest one that is proposed; a pupil may choose a slower one. */
private const val GOOD_SECONDS = 15
private const val MILLISECONDS_PER_SECOND = 1_000L

/** The speeds for a run of [length] milliseconds, the slowest first: the first that fits in a minute, and faster ones. */
internal fun speedsFor(length: Long): List<ShowSpeed> {
    val doubled = generateSequence(1) { it * 2 }.map { ShowSpeed(it, secondsOf(length, it)) }
    val fitting = doubled.dropWhile { it.seconds > MAX_SECONDS }.take(SPEEDS).toList()
    // A moving picture of a second shows nothing any more.
    return fitting.filterIndexed { index, speed -> index == 0 || speed.seconds > 1 }
}

/** The slowest of [speeds] with which nobody loses patience. */
internal fun proposedSpeed(speeds: List<ShowSpeed>): ShowSpeed =
    speeds.firstOrNull { it.seconds <= GOOD_SECONDS } ?: speeds.last()

private fun secondsOf(length: Long, factor: Int): Int {
    val perSecond = factor * MILLISECONDS_PER_SECOND
    return ((length + perSecond - 1) / perSecond).toInt().coerceAtLeast(1)
}

/** The frames of [states], drawn by [frames]. */
internal class RunFrames(private val states: List<SessionState>, private val frames: WorldFrames) : FrameSource {
    override val width: Int get() = frames.width
    override val height: Int get() = frames.height
    override val count: Int get() = states.size
    override val frameMilliseconds: Int get() = FRAME_MILLISECONDS

    override fun draw(index: Int, pixels: IntArray) = frames.draw(states[index], pixels)
}

/** The states that a moving picture of this run shows at [speed]. */
internal fun RecordedRun.statesAt(speed: ShowSpeed): Sequence<SessionState> = states(FRAME_MILLISECONDS * speed.factor)

/** The number of states in [statesAt]. */
internal fun RecordedRun.frameCount(speed: ShowSpeed): Int {
    val step = FRAME_MILLISECONDS * speed.factor
    return ((length + step - 1) / step).toInt() + 1
}

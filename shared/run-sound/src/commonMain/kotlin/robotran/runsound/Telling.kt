package robotran.runsound

import robotran.narration.SheetReader
import robotran.narration.wayAhead
import robotran.simulation.state.SessionState
import robotran.world.Light
import robotran.world.World
import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.length
import robotran.world.geometry.normalHeading
import robotran.world.robot.lineSensor
import kotlin.math.abs

/** Tells now and then how far it is to the next thing ahead, and at once that the robot drives on something else. */
internal class Telling(private val world: World, private val robot: Int) {
    private val sheet = SheetReader(world)
    private val sensor = world.robots[robot].description.lineSensor
    private var ground: Timbre? = null
    private var toldAt: Pose? = null
    private var isDue = false

    fun forget() {
        ground = null
        toldAt = null
        isDue = false
    }

    /** Notes whether it is time to tell. A robot that stands still tells nothing. */
    fun look(state: SessionState) {
        if (state.milliseconds % SoundValues.GROUND_LOOK != 0L) return
        val pose = state.robots[robot].robot.pose
        val now = timbreAt(state)
        val isOnOther = ground != null && ground != now
        ground = now
        val hasMoved = hasMoved(toldAt ?: pose.also { toldAt = it }, pose)
        if (isOnOther || (state.milliseconds % SoundValues.TELLING == 0L && hasMoved)) isDue = true
    }

    /** The tone that is due now; null for none. */
    fun due(state: SessionState): RunTone? {
        if (!isDue) return null
        isDue = false
        toldAt = state.robots[robot].robot.pose
        return tone(state)
    }

    fun tone(state: SessionState): RunTone {
        val ahead = wayAhead(robot, world, state)
        val step = SoundValues.STEPS.indexOfFirst { ahead != null && ahead < it }
        val timbre = timbreAt(state)
        return RunTone(
            state.milliseconds,
            RunSign.AHEAD,
            if (step < 0) SoundValues.PITCHES.last() else SoundValues.PITCHES[step],
            SoundValues.TELLING_LENGTH,
            panOf(world, state.robots[robot].robot.pose),
            timbre,
            timbre.loudness,
        )
    }

    /** Against a wall a robot trembles, which is no news. */
    private fun hasMoved(from: Pose, to: Pose): Boolean = length(to.x - from.x, to.y - from.y) >= SoundValues.MOVED ||
        abs(normalHeading(to.heading - from.heading)) >= SoundValues.TURNED

    /** By what is on the paper below its light sensor: ink, a mark that is darker than paper, or paper. */
    private fun timbreAt(state: SessionState): Timbre {
        val pose = state.robots[robot].robot.pose
        val point = Direction(pose.heading).from(Point(pose.x, pose.y), sensor.x, sensor.y)
        if (sheet.hasInk(state.ink, point)) return Timbre.SQUARE
        val isDark = (sheet.reflectanceAt(point) ?: Light.PAPER) < Light.PAPER - SoundValues.DARKER
        return if (isDark) Timbre.SAWTOOTH else Timbre.SINE
    }
}

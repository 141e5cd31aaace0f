package robotran.runsound

import robotran.simulation.state.SessionState
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
    private val sight = Sight(world, robot)
    private val finder = GroundFinder(world)
    private val sensor = world.robots[robot].description.lineSensor
    private var ground: Ground? = null
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
        val now = groundAt(state)
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
        val ahead = sight.ahead(state)
        val step = SoundValues.STEPS.indexOfFirst { ahead < it }
        val timbre = groundAt(state).timbre
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

    private fun groundAt(state: SessionState): Ground {
        val pose = state.robots[robot].robot.pose
        return finder.at(Direction(pose.heading).from(Point(pose.x, pose.y), sensor.x, sensor.y), state.ink)
    }
}

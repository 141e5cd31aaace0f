package robotran.simulation.goal

import robotran.world.GoalCondition
import kotlin.math.floor

/** Counts the laps of a robot along a line from its positions. */
internal sealed class Laps {
    /** The completed share; 1 or more if the goal is met. */
    abstract val share: Double

    /** The length of the line that is missing, in centimetres; 0 or less if the goal is met. */
    abstract val missing: Double

    /** The robot has reached [at] from elsewhere: the current lap does not count. */
    abstract fun restartAt(at: Double)

    /** The robot has advanced to [at] along the line. */
    abstract fun goOn(at: Double)
}

/** The max distance covered in one direction, despite movements to and fro. */
private class Advance {
    private var lowest = Double.MAX_VALUE
    private var highest = -Double.MAX_VALUE

    /** The max distances upwards and downwards. */
    var up = 0.0
        private set
    var down = 0.0
        private set

    fun goOn(at: Double) {
        lowest = minOf(lowest, at)
        highest = maxOf(highest, at)
        up = maxOf(up, at - lowest)
        down = maxOf(down, highest - at)
    }
}

/** Laps round a closed line, in either direction but always the same. */
internal class Rounds(private val length: Double, goal: GoalCondition.FollowLine) : Laps() {
    private val givenAway = minOf(goal.tolerance, length / MIN_PARTS)
    private val wanted = goal.laps * length - givenAway
    private var earlierRounds = 0.0
    private var advance = Advance()

    override val share: Double get() = done / wanted
    override val missing: Double get() = wanted - done

    private val done: Double get() = earlierRounds * length + maxOf(advance.up, advance.down)

    override fun restartAt(at: Double) {
        earlierRounds += floor((maxOf(advance.up, advance.down) + givenAway) / length)
        advance = Advance()
    }

    override fun goOn(at: Double) = advance.goOn(at)
}

/**
 * Laps from one end of an open line to the other, and back again.
 *
 * @param ahead how far the robot's line sensor is in front of its pen.
 */
internal class EndToEnd(length: Double, private val goal: GoalCondition.FollowLine, ahead: Double) : Laps() {
    /** The robot may start with its pen at the end, and it leaves the line when its sensor passes the other end. */
    private val wanted =
        length - minOf(ahead + goal.tolerance, length / MIN_PARTS) -
            minOf(goal.tolerance, length / MIN_PARTS)
    private var legs = 0
    private var advance = Advance()
    private var mayGoUp = true
    private var mayGoDown = true

    override val share: Double get() = (legs + leg / wanted) / goal.laps
    override val missing: Double get() = (goal.laps - legs) * wanted - leg

    private val leg: Double get() = maxOf(if (mayGoUp) advance.up else 0.0, if (mayGoDown) advance.down else 0.0)

    override fun restartAt(at: Double) {
        advance = Advance()
        mayGoUp = true
        mayGoDown = true
    }

    override fun goOn(at: Double) {
        advance.goOn(at)
        if (leg < wanted) return
        legs++
        mayGoUp = !(mayGoUp && advance.up >= wanted)
        mayGoDown = !mayGoUp
        advance = Advance()
        advance.goOn(at)
    }
}

/** The allowance is at most the length of the line divided by this. */
private const val MIN_PARTS = 4.0

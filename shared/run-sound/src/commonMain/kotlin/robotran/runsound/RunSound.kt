package robotran.runsound

import robotran.brick.state.RunState
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.SessionState
import robotran.world.World
import robotran.world.geometry.Pose

/**
 * Makes tones of a run, so that it can be followed by ear. The same states give the same tones everywhere.
 *
 * One tone sounds at a time. Signs come first, then the distance ahead, then the ticks of the wheels. While the brick of
 * the robot sounds, all others are silent, and signs wait.
 *
 * @param robot the index of the robot that is heard.
 */
class RunSound(private val world: World, private val robot: Int) {
    private val telling = Telling(world, robot)
    private val wheels = Wheels()
    private val waiting = linkedSetOf<RunSign>()
    private var before: SessionState? = null

    /** From when on a sign may sound, and from when on anything else. */
    private var signsFrom = 0L
    private var othersFrom = 0L
    private var bumpsFrom = 0L
    private var bumpPan = 0.0

    /**
     * The tones that begin at the time of [state] or with the sign that does; empty for none. Call it every
     * [LOOK_MILLISECONDS] of virtual time. The first state, and one after a jump in time, is silent.
     */
    fun observe(state: SessionState): List<RunTone> {
        val last = before
        if (last?.milliseconds == state.milliseconds) return emptyList()
        before = state
        if (last == null || state.milliseconds - last.milliseconds !in 1..LOOK_MILLISECONDS) {
            forget(state)
            return emptyList()
        }
        collectSigns(last, state)
        telling.look(state)
        wheels.look(last.robots[robot].robot, state.robots[robot].robot)
        val now = state.milliseconds
        return when {
            state.robots[robot].brick.sounding -> emptyList<RunTone>().also { wheels.forget() }
            waiting.isNotEmpty() && now >= signsFrom -> sign(now)
            now < othersFrom -> emptyList()
            else -> listOfNotNull(distance(state) ?: tick(state))
        }
    }

    private fun sign(now: Long): List<RunTone> {
        val next = waiting.first()
        waiting -= next
        signsFrom = now + next.length
        othersFrom = signsFrom
        return next.from(now, if (next == RunSign.BUMP) bumpPan else 0.0)
    }

    private fun distance(state: SessionState): RunTone? =
        telling.due(state)?.also { othersFrom = state.milliseconds + SoundValues.TELLING_ROOM }

    private fun forget(state: SessionState) {
        waiting.clear()
        telling.forget()
        wheels.forget()
        signsFrom = state.milliseconds
        othersFrom = state.milliseconds
        bumpsFrom = state.milliseconds
    }

    private fun collectSigns(last: SessionState, state: SessionState) {
        val then = last.robots[robot]
        val now = state.robots[robot]
        val hasTouched = now.bumps > then.bumps || now.robot.touching.any { it !in then.robot.touching }
        if (hasTouched) {
            if (state.milliseconds >= bumpsFrom) {
                waiting += RunSign.BUMP
                bumpPan = bumpSide(now)
            }
            bumpsFrom = state.milliseconds + SoundValues.BUMP_PAUSE
        }
        if (state.goals !== last.goals) {
            val changed = state.goals.zip(last.goals).filter { (goal, old) -> goal.status != old.status }
            if (changed.any { it.first.status == GoalStatus.MET }) waiting += RunSign.GOAL
            if (changed.any { it.first.status == GoalStatus.FAILED }) waiting += RunSign.GOAL_LOST
        }
        if (then.brick.run is RunState.Running && now.brick.run !is RunState.Running) waiting += RunSign.END
    }

    private fun tick(state: SessionState): RunTone? =
        wheels.due(state.milliseconds)?.also { othersFrom = state.milliseconds + SoundValues.TICK_ROOM }

    companion object {
        /** The virtual time between two looks at a run. */
        const val LOOK_MILLISECONDS = SoundValues.LOOK

        /**
         * One short sound of the moment [state] of a run: a bump if the robot touches something, otherwise the distance
         * ahead. Null while its brick sounds.
         */
        fun ofMoment(world: World, robot: Int, state: SessionState): RunTone? {
            val now = state.robots[robot]
            return when {
                now.brick.sounding -> null
                isTouching(now) -> RunSign.BUMP.from(state.milliseconds, bumpSide(now)).first()
                else -> Telling(world, robot).tone(state)
            }
        }
    }
}

private fun isTouching(robot: RobotSnapshot) = robot.robot.touching.isNotEmpty() || robot.robot.pressed.isNotEmpty()

/** The ear of the bumper that is pressed; the middle for both and for none. */
private fun bumpSide(robot: RobotSnapshot): Double = with(robot.robot) {
    if (leftBumperPressed == rightBumperPressed) {
        0.0
    } else if (leftBumperPressed) {
        -1.0
    } else {
        1.0
    }
}

/** Where [pose] is on the sheet from left to right, -1 to 1. */
internal fun panOf(world: World, pose: Pose): Double = (2 * pose.x / world.paper.width - 1).coerceIn(-1.0, 1.0)

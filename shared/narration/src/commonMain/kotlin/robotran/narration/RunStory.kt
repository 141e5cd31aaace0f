package robotran.narration

import robotran.brick.state.RunState
import robotran.language.Language
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.SessionState
import robotran.world.TouchKind
import robotran.world.World

/**
 * What happened in a run, as far as it is told; immutable and small, however long the run.
 *
 * @property robots in the world's order.
 */
class RunStory internal constructor(
    internal val robots: List<RobotStory>,
    internal val arrivals: List<Arrival>,
    internal val inkCentimetres: Double,
    internal val goals: List<GoalProgress>,
    internal val end: ProgramEnd,
) {
    /** The story in at most [MAX_SENTENCES] sentences. */
    fun sentences(language: Language): List<String> = storySentences(this, language)

    companion object {
        const val MAX_SENTENCES = 8
    }
}

/**
 * What one robot did.
 *
 * @property name null if it is the only one.
 * @property groups null if the run is too long to tell it in parts.
 * @property centimetres the length of its way.
 * @property bumpedAt when it bumped first, and into what, if that is known.
 */
internal class RobotStory(
    val name: String?,
    val groups: List<MoveGroup>?,
    val centimetres: Double,
    val bumps: Int,
    val bumpedAt: Long?,
    val bumpedInto: ThingKind?,
    val sounds: Int,
)

/** That the first robot came to a mark for the first time. */
internal class Arrival(val milliseconds: Long, val ground: Ground)

/** How the program of the first robot ended, or that it runs on. */
internal class ProgramEnd(val run: RunState, val milliseconds: Long)

/**
 * The story of a run.
 *
 * @param states the run at equal intervals, from its start, and bounded in number.
 * @param goals at the end of the run.
 */
fun storyOf(world: World, states: List<SessionState>, goals: List<GoalProgress>): RunStory {
    val last = states.lastOrNull()
    val robots = world.robots.mapIndexed { number, placed ->
        val now = last?.robots?.getOrNull(number)
        val bump = states.firstOrNull { (it.robots.getOrNull(number)?.bumps ?: 0) > 0 }?.robots?.get(number)
        RobotStory(
            placed.name.takeIf { world.robots.size > 1 },
            if (isFine(states)) gathered(movesOf(number, states)) else null,
            last?.trail.orEmpty().filter { it.robot == number }.sumOf { piece ->
                piece.points.zipWithNext { one, next -> apart(one, next) }.sum()
            },
            now?.bumps ?: 0,
            bump?.bumpedAt,
            bump?.robot?.touching?.minOrNull()?.thing,
            soundsOf(number, states),
        )
    }
    return RunStory(robots, arrivals(world, states), last?.ink?.lengthCentimetres ?: 0.0, goals, endOf(states))
}

/** How often a program began to sound; the firmware's own sounds at its start and its end do not count. */
private fun soundsOf(robot: Int, states: List<SessionState>): Int {
    var started = Long.MAX_VALUE
    return states.zipWithNext().count { (before, after) ->
        val was = before.robots.getOrNull(robot)?.brick ?: return@count false
        val now = after.robots.getOrNull(robot)?.brick ?: return@count false
        if (was.run !is RunState.Running) started = after.milliseconds
        val isLate = after.milliseconds - started > FIRMWARE_SOUND_MILLISECONDS
        isLate && now.run is RunState.Running && now.sounding && !was.sounding
    }
}

private fun isFine(states: List<SessionState>): Boolean =
    states.size < 2 || states[1].milliseconds - states[0].milliseconds <= FINE_MILLISECONDS

private fun arrivals(world: World, states: List<SessionState>): List<Arrival> {
    val found = mutableMapOf<Ground, Long>()
    val sheet = SheetReader(world)
    for (state in states.takeIf { world.marks.isNotEmpty() }.orEmpty()) {
        if (found.size >= MAX_ARRIVALS) break
        val pose = state.robots.firstOrNull()?.robot?.pose ?: continue
        val mark = sheet.markAt(pose.point) ?: continue
        if (mark.name != null) found.getOrPut(groundOf(mark)) { state.milliseconds }
    }
    val start = states.firstOrNull()?.milliseconds ?: 0
    return found.filterValues { it > start }.map { (ground, time) -> Arrival(time, ground) }
}

private fun endOf(states: List<SessionState>): ProgramEnd {
    val last = states.lastOrNull() ?: return ProgramEnd(RunState.Idle, 0)
    val run = last.robots.firstOrNull()?.brick?.run ?: RunState.Idle
    val running = states.lastOrNull { it.robots.firstOrNull()?.brick?.run is RunState.Running }
    return ProgramEnd(run, if (run is RunState.Running) last.milliseconds else running?.milliseconds ?: 0)
}

private val TouchKind.thing: ThingKind
    get() = when (this) {
        TouchKind.WALLS -> ThingKind.WALL
        TouchKind.BARRIERS -> ThingKind.BARRIER
        TouchKind.BLOCKS -> ThingKind.BLOCK
        TouchKind.ROBOTS -> ThingKind.ROBOT
    }

/** A turn on the spot takes a few times as long, so it is seen in states that are no further apart. */
private const val FINE_MILLISECONDS = 160L
private const val FIRMWARE_SOUND_MILLISECONDS = 200L
private const val MAX_ARRIVALS = 2

package robotran.narration

import robotran.simulation.state.SessionState
import robotran.world.geometry.Direction
import robotran.world.geometry.Pose
import robotran.world.geometry.normalHeading
import kotlin.math.PI
import kotlin.math.abs

/** What the robot with the index [robot] did, from the states of a run at short intervals, from its first move to its last. */
internal fun movesOf(robot: Int, states: List<SessionState>): List<Move> {
    val parts = mutableListOf<Part>()
    for (number in 1..<states.size) {
        val before = states[number - 1]
        val now = states[number]
        val milliseconds = now.milliseconds - before.milliseconds
        val from = before.robots.getOrNull(robot)?.robot?.pose
        val to = now.robots.getOrNull(robot)?.robot?.pose
        if (milliseconds <= 0 || from == null || to == null) continue
        val next = partOf(from, to, milliseconds)
        val last = parts.lastOrNull()
        if (last != null && last.goesOnWith(next)) last.add(next) else parts += next
    }
    var told: List<Part> = parts
    do {
        val before = told.size
        told = merged(withoutBits(told))
    } while (told.size < before)
    val moves = told.map { it.move() }
    return winding(moves.dropWhile { it is Move.Wait }.dropLastWhile { it is Move.Wait })
}

private enum class PartKind { STILL, DRIVE, TURN, BEND, CARRIED }

/** A time in which a robot did one thing. */
private class Part(val kind: PartKind, var along: Double, var degrees: Double, var milliseconds: Long) {
    /** Too little to be told, or the moment between two moves. */
    val isBit: Boolean
        get() = when (kind) {
            PartKind.STILL -> milliseconds < TOLD_WAIT_MILLISECONDS
            PartKind.DRIVE -> abs(along) < LEAST_LENGTH
            PartKind.TURN -> abs(degrees) < LEAST_ANGLE
            PartKind.BEND -> milliseconds <= BETWEEN_MILLISECONDS && abs(degrees) < BETWEEN_ANGLE
            PartKind.CARRIED -> false
        }

    fun goesOnWith(next: Part): Boolean = kind == next.kind && when (kind) {
        PartKind.STILL, PartKind.CARRIED -> true
        PartKind.DRIVE -> along * next.along >= 0
        PartKind.TURN -> degrees * next.degrees >= 0
        PartKind.BEND -> along * next.along >= 0 && degrees * next.degrees >= 0
    }

    fun add(other: Part) {
        along += other.along
        degrees += other.degrees
        milliseconds += other.milliseconds
    }

    fun move(): Move = when (kind) {
        PartKind.STILL -> Move.Wait(milliseconds)
        PartKind.DRIVE -> if (abs(degrees) < STRAIGHT_ANGLE) Move.Drive(along) else Move.Bend(along, degrees)
        PartKind.TURN -> Move.Turn(degrees)
        PartKind.BEND -> Move.Bend(along, degrees)
        PartKind.CARRIED -> Move.Carried
    }
}

private fun partOf(from: Pose, to: Pose, milliseconds: Long): Part {
    val degrees = normalHeading(to.heading - from.heading)
    val middle = Direction(from.heading + degrees / 2)
    val x = to.x - from.x
    val y = to.y - from.y
    val along = x * middle.cosine + y * middle.sine
    val seconds = milliseconds / MILLISECONDS_PER_SECOND
    val speed = abs(along) / seconds
    val turn = abs(degrees) / seconds
    val kind = when {
        apart(from.point, to.point) > FASTEST * seconds + LEAP || turn > FASTEST_TURN -> PartKind.CARRIED
        speed < SLOWEST && turn < SLOWEST_TURN -> PartKind.STILL
        turn < SLOWEST_TURN || speed > turn * PI / HALF_TURN * WIDEST_BEND -> PartKind.DRIVE
        speed < turn * PI / HALF_TURN * TIGHTEST_BEND -> PartKind.TURN
        else -> PartKind.BEND
    }
    return if (kind ==
        PartKind.CARRIED
    ) {
        Part(kind, 0.0, 0.0, milliseconds)
    } else {
        Part(kind, along, degrees, milliseconds)
    }
}

/** Gives what is too little to be told to the moves beside it: its length to one that drives, its angle to one that turns. */
private fun withoutBits(parts: List<Part>): List<Part> {
    val kept = parts.filter { !it.isBit }
    if (kept.isEmpty()) return kept
    var place = 0
    for (part in parts) {
        if (!part.isBit) {
            place++
            continue
        }
        val beside = listOfNotNull(kept.getOrNull(place - 1), kept.getOrNull(place))
        beside.firstOrNull { it.kind == PartKind.DRIVE || it.kind == PartKind.BEND }?.let { it.along += part.along }
        beside.firstOrNull { it.kind == PartKind.TURN || it.kind == PartKind.BEND }?.let { it.degrees += part.degrees }
    }
    return kept
}

/** Joins what goes on after a bit was taken out between. */
private fun merged(parts: List<Part>): List<Part> = buildList {
    for (part in parts) {
        val last = lastOrNull()
        if (last != null && last.goesOnWith(part)) last.add(part) else add(part)
    }
}

/** Many small moves one after the other, as along a line, are one. */
private fun winding(moves: List<Move>): List<Move> = buildList {
    var small = mutableListOf<Move>()

    fun close() {
        if (small.size >= LEAST_WINDING) add(Move.Winding(small.sumOf { it.way })) else addAll(small)
        small = mutableListOf()
    }
    for (move in moves) {
        if (move.isSmall) {
            small += move
        } else {
            close()
            add(move)
        }
    }
    close()
}

private val Move.isSmall: Boolean
    get() = when (this) {
        is Move.Drive -> abs(along) < SMALL_LENGTH
        is Move.Turn -> abs(degrees) < SMALL_ANGLE
        is Move.Bend -> abs(degrees) < SMALL_ANGLE && abs(along) < SMALL_LENGTH
        is Move.Winding, is Move.Wait, Move.Carried -> false
    }

private const val MILLISECONDS_PER_SECOND = 1000.0

/** In centimetres and degrees a second: no robot is faster, and what is slower is only settling. */
private const val FASTEST = 80.0
private const val FASTEST_TURN = 1_500.0
private const val LEAP = 1.0
private const val SLOWEST = 1.0
private const val SLOWEST_TURN = 6.0

/** The radius in centimetres of a bend; tighter ones are turns on the spot, wider ones straight. */
private const val TIGHTEST_BEND = 3.0
private const val WIDEST_BEND = 150.0

/** What is told of at least. */
private const val TOLD_WAIT_MILLISECONDS = 700L
private const val LEAST_LENGTH = 0.5
private const val LEAST_ANGLE = 2.5
private const val STRAIGHT_ANGLE = 8.0

/** A bend that lasts no longer is where a drive goes over into a turn. */
private const val BETWEEN_MILLISECONDS = 200L
private const val BETWEEN_ANGLE = 15.0

private const val SMALL_LENGTH = 12.0
private const val SMALL_ANGLE = 35.0
private const val LEAST_WINDING = 10

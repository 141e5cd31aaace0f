package robotran.worldediting

import robotran.world.Template
import robotran.world.World
import robotran.world.geometry.Point

/** The lines of the drawing to be traced. */
val World.strokes: List<List<Point>> get() = template?.strokes.orEmpty()

/** How many things of [kind] there are. */
fun World.count(kind: ThingKind): Int = when (kind) {
    ThingKind.MARK -> marks.size
    ThingKind.STROKE -> strokes.size
    ThingKind.GOAL -> allGoals(goals).size
    ThingKind.WALL -> walls.size
    ThingKind.BARRIER -> barriers.size
    ThingKind.BLOCK -> blocks.size
    ThingKind.ROBOT -> robots.size
    ThingKind.LAMP -> lamps.size
}

/** Everything in the world, the lowest first, those of a kind in their own order. */
fun World.things(): List<Thing> = ThingKind.entries.flatMap { kind -> List(count(kind)) { Thing(kind, it) } }

/** What [thing] is like; null if there is no such thing. */
fun World.piece(thing: Thing): Piece? = when (thing.kind) {
    ThingKind.MARK -> marks.getOrNull(thing.number)?.let(Piece::OfMark)
    ThingKind.STROKE -> strokes.getOrNull(thing.number)?.let(Piece::OfStroke)
    ThingKind.GOAL -> allGoals(goals).getOrNull(thing.number)?.let { Piece.OfGoal(it.goal) }
    ThingKind.WALL -> walls.getOrNull(thing.number)?.let(Piece::OfWall)
    ThingKind.BARRIER -> barriers.getOrNull(thing.number)?.let(Piece::OfBarrier)
    ThingKind.BLOCK -> blocks.getOrNull(thing.number)?.let(Piece::OfBlock)
    ThingKind.ROBOT -> robots.getOrNull(thing.number)?.let(Piece::OfRobot)
    ThingKind.LAMP -> lamps.getOrNull(thing.number)?.let(Piece::OfLamp)
}

/** This world with [piece] where [number] of its kind was; the parts of a group of goals stay as they are. */
internal fun World.with(number: Int, piece: Piece): World = when (piece) {
    is Piece.OfRobot -> copy(robots = robots.with(number, piece.robot))
    is Piece.OfWall -> copy(walls = walls.with(number, piece.wall))
    is Piece.OfBarrier -> copy(barriers = barriers.with(number, piece.barrier))
    is Piece.OfBlock -> copy(blocks = blocks.with(number, piece.block))
    is Piece.OfMark -> copy(marks = marks.with(number, piece.mark))
    is Piece.OfLamp -> copy(lamps = lamps.with(number, piece.lamp))
    is Piece.OfStroke -> copy(template = template?.copy(strokes = strokes.with(number, piece.points)))
    is Piece.OfGoal -> copy(goals = goals.changed { place, goal -> if (place == number) piece.goal.withParts(goal.parts) else goal })
}

/** This world with [piece] on top of the others of its kind. */
internal fun World.plus(piece: Piece): World = when (piece) {
    is Piece.OfRobot -> copy(robots = robots + piece.robot)
    is Piece.OfWall -> copy(walls = walls + piece.wall)
    is Piece.OfBarrier -> copy(barriers = barriers + piece.barrier)
    is Piece.OfBlock -> copy(blocks = blocks + piece.block)
    is Piece.OfMark -> copy(marks = marks + piece.mark)
    is Piece.OfLamp -> copy(lamps = lamps + piece.lamp)
    is Piece.OfStroke -> copy(template = (template ?: Template(emptyList())).let { it.copy(strokes = it.strokes + listOf(piece.points)) })
    is Piece.OfGoal -> copy(goals = goals + piece.goal)
}

/** This world without [things]; goals that lie in one of them go with it, and a drawing without lines is none. */
internal fun World.without(things: Set<Thing>): World {
    fun <T> List<T>.without(kind: ThingKind) = filterIndexed { number, _ -> Thing(kind, number) !in things }
    return copy(
        robots = robots.without(ThingKind.ROBOT),
        walls = walls.without(ThingKind.WALL),
        barriers = barriers.without(ThingKind.BARRIER),
        blocks = blocks.without(ThingKind.BLOCK),
        marks = marks.without(ThingKind.MARK),
        lamps = lamps.without(ThingKind.LAMP),
        template = template?.let { it.copy(strokes = it.strokes.without(ThingKind.STROKE)) }?.takeIf { it.strokes.isNotEmpty() },
        goals = goals.changed { number, goal -> goal.takeIf { Thing(ThingKind.GOAL, number) !in things } },
    )
}

/** This list with [item] at [place], if there is such a place. */
internal fun <T> List<T>.with(place: Int, item: T): List<T> = mapIndexed { number, old -> if (number == place) item else old }

package robotran.narration

import robotran.language.Language
import robotran.simulation.state.SessionState
import robotran.world.MarkFigure
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.flat
import kotlin.math.abs

/**
 * What is at [point] of the sheet, in a few short sentences. Where nothing stands, also what is near; and while there
 * is a place to reach for a goal, how to move there. The edge of the sheet is told only where there is no such place.
 */
fun whatIsAt(point: Point, world: World, session: SessionState, language: Language): List<String> {
    val messages = PlaceMessages.of(language)
    val bodies = bodiesOf(world, session)
    val lamps = world.lamps.zip(session.lamps) { lamp, now -> Thing(ThingKind.LAMP, lamp.name) to now.place }
    val things = bodies.filter { it.contains(point) }.map { it.thing } +
        lamps.filter { apart(it.second, point) <= LAMP_RADIUS }.map { it.first }
    val ground = groundAt(world, session, point).map { messages.ground(it.kind, it.name, it.tone) }
    val here = things.take(MAX_THINGS).map { messages.thing(it.kind, it.name) }
    val goal = wantedFrom(point, world, session)
    return buildList {
        // What stands there hides the paper.
        add(messages.spotHas(centimetres(point.x), centimetres(point.y), here.ifEmpty { ground }))
        lampsSeenAt(world, session, point).take(MAX_LAMPS).forEach { add(messages.inLight(world.lamps[it].name)) }
        goal?.takeIf {
            apart(it.point, point) > THERE
        }?.let { add(messages.toGoal(it.number, stepsTo(it.point, point, messages))) }
        if (here.isEmpty()) {
            val things = bodies.map { it.thing to it.outline.nearestEdgePoint(point) } + lamps +
                listOfNotNull((Thing(ThingKind.EDGE) to nearestOnEdge(world, point)).takeIf { goal == null })
            val near = things.map { (thing, place) -> messages.thing(thing.kind, thing.name) to place } +
                marksBeside(point, world, messages)
            val nearest = near.minBy { apart(it.second, point) }
            if (goal == null || apart(nearest.second, point) < NEAR) add(told(nearest, point, messages))
        }
    }
}

private fun told(near: Pair<String, Point>, point: Point, messages: PlaceMessages): String {
    val (words, place) = near
    val direction = sheetDirection(directionOf(place.x - point.x, place.y - point.y))
    val aside = direction.aside.takeIf { direction.degrees > STRAIGHT }
    return messages.nearest(words, centimetres(apart(place, point)), direction.to, aside)
}

/** One step to each side, so that it can be gone with arrow keys; what is hardly anything is left out. */
private fun stepsTo(place: Point, point: Point, messages: PlaceMessages): List<String> {
    val right = place.x - point.x
    val up = place.y - point.y
    return listOf(
        right to if (right > 0) SheetSide.RIGHT else SheetSide.LEFT,
        up to if (up > 0) SheetSide.UP else SheetSide.DOWN,
    ).filter { (length, _) -> abs(length) >= minOf(STEP, maxOf(abs(right), abs(up))) }
        .map { (length, side) -> messages.step(centimetres(abs(length)), side) }
}

/** Lines and areas that do not cover [point], with their nearest points. */
private fun marksBeside(point: Point, world: World, messages: PlaceMessages): List<Pair<String, Point>> =
    world.marks.mapNotNull { mark ->
        val nearest = when (val figure = mark.figure) {
            is MarkFigure.Line -> nearestOf(figure.way, point).takeIf { apart(it, point) > figure.width / 2 }

            is MarkFigure.Area -> {
                flat(figure.shape).run { if (contains(point.x, point.y)) null else nearestEdgePoint(point) }
            }

            is MarkFigure.GreyMap -> null
        } ?: return@mapNotNull null
        groundOf(mark).let { messages.ground(it.kind, it.name, it.tone) } to nearest
    }

private fun nearestOnEdge(world: World, point: Point): Point {
    val width = world.paper.width
    val height = world.paper.height
    val corners = listOf(Point(0.0, 0.0), Point(width, 0.0), Point(width, height), Point(0.0, height), Point(0.0, 0.0))
    return nearestOf(corners, point)
}

/** In centimetres. */
private const val LAMP_RADIUS = 2.0
private const val STEP = 1.0

/** Who is no further from the place of a goal is there. */
private const val THERE = 1.0

/** What is no further away is told beside a goal. */
private const val NEAR = 10.0
private const val MAX_THINGS = 3
private const val MAX_LAMPS = 2

/** In degrees: what is less beside a direction lies in it. */
private const val STRAIGHT = 20

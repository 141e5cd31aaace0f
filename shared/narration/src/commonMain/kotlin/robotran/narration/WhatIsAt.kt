package robotran.narration

import robotran.language.Language
import robotran.simulation.state.SessionState
import robotran.world.World
import robotran.world.geometry.Point

/** What is at [point] of the sheet, in a few short sentences, and what is nearest if nothing stands there. */
fun whatIsAt(point: Point, world: World, session: SessionState, language: Language): List<String> {
    val messages = PlaceMessages.of(language)
    val bodies = bodiesOf(world, session)
    val lamps = world.lamps.zip(session.lamps) { lamp, now -> Thing(ThingKind.LAMP, lamp.name) to now.place }
    val things = bodies.filter { it.contains(point) }.map { it.thing } +
        lamps.filter { apart(it.second, point) <= LAMP_RADIUS }.map { it.first }
    val ground = groundAt(world, session, point).map { messages.ground(it.kind, it.name, it.tone) }
    val here = things.take(MOST_THINGS).map { messages.thing(it.kind, it.name) }
    return buildList {
        // What stands there hides the paper.
        add(messages.spot(centimetres(point.x), centimetres(point.y), here + ground.filter { here.isEmpty() }))
        lampsSeenAt(world, session, point).take(MOST_LAMPS).forEach { add(messages.inLight(world.lamps[it].name)) }
        if (here.isEmpty()) add(nearest(point, world, bodies, lamps, messages))
    }
}

private fun nearest(
    point: Point,
    world: World,
    bodies: List<Body>,
    lamps: List<Pair<Thing, Point>>,
    messages: PlaceMessages,
): String {
    val places = bodies.map { it.thing to it.outline.nearestEdgePoint(point) } + lamps +
        (Thing(ThingKind.EDGE) to nearestOnEdge(world, point))
    val (thing, place) = places.minBy { apart(it.second, point) }
    val direction = sheetDirection(directionOf(place.x - point.x, place.y - point.y))
    val aside = direction.aside.takeIf { direction.degrees > STRAIGHT }
    return messages.nearest(thing.kind, thing.name, centimetres(apart(place, point)), direction.to, aside)
}

private fun nearestOnEdge(world: World, point: Point): Point {
    val width = world.paper.width
    val height = world.paper.height
    val corners = listOf(Point(0.0, 0.0), Point(width, 0.0), Point(width, height), Point(0.0, height), Point(0.0, 0.0))
    return nearestOf(corners, point)
}

/** In centimetres. */
private const val LAMP_RADIUS = 2.0
private const val MOST_THINGS = 3
private const val MOST_LAMPS = 2

/** In degrees: what is less beside a direction lies in it. */
private const val STRAIGHT = 20

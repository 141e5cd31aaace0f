package robotran.worldediting

import robotran.editing.hasNoUnpairedSurrogate
import robotran.editing.isValidText
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.WorldLimits
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import robotran.world.robot.robotErrors

/** Why [element] is invalid in any world; null if it is valid. */
internal fun errorOf(element: Element): WorldEditError? {
    val name = element.name
    if (name != null && !isValidText(name, WorldLimits.MAXIMUM_NAME_CHARACTERS)) return WorldEditError.InvalidText
    return element.form?.let(::errorOf) ?: valueError(element)
}

/** Why the properties of [world], without its elements and goals, are invalid; null if they are valid. */
internal fun errorOf(world: World): WorldEditError? = fieldsOf(world.parameters).error ?: countError(world)

/** Max number of elements of [kind] in a world. */
fun max(kind: ElementKind): Int = when (kind) {
    ElementKind.MARK -> WorldLimits.MAXIMUM_MARKS
    ElementKind.STROKE -> WorldLimits.MAXIMUM_STROKES
    ElementKind.GOAL -> WorldLimits.MAXIMUM_GOALS
    ElementKind.WALL -> WorldLimits.MAXIMUM_WALLS
    ElementKind.BARRIER -> WorldLimits.MAXIMUM_BARRIERS
    ElementKind.BLOCK -> WorldLimits.MAXIMUM_BLOCKS
    ElementKind.ROBOT -> WorldLimits.MAXIMUM_ROBOTS
    ElementKind.LAMP -> WorldLimits.MAXIMUM_LAMPS
}

private fun countError(world: World): WorldEditError? {
    ElementKind.entries.firstOrNull { world.count(it) > max(it) }?.let { return WorldEditError.TooMany(it) }
    if (world.robots.isEmpty()) return WorldEditError.LastRobot
    val goals = allGoals(world.goals)
    if (goals.any { it.depth >= WorldLimits.MAXIMUM_GOAL_DEPTH }) return WorldEditError.TooDeep
    val points =
        world.marks.sumOf {
            (it.figure as? MarkFigure.Line)?.points?.size
                ?: pointsIn((it.figure as? MarkFigure.Area)?.shape)
        } +
            world.strokes.sumOf { it.size } + goals.sumOf { pointsIn(it.goal.region) } +
            world.barriers.sumOf { pointsIn(it.shape) } + world.blocks.sumOf { pointsIn(it.shape) }
    return when {
        points > WorldLimits.MAXIMUM_POINTS -> WorldEditError.TooManyPoints
        cellsIn(world.marks) > WorldLimits.MAXIMUM_MAP_CELLS -> WorldEditError.TooMany(ElementKind.MARK)
        else -> null
    }
}

private fun pointsIn(shape: Shape?) = (shape as? Shape.Polygon)?.corners?.size ?: 0

private fun cellsIn(marks: List<Mark>) = marks.sumOf { mark ->
    (mark.figure as? MarkFigure.GreyMap)?.rows?.sumOf { it.length }
        ?: 0
}

private fun errorOf(form: Form): WorldEditError? = when (form) {
    is Form.Area -> errorOf(form.shape)
    is Form.Way -> errorOf(form)
    is Form.Start -> errorOf(Point(form.pose.x, form.pose.y))
    is Form.Light -> errorOf(form.place)
    is Form.Picture -> errorOf(form.corner)
}

private fun errorOf(shape: Shape): WorldEditError? = when (shape) {
    is Shape.Rectangle -> errorOf(shape.centre) ?: sizeError(shape.width) ?: sizeError(shape.height)
    is Shape.Circle -> errorOf(shape.centre) ?: sizeError(shape.radius)

    is Shape.Polygon -> when {
        shape.corners.size < MIN_CORNERS -> WorldEditError.TooFewCorners
        shape.corners.size > WorldLimits.MAXIMUM_CORNERS -> WorldEditError.TooManyPoints
        else -> shape.corners.firstNotNullOfOrNull(::errorOf)
    }
}

private fun errorOf(way: Form.Way): WorldEditError? = when {
    way.points.size < (if (way.closed) MIN_CORNERS else 2) -> WorldEditError.TooFewCorners
    way.points.size > WorldLimits.MAXIMUM_LINE_POINTS -> WorldEditError.TooManyPoints
    way.isBent && way.edges().any { (from, to) -> from == to } -> WorldEditError.CoincidentPoints
    else -> way.points.firstNotNullOfOrNull(::errorOf)
}

private fun errorOf(point: Point): WorldEditError? {
    val range = WorldLimits.MINIMUM_COORDINATE..WorldLimits.MAXIMUM_COORDINATE
    return WorldEditError.TooFar.takeIf { point.x !in range || point.y !in range }
}

private fun sizeError(side: Double): WorldEditError? =
    WorldEditError.InvalidSize.takeIf { side !in WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_SHAPE_SIDE }

private fun valueError(element: Element): WorldEditError? = when (element) {
    is Element.OfRobot -> errorOf(element.robot)
    is Element.OfGoal -> errorOf(element.goal)
    else -> ownFields(element).error
}

private fun errorOf(robot: RobotPlacement): WorldEditError? {
    val lines = robot.program?.lines().orEmpty()
    val areLines = lines.size <= WorldLimits.MAXIMUM_PROGRAM_LINES && lines.all { line ->
        line.length <= WorldLimits.MAXIMUM_PROGRAM_LINE_CHARACTERS && hasNoUnpairedSurrogate(line) &&
            line.none { it.isISOControl() && it != '\t' }
    }
    val isPossible = robotErrors(robot.description).isEmpty()
    return when {
        !areLines -> WorldEditError.InvalidText
        !isPossible || robot.beacon !in BRIGHTNESSES -> WorldEditError.OutOfRange
        else -> null
    }
}

internal const val MIN_CORNERS = 3
private val BRIGHTNESSES = 0.0..WorldLimits.MAXIMUM_BRIGHTNESS

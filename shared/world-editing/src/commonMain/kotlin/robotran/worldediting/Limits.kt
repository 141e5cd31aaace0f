package robotran.worldediting

import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.RobotPlacement
import robotran.world.Shade
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
internal fun errorOf(world: World): WorldEditError? {
    val sides = WorldLimits.MINIMUM_PAPER_SIDE..WorldLimits.MAXIMUM_PAPER_SIDE
    val isWithin = world.paper.width in sides && world.paper.height in sides &&
        world.ambientLight in 0.0..WorldLimits.MAXIMUM_BRIGHTNESS &&
        world.temperature in WorldLimits.MINIMUM_TEMPERATURE..WorldLimits.MAXIMUM_TEMPERATURE &&
        world.timeLimit in 1..WorldLimits.MAXIMUM_SECONDS && world.realism in 0.0..1.0 && world.seed >= 0
    val areTexts = isValidText(world.title, WorldLimits.MAXIMUM_TITLE_CHARACTERS) &&
        (
            world.task.isEmpty() ||
                isValidText(world.task, WorldLimits.MAXIMUM_TASK_CHARACTERS, mayBeBlank = true, severalLines = true)
        )
    return if (!isWithin) {
        WorldEditError.OutOfRange
    } else {
        WorldEditError.InvalidText.takeIf { !areTexts }
            ?: countError(world)
    }
}

/** Whether a file can hold [text] in one line, or in several if [severalLines]. */
fun isValidText(text: String, maximum: Int, mayBeBlank: Boolean = false, severalLines: Boolean = false): Boolean =
    (mayBeBlank || text.isNotBlank()) && text.length <= maximum && hasNoUnpairedSurrogate(text) &&
        text.none { it.isISOControl() && !(severalLines && it == '\n') }

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
    is Element.OfWall -> WorldEditError.OutOfRange.takeIf { element.wall.thickness !in THICKNESSES }

    is Element.OfBlock -> WorldEditError.OutOfRange.takeIf {
        element.block.mass !in MASSES ||
            element.block.friction !in FRICTIONS
    }

    is Element.OfMark -> errorOf(element.mark)
    is Element.OfLamp -> errorOf(element.lamp)
    is Element.OfGoal -> errorOf(element.goal)
    is Element.OfBarrier, is Element.OfStroke -> null
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

private fun errorOf(mark: Mark): WorldEditError? {
    val isShade = when (val shade = mark.shade) {
        is Shade.Grey -> shade.reflectance in 0.0..1.0
        is Shade.Colour -> listOf(shade.red, shade.green, shade.blue).all { it in 0..MAX_COLOUR }
    }
    val isWidth = (mark.figure as? MarkFigure.Line)?.let { it.width in THICKNESSES } ?: true
    return WorldEditError.OutOfRange.takeIf { !isShade || !isWidth }
}

private fun errorOf(lamp: Lamp): WorldEditError? = WorldEditError.OutOfRange.takeIf {
    lamp.brightness !in BRIGHTNESSES || lamp.cone !in WorldLimits.MINIMUM_CONE..Lamp.ALL_ROUND ||
        lamp.direction !in -WorldLimits.MAXIMUM_ANGLE..WorldLimits.MAXIMUM_ANGLE
}

/** Whether there is no unpaired surrogate, which UTF-8 cannot encode. */
internal fun hasNoUnpairedSurrogate(text: String): Boolean {
    var place = 0
    while (place < text.length) {
        val isPair = text[place].isHighSurrogate() && place + 1 < text.length && text[place + 1].isLowSurrogate()
        if (text[place].isSurrogate() && !isPair) return false
        place += if (isPair) 2 else 1
    }
    return true
}

internal const val MIN_CORNERS = 3
private const val MAX_COLOUR = 255
private val THICKNESSES = WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_WALL_THICKNESS
private val MASSES = WorldLimits.MINIMUM_MASS..WorldLimits.MAXIMUM_MASS
private val FRICTIONS = 0.0..WorldLimits.MAXIMUM_FRICTION
private val BRIGHTNESSES = 0.0..WorldLimits.MAXIMUM_BRIGHTNESS

package robotran.worldediting

import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.UnknownFields
import robotran.world.geometry.Shape

/** The position and size; null for a goal without a region. */
val Element.form: Form?
    get() = when (this) {
        is Element.OfRobot -> Form.Start(robot.start, robot.description)
        is Element.OfWall -> Form.Way(listOf(wall.from, wall.to), wall.thickness, closed = false, isBent = false)
        is Element.OfBarrier -> Form.Area(barrier.shape)
        is Element.OfBlock -> Form.Area(block.shape)
        is Element.OfMark -> mark.figure.form
        is Element.OfLamp -> Form.Light(lamp.place, lamp.direction, lamp.cone < Lamp.ALL_ROUND)
        is Element.OfStroke -> Form.Way(points, 0.0, closed = false, isBent = true)
        is Element.OfGoal -> goal.region?.let(Form::Area)
    }

private val MarkFigure.form: Form
    get() = when (this) {
        is MarkFigure.Area -> Form.Area(shape)
        is MarkFigure.Line -> Form.Way(points, width, closed, isBent = true)
        is MarkFigure.GreyMap -> Form.Picture(corner, cell * rows.first().length, cell * rows.size)
    }

/** The same element with another form; [form] must be of the element's type. Rounds values to thousandths. */
fun Element.withForm(form: Form): Element = when (val rounded = form.rounded()) {
    is Form.Area -> withShape(rounded.shape)
    is Form.Way -> withWay(rounded)
    is Form.Start -> if (this is Element.OfRobot) copy(robot.copy(start = rounded.pose)) else this

    is Form.Light -> {
        if (this is Element.OfLamp) copy(lamp.copy(place = rounded.place, direction = rounded.direction)) else this
    }

    is Form.Picture -> {
        val map = (this as? Element.OfMark)?.mark?.figure as? MarkFigure.GreyMap
        if (this is Element.OfMark && map != null) copy(mark.copy(figure = map.copy(corner = rounded.corner))) else this
    }
}

private fun Element.withShape(shape: Shape): Element = when (this) {
    is Element.OfBarrier -> copy(barrier.copy(shape = shape, unknown = barrier.unknown.fitting(barrier.shape, shape)))
    is Element.OfBlock -> copy(block.copy(shape = shape, unknown = block.unknown.fitting(block.shape, shape)))

    is Element.OfMark -> copy(
        mark.copy(figure = MarkFigure.Area(shape), unknown = mark.unknown.fitting(mark.shape, shape)),
    )

    is Element.OfGoal -> copy(goal.withRegion(shape))
    is Element.OfRobot, is Element.OfWall, is Element.OfLamp, is Element.OfStroke -> this
}

private fun Element.withWay(way: Form.Way): Element = when (this) {
    is Element.OfWall -> copy(wall.copy(from = way.points.first(), to = way.points.last()))

    is Element.OfMark -> {
        val line = mark.figure as? MarkFigure.Line
        if (line == null) this else copy(mark.copy(figure = line.copy(points = way.points)))
    }

    is Element.OfStroke -> copy(points = way.points)
    is Element.OfRobot, is Element.OfBarrier, is Element.OfBlock, is Element.OfLamp, is Element.OfGoal -> this
}

private val Mark.shape: Shape? get() = (figure as? MarkFigure.Area)?.shape

/** Drops unknown fields of a shape when its kind changes, because they could read as a second shape. */
internal fun UnknownFields.fitting(before: Shape?, after: Shape): UnknownFields =
    if (members.isEmpty() || before == null || before::class == after::class) this else UnknownFields(members - SHAPES)

private val SHAPES = setOf("rectangle", "circle", "polygon", "line", "greyMap")

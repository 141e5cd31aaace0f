package robotran.worldediting

import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.UnknownFields
import robotran.world.geometry.Shape

/** Where it is and what room it takes; null for a goal that is about no place. */
val Piece.form: Form?
    get() = when (this) {
        is Piece.OfRobot -> Form.Start(robot.start)
        is Piece.OfWall -> Form.Way(listOf(wall.from, wall.to), wall.thickness, closed = false, isBent = false)
        is Piece.OfBarrier -> Form.Area(barrier.shape)
        is Piece.OfBlock -> Form.Area(block.shape)
        is Piece.OfMark -> mark.figure.form
        is Piece.OfLamp -> Form.Light(lamp.place, lamp.direction, lamp.cone < Lamp.ALL_ROUND)
        is Piece.OfStroke -> Form.Way(points, 0.0, closed = false, isBent = true)
        is Piece.OfGoal -> goal.region?.let(Form::Area)
    }

private val MarkFigure.form: Form
    get() = when (this) {
        is MarkFigure.Area -> Form.Area(shape)
        is MarkFigure.Line -> Form.Way(points, width, closed, isBent = true)
        is MarkFigure.GreyMap -> Form.Picture(corner, cell * rows.first().length, cell * rows.size)
    }

/** The same piece elsewhere or in another shape; [form] must be of the sort that it has. Its figures are rounded to thousandths. */
fun Piece.withForm(form: Form): Piece = when (val rounded = form.rounded()) {
    is Form.Area -> {
        withShape(rounded.shape)
    }

    is Form.Way -> {
        withWay(rounded)
    }

    is Form.Start -> {
        if (this is Piece.OfRobot) copy(robot.copy(start = rounded.pose)) else this
    }

    is Form.Light -> {
        if (this is Piece.OfLamp) copy(lamp.copy(place = rounded.place, direction = rounded.direction)) else this
    }

    is Form.Picture -> {
        val map = (this as? Piece.OfMark)?.mark?.figure as? MarkFigure.GreyMap
        if (this is Piece.OfMark && map != null) copy(mark.copy(figure = map.copy(corner = rounded.corner))) else this
    }
}

private fun Piece.withShape(shape: Shape): Piece = when (this) {
    is Piece.OfBarrier -> copy(barrier.copy(shape = shape, unknown = barrier.unknown.fitting(barrier.shape, shape)))
    is Piece.OfBlock -> copy(block.copy(shape = shape, unknown = block.unknown.fitting(block.shape, shape)))
    is Piece.OfMark -> copy(mark.copy(figure = MarkFigure.Area(shape), unknown = mark.unknown.fitting(mark.shape, shape)))
    is Piece.OfGoal -> copy(goal.withRegion(shape))
    is Piece.OfRobot, is Piece.OfWall, is Piece.OfLamp, is Piece.OfStroke -> this
}

private fun Piece.withWay(way: Form.Way): Piece = when (this) {
    is Piece.OfWall -> {
        copy(wall.copy(from = way.points.first(), to = way.points.last()))
    }

    is Piece.OfMark -> {
        val line = mark.figure as? MarkFigure.Line
        if (line == null) this else copy(mark.copy(figure = line.copy(points = way.points)))
    }

    is Piece.OfStroke -> {
        copy(points = way.points)
    }

    is Piece.OfRobot, is Piece.OfBarrier, is Piece.OfBlock, is Piece.OfLamp, is Piece.OfGoal -> {
        this
    }
}

private val Mark.shape: Shape? get() = (figure as? MarkFigure.Area)?.shape

/** What a file says beyond the known within a shape of another kind would make that a second shape. */
internal fun UnknownFields.fitting(before: Shape?, after: Shape): UnknownFields =
    if (members.isEmpty() || before == null || before::class == after::class) this else UnknownFields(members - SHAPES)

private val SHAPES = setOf("rectangle", "circle", "polygon", "line", "greyMap")

package robotran.world.file

import robotran.json.JsonCursor
import robotran.world.Barrier
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.MovableBlock
import robotran.world.Shade
import robotran.world.Wall
import robotran.world.WorldLimits
import robotran.world.messages.reason

/** Reads all elements of a world file except robots and goals. */
internal class ElementReader(private val shapes: ShapeReader) {
    private var cells = 0

    fun wall(cursor: JsonCursor) = Wall(
        from = shapes.point(cursor.member("from")),
        to = shapes.point(cursor.member("to")),
        thickness = cursor.member(
            "thickness",
        ).number(WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_WALL_THICKNESS),
        unknown = unknownOf(cursor),
    )

    fun barrier(cursor: JsonCursor) = Barrier(shapes.shape(cursor), nameOf(cursor), unknownOf(cursor))

    fun block(cursor: JsonCursor) = MovableBlock(
        shape = shapes.shape(cursor),
        mass = cursor.optional(
            "mass",
        )?.number(WorldLimits.MINIMUM_MASS..WorldLimits.MAXIMUM_MASS) ?: MovableBlock.DEFAULT_MASS,
        friction =
            cursor.optional("friction")?.number(0.0..WorldLimits.MAXIMUM_FRICTION) ?: MovableBlock.DEFAULT_FRICTION,
        name = nameOf(cursor),
        unknown = unknownOf(cursor),
    )

    fun mark(cursor: JsonCursor) = Mark(figure(cursor), shade(cursor), nameOf(cursor), unknownOf(cursor))

    fun lamp(cursor: JsonCursor) = Lamp(
        place = shapes.corner(cursor),
        brightness = cursor.optional("brightness")?.number(0.0..WorldLimits.MAXIMUM_BRIGHTNESS) ?: 1.0,
        direction = cursor.optional("direction")?.number(WorldLimits.ANGLES) ?: 0.0,
        cone = cursor.optional("cone")?.number(WorldLimits.MINIMUM_CONE..Lamp.ALL_ROUND) ?: Lamp.ALL_ROUND,
        on = cursor.optional("on")?.flag() ?: true,
        infrared = cursor.optional("infrared")?.flag() ?: false,
        name = nameOf(cursor),
        unknown = unknownOf(cursor),
    )

    private fun nameOf(cursor: JsonCursor): String? = cursor.optional("name")?.text(WorldLimits.MAXIMUM_NAME_CHARACTERS)

    private fun figure(cursor: JsonCursor): MarkFigure {
        val (kind, figure) = onlyMember(cursor, FIGURES)
        return when (kind) {
            "line" -> line(figure)
            "greyMap" -> greyMap(figure)
            else -> MarkFigure.Area(shapes.shape(cursor))
        }
    }

    private fun line(cursor: JsonCursor): MarkFigure.Line {
        val closed = cursor.optional("closed")?.flag() ?: false
        return MarkFigure.Line(
            points = shapes.way(cursor.member("points"), if (closed) MIN_IN_LOOP else 2, closed),
            width = cursor.member("width").number(WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_WALL_THICKNESS),
            closed = closed,
        )
    }

    private fun greyMap(cursor: JsonCursor): MarkFigure.GreyMap {
        val rows = cursor.member("rows").items(1..WorldLimits.MAXIMUM_MAP_SIDE)
        val greys = rows.map(::greyRow)
        cells += greys.sumOf { it.length }
        if (cells > WorldLimits.MAXIMUM_MAP_CELLS) {
            cursor.refuse(reason { tooManyCells(WorldLimits.MAXIMUM_MAP_CELLS) })
        }
        greys.indexOfFirst { it.length != greys.first().length }.takeIf { it >= 0 }?.let {
            rows[it].refuse(reason { rowLength(greys.first().length) })
        }
        val cell = cursor.member("cell").number(WorldLimits.MINIMUM_CELL..WorldLimits.MAXIMUM_CELL)
        return MarkFigure.GreyMap(shapes.corner(cursor), cell, greys)
    }

    private fun greyRow(cursor: JsonCursor): String {
        val row = cursor.text(WorldLimits.MAXIMUM_MAP_SIDE).lowercase()
        if (row.any { it !in GREYS }) cursor.refuse(reason { mustBeGreys() })
        return row
    }

    private fun shade(cursor: JsonCursor): Shade {
        val grey = cursor.optional("grey")
        val colour = cursor.optional("colour")
        if (grey != null && colour != null) cursor.refuse(reason { mustHaveOnlyOneOf(listOf("grey", "colour")) })
        return colour?.let(::colour) ?: Shade.Grey(grey?.number(0.0..1.0) ?: 0.0)
    }

    private fun colour(cursor: JsonCursor): Shade.Colour {
        val text = cursor.textOrNull().orEmpty()
        val isColour =
            text.length == COLOUR_LENGTH && text[0] == '#' && text.drop(1).all { it.lowercaseChar() in HEXADECIMAL }
        if (!isColour) cursor.refuse(reason { mustBeColour() })
        val (red, green, blue) = text.drop(1).chunked(2).map { it.toInt(radix = 16) }
        return Shade.Colour(red, green, blue)
    }

    private companion object {
        val FIGURES = listOf("rectangle", "circle", "polygon", "line", "greyMap")
        const val HEXADECIMAL = "0123456789abcdef"
        const val GREYS = "$HEXADECIMAL."
        const val COLOUR_LENGTH = 7
        const val MIN_IN_LOOP = 3
    }
}

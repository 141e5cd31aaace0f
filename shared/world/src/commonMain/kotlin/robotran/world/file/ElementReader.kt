package robotran.world.file

import robotran.json.JsonCursor
import robotran.world.Barrier
import robotran.world.Block
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Shade
import robotran.world.Wall
import robotran.world.WorldLimits
import robotran.world.messages.told

/** Reads all elements of a world file except robots and goals. */
internal class ElementReader(private val shapes: ShapeReader) {
    private var cells = 0

    fun wall(place: JsonCursor) = Wall(
        from = shapes.point(place.member("from")),
        to = shapes.point(place.member("to")),
        thickness = place.member("thickness").number(WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_WALL_THICKNESS),
        unknown = unknownOf(place),
    )

    fun barrier(place: JsonCursor) = Barrier(shapes.shape(place), nameOf(place), unknownOf(place))

    fun block(place: JsonCursor) = Block(
        shape = shapes.shape(place),
        mass = place.optional("mass")?.number(WorldLimits.MINIMUM_MASS..WorldLimits.MAXIMUM_MASS) ?: Block.DEFAULT_MASS,
        friction = place.optional("friction")?.number(0.0..WorldLimits.MAXIMUM_FRICTION) ?: Block.DEFAULT_FRICTION,
        name = nameOf(place),
        unknown = unknownOf(place),
    )

    fun mark(place: JsonCursor) = Mark(figure(place), shade(place), nameOf(place), unknownOf(place))

    fun lamp(place: JsonCursor) = Lamp(
        place = shapes.corner(place),
        brightness = place.optional("brightness")?.number(0.0..WorldLimits.MAXIMUM_BRIGHTNESS) ?: 1.0,
        direction = place.optional("direction")?.number(WorldLimits.ANGLES) ?: 0.0,
        cone = place.optional("cone")?.number(WorldLimits.MINIMUM_CONE..Lamp.ALL_ROUND) ?: Lamp.ALL_ROUND,
        on = place.optional("on")?.flag() ?: true,
        infrared = place.optional("infrared")?.flag() ?: false,
        name = nameOf(place),
        unknown = unknownOf(place),
    )

    private fun nameOf(place: JsonCursor): String? = place.optional("name")?.text(WorldLimits.MAXIMUM_NAME_CHARACTERS)

    private fun figure(place: JsonCursor): MarkFigure {
        val (kind, figure) = onlyMember(place, FIGURES)
        return when (kind) {
            "line" -> line(figure)
            "greyMap" -> greyMap(figure)
            else -> MarkFigure.Area(shapes.shape(place))
        }
    }

    private fun line(place: JsonCursor): MarkFigure.Line {
        val closed = place.optional("closed")?.flag() ?: false
        return MarkFigure.Line(
            points = shapes.way(place.member("points"), if (closed) MIN_IN_LOOP else 2, closed),
            width = place.member("width").number(WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_WALL_THICKNESS),
            closed = closed,
        )
    }

    private fun greyMap(place: JsonCursor): MarkFigure.GreyMap {
        val rows = place.member("rows").items(1..WorldLimits.MAXIMUM_MAP_SIDE)
        val greys = rows.map(::greyRow)
        cells += greys.sumOf { it.length }
        if (cells > WorldLimits.MAXIMUM_MAP_CELLS) {
            place.refuse(told { tooManyCells(WorldLimits.MAXIMUM_MAP_CELLS) })
        }
        greys.indexOfFirst { it.length != greys.first().length }.takeIf { it >= 0 }?.let {
            rows[it].refuse(told { rowLength(greys.first().length) })
        }
        val cell = place.member("cell").number(WorldLimits.MINIMUM_CELL..WorldLimits.MAXIMUM_CELL)
        return MarkFigure.GreyMap(shapes.corner(place), cell, greys)
    }

    private fun greyRow(place: JsonCursor): String {
        val row = place.text(WorldLimits.MAXIMUM_MAP_SIDE).lowercase()
        if (row.any { it !in GREYS }) place.refuse(told { mustBeGreys() })
        return row
    }

    private fun shade(place: JsonCursor): Shade {
        val grey = place.optional("grey")
        val colour = place.optional("colour")
        if (grey != null && colour != null) place.refuse(told { mustHaveOnlyOneOf(listOf("grey", "colour")) })
        return colour?.let(::colour) ?: Shade.Grey(grey?.number(0.0..1.0) ?: 0.0)
    }

    private fun colour(place: JsonCursor): Shade.Colour {
        val text = place.textOrNull().orEmpty()
        val isColour =
            text.length == COLOUR_LENGTH && text[0] == '#' && text.drop(1).all { it.lowercaseChar() in HEXADECIMAL }
        if (!isColour) place.refuse(told { mustBeColour() })
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

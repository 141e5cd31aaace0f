package robotran.world.file

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonPrimitive
import robotran.json.ObjectBuilder
import robotran.json.jsonObject
import robotran.world.Barrier
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.MovableBlock
import robotran.world.Shade
import robotran.world.Wall
import robotran.world.geometry.Point
import robotran.world.geometry.Shape

internal fun elementOf(wall: Wall) = jsonObject(wall.unknown.members) {
    put("from", point(wall.from))
    put("to", point(wall.to))
    number("thickness", wall.thickness)
}

internal fun elementOf(barrier: Barrier) = jsonObject(barrier.unknown.members) {
    text("name", barrier.name)
    shape(barrier.shape)
}

internal fun elementOf(block: MovableBlock) = jsonObject(block.unknown.members) {
    text("name", block.name)
    shape(block.shape)
    number("mass", block.mass, default = MovableBlock.DEFAULT_MASS)
    number("friction", block.friction, default = MovableBlock.DEFAULT_FRICTION)
}

internal fun elementOf(mark: Mark) = jsonObject(mark.unknown.members) {
    text("name", mark.name)
    when (val shade = mark.shade) {
        is Shade.Grey -> number("grey", shade.reflectance, default = 0.0)

        is Shade.Colour -> text(
            "colour",
            "#" + listOf(shade.red, shade.green, shade.blue).joinToString("", transform = ::hexadecimal),
        )
    }
    when (val figure = mark.figure) {
        is MarkFigure.Area -> shape(figure.shape)
        is MarkFigure.Line -> put("line", elementOf(figure))
        is MarkFigure.GreyMap -> put("greyMap", elementOf(figure))
    }
}

internal fun elementOf(lamp: Lamp) = jsonObject(lamp.unknown.members) {
    text("name", lamp.name)
    corner(lamp.place)
    number("brightness", lamp.brightness, default = 1.0)
    number("direction", lamp.direction, default = 0.0)
    number("cone", lamp.cone, default = Lamp.ALL_ROUND)
    flag("on", lamp.on, default = true)
    flag("infrared", lamp.infrared, default = false)
}

internal fun ObjectBuilder.shape(shape: Shape) = when (shape) {
    is Shape.Polygon -> put("polygon", points(shape.corners))

    is Shape.Circle -> put(
        "circle",
        jsonObject {
            corner(shape.centre)
            number("radius", shape.radius)
        },
    )

    is Shape.Rectangle -> put(
        "rectangle",
        jsonObject {
            corner(shape.centre)
            number("width", shape.width)
            number("height", shape.height)
            number("angle", shape.angle, default = 0.0)
        },
    )
}

private fun elementOf(line: MarkFigure.Line) = jsonObject {
    put("points", points(line.points))
    number("width", line.width)
    flag("closed", line.closed, default = false)
}

private fun elementOf(map: MarkFigure.GreyMap) = jsonObject {
    corner(map.corner)
    number("cell", map.cell)
    put("rows", JsonArray(map.rows.map(::JsonPrimitive)))
}

private fun ObjectBuilder.corner(point: Point) {
    number("x", point.x)
    number("y", point.y)
}

private fun hexadecimal(part: Int): String = part.toString(radix = 16).padStart(2, '0')

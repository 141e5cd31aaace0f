package robotran.scene3d.model

import robotran.scene3d.geometry.ConvexPiece
import robotran.scene3d.geometry.ConvexPolygon
import robotran.scene3d.geometry.convexPieces
import robotran.scene3d.geometry.without
import robotran.world.Lamp
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.geometry.Shape
import robotran.world.geometry.centre
import kotlin.math.PI
import kotlin.math.sqrt

/** How high the things of a world are, in centimetres. The world itself is flat, so these are ours. */
object Heights {
    /** Of walls and barriers; hides from a robot's eye what is behind. */
    const val WALL = 6.5
    const val BLOCK = 4.8

    /** All that stands on the paper is lower; lamps and the cloths of flags are higher. */
    const val STANDING = RobotPlan3D.HEIGHT
    const val FLAG = 17.0
    const val LAMP = 17.5
}

/** The bodies of what a world contains besides robots. */
internal class Things(private val world: World, private val colours: SceneColours, private val round: Round) {
    /**
     * Walls and barriers. Where several are in the same place, the first has it and the others are cut off, because
     * ordered solids must not overlap. Beyond [MAX_CUT_PIECES] pieces, which only a grid of crossing walls has, the rest
     * is not cut off: it may be drawn in the wrong order, but soon enough.
     */
    fun standing(): List<SceneNode> {
        val pieces = mutableListOf<Pair<SceneElement, ConvexPiece>>()
        world.walls.forEachIndexed {
            number,
            wall,
            ->
            add(wall(wall), SceneElement(SceneElementKind.WALL, number), pieces)
        }
        world.barriers.forEachIndexed { number, barrier ->
            for (piece in piecesOf(barrier.shape, Point(0.0, 0.0))) {
                add(piece, SceneElement(SceneElementKind.BARRIER, number), pieces)
            }
        }
        return pieces.map { (element, piece) ->
            val smooth = element.kind == SceneElementKind.BARRIER &&
                world.barriers[element.number].shape is Shape.Circle
            val body = prism(
                piece.polygon,
                0.0,
                Heights.WALL,
                colours.wall,
                colours.wallTop,
                smooth,
                BooleanArray(piece.polygon.size) { !piece.outer[it] },
                sideDecals = { _, edge -> if (smooth) emptyList() else listOf(joints(piece.polygon, edge)) },
            )
            SceneNode.Solid(body, Placement.ORIGIN, element)
        }
    }

    /** The joints between the bricks of a wall's side beyond an edge of its footprint. */
    private fun joints(polygon: ConvexPolygon, edge: Int): Decal {
        val next = (edge + 1) % polygon.size
        val alongX = polygon.x(next) - polygon.x(edge)
        val alongY = polygon.y(next) - polygon.y(edge)
        val length = sqrt(alongX * alongX + alongY * alongY)

        fun rectangle(from: Double, to: Double, bottom: Double, top: Double): DoubleArray {
            val fromX = polygon.x(edge) + alongX * from / length
            val fromY = polygon.y(edge) + alongY * from / length
            val toX = polygon.x(edge) + alongX * to / length
            val toY = polygon.y(edge) + alongY * to / length
            return doubleArrayOf(fromX, fromY, bottom, toX, toY, bottom, toX, toY, top, fromX, fromY, top)
        }
        val shapes = mutableListOf<DoubleArray>()
        val course = Heights.WALL / COURSES
        for (row in 0 until COURSES) {
            val bottom = row * course
            if (row > 0) shapes += rectangle(0.0, length, bottom - JOINT / 2, bottom + JOINT / 2)
            var place = if (row % 2 == 0) BRICK else BRICK / 2
            while (place < length - JOINT && shapes.size < MAX_JOINTS) {
                shapes +=
                    rectangle(place - JOINT / 2, place + JOINT / 2, bottom + JOINT / 2, bottom + course - JOINT / 2)
                place += BRICK
            }
        }
        return Decal(shapes, colours.wallJoint)
    }

    private fun add(piece: ConvexPiece, element: SceneElement, pieces: MutableList<Pair<SceneElement, ConvexPiece>>) {
        var rest = listOf(piece)
        if (pieces.size < MAX_CUT_PIECES) {
            for ((_, other) in pieces) rest = rest.flatMap { it.without(other.polygon) }
        }
        rest.mapTo(pieces) { element to it }
    }

    private fun wall(wall: Wall): ConvexPiece {
        val alongX = wall.to.x - wall.from.x
        val alongY = wall.to.y - wall.from.y
        val length = sqrt(alongX * alongX + alongY * alongY)
        val half = wall.thickness / 2
        // A wall without length is a square, as everywhere else.
        val x = if (length == 0.0) half else alongX / length * half
        val y = if (length == 0.0) 0.0 else alongY / length * half
        val corners = listOf(
            Point(wall.from.x - x + y, wall.from.y - y - x),
            Point(wall.to.x + x + y, wall.to.y + y - x),
            Point(wall.to.x + x - y, wall.to.y + y + x),
            Point(wall.from.x - x - y, wall.from.y - y + x),
        )
        return ConvexPiece(ConvexPolygon(corners), BooleanArray(corners.size) { true })
    }

    /** The bodies of each block, around its centre. */
    val blocks: List<List<Body>> = world.blocks.map { block ->
        val isRound = block.shape is Shape.Circle
        piecesOf(block.shape, block.shape.centre).map { piece ->
            prism(
                piece.polygon,
                0.0,
                Heights.BLOCK,
                colours.block,
                colours.blockTop,
                isRound,
                BooleanArray(piece.polygon.size) { !piece.outer[it] },
                topDecals = grain(block.shape),
            )
        }
    }

    /** The rings of a log, the boards of a box. */
    private fun grain(shape: Shape): List<Decal> = when (shape) {
        is Shape.Circle -> listOf(
            0.8 to colours.blockGrain,
            0.72 to colours.blockTop,
            0.45 to colours.blockGrain,
            0.36 to colours.blockTop,
        )
            .map { (part, colour) -> round.disc(0.0, 0.0, Heights.BLOCK, shape.radius * part, colour, GRAIN_CORNERS) }

        is Shape.Rectangle -> boards(shape)
        is Shape.Polygon -> emptyList()
    }

    private fun boards(shape: Shape.Rectangle): List<Decal> {
        val angle = shape.angle * RADIANS_PER_DEGREE
        val lengthwise = shape.width >= shape.height
        val lines = listOf(-0.25, 0.0, 0.25).map { part ->
            val halfX = if (lengthwise) shape.width / 2 - INSET else GRAIN / 2
            val halfY = if (lengthwise) GRAIN / 2 else shape.height / 2 - INSET
            val x = if (lengthwise) 0.0 else shape.width * part
            val y = if (lengthwise) shape.height * part else 0.0
            val board = ConvexPolygon.rectangle(x - halfX, y - halfY, x + halfX, y + halfY)
                .placed(0.0, 0.0, round.cosine(angle), round.sine(angle))
            Round.flat(board, Heights.BLOCK)
        }
        return listOf(Decal(lines, colours.blockGrain, fine = false))
    }

    /** Relative to [origin]. */
    private fun piecesOf(shape: Shape, origin: Point): List<ConvexPiece> {
        fun whole(polygon: ConvexPolygon) = listOf(ConvexPiece(polygon, BooleanArray(polygon.size) { true }))
        return when (shape) {
            is Shape.Circle -> {
                whole(
                    round.circle(
                        shape.centre.x - origin.x,
                        shape.centre.y - origin.y,
                        shape.radius,
                        circleCorners(shape.radius),
                    ),
                )
            }

            is Shape.Rectangle -> {
                val angle = shape.angle * RADIANS_PER_DEGREE
                whole(
                    ConvexPolygon.rectangle(-shape.width / 2, -shape.height / 2, shape.width / 2, shape.height / 2)
                        .placed(
                            shape.centre.x - origin.x,
                            shape.centre.y - origin.y,
                            round.cosine(angle),
                            round.sine(angle),
                        ),
                )
            }

            is Shape.Polygon -> convexPieces(shape.corners.map { Point(it.x - origin.x, it.y - origin.y) })
        }
    }

    private fun circleCorners(radius: Double): Int = (MIN_CORNERS + radius).toInt().coerceAtMost(MAX_CORNERS)

    /** A lamp at the origin that shines along the x axis, or all round, on its rod: from bottom to top. */
    fun lamp(lamp: Lamp, on: Boolean): List<Body> {
        val shine = if (lamp.infrared) colours.lampInfrared else colours.lampOn
        val parts = if (lamp.cone < Lamp.ALL_ROUND) listOf(spotlight(on, shine)) else listOf(bulb(on, shine), shade())
        return listOf(rod(Heights.STANDING, parts.first().bottom, colours.lampShade)) + parts
    }

    private fun bulb(on: Boolean, shine: Int): Body {
        val colour = if (on) shine else colours.lampOff
        return loft(
            listOf(ring(0.6, BULB_BOTTOM), ring(1.2, BULB_BOTTOM + 0.7), ring(1.2, Heights.LAMP)),
            listOf(colour, colour),
            colour,
            smooth = true,
            glows = on,
        )
    }

    private fun shade(): Body = loft(
        listOf(ring(2.6, Heights.LAMP), ring(1.0, Heights.LAMP + 1.9), ring(0.3, Heights.LAMP + 2.5)),
        listOf(colours.lampShade, colours.lampShade),
        colours.lampShade,
        smooth = true,
    )

    private fun ring(radius: Double, height: Double) = Ring(round.circle(0.0, 0.0, radius, LAMP_CORNERS), height)

    /** A horizontal cone with a bright front that is tilted to the paper; its lowest line is level, on the rod. */
    private fun spotlight(on: Boolean, shine: Int): Body {
        val faces = mutableListOf<Face>()

        fun corner(radius: Double, number: Int, x: Double): List<Double> {
            val angle = number * 2 * PI / LAMP_CORNERS
            val up = radius * (1 + round.sine(angle))
            return listOf(x + up * SPOT_TILT, radius * round.cosine(angle), SPOT_BOTTOM + up)
        }
        for (number in 0 until LAMP_CORNERS) {
            val side = corner(SPOT_FRONT, number + 1, SPOT_LENGTH) + corner(SPOT_FRONT, number, SPOT_LENGTH) +
                corner(SPOT_REAR, number, -SPOT_LENGTH) + corner(SPOT_REAR, number + 1, -SPOT_LENGTH)
            faces += Face(side.toDoubleArray(), colours.lampShade, smooth = true)
        }
        val lens = (0 until LAMP_CORNERS).flatMap { corner(SPOT_FRONT, it, SPOT_LENGTH) }
        val back = (LAMP_CORNERS - 1 downTo 0).flatMap { corner(SPOT_REAR, it, -SPOT_LENGTH) }
        faces += Face(lens.toDoubleArray(), if (on) shine else colours.lampOff, glows = on)
        faces += Face(back.toDoubleArray(), colours.lampShade)
        val front = SPOT_LENGTH + 2 * SPOT_FRONT * SPOT_TILT
        val footprint = ConvexPolygon.rectangle(-SPOT_LENGTH, -SPOT_FRONT, front, SPOT_FRONT)
        return Body(footprint, SPOT_BOTTOM, SPOT_BOTTOM + 2 * SPOT_FRONT, faces)
    }

    /** The thin rod that shows where on the paper a lamp or a flag stands. */
    fun rod(bottom: Double, top: Double, colour: Int): Body =
        prism(ConvexPolygon.rectangle(-ROD, -ROD, ROD, ROD), bottom, top, colour)

    /** The upper part of a flag at the origin: rod and cloth, which blows along the x axis. */
    fun cloth(met: Boolean): List<Body> {
        val rod = rod(Heights.STANDING, Heights.FLAG, colours.flag)
        val cloth = prism(
            ConvexPolygon.rectangle(ROD, -CLOTH_HALF, CLOTH_WIDTH, CLOTH_HALF),
            Heights.FLAG - CLOTH_HEIGHT,
            Heights.FLAG - 0.2,
            colours.flagLight,
            sideDecals = { _, edge ->
                when (edge) {
                    0 -> chequers(-CLOTH_HALF, met)
                    2 -> chequers(CLOTH_HALF, met)
                    else -> emptyList()
                }
            },
        )
        return listOf(rod, cloth)
    }

    private fun chequers(y: Double, met: Boolean): List<Decal> {
        val width = (CLOTH_WIDTH - ROD) / CLOTH_COLUMNS
        val height = (CLOTH_HEIGHT - 0.2) / CLOTH_ROWS
        val squares = (0 until CLOTH_ROWS * CLOTH_COLUMNS).filter { (it / CLOTH_COLUMNS + it % CLOTH_COLUMNS) % 2 == 0 }
        return listOf(
            Decal(
                squares.map {
                    val left = ROD + it % CLOTH_COLUMNS * width
                    val bottom = Heights.FLAG - CLOTH_HEIGHT + it / CLOTH_COLUMNS * height
                    doubleArrayOf(
                        left,
                        y,
                        bottom,
                        left + width,
                        y,
                        bottom,
                        left + width,
                        y,
                        bottom + height,
                        left,
                        y,
                        bottom + height,
                    )
                },
                if (met) colours.flagMet else colours.flag,
                fine = false,
            ),
        )
    }

    private companion object {
        /** Drawing takes a time that grows with the square of the number of solids. */
        const val MAX_CUT_PIECES = 1_000
        const val COURSES = 4
        const val BRICK = 4.2
        const val JOINT = 0.14
        const val MAX_JOINTS = 400
        const val MIN_CORNERS = 20
        const val MAX_CORNERS = 40
        const val GRAIN_CORNERS = 16
        const val GRAIN = 0.14
        const val INSET = 0.1
        const val LAMP_CORNERS = 16
        const val BULB_BOTTOM = Heights.LAMP - 1.6
        const val SPOT_FRONT = 1.9
        const val SPOT_REAR = 0.9
        const val SPOT_LENGTH = 1.8
        const val SPOT_TILT = 0.4
        const val SPOT_BOTTOM = Heights.LAMP - 1.8
        const val ROD = 0.16
        const val CLOTH_HALF = 0.06
        const val CLOTH_WIDTH = 6.4
        const val CLOTH_HEIGHT = 4.6
        const val CLOTH_ROWS = 3
        const val CLOTH_COLUMNS = 4
    }
}

package robotran.simulation.physics

import robotran.world.MovableBlock
import robotran.world.Penbot
import robotran.world.TouchKind
import robotran.world.Wall
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import robotran.world.geometry.Trigonometry
import robotran.world.geometry.centre
import robotran.world.geometry.length
import robotran.world.geometry.outline
import robotran.world.geometry.signedArea
import kotlin.math.sqrt

/** Adds a wall as an immovable body. */
internal fun PhysicsWorld.addWall(wall: Wall) {
    val along = length(wall.to.x - wall.from.x, wall.to.y - wall.from.y)
    val directionX = if (along == 0.0) 1.0 else (wall.to.x - wall.from.x) / along
    val directionY = if (along == 0.0) 0.0 else (wall.to.y - wall.from.y) / along
    val reach = (along + wall.thickness) / 2
    val half = wall.thickness / 2

    fun corner(forwards: Double, leftwards: Double) =
        listOf(forwards * directionX - leftwards * directionY, forwards * directionY + leftwards * directionX)
    val corners = corner(-reach, -half) + corner(reach, -half) + corner(reach, half) + corner(-reach, half)
    val body = addBody(TouchKind.WALLS.ordinal, (wall.from.x + wall.to.x) / 2, (wall.from.y + wall.to.y) / 2, 0.0)
    addPolygon(body, corners.toDoubleArray(), Penbot.SHELL_FRICTION)
}

/** Adds a barrier as an immovable body. */
internal fun PhysicsWorld.addBarrier(shape: Shape, trigonometry: Trigonometry) {
    addShape(TouchKind.BARRIERS, shape.outline(trigonometry), shape.centre)
}

/** Adds a block as a body that slides on the floor, with its origin in [Shape.centre]; returns its index. */
internal fun PhysicsWorld.addBlock(block: MovableBlock, trigonometry: Trigonometry): Int {
    val outline = block.shape.outline(trigonometry)
    val body = addShape(TouchKind.BLOCKS, outline, block.shape.centre)
    spreadMass(body, block.mass)
    val force = block.friction * block.mass * Penbot.GRAVITY
    addFloorFriction(body, force, force * DISC_LEVER * sqrt(outline.area / kotlin.math.PI))
    return body
}

private fun PhysicsWorld.addShape(kind: TouchKind, outline: Outline, centre: Point): Int {
    val body = addBody(kind.ordinal, centre.x, centre.y, 0.0)
    when (outline) {
        is Outline.Round -> addCircle(body, 0.0, 0.0, outline.radius, Penbot.SHELL_FRICTION)

        is Outline.Angular -> addPolygon(
            body,
            outline.corners.flatMap {
                listOf(it.x - centre.x, it.y - centre.y)
            }.toDoubleArray(),
            Penbot.SHELL_FRICTION,
        )
    }
    return body
}

private val Outline.area: Double
    get() = when (this) {
        is Outline.Round -> kotlin.math.PI * radius * radius
        is Outline.Angular -> signedArea(corners) / 2
    }

/** The lever arm of the friction under a rotating disc, relative to its radius. */
private const val DISC_LEVER = 2.0 / 3.0

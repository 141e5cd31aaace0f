package robotran.ui.sheet3d

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Brush
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.withTransform
import robotran.scene3d.camera.Projection
import robotran.scene3d.geometry.ConvexPolygon
import robotran.simulation.state.SessionState
import robotran.ui.sheet.GLOW_STOPS
import robotran.ui.sheet.movedCorners
import robotran.ui.sheet.reachOf
import robotran.ui.sheet.robotOutlines
import robotran.ui.sheet.shadowOf
import robotran.ui.sheet.towards
import robotran.uikit.*
import robotran.world.Lamp
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.RADIANS_PER_DEGREE
import kotlin.math.PI

/** The shadows of robots and blocks in the light of the lamps, and the light of the lamps on robots. */
internal fun DrawScope.drawLampShadows(world: World, state: SessionState, projection: Projection) {
    val things = robotOutlines(world, state) +
        world.blocks.zip(state.blocks) { block, moved -> block.shape.movedCorners(moved) }
    for ((lamp, now) in world.lamps.zip(state.lamps)) {
        if (!now.on || lamp.infrared || lamp.brightness <= 0) continue
        val reach = reachOf(lamp.brightness)
        for (part in LIT_PARTS) {
            val highlighted = litCorners(lamp, now.place, reach * part)
            val path = Path()
            for (thing in things) {
                val shadow = shadowOf(thing, now.place, reach)?.let { ConvexPolygon.around(it) } ?: continue
                within(shadow, highlighted)?.let { path.addGround(it.corners, projection) }
            }
            drawPath(path, SpaceColours.LAMP_SHADOW)
        }
    }
    for ((robot, now) in world.robots.zip(state.robots)) {
        if (robot.beacon > 0) drawBeaconLight(now.robot.pose, reachOf(robot.beacon), projection)
    }
}

/** A round light on the paper around a robot, in perspective. */
private fun DrawScope.drawBeaconLight(pose: Pose, reach: Double, projection: Projection) {
    val radius = reach.toFloat()
    val light = Brush.radialGradient(
        *GLOW_STOPS,
        center = Offset.Zero,
        radius = radius,
    )
    withTransform({ transform(projection.groundMatrix(pose.x, pose.y)) }) {
        drawRect(light, Offset(-radius, -radius), Size(2 * radius, 2 * radius))
    }
}

/** A circle around [point], or the cone of [lamp] in it: a polygon that is convex if the cone is at most half a turn. */
private fun litCorners(lamp: Lamp, point: Point, reach: Double): ConvexPolygon {
    if (lamp.cone >= HALF_TURN) return ConvexPolygon(circle(point, reach))
    val first = (lamp.direction - lamp.cone / 2) * RADIANS_PER_DEGREE
    val span = lamp.cone * RADIANS_PER_DEGREE
    return ConvexPolygon(
        listOf(point) + List(CIRCLE_CORNERS) { point.towards(first + span * it / (CIRCLE_CORNERS - 1), reach) },
    )
}

/** The part of [polygon] in [area]. */
private fun within(polygon: ConvexPolygon, area: ConvexPolygon): ConvexPolygon? {
    var rest: ConvexPolygon = polygon
    for (edge in 0 until area.size) {
        val next = (edge + 1) % area.size
        val normalX = area.y(edge) - area.y(next)
        val normalY = area.x(next) - area.x(edge)
        rest = rest.beyond(normalX, normalY, normalX * area.x(edge) + normalY * area.y(edge)) ?: return null
    }
    return rest
}

internal fun circle(point: Point, radius: Double): List<Point> =
    List(CIRCLE_CORNERS) { point.towards(it * 2 * PI / CIRCLE_CORNERS, radius) }

private const val CIRCLE_CORNERS = 32
private const val HALF_TURN = 180.0

/** The light fades outwards, and with it a shadow in it. */
private val LIT_PARTS = listOf(0.75, 0.45)

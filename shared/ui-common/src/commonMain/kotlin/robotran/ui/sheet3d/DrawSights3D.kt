package robotran.ui.sheet3d

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.dp
import robotran.scene3d.camera.Projection
import robotran.scene3d.geometry.Vector3
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SPOT_CENTIMETRES
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.Sight
import robotran.ui.sheet.arc
import robotran.ui.sheet.contacts
import robotran.ui.sheet.sightCorners
import robotran.ui.sheet.sightsOf
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.robot.bumpers

/** What sensors see, on the paper, and the contacts of bumpers. */
internal fun DrawScope.drawSights3D(world: World, state: SessionState, projection: Projection) {
    for ((number, place) in world.robots.withIndex()) {
        val snapshot = state.robots.getOrNull(number) ?: continue
        for (sight in sightsOf(place, snapshot)) {
            val corners = when (sight) {
                is Sight.Spot -> circle(sight.at, SPOT_CENTIMETRES)
                is Sight.Cone -> sightCorners(sight, number, world, state)
            }
            val path = groundPath(corners, projection)
            drawPath(path, SheetColours.SIGHT.copy(alpha = 0.25f))
            drawPath(path, SheetColours.SIGHT.copy(alpha = 0.7f), style = Stroke(1.5.dp.toPx()))
            if (sight is Sight.Cone) drawEcho3D(sight, projection)
        }
        for ((from, to) in contacts(snapshot.robot, place.description.bumpers)) {
            val start = pixel(from, projection) ?: continue
            val end = pixel(to, projection) ?: continue
            drawLine(SheetColours.TOUCH, start, end, 3.dp.toPx(), StrokeCap.Round)
        }
    }
}

/** The arc from which the last echo came; without the parts behind the camera. */
private fun DrawScope.drawEcho3D(cone: Sight.Cone, projection: Projection) {
    val places = cone.arc(cone.heard ?: return).mapNotNull { pixel(it, projection) }
    val path = Path().apply {
        places.forEachIndexed { number, place ->
            if (number == 0) moveTo(place.x, place.y) else lineTo(place.x, place.y)
        }
    }
    drawPath(path, SheetColours.ECHO, style = Stroke(3.dp.toPx(), cap = StrokeCap.Round))
}

private fun pixel(point: Point, projection: Projection): Offset? =
    projection.toScreen(Vector3(point.x, point.y, 0.0))?.toOffset()

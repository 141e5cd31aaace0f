package robotran.ui.sheet3d

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.dp
import robotran.scene3d.camera.Projection
import robotran.scene3d.geometry.Vector3
import robotran.simulation.state.RobotState
import robotran.simulation.state.SessionState
import robotran.ui.sheet.BUMPER_MIDDLE
import robotran.ui.sheet.SPOT_CENTIMETRES
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.ahead
import robotran.ui.sheet.has
import robotran.ui.sheet.sightCone
import robotran.world.LightFacing
import robotran.world.Penbot
import robotran.world.PortSensor
import robotran.world.World

/** What light sensors see, on the paper, and the contacts of bumpers. */
internal fun DrawScope.drawSights3D(world: World, state: SessionState, projection: Projection) {
    for ((number, place) in world.robots.withIndex()) {
        val robot = state.robots.getOrNull(number)?.robot ?: continue
        if (place.has(PortSensor.LIGHT)) {
            val corners = if (place.lightFacing == LightFacing.FORWARD) {
                sightCone(number, world, state)
            } else {
                circle(robot.ahead(Penbot.LIGHT_SENSOR_POSITION, 0.0), SPOT_CENTIMETRES)
            }
            val path = groundPath(corners, projection)
            drawPath(path, SheetColours.SIGHT.copy(alpha = 0.25f))
            drawPath(path, SheetColours.SIGHT.copy(alpha = 0.7f), style = Stroke(1.5.dp.toPx()))
        }
        if (robot.leftBumperPressed) drawContact3D(robot, BUMPER_MIDDLE, projection)
        if (robot.rightBumperPressed) drawContact3D(robot, -BUMPER_MIDDLE, projection)
    }
}

private fun DrawScope.drawContact3D(robot: RobotState, middle: Double, projection: Projection) {
    for (spread in listOf(-1.0, 0.0, 1.0)) {
        val from = pixel(robot, Penbot.BUMPER_FRONT + 0.6, middle + spread * 1.6, projection) ?: continue
        val to = pixel(robot, Penbot.BUMPER_FRONT + 2.4, middle + spread * 2.8, projection) ?: continue
        drawLine(SheetColours.TOUCH, from, to, 3.dp.toPx(), StrokeCap.Round)
    }
}

private fun pixel(robot: RobotState, forwards: Double, leftwards: Double, projection: Projection): Offset? =
    robot.ahead(forwards, leftwards).let { projection.toScreen(Vector3(it.x, it.y, 0.0))?.toOffset() }

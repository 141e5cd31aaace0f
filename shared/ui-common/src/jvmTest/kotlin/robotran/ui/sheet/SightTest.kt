package robotran.ui.sheet

import robotran.brick.controls.MotorPort
import robotran.nxt.state.NxtState
import robotran.simulation.state.RobotSnapshot
import robotran.ui.brick.nxt.NxtScenes
import robotran.world.Facing
import robotran.world.LightFacing
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class SightTest {
    private val snapshot: RobotSnapshot = SheetScenes.state(SheetScenes.everything).robots.first().let {
        it.copy(robot = it.robot.copy(pose = Pose(50.0, 40.0, 90.0)))
    }

    private fun sights(robot: RobotDescription, brick: NxtState? = null, facing: LightFacing? = null): List<Sight> =
        sightsOf(
            RobotPlacement(Pose(0.0, 0.0, 0.0), description = robot, lightFacing = facing),
            if (brick == null) snapshot else snapshot.copy(brick = brick),
        )

    private fun heard(distance: Int) = with(NxtScenes.running) {
        copy(sensorPorts = sensorPorts.map { if (it.distance == null) it else it.copy(distance = distance) })
    }

    @Test
    fun `a penbot sees a spot below its light sensor, or a cone between its bumpers`() {
        val spot = assertIs<Sight.Spot>(sights(ReadyRobots.RCX_PENBOT).single())
        assertEquals(50.0, spot.at.x, NEAR)
        assertEquals(47.2, spot.at.y, NEAR)
        val cone = assertIs<Sight.Cone>(sights(ReadyRobots.RCX_PENBOT, facing = LightFacing.FORWARD).single())
        assertEquals(49.2, cone.eye.y, NEAR)
        assertEquals(90.0, cone.direction)
        assertEquals(false, cone.isSound)
    }

    @Test
    fun `an ultrasonic sensor sees a cone up to what it has heard last`() {
        val cone = sights(ReadyRobots.NXT_PENBOT, heard(45)).filterIsInstance<Sight.Cone>().single()
        assertEquals(45.0, cone.heard)
        assertEquals(48.4, cone.eye.y, NEAR)
        val arc = cone.arc(45.0)
        assertEquals(93.4, arc[arc.size / 2].y, NEAR)
        assertEquals(null, sights(ReadyRobots.NXT_PENBOT, heard(255)).filterIsInstance<Sight.Cone>().single().heard)
    }

    @Test
    fun `each sensor that is plugged in has a sight of its own`() {
        assertEquals(3, sights(ReadyRobots.LINE_FOLLOWER).size)
        val sides = sights(ReadyRobots.BOTH_SIDES).filterIsInstance<Sight.Cone>().map { it.direction }
        assertEquals(listOf(180.0, 0.0), sides)
        val bare = ReadyRobots.NXT_PENBOT.let { robot -> robot.copy(parts = robot.parts.map { it.on(null) }) }
        assertEquals(emptyList(), sights(bare))
    }

    @Test
    fun `a turret turns its ultrasonic sensor, the beam and the plate of its reading`() {
        val sonar = ReadyRobots.NXT_PENBOT.parts.filterIsInstance<SensorPart>().single { it.port == 4 }
        val turning = sonar.copy(at = Point(0.0, 0.0), facing = Facing.Ahead(20.0), turret = MotorPort.B)
        val robot = ReadyRobots.NXT_PENBOT.copy(pen = null, parts = listOf(turning))
        val place = RobotPlacement(Pose(0.0, 0.0, 0.0), description = robot)
        val now = snapshot.copy(robot = snapshot.robot.copy(turret = 70.0), brick = heard(30))
        val cone = assertIs<Sight.Cone>(sightsOf(place, now).single())
        assertEquals(180.0, cone.direction)
        assertEquals(30.0, cone.heard)
        val fixed = robot.copy(parts = listOf(turning.copy(turret = null)))
        assertEquals(110.0, assertIs<Sight.Cone>(sightsOf(place.copy(description = fixed), now).single()).direction)
        val state = SheetScenes.state(SheetScenes.everything).copy(robots = listOf(now))
        val reading = readings(SheetScenes.everything.copy(robots = listOf(place)), state).last()
        assertTrue(reading.place.x < 40.0, "${reading.place}")
        assertEquals("4: 30 cm", reading.text)
    }

    private companion object {
        const val NEAR = 1e-9
    }
}

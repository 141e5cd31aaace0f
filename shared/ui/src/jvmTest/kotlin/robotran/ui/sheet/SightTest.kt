package robotran.ui.sheet

import robotran.nxt.state.NxtState
import robotran.simulation.state.RobotSnapshot
import robotran.ui.brick.nxt.NxtScenes
import robotran.world.LightFacing
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

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

    private companion object {
        const val NEAR = 1e-9
    }
}

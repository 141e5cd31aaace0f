package robotran.ui.learning

import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.math.abs
import kotlin.math.hypot
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNull
import kotlin.test.assertTrue

class WelcomeDriveTest {
    private val corner = listOf(WelcomeCommand.Forward(20), WelcomeCommand.TurnLeft(90))

    @Test
    fun `it takes as long as a penbot takes`() =
        assertEquals(1000L + 450L, WelcomeDrive(Pose(0.0, 0.0, 0.0), corner).duration)

    @Test
    fun `it draws on its way, and turns on the spot`() {
        val drive = WelcomeDrive(Pose(5.0, 5.0, 0.0), corner)
        drive.at(500).run {
            assertEquals(Pose(15.0, 5.0, 0.0), robot.pose)
            assertEquals(corner[0], command)
            assertEquals(listOf(Point(5.0, 5.0), Point(15.0, 5.0)), line)
        }
        drive.at(1225).run {
            assertEquals(Pose(25.0, 5.0, 45.0), robot.pose)
            assertEquals(corner[1], command)
            assertEquals("turn left 90", corner[1].text)
        }
        drive.at(5_000).run {
            assertEquals(90.0, robot.pose.heading)
            assertNull(command)
            assertFalse(robot.penDown)
        }
    }

    @Test
    fun `closed shapes are closed, and all stay on the paper`() {
        for (drive in WelcomeDrive.ALL.take(2)) {
            val line = drive.at(drive.duration).line
            assertTrue(hypot(line.first().x - line.last().x, line.first().y - line.last().y) < 0.01)
        }
        for (drive in WelcomeDrive.ALL) {
            for (time in 0..drive.duration step 50) {
                val pose = drive.at(time).robot.pose
                assertTrue(abs(pose.x - WelcomeDrive.WIDTH / 2) <= WelcomeDrive.WIDTH / 2 - ROOM, "$pose")
                assertTrue(abs(pose.y - WelcomeDrive.HEIGHT / 2) <= WelcomeDrive.HEIGHT / 2 - ROOM, "$pose")
            }
        }
    }

    private companion object {
        /** In centimetres, so that the robot hardly leaves the paper. */
        const val ROOM = 6.0
    }
}

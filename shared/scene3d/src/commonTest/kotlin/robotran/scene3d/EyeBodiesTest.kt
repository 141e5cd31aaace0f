package robotran.scene3d

import robotran.scene3d.geometry.Vector3
import robotran.scene3d.model.Decal
import robotran.scene3d.model.EyeBodies
import robotran.scene3d.model.RobotFace
import robotran.scene3d.model.RobotFace.Lids
import robotran.scene3d.model.Round
import kotlin.math.round
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class EyeBodiesTest {
    private val palette = TEST_COLOURS.robot.copy(eye = WHITE, pupil = DARK)
    private val eyes = EyeBodies(LID, EDGE, palette, Round(TestTrigonometry))

    @Test
    fun `the pupils are in the middle of the eyes until the robot drives`() {
        val (left, right) = middles(RobotFace.STILL, DARK)
        assertEquals(middles(RobotFace.STILL, WHITE), listOf(left, right))
        assertTrue(left.y > 2 && right.y < -2)
    }

    @Test
    fun `the pupils go where it looks`() {
        val still = middles(RobotFace.STILL, DARK)
        val ahead = middles(RobotFace(gazeForwards = 1.0), DARK)
        val back = middles(RobotFace(gazeForwards = -1.0), DARK)
        val right = middles(RobotFace(gazeRightwards = 1.0), DARK)
        for (eye in 0..1) {
            assertTrue(ahead[eye].x > still[eye].x && ahead[eye].z < still[eye].z)
            assertTrue(back[eye].x < still[eye].x && back[eye].z > still[eye].z)
            assertTrue(right[eye].y < still[eye].y - 0.3)
        }
    }

    @Test
    fun `shut eyes have no pupils`() {
        val shut = decals(RobotFace(lids = Lids.SHUT)).flatten()
        assertTrue(shut.none { it.colour == DARK || it.colour == WHITE })
        assertTrue(shut.any { it.colour == LID })
    }

    @Test
    fun `lids hang from above when it sulks, and come up from below when it laughs`() {
        val middle = middles(RobotFace.STILL, DARK)
        val hanging = middles(RobotFace(lids = Lids.HANGING), LID)
        val raised = middles(RobotFace(lids = Lids.RAISED), LID)
        for (eye in 0..1) {
            assertTrue(hanging[eye].z > middle[eye].z + 0.1)
            assertTrue(raised[eye].z < middle[eye].z - 0.1)
        }
        // Most at the outer sides of the face.
        assertTrue(hanging[0].y > middle[0].y && hanging[1].y < middle[1].y)
    }

    /** The middle of what has [colour] in the left and the right eye. */
    private fun middles(face: RobotFace, colour: Int): List<Vector3> = decals(face).map { decals ->
        val corners = decals.first { it.colour == colour && !it.fine }.shapes.first()
        val count = corners.size / 3

        fun mean(axis: Int) = (0 until count).sumOf { corners[3 * it + axis] } / count
        Vector3(rounded(mean(0)), rounded(mean(1)), rounded(mean(2)))
    }

    private fun rounded(value: Double) = round(value * 1e6) / 1e6

    private fun decals(face: RobotFace): List<List<Decal>> = eyes.of(face).map { it.faces.first().decals }

    private companion object {
        const val WHITE = 1
        const val DARK = 2
        const val LID = 3
        const val EDGE = 4
    }
}

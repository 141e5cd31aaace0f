package robotran.scene3d

import robotran.scene3d.camera.Projection
import robotran.scene3d.camera.ScreenPoint
import robotran.scene3d.geometry.Vector3
import robotran.world.Paper
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.math.abs
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class ProjectionTest {
    private val paper = Paper(120.0, 80.0)

    @Test
    fun `a pixel leads back to the point of the paper that it shows`() = everyCamera { camera, random ->
        val point = Vector3(random.nextDouble(120.0), random.nextDouble(80.0), random.nextDouble(10.0))
        val pixel = camera.toScreen(point) ?: return@everyCamera
        val back = assertNotNull(camera.onPlane(pixel, point.z))
        assertClose(point.x, back.x)
        assertClose(point.y, back.y)
    }

    @Test
    fun `the matrix of the paper agrees with the projection of its points`() = everyCamera { camera, random ->
        val x = random.nextDouble(120.0)
        val y = random.nextDouble(80.0)
        val pixel = camera.toScreen(Vector3(x, y, 0.0)) ?: return@everyCamera
        val m = camera.paperMatrix()
        val w = m[6] * x + m[7] * y + m[8]
        assertClose(pixel.x, (m[0] * x + m[1] * y + m[2]) / w)
        assertClose(pixel.y, (m[3] * x + m[4] * y + m[5]) / w)
    }

    @Test
    fun `with a zoom of 1 all of the paper is in the window, from every side and on every screen`() {
        val random = Random(3)
        repeat(300) {
            val width = random.nextDouble(200.0, 1600.0)
            val height = random.nextDouble(200.0, 1200.0)
            val camera = camerasOf(width, height)
                .around(paper, Point(60.0, 40.0), random.nextDouble(360.0), random.nextDouble(8.0, 65.0), 1.0)
            for (x in listOf(0.0, 120.0)) {
                for (y in listOf(0.0, 80.0)) {
                    val pixel = assertNotNull(camera.toScreen(Vector3(x, y, 0.0)))
                    assertTrue(pixel.x in 0.0..width && pixel.y in 0.0..height, "$pixel in $width by $height")
                }
            }
        }
    }

    @Test
    fun `a pane without width has a camera, too`() {
        val camera = camerasOf(0.0, 900.0).around(paper, Point(60.0, 40.0), 90.0, 46.0, 1.0)
        assertTrue(camera.view.eye.z > 0)
    }

    @Test
    fun `no picture shows what is behind the foot of its camera`() = everyCamera { camera, random ->
        val lowest = ScreenPoint(random.nextDouble(camera.size.width), camera.size.height)
        assertTrue(camera.rayThrough(lowest).dot(camera.view.ahead) > 0)
    }

    @Test
    fun `the sky shows no point of the paper`() {
        val eye = camerasOf().eyeOf(Pose(60.0, 40.0, 0.0))
        assertNull(eye.onPlane(ScreenPoint(320.0, 10.0)))
        assertNotNull(eye.onPlane(ScreenPoint(320.0, 470.0)))
    }

    @Test
    fun `what is cut off in front of the camera stays in the picture`() {
        val eye = camerasOf().eyeOf(Pose(60.0, 40.0, 0.0))
        val floor = doubleArrayOf(0.0, 0.0, 0.0, 120.0, 0.0, 0.0, 120.0, 80.0, 0.0, 0.0, 80.0, 0.0)
        val seen = assertNotNull(eye.polygon(floor))
        assertTrue(seen.all { it.isFinite() })
        assertTrue((1 until seen.size step 2).all { seen[it] > eye.horizon - 1 }, "above the horizon")
        val behind = doubleArrayOf(0.0, 0.0, 0.0, 10.0, 0.0, 0.0, 10.0, 80.0, 0.0)
        assertNull(eye.polygon(behind))
    }

    private fun everyCamera(check: (Projection, Random) -> Unit) {
        val random = Random(1)
        repeat(300) {
            val cameras = camerasOf(random.nextDouble(200.0, 1600.0), random.nextDouble(200.0, 1200.0))
            val pose = Pose(random.nextDouble(120.0), random.nextDouble(80.0), random.nextDouble(360.0))
            val camera = when (it % 3) {
                0 -> cameras.around(
                    paper,
                    Point(pose.x, pose.y),
                    pose.heading,
                    random.nextDouble(90.0),
                    random.nextDouble(1.0, 20.0),
                )

                1 -> cameras.behind(pose, pose.heading, random.nextDouble(90.0), random.nextDouble(0.5, 4.0))
                else -> cameras.eyeOf(pose)
            }
            check(camera, random)
        }
    }

    private fun assertClose(expected: Double, actual: Double) =
        assertEquals(0.0, abs(expected - actual), 1e-6 * (1 + abs(expected)))
}

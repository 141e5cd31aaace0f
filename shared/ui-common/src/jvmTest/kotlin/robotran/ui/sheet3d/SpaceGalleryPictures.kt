package robotran.ui.sheet3d

import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.unit.IntSize
import robotran.scene3d.camera.Cameras
import robotran.scene3d.camera.Projection
import robotran.ui.pictures.pngOf
import robotran.ui.sheet.SheetScenes
import robotran.uikit.*
import robotran.world.geometry.Point
import java.io.File
import kotlin.test.Test
import kotlin.test.assertTrue

/** Pictures for review, in `build/pictures/space`. */
class SpaceGalleryPictures {
    private val folder = File("build/pictures/space").apply { mkdirs() }
    private val world = SheetScenes.everything
    private val state = SheetScenes.everythingLater

    @Test
    fun `everything is drawn from all sides, by day and by night`() {
        keep("above", render { it.around(world.paper, Point(60.0, 45.0), 90.0, 48.0, 1.0) })
        keep(
            "night",
            render(SpaceColours.of(RobotranColours.DARK)) {
                it.around(world.paper, Point(60.0, 45.0), 60.0, 35.0, 1.0)
            },
        )
        keep(
            "contrast",
            render(SpaceColours.of(RobotranColours.HIGH_CONTRAST)) {
                it.around(world.paper, Point(60.0, 45.0), 120.0, 30.0, 1.3)
            },
        )
        keep("near", render { it.around(world.paper, Point(28.0, 24.0), 130.0, 30.0, 3.0) })
        keep("behind", render { it.behind(state.robot.pose, state.robot.pose.heading, 24.0, 1.0) })
        keep("eye", render(eyeOf = 0) { it.eyeOf(state.robot.pose) })
        keep("robot", render { it.around(world.paper, Point(93.0, 62.0), 100.0, 28.0, 4.5) })
        keep("face", render { it.around(world.paper, Point(90.0, 66.0), 300.0, 28.0, 5.0) })
        keep("rear", render { it.around(world.paper, Point(25.0, 23.0), 20.0, 35.0, 4.5) })
    }

    private fun render(
        colours: SpaceColours = SpaceColours.LIGHT,
        eyeOf: Int? = null,
        camera: (Cameras) -> Projection,
    ): ImageBitmap = renderSpace(world, state, IntSize(1280, 800), colours, eyeOf = eyeOf, camera = camera)

    private fun keep(name: String, picture: ImageBitmap) {
        File(folder, "$name.png").writeBytes(pngOf(picture))
        val pixels = IntArray(picture.width * picture.height).also(picture::readPixels)
        assertTrue(pixels.toSet().size > 200, "$name is next to empty")
    }
}

package robotran.ui.sheet3d

import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.IntSize
import androidx.compose.ui.unit.LayoutDirection
import androidx.compose.ui.unit.toSize
import robotran.scene3d.camera.Cameras
import robotran.scene3d.camera.PictureSize
import robotran.scene3d.camera.PictureWindow
import robotran.scene3d.camera.Projection
import robotran.simulation.state.SessionState
import robotran.workshop.state.SheetLayer
import robotran.world.World

/**
 * Renders the 3D view off screen.
 *
 * @param eyeOf the robot whose eye the camera is; null for none.
 * @param camera chooses one of those that fit the picture.
 */
internal fun renderSpace(
    world: World,
    state: SessionState,
    pixels: IntSize,
    colours: SpaceColours = SpaceColours.LIGHT,
    shown: Set<SheetLayer> = SheetLayer.DEFAULT,
    labels: TextMeasurer? = null,
    eyeOf: Int? = null,
    camera: (Cameras) -> Projection,
): ImageBitmap {
    val size = PictureSize(pixels.width.toDouble(), pixels.height.toDouble())
    val projection = camera(Cameras(PictureWindow(0.0, 0.0, size.width, size.height, size), ScreenTrigonometry))
    val drawing = SpaceDrawing(world, colours)
    val image = ImageBitmap(pixels.width, pixels.height)
    val area = pixels.toSize()
    CanvasDrawScope().draw(Density(1f), LayoutDirection.Ltr, Canvas(image), area) {
        val scene = drawing.scene(state, shown, projection, eyeOf)
        drawSpace(drawing, scene, state, projection, shown, labels)
    }
    return image
}

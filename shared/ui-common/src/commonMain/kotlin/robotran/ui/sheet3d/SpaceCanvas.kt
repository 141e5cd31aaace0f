package robotran.ui.sheet3d

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxScope
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.runtime.Composable
import androidx.compose.runtime.SideEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.DpRect
import robotran.scene3d.camera.Cameras
import robotran.scene3d.camera.PictureSize
import robotran.scene3d.camera.PictureWindow
import robotran.scene3d.camera.Projection
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SheetTouch
import robotran.ui.sheet.ShownWorld
import robotran.uikit.*
import robotran.workshop.state.CameraKind
import robotran.workshop.state.SheetViewState
import robotran.workshop.state.SpaceCamera
import robotran.world.World

/**
 * A world in perspective that reacts to touch, mouse, wheel and keys like [robotran.ui.sheet.SheetCanvas]; only that a
 * finger on no element goes around the paper.
 *
 * @param onGround draws on the paper, below all that stands there; [overlay] over everything.
 * @param content composables over the picture, such as focusable elements.
 */
@Composable
fun SpaceCanvas(
    shown: ShownWorld,
    onCamera: (SpaceCamera) -> Unit,
    aside: DpRect,
    modifier: Modifier = Modifier,
    touch: SheetTouch? = null,
    onGround: DrawScope.(Projection) -> Unit = {},
    overlay: DrawScope.(Projection) -> Unit = {},
    content: @Composable BoxScope.(Projection, SpaceLook) -> Unit = { _, _ -> },
) {
    val world = shown.world
    val view = shown.view
    val theme = LocalRobotranColours.current
    val drawing = remember(world, theme) { SpaceDrawing(world, SpaceColours.of(theme)) }
    val isStill = LocalLessMotion.current
    val labels = rememberTextMeasurer(LABELS_REMEMBERED)
    val look = remember { SpaceLook() }
    val chase = remember(world, view.cameraKind, view.spaceCamera.robot) { ChaseHeading() }
    val fingers by rememberUpdatedState(touch)
    BoxWithConstraints(
        modifier
            .clipToBounds()
            .onKeyEvent { look.onKey(it) }
            .pointerInput(look) { spaceGestures(look) { fingers } },
    ) {
        val density = LocalDensity.current
        val cameras = remember(constraints.maxWidth, constraints.maxHeight, aside, density) {
            Cameras(windowOf(constraints.maxWidth, constraints.maxHeight, aside, density), ScreenTrigonometry)
        }
        val projection = projectionOf(view, shown.session, world, cameras, chase)
        val eye = view.spaceCamera.robot.takeIf { view.cameraKind == CameraKind.ROBOT_EYE }
        val scene = drawing.scene(shown.drawn, view.shown, projection, eye, isStill)
        SideEffect { look.show(view.spaceCamera, view.cameraKind, world.paper, cameras, projection, scene, onCamera) }
        Canvas(Modifier.matchParentSize()) {
            drawSpace(drawing, scene, shown.drawn, projection, view.shown, labels) { onGround(projection) }
            overlay(projection)
        }
        Box(Modifier.matchParentSize()) { content(projection, look) }
    }
}

private fun windowOf(width: Int, height: Int, aside: DpRect, density: Density): PictureWindow = with(density) {
    PictureWindow(
        aside.left.toPx().toDouble(),
        aside.top.toPx().toDouble(),
        width - aside.right.toPx().toDouble(),
        height - aside.bottom.toPx().toDouble(),
        PictureSize(width.toDouble(), height.toDouble()),
    )
}

private fun projectionOf(
    view: SheetViewState,
    session: SessionState,
    world: World,
    cameras: Cameras,
    chase: ChaseHeading,
): Projection {
    val camera = view.spaceCamera
    val pose = (session.robots.getOrNull(camera.robot) ?: session.robots.first()).robot.pose
    return when (view.cameraKind) {
        CameraKind.ORBIT -> cameras.of(camera, world.paper)

        CameraKind.FOLLOW -> cameras.behind(
            pose,
            chase.at(pose.heading, session.milliseconds) + camera.turn,
            camera.pitch - FOLLOWING_PITCH,
            camera.zoom,
        )

        CameraKind.ROBOT_EYE -> cameras.eyeOf(pose)
    }
}

private const val LABELS_REMEMBERED = 64

/** How much flatter, in degrees, a camera behind a robot looks than one around the paper. */
private const val FOLLOWING_PITCH = 16.0

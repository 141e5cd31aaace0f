package robotran.scene3d

import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.messages.BrickMessages
import robotran.scene3d.camera.Cameras
import robotran.scene3d.camera.PictureSize
import robotran.scene3d.camera.PictureWindow
import robotran.scene3d.model.RobotPalette
import robotran.scene3d.model.SceneColours
import robotran.simulation.state.Ink
import robotran.simulation.state.LampState
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.RobotState
import robotran.simulation.state.SessionState
import robotran.world.World
import robotran.world.geometry.Pose
import robotran.world.geometry.Trigonometry
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin

/** Any angle functions do for a picture. */
internal object TestTrigonometry : Trigonometry {
    override fun sine(angle: Double) = sin(angle)

    override fun cosine(angle: Double) = cos(angle)

    override fun angle(x: Double, y: Double) = atan2(y, x)
}

internal val TEST_COLOURS: SceneColours = run {
    val grey = 0xFF808080.toInt()
    val palette = RobotPalette(
        { grey },
        { grey },
        { grey },
        grey,
        grey,
        grey,
        grey,
        grey,
        grey,
        grey,
        grey,
        grey,
        grey,
        grey,
        grey,
        List(4) { grey },
        grey,
        grey,
        grey,
    )
    SceneColours(grey, grey, grey, grey, grey, grey, grey, grey, grey, grey, grey, grey, grey, grey, palette)
}

/** A session at rest. */
internal fun restingState(
    world: World,
    robots: List<RobotState> = world.robots.map { RobotState(it.start, 0.0, 0.0, false, false, false) },
    blocks: List<Pose> = world.blocks.map { Pose(0.0, 0.0, 0.0) },
) = SessionState(
    milliseconds = 0,
    robots = robots.map {
        RobotSnapshot(RcxBrick(emptyList(), messages = BrickMessages.of(Language.ENGLISH)).state, it, 0, emptyList(), 0)
    },
    blocks = blocks,
    lamps = world.lamps.map { LampState(it.place, it.on) },
    ink = Ink.NONE,
    goals = emptyList(),
)

/** The cameras of a picture of this size, of which nothing is covered. */
internal fun camerasOf(width: Double = 640.0, height: Double = 480.0) =
    Cameras(PictureWindow(0.0, 0.0, width, height, PictureSize(width, height)), TestTrigonometry)

package robotran.benchmarks

import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.unit.Density
import kotlinx.coroutines.runBlocking
import org.jetbrains.skiko.MainUIDispatcher
import robotran.programs.Program
import robotran.projects.ProgramView
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.simulation.physics.loadPhysicsEngine
import robotran.ui.RobotranApp
import robotran.ui.theme.RobotranTheme
import robotran.ui.world.WorldView
import robotran.workshop.Workshop
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.state.CameraKind
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.SheetCamera
import robotran.workshop.state.SpaceCamera
import robotran.world.geometry.Point
import javax.swing.SwingUtilities
import kotlin.time.Duration
import kotlin.time.DurationUnit
import kotlin.time.measureTime

/** The UI benchmarks, which run on the JVM only. */
internal val SCREEN_BENCHMARKS: Map<String, suspend () -> Measurement> =
    mapOf(
        "frames" to { onEventThread { frameTime(DrawerTab.CHART, DrawerTab.LOG) } },
        "frames-log" to { onEventThread { frameTime(DrawerTab.LOG) } },
        "frames-chart" to { onEventThread { frameTime(DrawerTab.CHART) } },
        "sheet-2d" to { onEventThread { viewTime(null) } },
        "sheet-2d-near" to { onEventThread { viewTime(null, zoom = 4.0) } },
        "sheet-2d-pushed" to { onEventThread { viewTime(null, zoom = 4.0, isPushed = true) } },
        "sheet-3d" to { onEventThread { viewTime(CameraKind.ORBIT) } },
        "sheet-3d-follow" to { onEventThread { viewTime(CameraKind.FOLLOW) } },
        "sheet-3d-eye" to { onEventThread { viewTime(CameraKind.ROBOT_EYE) } },
        "keystroke" to { onEventThread(::keystrokeTime) },
        "block-drag" to { onEventThread(::blockDragTime) },
        "block-scroll" to { onEventThread { scrollTime(ProgramView.BLOCKS) } },
        "moving-picture" to { movingPictureTime(faster = 1) },
        "moving-picture-4" to { movingPictureTime(faster = 4) },
        "text-scroll" to { onEventThread { scrollTime(ProgramView.TEXT) } },
    )

/** The UI dispatches its work to the event thread; drawn on another thread, it may block forever. */
private fun onEventThread(measure: suspend () -> Measurement): Measurement {
    var figure: Measurement? = null
    SwingUtilities.invokeAndWait { figure = runBlocking { measure() } }
    return checkNotNull(figure)
}

/**
 * The time to simulate a sixtieth of a second in the crowded world and to draw the whole screen of a tablet with [tab]
 * of the drawer open, and [beside] next to it. Renders in software on one core.
 */
private suspend fun frameTime(tab: DrawerTab, beside: DrawerTab? = null): Measurement {
    val workshop = Workshop(heavyProject(), loadPhysicsEngine())
    workshop.handle(RunEvent.RunPressed)
    workshop.advance(EARLIER_MILLISECONDS)
    workshop.handle(RunEvent.DrawerChosen(tab))
    workshop.handle(RunEvent.DrawerBesideChosen(beside))
    val scene = ImageComposeScene(WIDTH, HEIGHT, Density(1f), MainUIDispatcher) { RobotranApp(workshop, dark = false) }
    val times = List(WARMING_FRAMES + FRAMES) { frame ->
        measureTime { scene.render(frame * FRAME_NANOSECONDS) }
    }.drop(WARMING_FRAMES).sorted()
    val calls = workshop.state.session.robots.sumOf { it.romCalls }
    scene.close()
    workshop.close()
    val note =
        "99th percentile ${milliseconds(times[FRAMES * 99 / 100])} ms; $WIDTH by $HEIGHT, software rendering, $calls " +
            "ROM calls"
    return Measurement(times[FRAMES / 2].toDouble(DurationUnit.MILLISECONDS), "ms a frame, the median", note)
}

/**
 * The time to draw the world alone, on a screen of a tablet, while the crowded world runs: in 3D with the camera
 * [kind], or as the sheet for null, [zoom] times as large as all of it. A camera around the paper turns all the time;
 * a sheet that [isPushed] moves all the time.
 */
private suspend fun viewTime(kind: CameraKind?, zoom: Double = 1.0, isPushed: Boolean = false): Measurement {
    val workshop = Workshop(heavyProject(), loadPhysicsEngine())
    workshop.handle(RunEvent.RunPressed)
    workshop.advance(EARLIER_MILLISECONDS)
    workshop.handle(SheetEvent.SpaceSwitched(kind != null))
    if (kind != null) workshop.handle(SheetEvent.CameraKindChosen(kind, 0))
    val middle = workshop.state.world.paper.let { Point(it.width / 2, it.height / 2) }
    if (kind == null) workshop.handle(SheetEvent.CameraMoved(SheetCamera(zoom, middle), pushed = false))
    val scene = ImageComposeScene(WIDTH, HEIGHT, Density(1f), MainUIDispatcher) {
        RobotranTheme(dark = false) {
            val state = workshop.state
            WorldView(state.world, state.run.drawn, state.sheet, workshop::handle)
        }
    }
    val times = List(WARMING_FRAMES + FRAMES) { frame ->
        workshop.advance(if (frame % 3 == 0) 16 else 17)
        if (kind == CameraKind.ORBIT) workshop.handle(SheetEvent.SpaceCameraMoved(SpaceCamera(heading = frame * 0.5)))
        if (isPushed) {
            val place = middle.copy(x = middle.x + frame % PUSHED_FRAMES * PUSHED_CENTIMETRES)
            workshop.handle(SheetEvent.CameraMoved(SheetCamera(zoom, place), pushed = true))
        }
        measureTime { scene.render(frame * FRAME_NANOSECONDS).close() }
    }.drop(WARMING_FRAMES).sorted()
    scene.close()
    workshop.close()
    val note =
        "99th percentile ${milliseconds(
            times[FRAMES * 99 / 100],
        )} ms; $WIDTH by $HEIGHT, software rendering, the world " +
            "alone"
    return Measurement(times[FRAMES / 2].toDouble(DurationUnit.MILLISECONDS), "ms a frame, the median", note)
}

private fun heavyProject(): Project {
    val world = heavyWorld()
    val program = ProjectProgram(Program.of("drive.robo", PROGRAM))
    return Project(world, world.robots.map { ProjectRobot(it.name, listOf(program)) })
}

private fun milliseconds(time: Duration): String = rounded(time.toDouble(DurationUnit.MILLISECONDS))

private const val WIDTH = 1280
private const val HEIGHT = 800

/** The virtual time simulated before, so that log and chart have content. */
private const val EARLIER_MILLISECONDS = 20_000
private const val WARMING_FRAMES = 300
private const val FRAMES = 600
private const val FRAME_NANOSECONDS = 16_666_667L

/** A sheet is pushed that far in a frame, for so many frames, and then again from the beginning. */
private const val PUSHED_CENTIMETRES = 0.3
private const val PUSHED_FRAMES = 100

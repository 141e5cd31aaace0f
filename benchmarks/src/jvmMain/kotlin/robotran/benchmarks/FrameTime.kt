package robotran.benchmarks

import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.unit.Density
import kotlinx.coroutines.runBlocking
import robotran.language.ProgramLanguage
import robotran.programs.SourceFile
import robotran.projects.ProgramView
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.simulation.physics.loadPhysicsEngine
import robotran.ui.RobotranApp
import robotran.workshop.Workshop
import robotran.workshop.event.RunEvent
import robotran.workshop.state.DrawerTab
import javax.swing.SwingUtilities
import kotlin.time.Duration
import kotlin.time.DurationUnit
import kotlin.time.measureTime

/** The UI benchmarks, which run on the JVM only. */
internal val SCREEN_BENCHMARKS: Map<String, suspend () -> Figure> =
    mapOf(
        "frames" to { onEventThread { frameTime(DrawerTab.CHART, DrawerTab.LOG) } },
        "frames-log" to { onEventThread { frameTime(DrawerTab.LOG) } },
        "frames-chart" to { onEventThread { frameTime(DrawerTab.CHART) } },
        "keystroke" to { onEventThread(::keystrokeTime) },
        "block-drag" to { onEventThread(::blockDragTime) },
        "block-scroll" to { onEventThread { scrollTime(ProgramView.BLOCKS) } },
        "moving-picture" to { movingPictureTime(faster = 1) },
        "moving-picture-4" to { movingPictureTime(faster = 4) },
        "text-scroll" to { onEventThread { scrollTime(ProgramView.TEXT) } },
    )

/** The UI dispatches its work to the event thread; drawn on another thread, it may block forever. */
private fun onEventThread(measure: suspend () -> Figure): Figure {
    var figure: Figure? = null
    SwingUtilities.invokeAndWait { figure = runBlocking { measure() } }
    return checkNotNull(figure)
}

/**
 * The time to simulate a sixtieth of a second in the crowded world and to draw the whole screen of a tablet with [tab]
 * of the drawer open, and [beside] next to it. Renders in software on one core.
 */
private suspend fun frameTime(tab: DrawerTab, beside: DrawerTab? = null): Figure {
    val workshop = Workshop(heavyProject(), loadPhysicsEngine())
    workshop.handle(RunEvent.RunPressed)
    workshop.advance(EARLIER_MILLISECONDS)
    workshop.handle(RunEvent.DrawerChosen(tab))
    workshop.handle(RunEvent.DrawerBesideChosen(beside))
    val scene = ImageComposeScene(WIDTH, HEIGHT, Density(1f)) { RobotranApp(workshop, dark = false) }
    val times = List(WARMING_FRAMES + FRAMES) { frame ->
        measureTime { scene.render(frame * FRAME_NANOSECONDS) }
    }.drop(WARMING_FRAMES).sorted()
    val calls = workshop.state.session.robots.sumOf { it.romCalls }
    scene.close()
    workshop.close()
    val note =
        "99th percentile ${milliseconds(times[FRAMES * 99 / 100])} ms; $WIDTH by $HEIGHT, software rendering, $calls " +
            "ROM calls"
    return Figure(times[FRAMES / 2].toDouble(DurationUnit.MILLISECONDS), "ms a frame, the median", note)
}

private fun heavyProject(): Project {
    val world = heavyWorld()
    val program = ProjectProgram("drive.robo", ProgramLanguage.ROBOLANG, listOf(SourceFile("drive.robo", PROGRAM)))
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

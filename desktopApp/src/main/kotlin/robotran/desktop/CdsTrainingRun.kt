package robotran.desktop

import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.unit.Density
import kotlinx.coroutines.runBlocking
import org.jetbrains.skiko.MainUIDispatcher
import robotran.ui.RobotranWindow
import robotran.workshop.openWorkshop
import javax.swing.SwingUtilities

/**
 * Runs the app's start-up without a display for `java -XX:ArchiveClassesAtExit`. Later starts load these classes from
 * the archive (docs/building.md).
 */
internal object CdsTrainingRun {
    @JvmStatic
    fun main(arguments: Array<String>) {
        System.setProperty("java.awt.headless", "true")
        // The UI dispatches its work to the event thread; drawn on another thread, it may block forever.
        SwingUtilities.invokeAndWait(::draw)
        for (name in NEEDS_DISPLAY) Class.forName(name, false, CdsTrainingRun::class.java.classLoader)
    }

    private fun draw() {
        val workshop = runBlocking { openWorkshop() }
        val scene = ImageComposeScene(WIDTH, HEIGHT, Density(1f), MainUIDispatcher) { RobotranWindow(workshop) }
        repeat(FRAMES) { scene.render(nanoTime = it * FRAME_NANOSECONDS) }
        scene.close()
        workshop.close()
    }

    private const val WIDTH = 1280
    private const val HEIGHT = 840
    private const val FRAMES = 5
    private const val FRAME_NANOSECONDS = 16_000_000L

    /** Classes of the start-up that need a display. */
    val NEEDS_DISPLAY =
        listOf(
            "androidx.compose.ui.awt.ComposeWindow",
            "androidx.compose.ui.awt.ComposeWindowPanel",
            "androidx.compose.ui.window.Window_desktopKt",
            "androidx.compose.ui.window.Application_desktopKt",
            "androidx.compose.ui.window.Menu_desktopKt",
            "org.jetbrains.skiko.SkiaLayer",
            "org.jetbrains.skiko.redrawer.LinuxOpenGLRedrawer",
            "robotran.desktop.window.AppWindowKt",
            "robotran.desktop.window.ShowWindowsKt",
            "robotran.desktop.platform.DesktopPlatform",
            "robotran.cli.CommandLine",
        )
}

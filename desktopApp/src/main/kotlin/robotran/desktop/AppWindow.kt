package robotran.desktop

import androidx.compose.runtime.remember
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import androidx.compose.ui.window.Window
import androidx.compose.ui.window.application
import androidx.compose.ui.window.rememberWindowState
import robotran.desktop.sound.soundCardSpeaker
import robotran.ui.RobotranStart
import robotran.ui.brick.BrickIcon
import robotran.ui.platform.MemoryPlatform
import robotran.ui.workshop.PupilProgram
import java.awt.Dimension
import java.awt.Toolkit

/** Shows the window with [programs], or without any the square, and returns when it is closed. */
internal fun showWindow(programs: List<PupilProgram>) {
    application(exitProcessOnExit = false) {
        val state = rememberWindowState(size = remember { firstSize() })
        Window(onCloseRequest = ::exitApplication, state = state, title = "Robotran", icon = remember { BrickIcon() }) {
            window.minimumSize = Dimension(LEAST_WIDTH, LEAST_HEIGHT)
            RobotranStart(programs, remember { MemoryPlatform(soundCardSpeaker()) })
        }
    }
}

/** A laptop's window, but never larger than the screen it opens on. */
private fun firstSize(): DpSize {
    val screen = Toolkit.getDefaultToolkit().screenSize
    return DpSize(minOf(1280, screen.width).dp, minOf(840, screen.height).dp)
}

/** In this size the screen is laid out as on a phone. */
private const val LEAST_WIDTH = 360
private const val LEAST_HEIGHT = 560

package robotran.desktop.platform

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import java.awt.Toolkit
import java.io.IOException
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/**
 * Whether the desktop is told to move less. Linux tells it while the app runs, macOS and Windows are asked once, by
 * commands that each of their versions has, since Java does not ask them.
 */
internal object SystemMotion {
    var isReduced: Boolean by mutableStateOf(false)
        private set

    init {
        val toolkit = Toolkit.getDefaultToolkit()
        toolkit.addPropertyChangeListener(GTK_ANIMATIONS) { isReduced = it.newValue == 0 }
        isReduced = toolkit.getDesktopProperty(GTK_ANIMATIONS) == 0
        val system = System.getProperty("os.name")
        when {
            system.startsWith("Mac") -> ask(MAC_COMMAND, ::isReducedOnMac)
            system.startsWith("Windows") -> ask(WINDOWS_COMMAND, ::isReducedOnWindows)
        }
    }

    private fun ask(command: List<String>, isReducedBy: (String) -> Boolean) {
        thread(isDaemon = true, name = "reduced motion") { isReduced = isReducedBy(answerOf(command)) }
    }

    /** What [command] writes; empty if there is no such command. */
    private fun answerOf(command: List<String>): String = try {
        val process = ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start()
        process.outputStream.close()
        if (process.waitFor(SECONDS, TimeUnit.SECONDS)) {
            process.inputStream.bufferedReader().readText()
        } else {
            process.destroy()
            ""
        }
    } catch (_: IOException) {
        ""
    }

    private const val SECONDS = 5L

    /** 0 or 1, from the settings daemon of the desktop. */
    private const val GTK_ANIMATIONS = "gnome.Gtk/EnableAnimations"
}

/** "Reduce motion" is on if [answer], of `defaults`, is 1. It says nothing if nobody has touched the switch. */
internal fun isReducedOnMac(answer: String): Boolean = answer.trim() == "1"

/**
 * "Animation effects" are off if the second bit of the fifth byte is 0, which Windows calls client area animation.
 * [answer], of `reg`, has the bytes in hexadecimal digits after the type.
 */
internal fun isReducedOnWindows(answer: String): Boolean {
    val bytes = answer.substringAfter("REG_BINARY", "").trim().takeWhile { it.isLetterOrDigit() }
    val fifth = bytes.drop(FIFTH_BYTE).take(2).toIntOrNull(radix = 16) ?: return false
    return fifth and CLIENT_AREA_ANIMATION == 0
}

private const val FIFTH_BYTE = 8
private const val CLIENT_AREA_ANIMATION = 0x02
private val MAC_COMMAND = listOf("defaults", "read", "com.apple.universalaccess", "reduceMotion")
private val WINDOWS_COMMAND = listOf("reg", "query", "HKCU\\Control Panel\\Desktop", "/v", "UserPreferencesMask")

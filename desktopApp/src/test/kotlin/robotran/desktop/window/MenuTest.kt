package robotran.desktop.window

import org.junit.jupiter.api.Assumptions.assumeTrue
import java.io.File
import java.util.concurrent.TimeUnit
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests the window's menu in a real window, on the current display or on Xvfb. Skipped without either. */
class MenuTest {
    private var display: Process? = null

    @AfterTest
    fun closeDisplay() {
        display?.destroy()
    }

    @Test
    fun `the menu speaks the language that is chosen at once, and cuts, copies and pastes where the focus is`() {
        val name = System.getenv("DISPLAY")?.takeIf { it.isNotEmpty() } ?: openDisplay()
        assumeTrue(name != null, "There is neither a display nor Xvfb, so there is no window to look at.")
        val java = File(System.getProperty("java.home"), "bin/java").path
        val builder =
            ProcessBuilder(java, "-cp", System.getProperty("java.class.path"), "robotran.desktop.window.MenuProbeKt")
        builder.environment()["DISPLAY"] = checkNotNull(name)
        val probe = builder.redirectError(ProcessBuilder.Redirect.DISCARD).start()
        // Without a graphics card the renderer prints messages, too.
        val said = probe.inputStream.bufferedReader().readLines().filter { Regex("[A-Z]+: .*").matches(it) }
        assertTrue(probe.waitFor(30, TimeUnit.SECONDS), "$said")
        val expected = listOf(
            "ENGLISH: [File, Edit, Run, View, Help]",
            "GERMAN: [Datei, Bearbeiten, Lauf, Ansicht, Hilfe]",
            "SPANISH: [Archivo, Editar, Ejecutar, Ver, Ayuda]",
            "ENGLISH: [File, Edit, Run, View, Help]",
            "A: pen down",
            "C: pen down",
            "X: ",
            "V: pen down",
            "V: pen downpen down",
        )
        assertEquals(expected, said)
    }

    /** Starts Xvfb and returns the name of its display; null if it is not installed. */
    private fun openDisplay(): String? {
        val started = runCatching {
            ProcessBuilder(
                "Xvfb",
                "-displayfd",
                "1",
                "-screen",
                "0",
                "1000x700x24",
            ).redirectError(ProcessBuilder.Redirect.DISCARD).start()
        }.getOrNull() ?: return null
        display = started
        return started.inputStream.bufferedReader().readLine()?.let { ":$it" }
    }
}

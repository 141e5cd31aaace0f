package robotran.desktop.window

import androidx.compose.ui.window.WindowPlacement
import androidx.compose.ui.window.WindowPosition
import robotran.desktop.platform.dataFolder
import java.awt.Rectangle
import java.nio.file.Path
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull

class WindowBoundsTest {
    private val screen = Rectangle(0, 0, 1920, 1080)

    @Test
    fun `a window is again where it was, and as large`() {
        val place = WindowBounds(100, 50, 900, 700, isMaximised = true)
        assertEquals(place, WindowBounds.of(place.toText()))
        val state = windowStateFor(place, listOf(screen))
        assertEquals(WindowPlacement.Maximized, state.placement)
        assertEquals(place, WindowBounds.of(state))
    }

    @Test
    fun `a window smaller than the screen can be laid out in is made larger`() {
        val state = windowStateFor(WindowBounds(0, 0, 10, 10, isMaximised = false), listOf(screen))
        assertEquals(MIN_WIDTH.toFloat(), state.size.width.value)
        assertEquals(MIN_HEIGHT.toFloat(), state.size.height.value)
        assertIs<WindowPosition.Absolute>(state.position)
    }

    @Test
    fun `what is no place is none`() {
        for (text in listOf("", "1 2 3 4", "1 2 3 x true", "1 2 3 4 true 5")) assertNull(WindowBounds.of(text))
    }

    @Test
    fun `work is kept where the platform wants it`() {
        val home = Path.of("/home/ann")
        assertEquals(home.resolve(".local/share/robotran"), dataFolder(emptyMap(), "Linux", home))
        assertEquals(Path.of("/data/robotran"), dataFolder(mapOf("XDG_DATA_HOME" to "/data"), "Linux", home))
        assertEquals(
            home.resolve(".local/share/robotran"),
            dataFolder(mapOf("XDG_DATA_HOME" to "not/absolute"), "Linux", home),
        )
        assertEquals(home.resolve("Library/Application Support/Robotran"), dataFolder(emptyMap(), "Mac OS X", home))
        assertEquals(home.resolve("AppData/Roaming/Robotran"), dataFolder(emptyMap(), "Windows 11", home))
        assertEquals(Path.of("/elsewhere"), dataFolder(mapOf("ROBOTRAN_DATA" to "/elsewhere"), "Windows 11", home))
    }
}

package robotran.ui.brick.nxt

import androidx.compose.ui.graphics.PixelMap
import androidx.compose.ui.graphics.toPixelMap
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.NxtDisplay
import robotran.ui.brick.rcx.photograph
import kotlin.test.Test
import kotlin.test.assertEquals

class NxtDotsTest {
    private val display: NxtDisplay = NxtScenes.running.display
    private val dots = dotsOf(display)

    @Test
    fun `a dot of the display is a pixel of its picture`() {
        val pixels = dots.toPixelMap()
        assertEquals(DisplaySize.WIDTH to DisplaySize.HEIGHT, pixels.width to pixels.height)
        everyDot { x, y -> assertEquals(display.isBlack(x, y), pixels[x, y] == NxtColours.DOT, "$x, $y") }
    }

    @Test
    fun `all dots on the glass are squares of whole pixels`() {
        val pixels = glass(width = 320, height = 210)
        everyDot { x, y ->
            val wanted = if (display.isBlack(x, y)) NxtColours.DOT else NxtColours.GLASS
            for (right in 0..2) {
                for (down in 0..2) assertEquals(wanted, pixels[10 + 3 * x + right, 9 + 3 * y + down], "$x, $y")
            }
        }
    }

    @Test
    fun `dots fade with the contrast, and a brick that is off has a darker glass`() {
        val pale = glass(100, 64, contrast = 0f)
        everyDot { x, y -> assertEquals(NxtColours.GLASS, pale[x, y]) }
        assertEquals(NxtColours.GLASS_OFF, glass(100, 64, contrast = 0f, isOn = false)[50, 30])
    }

    private fun glass(width: Int, height: Int, contrast: Float = 1f, isOn: Boolean = true): PixelMap =
        photograph(width, height) { drawGlass(dots, 0, DisplaySize.HEIGHT, contrast, 0f, isOn) }.toPixelMap()

    private fun everyDot(check: (Int, Int) -> Unit) {
        for (y in 0..<DisplaySize.HEIGHT) for (x in 0..<DisplaySize.WIDTH) check(x, y)
    }
}

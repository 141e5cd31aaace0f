package robotran.uikit

import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.luminance
import kotlin.test.Test
import kotlin.test.assertTrue

/** Tests that all can be read and seen in each theme (WCAG 2.2, 1.4.3, 1.4.6 and 1.4.11). */
class ContrastTest {
    @Test
    fun `text can be read on every ground that it is on`() = inThemes { name, colours ->
        val least = if (colours.isHighContrast) ENHANCED else TEXT
        with(colours) {
            val grounds =
                listOf("pane" to pane, "desk" to desk, "line that runs" to runningLine, "invitation" to invite)
            for ((ground, colour) in grounds) check(onPane, colour, least, "$name: text on the $ground")
            check(quiet, pane, least, "$name: quiet text")
            check(quiet, desk, TEXT, "$name: quiet text on the desk")
            check(good, goodPane, least, "$name: what is reached")
            check(good, pane, least, "$name: what is reached, on the pane")
            check(error, errorPane, least, "$name: an error")
            check(error, pane, least, "$name: an error on the pane")
            check(focus, pane, least, "$name: a link")
        }
    }

    @Test
    fun `what is no text stands out from what is around it`() = inThemes { name, colours ->
        with(colours) {
            check(focus, pane, SHAPES, "$name: the focus on the pane")
            check(focus, desk, SHAPES, "$name: the focus on the desk")
            check(quiet, pane, SHAPES, "$name: the outline of a control")
            if (isHighContrast) check(line, pane, SHAPES, "$name: a line between panes")
        }
    }

    @Test
    fun `words on the brick's colours can be read`() {
        check(RobotranColours.ON_YELLOW, RobotranColours.YELLOW, ENHANCED, "the primary action")
        check(RobotranColours.ON_COLOUR, RobotranColours.ON_OFF_RED, TEXT, "On-Off")
        check(RobotranColours.YELLOW_EDGE, RobotranColours.LIGHT.pane, SHAPES, "the edge of yellow on the pane")
    }

    private fun inThemes(check: (String, RobotranColours) -> Unit) {
        check("light", RobotranColours.LIGHT)
        check("dark", RobotranColours.DARK)
        check("high contrast", RobotranColours.HIGH_CONTRAST)
        check("high contrast, dark", RobotranColours.HIGH_CONTRAST_DARK)
    }

    private fun check(one: Color, other: Color, least: Double, described: String) {
        val contrast = contrastOf(one, other)
        assertTrue(contrast >= least, "$described: the contrast is only $contrast")
    }

    private companion object {
        const val TEXT = 4.5
        const val ENHANCED = 7.0
        const val SHAPES = 3.0
    }
}

/** The contrast of two opaque colours, from 1 to 21. */
internal fun contrastOf(one: Color, other: Color): Double {
    val (light, dark) = listOf(one.luminance(), other.luminance()).sortedDescending()
    return (light + 0.05) / (dark + 0.05)
}

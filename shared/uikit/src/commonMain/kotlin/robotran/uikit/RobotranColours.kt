package robotran.uikit

import androidx.compose.runtime.Immutable
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.graphics.Color

/**
 * The colours of one theme, by role; docs/design.md shows them and says why. Brick, robot and everything that lies on
 * the paper have colours of their own, which are the same in all themes.
 *
 * @property desk around the paper, and behind pictures.
 * @property paper the sheet. It stays light in the dark theme, as paper does.
 * @property pane the ground of text and controls.
 * @property onPane text on [pane] and [desk].
 * @property quiet text and lines of controls that stay in the background.
 * @property line separates panes.
 * @property runningLine the ground of the line that runs, and of what is selected.
 * @property invite the ground of what asks to be tried first.
 * @property good what has been reached, as text; [goodPane] is its ground.
 * @property error what is wrong, as text; [errorPane] is its ground.
 * @property focus the ring around the focused element, and links.
 * @property shadow what lies on the paper casts it; transparent in high contrast, where edges do its work.
 * @property isHighContrast whether all text has a contrast of at least 7 to 1 and nothing is only tinted.
 */
@Immutable
data class RobotranColours(
    val desk: Color,
    val paper: Color,
    val paperEdge: Color,
    val pane: Color,
    val onPane: Color,
    val quiet: Color,
    val line: Color,
    val runningLine: Color,
    val invite: Color,
    val good: Color,
    val goodPane: Color,
    val error: Color,
    val errorPane: Color,
    val focus: Color,
    val shadow: Color = Color.Transparent,
    val isDark: Boolean = false,
    val isHighContrast: Boolean = false,
) {
    companion object {
        /** RCX yellow: the brick and the primary action. */
        val YELLOW = Color(0xFFF2C200)
        val ON_YELLOW = Color(0xFF211B00)
        val YELLOW_EDGE = Color(0xFF8F7200)
        val RUN_GREEN = Color(0xFF2E9E4F)
        val ON_OFF_RED = Color(0xFFD33A2C)

        /** Words and signs on a strong colour. */
        val ON_COLOUR = Color(0xFFFFFFFF)

        /** The outline around lines over the paper, which sets them apart from whatever is below. */
        val CASING = Color(0xFFFFFFFF)

        /** Black as ink: what is mixed into a colour to shade it, and the dots of QR codes. */
        val SHADE = Color(0xFF000000)

        val LIGHT = RobotranColours(
            desk = Color(0xFFE4DCCE),
            paper = Color(0xFFFEFCF6),
            paperEdge = Color(0x40594A30),
            pane = Color(0xFFFBF9F4),
            onPane = Color(0xFF221F1A),
            quiet = Color(0xFF5F594E),
            line = Color(0xFFCDC5B6),
            runningLine = Color(0xFFFFE88A),
            invite = Color(0xFFFFF4CC),
            good = Color(0xFF1F6E37),
            goodPane = Color(0xFFE3F3E2),
            error = Color(0xFFB3261E),
            errorPane = Color(0xFFFBE4E1),
            focus = Color(0xFF0B57D0),
            shadow = Color(0x1C402E10),
        )

        val DARK = RobotranColours(
            desk = Color(0xFF302B25),
            paper = Color(0xFFEBE5D8),
            paperEdge = Color(0x66000000),
            pane = Color(0xFF1E1B17),
            onPane = Color(0xFFF0EBE2),
            quiet = Color(0xFFB3A999),
            line = Color(0xFF534B40),
            runningLine = Color(0xFF5A4A00),
            invite = Color(0xFF3B3314),
            good = Color(0xFF8FD6A0),
            goodPane = Color(0xFF1C3522),
            error = Color(0xFFFFB4AB),
            errorPane = Color(0xFF4A1D19),
            focus = Color(0xFF8AB4F8),
            shadow = Color(0x26201400),
            isDark = true,
        )

        /** Black on white with visible lines: all text has a contrast of at least 7 to 1 (WCAG 2.2, 1.4.6). */
        val HIGH_CONTRAST = RobotranColours(
            desk = Color(0xFFE5E3DF),
            paper = Color(0xFFFFFFFF),
            paperEdge = Color(0xFF000000),
            pane = Color(0xFFFFFFFF),
            onPane = Color(0xFF000000),
            quiet = Color(0xFF36332E),
            line = Color(0xFF000000),
            runningLine = Color(0xFFFFE14D),
            invite = Color(0xFFFFF0A8),
            good = Color(0xFF0B4A1E),
            goodPane = Color(0xFFE6F7E6),
            error = Color(0xFF8C0009),
            errorPane = Color(0xFFFFE9E6),
            focus = Color(0xFF0037B3),
            isHighContrast = true,
        )

        /** White on black; the paper stays white. */
        val HIGH_CONTRAST_DARK = RobotranColours(
            desk = Color(0xFF12110F),
            paper = Color(0xFFFFFFFF),
            paperEdge = Color(0xFFFFFFFF),
            pane = Color(0xFF000000),
            onPane = Color(0xFFFFFFFF),
            quiet = Color(0xFFDFDAD1),
            line = Color(0xFFFFFFFF),
            runningLine = Color(0xFF5C4B00),
            invite = Color(0xFF332A00),
            good = Color(0xFFA9EBB8),
            goodPane = Color(0xFF062A10),
            error = Color(0xFFFFC9C2),
            errorPane = Color(0xFF3A0A06),
            focus = Color(0xFFA8CBFF),
            isDark = true,
            isHighContrast = true,
        )
    }
}

/** The [RobotranColours] of the current theme. */
val LocalRobotranColours = staticCompositionLocalOf { RobotranColours.LIGHT }

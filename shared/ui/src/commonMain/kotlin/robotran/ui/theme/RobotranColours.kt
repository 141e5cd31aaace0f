package robotran.ui.theme

import androidx.compose.runtime.Immutable
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.graphics.Color

/** Colours without a Material name; the brick and the paper are the same in the dark theme. */
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
    val error: Color,
    val errorPane: Color,
    val focus: Color,
    val isDark: Boolean = false,
) {
    companion object {
        /** RCX yellow: the brick and the primary action. */
        val YELLOW = Color(0xFFF2C200)
        val ON_YELLOW = Color(0xFF211B00)
        val RUN_GREEN = Color(0xFF2E9E4F)
        val ON_OFF_RED = Color(0xFFD33A2C)

        val LIGHT = RobotranColours(
            desk = Color(0xFFD5D8DA),
            paper = Color(0xFFFDFBF5),
            paperEdge = Color(0x33202428),
            pane = Color(0xFFF6F6F4),
            onPane = Color(0xFF1D2023),
            quiet = Color(0xFF5C6268),
            line = Color(0xFFB9BEC2),
            runningLine = Color(0xFFFFE88A),
            error = Color(0xFFB3261E),
            errorPane = Color(0xFFFBE4E1),
            focus = Color(0xFF0B57D0),
        )

        val DARK = RobotranColours(
            desk = Color(0xFF2B2E31),
            paper = Color(0xFFE9E5DB),
            paperEdge = Color(0x66000000),
            pane = Color(0xFF1A1C1E),
            onPane = Color(0xFFE8EAEC),
            quiet = Color(0xFFA4ABB1),
            line = Color(0xFF4A4F54),
            runningLine = Color(0xFF5A4A00),
            error = Color(0xFFFFB4AB),
            errorPane = Color(0xFF4A1D19),
            focus = Color(0xFF8AB4F8),
            isDark = true,
        )

        /** Black on white with visible lines: all text has a contrast of at least 7 to 1 (WCAG 2.2, 1.4.6). */
        val HIGH_CONTRAST = RobotranColours(
            desk = Color(0xFFE3E5E7),
            paper = Color(0xFFFFFFFF),
            paperEdge = Color(0xFF000000),
            pane = Color(0xFFFFFFFF),
            onPane = Color(0xFF000000),
            quiet = Color(0xFF33383C),
            line = Color(0xFF000000),
            runningLine = Color(0xFFFFE14D),
            error = Color(0xFF8C0009),
            errorPane = Color(0xFFFFE9E6),
            focus = Color(0xFF0037B3),
        )

        /** White on black; the paper stays white. */
        val HIGH_CONTRAST_DARK = RobotranColours(
            desk = Color(0xFF101112),
            paper = Color(0xFFFFFFFF),
            paperEdge = Color(0xFFFFFFFF),
            pane = Color(0xFF000000),
            onPane = Color(0xFFFFFFFF),
            quiet = Color(0xFFD7DBDF),
            line = Color(0xFFFFFFFF),
            runningLine = Color(0xFF5C4B00),
            error = Color(0xFFFFC9C2),
            errorPane = Color(0xFF3A0A06),
            focus = Color(0xFFA8CBFF),
            isDark = true,
        )
    }
}

/** The [RobotranColours] of the current theme. */
val LocalRobotranColours = staticCompositionLocalOf { RobotranColours.LIGHT }

package robotran.ui.code

import androidx.compose.runtime.Composable
import androidx.compose.runtime.Immutable
import androidx.compose.runtime.remember
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.luminance
import robotran.languagesupport.CodeTokenKind
import robotran.uikit.*

/** The syntax colours; each has a contrast of at least 4.5 to 1 with the pane. */
@Immutable
data class CodeColours(
    val keyword: Color,
    val known: Color,
    val number: Color,
    val text: Color,
    val comment: Color,
    val plain: Color,
    val warning: Color,
    val selection: Color,
    val match: Color,
    val caretLine: Color,
    val partner: Color,
    val breakpoint: Color,
) {
    fun of(kind: CodeTokenKind): Color = when (kind) {
        CodeTokenKind.KEYWORD -> keyword
        CodeTokenKind.BUILT_IN -> known
        CodeTokenKind.NUMBER -> number
        CodeTokenKind.TEXT -> text
        CodeTokenKind.COMMENT -> comment
        CodeTokenKind.NAME, CodeTokenKind.SIGN -> plain
    }
}

/** The colours for the current theme. */
@Composable
fun codeColours(): CodeColours {
    val colours = LocalRobotranColours.current
    return remember(colours) { codeColoursFor(colours) }
}

fun codeColoursFor(colours: RobotranColours): CodeColours {
    val isDark = colours.pane.luminance() < HALF
    return CodeColours(
        keyword = if (isDark) Color(0xFF9CC2FF) else Color(0xFF1546A0),
        known = if (isDark) Color(0xFF7FD6C6) else Color(0xFF00594E),
        number = if (isDark) Color(0xFFF2B880) else Color(0xFF863600),
        text = if (isDark) Color(0xFFB9DB7A) else Color(0xFF365C00),
        comment = colours.quiet,
        plain = colours.onPane,
        warning = if (isDark) Color(0xFFE8C46A) else Color(0xFF6B4E00),
        selection = colours.focus.copy(alpha = if (isDark) 0.4f else 0.24f),
        match = RobotranColours.YELLOW.copy(alpha = if (isDark) 0.3f else 0.45f),
        caretLine = colours.onPane.copy(alpha = 0.05f),
        partner = colours.focus.copy(alpha = if (isDark) 0.28f else 0.14f),
        breakpoint = RobotranColours.ON_OFF_RED,
    )
}

private const val HALF = 0.5f

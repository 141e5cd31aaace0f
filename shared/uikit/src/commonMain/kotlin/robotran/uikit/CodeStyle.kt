package robotran.uikit

import androidx.compose.runtime.Composable
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.LineHeightStyle
import androidx.compose.ui.unit.em
import org.jetbrains.compose.resources.Font
import robotran.uikit.resources.*

/** The style of program text: the bundled monospaced font with a fixed line height. */
@Composable
fun codeStyle(colour: Color = LocalRobotranColours.current.onPane): TextStyle = TextStyle(
    color = colour,
    fontFamily = FontFamily(Font(Res.font.jetbrains_mono_regular)),
    // Disables the font's ligatures such as !=: a beginner has to see each character.
    fontFeatureSettings = "liga 0, calt 0",
    fontWeight = FontWeight.Normal,
    // Each character has the same place in an editor, which lays out lines by itself.
    letterSpacing = 0.em,
    fontSize = Dimensions.CODE_SIZE,
    lineHeight = Dimensions.CODE_LINE_HEIGHT,
    lineHeightStyle = LineHeightStyle(LineHeightStyle.Alignment.Center, LineHeightStyle.Trim.None),
)

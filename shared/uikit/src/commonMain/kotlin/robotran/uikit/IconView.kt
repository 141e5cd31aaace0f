package robotran.uikit

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.size
import androidx.compose.material3.LocalContentColor
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/** An [icon] that its parent names, in the colour of text there unless it has its own. */
@Composable
fun IconView(icon: Icon, colour: Color = LocalContentColor.current, modifier: Modifier = Modifier, size: Dp = 24.dp) =
    Canvas(modifier.size(size)) { with(icon) { draw(colour) } }

/** A decorative icon next to words of the same meaning; it scales with the text. */
@Composable
fun SmallIcon(icon: Icon, colour: Color, modifier: Modifier = Modifier, size: Dp = 20.dp) =
    IconView(icon, colour, modifier, size * LocalDensity.current.fontScale)

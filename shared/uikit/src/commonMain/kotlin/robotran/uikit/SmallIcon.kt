package robotran.uikit

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/** A decorative icon next to words of the same meaning; it scales with the text. */
@Composable
fun SmallIcon(icon: Icon, colour: Color, modifier: Modifier = Modifier, size: Dp = 20.dp) =
    Canvas(modifier.size(size * LocalDensity.current.fontScale)) { with(icon) { draw(colour) } }

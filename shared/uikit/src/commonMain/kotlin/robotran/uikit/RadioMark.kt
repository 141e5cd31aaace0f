package robotran.uikit

import androidx.compose.material3.RadioButton
import androidx.compose.material3.RadioButtonDefaults
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier

/** A radio button's ring, filled if selected; the parent handles touches. */
@Composable
fun RadioMark(selected: Boolean, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    RadioButton(
        selected,
        onClick = null,
        modifier,
        colors = RadioButtonDefaults.colors(selectedColor = colours.focus, unselectedColor = colours.quiet),
    )
}

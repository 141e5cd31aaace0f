package robotran.uikit

import androidx.compose.material3.Checkbox
import androidx.compose.material3.CheckboxDefaults
import androidx.compose.material3.RadioButton
import androidx.compose.material3.RadioButtonDefaults
import androidx.compose.material3.Switch
import androidx.compose.material3.SwitchDefaults
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

/** A box with a tick if [checked]; the parent handles touches. */
@Composable
fun CheckMark(checked: Boolean) {
    val colours = LocalRobotranColours.current
    Checkbox(
        checked,
        onCheckedChange = null,
        colors = CheckboxDefaults.colors(
            checkedColor = colours.focus,
            uncheckedColor = colours.quiet,
            checkmarkColor = colours.pane,
        ),
    )
}

/** A switch that is [on] or off; the parent handles touches. */
@Composable
fun SwitchMark(on: Boolean) {
    val colours = LocalRobotranColours.current
    Switch(
        on,
        onCheckedChange = null,
        colors = SwitchDefaults.colors(
            checkedThumbColor = colours.pane,
            checkedTrackColor = RobotranColours.RUN_GREEN,
            uncheckedThumbColor = colours.quiet,
            uncheckedBorderColor = colours.quiet,
            uncheckedTrackColor = colours.pane,
        ),
    )
}

package robotran.ui.parts

import androidx.compose.material3.OutlinedTextFieldDefaults
import androidx.compose.runtime.Composable
import robotran.ui.theme.LocalRobotranColours

@Composable
internal fun fieldColours() = LocalRobotranColours.current.let {
    OutlinedTextFieldDefaults.colors(
        focusedBorderColor = it.focus,
        focusedLabelColor = it.focus,
        unfocusedBorderColor = it.quiet,
        unfocusedLabelColor = it.quiet,
        cursorColor = it.focus,
    )
}

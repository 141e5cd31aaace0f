package robotran.uikit

import androidx.compose.material3.OutlinedTextFieldDefaults
import androidx.compose.runtime.Composable

@Composable
fun fieldColours() = LocalRobotranColours.current.let {
    OutlinedTextFieldDefaults.colors(
        focusedBorderColor = it.focus,
        focusedLabelColor = it.focus,
        unfocusedBorderColor = it.quiet,
        unfocusedLabelColor = it.quiet,
        cursorColor = it.focus,
    )
}

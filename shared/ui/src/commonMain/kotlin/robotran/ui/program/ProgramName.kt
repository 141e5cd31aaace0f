package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Measures

/** The head of the program's pane: which program this is. */
@Composable
internal fun ProgramName(name: String, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    Box(modifier.fillMaxWidth().background(colours.pane).height(Measures.TARGET).padding(horizontal = 20.dp), Alignment.CenterStart) {
        Text(
            name,
            Modifier.semantics { heading() },
            color = colours.onPane,
            fontSize = 16.sp,
            fontWeight = FontWeight.SemiBold,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
    }
}

package robotran.ui.editing

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.layout.onSizeChanged
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.uikit.*

/**
 * A panel that scrolls, and what is [wrong] at its lower end: a mistake comes and goes under a finger that taps a
 * button again and again, so it moves nothing.
 */
@Composable
internal fun FieldPanel(
    tag: String,
    wrong: List<String>,
    wrongTag: String,
    modifier: Modifier = Modifier,
    content: @Composable ColumnScope.() -> Unit,
) {
    val colours = LocalRobotranColours.current
    // Once taken, the room stays, since the end of the panel would move.
    var covered by remember { mutableIntStateOf(0) }
    Box(modifier.fillMaxSize().background(colours.pane)) {
        Column(
            Modifier
                .fillMaxSize()
                .testTag(tag)
                .verticalScroll(rememberScrollState())
                .padding(12.dp)
                .padding(bottom = with(LocalDensity.current) { covered.toDp() }),
            Arrangement.spacedBy(4.dp),
            content = content,
        )
        if (wrong.isEmpty()) return@Box
        Column(
            Modifier
                .align(Alignment.BottomCenter)
                .fillMaxWidth()
                .onSizeChanged { covered = maxOf(covered, it.height) }
                .background(colours.errorPane)
                .padding(horizontal = 12.dp, vertical = 8.dp),
            Arrangement.spacedBy(4.dp),
        ) {
            for (sentence in wrong) FieldError(sentence, Modifier.testTag(wrongTag))
        }
    }
}

package robotran.ui.brick.nxt

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.brick.program.FailureFrame
import robotran.nxt.state.ExceptionView
import robotran.ui.run.tags.RunTags
import robotran.ui.texts.NxtTexts
import robotran.uikit.*

/** In words, the calls of which the exception screen of an NXT shows only numbers; empty if there are none. */
@Composable
internal fun ExceptionCalls(exception: ExceptionView, modifier: Modifier = Modifier) {
    val calls = exception.failure.stack
    if (calls.isEmpty()) return
    Column(modifier.testTag(RunTags.EXCEPTION_CALLS)) {
        Text(
            NxtTexts.exceptionCalls(spoken),
            Modifier.padding(bottom = 4.dp),
            TextStyles.smallLines,
            color = LocalRobotranColours.current.quiet,
        )
        for (call in calls) {
            Text(placeOf(call), style = codeStyle().copy(fontSize = TextSizes.SMALL, lineHeight = LineHeights.SMALL))
        }
    }
}

@Composable
private fun placeOf(call: FailureFrame): String = if (call.sourceLine == 0) {
    NxtTexts.exceptionLibrary(spoken, call.name)
} else {
    val name = call.sourceFile?.let { "${call.name}, $it" } ?: call.name
    NxtTexts.exceptionCall(spoken, name, call.sourceLine)
}

package robotran.ui.send

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.HubSendTexts
import robotran.uikit.*

/**
 * How far Python is on its way to a hub or a board.
 *
 * @property sent bytes that have arrived; so are those of [total].
 * @property isRepeated whether an attempt before it failed.
 */
internal class SentPart(val sent: Int, val total: Int, val isRepeated: Boolean) {
    /** From 0 to 1. */
    val share: Float get() = if (total <= 0) 0f else (sent.toFloat() / total).coerceIn(0f, 1f)
}

/** Shows [part]; null before the other side has begun. */
@Composable
internal fun SentPartView(part: SentPart?) {
    val colours = LocalRobotranColours.current
    Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp)) {
        Bar(Modifier.testTag(SendTags.SEND_PROGRESS)) { part?.share ?: 0f }
        val words = part?.let { HubSendTexts.bytes(spoken, it.sent, it.total) }
        // An empty line, so that nothing moves when the other side begins.
        Text(words.orEmpty(), Modifier.testTag(SendTags.SEND_BLOCK), TextStyles.body, color = colours.quiet)
        if (part?.isRepeated == true) {
            Explanation(HubSendTexts.repeated(spoken), Modifier.testTag(SendTags.SEND_WEAK))
        }
    }
}

/** A bar that is filled by [part], from 0 to 1. */
@Composable
internal fun Bar(modifier: Modifier = Modifier, part: () -> Float) =
    Progress(part, Modifier.fillMaxWidth().height(8.dp).then(modifier), ground = LocalRobotranColours.current.desk)

/** The last [count] of the [lines] that a program has printed, and the [unfinished] one. */
@Composable
internal fun Printed(lines: List<String>, unfinished: String, count: Int) {
    val all = lines + listOf(unfinished).filter { it.isNotEmpty() }
    if (all.isEmpty()) return
    val colours = LocalRobotranColours.current
    Text(HubSendTexts.printed(spoken), style = TextStyles.body, color = colours.quiet)
    val before = all.size - count
    if (before > 0) Text(HubSendTexts.lineMore(spoken, before), style = TextStyles.body, color = colours.quiet)
    Text(all.takeLast(count).joinToString("\n"), Modifier.testTag(SendTags.SEND_OUTPUT), TextStyles.code)
}

/** Lines that are shown while a program may print, so that the last one is in sight. */
internal const val RUNNING_LINES = 6

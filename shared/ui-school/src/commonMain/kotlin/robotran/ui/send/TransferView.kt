package robotran.ui.send

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.language.Language
import robotran.tower.TransferProgress
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.SendTexts
import robotran.uikit.*

/**
 * How far a transfer is; null before its first block.
 *
 * @param counted the words for so many of so many blocks.
 */
@Composable
internal fun TransferView(progress: TransferProgress?, counted: (Language, Int, Int) -> String = SendTexts::block) {
    val colours = LocalRobotranColours.current
    Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp)) {
        Progress(
            { partOf(progress) },
            Modifier.fillMaxWidth().height(8.dp).testTag(SendTags.SEND_PROGRESS),
            ground = colours.desk,
        )
        val words = progress?.let {
            "${counted(spoken, it.confirmedBlocks, it.totalBlocks)}, ${timeLeft(it)}"
        }
        // An empty line, so that nothing moves when the first block is through.
        Text(words.orEmpty(), Modifier.testTag(SendTags.SEND_BLOCK), TextStyles.body, color = colours.quiet)
        if (progress != null && isWeak(progress)) {
            Explanation(SendTexts.weak(spoken), Modifier.testTag(SendTags.SEND_WEAK))
        }
    }
}

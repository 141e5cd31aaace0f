package robotran.ui.learning

import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.learning.Hint
import robotran.learning.HintStage
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*

/**
 * The visible [hints]. They are told to screen readers, also the one that comes by itself after a try.
 *
 * @param hasLatest whether the first of them is the latest one.
 */
@Composable
fun HintCards(hints: List<Hint>, inBlocks: Boolean, hasLatest: Boolean = true) {
    hints.forEachIndexed { place, hint ->
        key(hint) { HintCard(hint, inBlocks, isLatest = hasLatest && place == 0) }
    }
}

@Composable
private fun HintCard(hint: Hint, inBlocks: Boolean, isLatest: Boolean) {
    val colours = LocalRobotranColours.current
    Column(
        Modifier
            .fillMaxWidth()
            .testTag(if (isLatest) LearningTags.HINT else LearningTags.hint(hint.stage))
            .broughtIntoSight(isLatest)
            .border(1.dp, colours.line, Shapes.MEDIUM)
            .padding(Space.SMALL)
            .semantics(mergeDescendants = true) { liveRegion = LiveRegionMode.Polite },
        Arrangement.spacedBy(Space.HAIR),
    ) {
        val line = hint.line?.let { " · ${LearningTexts.hintLine(spoken, it)}" }.orEmpty()
        Text("${hint.stage.title(spoken)}$line", style = TextStyles.small.strong)
        MarkedText(if (inBlocks) hint.textInBlocks else hint.text, colour = colours.onPane)
    }
}

private val HintStage.title: Label
    get() = when (this) {
        HintStage.NUDGE -> LearningTexts::hintNudge
        HintStage.PART -> LearningTexts::hintPart
        HintStage.SOLUTION -> LearningTexts::hintSolution
    }

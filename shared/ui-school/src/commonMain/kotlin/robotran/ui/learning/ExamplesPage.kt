package robotran.ui.learning

import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.grid.LazyGridScope
import androidx.compose.foundation.lazy.grid.items
import androidx.compose.foundation.lazy.grid.rememberLazyGridState
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.ui.programlanguages.ExampleSet
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*
import robotran.workshop.event.LearningEvent

/**
 * All example programs with their drawings; those in the language [current], for the [brick] of the robot, come first.
 */
@Composable
internal fun ExamplesPage(current: ProgramLanguage, brick: BrickKind, onEvent: (LearningEvent) -> Unit) {
    val cards = rememberLazyGridState()
    Page(LearningTexts.examples(spoken), LearningTags.EXAMPLES_PAGE, {
        onEvent(LearningEvent.PageClosed)
    }, cards, maxWidth = 1280.dp) {
        CardGrid(pictureCardColumns(CARD_WIDTH), cards, LearningTags.EXAMPLE_CARDS) {
            wholeRow("added") {
                Text(
                    LearningTexts.examplesAdded(spoken),
                    style = TextStyles.body,
                    color = LocalRobotranColours.current.quiet,
                )
            }
            val isFirst = { set: ExampleSet -> set.language == current && (set.brick == null || set.brick == brick) }
            for (set in ExampleSet.entries.sortedByDescending(isFirst)) examples(set, onEvent)
        }
    }
}

private fun LazyGridScope.examples(set: ExampleSet, onEvent: (LearningEvent) -> Unit) {
    wholeRow(set.name) {
        val words = Modifier.padding(top = 8.dp).heading()
        Text(set.title(spoken), words, TextStyles.lead.strong)
    }
    items(set.programs.keys.toList(), key = { set.idOf(it) }) { name ->
        ExampleCard(name, set.idOf(name), aboutExample(set, name, spoken)) {
            onEvent(LearningEvent.ExampleChosen(set.language, name, set.brick ?: BrickKind.default))
        }
    }
}

@Composable
private fun ExampleCard(name: String, id: String, about: String, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    PictureCard(id, ExamplePictures, LearningTags.example(id), LOOK, onClick) {
        Text(name, style = TextStyles.body.strong)
        Text(about, style = TextStyles.smallLines, color = colours.quiet)
    }
}

private val CARD_WIDTH = 200.dp
private val LOOK = CardLook(4f / 3f, padding = Space.MEDIUM)

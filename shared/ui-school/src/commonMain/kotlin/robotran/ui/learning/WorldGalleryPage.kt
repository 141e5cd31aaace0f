package robotran.ui.learning

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.lazy.grid.items
import androidx.compose.foundation.lazy.grid.rememberLazyGridState
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.learning.WorldGallery
import robotran.ui.empty.EmptyPicture
import robotran.ui.empty.EmptyState
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.ui.texts.HubTexts
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.state.LearningState

/** All built-in worlds to choose from. */
@Composable
internal fun WorldGalleryPage(state: LearningState, onEvent: (LearningEvent) -> Unit) {
    val colours = LocalRobotranColours.current
    // Reading the files of all worlds takes long, so nobody does before somebody searches.
    val robots = if (state.query.isBlank()) emptyMap() else robotsOfWorlds()
    var brick by rememberSaveable { mutableStateOf<BrickKind?>(null) }
    val found = remember(state.query, state.language, robots, brick) {
        WorldGallery.search(state.query, state.language) { robots.getValue(it.name) }
            .filter { brick == null || it.plainWorld.robots.first().description.brick == brick }
    }
    val cards = rememberLazyGridState()
    Page(LearningTexts.worlds(spoken), LearningTags.WORLDS_PAGE, {
        onEvent(LearningEvent.PageClosed)
    }, cards, maxWidth = 1280.dp) {
        CardGrid(pictureCardColumns(CARD_WIDTH), cards, LearningTags.WORLD_CARDS) {
            wholeRow("kept") {
                Text(LearningTexts.worldsKept(spoken), style = TextStyles.body, color = colours.quiet)
            }
            wholeRow("search") {
                Column(verticalArrangement = Arrangement.spacedBy(8.dp)) {
                    Search(state.query) { onEvent(LearningEvent.WorldSearchChanged(it)) }
                    BrickFilter(brick) { brick = it }
                }
            }
            items(found, key = { it.name }) { world ->
                WorldCard(world, state.language, state.worldsDone) { onEvent(LearningEvent.WorldChosen(it.name)) }
            }
            if (found.isEmpty()) wholeRow("none") { NothingFound() }
        }
    }
}

@Composable
private fun robotsOfWorlds(): Map<String, String> = WorldGallery.worlds.associate { it.name to robotOf(it.plainWorld) }

/** Shows all worlds, or only those whose robot has the chosen brick. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun BrickFilter(brick: BrickKind?, onChoose: (BrickKind?) -> Unit) {
    val all = LearningTexts.worldsAll(spoken)
    FlowRow(horizontalArrangement = Arrangement.spacedBy(8.dp)) {
        for (choice in listOf<BrickKind?>(null) + WorldGallery.bricks) {
            val tag = LearningTags.worlds(choice)
            val name = choice?.let { HubTexts.robotWith(spoken, it) } ?: all
            Chip(name, choice == brick, tag) { onChoose(choice) }
        }
    }
}

@Composable
private fun Search(query: String, onAsk: (String) -> Unit) {
    val field = remember { FocusRequester() }
    val clear = @Composable {
        IconButton(Icon.CLOSE, LearningTexts.worldsClear(spoken), LearningTags.WORLD_SEARCH_CLEAR) {
            onAsk("")
            // Whoever clears it wants to type something else.
            field.requestFocus()
        }
    }
    TextField(
        query,
        onAsk,
        Modifier.fillMaxWidth().widthIn(max = 480.dp).focusRequester(field).testTag(LearningTags.WORLD_SEARCH),
        LearningTexts.worldsSearch(spoken),
        extras = FieldExtras(shape = Shapes.MEDIUM, button = if (query.isEmpty()) null else clear),
    )
}

@Composable
private fun NothingFound() = EmptyState(
    EmptyPicture.GLASS,
    LearningTexts.worldsNone(spoken),
    LearningTags.WORLDS_NONE,
    Modifier.fillMaxWidth().height(NOTHING_HEIGHT).announced(),
)

private val NOTHING_HEIGHT = 220.dp
private val CARD_WIDTH = 264.dp

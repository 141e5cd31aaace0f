package robotran.ui.learning

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.language.Language
import robotran.learning.GalleryWorld
import robotran.learning.WorldLevel
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*

/**
 * A world of the gallery: its picture, title, difficulty, robot and task, and its harder variations.
 *
 * @param done the names of the worlds and variations whose goals were met.
 */
@Composable
internal fun WorldCard(world: GalleryWorld, language: Language, done: Set<String>, onChoose: (GalleryWorld) -> Unit) {
    val colours = LocalRobotranColours.current
    val shown = remember(world, language) { world.world(language) }
    PictureCard(world, WorldPictures, LearningTags.world(world.name), LOOK, { onChoose(world) }) {
        Text(shown.title, style = TextStyles.lead.strong)
        Row(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalAlignment = Alignment.CenterVertically) {
            Text(world.level.title(spoken), style = TextStyles.compact.medium, color = colours.quiet)
            if (world.name in done) DoneMark()
        }
        Text(robotOf(world.plainWorld), style = TextStyles.compact, color = colours.quiet)
        Text(shown.task, style = TextStyles.compactLines)
        for (harder in world.harder) Harder(harder, language, harder.name in done) { onChoose(harder) }
    }
}

@Composable
private fun Harder(world: GalleryWorld, language: Language, isDone: Boolean, onClick: () -> Unit) {
    val title = remember(world, language) { world.world(language).title }
    val words = LearningTexts.harder(spoken, title)
    val mark = if (isDone) " · ${LearningTexts.worldDoneMark(spoken)}" else ""
    Button("$words$mark", LearningTags.world(world.name), ButtonKind.SECOND, Modifier.fillMaxWidth(), onClick = onClick)
}

@Composable
private fun DoneMark() {
    val colours = LocalRobotranColours.current
    Row(horizontalArrangement = Arrangement.spacedBy(4.dp), verticalAlignment = Alignment.CenterVertically) {
        SmallIcon(DONE_ICON, colours.onPane, size = 18.dp)
        val done = LearningTexts.worldDoneMark(spoken)
        Text(done, style = TextStyles.compact.strong, color = colours.onPane)
    }
}

private val WorldLevel.title: Label
    get() = when (this) {
        WorldLevel.EASY -> LearningTexts::levelEasy
        WorldLevel.MEDIUM -> LearningTexts::levelMedium
        WorldLevel.HARD -> LearningTexts::levelHard
    }

private val LOOK = CardLook(16f / 10f, padding = Space.LARGE)

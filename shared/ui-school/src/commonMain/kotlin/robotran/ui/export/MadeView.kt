package robotran.ui.export

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.role
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import kotlinx.coroutines.delay
import robotran.simulation.state.SessionState
import robotran.ui.school.tags.ExportTags
import robotran.ui.school.texts.ExportTexts
import robotran.uikit.*
import robotran.workshop.state.MadePicture
import robotran.workshop.state.ShowStep
import robotran.world.World

/** What was made, as large as there is room, and below it what became of it. */
@Composable
internal fun MadeView(step: ShowStep.Made) = Column(Modifier.fillMaxSize(), Arrangement.spacedBy(12.dp)) {
    val room = Modifier.weight(1f).fillMaxWidth()
    when (val shown = step.work.shown) {
        is MadePicture.Still -> SheetView(shown.world, shown.session, room.madePicture(ExportTexts.madePicture(spoken)))
        is MadePicture.Moving -> Film(shown, room)
        is MadePicture.Page -> PosterView(shown.poster, room, Modifier.testTag(ExportTags.SHOW_MADE))
    }
    Outcome(step)
}

@Composable
private fun Outcome(step: ShowStep.Made) {
    val error = step.error
    val saved = step.savedAs
    when {
        error != null -> Text(
            sentenceOf(error),
            Modifier.fillMaxWidth().testTag(ExportTags.SHOW_FAILED).announced(),
            TextStyles.sentence,
            color = LocalRobotranColours.current.error,
        )

        saved != null -> Text(
            ExportTexts.saved(spoken, saved),
            Modifier.fillMaxWidth().testTag(ExportTags.SHOW_SAVED).announced(),
            TextStyles.sentence,
        )
    }
}

/** Plays once, and again at a touch. With less motion it stands at its last moment until it is touched. */
@Composable
private fun Film(film: MadePicture.Moving, modifier: Modifier) {
    val lessMotion = LocalLessMotion.current
    var plays by remember(film) { mutableIntStateOf(if (lessMotion) 0 else 1) }
    var frame by remember(film) { mutableIntStateOf(if (lessMotion) film.states.lastIndex else 0) }
    LaunchedEffect(film, plays) {
        if (plays == 0) return@LaunchedEffect
        for (next in film.states.indices) {
            frame = next
            delay(film.frameMilliseconds.toLong())
        }
    }
    val again = ExportTexts.playAgain(spoken)
    val place = modifier.clickable(onClickLabel = again) { plays++ }.madePicture(ExportTexts.madeFilm(spoken))
    SheetView(film.world, film.states[frame], place)
}

@Composable
private fun SheetView(world: World, session: SessionState, modifier: Modifier) {
    val sheet = remember(world) { ShownSheet(world) }
    Box(modifier) {
        Canvas(Modifier.fillMaxSize()) { with(sheet) { drawIn(Rect(Offset.Zero, size), session) } }
    }
}

private fun Modifier.madePicture(description: String): Modifier = testTag(ExportTags.SHOW_MADE).semantics {
    role = Role.Image
    contentDescription = description
}

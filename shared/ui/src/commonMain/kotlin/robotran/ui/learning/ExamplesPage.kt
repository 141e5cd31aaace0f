package robotran.ui.learning

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.Image
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.grid.GridCells
import androidx.compose.foundation.lazy.grid.GridItemSpan
import androidx.compose.foundation.lazy.grid.LazyGridScope
import androidx.compose.foundation.lazy.grid.LazyVerticalGrid
import androidx.compose.foundation.lazy.grid.items
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Surface
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.layout.ContentScale
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.parts.Page
import robotran.ui.resources.Res
import robotran.ui.resources.learning_examples
import robotran.ui.resources.learning_examples_added
import robotran.ui.resources.program_examples_java
import robotran.ui.resources.program_examples_robolang
import robotran.ui.sheet.PictureRoom
import robotran.ui.sheet.SheetColours
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.focusRing
import robotran.ui.workshop.LearningEvent
import robotran.ui.workshop.ProgramLanguage
import robotran.ui.workshop.examples

/** All programs that come with the app, with what they draw; first those in the language [current], which one works in. */
@Composable
internal fun ExamplesPage(current: ProgramLanguage, onEvent: (LearningEvent) -> Unit) {
    val scale = LocalDensity.current.fontScale.coerceAtMost(MOST_SCALE)
    Page(stringResource(Res.string.learning_examples), "examples-page", { onEvent(LearningEvent.PageLeft) }, mostWidth = 1280.dp) {
        LazyVerticalGrid(
            columns = GridCells.Adaptive(CARD_WIDTH * scale),
            modifier = Modifier.fillMaxSize().testTag("example-cards"),
            contentPadding = PaddingValues(20.dp),
            horizontalArrangement = Arrangement.spacedBy(16.dp),
            verticalArrangement = Arrangement.spacedBy(16.dp),
        ) {
            item(span = { GridItemSpan(maxLineSpan) }, key = "added") {
                Text(stringResource(Res.string.learning_examples_added), color = LocalRobotranColours.current.quiet, fontSize = 16.sp)
            }
            for (language in ProgramLanguage.entries.sortedByDescending { it == current }) examples(language, onEvent)
        }
    }
}

private fun LazyGridScope.examples(language: ProgramLanguage, onEvent: (LearningEvent) -> Unit) {
    item(span = { GridItemSpan(maxLineSpan) }, key = language.name) {
        val colour = LocalRobotranColours.current.onPane
        val words = Modifier.padding(top = 8.dp).semantics { heading() }
        Text(stringResource(language.title), words, color = colour, fontSize = 18.sp, fontWeight = FontWeight.SemiBold)
    }
    items(language.examples.toList(), key = { it.first }) { (name, text) ->
        ExampleCard(name, aboutExample(text)) { onEvent(LearningEvent.ExampleChosen(language, name)) }
    }
}

@Composable
private fun ExampleCard(name: String, about: String, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    Surface(
        Modifier
            .fillMaxWidth()
            .testTag("example-$name")
            .focusRing(CORNER)
            .clip(RoundedCornerShape(CORNER))
            .clickable(role = Role.Button, onClick = onClick),
        shape = RoundedCornerShape(CORNER),
        color = colours.pane,
        border = BorderStroke(1.dp, colours.line),
    ) {
        Column {
            ExamplePicture(name)
            Column(Modifier.padding(12.dp), Arrangement.spacedBy(4.dp)) {
                Text(name, color = colours.onPane, fontSize = 16.sp, fontWeight = FontWeight.SemiBold)
                Text(about, color = colours.quiet, fontSize = 14.sp, lineHeight = 20.sp)
            }
        }
    }
}

/** The card says what it shows, so it has no words of its own. */
@Composable
private fun ExamplePicture(name: String) {
    val colours = LocalRobotranColours.current
    val sheetColours = remember(colours) { SheetColours.of(colours) }
    BoxWithConstraints(Modifier.fillMaxWidth().aspectRatio(PICTURE_ASPECT).background(colours.desk).padding(6.dp), Alignment.Center) {
        val room = PictureRoom.of(constraints.maxWidth, constraints.maxHeight, LocalDensity.current.density)
        val picture by produceState(ExamplePictures.ready(name, sheetColours, room), name, sheetColours, room) {
            value = ExamplePictures.of(name, sheetColours, room)
        }
        picture?.let { Image(it, contentDescription = null, Modifier.fillMaxSize(), contentScale = ContentScale.Fit) }
    }
}

/** What an example says about itself: the note it begins with, up to the end of its first sentence. */
private fun aboutExample(text: String): String {
    val note = text.lineSequence().takeWhile { it.startsWith("//") }
    return note.joinToString(" ") { it.removePrefix("//").trim() }.substringBefore(". ").removeSuffix(".")
}

private val ProgramLanguage.title: StringResource
    get() = when (this) {
        ProgramLanguage.ROBOLANG -> Res.string.program_examples_robolang
        ProgramLanguage.JAVA -> Res.string.program_examples_java
    }

private val CARD_WIDTH = 200.dp
private const val MOST_SCALE = 1.4f
private const val PICTURE_ASPECT = 4f / 3f
private val CORNER = 12.dp

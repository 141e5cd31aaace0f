package robotran.ui.learning

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.Image
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
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
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.language.Language
import robotran.learning.GalleryWorld
import robotran.learning.WorldLevel
import robotran.ui.resources.Res
import robotran.ui.resources.learning_level_easy
import robotran.ui.resources.learning_level_hard
import robotran.ui.resources.learning_level_medium
import robotran.ui.resources.learning_world_done_mark
import robotran.ui.sheet.PictureRoom
import robotran.ui.sheet.SheetColours
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.focusRing

/** A world of the gallery: its picture, what it is called, how hard it is, and what is to be done there. */
@Composable
internal fun WorldCard(world: GalleryWorld, language: Language, isDone: Boolean, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    val shown = remember(world, language) { world.world(language) }
    Surface(
        Modifier
            .fillMaxWidth()
            .testTag("world-${world.name}")
            .focusRing(CORNER)
            .clip(RoundedCornerShape(CORNER))
            .clickable(role = Role.Button, onClick = onClick),
        shape = RoundedCornerShape(CORNER),
        color = colours.pane,
        border = BorderStroke(1.dp, colours.line),
    ) {
        Column {
            WorldPicture(world)
            Column(Modifier.padding(16.dp), Arrangement.spacedBy(6.dp)) {
                Text(shown.title, color = colours.onPane, fontSize = 18.sp, fontWeight = FontWeight.SemiBold)
                Row(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalAlignment = Alignment.CenterVertically) {
                    Text(stringResource(world.level.title), color = colours.quiet, fontSize = 15.sp, fontWeight = FontWeight.Medium)
                    if (isDone) DoneMark()
                }
                Text(shown.task, color = colours.onPane, fontSize = 15.sp, lineHeight = 21.sp)
            }
        }
    }
}

@Composable
private fun DoneMark() {
    val colours = LocalRobotranColours.current
    Row(horizontalArrangement = Arrangement.spacedBy(4.dp), verticalAlignment = Alignment.CenterVertically) {
        SmallIcon(DONE_ICON, colours.onPane, size = 18.dp)
        val done = stringResource(Res.string.learning_world_done_mark)
        Text(done, color = colours.onPane, fontSize = 15.sp, fontWeight = FontWeight.SemiBold)
    }
}

/** Title and task say what is to be seen, so it has no words of its own. */
@Composable
private fun WorldPicture(world: GalleryWorld) {
    val colours = LocalRobotranColours.current
    val sheetColours = remember(colours) { SheetColours.of(colours) }
    BoxWithConstraints(Modifier.fillMaxWidth().aspectRatio(PICTURE_ASPECT).background(colours.desk).padding(8.dp), Alignment.Center) {
        val room = PictureRoom.of(constraints.maxWidth, constraints.maxHeight, LocalDensity.current.density)
        val picture by produceState(WorldPictures.ready(world, sheetColours, room), world, sheetColours, room) {
            value = WorldPictures.of(world, sheetColours, room)
        }
        picture?.let { Image(it, contentDescription = null, Modifier.fillMaxSize(), contentScale = ContentScale.Fit) }
    }
}

private val WorldLevel.title: StringResource
    get() = when (this) {
        WorldLevel.EASY -> Res.string.learning_level_easy
        WorldLevel.MEDIUM -> Res.string.learning_level_medium
        WorldLevel.HARD -> Res.string.learning_level_hard
    }

private const val PICTURE_ASPECT = 16f / 10f
private val CORNER = 12.dp

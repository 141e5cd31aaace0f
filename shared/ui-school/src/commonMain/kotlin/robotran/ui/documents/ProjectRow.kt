package robotran.ui.documents

import androidx.compose.foundation.Image
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
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
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import robotran.language.Language
import robotran.programs.ProgramCompiler
import robotran.programs.support
import robotran.projects.PENBOT_TARGET
import robotran.projects.Project
import robotran.projects.RobotProgramSets
import robotran.projects.readRobotLoads
import robotran.simulation.RobotProgramSet
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetPictures
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.ProjectListEntry
import robotran.world.World
import robotran.world.file.BuiltInWorlds

/**
 * An entry of the project list: a thumbnail of what it draws, its name, world, programs, and the time it was stored. A
 * touch opens it; a menu has what else can be done with it.
 */
@Composable
internal fun ProjectRow(work: ProjectListEntry, onEvent: (DocumentEvent) -> Unit) {
    Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp), Alignment.CenterVertically) {
        Row(
            Modifier
                .weight(1f)
                .heightIn(min = Dimensions.TARGET)
                .clip(Shapes.MEDIUM)
                .focusRing()
                .clickable(role = Role.Button) { onEvent(DocumentEvent.SavedProjectChosen(work.entry.id)) }
                .testTag(DocumentTags.work(work.entry.id))
                .padding(8.dp),
            Arrangement.spacedBy(12.dp),
            Alignment.CenterVertically,
        ) {
            SheetPicture(work)
            Column(Modifier.weight(1f)) {
                val colours = LocalRobotranColours.current
                Text(nameOf(work), style = TextStyles.label.medium)
                val title = work.world?.let { titleOf(it) }
                val holds = listOfNotNull(title?.takeIf { it != work.entry.name }) + work.programs
                // Reserves its space, so that nothing moves when it appears.
                Text(
                    holds.joinToString(" · "),
                    style = TextStyles.smallLines,
                    color = colours.quiet,
                    maxLines = 1,
                    overflow = TextOverflow.Ellipsis,
                )
                Text(timeOf(work), style = TextStyles.smallLines, color = colours.quiet)
            }
        }
        ProjectActions(work, onEvent)
    }
}

/** The default world is stored with its English title, whatever the language. */
@Composable
private fun titleOf(world: World): String =
    if (world.title == BuiltInWorlds.plain.title) DocumentTexts.plainWorld(spoken) else world.title

@Composable
private fun timeOf(work: ProjectListEntry): String {
    val time = if (work.isOpen) DocumentTexts.workNow(spoken) else work.time
    return work.entry.fileName?.let { DocumentTexts.workFile(spoken, time, it) } ?: time
}

/** The world's title is next to it, so it needs no accessibility text. */
@Composable
private fun SheetPicture(work: ProjectListEntry) {
    val colours = LocalRobotranColours.current
    val sheetColours = remember(colours) { SheetColours.of(colours) }
    val key = "${work.entry.id} ${work.entry.keptAt}"
    val room =
        with(LocalDensity.current) { PictureBounds.of(PICTURE_WIDTH.roundToPx(), PICTURE_HEIGHT.roundToPx(), density) }
    val picture by produceState(pictures.ready(key, sheetColours, room), key, work.project, sheetColours, room) {
        work.project?.let { value = pictures.of(key, it.worldToRun, sheetColours, room) { loadsForPicture(it) } }
    }
    Box(
        Modifier.size(PICTURE_WIDTH, PICTURE_HEIGHT).background(colours.desk, Shapes.PIECE).padding(2.dp),
        Alignment.Center,
    ) {
        picture?.let { Image(it, contentDescription = null, Modifier.fillMaxSize(), contentScale = ContentScale.Fit) }
    }
}

/**
 * The programs of [project] for its picture; empty if they have errors, or if the compiler of one would have to be
 * fetched for a picture.
 */
private suspend fun loadsForPicture(project: Project): List<RobotProgramSet> {
    val isSlow = project.robots.any { robot -> robot.programs.any { it.language.support.hasSlowCompiler } }
    if (isSlow) return emptyList()
    return (readRobotLoads(project, compiler) as? RobotProgramSets.Success)?.loads.orEmpty()
}

private val pictures = SheetPictures()
private val compiler = ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH)
private val PICTURE_WIDTH = 96.dp
private val PICTURE_HEIGHT = 72.dp

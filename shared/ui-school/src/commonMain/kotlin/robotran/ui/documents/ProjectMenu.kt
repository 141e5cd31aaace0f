package robotran.ui.documents

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DocumentState

/**
 * The project's name, which opens the menu with actions on the project. A dot marks changes not saved to the file, a
 * warning sign a failed autosave.
 */
@Composable
fun ProjectMenu(state: DocumentState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    var open by remember { mutableStateOf(false) }
    var showsMore by remember { mutableStateOf(false) }
    val choose = { event: WorkshopEvent ->
        open = false
        onEvent(event)
    }
    Box(modifier) {
        ProjectName(state) {
            showsMore = false
            open = true
        }
        AppMenu(
            expanded = open,
            onDismissRequest = { open = false },
            modifier = Modifier.widthIn(min = 240.dp).testTag(DocumentTags.WORK_MENU_ITEMS),
            page = showsMore,
        ) {
            if (showsMore) {
                LessItem { showsMore = false }
                MenuDivider()
                MoreProjectItems(state, choose)
            } else {
                ProjectMenuItems(state, choose) { showsMore = true }
            }
        }
    }
}

/** The same as a menu entry; [onClick] should show the list of actions on the project. */
@Composable
fun ProjectMenuEntry(state: DocumentState, onClick: () -> Unit) {
    val words =
        DocumentTexts.menu(spoken, state.name.ifEmpty { DocumentTexts.untitled(spoken) })
    val condition = conditionOf(state)
    MenuItem(
        DocumentTags.WORK_MENU,
        onClick,
        Modifier.semantics {
            contentDescription = words
            if (condition != null) stateDescription = condition
        },
        trailing = { MoreSign() },
    ) {
        val named = listOfNotNull(signOf(state), words).joinToString(" ")
        Text(named, style = TextStyles.body, maxLines = 1, overflow = TextOverflow.Ellipsis)
    }
}

/** Behind a menu entry that opens a list in place of the menu. */
@Composable
fun MoreSign() = SmallIcon(MORE_ICON, LocalRobotranColours.current.quiet)

/** Leads back from the list of [MoreProjectItems]. */
@Composable
private fun LessItem(onClick: () -> Unit) = MenuItem(
    DocumentTexts.backToMenu(spoken),
    DocumentTags.menuItem(DocumentTags.LESS),
    leading = { SmallIcon(Icon.BACK, LocalRobotranColours.current.onPane) },
    onClick = onClick,
)

/** The sign for the save status before the project's name; null if all is saved. */
private fun signOf(state: DocumentState): String? = when {
    state.error != null -> "⚠"
    state.fileName != null && !state.saved -> "●"
    else -> null
}

/** The save status in words. */
@Composable
fun conditionOf(state: DocumentState): String? = when {
    state.error != null -> DocumentTexts.notKept(spoken)
    state.fileName != null && !state.saved -> DocumentTexts.unsaved(spoken)
    else -> null
}

@Composable
private fun ProjectName(state: DocumentState, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    val name = state.name.ifEmpty { DocumentTexts.untitled(spoken) }
    val words = DocumentTexts.menu(spoken, name)
    val condition = conditionOf(state)
    Row(
        Modifier
            .testTag(DocumentTags.WORK_MENU)
            .heightIn(min = Dimensions.TARGET)
            .clip(Shapes.MEDIUM)
            .focusRing()
            .clickable(role = Role.DropdownList, onClick = onClick)
            .semantics(mergeDescendants = true) {
                contentDescription = words
                if (condition != null) stateDescription = condition
            }
            .padding(horizontal = 12.dp),
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        signOf(state)?.let { Text(it, style = TextStyles.sign) }
        Text(
            name,
            Modifier.weight(1f, fill = false),
            TextStyles.body.medium,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
        Canvas(Modifier.size(10.dp, 6.dp)) {
            val width = 2.dp.toPx()
            val tip = Offset(size.width / 2, size.height)
            drawLine(colours.quiet, Offset.Zero, tip, width, StrokeCap.Round)
            drawLine(colours.quiet, Offset(size.width, 0f), tip, width, StrokeCap.Round)
        }
    }
}

private val MORE_ICON = Icon.strokes("M9 5L16 12L9 19")

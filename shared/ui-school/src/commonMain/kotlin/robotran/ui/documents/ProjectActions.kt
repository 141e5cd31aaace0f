package robotran.ui.documents

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.TextRange
import androidx.compose.ui.text.input.TextFieldValue
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.ProjectListEntry

/** The menu of an entry of the project list. The open project cannot be deleted. */
@Composable
internal fun ProjectActions(work: ProjectListEntry, onEvent: (DocumentEvent) -> Unit) {
    var isOpen by remember { mutableStateOf(false) }
    val id = work.entry.id
    val choose = { event: DocumentEvent ->
        isOpen = false
        onEvent(event)
    }
    Box {
        IconButton(Icon.MORE, DocumentTexts.workActions(spoken, nameOf(work)), DocumentTags.actions(id)) {
            isOpen = true
        }
        AppMenu(isOpen, { isOpen = false }) {
            MenuItem(DocumentTexts.rename(spoken), DocumentTags.rename(id)) {
                choose(DocumentEvent.ProjectRenamingRequested(id))
            }
            MenuItem(DocumentTexts.duplicate(spoken), DocumentTags.duplicate(id)) {
                choose(DocumentEvent.ProjectDuplicated(id))
            }
            if (!work.isOpen) {
                MenuItem(DocumentTexts.delete(spoken), DocumentTags.delete(id)) {
                    choose(DocumentEvent.ProjectDeleted(id))
                }
            }
        }
    }
}

/** The entry of a project that gets another name. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun RenamingRow(work: ProjectListEntry, onEvent: (DocumentEvent) -> Unit) {
    var name by remember { mutableStateOf(TextFieldValue(work.entry.name, TextRange(0, work.entry.name.length))) }
    val done = { onEvent(DocumentEvent.ProjectRenamed(name.text)) }
    val mayBeDone = name.text.isNotBlank()
    Column(Modifier.fillMaxWidth().padding(8.dp), Arrangement.spacedBy(4.dp)) {
        OneLine(name, { name = it }, DocumentTexts.nameLabel(spoken), isError = false) {
            if (mayBeDone) done()
        }
        FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp, Alignment.End)) {
            Button(DocumentTexts.cancel(spoken), DocumentTags.RENAME_CANCEL, ButtonKind.DIALOG_OTHER) {
                onEvent(DocumentEvent.ProjectRenamed(null))
            }
            Button(
                DocumentTexts.nameDone(spoken),
                DocumentTags.RENAME_DONE,
                ButtonKind.DIALOG_MAIN,
                enabled = mayBeDone,
                onClick = done,
            )
        }
    }
}

/** The place of a project that was deleted, where it can be brought back. */
@Composable
internal fun DeletedRow(work: ProjectListEntry, onEvent: (DocumentEvent) -> Unit) {
    Row(
        Modifier.fillMaxWidth().heightIn(min = DELETED_HEIGHT).padding(horizontal = 8.dp),
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        Explanation(
            DocumentTexts.deleted(spoken, nameOf(work)),
            Modifier.weight(1f).announced(),
        )
        Button(DocumentTexts.bringBack(spoken), DocumentTags.DELETE_UNDO, ButtonKind.DIALOG_OTHER) {
            onEvent(DocumentEvent.ProjectDeletionUndone)
        }
    }
}

/** As high as the entry was, so that nothing below moves. */
private val DELETED_HEIGHT = 88.dp

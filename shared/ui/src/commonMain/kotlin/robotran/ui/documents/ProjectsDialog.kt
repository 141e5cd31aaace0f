package robotran.ui.documents

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.HorizontalDivider
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.parts.EmptyPicture
import robotran.ui.parts.EmptyState
import robotran.ui.resources.Res
import robotran.ui.resources.documents_close
import robotran.ui.resources.documents_delete_no
import robotran.ui.resources.documents_delete_question
import robotran.ui.resources.documents_delete_yes
import robotran.ui.resources.documents_my_work
import robotran.ui.resources.documents_new
import robotran.ui.resources.documents_untitled
import robotran.ui.resources.documents_works_empty
import robotran.ui.resources.documents_works_loading
import robotran.ui.theme.LocalRobotranColours
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.ProjectListEntry

/** The list of projects: a touch opens one, the cross next to it deletes it after confirmation. */
@Composable
internal fun ProjectsDialog(dialog: DocumentDialog.ProjectList, onEvent: (DocumentEvent) -> Unit) {
    val close = { onEvent(DocumentEvent.DialogClosed) }
    DialogFrame(
        stringResource(Res.string.documents_my_work),
        close,
        buttons = {
            OtherButton(stringResource(Res.string.documents_close), "document-cancel", close)
            MainButton(stringResource(Res.string.documents_new), "works-new") { onEvent(DocumentEvent.NewRequested) }
        },
    ) {
        val projects = dialog.projects
        when {
            projects == null -> Explanation(stringResource(Res.string.documents_works_loading))

            projects.isEmpty() -> EmptyState(
                EmptyPicture.SHEETS,
                stringResource(Res.string.documents_works_empty),
                "works-empty",
                Modifier.fillMaxWidth(),
            )

            else -> projects.forEachIndexed { number, work ->
                if (number > 0) HorizontalDivider(color = LocalRobotranColours.current.line)
                if (work.entry.id == dialog.deleting?.entry?.id) Deleting(work, onEvent) else ProjectRow(work, onEvent)
            }
        }
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Deleting(work: ProjectListEntry, onEvent: (DocumentEvent) -> Unit) {
    Column(Modifier.fillMaxWidth().padding(horizontal = 12.dp), Arrangement.spacedBy(4.dp)) {
        Explanation(
            stringResource(Res.string.documents_delete_question, nameOf(work)),
            Modifier.semantics { liveRegion = LiveRegionMode.Polite },
        )
        FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp, Alignment.End)) {
            OtherButton(stringResource(Res.string.documents_delete_yes), "delete-yes") {
                onEvent(DocumentEvent.ProjectDeletionAnswered(true))
            }
            MainButton(stringResource(Res.string.documents_delete_no), "delete-no") {
                onEvent(DocumentEvent.ProjectDeletionAnswered(false))
            }
        }
    }
}

@Composable
internal fun nameOf(work: ProjectListEntry) = work.entry.name.ifEmpty { stringResource(Res.string.documents_untitled) }

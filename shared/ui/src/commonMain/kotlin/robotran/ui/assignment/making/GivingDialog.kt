package robotran.ui.assignment.making

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.ui.documents.DialogFrame
import robotran.ui.documents.Explanation
import robotran.ui.documents.MainButton
import robotran.ui.documents.OtherButton
import robotran.ui.resources.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent

/** Asks whether pupils shall begin with what solves the task. */
@Composable
internal fun GivingDialog(onEvent: (WorkshopEvent) -> Unit) {
    val cancel = { onEvent(AssignmentEvent.GivingCancelled) }
    DialogFrame(
        stringResource(Res.string.make_giving_title),
        cancel,
        buttons = {
            OtherButton(stringResource(Res.string.make_giving_share), "make-giving-share", {
                onEvent(AssignmentEvent.GivingConfirmed)
            })
            MainButton(stringResource(Res.string.documents_cancel), "make-giving-cancel") { cancel() }
        },
    ) { Explanation(stringResource(Res.string.make_giving_help)) }
}

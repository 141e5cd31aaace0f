package robotran.ui.send

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.tower.LegoLimits
import robotran.ui.resources.Res
import robotran.ui.resources.send_slot_last
import robotran.ui.resources.send_slot_number
import robotran.workshop.event.SendEvent
import robotran.workshop.state.SendStep

/** A button for each slot of LEGO's own firmware, which sends the program. */
@Composable
internal fun SlotChoice(step: SendStep.ChoosingSlot, onEvent: (SendEvent) -> Unit) {
    for (slot in 1..LegoLimits.SLOTS) {
        val words = if (slot == step.last) Res.string.send_slot_last else Res.string.send_slot_number
        ChoiceButton(stringResource(words, slot), "send-slot-$slot") { onEvent(SendEvent.SlotChosen(slot)) }
    }
}

package robotran.ui.workshop

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue

/** Keeps how the world is shown. */
class SheetHolder(private val bench: Bench) {
    var state: SheetViewState by mutableStateOf(SheetViewState())
        private set

    fun handle(event: SheetEvent) {
        when (event) {
            SheetEvent.WholeSheetWanted -> state = SheetViewState()
        }
    }
}

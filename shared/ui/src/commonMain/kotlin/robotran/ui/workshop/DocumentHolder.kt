package robotran.ui.workshop

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue

/** Keeps what the project is called and where it lies. */
class DocumentHolder(private val bench: Bench) {
    var state: DocumentState by mutableStateOf(DocumentState())
        private set

    fun handle(event: DocumentEvent) {
        when (event) {
            is DocumentEvent.Renamed -> state = state.copy(name = event.name)
        }
    }
}

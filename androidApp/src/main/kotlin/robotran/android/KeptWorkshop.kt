package robotran.android

import android.os.Bundle
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.core.os.bundleOf
import androidx.lifecycle.SavedStateHandle
import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import kotlinx.coroutines.launch
import robotran.ui.openWorkshop
import robotran.ui.workshop.Workshop
import robotran.ui.workshop.WorkshopEvent

/**
 * Keeps the workshop, and a run in it, when the activity is made anew because the tablet was turned. When Android ends the whole
 * process in the background, [savedState] brings the program text back.
 */
class KeptWorkshop(private val savedState: SavedStateHandle) : ViewModel() {
    /** Null until the physics is there. */
    var workshop: Workshop? by mutableStateOf(null)
        private set

    init {
        viewModelScope.launch { workshop = openWorkshop().also(::keepProgramText) }
    }

    private fun keepProgramText(workshop: Workshop) {
        val saved = savedState.get<Bundle>(PROGRAM)?.getString(TEXT)
        if (saved != null) workshop.handle(WorkshopEvent.ProgramEdited(saved))
        savedState.setSavedStateProvider(PROGRAM) {
            bundleOf(TEXT to workshop.state.programText.takeIf { it.length <= MOST_CHARACTERS })
        }
    }

    override fun onCleared() {
        workshop?.close()
    }

    private companion object {
        const val PROGRAM = "program"
        const val TEXT = "text"

        /** Android ends an app whose saved state is larger than about a megabyte; a character takes two bytes. */
        const val MOST_CHARACTERS = 100_000
    }
}

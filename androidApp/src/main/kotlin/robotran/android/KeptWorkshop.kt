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
import robotran.android.sound.audioTrackSpeaker
import robotran.ui.openWorkshop
import robotran.ui.workshop.Workshop
import robotran.ui.workshop.WorkshopEvent

/**
 * Keeps the workshop, and a run in it, when the activity is made anew because the tablet was turned. When Android ends the whole
 * process in the background, [savedState] brings back the program text, and whether there is to be sound.
 */
class KeptWorkshop(private val savedState: SavedStateHandle) : ViewModel() {
    /** Null until the physics is there. */
    var workshop: Workshop? by mutableStateOf(null)
        private set

    init {
        viewModelScope.launch { workshop = openWorkshop(speaker = audioTrackSpeaker()).also(::keepState) }
    }

    private fun keepState(workshop: Workshop) {
        val saved = savedState.get<Bundle>(WORKSHOP)
        saved?.getString(TEXT)?.let { workshop.handle(WorkshopEvent.ProgramEdited(it)) }
        saved?.getBoolean(SOUND)?.let { workshop.handle(WorkshopEvent.SoundSwitched(it)) }
        savedState.setSavedStateProvider(WORKSHOP) {
            bundleOf(TEXT to workshop.state.programText.takeIf { it.length <= MOST_CHARACTERS }, SOUND to workshop.state.soundOn)
        }
    }

    override fun onCleared() {
        workshop?.close()
    }

    private companion object {
        const val WORKSHOP = "workshop"
        const val TEXT = "text"
        const val SOUND = "sound"

        /** Android ends an app whose saved state is larger than about a megabyte; a character takes two bytes. */
        const val MOST_CHARACTERS = 100_000
    }
}

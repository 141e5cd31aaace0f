package robotran.android

import android.os.Bundle
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.core.os.BundleCompat
import androidx.core.os.bundleOf
import androidx.lifecycle.SavedStateHandle
import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import kotlinx.coroutines.launch
import robotran.android.sound.audioTrackSpeaker
import robotran.ui.openWorkshop
import robotran.ui.platform.MemoryPlatform
import robotran.ui.workshop.PupilProgram
import robotran.ui.workshop.SettingsEvent
import robotran.ui.workshop.Workshop

/**
 * Keeps the workshop, and a run in it, when the activity is made anew because the tablet was turned. When Android ends the whole
 * process in the background, [savedState] brings back the programs, and whether there is to be sound.
 */
class KeptWorkshop(private val savedState: SavedStateHandle) : ViewModel() {
    /** Null until the physics is there. */
    var workshop: Workshop? by mutableStateOf(null)
        private set

    init {
        viewModelScope.launch { workshop = openWorkshop(keptPrograms(), MemoryPlatform(audioTrackSpeaker())).also(::keepState) }
    }

    private fun keepState(workshop: Workshop) {
        val saved = savedState.get<Bundle>(WORKSHOP)
        saved?.getBoolean(SOUND)?.let { workshop.handle(SettingsEvent.SoundSwitched(it)) }
        savedState.setSavedStateProvider(WORKSHOP) {
            bundleOf(PROGRAMS to bundlesOf(workshop.state.programs.programs), SOUND to workshop.state.soundOn)
        }
    }

    private fun keptPrograms(): List<PupilProgram> =
        savedState.get<Bundle>(WORKSHOP)?.let {
            BundleCompat.getParcelableArrayList(it, PROGRAMS, Bundle::class.java)
        }.orEmpty().map(::programOf)

    override fun onCleared() {
        workshop?.close()
    }

    private companion object {
        const val WORKSHOP = "workshop"
        const val PROGRAMS = "programs"
        const val SOUND = "sound"
    }
}
